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
 * One outline once it was read as a marker: measured, with all that is in doubt, and reported.
 */

#include "vpDetectorCircleMarkerImpl.h"

#include <algorithm>
#include <cmath>

#include "detect_covered.h"
#include "pose/hypotheses.h"
#include "refine/blur_shape.h"
#include "refine/blurred_measurement.h"
#include "refine/camera_doubt.h"
#include "refine/closed_form.h"
#include "refine/coarse_fits.h"
#include "refine/measure.h"
#include "refine/report.h"
#include "support/sensor_range.h"
#include "debug_record.h"
#include "measure_proven.h"
#include "outer_edge.h"

BEGIN_VISP_NAMESPACE

using namespace circle_marker;

namespace {
// Plain rings are promised from a minor axis of 8 pixels on; the smaller the more there is that looks like one. When it
// is refined, its semi-axis is known to some hundredths of a pixel.
constexpr double leastMeasuredRing = 3.8; // its semi-minor axis, pixels

// Share of a plain ring that must be visible, at its measured pose: behind a straight edge over 40 % of it 0.55 is.
constexpr double leastVisibleRing = 0.4;

// Residuals larger than this, grey levels, are not noise; unless the image has so much, by which it is known to a half.
constexpr double muchNoise = 32.;
constexpr double mostOfNoise = 1.5;

bool isNoise(double residuals, double noise)
{
  return residuals < std::max(muchNoise, mostOfNoise * noise);
}

// As scaleTo() of poses does, and with them their covariance.
void scaleTo(double size, FittedPose &fit)
{
  const double scale = 0.5 * size / fit.plane.radius;
  fit.plane.center *= scale;
  fit.plane.radius = 0.5 * size;
  fit.covariance.topRows<3>() *= scale;
  fit.covariance.leftCols<3>() *= scale;
}
} // namespace

/*! Outer diameter of a marker, metres: as the database has it, or setMarkerSizes(), or detect(); or as getPose() says.
 */
double vpDetectorCircleMarker::Impl::sizeOf(const Recognition &marker, const Visit &visit) const
{
  if (visit.isSizeGiven) {
    return visit.size;
  }
  const vpCircleMarkerEntry *entry = database.find(marker.family, marker.code.id);
  const auto known = settings.sizes.find(marker.code.id);
  return entry != nullptr ? entry->size : known != settings.sizes.end() ? known->second : visit.size;
}

/*!
  The measurement of a marker that was read as a whole one, or, if something covers a part of it after all, that without
  it; nothing if it is not this marker.
*/
std::optional<Measurement> vpDetectorCircleMarker::Impl::withoutCover(const Visit &visit,
                                                                      const EllipseCandidate &outline,
                                                                      const Measurement &measurement,
                                                                      Recognition &marker, Workspace &workspace) const
{
  MeasureMemory &memory = workspace.measuring;
  const double noise = visit.noise.sigma;
  const WholeVerdict verdict = judgeWhole(visit.I, visit.camera, noise, outline.support, marker, measurement, memory);
  if (verdict == WholeVerdict::WRONG) {
    return std::nullopt;
  }
  // What it was read as is right: once more without what covers it, if that explains more of what is left. (It does not
  // if a shadow lies there, too, which no covered marker is measured with.)
  const auto leftOut = [&]() -> std::optional<Measurement> {
    auto part = withoutWhatCovers(visit.I, visit.camera, marker, measurement, memory);
    auto again = part ? measure(visit.I, visit.camera, *part, true, memory, visit.deadline, visit.noise) : std::nullopt;
    if (!again || again->first.inliers < measurement.first.inliers) {
      return measurement;
    }
    marker = std::move(*part);
    return again;
  };
  if (verdict == WholeVerdict::RIGHT) {
    return isPartMissing(outline.support) ? leftOut() : measurement;
  }
  const auto poses = posesFromOutline(outline.points, visit.camera, measurement.first.plane.radius, workspace.meters);
  auto ring = poses ? recogniseCoveredRing(visit.I, visit.camera, *poses, outline, marker.family) : std::nullopt;
  if (ring) {
    ring->asSeen = marker.asSeen;
  }
  auto covered = ring ? recogniseByMeasuredRing(visit.I, visit.camera, *ring, marker.family, settings.decode, memory,
                                                visit.deadline, visit.noise)
                      : std::nullopt;
  if (!covered && visit.deadline.hasPassed()) { // there was no time to ask what else it may be
    return std::nullopt;
  }
  if (covered && (marker.code.hamming > 0 || covered->code.id == marker.code.id)) {
    if (verdict == WholeVerdict::DOUBTFUL && covered->code.id == marker.code.id) {
      return measurement; // by all pixels: without noise, those left out are off by little
    }
    scaleTo(sizeOf(*covered, visit), covered->poses);
    covered->asSeen = marker.asSeen;
    if (auto again = measure(visit.I, visit.camera, *covered, true, memory, visit.deadline, visit.noise)) {
      marker = std::move(*covered);
      return again;
    }
  }
  if (covered || !isRightThoughCovered(visit.I, visit.camera, marker, measurement, verdict, memory)) {
    return std::nullopt;
  }
  return verdict == WholeVerdict::DOUBTFUL ? measurement : leftOut();
}

/*! A marker through the room refine; false if it turns out to be none. The place of the result is used again. */
bool vpDetectorCircleMarker::Impl::measureMarker(const Visit &visit, const EllipseCandidate &outline,
                                                 const Recognition &marker, Workspace &workspace, Found &measured) const
{
  Fit fit;
  const bool isMeasured = measureSharpened(visit, outline, marker, workspace, measured, fit);
  measured.isOtherRing = isMeasured && fit.isOtherRing;
  return isMeasured && !fit.isOtherRing;
}

/*! The measurement of a marker that explains the image; nothing if none does. The marker is then what was measured. */
std::optional<Measurement> vpDetectorCircleMarker::Impl::explain(const Visit &visit, const EllipseCandidate &outline,
                                                                 Recognition &marker, Workspace &workspace) const
{
  const bool isProofWanted = settings.refinePose && !marker.seen && !marker.blurred &&
                             (!marker.isCertain || wantsProof(outline.ellipse, marker.family));
  std::optional<Measurement> measurement;
  if (isProofWanted) {
    measurement = measureProven(visit.I, visit.camera, visit.noise, marker, workspace.measuring, visit.deadline);
    if (measurement) { // it may be another marker than was read
      forEachPose(*measurement, [&](FittedPose &pose) { scaleTo(sizeOf(marker, visit), pose); });
    }
  }
  else {
    if (settings.refinePose || !marker.blurred) { // the reading through a blur has its own poses
      measurement =
          measure(visit.I, visit.camera, marker, settings.refinePose, workspace.measuring, visit.deadline, visit.noise);
    }
    measurement = bestMeasurement(marker, measurement);
    if (measurement && settings.refinePose) {
      measurement = withoutCover(visit, outline, *measurement, marker, workspace);
    }
    if (measurement && settings.refinePose &&
        (showsOtherCode(visit.I, visit.camera, marker, *measurement, settings.decode.maximumHamming,
                        workspace.measuring) ||
         mayBeOtherCode(visit.I, visit.camera, marker, *measurement, workspace.measuring))) {
      return std::nullopt;
    }
  }
  const bool isRight = measurement && (!settings.refinePose || isNoise(measurement->first.noise, visit.noise.sigma));
  return isRight ? measurement : std::nullopt;
}

/*! What is in doubt besides the noise: the shape of the blur, the camera, and without refinement all of the pose. */
void vpDetectorCircleMarker::Impl::addDoubts(const Visit &visit, const EllipseCandidate &outline,
                                             const Recognition &marker, Workspace &workspace, Measurement &measurement,
                                             Fit &fit) const
{
  if (settings.refinePose) {
    const auto halo = marker.blurred ? std::nullopt : haloOf(visit.I, visit.camera, marker, measurement);
    forEachPose(measurement,
                [&](FittedPose &pose) { widenByShapeOfBlur(visit.noise.sigma, marker.family.isCoded(), halo, pose); });
    if (!marker.blurred) { // in a wide blur there is no halo to be seen
      fit.halo = halo.value_or(0.);
      addHaloDoubt(fit.halo < leastHalo ? 0. : fit.halo, visit.camera, measurement);
    }
    addLightDoubt(visit.camera, measurement);
    if (visit.mask != nullptr) {
      forEachPose(measurement, [&](FittedPose &pose) { pose.covariance += visit.mask->doubtOf(pose.plane); });
    }
  }
  else if (!marker.blurred) {
    forEachPose(measurement, [&](FittedPose &pose) {
      pose.covariance =
          closedFormCovariance(visit.I, outline, pose.plane, marker.family, visit.camera, workspace.meters);
    });
  }
  forEachPose(measurement,
              [&](FittedPose &pose) { addCameraDoubt(settings.cameraCovariance, marker.family, visit.camera, pose); });
}

/*! The same in the image of a visit as it is. */
bool vpDetectorCircleMarker::Impl::measureIn(const Visit &visit, const EllipseCandidate &outline, Recognition marker,
                                             Workspace &workspace, Found &measured, Fit &fit) const
{
  std::optional<Measurement> measurement = explain(visit, outline, marker, workspace);
  if (!measurement) {
    return false;
  }
  fit.measurement = measurement;
  fit.pixels = workspace.measuring.pixels.size();
  fit.left = unexplainedBy(measurement->first) / std::max(visit.noise.sigma, quantisation);
  addDoubts(visit, outline, marker, workspace, *measurement, fit);
  // Of a blurred outline pieces are missed, but a marker that is read through a blur shows all of its image.
  const double visible = marker.blurred        ? 1.
                         : !marker.seen        ? outline.support
                         : settings.refinePose ? visibleEdgeOf(visit.I, visit.camera, marker, *measurement)
                                               : marker.seen->shareOfRing();
  if (marker.seen && !marker.family.isCoded() && visible < leastVisibleRing) {
    return false;
  }
  vpCircleMarkerDetection &detection = measured.detection;
  putReport(marker, *measurement, visit.camera, visible, settings.zAlignedWithCameraAxis, detection);
  if (settings.refinePose && marker.family.getType() == vpCircleMarkerFamily::RING &&
      detection.ellipse.b < leastMeasuredRing) {
    return false;
  }
  fit.isOtherRing =
      settings.refinePose && !visit.isCameraGuessed && isOtherRing(marker, measurement->first, visit.camera);
  fit.poses.push_back(measurement->first.plane);
  if (measurement->second) {
    fit.poses.push_back(measurement->second->plane);
  }
  putOutline(marker, measurement->first.plane, visit.camera, polygonPoints, measured.polygon);
  measured.marker = std::move(marker);
  measured.outline = outline;
  measured.noise = visit.noise;
  return true;
}

END_VISP_NAMESPACE
