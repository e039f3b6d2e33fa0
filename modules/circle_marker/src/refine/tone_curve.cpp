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
 * Fits of a marker in the image of a camera whose tone curve is no power of the light.
 */

#include "refine/tone_curve.h"

#include <algorithm>
#include <cmath>

#include "refine/coarse_fits.h"
#include "support/sensor_range.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// What leaves more than this factor of the noise, beyond a standard deviation of chance, may have a tone curve; and
// what leaves less than the other, as a curve that raises the contrast has more noise between black and white than in
// both.
constexpr double muchLeft = 1.03;
constexpr double littleLeft = 0.97;
// And so may ink that seems to have spread by more than this share of the blur.
constexpr double muchOfBlur = 0.1;
// Log-odds by which a curve explains the pixels better than none. Two more numbers do by 2 of their own accord in one
// of seven; then a little precision is lost, with a curve that is missed the truth of the covariance.
constexpr double leastGain = 2.;
// Cameras' curves are steeper in the middle, at least by so much. A weaker one explains the spread of ink, of which
// less is said where there is a curve, and one of the other kind halos that are cut off at black and white.
constexpr double leastCurve = 0.05;
} // namespace

bool mayHaveToneCurve(const FittedPose &fit, std::size_t pixels, double size, double noise)
{
  const Photometry &photometry = fit.photometry;
  const double left = keptOfNoise * unexplainedBy(fit);
  const double chance = std::sqrt(fit.sharing / (2. * static_cast<double>(pixels)));
  return left > mostLeftByNoise(fit, pixels, noise, muchLeft, 1.) || left < (littleLeft - chance) * noise ||
         std::abs(photometry.blur.spread) * size > muchOfBlur * photometry.blur.widest();
}

RankedFits fitToneCurve(const std::vector<FitPixel> &pixels, const RankedFits &fits, const MarkerPattern &pattern,
                        const FitSettings &settings, Fitter &fitter)
{
  LightExtension curve;
  curve.extend = [](Photometry &light) { light.toneCurve = light.toneCurve.value_or(0.); };
  curve.has = [](const Photometry &light) { return light.toneCurve.has_value(); };
  curve.isPossible = [](const Photometry &light) { return *light.toneCurve < -leastCurve; };
  curve.leastGain = leastGain;
  return fitExtended(pixels, fits, curve, pattern, settings, fitter);
}
} // namespace circle_marker
END_VISP_NAMESPACE
