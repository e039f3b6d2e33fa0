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
 * The simulated camera of a servo.
 */

#include "servo_eyes.h"

#include <visp3/core/vpTime.h>

#include "servo_task.h"

namespace tutorial {
namespace {
/*! Markers are covered on these parts of the way, counted from 0 at the start to 1 at the goal. */
constexpr double circleCoveredFrom = 0.40, circleCoveredTo = 0.60;
constexpr double tagCoveredFrom = 0.70, tagCoveredTo = 0.90;

/*! Only with two markers can one be covered. */
Covers coversAt(const ServoObject &object, double progress)
{
  if (!object.circle || !object.aprilTag) {
    return Covers{};
  }
  return Covers{progress >= circleCoveredFrom && progress < circleCoveredTo,
                progress >= tagCoveredFrom && progress < tagCoveredTo};
}

/*! Noise of its own for each image: 0x9e3779b97f4a7c15 spreads the seeds (Knuth's multiplicative hashing). */
std::uint64_t noiseSeed(std::uint64_t seed, unsigned int iteration)
{
  return (seed + 1) * 0x9e3779b97f4a7c15ULL + iteration;
}
} // namespace

double remainingWay(const vpHomogeneousMatrix &cdMo, const vpHomogeneousMatrix &cMo)
{
  const ServoError error(cdMo, cMo);
  return error.distance() + error.angle();
}

void prepareRobot(vpSimulatorCamera &robot, const vpHomogeneousMatrix &cMo)
{
  robot.setSamplingTime(samplingTime);
  // ServoTask keeps these limits; the robot, which reports what it cuts, must not cut for a rounding.
  const ServoLimits limits;
  robot.setMaxTranslationVelocity(1.001 * limits.speed);
  robot.setMaxRotationVelocity(1.001 * limits.turn);
  robot.setPosition(cMo.inverse());
}

SimulatedEyes::SimulatedEyes(const ServoCamera &camera, const ServoObject &object, const vpSimulatorCamera &robot,
                             const vpHomogeneousMatrix &cdMo, std::uint64_t seed, bool isRealTime)
    : m_camera(camera), m_object(object), m_robot(robot), m_cdMo(cdMo), m_seed(seed), m_isRealTime(isRealTime),
      m_wholeWay(remainingWay(cdMo, robot.getPosition().inverse()))
{
}

std::optional<ServoView> SimulatedEyes::look(const std::function<void()> &)
{
  if (m_isRealTime && m_images > 0) {
    vpTime::wait(m_last, 1e3 * samplingTime);
  }
  m_last = vpTime::measureTimeMs();
  const vpHomogeneousMatrix truth = m_robot.getPosition().inverse();
  ServoView view;
  view.time = m_images * samplingTime;
  view.truth = truth;
  view.covers = coversAt(m_object, 1. - remainingWay(m_cdMo, truth) / m_wholeWay);
  view.image = renderScene(m_camera, m_object, truth, view.covers, noiseSeed(m_seed, m_images));
  ++m_images;
  return view;
}
} // namespace tutorial
