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
 * Options as ViSP's programs take them.
 */

#ifndef VP_TUTORIAL_PARSE_H
#define VP_TUTORIAL_PARSE_H

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "arguments.h"

namespace tutorial {
/*! A number in a range; CLI11's own check lets what is no number (nan) pass. */
inline CLI::Validator numberIn(double least, double most)
{
  const std::string range = CLI::detail::to_string(least) + " to " + CLI::detail::to_string(most);
  return CLI::Validator(
      [least, most, range](std::string &text) {
        double value = 0.;
        const bool isGood = CLI::detail::lexical_cast(text, value) && value >= least && value <= most;
        return isGood ? std::string() : "\"" + text + "\" is not a number from " + range;
      },
      range);
}

/*! A number above 0 that is none too large to be meant. */
inline CLI::Validator positiveNumber()
{
  return numberIn(1e-9, 1e9);
}

/*! A whole number that is not negative: of -1 CLI11 would make one with twenty digits. */
inline CLI::Validator wholeNumber()
{
  return CLI::Validator(
      [](std::string &text) {
        constexpr std::size_t mostDigits = 18; // a number of 64 bits holds any of them
        const bool isGood =
            !text.empty() && text.size() <= mostDigits && text.find_first_not_of("0123456789") == std::string::npos;
        return isGood ? std::string() : "\"" + text + "\" is not a whole number from 0 of up to 18 digits";
      },
      "whole number");
}

/*!
  Arguments in the order CLI11 wants them, last first; options may be written with underscores, as ViSP's tools do.
*/
inline std::vector<std::string> reversedArguments(int argc, const char *const argv[])
{
  std::vector<std::string> arguments;
  for (int i = argc - 1; i > 0; --i) {
    std::string argument = argv[i];
    if (argument.compare(0, 2, "--") == 0) {
      const std::size_t length = std::min(argument.find('='), argument.size());
      std::replace(argument.begin(), argument.begin() + static_cast<std::ptrdiff_t>(length), '_', '-');
    }
    arguments.push_back(argument);
  }
  return arguments;
}

/*!
  Parses arguments.

  \return True: go on; false: help is asked for, app.help().
  \exception UsageError : If the arguments are wrong.
*/
inline bool parse(CLI::App &app, int argc, const char *const argv[])
{
  try {
    std::vector<std::string> reversed = reversedArguments(argc, argv);
    app.parse(reversed);
    return true;
  }
  catch (const CLI::CallForHelp &) {
    return false;
  }
  catch (const CLI::ParseError &e) {
    throw UsageError(std::string(e.what()) + "; see --help");
  }
}
} // namespace tutorial

#endif
