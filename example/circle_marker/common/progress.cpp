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

#include "progress.h"

namespace common {
ProgressLine::ProgressLine(const std::string &items) : m_items(items), m_start(Clock::now()) {}

void ProgressLine::show(std::size_t done, std::size_t all)
{
  if (!m_line.isDue()) {
    return;
  }
  const double passed = std::chrono::duration<double>(Clock::now() - m_start).count();
  const double left = passed * static_cast<double>(all - done) / static_cast<double>(done);
  m_line.write(std::to_string(done) + " of " + std::to_string(all) + " " + m_items + ", " +
               std::to_string(static_cast<long>(left + 0.5)) + " s left");
}
} // namespace common
