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
 * How a live detection keeps up with its camera.
 */

#ifndef VP_TUTORIAL_LIVE_STATISTICS_H
#define VP_TUTORIAL_LIVE_STATISTICS_H

#include <chrono>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "../common/cameras/frame_feed.h"

namespace tutorial {
/*!
  Rate, processor time and latency of the last images, and what became of the others.
*/
class LiveStatistics
{
public:
  /*!
    Takes note of an image.
    \param cpuMilliseconds : Processor time of its detection.
    \param latencyMilliseconds : From the image being taken to its poses; nothing if it is not known.
  */
  void add(double cpuMilliseconds, std::optional<double> latencyMilliseconds);

  /*! \return The state in two lines. */
  std::vector<std::string> lines(const FrameCounts &counts) const;

  /*! \return What became of the images, in one line. */
  static std::string summary(const FrameCounts &counts);

private:
  using Clock = std::chrono::steady_clock;
  struct Sample
  {
    Clock::time_point when;
    double cpu;
    std::optional<double> latency;
  };

  std::deque<Sample> m_last; //!< The last images.
};
} // namespace tutorial

#endif
