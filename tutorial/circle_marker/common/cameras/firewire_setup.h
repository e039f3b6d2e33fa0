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
 * How a FireWire camera is set.
 */

#ifndef VP_TUTORIAL_FIREWIRE_SETUP_H
#define VP_TUTORIAL_FIREWIRE_SETUP_H

#include "firewire_bus.h"

#ifdef CIRCLE_MARKER_HAVE_FIREWIRE
#include <optional>
#include <string>

#include <visp3/sensor/vp1394TwoGrabber.h>

#include "../visp_names.h"
#include "camera_settings.h"

namespace tutorial {
/*!
  Sets video mode, frame rate, region, colour coding, shutter and gain of the camera that the grabber has chosen, and
  starts it.

  \return Time between two images, seconds, if it is known.
  \exception UsageError : If the camera does not have what was asked for; says what it has.
  \exception vpException : If the camera does not take it.
*/
std::optional<double> setUpFireWireCamera(vp1394TwoGrabber &grabber, const FireWireHandle &handle,
                                          const CameraSettings &settings);

/*! \return The video modes of the camera that the grabber has chosen, as --video-mode takes them. */
std::string videoModesOf(vp1394TwoGrabber &grabber);
} // namespace tutorial
#endif

#endif
