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
 * A line on the terminal that is written over again.
 */

#ifndef VP_TUTORIAL_STATUS_LINE_H
#define VP_TUTORIAL_STATUS_LINE_H

#include <chrono>
#include <iostream>
#include <string>

#include <visp3/core/vpConfig.h>

#if !defined(_WIN32)
#include <unistd.h>
#endif

namespace tutorial {
/*!
  A line of the standard error that is rewritten on a terminal; elsewhere a new line every half minute, so that short
  work leaves none.
*/
class StatusLine
{
public:
  StatusLine() : m_isTerminal(errorIsTerminal()), m_last(Clock::now()) {}
  StatusLine(const StatusLine &) = delete;
  StatusLine &operator=(const StatusLine &) = delete;
  ~StatusLine() { clear(); }

  /*! \return Whether it is time for write(). */
  bool isDue() const
  {
    constexpr std::chrono::milliseconds pause(250), logPause(30000);
    return Clock::now() - m_last >= (m_isTerminal ? pause : logPause);
  }

  void write(const std::string &text)
  {
    m_last = Clock::now();
    if (!m_isTerminal) {
      std::cerr << text << std::endl;
      return;
    }
    clear();
    std::cerr << text << std::flush;
    m_length = text.size();
  }

  /*! Takes the line away, for something else to be said. */
  void clear()
  {
    if (m_length > 0) {
      std::cerr << '\r' << std::string(m_length, ' ') << '\r' << std::flush;
      m_length = 0;
    }
  }

private:
  using Clock = std::chrono::steady_clock;

  static bool errorIsTerminal()
  {
#if !defined(_WIN32)
    return isatty(STDERR_FILENO) == 1;
#else
    return false;
#endif
  }

  bool m_isTerminal;        //!< Whether anybody reads it.
  Clock::time_point m_last; //!< When it was last written.
  std::size_t m_length = 0; //!< Of what stands on the terminal.
};
} // namespace tutorial

#endif
