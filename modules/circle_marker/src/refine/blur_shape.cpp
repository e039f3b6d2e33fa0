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

#include <algorithm>
#include <cmath>

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
// A motion's way is long, but what its shape leaves mostly cancels between its two ends. Of a ring without a code,
// whose edges face both ends alike, it leaves the rest: over so many pixels, in units of the product of the blur's
// standard deviations across the motion and what it is longer along it. (Motions of a tenth of the diameter, 40 to 160
// pixels.)
constexpr double coherentAreaOfMotion = 1.5;
} // namespace

void widenByShapeOfBlur(double noise, bool isCoded, const std::optional<double> &leftAlike, FittedPose &fit)
{
  const BlurParameters &fitted = fit.photometry.blur;
  const double widest = fitted.widest();
  const double narrowest = fitted.sigma * fitted.sigma / widest;
  const double usual = usualNoise * noise;
  if (fit.noise <= usual) {
    return;
  }
  double area = 0.; // pixels
  if (narrowest > wideBlur) {
    area += (isCoded ? coherentAreaOfCode : coherentArea) * narrowest * narrowest;
  }
  if (widest > wideBlur && !isCoded) {
    area += coherentAreaOfMotion * narrowest * (widest - narrowest);
  }
  double left = fit.noise * fit.noise - usual * usual; // grey levels^2
  if (leftAlike) {
    left = std::min(left, std::pow(*leftAlike * fit.photometry.tellableContrast(), 2.));
  }
  const double share = left / (fit.noise * fit.noise);
  fit.covariance *= 1. + share * area;
}
} // namespace circle_marker
END_VISP_NAMESPACE
