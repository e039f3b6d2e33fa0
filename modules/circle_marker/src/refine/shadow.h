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
 * A shadow whose edge falls on a marker.
 */

/*!
  \file shadow.h
  \brief Whether the edge of a shadow falls on a marker, and where: for the start of a fit.
*/

#ifndef VP_CIRCLE_MARKER_SHADOW_H
#define VP_CIRCLE_MARKER_SHADOW_H

#include <algorithm>
#include <optional>

#include "refine/fit_pixel.h"
#include "support/camera_model.h"

#include <visp3/core/vpImage.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Softness of a shadow's edge that a fit starts with, in the coordinates of an ImageFrame: of the edge little is known.
  \param frameSize : Size of the frame, pixels.
*/
inline double softnessAtStart(double frameSize)
{
  constexpr double common = 2.; // pixels
  constexpr double most = 0.3;  // a softer edge is a gradient
  return std::min(common / frameSize, most);
}

/*!
  Looks for a shadow in the white of the quiet zone.
  \param I : The image.
  \param camera : Its camera.
  \param frame : Coordinates of the shadow.
  \param plane : The marker, known to about a pixel.
  \param quietZone : Width of the white around the ring, in units of its radius.
  \return Nothing if the light is even, but for a gradient, or the quiet zone lies partly outside of the image.
*/
std::optional<Shadow> shadowOn(const vpImage<unsigned char> &I, const CameraModel &camera, const ImageFrame &frame,
                               const MarkerPlane &plane, double quietZone);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
