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
 * The simulated camera and the detectors of one thread.
 */

#include <visp3/core/vpMath.h>

#include "common/pose_error.h"
#include "common/reference_camera.h"
#include "common/seeds.h"
#include "cover.h"
#include "ideal_estimate.h"
#include "laboratory.h"
#include "poses.h"
#include "reading.h"

namespace experiments {
namespace {
constexpr double millimetres = 1e3;  // In a metre.
constexpr double milliseconds = 1e3; // In a second.

Deviation deviationOf(const PoseError &error)
{
  return {millimetres * error.x, millimetres * error.y, millimetres * error.z, vpMath::deg(error.normal)};
}

vpSimulatedMarker markerOf(Method method, int id, const Scene &scene, const Settings &settings, std::uint64_t seed)
{
  if (scene.design) {
    return markerOf(*scene.design, settings, seed);
  }
  switch (method) {
  case Method::Ring:
    return vpSimulatedMarker::ring(settings.size, thesisRingRatio);
  case Method::AprilTag:
    return vpSimulatedMarker::aprilTag36h11(id, tagOnSheet(settings.sheetSide()));
  default:
    return vpSimulatedMarker::circle(codedFamily, id, settings.size);
  }
}

int idOf(Method method, const Scene &scene, std::uint64_t seed)
{
  if (scene.design) {
    return idOf(*scene.design, seed);
  }
  switch (method) {
  case Method::Ring:
    return -1;
  case Method::AprilTag:
    return static_cast<int>(seedOf(Draw::TagId, seed) % tagIds);
  default:
    return static_cast<int>(seedOf(Draw::CodedId, seed) % codedIds);
  }
}
/*! Whether the camera is the reference camera in even light on a plain ground: to make another takes longer than an
 * image. */
bool isUsual(const Scene &scene, const Settings &settings)
{
  return !scene.clutterSeed && scene.cam.get_projModel() == vpCameraParameters::perspectiveProjWithoutDistortion &&
         scene.photometry.noiseSigma == settings.noise && scene.photometry.blurSigma == settings.blur &&
         scene.photometry.gradientU == 0. && scene.photometry.gradientV == 0. && !scene.photometry.shadow;
}
} // namespace

std::uint64_t frameSeed(const Settings &settings, const Series &series, unsigned int frame)
{
  return mixed(mixed(mixed(settings.seed, 0), series.stream), frame);
}

Laboratory::Laboratory(const Settings &settings)
    : m_settings(settings), m_ring(vpCircleMarkerFamily::ring(thesisRingRatio), settings.size),
      m_circle(vpCircleMarkerFamily::fromName(codedFamily), settings.size)
{
}

FrameSamples Laboratory::take(const Series &series, unsigned int frame)
{
  const std::uint64_t seed = frameSeed(m_settings, series, frame);
  const Scene scene = series.scene(frame, seed);
  FrameSamples samples;
  for (const Method method : methodsOf(series, frame)) {
    samples.push_back(look(method, scene, seed));
  }
  return samples;
}

Sample Laboratory::look(Method method, const Scene &scene, std::uint64_t seed)
{
  Sample sample;
  sample.method = method;
  const int id = idOf(method, scene, seed);
  vpSimulatedMarker marker = markerOf(method, id, scene, m_settings, seed);
  marker.setSheetSide(m_settings.sheetSide());
  if (scene.cMo) {
    marker.setPose(*scene.cMo);
  }
  if (method == Method::Limit) {
    sample = limitOf(marker, scene);
    const unsigned int distance = scene.design ? codeDistanceOf(*scene.design) : 0;
    sample.reading = distance > 0 ? readingDistance(marker, distance, scene) : 0.;
    return sample;
  }
  Sighting sighting;
  if (method == Method::Bound) {
    sighting.cMo = idealEstimate(marker, scene, seedOf(Draw::Bound, seed));
  }
  else {
    photograph(marker, scene, mixed(seedOf(Draw::Noise, seed), static_cast<std::uint64_t>(method)));
    sighting = sightOf(method, scene, id, sample);
  }
  sample.cpuTime = milliseconds * sighting.cpuTime;
  sample.markers = sighting.wrongIds + (sighting.cMo ? 1 : 0);
  if (!scene.cMo) {
    return sample;
  }
  sample.x = (*scene.cMo)[0][3];
  sample.y = (*scene.cMo)[1][3];
  sample.z = (*scene.cMo)[2][3];
  sample.angle = vpMath::deg(tiltOf(*scene.cMo));
  if (sighting.cMo) {
    const PoseError error = errorOf(*sighting.cMo, *scene.cMo);
    sample.first = deviationOf(error);
    sample.rotation = method == Method::Ring ? 0. : vpMath::deg(error.rotation);
    sample.isMirrored = error.wrongSolution;
  }
  const bool isOurs = method == Method::Ring || method == Method::Circle;
  if (sighting.cMo && isOurs) {
    const auto &detection = detectorFor(method, scene).last();
    if (detection->hasSecondPose) {
      sample.second = deviationOf(errorOf(detection->cMo2, *scene.cMo));
      sample.logOdds = detection->logOdds;
    }
  }
  return sample;
}

void Laboratory::photograph(const vpSimulatedMarker &marker, const Scene &scene, std::uint64_t seed)
{
  if (!m_camera || !isUsual(scene, m_settings)) {
    m_camera.emplace(scene.cam, imageWidth, imageHeight);
    m_camera->setPhotometry(scene.photometry);
    if (scene.clutterSeed) {
      m_camera->setBackground(vpSceneBackground::clutter(*scene.clutterSeed));
    }
  }
  vpMarkerSceneSimulator &camera = *m_camera;
  camera.clearMarkers();
  camera.clearOccluders();
  camera.setMotion(scene.motion);
  if (scene.cMo) {
    camera.addMarker(marker);
    if (scene.cover) {
      camera.addOccluder(occluderOf(*scene.cover, camera, *scene.cMo, 0.5 * m_settings.size));
    }
  }
  camera.render(m_image, seed);
  if (!isUsual(scene, m_settings)) {
    m_camera.reset();
  }
}

Sighting Laboratory::sightOf(Method method, const Scene &scene, int id, Sample &sample)
{
  if (method == Method::AprilTag) {
    if (!m_tag) {
      m_tag = std::make_unique<AprilTagDetector>(tagOnSheet(m_settings.sheetSide()), bestTagPose, 1.f);
    }
    return m_tag->look(m_image, scene.cam, id).halfPixel;
  }
  CircleDetector &detector = detectorFor(method, scene);
  const Sighting sighting = detector.look(m_image, scene.cam, id);
  sample.outlines = detector.outlines();
  return sighting;
}

CircleDetector &Laboratory::detectorFor(Method method, const Scene &scene)
{
  if (!scene.design) {
    return method == Method::Ring ? m_ring : m_circle;
  }
  const Wanted wanted = wantedOf(*scene.design, m_settings);
  return m_designs.try_emplace(nameOf(*scene.design), wanted.family, wanted.size).first->second;
}
} // namespace experiments
