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
 * The servo: look, compute, move, until the desired pose is reached.
 */

#ifndef VP_TUTORIAL_SERVO_LOOP_H
#define VP_TUTORIAL_SERVO_LOOP_H

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <visp3/core/vpColVector.h>
#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/core/vpImage.h>

#include "../common/visp_names.h"
#include "pose_source.h"
#include "servo_scene.h"
#include "servo_task.h"

namespace tutorial {
/*! One image of the servo and what was done with it. */
struct ServoStep
{
  unsigned int iteration = 0;            //!< From 0.
  double time = 0.;                      //!< Seconds since the start, as the camera counts them.
  Covers covers;                         //!< What was covered.
  ObjectSighting sighting;               //!< What was seen.
  vpHomogeneousMatrix cMo;               //!< The true pose of the object.
  ServoError trueError;                  //!< Error of the true pose.
  std::optional<ServoError> measured;    //!< Error of the measured pose.
  vpColVector velocity = vpColVector(6); //!< Velocity that was sent, camera frame, m/s and rad/s.
};

/*! An image that is worth being kept. */
struct Snapshot
{
  std::string name;             //!< What it shows, in one word.
  ServoStep step;               //!< What was done with it.
  vpImage<unsigned char> image; //!< The image.
};

/*! How a servo went. */
struct ServoRecord
{
  std::vector<ServoStep> steps;
  std::vector<Snapshot> snapshots;
  bool converged = false; //!< Whether the true pose is the desired one.
  std::string reason;     //!< Why not.
};

/*! Is shown each image before the camera moves, and says whether to go on; may be empty. */
using Observer = std::function<bool(const vpImage<unsigned char> &I, const ServoStep &step)>;

/*! A servo to be run. */
struct ServoProblem
{
  ServoCamera camera;        //!< The camera.
  ServoObject object;        //!< What it looks at.
  vpHomogeneousMatrix start; //!< Pose of the object at the start.
  std::uint64_t seed = 0;    //!< Of the noise.
};

/*! \return The desired pose of the object: 0.5 m in front of the camera, frontal and upright. */
vpHomogeneousMatrix desiredPose();

/*! Bounds that the true pose is judged with at the end. */
constexpr double acceptedDistance = 1e-3;           // m
constexpr double acceptedAngle = 0.1 * M_PI / 180.; // rad

/*!
  Runs a servo until the measured error is small for some images in a row, or it cannot go on.
*/
ServoRecord runServo(const ServoProblem &problem, const Observer &observer);
} // namespace tutorial

#endif
