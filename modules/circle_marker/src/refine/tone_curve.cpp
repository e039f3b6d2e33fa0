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
#include "refine/pose_odds.h"
#include "support/sensor_range.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// What leaves more than this factor of the noise, and this share of the contrast, may have a tone curve; and what
// leaves less than the other, as a curve that raises the contrast has more noise between black and white than in both.
constexpr double muchLeft = 1.03;
constexpr double littleLeft = 0.97;
constexpr double lacking = 0.001;
constexpr double byChance = 0.7; // by the square root of the number of pixels: one standard deviation
// Share of normal noise that is not taken for outliers: the biweight's mean.
constexpr double keptOfNoise = 0.915;
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
  const double chance = byChance * std::sqrt(fit.sharing / static_cast<double>(pixels));
  const double most =
      std::hypot((muchLeft + chance) * std::max(noise, quantisation), lacking * photometry.tellableContrast());
  const double left = keptOfNoise * unexplainedBy(fit);
  return left > most || left < (littleLeft - chance) * noise ||
         std::abs(photometry.blur.spread) * size > muchOfBlur * photometry.blur.widest();
}

RankedFits fitToneCurve(const std::vector<FitPixel> &pixels, const RankedFits &fits, const MarkerPattern &pattern,
                        FitSettings settings, Fitter &fitter)
{
  settings.samePixels = true;
  const FittedPose &rival = fits.fits[0];
  Few<FitStart> starts;
  for (const FittedPose &fit : fits.fits) {
    Photometry light = fit.photometry;
    light.toneCurve = light.toneCurve.value_or(0.);
    starts.push_back({fit.plane, light, fits.noise});
  }
  Few<FittedPose> toned = fitAll(pixels, starts, pattern, settings, fitter);
  toned.push_back(rival);
  RankedFits ranked = rank(pixels, pattern, true, toned, fitter);
  const auto isWithout = [](const FittedPose &fit) { return !fit.photometry.toneCurve; };
  FittedPose *const last = std::find_if(ranked.fits.begin(), ranked.fits.end(), isWithout);
  const FittedPose &best = ranked.fits[0];
  const bool isCurve = best.photometry.toneCurve && *best.photometry.toneCurve < -leastCurve;
  if (last == ranked.fits.end() || !isCurve ||
      costOf(last->squares - best.squares, ranked.noise, best.sharing) / best.edgeNoise < leastGain) {
    return fits;
  }
  std::rotate(last, last + 1, ranked.fits.end());
  ranked.fits.pop_back();
  keepTwo(ranked);
  return ranked.fits.size() > 1 ? ranked : withMirrored(pixels, ranked, pattern, settings, fitter);
}
} // namespace circle_marker
END_VISP_NAMESPACE
