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
 * Fits of a marker on all of its pixels.
 */

#ifndef VP_CIRCLE_MARKER_FINE_FITS_H
#define VP_CIRCLE_MARKER_FINE_FITS_H

#include "refine/coarse_fits.h"
#include "refine/measure.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Of markers below this radius, pixels, both poses are refined: all pixels cost little more than the few, and a coarse
  fit that was stuck made the right pose of some markers of 16 pixels hopeless.
*/
constexpr double leastHopelessSize = 20.;

/*!
  The fits on all pixels around the coarse ones, and what only these tell: the light, the spin and the sheet's bend.
  \param view : What is looked at; it takes the light.
  \param coarse : The coarse fits.
  \param isInDoubt : Whether its code is not proven yet.
  \param isOneGivenUp : Whether one of its poses was given up.
  \param settings : Of the fits.
  \param pattern : The print; it takes the turn of the sheet's edge.
  \param memory : Working memory.
*/
RankedFits fitFinely(MarkerInImage &view, const RankedFits &coarse, bool isInDoubt, bool isOneGivenUp,
                     const FitSettings &settings, MarkerPattern &pattern, MeasureMemory &memory);

/*!
  One fit on all pixels from a pose that is nearly right, in its light and with its bend, if it has one.
  \param view : What is looked at.
  \param around : Around whose edges the pixels are chosen, as far as its blur reaches.
  \param from : The pose.
  \param settings : Of the fit.
  \param pattern : The print; it takes the turn of the sheet's edge.
  \param memory : Working memory.
*/
std::optional<FittedPose> fitOnce(const MarkerInImage &view, const FittedPose &around, const FittedPose &from,
                                  FitSettings settings, MarkerPattern &pattern, MeasureMemory &memory);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
