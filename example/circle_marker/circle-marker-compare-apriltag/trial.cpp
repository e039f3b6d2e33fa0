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
 * One pose, seen once with each marker and measured with each method.
 */

#include <memory>

#include <visp3/circle_marker_simulator/vpMarkerSceneSimulator.h>
#include <visp3/circle_marker_simulator/vpRandomMarkerPose.h>
#include <visp3/core/vpMath.h>

#include "common/seeds.h"
#include "trial.h"

namespace compare {
namespace {
/*! What a trial draws from its seed. */
enum class Draw : std::uint64_t
{
  Pose = 1,
  CircleId,
  TagId,
  CircleNoise,
  TagNoise
};

/*! The seeds of a trial. */
class Seeds
{
public:
  Seeds(std::uint64_t seed, std::size_t cell, unsigned int frame) : m_seed(mixed(mixed(mixed(seed, 0), cell), frame)) {}

  std::uint64_t of(Draw draw) const { return mixed(m_seed, static_cast<std::uint64_t>(draw)); }

private:
  std::uint64_t m_seed; //!< Of this trial.
};

/*! The simulated camera and the detectors of one thread. */
class Laboratory
{
public:
  explicit Laboratory(const Settings &settings)
      : m_settings(settings), m_camera(referenceCamera(), imageWidth, imageHeight),
        m_circle(vpCircleMarkerFamily::fromName(circleFamily), settings.size),
        m_tag1(settings.tagSize(), settings.tagPose, 1.f), m_tag2(settings.tagSize(), settings.tagPose, 2.f)
  {
    vpScenePhotometry photometry;
    photometry.noiseSigma = settings.noise;
    photometry.blurSigma = settings.blur;
    m_camera.setPhotometry(photometry);
  }

  Trial makeTrial(std::size_t cell, unsigned int frame)
  {
    const Seeds seeds(m_settings.seed, cell, frame);
    Trial trial;
    trial.cell = cell;
    trial.frame = frame;
    trial.circleId = static_cast<int>(seeds.of(Draw::CircleId) % circleIds);
    trial.tagId = static_cast<int>(seeds.of(Draw::TagId) % tagIds);

    vpSimulatedMarker circle = vpSimulatedMarker::circle(circleFamily, trial.circleId, m_settings.size);
    circle.setSheetSide(m_settings.sheetSide());
    vpRandomPoseRange range;
    range.minDepth = minDistance;
    range.maxDepth = cells[cell].maxDistance;
    range.maxTilt = vpMath::rad(cells[cell].maxTilt);
    // The sheets are the same, so a pose that suits one marker suits the other.
    trial.cMo = vpRandomMarkerPose(circle, referenceCamera(), imageWidth, imageHeight, range, seeds.of(Draw::Pose));

    photograph(circle, trial.cMo, seeds.of(Draw::CircleNoise));
    record(m_circle.look(m_image, m_camera.getCameraParameters(), trial.circleId), Method::Circle, trial);

    vpSimulatedMarker tag = vpSimulatedMarker::aprilTag36h11(trial.tagId, m_settings.tagSize());
    tag.setSheetSide(m_settings.sheetSide());
    photograph(tag, trial.cMo, seeds.of(Draw::TagNoise));
    const AprilTagSightings whole = m_tag1.look(m_image, m_camera.getCameraParameters(), trial.tagId);
    record(whole.asDelivered, Method::AprilTag1, trial);
    record(whole.halfPixel, Method::AprilTag1HalfPixel, trial);
    const AprilTagSightings decimated = m_tag2.look(m_image, m_camera.getCameraParameters(), trial.tagId);
    record(decimated.asDelivered, Method::AprilTag2, trial);
    record(decimated.halfPixel, Method::AprilTag2HalfPixel, trial);
    return trial;
  }

private:
  void photograph(vpSimulatedMarker &marker, const vpHomogeneousMatrix &cMo, std::uint64_t seed)
  {
    m_camera.clearMarkers();
    m_camera.addMarker(marker.setPose(cMo));
    m_camera.render(m_image, seed);
  }

  static void record(const Sighting &sighting, Method method, Trial &trial)
  {
    Measurement &measurement = trial.measurements[indexOf(method)];
    measurement.wrongIds = sighting.wrongIds;
    measurement.cpuTime = sighting.cpuTime;
    if (sighting.cMo) {
      measurement.error = errorOf(*sighting.cMo, trial.cMo);
    }
  }

  Settings m_settings;             //!< As given.
  vpMarkerSceneSimulator m_camera; //!< One marker on a plain grey ground.
  CircleDetector m_circle;         //!< For circular markers.
  AprilTagDetector m_tag1, m_tag2; //!< Decimation 1 and 2.
  vpImage<unsigned char> m_image;  //!< The last picture.
};
} // namespace

std::vector<Trial> makeTrials(const Settings &settings, const Progress &progress)
{
  std::vector<Trial> trials(cells.size() * settings.frames);
  const auto makeWorker = [&]() {
    const auto laboratory = std::make_shared<Laboratory>(settings);
    return [&, laboratory](std::size_t item) {
      // Frame by frame through the cells, which differ in the time they take: so the time left can be told.
      const std::size_t cell = item % cells.size();
      const std::size_t frame = item / cells.size();
      trials[cell * settings.frames + frame] = laboratory->makeTrial(cell, static_cast<unsigned int>(frame));
    };
  };
  forEachItem(trials.size(), settings.threads, makeWorker, progress);
  return trials;
}
} // namespace compare
