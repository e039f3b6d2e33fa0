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
 * Recorded images in place of a camera's.
 */

#ifndef VP_TUTORIAL_RECORDING_H
#define VP_TUTORIAL_RECORDING_H

#include <memory>

#include "camera_settings.h"
#include "frame_source.h"

namespace tutorial {
/*!
  Opens an image, a sequence, a video or a list of images; with a frame rate it is played at that pace.
  \exception SourceError : If there is nothing to be opened.
*/
std::unique_ptr<FrameSource> openRecording(const CameraSettings &settings);
} // namespace tutorial

#endif
