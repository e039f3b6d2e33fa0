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
 * Both poses of a recognised marker, refined and weighed against each other.
 */

#include "refine/measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "refine/bent_sheet.h"
#include "refine/coarse_fits.h"
#include "refine/fit_starts.h"
#include "refine/missed_light.h"
#include "refine/missed_shadow.h"
#include "refine/nearly_frontal.h"
#include "refine/plausible_print.h"
#include "refine/pose_odds.h"
#include "refine/shadow.h"
#include "refine/spin_search.h"
#include "refine/surround.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// All pixels are used up to a marker of some 500 pixels diameter: every pixel that is left out is information lost.
constexpr double manyPixels = 20000.;
// How far the fits on all pixels may go from the coarse ones until their pixels are sorted anew, pixels.
constexpr double fineError = 0.6;
// How far the coarse fits are off, pixels. (With 0.1, which nearly all clear ones are nearer than, a covered code was
// read as another: testDetectorWrongIds.)
constexpr double coarseError = 0.3;
// Steps of a fit to a code that is not certain: with the right one seldom more are wanted, with a wrong one and on what
// is no marker they do not end.
constexpr int mostIterationsInDoubt = 12;
// Of a plain ring: ink spreads by some 0.1 mm, 0.003 radii of a small marker; and edges are known to a part of their
// blur, as it is hardly ever a Gaussian.
constexpr double mostSpreadOfRing = 0.01;
constexpr double mostOfBlur = 0.3;
// Of a bent sheet's ring this share is seen at least: the quiet zone of one at the image's border is not all in it, and
// such a marker is read as one of which a part is covered.
constexpr double leastSeenOfBent = 0.75;
// Of markers below this radius, pixels, both poses are refined: all pixels cost little more than the few, and a coarse
// fit that was stuck made the right pose of some markers of 16 pixels hopeless.
constexpr double leastHopelessSize = 20.;
// Fits from the mirrored pose of the best, at most: the first may become the best, and its own mirrored pose is stuck.
constexpr int mostTwins = 2;

// Whether the sheet may be bent, as far as the fit can tell: where too much is covered a bend explains what covers it.
bool mayBend(const Recognition &marker, const MarkerPattern &pattern)
{
  const bool isMostlySeen = !marker.seen || marker.seen->shareOfRing() > leastSeenOfBent;
  return isMostlySeen && !marker.darkness && pattern.sectors > 0;
}

// The coarse fits.
RankedFits fitCoarsely(const MarkerInImage &view, bool refine, FitSettings &settings, MarkerPattern &pattern,
                       MeasureMemory &memory)
{
  const Recognition &marker = view.marker;
  RankedFits coarse = fitFewPixels(view, pattern, refine, settings, memory.pixels, *memory.fitter);
  if (refine && mayHaveShadow(marker, pattern, coarse)) {
    coarse = withMissedShadow(view, pattern, coarse, settings, memory);
  }
  return coarse;
}

// The light that a measured ring tells, in the coordinates of a frame. That of a covered one has no shadow.
Photometry lightOf(const MeasuredRing &ring, const ImageFrame &frame)
{
  const Photometry &told = ring.photometry;
  const Eigen::Vector2d slope = told.lightGradient / ring.frame.size; // by the pixel
  Photometry photometry;                                              // of what lies around it nothing is known
  photometry.white = ring.whiteAt(frame.center);
  photometry.lightGradient =
      frame.size * slope / std::max(1. + slope.dot(frame.center - ring.frame.center), leastLight);
  photometry.absorption = told.absorption;
  photometry.gamma = told.gamma;
  photometry.blur = told.blur;
  return photometry;
}

// Where something covers a part of a marker its ring, which was measured before its code was read, stands for the
// coarse fits: few pixels, with some of the cover among them, led away from where it was, and made it look hopeless.
RankedFits fitsOfRing(const MarkerInImage &view)
{
  RankedFits ranked;
  for (const MarkerPlane &plane : view.marker.poses) {
    FittedPose fit;
    fit.plane = plane;
    fit.photometry = lightOf(*view.marker.measuredRing, view.frame);
    ranked.fits.push_back(fit);
  }
  ranked.noise = view.marker.measuredRing->noise;
  return ranked;
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
  const FittedPose &best = ranked.fits[0];
  FittedPose twin = best;
  twin.plane = mirrored(best.plane);
  twin.isSettled = false;
  twin.decrement = HUGE_VAL; // is not asked for: the most that isHopeless() allows
  twin.squares = memory.fitter->robustSquares(memory.pixels, twin, pattern, best.photometry, ranked.noise, true);
  return isHopeless(twin, best, ranked.noise);
}

// The fits on all pixels around the coarse ones; of both poses unless one is given up.
RankedFits fitAllPixels(const MarkerInImage &view, const RankedFits &coarse, bool isOneGivenUp, FitSettings settings,
                        MarkerPattern &pattern, MeasureMemory &memory)
{
  const Few<FittedPose> &fits = coarse.fits;
  const std::array<MarkerPlane, 2> planes = {fits.front().plane, fits.back().plane};
  const BlurParameters blur = boundedBlur(fits[0].photometry.blur);
  if (!settings.spinIsKnown) {
    PaperEnd &square = pattern.paper[static_cast<std::size_t>(PaperShape::SQUARE)];
    square.angle = squareAngleOf(view.I, view.camera, planes[0], square.extent, blur.sigma);
  }
  const PixelChoice choice = {blur, coarseError, manyPixels};
  memory.fitter->selectPixels(view.I, view.camera, view.frame, planes.data(), fits.size(), pattern, choice,
                              memory.pixels);
  dropCovered(view.marker, memory.pixels);
  evenOut(view, memory.pixels);
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

FitSettings settingsFor(const MarkerInImage &view, const MarkerPattern &pattern, const Deadline &deadline)
{
  const Recognition &marker = view.marker;
  FitSettings settings;
  settings.spinIsKnown = pattern.sectors > 0;
  settings.poseError = fineError;
  settings.deadline = deadline;
  if (!marker.isCertain) {
    settings.mostIterations = mostIterationsInDoubt;
  }
  settings.gammaAndSpread = pattern.ringEdges > 1; // the size of a lone disc cannot be told from them
  settings.isClear = marker.isCertain && !marker.seen && view.frame.size > leastHopelessSize;
  if (!marker.seen) { // what covers a marker looks like the edge of a shadow
    settings.shadow = shadowOn(view.I, view.camera, view.frame, marker.poses[0], marker.family.getLayout().quietZone);
  }
  return settings;
}

// A second pose that is not refined.
struct GivenUp
{
  FittedPose fit;
  double moreCost = 0.; // than that of the first
};

// Takes the second coarse fit out if few pixels say enough against it: all of them would say more.
std::optional<GivenUp> giveUpHopeless(const MarkerInImage &view, RankedFits &coarse)
{
  Few<FittedPose> &fits = coarse.fits;
  if (fits.size() < 2 || view.frame.size <= leastHopelessSize || !isHopeless(fits[1], fits[0], coarse.noise)) {
    return std::nullopt;
  }
  const GivenUp givenUp = {fits[1], costOf(fits[1].squares - fits[0].squares, coarse.noise, fits[0].sharing)};
  fits.pop_back();
  return givenUp;
}

// Takes all but the best coarse fit of a code in doubt out: it is proven at the better pose, and only then is the other
// one worth a fit.
void leaveBest(RankedFits &coarse)
{
  while (coarse.fits.size() > 1) {
    coarse.fits.pop_back();
  }
}

// The fits on all pixels, and what only these tell: the light, the spin and the sheet's bend.
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
  if (isInDoubt || ranked.fits.empty() || pattern.sectors == 0) {
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

// Whether it has a code, which may not be read yet.
bool hasCode(const Recognition &marker)
{
  return marker.family.isCoded() || marker.isRingOfCode;
}

// Whether a pose was given up so far from its end that by the equations there nothing may be left between it and the
// best. Of a ring that nearly faces the camera they mean little: halfway between its two poses one of 52 pixels, a
// tenth of which was covered, had 1027 before it and was 773 behind, with odds of e^75 against the right one.
bool isFarFromEnd(const FittedPose &other, const FittedPose &best)
{
  return !other.isSettled && other.decrement > 0.5 * (other.squares - best.squares);
}

// Whether the other pose of a marker was given up on its way though something is left that the model lacks, or was far
// from its end: how far it would have come is not known then, and the odds are not. (Of a ring of 250 pixels whose
// edges were sharper than a lens makes them they were e^0.1, and in other noise e^700.)
bool isGivenUpEarly(const MarkerInImage &view, const FittedPose *other, const FittedPose &best)
{
  if (!other || other->isSettled || view.frame.size <= leastHopelessSize) {
    return false;
  }
  return best.coherence > 1. || (!hasCode(view.marker) && isFarFromEnd(*other, best));
}

// Compares the poses once more, if the other one was given up early, and always of a plain ring that something covers:
// an outline of which a part is missing has poses from which the fit may lead anywhere. (Behind a blob over two fifths
// the other one of a ring of 48 pixels was 0.4 m nearer, and the mirrored one came first with odds of e^187.) Few
// pixels tell it; all pixels, if it is not hopeless there. Whether that has led to a better pose, which may have
// another mirrored one.
bool compareAtTheirEnds(MarkerInImage &view, RankedFits &ranked, std::optional<GivenUp> &givenUp,
                        const FitSettings &settings, MarkerPattern &pattern, MeasureMemory &memory)
{
  const FittedPose best = ranked.fits[0];
  FittedPose *other = givenUp ? &givenUp->fit : ranked.fits.size() > 1 ? &ranked.fits[1] : nullptr;
  // What covers a code is lacking at any pose: one was read as another by this.
  const bool isAsked = view.marker.seen ? !hasCode(view.marker) : isGivenUpEarly(view, other, best);
  if (!isAsked) {
    return false;
  }
  RankedFits few =
      fitToTheirEnds(view, pattern, best, mirrored(best.plane), settings, memory.fewPixels, *memory.fitter);
  if (few.fits.size() < 2) {
    // Whether from the mirrored pose, too, one comes to the best: then the other is no end, and what it leaves counts
    // as it is; that of a covered ring, which may be anything, is none.
    const bool isAlone = !few.fits.empty() && isSamePose(few.fits[0], best);
    if (isAlone && view.marker.seen) {
      leaveBest(ranked);
      givenUp.reset();
    }
    else if (other) {
      other->isSettled = isAlone;
    }
    return false;
  }
  givenUp = giveUpHopeless(view, few);
  if (givenUp && isSamePose(few.fits[0], best)) {
    if (!givenUp->fit.isSettled) { // after so many steps: as much may be left of the way as isHopeless() allows
      const double ahead = costOf(givenUp->fit.decrement, few.noise, few.fits[0].sharing);
      givenUp->moreCost -= std::min(ahead, 0.5 * givenUp->moreCost);
      givenUp->fit.isSettled = true;
    }
    leaveBest(ranked);
  }
  else {
    ranked = fitFinely(view, few, false, givenUp.has_value(), settings, pattern, memory);
  }
  return !ranked.fits.empty() && !isSamePose(ranked.fits[0], best);
}

Measurement measurementOf(const RankedFits &ranked, const std::optional<GivenUp> &givenUp)
{
  const Few<FittedPose> &fits = ranked.fits;
  Measurement result;
  result.first = fits[0];
  result.cost = costOf(fits[0].squares, ranked.noise, fits[0].sharing);
  if (fits.size() > 1 && !isSamePose(fits[0], fits[1])) {
    result.second = fits[1];
    const double odds = costOf(fits[1].squares - fits[0].squares, ranked.noise, fits[0].sharing);
    result.cost2 = result.cost + coherentOdds(odds, fits[0], fits[1], ranked.noise);
  }
  else if (givenUp) {
    result.second = givenUp->fit;
    result.cost2 = result.cost + coherentOdds(givenUp->moreCost, fits[0], givenUp->fit, ranked.noise);
  }
  forEachPose(result, [&](FittedPose &fit) {
    if (fit.leanInformation) {
      fit.covariance = nearlyFrontalCovariance(fit, result.second.has_value());
    }
  });
  return result;
}
} // namespace

ImageFrame frameOf(const MarkerPlane &plane, const CameraModel &camera)
{
  return {camera.toPixel(plane.project(Eigen::Vector2d::Zero())),
          plane.radius / (plane.center.z() * meterPerPixelAt(plane, camera))};
}

bool isOtherRing(const Recognition &marker, const FittedPose &fit, const CameraModel &camera)
{
  const BlurParameters &blur = fit.photometry.blur;
  const double most = std::max(mostSpreadOfRing, mostOfBlur * blur.widest() / frameOf(fit.plane, camera).size);
  return !marker.family.isCoded() && std::abs(blur.spread) > most;
}

std::optional<Measurement> measure(const vpImage<unsigned char> &I, const CameraModel &camera,
                                   const Recognition &marker, bool refine, MeasureMemory &memory,
                                   const Deadline &deadline, const ImageNoise &noise)
{
  MarkerPattern pattern = patternOf(marker.family, marker.code.id);
  if (marker.darkness) {
    pattern.darkness = *marker.darkness;
  }
  MarkerInImage view = {I, camera, frameOf(marker.poses[0], camera), marker,
                        marker.measuredRing ? marker.measuredRing->uneven : std::nullopt};
  FitSettings settings = settingsFor(view, pattern, deadline);
  settings.noise = noise;
  RankedFits ranked =
      marker.measuredRing && refine ? fitsOfRing(view) : fitCoarsely(view, refine, settings, pattern, memory);
  if (refine && mayBeInUnevenLight(view, pattern, ranked, memory.pixels, noise.sigma)) {
    ranked = withEvenLight(view, pattern, ranked, settings, memory);
  }
  const bool isInDoubt = refine && !marker.isCertain && pattern.sectors > 0;
  if (isInDoubt && !ranked.fits.empty() && !mayBePrint(ranked.fits[0], view, true)) {
    return std::nullopt;
  }
  const bool isCoveredRing = refine && marker.seen && !hasCode(marker);
  if (isCoveredRing && !ranked.fits.empty() && !isRingWhereSeen(ranked.fits[0], view, noise.sigma, true)) {
    return std::nullopt;
  }
  std::optional<GivenUp> givenUp;
  if (refine && !ranked.fits.empty()) {
    if (isInDoubt) {
      leaveBest(ranked);
    }
    else {
      givenUp = giveUpHopeless(view, ranked);
    }
    ranked = fitFinely(view, ranked, isInDoubt, givenUp.has_value(), settings, pattern, memory);
    const bool isComparable = !isInDoubt && !ranked.fits.empty();
    if (isComparable && compareAtTheirEnds(view, ranked, givenUp, settings, pattern, memory) && isCoveredRing) {
      compareAtTheirEnds(view, ranked, givenUp, settings, pattern, memory);
    }
  }
  if (isInDoubt && !ranked.fits.empty() && !mayBePrint(ranked.fits[0], view, false)) {
    return std::nullopt;
  }
  // The fit that was stopped may be that of the better pose.
  if (ranked.fits.empty() || deadline.hasPassed() || !isExplained(ranked.fits[0], view, pattern.sectors > 0, refine)) {
    return std::nullopt;
  }
  if (isCoveredRing && !isRingWhereSeen(ranked.fits[0], view, noise.sigma, false)) {
    return std::nullopt;
  }
  Measurement result = measurementOf(ranked, givenUp);
  result.uneven = view.uneven;
  if (!refine && result.second) {
    result.cost2 = result.cost + unrefinedOdds(result.cost2 - result.cost, result.first, ranked.noise);
  }
  return result;
}
} // namespace circle_marker
END_VISP_NAMESPACE
