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
  \file tone_curve.h
  \brief Fits of a marker in the image of a camera whose tone curve is no power of the light.

  Most cameras raise the contrast, and bend the curve where it is brightest. Blurred edges are then no Gaussian's: black
  looks larger or smaller by a part of the blur, and that was taken for the depth. The curve between ink and paper has a
  parameter of its own (maximum_likelihood.h), but only where a marker leaves more or less than noise or its ink seems
  to have spread: on others it would cost precision and time. Plain rings show too little of it:
  from a radius of 10 pixels on all are fitted with it, and the curve is taken if it explains more.
*/

#ifndef VP_CIRCLE_MARKER_TONE_CURVE_H
#define VP_CIRCLE_MARKER_TONE_CURVE_H

#include "refine/ranked_fits.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Whether a fit may have missed a tone curve.
  \param fit : The fit.
  \param pixels : Number of its pixels.
  \param size : Radius of the marker, pixels.
  \param noise : Of the image, standard deviation, grey levels.
*/
bool mayHaveToneCurve(const FittedPose &fit, std::size_t pixels, double size, double noise);

/*!
  Fits both poses with a tone curve.
  \param pixels : The pixels, those that the fitter has.
  \param fits : Those without, at least one.
  \param pattern : The print.
  \param settings : Of these fits.
  \param fitter : Fits.
  \return The fits with it, or those without if they explain the pixels as well.
*/
RankedFits fitToneCurve(const std::vector<FitPixel> &pixels, const RankedFits &fits, const MarkerPattern &pattern,
                        const FitSettings &settings, Fitter &fitter);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
