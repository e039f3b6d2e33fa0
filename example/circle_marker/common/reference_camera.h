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
 * The simulated camera of all figures: the reference camera.
 */

#ifndef VP_COMMON_REFERENCE_CAMERA_H
#define VP_COMMON_REFERENCE_CAMERA_H

#include <visp3/core/vpCameraParameters.h>

#include "circle_marker/common/moved_camera.h"
#include "visp_names.h"

namespace common {
/*! The reference camera of this project: the thesis's 1280 x 960 pixels of 3.75 um behind a lens of 6 mm. */
constexpr unsigned int imageWidth = 1280;
constexpr unsigned int imageHeight = 960;
constexpr double focalLength = 1600; // Pixels: an angle of view of 43.6 by 33.4 degrees.

inline vpCameraParameters referenceCamera()
{
  return vpCameraParameters(focalLength, focalLength, 0.5 * (imageWidth - 1), 0.5 * (imageHeight - 1));
}

/*!
  AprilTag's image origin is the corner of the first pixel, ViSP's its centre: what AprilTag measures is off by half a
  pixel, and so is the camera that undoes it.
*/
inline vpCameraParameters halfPixelCamera(const vpCameraParameters &cam)
{
  constexpr double offset = 0.5; // pixels
  return tutorial::movedPrincipalPoint(cam, offset, offset);
}
} // namespace common

#endif
