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
 * Cameras of Video4Linux 2, through ViSP's grabber.
 */

#ifndef VP_TUTORIAL_V4L2_CAMERA_H
#define VP_TUTORIAL_V4L2_CAMERA_H

#include <memory>
#include <string>

#include "camera_settings.h"
#include "frame_source.h"

namespace tutorial {
/*!
  Opens a camera with vpV4l2Grabber.
  \exception SourceError : If it cannot be used.
*/
std::unique_ptr<FrameSource> openV4l2Camera(const CameraSettings &settings);

/*! \return The devices /dev/video*, one on each line, or what is missing to use any. */
std::string listV4l2Cameras();
} // namespace tutorial

#endif
