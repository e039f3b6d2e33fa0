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
  \file curved_light.h
  \brief Fits of a marker in light that bends over it.

  A lens's corners are darker than its middle, by the fourth power of the cosine of the angle to its axis and more
  (Kingslake, Optics in Photography, 1992, chapter 8). Over a marker the light is then no plane: over a radius of 100
  pixels in the middle before a lens of 800 it bends by 3 %, which moves edges by some hundredths of a pixel, the outer
  ones in and the inner ones out. So it has three more numbers (Photometry::lightCurvature), but only where the image
  asks for them: each costs a column of the fit, and precision.
*/

#ifndef VP_CIRCLE_MARKER_CURVED_LIGHT_H
#define VP_CIRCLE_MARKER_CURVED_LIGHT_H

#include <vector>

#include "refine/ranked_fits.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Whether the pixels ask for light that bends, more than chance does once in some hundred markers: Rao's score test, by
  what a fit with a plane leaves of them (FittedPose::bendOfLight).
*/
bool isLightCurved(const FittedPose &fit);

/*!
  Whether the light falls off as before a lens: across the way from wherever it is brightest it always does, along it
  may bend either way. What is brighter beside black, as the halos of a camera that sharpens, bends upward in all
  directions.
*/
bool fallsOff(const Photometry &light);

/*! Fits both poses with light that bends; parameters and result are those of fitExtended(). */
RankedFits fitCurvedLight(const std::vector<FitPixel> &pixels, const RankedFits &fits, const MarkerPattern &pattern,
                          const FitSettings &settings, Fitter &fitter);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
