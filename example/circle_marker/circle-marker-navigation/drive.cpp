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
 * A robot's way through the room, step by step.
 */

#include "drive.h"

#include <algorithm>
#include <cmath>

#include <visp3/circle_marker/vpDetectorCircleMarker.h>
#include <visp3/core/vpExponentialMap.h>

#include "circle_marker/common/detection/marker_overlay.h"
#include "circle_marker/common/draw.h"
#include "common/seeds.h"
#include "tasks.h"

namespace navigation {
namespace {
constexpr double samplingTime = 0.2; // s: five images a second
// Ten legs of three metres and their turns take some 100 s; the robot is lost long before.
constexpr double longestLeg = 60.;                // s
constexpr unsigned int width = 960, height = 720; // pixels

/*! 77 degrees of view: a robot should see more than what is straight ahead. */
vpCameraParameters robotsCamera()
{
  return vpCameraParameters(600., 600., 0.5 * (width - 1.), 0.5 * (height - 1.));
}

vpHomogeneousMatrix cameraAt(const FloorPose &pose)
{
  return common::lookingAlong(pose.x, 0., pose.z, pose.direction);
}

/*! Robot, room and what both make of each other. */
class Drive
{
public:
  Drive(const common::Room &room, const Settings &settings)
      : m_room(room), m_settings(settings), m_robot(start(), settings.speedError, settings.turnError, settings.seed),
        m_belief(start()), m_wheels(start()), m_scene(robotsCamera(), width, height)
  {
    m_detector.setZAlignedWithCameraAxis(true);
    m_detector.setFamilies(common::familiesOf(room));
    m_detector.setDatabase(room.markers);
  }

  Journey all(const common::Progress &progress)
  {
    const std::size_t count = std::min<std::size_t>(m_settings.mostTasks, m_room.markers.getEntries().size());
    FloorPose goal = start();
    look();
    while (m_journey.problem.empty()) {
      const std::optional<Task> task = readTask(goal);
      if (!task) {
        break;
      }
      progress(m_journey.stations.size(), std::max(count, m_journey.stations.size()));
      m_journey.isComplete = task->isStop || m_journey.stations.size() > m_settings.mostTasks;
      if (m_journey.isComplete) {
        break;
      }
      goal = task->goal;
      follow(goal);
    }
    return std::move(m_journey);
  }

private:
  static FloorPose start() { return FloorPose{0., 3.8, 0.}; }

  /*! Takes an image, finds out where the camera is, and notes how true that is. */
  void look()
  {
    const vpHomogeneousMatrix truth = cameraAt(m_robot.pose());
    m_scene.clearMarkers();
    common::addMarkers(m_room, truth, m_scene);
    m_scene.render(m_image, common::mixed(m_settings.seed, m_journey.steps.size()));
    std::vector<vpHomogeneousMatrix> cMo;
    constexpr double anySize = 0.18; // metres; the database has the sizes
    m_detector.detect(m_image, anySize, robotsCamera(), cMo);
    const auto location = locate(m_room.markers, m_detector.getDetections(), cameraAt(m_belief.pose()));
    Step step;
    step.time = samplingTime * static_cast<double>(m_journey.steps.size());
    if (location) {
      m_belief.correct(*location);
      step.markers = location->markers;
      const vpColVector d = vpExponentialMap::inverse(location->wMc.inverse() * truth);
      step.cameraError = std::hypot(location->wMc[0][3] - truth[0][3], location->wMc[1][3] - truth[1][3],
                                    location->wMc[2][3] - truth[2][3]);
      step.cameraSigmas = std::sqrt((d.t() * (location->covariance.inverseByCholesky() * d)) / 6.);
    }
    step.truth = m_robot.pose();
    step.believed = m_belief.pose();
    step.wheels = m_wheels;
    step.sigmas = m_belief.sigmasFrom(m_robot.pose());
    m_journey.steps.push_back(step);
  }

  /*! Reads the marker that is straight ahead. */
  std::optional<Task> readTask(const FloorPose &goal)
  {
    const vpCircleMarkerEntry *ahead = nullptr;
    double least = HUGE_VAL;
    std::string message;
    for (std::size_t i = 0; i < m_detector.getDetections().size(); ++i) {
      const vpCircleMarkerDetection &detection = m_detector.getDetections()[i];
      const vpCircleMarkerEntry *entry = m_room.markers.find(detection.family, detection.id);
      const double off = std::abs(detection.center.get_u() - 0.5 * width);
      if (entry != nullptr && !entry->payload.empty() && off < least) {
        least = off;
        ahead = entry;
        message = m_detector.getMessage(i);
      }
    }
    if (ahead == nullptr) {
      m_journey.problem = "no marker with a task is seen after task " + std::to_string(m_journey.stations.size());
      return std::nullopt;
    }
    const Task task = taskOf(ahead->payload);
    m_journey.stations.push_back(Station{ahead->name.empty() ? std::to_string(ahead->id) : ahead->name, ahead->payload,
                                         goal, m_robot.pose(), viewOf(message)});
    return task;
  }

  vpImage<vpRGBa> viewOf(const std::string &message) const
  {
    vpImage<vpRGBa> view = tutorial::markerOverlay(m_image, m_detector.getDetections(), robotsCamera());
    tutorial::drawText(view, message, vpImagePoint(10., 10.), vpColor::yellow);
    return view;
  }

  void follow(const FloorPose &goal)
  {
    Driver driver(goal);
    const std::size_t mostSteps = m_journey.steps.size() + static_cast<std::size_t>(longestLeg / samplingTime);
    while (const auto command = driver.next(m_belief.pose(), samplingTime)) {
      m_robot.obey(*command, samplingTime);
      m_belief.predict(*command, samplingTime);
      m_wheels = advanced(m_wheels, *command, samplingTime);
      look();
      if (m_journey.steps.size() > mostSteps) {
        m_journey.problem = "the place that marker \"" + m_journey.stations.back().marker +
                            "\" has sent the robot to " + "was not reached in " +
                            std::to_string(static_cast<int>(longestLeg)) + " s";
        return;
      }
    }
  }

  common::Room m_room;               //!< With its markers.
  Settings m_settings;               //!< What to do.
  TrueRobot m_robot;                 //!< As it is.
  Belief m_belief;                   //!< As it believes to be.
  FloorPose m_wheels;                //!< As it would believe without markers.
  vpMarkerSceneSimulator m_scene;    //!< Draws what it sees.
  vpDetectorCircleMarker m_detector; //!< Of markers.
  vpImage<unsigned char> m_image;    //!< What it sees.
  Journey m_journey;                 //!< So far.
};
} // namespace

Journey drive(const common::Room &room, const Settings &settings, const common::Progress &progress)
{
  Drive drive(room, settings);
  return drive.all(progress);
}
} // namespace navigation
