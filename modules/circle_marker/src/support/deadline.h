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
 * The time until which the rooms may work.
 */

#ifndef VP_CIRCLE_MARKER_DEADLINE_H
#define VP_CIRCLE_MARKER_DEADLINE_H

#include <chrono>

#include <visp3/circle_marker/vpConfigCircleMarker.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  The time until which the rooms may work; by default for ever. Every loop whose length depends on the image asks, at
  least each millisecond, whether it has passed, and then leaves with what it has. Asking takes some 30 ns.
*/
class Deadline
{
public:
  using Clock = std::chrono::steady_clock; // a change of the system's time must not stop a detection

  Deadline() = default;

  /*! So many milliseconds from now; none for 0 or less, as in vpDetectorBase::setTimeout(). */
  explicit Deadline(double milliseconds)
  {
    constexpr double longest = 1e12; // some 30 years: beyond them is for ever, and the clock's range
    if (milliseconds > 0. && milliseconds < longest) {
      m_end = Clock::now() +
              std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double, std::milli>(milliseconds));
    }
  }

  /*! Whether there is any end. */
  bool isSet() const { return m_end != Clock::time_point::max(); }

  bool hasPassed() const { return isSet() && Clock::now() > m_end; }

private:
  Clock::time_point m_end = Clock::time_point::max(); //!< When the work has to end.
};
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
