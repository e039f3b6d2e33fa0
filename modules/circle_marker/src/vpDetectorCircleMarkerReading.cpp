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
 * One outline through the rooms that read it: as each of the families that are sought, in the order of the attempts.
 */

#include "vpDetectorCircleMarkerImpl.h"

#include <algorithm>
#include <cmath>

#include "decode/edge_width.h"
#include "detect_covered.h"
#include "pose/hypotheses.h"
#include "support/same_family.h"
#include "debug_record.h"
#include "measure_proven.h"

BEGIN_VISP_NAMESPACE

using namespace circle_marker;

namespace {
// Outlines of an image that are read through a blur, at most. A picture that is out of focus has hundreds of them if it
// is full of rings; each takes 10 to 20 ms and a family (bench-circle-marker --timeouts 1, defocused-tracks).
constexpr std::size_t mostBlurred = 16;
} // namespace

/*! One outline through the rooms pose and decode: the first of the families that remain and that it looks like. */
void vpDetectorCircleMarker::Impl::read(const Visit &visit, const EllipseCandidate &outline, Workspace &workspace,
                                        Examination &examination) const
{
  const auto poses = posesFromOutline(outline.points, visit.camera, 0.5 * visit.size, workspace.meters);
  if (!poses && keepsDebug) {
    examination.candidates.push_back(candidateOf(outline, settings.families.front(), vpCircleMarkerReject::NO_POSE));
  }
  std::optional<OutlineInImage> seen;
  if (poses) {
    seen.emplace(visit.I, visit.camera, *poses, outline);
  }
  while (seen && !examination.marker && examination.attempt < m_attempts.size() && !visit.deadline.hasPassed()) {
    const Attempt &attempt = m_attempts[examination.attempt++];
    const vpCircleMarkerFamily &family = settings.families[attempt.family];
    if (attempt.kind != ReadingKind::WHOLE && (visit.readsWholeOnly || attempt.family == examination.otherRingOf ||
                                               attempt.family == examination.mirroredOf)) {
      continue;
    }
    if (attempt.kind != ReadingKind::WHOLE) {
      examination.marker = readInDoubt(visit, *seen, family, attempt.kind);
      if (examination.marker && !isCoveredRing(examination)) { // that of a code is one when its code is read
        keepAsMarker(outline, family, examination);
      }
    }
    else {
      readWhole(visit, *seen, family, examination);
    }
  }
  if (examination.marker && !isCoveredRing(examination)) {
    scaleTo(sizeOf(*examination.marker, visit), examination.marker->poses);
  }
  examination.isRead = true;
  examination.isOver = !examination.marker;
}

/*! Of what an outline was tried as, if that is to be shown: as a family's whole marker it is none, but in doubt. */
void vpDetectorCircleMarker::Impl::keepAsMarker(const EllipseCandidate &outline, const vpCircleMarkerFamily &family,
                                                Examination &examination) const
{
  if (!keepsDebug) {
    return;
  }
  std::vector<vpCircleMarkerCandidate> &candidates = examination.candidates;
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                                  [&](const auto &other) { return isSameFamily(other.family, family); }),
                   candidates.end());
  candidates.push_back(candidateOf(outline, family, vpCircleMarkerReject::NONE));
}

/*! Whether an outline was read as the ring of a marker that something covers, whose code is not read yet. */
bool vpDetectorCircleMarker::Impl::isCoveredRing(const Examination &examination) const
{
  return examination.marker && examination.marker->isRingOfCode;
}

/*! The code of such a ring; false, and it has no marker any more, if it has none. */
bool vpDetectorCircleMarker::Impl::readCovered(const Visit &visit, const EllipseCandidate &outline,
                                               Workspace &workspace, Examination &examination) const
{
  const vpCircleMarkerFamily &family = settings.families[m_attempts[examination.attempt - 1].family];
  examination.marker = recogniseByMeasuredRing(visit.I, visit.camera, *examination.marker, family, settings.decode,
                                               workspace.measuring, visit.deadline, visit.noise);
  if (examination.marker) {
    scaleTo(sizeOf(*examination.marker, visit), examination.marker->poses);
    keepAsMarker(outline, family, examination);
  }
  return examination.marker.has_value();
}

/*!
  An outline as a marker with sectors that are too small to be read one by one, or as the ring of one with something in
  front of it.
*/
std::optional<Recognition> vpDetectorCircleMarker::Impl::readInDoubt(const Visit &visit, OutlineInImage &seen,
                                                                     const vpCircleMarkerFamily &family,
                                                                     ReadingKind kind) const
{
  if (kind == ReadingKind::COVERED && !family.isCoded()) { // only what is left of a fit tells whether it is one
    return settings.refinePose ? recogniseCoveredShape(seen, family) : std::nullopt;
  }
  if (kind == ReadingKind::COVERED) {
    return recogniseCoveredRing(visit.I, visit.camera, seen.poses, seen.outline, family);
  }
  // Who asks for more certainty than by default, or forbids corrections, gets what is read sector by sector.
  const bool mayProve = settings.refinePose && settings.decode.maximumHamming > 0 &&
                        settings.decode.minimumMargin <= DecodeSettings().minimumMargin;
  return mayProve && mayBeUncertain(seen.outline.ellipse, family) ? recogniseUncertain(seen, family, visit.noise.sigma)
                                                                  : std::nullopt;
}

/*!
  Allows the largest of the outlines that look blurred to be read through the blur: 10 to 20 ms for each. Which
  ones does not depend on the threads, nor on what is read.
*/
void vpDetectorCircleMarker::Impl::allowBlurred(const Visit &visit, const Outlines &outlines)
{
  const auto hasAny = [this](const auto &isOne) {
    return std::any_of(settings.families.begin(), settings.families.end(), isOne);
  };
  const bool hasRings = hasAny([](const auto &family) { return family.getType() == vpCircleMarkerFamily::RING; });
  const bool isAsked = hasRings || hasAny([](const auto &family) { return family.isCoded(); });
  double quietZone = HUGE_VAL; // the narrowest
  for (const vpCircleMarkerFamily &family : settings.families) {
    quietZone = std::min(quietZone, family.getLayout().quietZone);
  }
  std::size_t allowed = 0;
  for (std::size_t i = 0;
       isAsked && !visit.readsWholeOnly && i < outlines.size() && allowed < mostBlurred && !visit.deadline.hasPassed();
       ++i) {
    m_examinations[i].mayBeBlurred =
        !outlines[i].isThin && looksBlurred(visit.I, outlines[i].ellipse, !hasRings, quietZone);
    allowed += m_examinations[i].mayBeBlurred ? 1 : 0;
  }
}

/*! An outline as a marker of a family of which nothing is covered. */
void vpDetectorCircleMarker::Impl::readWhole(const Visit &visit, OutlineInImage &seen,
                                             const vpCircleMarkerFamily &family, Examination &examination) const
{
  ReadingTrace trace;
  Judged<Recognition> marker =
      recognise(seen, family, settings.decode, keepsDebug ? &trace : nullptr, examination.mayBeBlurred, visit.deadline);
  const bool isOther =
      marker && std::any_of(settings.families.begin(), settings.families.end(),
                            [&](const auto &other) { return isRatherOf(seen, family, other, settings.decode); });
  if (isOther) {
    marker = vpCircleMarkerReject::NO_CODEWORD;
  }
  if (keepsDebug) {
    examination.candidates.push_back(candidateOf(seen.outline, family, marker.reason()));
    addReading(trace, family, visit.camera, examination.candidates.back());
  }
  if (marker) {
    examination.marker = std::move(*marker);
  }
  else if (marker.reason() == vpCircleMarkerReject::MIRRORED) {
    examination.mirroredOf = m_attempts[examination.attempt - 1].family;
  }
}

END_VISP_NAMESPACE
