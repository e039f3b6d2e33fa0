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
 * What the shape of a wide blur leaves of a fit.
 */

#include "refine/blur_shape.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// From this blur on, standard deviation, pixels, its shape matters: that of a lens out of focus is a disc, and the
// model's a Gaussian.
constexpr double wideBlur = 1.2;
// A fit may leave this much of the image's noise for no other reason than chance.
constexpr double usualNoise = 1.03;
// What the shape leaves goes the same way over so many pixels, in units of the blur's variance: the disc, twice the
// standard deviation in radius, covers 4 pi of them, and its rim lies along the ring.
constexpr double coherentArea = 20.;
// Where the edges of a code face all ways, over about a quarter of them.
constexpr double coherentAreaOfCode = 5.;
} // namespace

void widenByShapeOfBlur(double noise, bool isCoded, FittedPose &fit)
{
  // Where it is narrow: a motion's way is long, but what its shape leaves cancels between its two ends.
  const BlurParameters &fitted = fit.photometry.blur;
  const double blur = fitted.sigma * fitted.sigma / fitted.widest();
  const double usual = usualNoise * noise;
  if (blur > wideBlur && fit.noise > usual) {
    const double share = 1. - usual * usual / (fit.noise * fit.noise);
    fit.covariance *= 1. + share * (isCoded ? coherentAreaOfCode : coherentArea) * blur * blur;
  }
}
} // namespace circle_marker
END_VISP_NAMESPACE
