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
 * Makes pictures of scenes, measures the markers in them, and asks how well that could have been done.
 */

#include <cmath>

#include <visp3/core/vpMath.h>

#include "common/pose_error.h"
#include "laboratory.h"
#include "pose_check.h"

namespace accuracy {
namespace {
constexpr double millimetres = 1000.;
// Images of greater diameter, pixels, are those of poses 15 standard deviations and more apart even at the faintest.
constexpr double separateFrom = 100.;

vpScenePhotometry withRounding(vpScenePhotometry photometry)
{
  photometry.noiseSigma = std::sqrt(photometry.noiseSigma * photometry.noiseSigma + 1. / 12.);
  return photometry;
}

vpEllipseTruth edgeOf(const Scene &scene)
{
  vpMarkerSceneSimulator simulator(scene.camera, 1, 1);
  simulator.addMarker(scene.marker());
  return simulator.getTruth()[0].ellipse.value();
}

Record recordOf(const Scene &scene, const Limit &limit)
{
  const vpEllipseTruth edge = edgeOf(scene);
  Record record;
  record.method = "circle";
  record.id = scene.id;
  record.distance = distanceOf(scene.cMo);
  record.diameter = 2. * edge.semiAxisA;
  record.minor = 2. * edge.semiAxisB;
  record.tilt = vpMath::deg(tiltOf(scene.cMo));
  record.noise = scene.photometry.noiseSigma;
  record.blur = scene.photometry.blurSigma;
  record.contrast = scene.photometry.paper - scene.photometry.ink;
  record.dof = limit.bound.dof;
  record.boundX = millimetres * limit.bound.x;
  record.boundY = millimetres * limit.bound.y;
  record.boundZ = millimetres * limit.bound.z;
  record.boundNormal = vpMath::deg(limit.bound.normal);
  record.boundRotation = vpMath::deg(std::hypot(limit.bound.normal, limit.bound.spin));
  record.predicted = limit.separation ? limit.separation->wrongChoice : limit.isCertain ? 0. : none;
  record.separation = limit.separation ? limit.separation->separation : none;
  return record;
}

void addError(const Sighting &sighting, const Scene &scene, Record &record)
{
  record.milliseconds = millimetres * sighting.cpuTime; // Seconds.
  record.found = sighting.cMo ? 1. : 0.;
  if (!sighting.cMo) {
    return;
  }
  const PoseError error = errorOf(*sighting.cMo, scene.cMo);
  record.wrong = error.wrongSolution ? 1. : 0.;
  record.x = millimetres * error.x;
  record.y = millimetres * error.y;
  record.z = millimetres * error.z;
  record.normal = vpMath::deg(error.normal);
  record.lean = vpMath::deg(tiltOf(*sighting.cMo) - tiltOf(scene.cMo));
  record.rotation = vpMath::deg(error.rotation);
}
} // namespace

Limit Laboratory::limitOf(const Scene &scene, bool withSeparation) const
{
  vpMarkerPoseBound bound(scene.camera, withRounding(scene.modelled));
  bound.setSurround(m_settings.surround);
  const vpSimulatedMarker marker = scene.marker();
  Limit limit;
  limit.bound = bound.bound(marker);
  limit.isCertain = withSeparation && 2. * edgeOf(scene).semiAxisA >= separateFrom;
  if (withSeparation && !limit.isCertain) {
    limit.separation = bound.separation(marker);
  }
  return limit;
}

Limit Laboratory::limitOfTag(const Scene &scene) const
{
  vpMarkerPoseBound bound(scene.camera, withRounding(scene.modelled));
  bound.setSurround(m_settings.surround);
  Limit limit;
  limit.bound = bound.bound(scene.tag());
  return limit;
}

void Laboratory::photograph(const Scene &scene, const vpSimulatedMarker &marker)
{
  vpMarkerSceneSimulator simulator(scene.camera, scene.width, scene.height);
  simulator.setPhotometry(scene.photometry);
  simulator.setBackground(vpSceneBackground::plain(scene.ground));
  simulator.setMotion(scene.motion);
  simulator.addMarker(scene.printed(marker));
  simulator.render(m_image, scene.noiseSeed);
  process(scene.processing, m_image);
}

Record Laboratory::measure(const Scene &scene, const Limit &limit)
{
  const std::string key = scene.family + " " + std::to_string(scene.size);
  auto place = m_circles.find(key);
  if (place == m_circles.end()) {
    place = m_circles.emplace(key, CircleDetector(familyOf(scene.family), scene.size)).first;
  }
  photograph(scene, scene.marker());
  CircleDetector &detector = place->second;
  Record record = recordOf(scene, limit);
  detector.setCameraCovariance(scene.assumedCovariance);
  addError(detector.look(m_image, scene.assumed, scene.id), scene, record);
  if (record.isFound()) {
    const vpCircleMarkerDetection &detection = *detector.last();
    record.logOdds = detection.logOdds;
    const PoseCheck checked = check(detection.cMo, scene.cMo, detection.covariance, detection.dof);
    record.mahalanobis = checked.mahalanobis;
    record.reportedX = millimetres * checked.x;
    record.reportedY = millimetres * checked.y;
    record.reportedZ = millimetres * checked.z;
    record.reportedNormal = vpMath::deg(checked.normal);
  }
  return record;
}

Record Laboratory::measureTag(const Scene &scene, const Limit &limit, int decimation)
{
  const double size = tagOnSheet(sheetOfRing(scene.size));
  auto place = m_tags.find({decimation, size});
  if (place == m_tags.end()) {
    place = m_tags
                .emplace(std::make_pair(decimation, size),
                         AprilTagDetector(size, bestTagPose, static_cast<float>(decimation)))
                .first;
  }
  photograph(scene, scene.tag());
  Record record = recordOf(scene, limit);
  record.method = "apriltag-" + std::to_string(decimation);
  record.id = scene.id % tagIds;
  addError(place->second.look(m_image, scene.assumed, scene.id % tagIds).halfPixel, scene, record);
  return record;
}
} // namespace accuracy
