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
 * A robot on wheels, as it is and as it believes to be.
 */

#ifndef VP_NAVIGATION_ROBOT_H
#define VP_NAVIGATION_ROBOT_H

#include <array>
#include <random>

#include <Eigen/Core>

#include "localise.h"

namespace navigation {
/*! Place and direction on the floor; see common::lookingAlong(). */
struct FloorPose
{
  double x = 0.;         //!< Metres.
  double z = 0.;         //!< Metres.
  double direction = 0.; //!< Radians.
};

/*! An angle in ]-pi, pi]. */
double wrapped(double angle);

/*! What the robot is told. */
struct Command
{
  double speed = 0.; //!< m/s
  double turn = 0.;  //!< rad/s
};

/*! \return The pose after a command has been obeyed for a time, seconds: an arc. */
FloorPose advanced(const FloorPose &pose, const Command &command, double time);

/*!
  The robot itself. Its wheels are not what it believes: speed and turn are off by a constant share, and by noise.
*/
class TrueRobot
{
public:
  TrueRobot(const FloorPose &start, double speedError, double turnError, std::uint64_t seed)
      : m_pose(start), m_speedError(speedError), m_turnError(turnError), m_random(seed)
  {
  }

  void obey(const Command &command, double time);
  const FloorPose &pose() const { return m_pose; }

private:
  double normal();

  FloorPose m_pose;         //!< Where it is.
  double m_speedError;      //!< Share.
  double m_turnError;       //!< Share.
  std::mt19937_64 m_random; //!< Of the noise.
};

/*!
  What the robot believes: an extended Kalman filter of place and direction. Wheels predict, markers correct.
*/
class Belief
{
public:
  explicit Belief(const FloorPose &start);

  /*! The wheels have obeyed. */
  void predict(const Command &command, double time);
  /*! The camera was seen to be somewhere; its height and tilt are the robot's own. */
  void correct(const Location &location);

  const FloorPose &pose() const { return m_pose; }
  /*! Of x, z, direction. */
  const Eigen::Matrix3d &covariance() const { return m_covariance; }
  /*! Error in standard deviations: root of the mean square of three numbers. */
  double sigmasFrom(const FloorPose &truth) const;

private:
  FloorPose m_pose;             //!< Most likely.
  Eigen::Matrix3d m_covariance; //!< Of it.
};
} // namespace navigation

#endif
