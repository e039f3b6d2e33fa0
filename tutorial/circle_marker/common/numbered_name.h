/*
 * Circular fiducial markers for ViSP, the Visual Servoing Platform.
 *
 * This software is free software; you can redistribute it and/or modify
 * it under the terms of the GNU General Public License as published by
 * the Free Software Foundation; either version 2 of the License, or
 * (at your option) any later version.
 * See the file LICENSE at the root directory of this source
 * distribution for additional information about the GNU GPL.
 *
 * This file is provided AS IS with NO WARRANTY OF ANY KIND, INCLUDING THE
 * WARRANTY OF DESIGN, MERCHANTABILITY AND FITNESS FOR A PARTICULAR PURPOSE.
 *
 * Description:
 * File names with a number, img%04d.png.
 */

#ifndef VP_TUTORIAL_NUMBERED_NAME_H
#define VP_TUTORIAL_NUMBERED_NAME_H

#include <optional>
#include <string>

namespace tutorial {
/*!
  The pattern of a file name with one number, as printf writes it: %d, %4d or %04d.
*/
class NumberedName
{
public:
  /*!
    A % that begins no such number stands for itself, as does %%.
    \return The pattern, or nothing if the text does not contain exactly one of %d, %4d, %04d.
  */
  static std::optional<NumberedName> parse(const std::string &text)
  {
    NumberedName name;
    bool hasNumber = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
      std::size_t end = i + 1;
      while (text[i] == '%' && end < text.size() && text[end] >= '0' && text[end] <= '9') {
        ++end;
      }
      const bool isNumber = text[i] == '%' && end < text.size() && text[end] == 'd';
      // No file name has a number of 100 digits or more.
      if (isNumber && (hasNumber || end - i > 4)) {
        return std::nullopt;
      }
      if (isNumber) {
        hasNumber = true;
        name.m_filler = text[i + 1] == '0' ? '0' : ' ';
        name.m_width = end > i + 1 ? std::stoul(text.substr(i + 1, end - i - 1)) : 0;
        i = end;
        continue;
      }
      (hasNumber ? name.m_suffix : name.m_prefix) += text[i];
      i += text[i] == '%' && end < text.size() && text[end] == '%' ? 1 : 0;
    }
    return hasNumber ? std::optional<NumberedName>(name) : std::nullopt;
  }

  /*!
    \return The name with a number, from 0.
  */
  std::string operator()(long number) const
  {
    const std::string digits = std::to_string(number);
    const std::string filler(digits.size() < m_width ? m_width - digits.size() : 0, m_filler);
    return m_prefix + filler + digits + m_suffix;
  }

  /*!
    \return The number of a name of this pattern, nothing for another name.
  */
  std::optional<long> numberOf(const std::string &name) const
  {
    if (name.size() <= m_prefix.size() + m_suffix.size()) {
      return std::nullopt;
    }
    const std::string digits = name.substr(m_prefix.size(), name.size() - m_prefix.size() - m_suffix.size());
    constexpr std::size_t mostDigits = 18; // that a long surely holds
    const std::size_t first = digits.find_first_not_of(m_filler == ' ' ? " " : "");
    if (digits.size() > mostDigits || first == std::string::npos ||
        digits.find_first_not_of("0123456789", first) != std::string::npos) {
      return std::nullopt;
    }
    const long number = std::stol(digits.substr(first));
    return (*this)(number) == name ? std::optional<long>(number) : std::nullopt;
  }

private:
  std::string m_prefix;    //!< What is before the number.
  std::string m_suffix;    //!< What is after it.
  char m_filler = ' ';     //!< What fills a number up to the width.
  std::size_t m_width = 0; //!< Least number of characters of the number.
};
} // namespace tutorial

#endif
