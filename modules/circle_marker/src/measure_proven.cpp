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
 * Measures a marker and reads its code again where it is.
 */

#include "measure_proven.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "decode/cyclic_code.h"
#include "refine/code_likelihood.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Sectors that are longer than this at the track's middle, along the image's shorter axis, pixels, are read one by one
// without doubt: the blur leaves their middle alone.
constexpr double longSector = 1.6;
// Those shorter than this are often not read for certain.
constexpr double shortSector = 1.4;
// With a code that is not certain the ring alone must fit by this correlation, as it was found and when it is measured,
// or no code will do.
constexpr double leastCorrelationAtStart = 0.7;
constexpr double leastCorrelationMeasured = 0.9;
// Least odds against the next codeword, ln: one in 10^6 is wrong, if the pose is right. Which it need not be where the
// code was not read for certain: codes are compared at the pose that the likeliest has made of the image.
constexpr double leastOdds = 14.;
constexpr double leastOddsIfUncertain = 25.;
// And where the noise is more than this share of the contrast: there a wrong pose, too, leaves no more than the noise,
// and the odds are all that speaks for a code. That is so of codes with fewer check bits than this: of all words one in
// 2^11 is of golay23, but one in 2^15 of bch31. In 150000 golay23 of 8 to 22 pixels in any light, half of which were
// found, five that were read as others had odds of e^26 to e^32; in 36000 bch31 none was.
constexpr double leastOddsInNoise = 33.;
constexpr double muchNoise = 0.015;
constexpr unsigned int fewChecks = 14;
// Residuals of the best codeword, in units of what noise and model leave. Beyond the other odds, ln, they may be more:
// of a track that is less than a pixel wide the model misses some hundredths of its contrast. And if the same code was
// read sector by sector, more again: the phases that are tried are then the coarsest of what is seen. (Right ones leave
// up to 1.2; one that was read as another, near the edge of its sheet, left 2.9.)
constexpr double mostUnexplained = 1.2;
constexpr double clearOdds = 40.;
constexpr double mostUnexplainedIfClear = 1.6;
constexpr double mostUnexplainedIfRead = 2.;
// At a wrong pose, too, one codeword is the best, by up to e^64; but it does not leave the image's noise alone. Of a
// right one no more is left than this factor, and this share of the contrast for what the model lacks: the higher its
// odds, ln, the more. (A golay23 of 9 pixels in a blur of 1.2 was read as another, with odds of e^35, where 1.4 times
// the noise was left.)
struct MostLeft
{
  double odds;    // up to these
  double noise;   // factor
  double lacking; // share of the contrast
};
constexpr std::array<MostLeft, 3> mostLeftByOdds = {{{25., 1.1, 0.003}, {60., 1.2, 0.003}, {150., 1.5, 0.005}}};
// A code that was not read for certain and whose odds are not clear must not leave more than so many standard
// deviations of what noise leaves: of n pixels its root mean square is known to 1 / sqrt(2 n). In 18000 markers of 8 to
// 24 pixels two that were read as others had odds of e^27 and e^32 and left 4.4 more; of the right ones with such odds
// one in a hundred leaves 3.5 more.
constexpr double mostDeviations = 3.5;
constexpr double rounding = 0.29; // noise of an image without any, grey levels
// What is no marker, letters, rings of dots, a castle's window, may be near a codeword, but it is not what is printed:
// it leaves 4 % of its contrast and more besides noise, and correlates by less than 0.98. True markers do by that in
// noise of a twelfth of the contrast; then no more than the noise is left, to this factor, and the odds are clear.
constexpr double mostUnlike = 0.03;
constexpr double mostNoise = 1.3;
constexpr double mostNoiseIfFaint = 1.1;
// Where the sectors were read one by one without doubt, it may be more, in pictures that were compressed or moved;
// lettering that was read as a code left twice this share of its contrast.
constexpr double mostUnlikeIfCertain = 0.1;
constexpr double leastCorrelation = 0.97;
// Below clear odds the next likely code is measured, too, and has to leave more of the image by this factor. Right ones
// left 0.82 and 0.87 times what the wrong one did, wrong ones mostly 1.2 times what the right one did and more.
constexpr double clearlyMore = 1.02;
// How often another code is measured: the first was read at a pose that the code did not yet help to measure.
constexpr int mostRounds = 3;

// At the track's middle, along the image's shorter axis, pixels.
double sectorLength(const EllipseParameters &outline, const vpCircleMarkerFamily &family)
{
  const vpCircleMarkerLayout &layout = family.getLayout();
  return M_PI * (layout.codeInner + layout.codeOuter) * outline.b / family.getNbSectors();
}

// Whether a fit leaves no more of the image than one of a print does: noise, and a share of the contrast. No sensor
// tells more than white, nor ink darker than black: a fit of what is no marker may find its contrast there, but that is
// not what is left to be explained.
bool leavesWhatPrintsLeave(const FittedPose &fit, double noise, double share)
{
  constexpr double white = 255.;
  const double paper = std::min(fit.photometry.light, white);
  const double ink = std::max(fit.photometry.light * (1. - fit.photometry.contrast()), 0.);
  return fit.photometry.contrast() < 1. + share &&
         fit.noise < mostNoise * std::max(noise, rounding) + share * (paper - ink);
}

// Whether a fit on so many pixels leaves no more than one at the right pose, where a code has such odds.
bool isAtRightPose(const FittedPose &fit, double noise, double odds, bool isCertain, std::size_t pixels)
{
  const double contrast = fit.photometry.light * fit.photometry.contrast();
  for (const MostLeft &most : mostLeftByOdds) {
    if (odds < most.odds) {
      const bool isDoubted = !isCertain && odds < clearOdds;
      const double byChance = 1. + mostDeviations / std::sqrt(2. * static_cast<double>(pixels));
      const double factor = isDoubted ? std::min(most.noise, byChance) : most.noise;
      return fit.noise < factor * std::max(noise, rounding) + most.lacking * contrast;
    }
  }
  return true;
}

// Odds that a code needs against the next one, ln.
double leastOddsOf(const vpCircleMarkerFamily &family, const FittedPose &fit, double noise, bool isCertain)
{
  const CyclicCode &code = codeOf(family);
  const bool isDense = code.getLength() - code.getDimension() < fewChecks;
  const bool isNoisy = noise > muchNoise * fit.photometry.light * fit.photometry.contrast();
  return isCertain ? leastOdds : isDense && isNoisy ? leastOddsInNoise : leastOddsIfUncertain;
}

// Whether a marker's likeliest code is beyond doubt, measured on so many pixels.
bool isProven(const LikelyCode &code, const vpCircleMarkerFamily &family, const FittedPose &fit, double noise,
              bool isCertain, std::size_t pixels)
{
  const double mostLeft = code.odds < clearOdds ? mostUnexplained
                          : isCertain           ? mostUnexplainedIfRead
                                                : mostUnexplainedIfClear;
  const bool isLikely = code.odds > leastOddsOf(family, fit, noise, isCertain) && code.unexplained < mostLeft;
  const bool isRightPose = isAtRightPose(fit, noise, code.odds, isCertain, pixels);
  const bool isFaint = code.odds > clearOdds && fit.noise < mostNoiseIfFaint * noise;
  const bool isAlike = fit.correlation > leastCorrelation || isFaint;
  const bool isPrint = isCertain ? leavesWhatPrintsLeave(fit, noise, mostUnlikeIfCertain)
                                 : leavesWhatPrintsLeave(fit, noise, mostUnlike) && isAlike;
  return isLikely && isRightPose && isPrint;
}

// Sets another code, at the measured poses.
void setCode(const PlacedCode &code, const Measurement &measurement, Recognition &marker)
{
  marker.code.id = code.id;
  marker.code.spin = code.spin;
  marker.code.hamming = 0; // no sector was read one by one, so none was corrected
  marker.poses[0] = measurement.first.plane;
  if (measurement.second) {
    marker.poses[1] = measurement.second->plane;
  }
  for (MarkerPlane &pose : marker.poses) {
    pose.bend = SheetBend();
    pose.spin(code.spin);
  }
}

// The marker with the next likely code, if that, measured on its own, explains the image as well: the poses to which
// codes are compared are those that the likeliest has made of the image.
std::optional<Recognition> challenger(const vpImage<unsigned char> &I, const CameraModel &camera,
                                      const LikelyCode &code, const Measurement &measurement, Recognition marker,
                                      MeasureMemory &memory)
{
  if (code.next.id < 0) {
    return std::nullopt;
  }
  setCode(code.next, measurement, marker);
  const auto other = measure(I, camera, marker, true, memory);
  const bool isAsGood = other && other->first.noise < clearlyMore * measurement.first.noise;
  return isAsGood ? std::make_optional(std::move(marker)) : std::nullopt;
}
} // namespace

bool wantsProof(const EllipseParameters &outline, const vpCircleMarkerFamily &family)
{
  return family.isCoded() && sectorLength(outline, family) < longSector;
}

bool mayBeUncertain(const EllipseParameters &outline, const vpCircleMarkerFamily &family)
{
  return family.isCoded() && sectorLength(outline, family) < shortSector;
}

std::optional<Measurement> measureProven(const vpImage<unsigned char> &I, const CameraModel &camera, double noise,
                                         Recognition &marker, MeasureMemory &memory, const Deadline &deadline)
{
  if (!marker.isCertain) {
    const auto start = measure(I, camera, marker, false, memory);
    if (!start || start->first.correlation < leastCorrelationAtStart) {
      return std::nullopt;
    }
  }
  for (int round = 0; round < mostRounds; ++round) {
    const ImageFrame frame = frameOf(marker.poses[0], camera);
    auto measurement = measure(I, camera, marker, true, memory);
    if (!measurement || deadline.hasPassed()) {
      return std::nullopt;
    }
    if (!marker.isCertain && measurement->first.correlation < leastCorrelationMeasured) {
      return std::nullopt;
    }
    const auto code = mostLikelyCode(I, camera, measurement->first, frame, marker.family, memory.code, deadline);
    if (deadline.hasPassed()) {
      return std::nullopt;
    }
    if (!code) { // the first reading decides, if what was read is there at all
      const bool isThere = marker.isCertain && leavesWhatPrintsLeave(measurement->first, noise, mostUnlike);
      return isThere ? measurement : std::nullopt;
    }
    if (code->best.id < 0) {
      return std::nullopt;
    }
    const bool isSame =
        code->best.id == marker.code.id && std::abs(code->best.spin) < M_PI / marker.family.getNbSectors();
    if (isSame) {
      if (!isProven(*code, marker.family, measurement->first, noise, marker.isCertain, memory.pixels.size())) {
        return std::nullopt;
      }
      if (marker.isCertain || code->odds > clearOdds) {
        return measurement;
      }
      auto other = challenger(I, camera, *code, *measurement, marker, memory);
      if (deadline.hasPassed()) {
        return std::nullopt;
      }
      if (!other) {
        return measurement;
      }
      marker = std::move(*other);
      continue;
    }
    setCode(code->best, *measurement, marker);
    marker.isCertain = false;
  }
  return std::nullopt;
}
} // namespace circle_marker
END_VISP_NAMESPACE
