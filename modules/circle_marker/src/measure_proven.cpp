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
#include <cmath>

#include "code_proof.h"
#include "refine/fit_starts.h"
#include "refine/over_exposed_code.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Sectors that are longer than this at the track's middle, along the image's shorter axis, pixels, need no proof if
// they were read for certain one by one: the blur leaves their middle alone.
constexpr double clearSector = 1.6;
// Those shorter than this are often not read for certain: in a blur of 1.2 pixels a twenty-fifth is left of the
// contrast of sectors of 1.5 pixels that are black and white in turn, which is noise in many pictures. (Of longer ones
// no more markers came: 3.9 pixels in noise of 20 were tried.)
constexpr double doubtfulSector = 1.9;
// With a code that is not certain the ring alone must fit by this correlation, as it was found and when it is measured,
// or no code will do.
constexpr double leastCorrelationAtStart = 0.7;
constexpr double leastCorrelationMeasured = 0.9;
// Below clear odds the next likely code is measured, too, and has to leave more of the image by this factor. Right ones
// left 0.82 and 0.87 times what the wrong one did, wrong ones mostly 1.2 times what the right one did and more.
constexpr double clearlyMore = 1.02;
// Whatever its odds, a code leaves no more than this factor of what another one left that was measured before: one
// whose track something covers was refused, and another one proven that left 1.4 times as much.
constexpr double muchMore = 1.2;
// Odds of a code on over-exposed paper, ln: one in 10^8 is wrong, as elsewhere.
constexpr double leastOddsIfOverExposed = 20.;
// How often another code is measured: the first was read at a pose that the code did not yet help to measure.
constexpr int mostRounds = 3;

// At the track's middle, along the image's shorter axis, pixels. b: half of that axis.
double sectorLength(double b, const vpCircleMarkerFamily &family)
{
  const vpCircleMarkerLayout &layout = family.getLayout();
  return M_PI * (layout.codeInner + layout.codeOuter) * b / family.getNbSectors();
}

double sectorLength(const MarkerPlane &plane, const CameraModel &camera, const vpCircleMarkerFamily &family)
{
  return sectorLength(plane.foreshortening() * frameOf(plane, camera).size, family);
}

// Sets the measured poses, as a start.
void startAt(const Measurement &measurement, Recognition &marker)
{
  marker.poses[0] = measurement.first.plane.flattened();
  marker.poses[1] = measurement.second ? measurement.second->plane.flattened() : mirrored(marker.poses[0]);
}

// Sets another code, at the measured poses.
void setCode(const PlacedCode &code, const Measurement &measurement, Recognition &marker)
{
  marker.code.id = code.id;
  marker.code.spin = code.spin;
  marker.code.hamming = 0; // no sector was read one by one, so none was corrected
  marker.isCertain = false;
  startAt(measurement, marker);
  for (MarkerPlane &pose : marker.poses) {
    pose.spin(code.spin);
  }
}

// frame: of the light in the measurement.
MeasuredView viewOf(const vpImage<unsigned char> &I, const CameraModel &camera, const Measurement &measurement,
                    const ImageFrame &frame)
{
  return {I, camera, measurement.first, frame, measurement.uneven ? &*measurement.uneven : nullptr};
}

// The image that a marker is measured in, and what it is measured with.
struct Measuring
{
  const vpImage<unsigned char> &I;
  const CameraModel &camera;
  const ImageNoise &noise;
  MeasureMemory &memory;
  const Deadline &deadline;

  std::optional<Measurement> measure(const Recognition &marker, bool refine = true) const
  {
    return circle_marker::measure(I, camera, marker, refine, memory, deadline, noise);
  }

  // frame: of the light in the measurement.
  std::optional<LikelyCode> mostLikelyCode(const Measurement &measurement, const ImageFrame &frame,
                                           const vpCircleMarkerFamily &family) const
  {
    return circle_marker::mostLikelyCode(viewOf(I, camera, measurement, frame), family, memory.code, deadline);
  }
};

// The marker with the next likely code, if that, measured on its own, explains the image as well: the poses to which
// codes are compared are those that the likeliest has made of the image.
std::optional<Recognition> challenger(const Measuring &measuring, const LikelyCode &code,
                                      const Measurement &measurement, Recognition marker)
{
  if (code.next.id < 0) {
    return std::nullopt;
  }
  setCode(code.next, measurement, marker);
  const auto other = measuring.measure(marker);
  const bool isAsGood = other && other->first.noise < clearlyMore * measurement.first.noise;
  return isAsGood ? std::make_optional(std::move(marker)) : std::nullopt;
}

// Whether the image looks like the marker where that was found.
bool isLikeAtStart(const Measuring &measuring, const Recognition &marker)
{
  const auto start = measuring.measure(marker, false);
  return start && start->first.correlation >= leastCorrelationAtStart;
}

// Another code for a marker whose own was not proven. A wrong code draws the pose to where it fits: here the sectors
// are as dark as they were read, and the code is the likeliest at the pose to which they lead. Whether there is one.
bool setLikeliest(const Measuring &measuring, Recognition &marker)
{
  const ImageFrame frame = frameOf(marker.poses[0], measuring.camera);
  const auto measurement = measuring.measure(marker);
  marker.darkness.reset();
  if (!measurement || measurement->first.correlation < leastCorrelationMeasured) {
    return false;
  }
  const auto code = measuring.mostLikelyCode(*measurement, frame, marker.family);
  if (!code || code->best.id < 0) {
    return false;
  }
  setCode(code->best, *measurement, marker);
  return true;
}

// The measurement of a marker whose code is proven: in doubt it was one of a single pose, with few steps, and goes on
// from where it is, and so do the marker's poses.
std::optional<Measurement> settled(const Measuring &measuring, const Measurement &measurement, Recognition &marker)
{
  if (marker.isCertain) {
    return measurement;
  }
  Recognition proven = marker;
  proven.isCertain = true;
  startAt(measurement, proven);
  auto again = measuring.measure(proven);
  if (again) {
    marker.poses = proven.poses;
  }
  return again;
}

// One marker on its way to a proven code: measured with one code after another until one is proven, or none.
class Proof
{
public:
  explicit Proof(const Measuring &measuring) : m_measuring(measuring) {}

  // The marker's measurement, if a code is proven by it, which may be another one than was read.
  std::optional<Measurement> measure(Recognition &marker)
  {
    const double sigma = m_measuring.noise.sigma;
    for (int round = 0; round < mostRounds; ++round) {
      const ImageFrame frame = frameOf(marker.poses[0], m_measuring.camera);
      const auto measurement = m_measuring.measure(marker);
      if (!measurement || !isWorthComparing(*measurement, isClear(marker))) {
        return std::nullopt;
      }
      m_leastLeft = std::min(m_leastLeft, measurement->first.noise);
      const auto code = m_measuring.mostLikelyCode(*measurement, frame, marker.family);
      if (m_measuring.deadline.hasPassed()) {
        return std::nullopt;
      }
      if (!code) { // the first reading decides, if what was read is there at all
        const bool isThere =
            isClear(marker) && leavesWhatPrintsLeave(measurement->first, sigma) &&
            !mayBeOtherCode(m_measuring.I, m_measuring.camera, marker, *measurement, m_measuring.memory);
        return isThere ? measurement : std::nullopt;
      }
      if (!isSame(code->best, marker)) {
        if (code->best.id < 0 || !isWorthMeasuring(*code)) {
          return std::nullopt;
        }
        setCode(code->best, *measurement, marker);
        continue;
      }
      const FittedPose &fit = measurement->first;
      const double sector = sectorLength(fit.plane, m_measuring.camera, marker.family);
      if (!isProven(*code, {marker.family, fit, sigma, isClear(marker), m_measuring.memory.pixels.size(), sector})) {
        return std::nullopt;
      }
      std::optional<Recognition> other;
      if (!isClear(marker) && code->odds <= clearOdds) {
        other = challenger(m_measuring, *code, *measurement, marker);
        if (m_measuring.deadline.hasPassed()) {
          return std::nullopt;
        }
      }
      if (!other) {
        return settled(m_measuring, *measurement, marker);
      }
      marker = std::move(*other);
    }
    return std::nullopt;
  }

private:
  // A sector that had to be corrected shows something else than the code: the reading is certain of the others only,
  // and by those a marker of which a part is covered may be another one.
  static bool isClear(const Recognition &marker) { return marker.isCertain && marker.code.hamming == 0; }

  static bool isSame(const PlacedCode &code, const Recognition &marker)
  {
    return code.id == marker.code.id && std::abs(code.spin) < M_PI / marker.family.getNbSectors();
  }

  // Whether a fit that may be one to a wrong code, or to no marker, explains enough.
  bool isWorthComparing(const Measurement &measurement, bool isClear) const
  {
    const bool isLike = measurement.first.correlation >= leastCorrelationMeasured;
    return isClear || (isLike && measurement.first.noise <= muchMore * m_leastLeft);
  }

  const Measuring &m_measuring;
  double m_leastLeft = HUGE_VAL; // the least that a code left so far, grey levels
};
} // namespace

bool wantsProof(const EllipseParameters &outline, const vpCircleMarkerFamily &family)
{
  return family.isCoded() && sectorLength(outline.b, family) < clearSector;
}

bool mayBeUncertain(const EllipseParameters &outline, const vpCircleMarkerFamily &family)
{
  return family.isCoded() && sectorLength(outline.b, family) < doubtfulSector;
}

bool mayBeOtherCode(const vpImage<unsigned char> &I, const CameraModel &camera, const Recognition &marker,
                    const Measurement &measurement, MeasureMemory &memory)
{
  if (!marker.family.isCoded() || marker.seen || marker.blurred) {
    return false;
  }
  const auto odds = oddsIfOverExposed(viewOf(I, camera, measurement, frameOf(marker.poses[0], camera)), marker.family,
                                      marker.family.getCodeword(marker.code.id), memory.code);
  return odds && *odds < leastOddsIfOverExposed;
}

std::optional<Measurement> measureProven(const vpImage<unsigned char> &I, const CameraModel &camera,
                                         const ImageNoise &noise, Recognition &marker, MeasureMemory &memory,
                                         const Deadline &deadline)
{
  const Measuring measuring = {I, camera, noise, memory, deadline};
  Proof proof(measuring);
  if (marker.isCertain) {
    return proof.measure(marker);
  }
  const Recognition asRead = marker;
  marker.darkness.reset();
  std::optional<Measurement> measurement;
  if (isLikeAtStart(measuring, marker)) {
    measurement = proof.measure(marker);
  }
  if (!measurement && asRead.darkness && isLikeAtStart(measuring, asRead)) {
    marker = asRead;
    if (setLikeliest(measuring, marker)) {
      measurement = proof.measure(marker);
    }
  }
  return measurement;
}
} // namespace circle_marker
END_VISP_NAMESPACE
