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
 * A line that says how far a servo has come.
 */

#include "servo_progress.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace tutorial {
namespace {
constexpr std::size_t window = 25; // images: a second of the simulated camera
} // namespace

ServoProgress::ServoProgress(const ServoGoal &goal)
    : m_acceptedDistance(goal.acceptedDistance), m_acceptedAngle(goal.acceptedAngle)
{
}

std::optional<double> ServoProgress::secondsLeft() const
{
  if (m_recent.size() < 2 || !(m_recent.back().off < m_recent.front().off)) {
    return std::nullopt;
  }
  // The servo makes the error decrease by the same share in the same time.
  const double passed = m_recent.back().time - m_recent.front().time;
  const double rate = std::log(m_recent.front().off / std::max(m_recent.back().off, 1e-9)) / passed;
  return std::max(0., std::log(std::max(m_recent.back().off, 1.)) / rate);
}

std::string ServoProgress::line(const ServoStep &step) const
{
  std::ostringstream text;
  text << "image " << step.iteration;
  if (const auto &error = step.error()) {
    text << std::fixed << std::setprecision(1) << ", " << 1e3 * error->distance() << " mm and "
         << error->angle() * 180. / M_PI << " degrees to go";
  }
  if (!step.measured) {
    text << ", no marker is seen";
  }
  if (const auto left = secondsLeft()) {
    text << ", about " << static_cast<long>(std::ceil(*left)) << " s left";
  }
  return text.str();
}

void ServoProgress::show(const ServoStep &step)
{
  if (const auto &error = step.error()) {
    m_recent.push_back(
        Sample{step.time, std::max(error->distance() / m_acceptedDistance, error->angle() / m_acceptedAngle)});
    if (m_recent.size() > window) {
      m_recent.pop_front();
    }
  }
  if (m_line.isDue()) {
    m_line.write(line(step));
  }
}
} // namespace tutorial
