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
 * A robot's way through the room, step by step.
 */

#ifndef VP_NAVIGATION_DRIVE_H
#define VP_NAVIGATION_DRIVE_H

#include <functional>
#include <string>
#include <vector>

#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpImage.h>
#include <visp3/core/vpRGBa.h>

#include "common/parallel.h"
#include "common/room.h"
#include "robot.h"

namespace navigation {
struct Settings
{
  std::string database;         //!< Of the room; empty: the room of ten markers.
  std::string output;           //!< Folder.
  unsigned int mostTasks = 100; //!< After which it ends.
  double speedError = 0.04;     //!< Of the wheels, share.
  double turnError = -0.03;     //!< Of the wheels, share.
  std::uint64_t seed = 1;
};

/*! One image and what the robot made of it. */
struct Step
{
  double time = 0.;                   //!< Seconds.
  FloorPose truth, believed, wheels;  //!< Wheels: by dead reckoning alone.
  unsigned int markers = 0;           //!< That the place was made of.
  double sigmas = 0.;                 //!< Error of the belief in its own standard deviations.
  std::optional<double> cameraError;  //!< Of the fused pose alone, the camera's place, metres.
  std::optional<double> cameraSigmas; //!< The same in its own standard deviations: root of the mean square of six.
};

/*! A place where a task was read. */
struct Station
{
  std::string marker;   //!< Its name.
  std::string task;     //!< What it said.
  FloorPose goal;       //!< Where the robot was to be; the start for the first.
  FloorPose truth;      //!< Where it was.
  vpImage<vpRGBa> view; //!< What it saw.
};

struct Journey
{
  std::vector<Step> steps;
  std::vector<Station> stations;
  bool isComplete = false; //!< The last task said to stop, or as many were done as were asked for.
  std::string problem;     //!< Why not.
};

/*! Drives; the progress counts stations. */
Journey drive(const common::Room &room, const Settings &settings, const common::Progress &progress);
} // namespace navigation

#endif
