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
 * What a lens does to the image of a marker besides a linear map.
 */

#ifndef VP_CIRCLE_MARKER_LENS_SECOND_ORDER_H
#define VP_CIRCLE_MARKER_LENS_SECOND_ORDER_H

#include <vector>

#include <Eigen/Core>

#include "refine/fit_pixel.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! Whether all pixels, one at least, have the same derivative, as with a camera without distortion. */
bool isUniform(const std::vector<FitPixel> &pixels);

/*!
  Second derivative of where a lens has pixels by these: of (u, v) along uu, uv and vv, in pixels, 1 / pixel. It is that
  of how the pixels' first derivatives change over the marker, by least squares on some of them: as good as it is the
  same all over the marker. \param pixels : Of a marker; one at least. \return 0 without distortion, and where the
  pixels do not tell.
*/
Eigen::Matrix<double, 2, 3> secondOrderOfLens(const std::vector<FitPixel> &pixels);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
