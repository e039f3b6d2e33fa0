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
 * The spin of a marker whose code is covered in part.
 */

#ifndef VP_CIRCLE_MARKER_SPIN_SEARCH_H
#define VP_CIRCLE_MARKER_SPIN_SEARCH_H

#include <vector>

#include "refine/ranked_fits.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! Whether a fit leaves out so many pixels that something may cover a part of the code, and has turned its start. */
bool mayBeTurned(const FittedPose &fit);

/*!
  Looks up to half a sector to either side whether the pixels are explained better with another spin, and fits both
  poses from there. What covers a part of a code draws its reading aside by some hundredths of a turn, where the true
  borders between sectors are outliers: a fit does not find back to them.
  \param pixels : The pixels, those that the fitter has.
  \param ranked : The fits, at least one.
  \param pattern : The print, with a code.
  \param settings : Of the fits. After their deadline nothing is sought.
  \param fitter : Fits.
  \return The better fits, or those that there were.
*/
RankedFits withBetterSpin(const std::vector<FitPixel> &pixels, const RankedFits &ranked, const MarkerPattern &pattern,
                          FitSettings settings, Fitter &fitter);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
