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
 * The command line of tutorial-circle-marker-detector.
 */

#include "command_line.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <system_error>

#include "../common/detection/image_file.h"
#include "../common/numbered_name.h"
#include "../common/parse.h"

namespace tutorial {
namespace {
// Better said before the images are read than after.
void checkPictureName(const std::string &name)
{
  const std::string known[] = {".png", ".jpg", ".jpeg", ".ppm", ".bmp", ".tif", ".tiff"};
  if (!name.empty() && std::find(std::begin(known), std::end(known), extensionOf(name)) == std::end(known)) {
    throw UsageError("--overlay \"" + name +
                     "\" does not say what kind of picture it is; end it with .png, for instance");
  }
}

void check(const Order &order)
{
  if (order.input.empty()) {
    throw UsageError("--input is empty; name an image, a video, a pattern or @list.txt");
  }
  if (order.first && order.last && *order.first > *order.last) {
    throw UsageError("--first is after --last; exchange them");
  }
  std::error_code ignored; // a file that is not there is none of the others
  for (const std::string &output : {order.overlay, order.json}) {
    for (const std::string &input : {order.input, order.cameraFile}) {
      if (!output.empty() && (output == input || std::filesystem::equivalent(output, input, ignored))) {
        throw UsageError("\"" + output + "\" is read and would be replaced; name another file to be written");
      }
    }
  }
  checkPictureName(order.overlay);
  const bool isSequence = order.input.front() == '@' || NumberedName::parse(order.input);
  if (!order.overlay.empty() && isSequence && !NumberedName::parse(order.overlay)) {
    throw UsageError("--overlay names one picture for many images; use a number in the name, overlay-%04d.png");
  }
}
} // namespace

Request parseCommandLine(int argc, const char *const argv[])
{
  Order order;
  DetectorOptions options;
  bool displayOff = false;
  CLI::App app("Finds circular markers in images: identity, both poses, covariance.\n"
               "Results are lines of JSON, one for each image, with z into the marker.",
               "tutorial-circle-marker-detector");
  app.add_option("--input", order.input,
                 "An image, a video, a pattern such as img%04d.png, or @list.txt with a path on each line")
      ->required();
  const auto notNegative = CLI::Range(0L, 999999999L);
  app.add_option("--first", order.first, "First number of the pattern, or frame of the video from 0")
      ->check(notNegative);
  app.add_option("--last", order.last, "Last number; with --first, images missing between are reported")
      ->check(notNegative);
  app.add_option("--intrinsic", order.cameraFile, "Camera, an XML file of ViSP with any of its models")->required();
  app.add_option("--camera-name", order.cameraName, "Name of the camera in that file")->required();
  options.addTo(app);
  app.add_option("--json", order.json, "File for the results; the standard output unless told");
  app.add_option("--overlay", order.overlay, "Pictures with what was found: a name, for sequences with a number, %04d");
  app.add_option("--debug", order.debug,
                 "Folder for pictures of what each room of the detector saw, with the reasons of what it refused, and "
                 "tables of them, made if needed; cpu_ms is then longer");
  app.add_flag("--display-off", displayOff, "Open no window; in the window a click goes on, a right click quits");
  app.footer("Lines have \"image\", \"width\", \"height\", \"cpu_ms\" (time of the process for detection and pose) and "
             "\"markers\".\nWhere a marker has one pose only, its \"cMo2\" is null and its \"log_odds\" 1.8e308.\nA "
             "frame of a "
             "video is named video.mp4#12. An image that cannot be read is reported and has "
             "no line; the program then ends with 1.");
  if (!parse(app, argc, argv)) {
    return Request{std::nullopt, app.help()};
  }
  order.detector = options.settings();
  order.display = !displayOff;
  check(order);
  return Request{order, ""};
}
} // namespace tutorial
