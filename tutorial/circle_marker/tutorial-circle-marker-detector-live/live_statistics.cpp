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

#include "live_statistics.h"

#include <iomanip>
#include <sstream>

namespace tutorial {
namespace {
constexpr std::size_t window = 30; // images; two seconds of a camera at 15 images a second
}

void LiveStatistics::add(double cpuMilliseconds, std::optional<double> latencyMilliseconds)
{
  m_last.push_back(Sample{Clock::now(), cpuMilliseconds, latencyMilliseconds});
  if (m_last.size() > window) {
    m_last.pop_front();
  }
}

std::vector<std::string> LiveStatistics::lines(const FrameCounts &counts) const
{
  std::ostringstream first;
  first << std::fixed << std::setprecision(1);
  if (m_last.size() > 1) {
    const double seconds = std::chrono::duration<double>(m_last.back().when - m_last.front().when).count();
    first << static_cast<double>(m_last.size() - 1) / seconds << " images/s  ";
  }
  double cpu = 0., latency = 0.;
  std::size_t known = 0;
  for (const Sample &sample : m_last) {
    cpu += sample.cpu / static_cast<double>(m_last.size());
    latency += sample.latency.value_or(0.);
    known += sample.latency ? 1 : 0;
  }
  first << "detection " << cpu << " ms  latency ";
  if (known > 0) {
    first << latency / static_cast<double>(known) << " ms";
  }
  else {
    first << "not known";
  }
  return {first.str(), summary(counts)};
}

std::string LiveStatistics::summary(const FrameCounts &counts)
{
  std::ostringstream text;
  text << counts.delivered << " images; dropped: " << counts.missed << " by the camera or bus, " << counts.passedOver
       << " passed over here; damaged: " << counts.damaged;
  return text.str();
}
} // namespace tutorial
