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
 * A line on the terminal that tells how far the work is.
 */

#include <iostream>

#include <visp3/core/vpConfig.h>

#if !defined(_WIN32)
#include <unistd.h>
#endif

#include "progress.h"

namespace common {
namespace {
constexpr std::chrono::milliseconds pause(250);      // Between two writings on a terminal.
constexpr std::chrono::milliseconds logPause(30000); // Between two lines in a log: short work leaves none.
constexpr const char *emptyLine = "\r                                                            \r";

bool errorIsTerminal()
{
#if !defined(_WIN32)
  return isatty(STDERR_FILENO) == 1;
#else
  return false;
#endif
}
} // namespace

ProgressLine::ProgressLine(const std::string &items)
    : m_items(items), m_isTerminal(errorIsTerminal()), m_start(Clock::now()), m_last(m_start)
{
}

ProgressLine::~ProgressLine()
{
  if (m_isTerminal) {
    std::cerr << emptyLine << std::flush;
  }
}

void ProgressLine::show(std::size_t done, std::size_t all)
{
  const Clock::time_point now = Clock::now();
  if (now - m_last < (m_isTerminal ? pause : logPause)) {
    return;
  }
  m_last = now;
  const double passed = std::chrono::duration<double>(now - m_start).count();
  const double left = passed * static_cast<double>(all - done) / static_cast<double>(done);
  std::cerr << (m_isTerminal ? emptyLine : "") << done << " of " << all << " " << m_items << ", "
            << static_cast<long>(left + 0.5) << " s left" << (m_isTerminal ? "" : "\n") << std::flush;
}
} // namespace common
