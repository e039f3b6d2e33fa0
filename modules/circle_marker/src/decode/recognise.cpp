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
 * What marker an outline belongs to, before its pose is refined.
 */

#include "decode/recognise.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "decode/blurred_reading.h"
#include "decode/code_asymmetry.h"
#include "decode/covered_reading.h"
#include "decode/covered_shape.h"
#include "decode/edge_width.h"
#include "decode/radial_profile.h"
#include "decode/shape_evidence.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// The radial profile of a blurred thin ring keeps this share of the step across the outline.
constexpr double shareOfContrast = 0.3;
// A code is not read on a smaller semi-minor axis, pixels: of markers at a grazing angle this is where, even on white
// ground in little noise, more codes are left in doubt than read. Their outlines are found half a pixel too wide.
constexpr double leastCodeSemiMinor = 2.3;
// Nor where the track has fewer pixels than sectors: what is read then is made of the blur's model, not of the image.
constexpr double leastSectorPixels = 1.;
// The smallest plain ring that is promised to be found has a minor axis of 8 pixels, whose blurred outline shrinks by
// up to 0.3; smaller ones have too many look-alikes.
constexpr double leastRingSemiMinor = 3.7;
// Share of the outline that must be seen where no code proves the marker.
constexpr double leastSupport = 0.75;
// Of two families the one whose sectors leave less than this share of what the other's leave is the right one: of 43
// bch31 that were read as a golay23, too, they left a fourth at most (private counts; testDetectorScenes has some).
constexpr double clearlyLess = 0.5;
// A ring whose measured inner radius is this near to the family's own is taken for one of that family's ratio: by the
// steps of the profile, and by the blur of its inner edge in pixels, which matters on small rings.
constexpr double sameRatio = 0.03;
constexpr double sameRatioPixels = 0.8;

// Of a covered marker fewer pixels are left to read: its semi-minor axis, pixels, is twice as large at least.
constexpr double leastCoveredSemiMinor = 6.;
// And of a plain ring, which no code proves.
constexpr double leastCoveredShapeSemiMinor = 8.;

// Whether enough of the sectors are seen, black and white, that measuring the ring is worth while.
bool looksLikeCode(const SectorReading &reading)
{
  constexpr double leastShare = 0.25; // of the sectors: at the outline's pose not all that are seen are told
  constexpr double leastContrast = 0.4;
  constexpr double mostOffMiddle = 0.25;
  unsigned int seen = 0;
  for (unsigned int k = 0; k < reading.sectors; ++k) {
    seen += reading.seen[k] >= leastSeen ? 1 : 0;
  }
  return seen >= leastShare * reading.sectors && reading.contrast >= leastContrast &&
         std::abs(reading.middle - 0.5) <= mostOffMiddle;
}

// Share of the sectors that are seen which are of another colour than the one that is seen before them.
double shareOfChanges(const SectorReading &reading)
{
  unsigned int pairs = 0;
  unsigned int changes = 0;
  std::optional<bool> before;
  for (unsigned int k = 0; k < reading.sectors; ++k) {
    if (reading.seen[k] >= leastSeen) {
      const bool isBlack = reading.soft[k] > 0.;
      pairs += before ? 1 : 0;
      changes += before && *before != isBlack ? 1 : 0;
      before = isBlack;
    }
  }
  return pairs > 0 ? static_cast<double>(changes) / pairs : 0.;
}

// Margin from which the code that was read at one pose is not looked for at the other.
constexpr double clearMargin = 0.6;

// Whether the second of two readings came farther than the first.
bool isFarther(const Judged<CodeReading> &first, const Judged<CodeReading> &second)
{
  if (first && second) {
    return second->margin > first->margin;
  }
  return second || (!first && second.reason() > first.reason());
}

// The marker of two readings, the first of which, by its number, is the better one.
Recognition markerOf(const PosePair &poses, const vpCircleMarkerFamily &family,
                     const std::array<Judged<CodeReading>, 2> &codes, std::size_t best)
{
  const std::size_t other = 1 - best;
  Recognition result;
  result.family = family;
  result.code = *codes[best];
  result.poses = poses;
  result.poses[best].spin(codes[best]->spin);
  if (codes[other] && codes[other]->id == codes[best]->id) {
    result.poses[other].spin(codes[other]->spin);
  }
  else {
    copySpin(result.poses[best], result.poses[other]);
  }
  return result;
}

Judged<Recognition> recogniseCode(OutlineInImage &seen, const vpCircleMarkerFamily &family,
                                  const DecodeSettings &settings, ReadingTrace *trace)
{
  std::array<Judged<CodeReading>, 2> codes = {vpCircleMarkerReject::NO_SECTORS, vpCircleMarkerReject::NO_SECTORS};
  for (std::size_t i = 0; i < 2; ++i) {
    const Judged<SectorReading> &sectors = seen.sectorsAt(i, family);
    codes[i] = sectors ? identify(*sectors, family, settings) : Judged<CodeReading>(sectors.reason());
    if (codes[i] && codes[i]->hamming == 0 && codes[i]->margin >= clearMargin) {
      break; // the other pose could only be read as the same
    }
  }
  const std::size_t best = isFarther(codes[0], codes[1]) ? 1 : 0;
  if (trace != nullptr) {
    *trace = {seen.poses[best], seen.sectorsAt(best, family).seen(), codes[best].seen()};
  }
  if (!codes[best]) {
    return codes[best].reason();
  }
  // What is a marker in a mirror at one pose may have sectors misread at the other that make it another one.
  if (codes[best]->hamming > 0 && codes[1 - best].reason() == vpCircleMarkerReject::MIRRORED) {
    return vpCircleMarkerReject::MIRRORED;
  }
  return markerOf(seen.poses, family, codes, best);
}

// The darkness of the sectors as they were read, in the order of a code that starts at an angle of the plane.
std::array<float, mostSectors> darknessOf(const SectorReading &reading, double spin)
{
  const double rotation = (spin - reading.phase) * reading.sectors / (2. * M_PI);
  const auto first = static_cast<unsigned int>(std::lround(rotation) + 2 * static_cast<long>(reading.sectors));
  std::array<float, mostSectors> darkness{};
  for (unsigned int k = 0; k < reading.sectors; ++k) {
    const double soft = reading.soft[(first + k) % reading.sectors];
    darkness[k] = static_cast<float>(std::clamp(1. - reading.middle + 0.5 * reading.contrast * soft, 0., 1.));
  }
  return darkness;
}

// What was found through a blur, in the frame that the code fixes.
Recognition blurredMarkerOf(const BlurredReading &reading, const vpCircleMarkerFamily &family)
{
  Recognition result;
  result.family = family;
  result.code = reading.code;
  result.poses = {reading.fit.plane, reading.twin};
  result.blurred = reading.poses;
  const Eigen::Matrix3d back = Eigen::AngleAxisd(-reading.code.spin, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  for (std::size_t i = 0; i < result.poses.size(); ++i) {
    result.poses[i].spin(reading.code.spin);
    result.blurred->covariance[i] = turnedCovariance(reading.poses.covariance[i], back);
  }
  return result;
}

// A marker whose sectors are too blurred to be read one by one; nothing if it is none, or not certain.
std::optional<Recognition> recogniseBlurred(const OutlineInImage &seen, const vpCircleMarkerFamily &family,
                                            const DecodeSettings &settings, const Deadline &deadline)
{
  const auto reading = readBlurred(seen.I, seen.camera, seen.outline.ellipse, seen.poses[0].radius, family,
                                   settings.minimumMargin, deadline);
  return reading ? std::optional<Recognition>(blurredMarkerOf(*reading, family)) : std::nullopt;
}

// A plain ring through a blur: the same.
std::optional<Recognition> recogniseBlurredRing(const OutlineInImage &seen, const vpCircleMarkerFamily &family,
                                                const Deadline &deadline)
{
  const auto reading =
      fitBlurredRing(seen.I, seen.camera, seen.outline.ellipse, seen.poses[0].radius, family, deadline);
  return reading ? std::optional<Recognition>(blurredMarkerOf(*reading, family)) : std::nullopt;
}

// Why there is nothing at a pose that may be a plain ring or a disc of the family; NONE if there is. The first look
// misjudges the ratio of small and blurred rings: whether it is the family's, the fit tells.
vpCircleMarkerReject judgeShape(OutlineInImage &seen, std::size_t pose, const vpCircleMarkerFamily &family)
{
  const std::optional<RadialProfile> &profile = seen.profileAt(pose);
  if (!profile) {
    return vpCircleMarkerReject::OUT_OF_IMAGE;
  }
  const auto inner = innerRadius(*profile, family.getLayout().quietZone, shareOfContrast * seen.outline.contrast);
  if (!inner) {
    return vpCircleMarkerReject::NO_RING;
  }
  if ((*inner == 0.) != (family.getType() == vpCircleMarkerFamily::DISC)) {
    return vpCircleMarkerReject::OTHER_SHAPE;
  }
  const double nominal = family.getLayout().ringInner;
  const double slack = sameRatio + sameRatioPixels / seen.outline.ellipse.b;
  const double radius = std::abs(*inner - nominal) < slack ? nominal : *inner;
  if (!hasShapeAllAround(seen.I, seen.camera, seen.poses[pose], family.getLayout(), radius)) {
    return vpCircleMarkerReject::NOT_ALL_AROUND;
  }
  return vpCircleMarkerReject::NONE;
}

Judged<Recognition> recogniseShape(OutlineInImage &seen, const vpCircleMarkerFamily &family)
{
  const bool isRing = family.getType() == vpCircleMarkerFamily::RING;
  const bool isSmallRing = isRing && seen.outline.ellipse.b < leastRingSemiMinor;
  if (seen.outline.support < leastSupport) {
    return vpCircleMarkerReject::NOT_ALL_AROUND;
  }
  if (isSmallRing) {
    return vpCircleMarkerReject::TOO_SMALL;
  }
  // At the mirrored pose the inner circle of a large ring lies beside where it should be.
  vpCircleMarkerReject farthest = vpCircleMarkerReject::NONE;
  for (std::size_t pose = 0; pose < seen.poses.size(); ++pose) {
    const vpCircleMarkerReject reason = judgeShape(seen, pose, family);
    if (reason == vpCircleMarkerReject::NONE) {
      Recognition result;
      result.family = family;
      result.code.margin = 1.;
      result.poses = seen.poses;
      return result;
    }
    farthest = std::max(farthest, reason);
  }
  return farthest;
}

// What sectors of any grey leave of the track, at the pose at which they leave least, as a share of the ring's
// contrast.
double leastResidual(OutlineInImage &seen, const vpCircleMarkerFamily &family)
{
  double least = HUGE_VAL;
  for (std::size_t pose = 0; pose < seen.poses.size(); ++pose) {
    if (const Judged<SectorReading> &sectors = seen.sectorsAt(pose, family)) {
      least = std::min(least, sectors->residual);
    }
  }
  return least;
}
} // namespace

Judged<Recognition> recognise(OutlineInImage &seen, const vpCircleMarkerFamily &family, const DecodeSettings &settings,
                              ReadingTrace *trace, bool mayBeBlurred, const Deadline &deadline)
{
  const EllipseParameters &ellipse = seen.outline.ellipse;
  const vpCircleMarkerLayout &layout = family.getLayout();
  if (!family.isCoded()) {
    if (mayBeBlurred && family.getType() == vpCircleMarkerFamily::RING &&
        looksBlurred(seen.I, ellipse, false, layout.quietZone)) {
      if (auto blurred = recogniseBlurredRing(seen, family, deadline)) {
        return std::move(*blurred);
      }
    }
    return recogniseShape(seen, family);
  }
  const double trackPixels =
      M_PI * ellipse.a * ellipse.b * (layout.codeOuter * layout.codeOuter - layout.codeInner * layout.codeInner);
  if (ellipse.b < leastCodeSemiMinor || trackPixels < leastSectorPixels * family.getNbSectors()) {
    return vpCircleMarkerReject::TOO_SMALL;
  }
  if (mayBeBlurred && looksBlurred(seen.I, ellipse, true, layout.quietZone)) {
    if (auto blurred = recogniseBlurred(seen, family, settings, deadline)) {
      return std::move(*blurred);
    }
  }
  return recogniseCode(seen, family, settings, trace);
}

bool isRatherOf(OutlineInImage &seen, const vpCircleMarkerFamily &family, const vpCircleMarkerFamily &other,
                const DecodeSettings &settings)
{
  if (!family.isCoded() || !other.isCoded() || family.getNbSectors() == other.getNbSectors() ||
      !recogniseCode(seen, other, settings, nullptr)) {
    return false;
  }
  return leastResidual(seen, other) < clearlyLess * leastResidual(seen, family);
}

std::optional<Recognition> recogniseUncertain(OutlineInImage &seen, const vpCircleMarkerFamily &family, double noise)
{
  // What was found by its dark line has a dark ring.
  const bool isThin = seen.outline.isThin;
  if (!isAsymmetricAsCode(seen.I, seen.outline.ellipse, noise) ||
      (!isThin && !hasDarkRing(seen.I, seen.camera, seen.poses[0]))) {
    return std::nullopt;
  }
  std::array<Judged<CodeReading>, 2> codes = {vpCircleMarkerReject::NO_SECTORS, vpCircleMarkerReject::NO_SECTORS};
  for (std::size_t i = 0; i < 2; ++i) {
    const Judged<SectorReading> &sectors = seen.sectorsAt(i, family);
    const auto closest = sectors ? closestCode(*sectors, family, isThin) : std::nullopt;
    if (closest) {
      codes[i] = *closest;
    }
  }
  const std::size_t best = isFarther(codes[0], codes[1]) ? 1 : 0;
  if (!codes[best]) {
    return std::nullopt;
  }
  Recognition result = markerOf(seen.poses, family, codes, best);
  result.isCertain = false;
  result.darkness = darknessOf(*seen.sectorsAt(best, family), codes[best]->spin);
  return result;
}

std::optional<Recognition> recogniseCoveredRing(const vpImage<unsigned char> &I, const CameraModel &camera,
                                                const PosePair &poses, const EllipseCandidate &outline,
                                                const vpCircleMarkerFamily &family)
{
  if (!family.isCoded() || outline.ellipse.b < leastCoveredSemiMinor) {
    return std::nullopt;
  }
  // A plain ring has no black and white sectors: it is not worth the measuring.
  std::optional<SeenParts> most;
  double changes = 0.;
  for (const MarkerPlane &plane : poses) {
    auto reading = readCoveredSectors(I, camera, plane, family);
    if (reading && looksLikeCode(reading->sectors) && (!most || reading->seen.shareOfRing() > most->shareOfRing())) {
      most = reading->seen;
      most->track.reset();
      most->center.reset();
      changes = shareOfChanges(reading->sectors);
    }
  }
  if (!most) {
    return std::nullopt;
  }
  Recognition result;
  result.family = vpCircleMarkerFamily::ring(family.getLayout().ringInner);
  result.isRingOfCode = true;
  result.code.margin = changes;
  result.poses = poses;
  result.seen = most;
  return result;
}

std::optional<Recognition> recogniseCoveredShape(const OutlineInImage &seen, const vpCircleMarkerFamily &family)
{
  if (family.getType() != vpCircleMarkerFamily::RING || seen.outline.ellipse.b < leastCoveredShapeSemiMinor) {
    return std::nullopt;
  }
  std::optional<SeenParts> most;
  for (const MarkerPlane &plane : seen.poses) {
    const auto parts = seenPartsOfRing(seen.I, seen.camera, plane, family.getLayout());
    if (parts && (!most || parts->ring.count() > most->ring.count())) {
      most = parts;
    }
  }
  if (!most) {
    return std::nullopt;
  }
  Recognition result;
  result.family = family;
  result.code.margin = 1.;
  result.poses = seen.poses;
  result.seen = most;
  return result;
}

Judged<Recognition> recogniseCovered(const vpImage<unsigned char> &I, const CameraModel &camera,
                                     const MeasuredRing &ring, const std::optional<MeasuredRing> &twin,
                                     const vpCircleMarkerFamily &family, const DecodeSettings &settings,
                                     TrackMemory &memory, const Deadline &deadline)
{
  const std::array<const MeasuredRing *, 2> rings = {&ring, twin ? &*twin : &ring};

  std::array<Judged<CodeReading>, 2> codes = {vpCircleMarkerReject::NO_RING, vpCircleMarkerReject::NO_RING};
  std::array<std::optional<SeenParts>, 2> seen;
  for (std::size_t i = 0; i < (twin ? 2U : 1U); ++i) {
    if (deadline.hasPassed()) {
      return vpCircleMarkerReject::TIMEOUT;
    }
    auto reading = readCoveredSectors(I, camera, rings[i]->plane, family);
    if (!reading) {
      continue;
    }
    seen[i] = reading->seen;
    TrackPixels pixels(I, camera, *rings[i], family, memory);
    pixels.improve(reading->sectors);
    if (deadline.hasPassed()) { // to here, and to the end, takes some milliseconds each
      return vpCircleMarkerReject::TIMEOUT;
    }
    codes[i] = identifyCovered(reading->sectors, pixels, family, settings, *seen[i]);
  }
  const std::size_t best = isFarther(codes[0], codes[1]) ? 1 : 0;
  if (!codes[best]) {
    return codes[best].reason();
  }
  Recognition result = markerOf({rings[0]->plane, rings[1]->plane}, family, codes, best);
  result.seen = seen[best];
  result.measuredRing = *rings[best];
  return result;
}
} // namespace circle_marker
END_VISP_NAMESPACE
