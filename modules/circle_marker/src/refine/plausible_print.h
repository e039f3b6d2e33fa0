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
 * Whether a fit is one of a print.
 */

#ifndef VP_CIRCLE_MARKER_PLAUSIBLE_PRINT_H
#define VP_CIRCLE_MARKER_PLAUSIBLE_PRINT_H

#include "refine/coarse_fits.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! A marker's image correlates with its model by more than this, even with noise of a third of the contrast. */
constexpr double leastCorrelationOfMarker = 0.85;

/*!
  Whether a fit to a code in doubt, which mostly is none, may be that of a print: it is none if it explains the image by
  ink that takes more than all of the light, by a size that is not that of the outline, or by a blur that leaves nothing
  of a code; or if a coarse one hardly correlates.
  \param fit : The fit.
  \param view : What it was fitted to.
  \param isCoarse : Whether it is a coarse one, whose size and blur are less certain.
*/
bool mayBePrint(const FittedPose &fit, const MarkerInImage &view, bool isCoarse);

/*!
  Whether what is seen of a plain ring, of which something covers a part, is explained but for noise.
  \param fit : The fit to it.
  \param view : What it was fitted to.
  \param noise : Standard deviation of the image's noise, grey levels.
  \param isCoarse : Whether the fit is a coarse one, which leaves more.
*/
bool isRingWhereSeen(const FittedPose &fit, const MarkerInImage &view, double noise, bool isCoarse);

/*!
  Whether a marker's best fit explains its image, by light, ink and paper as there are.
  \param best : The fit.
  \param view : What it was fitted to.
  \param hasCode : Whether the print that was fitted has a code.
  \param refine : Whether the pose was refined.
*/
bool isExplained(const FittedPose &best, const MarkerInImage &view, bool hasCode, bool refine);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
