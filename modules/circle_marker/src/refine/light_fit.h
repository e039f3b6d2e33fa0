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
 * The uneven light on a marker, by what a fit in even light makes of it.
 */

#ifndef VP_CIRCLE_MARKER_LIGHT_FIT_H
#define VP_CIRCLE_MARKER_LIGHT_FIT_H

#include <optional>
#include <vector>

#include "decode/uneven_light.h"
#include "refine/shadow_split.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  The light that the pixels around a marker's edges show. With the share of black that each sees by a fit, their grey
  levels are linear in the coefficients of both functions, which are found by weighted least squares; the prior is even
  light (so that they are a Gaussian process, of which the grid is the base).
  \param pixels : The pixels, by a fit whose pose may be off by a pixel.
  \param frame : Coordinates of their offsets.
  \param toSheet : From offsets to outer radii on the sheet.
  \param noise : Standard deviation of the image's noise, grey levels.
  \return Nothing where no print is seen.
*/
std::optional<UnevenLight> unevenLightOf(const std::vector<ExplainedPixel> &pixels, const ImageFrame &frame,
                                         const Eigen::Matrix2d &toSheet, double noise);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
