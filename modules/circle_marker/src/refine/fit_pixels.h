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
 * The pixels a marker's pose is refined on.
 */

#ifndef VP_CIRCLE_MARKER_FIT_PIXELS_H
#define VP_CIRCLE_MARKER_FIT_PIXELS_H

#include <vector>

#include "refine/fit_pixel.h"
#include "refine/lanes.h"
#include "support/camera_model.h"

#include <visp3/core/vpImage.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
/*!
  Chooses the pixels that carry information on the pose: those near an edge of the pattern in any of the hypotheses,
  and a few of the flat areas that fix white and black. Very large markers are thinned to keep the number bounded.
  \param I : The image.
  \param camera : Its camera.
  \param frame : Coordinates of the pixels' offsets.
  \param planes, count : The hypotheses.
  \param pattern : The print.
  \param choice : Which pixels near an edge, and how many.
  \param pixels : The result; its memory is used again.
*/
void selectPixels(const vpImage<unsigned char> &I, const CameraModel &camera, const ImageFrame &frame,
                  const MarkerPlane *planes, std::size_t count, const MarkerPattern &pattern, const PixelChoice &choice,
                  std::vector<FitPixel> &pixels);
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
