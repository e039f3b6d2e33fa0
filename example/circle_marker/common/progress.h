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

#ifndef VP_COMMON_PROGRESS_H
#define VP_COMMON_PROGRESS_H

#include <chrono>
#include <cstddef>
#include <string>

#include "circle_marker/common/status_line.h"

namespace common {
/*! A line of the standard error that says how much is done and how long the rest takes. */
class ProgressLine
{
public:
  /*! \param items : What is counted, such as "frames". */
  explicit ProgressLine(const std::string &items = "frames");

  /*! Shows how much is done, and the time left if the rest takes as long in proportion. */
  void show(std::size_t done, std::size_t all);

private:
  using Clock = std::chrono::steady_clock;

  std::string m_items;         //!< What is counted.
  Clock::time_point m_start;   //!< When the work began.
  tutorial::StatusLine m_line; //!< Where it is written.
};
} // namespace common

#endif
