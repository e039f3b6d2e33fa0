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
 * The command line of tutorial-circle-marker-detector-live.
 */

#include "command_line.h"

#include "../common/numbered_name.h"
#include "../common/parse.h"

namespace tutorial {
namespace {
void check(const Order &order)
{
  if (!order.record.empty() && !NumberedName::parse(order.record)) {
    throw UsageError("--record takes a name with a number, such as sequence/img%04d.png");
  }
}

/*! Whether one of the arguments is this flag: it does without the options that are required otherwise. */
bool isAsked(const std::vector<std::string> &arguments, const std::string &flag)
{
  return std::find(arguments.begin(), arguments.end(), flag) != arguments.end();
}
} // namespace

Request parseCommandLine(int argc, const char *const argv[])
{
  Order order;
  CameraOptions camera;
  DetectorOptions detector;
  bool displayOff = false, listCamerasOnly = false;
  camera.source = "firewire";
  CLI::App app("Finds circular markers in the images of a camera: identity, both poses, covariance.\n"
               "Results are lines of JSON, one for each image, with z into the marker.",
               "tutorial-circle-marker-detector-live");
  camera.addTo(app);
  app.add_flag("--list-cameras", listCamerasOnly, "List the cameras and their modes, and end");
  app.add_option(
         "--intrinsic", order.cameraFile,
         "Camera, an XML file of ViSP with any of its models, for the whole image; a region of Format7 shifts it")
      ->required();
  app.add_option("--camera-name", order.cameraName, "Name of the camera in that file")->required();
  detector.addTo(app);
  app.add_option("--json", order.json, "File for the results; the standard output unless told");
  app.add_option("--record", order.record,
                 "Record the images, as sequence/img%04d.png, and their lines in poses.jsonl beside them; from the "
                 "first image, with a window when r or the left button is pressed");
  app.add_option("--count", order.count, "End after this number of images")->check(CLI::Range(1UL, 1000000000UL));
  app.add_option("--timeout", order.timeout, "Seconds without an image after which the program gives up")
      ->check(numberIn(0.1, 3600.))
      ->capture_default_str();
  app.add_flag("--all-images", order.allImages,
               "Use every image, in order, even if the camera waits; otherwise always the newest");
  app.add_flag("--display-off", displayOff, "Open no window, for use over SSH; Ctrl-C ends and keeps the results");
  app.footer(
      "Lines have \"image\", \"width\", \"height\", \"cpu_ms\" (processor time of detection and pose), \"time_s\" "
      "(when the image was\ntaken, Unix time), \"latency_ms\" (from then to the poses), \"missed\" (images that were "
      "lost before it) and \"markers\".\n"
      "In the window: left button record or stop, without --record quit; right button, q or Escape quit; space hold; "
      "r record or\nstop; 2 the second pose; u uncertainty; h these keys.\n"
      "Ends with 0, or with 1 if the camera failed or images came damaged.");
  const std::vector<std::string> given = reversedArguments(argc, argv);
  if (isAsked(given, "--list-cameras") && !isAsked(given, "--help") && !isAsked(given, "-h")) {
    return Request{std::nullopt, listCameras()};
  }
  if (!parse(app, argc, argv)) {
    return Request{std::nullopt, app.help()};
  }
  order.camera = camera.settings();
  order.detector = detector.settings();
  order.display = !displayOff;
  check(order);
  return Request{order, ""};
}
} // namespace tutorial
