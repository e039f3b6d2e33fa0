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

#include <cmath>
#include <sstream>

#include <CLI/CLI.hpp>
#include <visp3/core/vpException.h>

#include "../common/numbered_name.h"

namespace tutorial {
namespace {
std::vector<std::string> splitAtCommas(const std::string &text)
{
  std::vector<std::string> parts;
  std::istringstream in(text);
  std::string part;
  while (std::getline(in, part, ',')) {
    parts.push_back(part);
  }
  return parts;
}

std::vector<vpCircleMarkerFamily> familiesOf(const std::string &names, const std::optional<double> &ratio)
{
  std::vector<vpCircleMarkerFamily> families;
  bool ratioUsed = false;
  for (const std::string &name : splitAtCommas(names)) {
    const vpCircleMarkerFamily family = vpCircleMarkerFamily::fromName(name);
    const bool isRing = family.getType() == vpCircleMarkerFamily::RING;
    ratioUsed = ratioUsed || isRing;
    families.push_back(isRing && ratio ? vpCircleMarkerFamily::ring(*ratio) : family);
  }
  if (families.empty()) {
    throw UsageError("--family names no family; use golay23, bch31, bch31r, ring or disc");
  }
  if (ratio && !ratioUsed) {
    throw UsageError("--ratio is for the family ring; leave it out or add --family ring");
  }
  return families;
}

double checkedSize(double size, const std::string &option)
{
  if (!(size > 0.) || !std::isfinite(size)) {
    throw UsageError(option + " is the outer diameter of the ring in metres and must be positive, for instance 0.18");
  }
  return size;
}

/*! Sizes as in 3:0.1,4:0.2. */
std::map<int, double> sizesOf(const std::string &text)
{
  std::map<int, double> sizes;
  for (const std::string &part : splitAtCommas(text)) {
    std::istringstream in(part);
    int id = 0;
    char colon = 0;
    double size = 0.;
    if (!(in >> id >> colon >> size) || colon != ':' || id < 0 || in.peek() != std::istringstream::traits_type::eof()) {
      throw UsageError("--sizes takes ids and diameters in metres, as 3:0.1,4:0.2, not \"" + part + "\"");
    }
    sizes[id] = checkedSize(size, "--sizes");
  }
  return sizes;
}

void check(const Order &order)
{
  if (order.first && order.last && *order.first > *order.last) {
    throw UsageError("--first is after --last; exchange them");
  }
  const bool isSequence = order.input.front() == '@' || NumberedName::parse(order.input);
  if (!order.overlay.empty() && isSequence && !NumberedName::parse(order.overlay)) {
    throw UsageError("--overlay names one picture for many images; use a number in the name, overlay-%04d.png");
  }
}
} // namespace

Request parseCommandLine(int argc, const char *const argv[])
{
  Order order;
  std::string families, sizes;
  std::optional<double> ratio;
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
  app.add_option("--size", order.size, "Outer diameter of the black ring, metres")->required();
  app.add_option("--sizes", sizes, "Diameters of single markers, as 3:0.1,4:0.2");
  app.add_option(
      "--family", families,
      "golay23, bch31, bch31r, ring, disc, or several with commas; golay23 or those of --config unless told");
  app.add_option("--ratio", ratio, "Inner over outer radius of the family ring");
  app.add_option("--hamming", order.hamming, "Most sectors of a code that are corrected")->check(CLI::Range(0U, 5U));
  app.add_option("--config", order.configFile, "Settings of vpDetectorCircleMarker, JSON; other options go before it");
  app.add_option("--nthreads", order.threads, "Number of threads")->check(CLI::Range(1U, 1024U));
  app.add_option("--json", order.json, "File for the results; the standard output unless told");
  app.add_option("--overlay", order.overlay, "Pictures with what was found: a name, for sequences with a number, %04d");
  app.add_flag("--display-off", displayOff, "Open no window; in the window a click goes on, a right click quits");
  app.footer("Lines have \"image\", \"width\", \"height\", \"cpu_ms\" (time of the process for detection and pose) and "
             "\"markers\".\nA frame of a video is named video.mp4#12. An image that cannot be read is reported and has "
             "no line; the program then ends with 1.");
  try {
    std::vector<std::string> reversed = reversedArguments(argc, argv);
    app.parse(reversed);
    checkedSize(order.size, "--size");
    if (!families.empty() || ratio || order.configFile.empty()) {
      order.families = familiesOf(families.empty() ? (ratio ? "ring" : "golay23") : families, ratio);
    }
    order.sizes = sizesOf(sizes);
    order.display = !displayOff;
    check(order);
    return Request{order, ""};
  }
  catch (const CLI::CallForHelp &) {
    return Request{std::nullopt, app.help()};
  }
  catch (const CLI::ParseError &e) {
    throw UsageError(std::string(e.what()) + "; see --help");
  }
  catch (const vpException &e) {
    throw UsageError(e.what());
  }
}
} // namespace tutorial
