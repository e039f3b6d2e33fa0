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
 */

/*!
  \file bent_sheet.h
  \brief Fits of a marker whose sheet is bent.

  Paper is seldom flat to a hundredth of a pixel: a sheet that is bowed by 2 mm moves the print of a tilted marker of
  100 pixels by a pixel. The bend is of three numbers (SheetBend), which are fitted with all others, but only where
  parts of the print pull the pose of a flat sheet apart: on a flat one they would cost precision and tell nothing.
*/

#ifndef VP_CIRCLE_MARKER_BENT_SHEET_H
#define VP_CIRCLE_MARKER_BENT_SHEET_H

#include "refine/ranked_fits.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Fits both poses with a sheet that may be bent.
  \param pixels : The pixels, those that the fitter has.
  \param fits : Those of a flat sheet, at least one.
  \param pattern : The print.
  \param settings : Of these fits.
  \param fitter : Fits.
  \return The fits of a bent sheet, or those of the flat one if that explains the pixels as well.
*/
RankedFits fitBent(const std::vector<FitPixel> &pixels, const RankedFits &fits, const MarkerPattern &pattern,
                   FitSettings settings, Fitter &fitter);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
