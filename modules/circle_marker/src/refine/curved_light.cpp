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
 * Fits of a marker in light that bends over it.
 */

#include "refine/curved_light.h"

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// chi^2 that is worth a fit. What the light and ink say of it is no more than all parameters together would, and half
// to three quarters of that (testCurvedLight records it): so chance says as much once in some hundred markers or less,
// and what says less is hardly worth leastGain. Of normal noise the biweight's pulls have this share of the variance
// that they are compared with (pullOfNoise).
constexpr double clearOfChance = 9.;
constexpr double shareOfPulls = 0.66;
// By so much, ln, the light that bends has to explain all pixels better: chi^2 of 12.
constexpr double leastGain = 6.;
// And bend downward in one direction by so much at least, from the centre to the rim, share of the light: less is
// chance.
constexpr double leastFall = 0.001;
} // namespace

bool isLightCurved(const FittedPose &fit)
{
  const double unit = shareOfPulls * fit.sharing * std::max(fit.edgeNoise, 1.) * fit.noise * fit.noise; // grey levels^2
  return fit.bendOfLight > clearOfChance * unit;
}

bool fallsOff(const Photometry &light)
{
  const Eigen::Vector3d bend = light.lightCurvature.value_or(Eigen::Vector3d::Zero());
  const double least = 0.5 * (bend[0] + bend[2]) - 0.5 * std::hypot(bend[0] - bend[2], bend[1]); // eigenvalue
  return least < -leastFall;
}

RankedFits fitCurvedLight(const std::vector<FitPixel> &pixels, const RankedFits &fits, const MarkerPattern &pattern,
                          const FitSettings &settings, Fitter &fitter)
{
  LightExtension curvature;
  curvature.extend = [](Photometry &light) { light.lightCurvature = Eigen::Vector3d::Zero(); };
  curvature.has = [](const Photometry &light) { return light.lightCurvature.has_value(); };
  curvature.isPossible = fallsOff;
  curvature.leastGain = leastGain;
  return fitExtended(pixels, fits, curvature, pattern, settings, fitter);
}
} // namespace circle_marker
END_VISP_NAMESPACE
