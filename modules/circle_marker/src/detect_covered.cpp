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
 * A marker of an outline, whole or with something in front of a part of it.
 */

#include "detect_covered.h"

#include <utility>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Odds, ln, by which the ring alone tells its pose from the twin: at a twin what covers the code and the code itself
// change places.
constexpr double hopelessOdds = 10.;
} // namespace

std::optional<Recognition> recogniseByMeasuredRing(const vpImage<unsigned char> &I, const CameraModel &camera,
                                                   const EllipseCandidate &outline, const PosePair &poses,
                                                   const vpCircleMarkerFamily &family, const DecodeSettings &settings,
                                                   MeasureMemory &memory)
{
  const auto ring = recogniseCoveredRing(I, camera, poses, outline, family);
  if (!ring) {
    return std::nullopt;
  }
  const auto measurement = measure(I, camera, *ring, true, memory);
  if (!measurement) {
    return std::nullopt;
  }
  const MarkerPlane &first = measurement->first.plane;
  const bool hasTwin = measurement->second && measurement->cost2 - measurement->cost < hopelessOdds;
  const PosePair measured = {first, hasTwin ? measurement->second->plane : first};
  Judged<Recognition> marker = recogniseCovered(I, camera, measured, family, settings);
  return marker ? std::optional<Recognition>(std::move(*marker)) : std::nullopt;
}

void listAttempts(const std::vector<vpCircleMarkerFamily> &families, std::vector<Attempt> &attempts)
{
  attempts.clear();
  std::size_t k = 0;
  while (k < families.size()) {
    const std::size_t first = k;
    do {
      attempts.push_back({k++, ReadingKind::WHOLE});
    } while (k < families.size() && families[first].isCoded() && families[k].isCoded());
    for (const ReadingKind kind : {ReadingKind::UNCERTAIN, ReadingKind::COVERED}) {
      for (std::size_t coded = first; coded < k && families[coded].isCoded(); ++coded) {
        attempts.push_back({coded, kind});
      }
    }
  }
}
} // namespace circle_marker
END_VISP_NAMESPACE
