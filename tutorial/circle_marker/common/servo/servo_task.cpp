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
 * The control law: from the pose to the camera's velocity.
 */

#include "servo_task.h"

#include <visp3/core/vpThetaUVector.h>
#include <visp3/robot/vpRobot.h>
#include <visp3/vs/vpAdaptiveGain.h>

namespace tutorial {
namespace {
// Gains, 1/s: of the last millimetres, of great errors, and the slope at zero, 1/s for each unit of the error. An image
// moves the camera by gain * samplingTime of the measured error. Near the goal this is 0.1: there the servo is its own
// low-pass filter, which leaves sqrt(0.1 / 1.9) = 0.23 of the noise of a single pose in the camera's.
constexpr double gainAtZero = 2.5;
constexpr double gainFarAway = 2.;
constexpr double slopeAtZero = 30.;

vpColVector columnOf(const vpTranslationVector &t)
{
  return vpColVector(std::vector<double>{t[0], t[1], t[2]});
}
} // namespace

ServoError::ServoError(const vpHomogeneousMatrix &cdMo, const vpHomogeneousMatrix &cMo)
{
  const vpHomogeneousMatrix cdMc = cdMo * cMo.inverse();
  const vpThetaUVector thetaU(cdMc.getRotationMatrix());
  translation = columnOf(cdMc.getTranslationVector());
  rotation = vpColVector(std::vector<double>{thetaU[0], thetaU[1], thetaU[2]});
  object = (columnOf(cMo.getTranslationVector()) - columnOf(cdMo.getTranslationVector())).frobeniusNorm();
}

//! [Servo task]
ServoTask::ServoTask(const vpHomogeneousMatrix &cdMo, const ServoLimits &limits)
    : m_cdMo(cdMo), m_limits(limits), m_translation(vpFeatureTranslation::cMo),
      m_desiredTranslation(vpFeatureTranslation::cMo), m_rotation(vpFeatureThetaU::cdRc)
{
  m_desiredTranslation.buildFrom(cdMo);
  m_servo.addFeature(m_translation, m_desiredTranslation);
  m_servo.addFeature(m_rotation);
  m_servo.setServo(vpServo::EYEINHAND_CAMERA);
  m_servo.setInteractionMatrixType(vpServo::CURRENT);
  m_servo.setLambda(vpAdaptiveGain(gainAtZero, gainFarAway, slopeAtZero));
}

vpColVector ServoTask::velocity(const vpHomogeneousMatrix &cMo)
{
  const vpHomogeneousMatrix cdMc = m_cdMo * cMo.inverse();
  m_translation.buildFrom(cMo);
  m_rotation.buildFrom(cdMc);
  const double speed = m_limits.speed, turn = m_limits.turn;
  const vpColVector limits(std::vector<double>{speed, speed, speed, turn, turn, turn});
  return vpRobot::saturateVelocities(m_servo.computeControlLaw(), limits);
}
//! [Servo task]

ServoTask::~ServoTask()
{
  m_servo.kill();
}
} // namespace tutorial
