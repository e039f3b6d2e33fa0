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
 * The simulated camera that the user moves through a room.
 */

#include "world.h"

#include <algorithm>
#include <cmath>

#include "common/pose_distance.h"
#include "common/pose_error.h"
#include "common/seeds.h"

namespace simulator {
namespace {
vpScenePhotometry photometryOf(const Knobs &knobs)
{
  vpScenePhotometry photometry;
  photometry.noiseSigma = knobs.noise;
  photometry.blurSigma = knobs.blur;
  photometry.paper *= knobs.light;
  photometry.ink *= knobs.light;
  photometry.gradientU = knobs.gradient;
  return photometry;
}

/*! Something dark before the left part of each marker. */
void cover(vpMarkerSceneSimulator &scene, int tenths)
{
  for (const vpMarkerTruth &truth : tenths > 0 ? scene.getTruth() : std::vector<vpMarkerTruth>()) {
    if (!truth.ellipse) {
      continue;
    }
    const vpImagePoint center = truth.ellipse->center;
    const double reach = 1.1 * truth.ellipse->semiAxisA;
    const double right = -reach + 0.2 * reach * tenths;
    const auto corner = [&](double u, double v) { return vpImagePoint(center.get_v() + v, center.get_u() + u); };
    constexpr double grey = 70.; // neither ink nor paper
    scene.addOccluder(vpSceneOccluder::polygon({corner(-1.5 * reach, -1.5 * reach), corner(right, -1.5 * reach),
                                                corner(right, 1.5 * reach), corner(-1.5 * reach, 1.5 * reach)},
                                               grey));
  }
}

/*! Root of the mean square of what was measured. */
double inSigmas(const vpCircleMarkerDetection &detection, const vpHomogeneousMatrix &truth)
{
  return std::sqrt(std::max(common::squaredMahalanobis(truth, detection), 0.) / detection.dof);
}

Comparison compare(const vpMarkerTruth &truth, const std::vector<vpCircleMarkerDetection> &detections)
{
  Comparison comparison;
  comparison.id = truth.id;
  comparison.distance = common::distanceOf(truth.cMo);
  comparison.tilt = truth.tilt;
  comparison.isWhole = truth.visibleEdge >= 1. && truth.tilt < M_PI / 2.;
  for (const vpCircleMarkerDetection &detection : detections) {
    if (detection.id == truth.id && detection.family.getName() == truth.family) {
      const common::PoseError error = common::errorOf(detection.cMo, truth.cMo);
      comparison.error = error.position;
      comparison.normalError = error.normal;
      comparison.sigmas = inSigmas(detection, truth.cMo);
    }
  }
  return comparison;
}
} // namespace

World::World(const common::Room &room, const vpCameraParameters &cam, unsigned int width, unsigned int height,
             std::uint64_t seed)
    : m_room(room), m_cam(cam), m_scene(cam, width, height), m_seed(seed)
{
  m_detector.setFamilies(common::familiesOf(room));
  m_detector.setZAlignedWithCameraAxis(true);
  m_detector.setDatabase(room.markers);
}

Shot World::look(const vpHomogeneousMatrix &wMc, const Knobs &knobs)
{
  m_scene.clearMarkers();
  m_scene.clearOccluders();
  m_scene.setPhotometry(photometryOf(knobs));
  common::addMarkers(m_room, wMc, m_scene);
  cover(m_scene, knobs.cover);
  Shot shot;
  const std::vector<vpMarkerTruth> truths = m_scene.render(shot.image, common::mixed(m_seed, m_images++));
  std::vector<vpHomogeneousMatrix> cMo;
  constexpr double anySize = 0.18; // metres; the database knows those of the room's markers
  m_detector.detect(shot.image, anySize, m_cam, cMo);
  shot.detections = m_detector.getDetections();
  std::size_t found = 0;
  for (const vpMarkerTruth &truth : truths) {
    Comparison comparison = compare(truth, shot.detections);
    const auto *entry = m_room.markers.find(vpCircleMarkerFamily::fromName(truth.family), truth.id);
    comparison.name = entry != nullptr ? entry->name : "";
    found += comparison.error ? 1 : 0;
    if (truth.visibleEdge > 0. && truth.tilt < M_PI / 2.) {
      shot.markers.push_back(comparison);
    }
  }
  shot.phantoms = static_cast<unsigned int>(shot.detections.size() - std::min(found, shot.detections.size()));
  std::sort(shot.markers.begin(), shot.markers.end(),
            [](const Comparison &a, const Comparison &b) { return a.distance < b.distance; });
  return shot;
}
} // namespace simulator
