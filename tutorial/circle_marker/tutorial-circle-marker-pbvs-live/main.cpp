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
 * Position-based visual servo of a robot that carries a camera, on a circular marker.
 */

/*!
  \example tutorial-circle-marker-pbvs-live/main.cpp
  Position-based visual servo of a robot that carries a camera, on a circular marker.
*/

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <visp3/robot/vpSimulatorCamera.h>

#include "../common/cameras/frame_feed.h"
#include "../common/cameras/region_camera.h"
#include "../common/interruption.h"
#include "../common/program.h"
#include "../common/servo/feed_eyes.h"
#include "../common/servo/live_view.h"
#include "../common/servo/servo_loop.h"
#include "../common/servo/servo_progress.h"
#include "../common/servo/servo_report.h"
#include "../common/visp_names.h"
#include "user-robot/user_robot.h"
#include "command_line.h"

using namespace tutorial;

namespace {
const Program program("tutorial-circle-marker-pbvs-live");

/*! The camera, whichever it is, and what the servo must know of it. */
struct Vision
{
  std::optional<FrameFeed> feed; //!< A real camera's images.
  std::unique_ptr<ServoEyes> eyes;
  ServoCamera camera;
  bool isLive = false; //!< Whether the robot goes on while an image is worked on.
};

/*! The marker with its quiet zone, in the middle of the object. */
ServoObject objectOf(const Order &order)
{
  ServoObject object;
  object.circle = MountedMarker{order.id, order.detector.size, order.detector.size * 7. / 6., vpHomogeneousMatrix()};
  return object;
}

/*! The simulated camera shows marker 5 where any is asked for. */
ServoObject simulatedObject(const Order &order)
{
  ServoObject object = objectOf(order);
  object.circle->id = order.id == anyId ? 5 : order.id;
  return object;
}

void openSimulatedCamera(const Order &order, vpRobot &robot, Vision &vision)
{
  const auto *standIn = dynamic_cast<const vpSimulatorCamera *>(&robot);
  if (standIn == nullptr) {
    throw UsageError("the simulated camera is for the robot that stands in; for yours, add --source with its camera");
  }
  const std::vector<vpCircleMarkerFamily> &families = order.detector.families;
  if (!families.empty() && (families.size() > 1 || families.front().getName() != "golay23")) {
    throw UsageError("the simulated camera shows a golay23 marker; leave out --family, or add --source");
  }
  vision.camera = servoCamera(order.cameraFile, order.cameraName);
  constexpr std::uint64_t seed = 1; // of the noise
  vision.eyes = std::make_unique<SimulatedEyes>(vision.camera, simulatedObject(order), *standIn,
                                                desiredPose(order.distance), seed, order.display);
}

void openRealCamera(const Order &order, vpRobot &robot, Vision &vision)
{
  RegionCamera parameters(order.cameraFile, order.cameraName);
  std::unique_ptr<FrameSource> source = openFrameSource(*order.camera);
  const ImageRegion region = source->region();
  vision.isLive = source->isLive();
  const auto use = vision.isLive ? FrameFeed::Use::Newest : FrameFeed::Use::All;
  vision.feed.emplace(std::move(source), use);
  vision.eyes = std::make_unique<FeedEyes>(*vision.feed, order.camera->name, order.timeout, isInterrupted,
                                           [](const std::string &message) { program.complain(message); });
  // The first image says how large they are.
  const std::optional<ServoView> first = vision.eyes->look([] {});
  if (!first) {
    throw SourceError("no image came from " + order.camera->name);
  }
  const unsigned int width = first->image.getWidth(), height = first->image.getHeight();
  vision.camera = ServoCamera{parameters.forImage(width, height, region), width, height};
  for (const std::string &note : parameters.newNotes()) {
    program.complain(note);
  }
  if (dynamic_cast<const vpSimulatorCamera *>(&robot) != nullptr) {
    program.complain(
        "no robot was supplied: the velocities are computed and written, and nothing moves; see user_robot.h");
  }
}

ServoGoal goalOf(const Order &order, const Vision &vision)
{
  ServoGoal goal;
  goal.camera = vision.camera;
  goal.object = objectOf(order);
  goal.cdMo = desiredPose(order.distance);
  goal.detector = order.detector;
  goal.limits = order.limits;
  goal.acceptedDistance = order.acceptedDistance;
  goal.acceptedAngle = order.acceptedAngle;
  goal.mostImages = order.mostImages;
  if (vision.isLive) {
    constexpr int longestSearch = 200; // milliseconds
    goal.detector.timeout = longestSearch;
  }
  return goal;
}

/*! Says so if a marker cannot tell how far it is turned. */
void warnOfSpin(const Order &order)
{
  const std::vector<vpCircleMarkerFamily> &families = order.detector.families;
  if (std::any_of(families.begin(), families.end(),
                  [](const vpCircleMarkerFamily &family) { return !family.isCoded(); })) {
    program.complain("a ring or disc without a code does not tell how far it is turned about its normal: that angle of "
                     "the pose is a convention, and what the camera turns by about it means nothing");
  }
}

ServoRecord run(const Order &order, const ServoGoal &goal, ServoEyes &eyes, vpRobot &robot)
{
  std::optional<LiveView> view;
  if (order.display) {
    try {
      view.emplace(goal);
    }
    catch (const vpException &e) {
      throw UsageError(std::string("no window can be opened (") + e.what() +
                       "), and without a window nothing starts by a click; --display-off starts at once");
    }
  }
  std::optional<ServoProgress> progress;
  if (!view) {
    progress.emplace(goal);
  }
  const ServoRecord record = runServo(eyes, robot, goal, [&](const vpImage<unsigned char> &I, const ServoStep &step) {
    if (isInterrupted()) {
      return ServoWish::Quit;
    }
    if (progress) {
      progress->show(step);
    }
    return view ? view->show(I, step) : ServoWish::Go;
  });
  progress.reset();
  const bool quitByUser = isInterrupted() || record.reason.find("click") != std::string::npos;
  if (view && !quitByUser) {
    view->showEnd(record);
  }
  return record;
}

void print(const ServoRecord &record)
{
  std::cout << record.steps.size() << " images";
  if (!record.steps.empty() && record.steps.back().error()) {
    const ServoError &error = *record.steps.back().error();
    std::cout << ", " << (record.steps.back().trueError ? "true" : "measured") << " pose at the end " << std::fixed
              << std::setprecision(3) << 1e3 * error.distance() << " mm and " << std::setprecision(4)
              << error.angle() * 180. / M_PI << " deg from the desired one";
  }
  std::cout << ": " << (record.converged ? "converged" : "not converged, " + record.reason) << std::endl;
}

/*! \return Whether the servo has converged. */
bool carryOut(const Order &order)
{
  prepareReport(order.folder);
  const std::unique_ptr<vpRobot> robot = makeUserRobot(order.robotAddress);
  Vision vision;
  if (order.camera) {
    openRealCamera(order, *robot, vision);
  }
  else {
    openSimulatedCamera(order, *robot, vision);
  }
  warnOfSpin(order);
  const ServoGoal goal = goalOf(order, vision);
  const ServoRecord record = run(order, goal, *vision.eyes, *robot);
  print(record);
  writeReport(order.folder, goal, record);
  if (!record.converged) {
    program.complain("the servo has not reached the desired pose: " + record.reason);
  }
  return record.converged;
}
} // namespace

int main(int argc, const char *argv[])
{
  return program.run(parseCommandLine, argc, argv, [](const Order &order) {
    watchInterruption();
    return carryOut(order) ? 0 : 1;
  });
}
