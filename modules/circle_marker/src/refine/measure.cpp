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
#include <cmath>
#include <utility>

#include "refine/coarse_fits.h"
#include "refine/fine_fits.h"
#include "refine/fit_starts.h"
#include "refine/missed_light.h"
#include "refine/missed_shadow.h"
#include "refine/nearly_frontal.h"
#include "refine/other_pose.h"
#include "refine/plausible_print.h"
#include "refine/pose_odds.h"
#include "refine/shadow.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// How far the fits on all pixels may go from the coarse ones until their pixels are sorted anew, pixels.
constexpr double fineError = 0.6;
// Steps of a fit to a code that is not certain: with the right one seldom more are wanted, with a wrong one and on what
// is no marker they do not end.
constexpr int mostIterationsInDoubt = 12;
// Of a plain ring: ink spreads by some 0.1 mm, 0.003 radii of a small marker; and edges are known to a part of their
// blur, as it is hardly ever a Gaussian.
constexpr double mostSpreadOfRing = 0.01;
constexpr double mostOfBlur = 0.3;

// A small marker that leaves more than this factor of the noise, and this share of the contrast, is measured once more
// from where its fit has ended. (A golay23 of 27 pixels, 7 wide, ended where it left 1.8 times the noise; of 650 small
// ones three are looked at again; private.)
constexpr double muchMoreThanNoise = 1.3;
constexpr double muchLeft = 0.015;

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

// Where something covers a part of a marker its ring, which was measured before its code was read, stands for the
// coarse fits: few pixels, with some of the cover among them, led away from where it was, and made it look hopeless.
RankedFits fitsOfRing(const MarkerInImage &view)
{
  RankedFits ranked;
  for (const MarkerPlane &plane : view.marker.poses) {
    FittedPose fit;
    fit.plane = plane;
    fit.photometry = view.marker.measuredRing->photometryIn(view.frame);
    ranked.fits.push_back(fit);
  }
  ranked.noise = view.marker.measuredRing->noise;
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
  result.cost2 = result.cost + (result.cost2 - result.cost) / fits[0].resampled;
  forEachPose(result, [&](FittedPose &fit) {
    if (fit.leanInformation) {
      fit.covariance = nearlyFrontalCovariance(fit, result.second.has_value());
    }
  });
  return result;
}

// See measure(). view: the marker, and in the end the light that was found. mayBeLit: whether the light on it may turn
// out to be uneven.
std::optional<Measurement> measureInLight(MarkerInImage &view, MarkerPattern pattern, bool refine, bool mayBeLit,
                                          MeasureMemory &memory, const Deadline &deadline, const ImageNoise &noise)
{
  const Recognition &marker = view.marker;
  FitSettings settings = settingsFor(view, pattern, deadline);
  settings.noise = noise;
  RankedFits ranked =
      marker.measuredRing && refine ? fitsOfRing(view) : fitCoarsely(view, refine, settings, pattern, memory);
  if (refine && mayBeLit && mayBeInUnevenLight(view, pattern, ranked, memory.pixels, noise.sigma)) {
    ranked = withEvenLight(view, pattern, ranked, settings, memory);
  }
  const bool isInDoubt = refine && !marker.isCertain && pattern.sectors > 0;
  if (isInDoubt && !ranked.fits.empty() && !mayBePrint(ranked.fits[0], view, true)) {
    return std::nullopt;
  }
  const bool isCoveredRing = refine && marker.seen && !marker.hasCode();
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

MarkerPattern patternAsRead(const Recognition &marker)
{
  MarkerPattern pattern = patternOf(marker.family, marker.code.id);
  if (marker.darkness) {
    pattern.darkness = *marker.darkness;
  }
  return pattern;
}

// Whether a fit leaves much of the image. noise: its standard deviation, grey levels.
bool leavesMuch(const FittedPose &fit, double noise)
{
  return unexplainedBy(fit) > std::max(muchMoreThanNoise * noise, muchLeft * fit.photometry.tellableContrast());
}

// Takes another measurement if there is none, or it leaves less.
void keepBetter(std::optional<Measurement> other, std::optional<Measurement> &measurement)
{
  if (other && (!measurement || unexplainedBy(other->first) < unexplainedBy(measurement->first))) {
    measurement = std::move(other);
  }
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

std::optional<FittedPose> measureInOneLook(const vpImage<unsigned char> &I, const CameraModel &camera,
                                           const Recognition &marker, MeasureMemory &memory, const Deadline &deadline,
                                           const ImageNoise &noise)
{
  MarkerInImage view = {I, camera, frameOf(marker.poses[0], camera), marker, std::nullopt};
  const auto measurement = measureInLight(view, patternAsRead(marker), true, false, memory, deadline, noise);
  return measurement ? std::make_optional(measurement->first) : std::nullopt;
}

std::optional<FittedPose> measureNearby(const vpImage<unsigned char> &I, const CameraModel &camera,
                                        const Recognition &marker, const FittedPose &around, const FittedPose &from,
                                        MeasureMemory &memory, const Deadline &deadline, const ImageNoise &noise)
{
  const MarkerInImage view = {I, camera, frameOf(marker.poses[0], camera), marker, std::nullopt};
  MarkerPattern pattern = patternAsRead(marker);
  FitSettings settings = settingsFor(view, pattern, deadline);
  settings.noise = noise;
  return fitOnce(view, around, from, settings, pattern, memory);
}

std::optional<Measurement> measure(const vpImage<unsigned char> &I, const CameraModel &camera,
                                   const Recognition &marker, bool refine, MeasureMemory &memory,
                                   const Deadline &deadline, const ImageNoise &noise)
{
  const MarkerPattern pattern = patternAsRead(marker);
  const MarkerInImage asTold = {I, camera, frameOf(marker.poses[0], camera), marker,
                                marker.measuredRing ? marker.measuredRing->uneven : std::nullopt};
  MarkerInImage view = asTold;
  auto measurement = measureInLight(view, pattern, refine, true, memory, deadline, noise);
  // What a bad start leaves of a small marker may be taken for light, and so may what few pixels leave of a plain ring
  // by chance: of the accuracy report's 405 rings of 136 to 400 pixels two were off by that, by 5 and 9 times the bound
  // in depth. Even light is the simpler one. (Of larger codes what covers them is left: one that was evened before was
  // no code, and with this another one's.)
  const bool isSmall = asTold.frame.size <= leastHopelessSize;
  const bool mayBeEven = isSmall || !marker.hasCode();
  if (view.uneven && !asTold.uneven && mayBeEven && !deadline.hasPassed()) {
    MarkerInImage evenly = asTold;
    keepBetter(measureInLight(evenly, pattern, refine, false, memory, deadline, noise), measurement);
  }
  const bool isWhole = marker.isCertain && !marker.seen;
  if (measurement && refine && isSmall && isWhole && leavesMuch(measurement->first, noise.sigma) &&
      !deadline.hasPassed()) {
    Recognition there = marker;
    there.poses[0] = measurement->first.plane.flattened();
    there.poses[1] = mirrored(there.poses[0]);
    MarkerInImage again = {I, camera, asTold.frame, there, asTold.uneven};
    keepBetter(measureInLight(again, pattern, refine, false, memory, deadline, noise), measurement);
  }
  return measurement;
}
} // namespace circle_marker
END_VISP_NAMESPACE
