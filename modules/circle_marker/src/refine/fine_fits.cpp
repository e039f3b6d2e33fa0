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

#include "refine/fine_fits.h"

#include <array>
#include <optional>

#include "refine/bent_sheet.h"
#include "refine/coarse_fits.h"
#include "refine/curved_light.h"
#include "refine/fit_starts.h"
#include "refine/missed_light.h"
#include "refine/plausible_print.h"
#include "refine/pose_odds.h"
#include "refine/spin_search.h"
#include "refine/surround.h"
#include "refine/tone_curve.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Of a bent sheet's ring this share is seen at least: the quiet zone of one at the image's border is not all in it, and
// such a marker is read as one of which a part is covered.
constexpr double leastSeenOfBent = 0.75;
// Fits from the mirrored pose of the best, at most: the first may become the best, and its own mirrored pose is stuck.
constexpr int mostTwins = 2;
// Plain rings below this radius, pixels, are fitted without a tone curve: one of 6 pixels and a ratio of 0.5 was found
// as that of 0.8 with one.
constexpr double leastTonedRing = 10.;
// Below this radius, pixels, light that bends as before a lens of 800 pixels costs no truth of the covariance that
// shows.
constexpr double leastRadiusInCurvedLight = 30.;
// With light that bends hardly more than noise is left, up to this factor beyond two standard deviations of chance:
// what leaves more has another reason. (Beside black that a camera has sharpened two times by 2 pixels, clipped, five
// of 200 poses were off because halos were taken for such light; with 1.25 one of 40 still, by d^2 / dof 40.)
constexpr double mostLeftInCurvedLight = 1.12;
constexpr double chanceInCurvedLight = 2.;

// Whether the sheet may be bent, as far as the fit can tell: where too much is covered a bend explains what covers it.
bool mayBend(const Recognition &marker, const MarkerPattern &pattern)
{
  const bool isMostlySeen = !marker.seen || marker.seen->shareOfRing() > leastSeenOfBent;
  return isMostlySeen && !marker.darkness && pattern.sectors > 0;
}

bool isCorrected(const Recognition &marker)
{
  return marker.hasCode() && marker.code.hamming > 0;
}

// Whether a tone curve is to be fitted. One shadow is enough; and a plain ring shows too little to tell that there is a
// curve, but of a small one it explains that it has another ratio of radii. A code that had to be corrected,
// or of which a part is covered, is compared with others, which are fitted without: with a curve prints of no codeword
// were taken for the nearest one.
bool mayBeToned(const MarkerInImage &view, const FittedPose &fit, const FitSettings &settings,
                const MarkerPattern &pattern, const MeasureMemory &memory)
{
  if (!settings.gammaAndSpread || fit.photometry.shadow || view.marker.seen || isCorrected(view.marker)) {
    return false;
  }
  return pattern.sectors == 0 ? view.frame.size > leastTonedRing
                              : mayHaveToneCurve(fit, memory.pixels.size(), view.frame.size, settings.noise.sigma);
}

// Whether the light is to be fitted with a curvature; see mayBeToned(). Light that was told to be uneven has one.
bool mayBeInCurvedLight(const MarkerInImage &view, const FittedPose &fit)
{
  return view.frame.size > leastRadiusInCurvedLight && !view.uneven && !isCorrected(view.marker) &&
         !fit.photometry.shadow && !view.marker.seen && !fit.photometry.lightCurvature;
}

// Whether the mirrored pose of the best fit is another one that no fit has come to, or one in other light has. From
// where a small marker's coarse fit ends, a wrong pose may come to its minimum and the right one be stuck, come to the
// same, or be so far behind on its way that it is given up.
bool lacksTwin(const Few<FittedPose> &fits, bool isSmall)
{
  if (fits.size() > 1) {
    return !isSameLight(fits[0].photometry, fits[1].photometry) ||
           (isSmall && !fits[1].isSettled && fits[0].correlation >= leastCorrelationOfMarker);
  }
  if (fits.empty() || fits[0].correlation < leastCorrelationOfMarker) {
    return false;
  }
  FittedPose twin = fits[0];
  twin.plane = mirrored(twin.plane);
  return !isSamePose(fits[0], twin);
}

// Whether the mirrored pose of a large marker's best fit is so far behind, before any step from it, that it is not
// worth a fit, which would go all the way to the best: on paper that nearly faces the camera the likelihood has one
// maximum only.
bool isTwinHopeless(const RankedFits &ranked, const MarkerPattern &pattern, MeasureMemory &memory)
{
  FittedPose best = ranked.fits[0];
  FittedPose twin = best;
  twin.plane = mirrored(best.plane);
  twin.isSettled = false;
  twin.decrement = HUGE_VAL; // is not asked for: the most that isHopeless() allows
  // Of one fit there are the squares by its own noise, with what is held of gamma and ink: not those of another pose.
  for (FittedPose *fit : {&best, &twin}) {
    fit->squares = memory.fitter->robustSquares(memory.pixels, *fit, pattern, best.photometry, ranked.noise, true);
  }
  return isHopeless(twin, best, ranked.noise);
}

// All pixels around poses, as many as there are of them.
void chooseAllPixels(const MarkerInImage &view, const MarkerPlane *planes, std::size_t count,
                     const BlurParameters &blur, const FitSettings &settings, MarkerPattern &pattern,
                     MeasureMemory &memory)
{
  if (!settings.spinIsKnown) {
    PaperEnd &square = pattern.paper[static_cast<std::size_t>(PaperShape::SQUARE)];
    square.angle = squareAngleOf(view.I, view.camera, planes[0], square.extent, blur.sigma);
  }
  PixelChoice choice;
  choice.blur = blur;
  memory.fitter->selectPixels(view.I, view.camera, view.frame, planes, count, pattern, choice, memory.pixels);
  dropCovered(view.marker, memory.pixels);
  dropCutOff(view, memory.pixels);
  evenOut(view, memory.pixels);
}

// The fits on all pixels around the coarse ones; of both poses unless one is given up.
RankedFits fitAllPixels(const MarkerInImage &view, const RankedFits &coarse, bool isOneGivenUp, FitSettings settings,
                        MarkerPattern &pattern, MeasureMemory &memory)
{
  const Few<FittedPose> &fits = coarse.fits;
  const std::array<MarkerPlane, 2> planes = {fits.front().plane, fits.back().plane};
  chooseAllPixels(view, planes.data(), fits.size(), boundedBlur(fits[0].photometry.blur), settings, pattern, memory);
  Few<FitStart> starts;
  for (const FittedPose &fit : fits) {
    starts.push_back({fit.plane, fit.photometry, coarse.noise});
  }
  RankedFits ranked = rank(memory.pixels, pattern, true,
                           fitAll(memory.pixels, starts, pattern, settings, *memory.fitter), *memory.fitter);
  keepTwo(ranked);
  const bool isSmall = view.frame.size <= leastHopelessSize;
  // Of a clear marker the coarse fits have tried both poses, and if both led to one there is one.
  const bool isTried = isOneGivenUp || (settings.isClear && fits.size() == 1);
  for (int round = 0; round < mostTwins && !isTried && lacksTwin(ranked.fits, isSmall); ++round) {
    const FittedPose best = ranked.fits[0];
    if (!isSmall && ranked.fits.size() == 1 && isTwinHopeless(ranked, pattern, memory)) {
      break;
    }
    Few<FitStart> again;
    again.push_back({mirrored(best.plane), best.photometry, ranked.noise});
    settings.samePixels = true;
    const Few<FittedPose> others = fitAll(memory.pixels, again, pattern, settings, *memory.fitter,
                                          isSmall ? std::nullopt : std::make_optional(best));
    if (others.empty()) {
      break;
    }
    ranked.fits.push_back(others[0]);
    ranked = rank(memory.pixels, pattern, true, ranked.fits, *memory.fitter);
    keepTwo(ranked);
    if (isSamePose(best, ranked.fits[0])) { // its mirrored pose is that which was fitted
      break;
    }
  }
  return ranked;
}
} // namespace

RankedFits fitFinely(MarkerInImage &view, const RankedFits &coarse, bool isInDoubt, bool isOneGivenUp,
                     const FitSettings &settings, MarkerPattern &pattern, MeasureMemory &memory)
{
  const Recognition &marker = view.marker;
  RankedFits ranked = fitAllPixels(view, coarse, isInDoubt || isOneGivenUp, settings, pattern, memory);
  // The light by all pixels, once more: of four that were looked at the depth was off by a third to a half less then.
  if (view.uneven && !marker.measuredRing && !ranked.fits.empty() &&
      tellLight(view, pattern, ranked.fits[0], settings, memory)) {
    ranked = fitAllPixels(view, ranked, isOneGivenUp, settings, pattern, memory);
  }
  if (isInDoubt || ranked.fits.empty()) {
    return ranked;
  }
  const auto take = [&](const RankedFits &extended) { // unless what it says is no camera's any more
    const bool hasCode = pattern.sectors > 0;
    if (isExplained(extended.fits[0], view, hasCode, true) || !isExplained(ranked.fits[0], view, hasCode, true)) {
      ranked = extended;
    }
  };
  const auto askForBend = [&] {
    if (!mayBeInCurvedLight(view, ranked.fits[0]) || !isLightCurved(ranked.fits[0])) {
      return;
    }
    const RankedFits curved = fitCurvedLight(memory.pixels, ranked, pattern, settings, *memory.fitter);
    const FittedPose &best = curved.fits[0];
    if (keptOfNoise * unexplainedBy(best) <
        mostLeftByNoise(best, memory.pixels.size(), settings.noise.sigma, mostLeftInCurvedLight, chanceInCurvedLight)) {
      take(curved);
    }
  };
  askForBend();
  if (mayBeToned(view, ranked.fits[0], settings, pattern, memory)) {
    take(fitToneCurve(memory.pixels, ranked, pattern, settings, *memory.fitter));
    if (ranked.fits[0].photometry.toneCurve) { // what that leaves has hidden the light
      askForBend();
    }
  }
  if (pattern.sectors == 0) {
    return ranked;
  }
  if (marker.isCertain && mayBeTurned(ranked.fits[0])) {
    ranked = withBetterSpin(memory.pixels, ranked, pattern, settings, *memory.fitter);
  }
  if (!ranked.fits.empty() && ranked.fits[0].coherence > 1. && mayBend(marker, pattern)) {
    ranked = fitBent(memory.pixels, ranked, pattern, settings, *memory.fitter);
  }
  return ranked;
}

std::optional<FittedPose> fitOnce(const MarkerInImage &view, const FittedPose &around, const FittedPose &from,
                                  FitSettings settings, MarkerPattern &pattern, MeasureMemory &memory)
{
  chooseAllPixels(view, &around.plane, 1, boundedBlur(around.photometry.blur), settings, pattern, memory);
  settings.bend = from.plane.bend.isAny();
  return memory.fitter->fitPose(memory.pixels, {from.plane, from.photometry, from.noise}, pattern, settings);
}
} // namespace circle_marker
END_VISP_NAMESPACE
