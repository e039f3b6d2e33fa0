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
 * A few pixels across the edges of a marker.
 */

#ifndef VP_CIRCLE_MARKER_FEW_PIXELS_H
#define VP_CIRCLE_MARKER_FEW_PIXELS_H

#include <vector>

#include "refine/fit_pixel.h"
#include "support/camera_model.h"

#include <visp3/core/vpImage.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Chooses a few hundred pixels, however large the marker: short rows across the edges of the pattern, which measure a
  pose well enough to go on from with all pixels (selectPixels()).
  \param I : The image.
  \param camera : Its camera.
  \param frame : Coordinates of the pixels' offsets.
  \param planes, count : The hypotheses; each gets its share of the rows.
  \param pattern : The print.
  \param blur : Blur expected at the edges: the spacing of the pixels in a row.
  \param pixels : The result; its memory is used again. A small marker's rows may share pixels.
*/
void selectFewPixels(const vpImage<unsigned char> &I, const CameraModel &camera, const ImageFrame &frame,
                     const MarkerPlane *planes, std::size_t count, const MarkerPattern &pattern,
                     const BlurParameters &blur, std::vector<FitPixel> &pixels);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
