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

#ifndef VP_TUTORIAL_SERVO_TASK_H
#define VP_TUTORIAL_SERVO_TASK_H

#include <visp3/core/vpColVector.h>
#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/visual_features/vpFeatureThetaU.h>
#include <visp3/visual_features/vpFeatureTranslation.h>
#include <visp3/vs/vpServo.h>

#include "../visp_names.h"

namespace tutorial {
/*! The greatest velocities. */
struct ServoLimits
{
  double speed = 2.;        //!< m/s; what the simulated camera can do.
  double turn = 0.5 * M_PI; //!< rad/s
};

/*!
  How far the camera is from where it should be.
*/
struct ServoError
{
  vpColVector translation; //!< Translation of cdMc, metres: where the camera is in the desired camera's frame.
  vpColVector rotation;    //!< theta u of cdMc, radians.
  double object = 0.;      //!< Distance between the object's place in the camera's frame and the desired one, metres.

  ServoError(const vpHomogeneousMatrix &cdMo, const vpHomogeneousMatrix &cMo);

  /*! Distance of the camera from its desired place, metres. */
  double distance() const { return translation.frobeniusNorm(); }
  /*! Angle of its rotation from the desired one, radians. */
  double angle() const { return rotation.frobeniusNorm(); }
  /*!
    Whether all errors are within the bounds. Both the camera's place and the object's place in its frame count: they
    differ by the angle times the distance.
  */
  bool isWithin(double metres, double radians) const
  {
    return distance() <= metres && object <= metres && angle() <= radians;
  }
};

/*!
  Eye-in-hand position-based servo. Features are the object's translation in the camera's frame and theta u of cdRc:
  the object's origin then moves on a straight line in the camera's frame, so its image goes straight to the image's
  centre, and the marker is not lost. With the translation of cdMc the camera would go straight instead; from 4 m and
  60 degrees the marker leaves the image on half the way.
*/
class ServoTask
{
public:
  explicit ServoTask(const vpHomogeneousMatrix &cdMo, const ServoLimits &limits = ServoLimits());
  ServoTask(const ServoTask &) = delete;
  ServoTask &operator=(const ServoTask &) = delete;
  ~ServoTask();

  /*!
    \return Velocity of the camera in its own frame, m/s and rad/s, shortened to what the camera can do.
  */
  vpColVector velocity(const vpHomogeneousMatrix &cMo);

private:
  vpHomogeneousMatrix m_cdMo;                //!< Desired pose of the object.
  ServoLimits m_limits;                      //!< The greatest velocities.
  vpFeatureTranslation m_translation;        //!< Where the object is.
  vpFeatureTranslation m_desiredTranslation; //!< Where it should be.
  vpFeatureThetaU m_rotation;                //!< theta u of cdRc; zero is desired.
  vpServo m_servo;                           //!< The control law.
};

constexpr double samplingTime = 0.04; // s: 25 images a second
} // namespace tutorial

#endif
