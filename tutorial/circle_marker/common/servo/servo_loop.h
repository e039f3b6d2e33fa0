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

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <visp3/core/vpColVector.h>
#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/core/vpImage.h>
#include <visp3/robot/vpRobot.h>

#include "../visp_names.h"
#include "pose_source.h"
#include "servo_eyes.h"
#include "servo_scene.h"
#include "servo_task.h"

namespace tutorial {
/*! One image of the servo and what was done with it. */
struct ServoStep
{
  unsigned int iteration = 0;             //!< From 0.
  double time = 0.;                       //!< Seconds since the start, as the camera counts them.
  Covers covers;                          //!< What was covered.
  ObjectSighting sighting;                //!< What was seen.
  std::optional<vpHomogeneousMatrix> cMo; //!< The true pose of the object, if it is known.
  std::optional<ServoError> trueError;    //!< Error of the true pose.
  std::optional<ServoError> measured;     //!< Error of the measured pose.
  vpColVector velocity = vpColVector(6);  //!< Velocity that was sent, camera frame, m/s and rad/s.

  /*! The error the step is judged by: the true one where it is known, or the measured one if there is one. */
  const std::optional<ServoError> &error() const { return trueError ? trueError : measured; }
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
  bool converged = false; //!< Whether the pose, the true one where it is known, is the desired one.
  std::string reason;     //!< Why not.
};

/*! What the user wants after an image. */
enum class ServoWish
{
  Go,   //!< The robot moves.
  Hold, //!< The robot stands still; the image does not count.
  Quit  //!< The servo ends.
};

/*! Is shown each image before the robot moves, and says what to do; may be empty. It must not wait. */
using Observer = std::function<ServoWish(const vpImage<unsigned char> &I, const ServoStep &step)>;

/*! Where a servo goes, and when it is there. */
struct ServoGoal
{
  ServoCamera camera;        //!< The camera.
  ServoObject object;        //!< What it looks at.
  vpHomogeneousMatrix cdMo;  //!< The desired pose of the object.
  DetectorSettings detector; //!< How the circular marker is looked for.
  ServoLimits limits;        //!< The greatest velocities.
  // Bounds that the pose is judged with at the end; measured, half of them is asked for.
  double acceptedDistance = 1e-3;           //!< Metres.
  double acceptedAngle = 0.1 * M_PI / 180.; //!< Radians.
  // From 4 m the simulated camera takes some 130 images; more than this (40 s) means that the servo does not end.
  unsigned int mostImages = 1000;
};

/*! \return The desired pose of the object: in front of the camera, frontal and upright; the distance is in metres. */
vpHomogeneousMatrix desiredPose(double distance = 0.5);

/*!
  Runs a servo until the measured error is small for some images in a row, or it cannot go on. The robot stands still
  while no marker is seen or no image comes, and at the end.

  \param eyes : Gives the images.
  \param robot : Any robot of ViSP that takes velocities in the camera's frame.
  \param goal : Where to go.
  \param observer : Sees each image; may be empty.
*/
ServoRecord runServo(ServoEyes &eyes, vpRobot &robot, const ServoGoal &goal, const Observer &observer);
} // namespace tutorial

#endif
