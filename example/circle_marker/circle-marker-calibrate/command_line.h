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
 * Command line of circle-marker-calibrate.
 */

#ifndef VP_CALIBRATE_COMMAND_LINE_H
#define VP_CALIBRATE_COMMAND_LINE_H

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "circle_marker/common/arguments.h"
#include "circle_marker/common/cameras/camera_settings.h"

#include "lens.h"
#include "target.h"

namespace calibrate {
/*! Where the pictures are from. */
struct PictureOrder
{
  std::string input; //!< Files; empty: none.
  std::optional<long> first, last;
  std::optional<tutorial::CameraSettings> camera; //!< A camera, live.
  unsigned int simulated = 0;                     //!< Number of simulated pictures; 0: none are simulated.
  unsigned int wanted = 15;                       //!< Views to take from a live camera.
  double timeout = 5.;                            //!< Seconds without an image after which a live camera is given up.
  bool display = true;
};

/*! The camera and the poses that are simulated. */
struct SimulationOrder
{
  vpCameraParameters camera;
  unsigned int width = 0;
  unsigned int height = 0;
  double leastTilt = 10., mostTilt = 45.; //!< Degrees.
  std::uint64_t seed = 1;
};

/*! What to do. */
struct Order
{
  std::string convert; //!< A camera file of OpenCV or ROS to be converted; empty: calibrate.
  PictureOrder pictures;
  SimulationOrder simulation;
  Target target;
  std::vector<LensModel> models;
  bool compareVisp = false;
  std::string output, cameraName, json, residuals, savedViews;
};

using Request = tutorial::RequestFor<Order>;

/*! \exception common::UsageError : If the arguments are wrong. */
Request parseCommandLine(int argc, const char *const argv[]);
} // namespace calibrate

#endif
