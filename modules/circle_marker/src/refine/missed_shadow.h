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
 * The fit of a marker under a shadow that its quiet zone does not show.
 */

#ifndef VP_CIRCLE_MARKER_MISSED_SHADOW_H
#define VP_CIRCLE_MARKER_MISSED_SHADOW_H

#include "refine/coarse_fits.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Whether coarse fits leave so much that they may have missed a shadow, or taken it to be elsewhere. This is not asked
  of rings without a code, whose shape alone proves them; of covered markers, as what covers them looks like the edge of
  a shadow; and of what is less like the marker than those under shadows are, such as letters.
*/
bool mayHaveShadow(const Recognition &marker, const MarkerPattern &pattern, const RankedFits &few);

/*!
  Coarse fits with the shadow that such fits show in what they leave (shadowBySplit()).
  \param view : The marker.
  \param pattern : The print.
  \param few : The fits.
  \param settings : Of the fits; they take the shadow.
  \param memory : Holds the pixels that were fitted; those of the last fit.
  \return The fits as they are, and the settings too, if those with a shadow do not leave clearly less.
*/
RankedFits withMissedShadow(const MarkerInImage &view, const MarkerPattern &pattern, const RankedFits &few,
                            FitSettings &settings, FittingMemory &memory);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
