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
 * Coarse fits of a marker in uneven light.
 */

#ifndef VP_CIRCLE_MARKER_MISSED_LIGHT_H
#define VP_CIRCLE_MARKER_MISSED_LIGHT_H

#include <vector>

#include "refine/coarse_fits.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Whether coarse fits of a marker that was read for certain leave so much that the light on it may be uneven. This is
  not asked of covered markers, nor where paper is brighter than the sensor can tell: what is cut off
  there looks like uneven light, and hides what tells a code from another (over_exposed_code.h).
  \param view : The marker.
  \param pattern : Its print.
  \param few : The fits.
  \param pixels : The pixels that were fitted.
  \param noise : Standard deviation of the image's noise, grey levels.
*/
bool mayBeInUnevenLight(const MarkerInImage &view, const MarkerPattern &pattern, const RankedFits &few,
                        const std::vector<FitPixel> &pixels, double noise);

/*!
  Coarse fits of pixels that are taken to even light, by the light that such fits show in what they leave.
  \param view : The marker; it takes the light.
  \param pattern : The print.
  \param few : The fits.
  \param settings : Of the fits.
  \param memory : Holds the pixels that were fitted; those of the last fit.
  \return The fits as they are if those do not leave far less.
*/
RankedFits withEvenLight(MarkerInImage &view, const MarkerPattern &pattern, const RankedFits &few,
                         const FitSettings &settings, FittingMemory &memory);

/*!
  Tells the light by a fit.
  \param view : The marker, with the light to which the pixels were taken, if any; it takes the new one.
  \param pattern : The print.
  \param fit : The fit.
  \param settings : Of the fit.
  \param memory : Holds the pixels that were fitted.
  \return Whether it is told; nothing changes if not.
*/
bool tellLight(MarkerInImage &view, const MarkerPattern &pattern, const FittedPose &fit, const FitSettings &settings,
               FittingMemory &memory);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
