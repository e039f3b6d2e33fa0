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
 * Where the fit of a marker to a blurred image may start.
 */

/*!
  \file blurred_looks.h
  \brief Where the fit of a marker to a blurred image may start.
*/

#ifndef VP_CIRCLE_MARKER_BLURRED_LOOKS_H
#define VP_CIRCLE_MARKER_BLURRED_LOOKS_H

#include <vector>

#include "decode/blurred_marker.h"
#include "ellipse/conic.h"
#include "support/deadline.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Fits with sectors of any grey to the image around a blurred outline, by few samples and a few steps: from both poses
  of the outline, out of focus by some discs, and moved in some directions by some ways.
  \param marker : The marker in the image.
  \param camera : Its camera.
  \param outline : Ellipse of the blurred outline, pixels.
  \param radius : Outer radius of the ring, metres.
  \param deadline : When to stop.
  \return The best two, the best first; fewer if nothing like the marker is there.
*/
std::vector<BlurredFit> bestLooks(BlurredMarker &marker, const CameraModel &camera, const EllipseParameters &outline,
                                  double radius, const Deadline &deadline);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
