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
 * The command line of tutorial-circle-marker-detector-live.
 */

#ifndef VP_TUTORIAL_LIVE_COMMAND_LINE_H
#define VP_TUTORIAL_LIVE_COMMAND_LINE_H

#include <optional>
#include <string>

#include "../common/arguments.h"
#include "../common/cameras/camera_settings.h"
#include "../common/detection/detector_options.h"

namespace tutorial {
/*! What the program is asked to do. */
struct Order
{
  CameraSettings camera;              //!< Where the images come from.
  std::string cameraFile;             //!< XML file.
  std::string cameraName;             //!< Name of the camera in it.
  DetectorSettings detector;          //!< What to look for.
  std::string json;                   //!< File for the results; empty: standard output.
  std::string record;                 //!< Pattern of the recorded images; empty: none.
  std::optional<unsigned long> count; //!< Number of images after which to end.
  double timeout = 5.;                //!< Longest wait for an image, seconds.
  bool allImages = false;             //!< Whether no image is passed over.
  bool display = true;                //!< Whether to open a window.
};

using Request = RequestFor<Order>;

/*!
  \exception UsageError : If the arguments are wrong.
*/
Request parseCommandLine(int argc, const char *const argv[]);
} // namespace tutorial

#endif
