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
 * The command line of tutorial-circle-marker-pbvs-live.
 */

#include "command_line.h"

#include "../common/parse.h"

namespace tutorial {
namespace {
constexpr double degree = M_PI / 180.;

void check(const Order &order)
{
  if (order.camera && order.cameraFile.empty()) {
    throw UsageError("a real camera needs its parameters; add --intrinsic camera.xml --camera-name NAME");
  }
}
} // namespace

Request parseCommandLine(int argc, const char *const argv[])
{
  Order order;
  CameraOptions camera;
  DetectorOptions detector;
  bool displayOff = false;
  // What most of ViSP's robots allow unless told otherwise, and a person can step back from.
  double speed = 0.2, turn = 40., acceptedDistance = 1., acceptedAngle = 0.1;
  camera.source = "simulator";
  detector.size = 0.12;
  CLI::App app("Position-based visual servo of a robot that carries a camera: the camera goes in front of a circular "
               "marker.\nThe robot is the one that user_robot.cpp makes; as it comes, a simulated one that carries the "
               "simulated camera.",
               "tutorial-circle-marker-pbvs-live");
  camera.addTo(app, "simulator (the stand-in robot's camera), ");
  app.add_option("--intrinsic", order.cameraFile,
                 "Camera, an XML file of ViSP with any of its models; the reference camera for the simulator");
  app.add_option("--camera-name", order.cameraName, "Name of the camera in that file")->capture_default_str();
  detector.addTo(app);
  app.get_option("--size")->required(false)->capture_default_str();
  app.add_option("--id", order.id, "Id of the marker; any unless told")->check(CLI::Range(0, 1000000));
  app.add_option("--robot-address", order.robotAddress, "Handed to the robot that you have supplied");
  app.add_option("--distance", order.distance, "Desired distance of the marker, metres")
      ->check(numberIn(0.05, 20.))
      ->capture_default_str();
  app.add_option("--max-speed", speed, "Greatest speed of the camera, m/s")
      ->check(numberIn(0.001, 2.))
      ->capture_default_str();
  app.add_option("--max-turn", turn, "Greatest turn of the camera, degrees/s")
      ->check(numberIn(0.1, 90.))
      ->capture_default_str();
  app.add_option("--accept-distance", acceptedDistance, "Accepted error of the place, mm")
      ->check(positiveNumber())
      ->capture_default_str();
  app.add_option("--accept-angle", acceptedAngle, "Accepted error of the rotation, degrees")
      ->check(positiveNumber())
      ->capture_default_str();
  app.add_option("--most-images", order.mostImages, "Images after which the servo gives up")
      ->check(CLI::Range(10U, 1000000U))
      ->capture_default_str();
  app.add_option("--timeout", order.timeout, "Seconds without an image after which the program gives up")
      ->check(numberIn(0.1, 3600.))
      ->capture_default_str();
  app.add_option("--output", order.folder, "Folder for servo.csv, servo.svg and overlay-*.png")->capture_default_str();
  app.add_flag("--display-off", displayOff,
               "Open no windows and start at once; in the window a left click starts or stops, a right click quits");
  app.footer(
      "The servo goes on with the marker that it has seen first. The robot stands still while that is not seen and "
      "after 0.2 s\nwithout an image. Ends with 0 only if the marker was seen where it should be in ten images in "
      "a row, within half of the\naccepted errors; the simulated camera is judged by its true pose.");
  if (!parse(app, argc, argv)) {
    return Request{std::nullopt, app.help()};
  }
  if (camera.source != "simulator") {
    order.camera = camera.settings();
  }
  order.detector = detector.settings();
  order.limits = ServoLimits{speed, turn * degree};
  order.acceptedDistance = 1e-3 * acceptedDistance;
  order.acceptedAngle = acceptedAngle * degree;
  order.display = !displayOff;
  check(order);
  return Request{order, ""};
}
} // namespace tutorial
