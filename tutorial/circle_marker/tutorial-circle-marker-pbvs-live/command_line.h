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
 * The command line of tutorial-circle-marker-pbvs-live.
 */

#ifndef VP_TUTORIAL_PBVS_LIVE_COMMAND_LINE_H
#define VP_TUTORIAL_PBVS_LIVE_COMMAND_LINE_H

#include <cstdint>
#include <optional>
#include <string>

#include "../common/arguments.h"
#include "../common/cameras/camera_settings.h"
#include "../common/detection/detector_options.h"
#include "../common/servo/servo_scene.h"
#include "../common/servo/servo_task.h"

namespace tutorial {
/*! What the program is asked to do. */
struct Order
{
  std::optional<CameraSettings> camera; //!< Where the images come from; nothing: the simulated camera.
  std::string cameraFile;               //!< XML file; empty with the simulated camera: the reference camera.
  std::string cameraName = "Camera";    //!< Name of the camera in it.
  DetectorSettings detector;            //!< What to look for.
  int id = anyId;                       //!< Of the marker.
  std::string robotAddress;             //!< For the user's robot.
  double distance = 0.5;                //!< Desired distance of the marker, metres.
  ServoLimits limits;                   //!< The greatest velocities.
  double acceptedDistance = 1e-3;       //!< Metres.
  double acceptedAngle = 0.;            //!< Radians.
  unsigned int mostImages = 1000;       //!< After which the servo gives up.
  double timeout = 5.;                  //!< Longest wait for an image, seconds.
  bool display = true;                  //!< Whether to open windows.
  std::string folder = ".";             //!< For table, plot and pictures.
};

using Request = RequestFor<Order>;

/*!
  \exception UsageError : If the arguments are wrong.
*/
Request parseCommandLine(int argc, const char *const argv[]);
} // namespace tutorial

#endif
