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
 * Images as libdc1394 delivers them.
 */

#ifndef VP_TUTORIAL_FIREWIRE_FRAME_H
#define VP_TUTORIAL_FIREWIRE_FRAME_H

#include "firewire_bus.h"

#ifdef CIRCLE_MARKER_HAVE_FIREWIRE
#include <string>

#include <visp3/core/vpImage.h>

#include "../visp_names.h"

namespace tutorial {
/*!
  \return What is wrong with an image, empty if nothing is. vp1394TwoGrabber copies width times height pixels whatever
  the frame holds, and does not ask libdc1394 whether packets were lost.
*/
std::string frameDefect(const dc1394video_frame_t &frame);

/*!
  Converts an image to grey levels, as vp1394TwoGrabber::dequeue() does: the same functions for the same codings.
  \exception SourceError : If ViSP cannot convert the coding.
*/
void convertFrame(const dc1394video_frame_t &frame, vpImage<unsigned char> &I);
} // namespace tutorial
#endif

#endif
