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
 * FireWire cameras (IIDC over IEEE 1394, and USB cameras that speak IIDC), through ViSP's grabber.
 */

#ifndef VP_TUTORIAL_FIREWIRE_CAMERA_H
#define VP_TUTORIAL_FIREWIRE_CAMERA_H

#include <filesystem>
#include <memory>
#include <string>

#include "camera_settings.h"
#include "frame_source.h"

namespace tutorial {
/*!
  Opens a camera with vp1394TwoGrabber.

  \exception SourceError : If it cannot be used.
  \exception UsageError : If it does not have what was asked for.
*/
std::unique_ptr<FrameSource> openFireWireCamera(const CameraSettings &settings);

/*! \return The FireWire cameras, one on each line with its GUID and its modes, or what is missing to find any. */
std::string listFireWireCameras();

/*!
  \return What to do when no camera is found: what this computer lacks, and in which order to look.
  \param root : Root of the file system; tests have one of their own.
*/
std::string fireWireAdvice(const std::filesystem::path &root = "/");
} // namespace tutorial

#endif
