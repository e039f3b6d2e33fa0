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
 * The command line of tutorial-circle-marker-pbvs.
 */

#include "command_line.h"

#include <map>

#include "../common/parse.h"

namespace tutorial {
Request parseCommandLine(int argc, const char *const argv[])
{
  const std::map<std::string, MarkerChoice> choices = {
      {"circle", MarkerChoice::Circle}, {"apriltag", MarkerChoice::AprilTag}, {"both", MarkerChoice::Both}};
  Order order;
  std::string detector = "circle";
  bool displayOff = false;
  CLI::App app("Position-based visual servo of a simulated camera on a circular marker, an AprilTag or both.\n"
               "The camera starts at random and goes to 0.5 m in front of the object. With both, each marker is "
               "covered for a\npart of the way.",
               "tutorial-circle-marker-pbvs");
  app.add_option("--detector", detector, "circle, apriltag or both")
      ->check(CLI::IsMember({"circle", "apriltag", "both"}))
      ->capture_default_str();
  app.add_flag("--display-off", displayOff,
               "Open no windows; in the window a left click starts or stops, a right click quits");
  app.add_option("--output", order.folder, "Folder for servo.csv, servo.svg and overlay-*.png")->capture_default_str();
  app.add_option("--seed", order.seed, "Of the start and the noise")->check(wholeNumber())->capture_default_str();
  app.add_option("--distance", order.distance, "Distance of the start, metres; random from 0.5 to 4 unless told")
      ->check(numberIn(0.3, 100.));
  app.add_option("--runs", order.runs,
                 "Number of random starts, with the seeds from --seed on; writes runs.csv, and the rest for the worst")
      ->check(CLI::Range(1U, 100000U))
      ->capture_default_str();
  const CLI::Option *camera = app.add_option(
      "--intrinsic", order.cameraFile,
      "Camera, an XML file of ViSP; the reference camera unless told: 1280 x 960, px = py = 1600, u0 = 639.5, "
      "v0 = 479.5");
  const CLI::Option *name =
      app.add_option("--camera-name", order.cameraName, "Name of the camera in that file")->capture_default_str();
  app.footer("Ends with 0 only if every servo has brought the true pose within 1 mm and 0.1 degrees of the desired "
             "one.");
  if (!parse(app, argc, argv)) {
    return Request{std::nullopt, app.help()};
  }
  if (name->count() > 0 && camera->count() == 0) {
    throw UsageError("--camera-name names a camera of the file of --intrinsic; name that, too");
  }
  order.markers = choices.at(detector);
  order.display = !displayOff;
  return Request{order, ""};
}
} // namespace tutorial
