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
 * Command line of circle-marker-simulator.
 */

#include "command_line.h"

#include "circle_marker/common/camera_file.h"
#include "circle_marker/common/numbered_name.h"
#include "common/arguments.h"
#include "controls.h"

namespace simulator {
namespace {
using common::UsageError;
using common::wholeNumber;

void readCamera(const std::string &file, const std::string &name, Order &order)
{
  if (file.empty()) {
    // Fewer pixels than the reference camera, to be quick, and 67 degrees of view, to see some of a room.
    order.width = 800;
    order.height = 600;
    order.camera.initPersProjWithoutDistortion(600., 600., 399.5, 299.5);
    return;
  }
  const tutorial::NamedCamera camera = tutorial::readCamera(file, name, 0, 0);
  if (camera.width == 0 || camera.height == 0) {
    throw UsageError("\"" + file + "\" does not say the size of the images; add image_width and image_height");
  }
  order.camera = camera.parameters;
  order.width = camera.width;
  order.height = camera.height;
}

std::string footer()
{
  std::string text = "In the window:\n";
  for (const std::string &line : keyHelp()) {
    text += "  " + line + "\n";
  }
  return text + "In a script, one on each line: key w, key N 5 (five times), drag 1 120 -40 (button, pixels), wait 10 "
                "(images),\nshot name.png; # begins a comment. Without a window (--display-off) a script is needed.";
}
} // namespace

Request parseCommandLine(int argc, const char *const argv[])
{
  Order order;
  std::string database, intrinsic, cameraName = "Camera", script;
  std::string savedRoom;
  bool displayOff = false;
  CLI::App app("A camera to be moved through a room with circular markers, by mouse and keys: what the detector finds, "
               "and its true errors.",
               "circle-marker-simulator");
  app.add_option(
      "--database", database,
      "Markers of the room, with poses: JSON of vpCircleMarkerDatabase; ten markers on four walls unless told");
  app.add_option("--save-room", savedRoom, "Write the database of the room to a file, and end");
  app.add_option("--intrinsic", intrinsic, "Camera file of ViSP; 800 x 600 pixels, f = 600 pixels unless told");
  app.add_option("--camera-name", cameraName, "Name of the camera in that file")->capture_default_str();
  app.add_option("--script", script, "Keys and movements of the mouse from a file; the program ends after them");
  app.add_option("--json", order.json, "File for a line for each image: pose, state, true errors");
  app.add_option("--shots", order.shots, "Pictures that the key p saves")->capture_default_str();
  app.add_option("--distance", order.distance, "Distance from the marker at which the servo ends, metres")
      ->check(common::numberIn(0.2, 10.))
      ->capture_default_str();
  app.add_option("--seed", order.seed, "Of the noise")->check(wholeNumber())->capture_default_str();
  app.add_flag("--display-off", displayOff, "Open no window, for use over SSH");
  app.footer(footer());
  if (!common::parse(app, argc, argv)) {
    return Request{std::nullopt, app.help()};
  }
  order.room = database.empty() ? common::makeRoom() : common::readRoom(database);
  if (!savedRoom.empty()) {
    order.room.markers.save(savedRoom);
    return Request{std::nullopt, ""};
  }
  readCamera(intrinsic, cameraName, order);
  order.display = !displayOff;
  order.hasScript = !script.empty();
  if (!order.hasScript && !order.display) {
    throw UsageError("without a window nothing moves the camera; add --script FILE, or leave out --display-off");
  }
  if (!tutorial::NumberedName::parse(order.shots)) {
    throw UsageError("--shots takes a name with a number, such as shot%04d.png");
  }
  if (order.hasScript) {
    order.script = readScript(script);
  }
  return Request{order, ""};
}
} // namespace simulator
