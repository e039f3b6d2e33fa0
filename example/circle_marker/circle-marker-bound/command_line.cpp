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
 * Command line of circle-marker-bound.
 */

#include <algorithm>
#include <thread>

#include <visp3/circle_marker/vpCircleMarkerFamily.h>
#include <visp3/core/vpMath.h>

#include "../../../tutorial/circle_marker/common/camera_file.h"
#include "command_line.h"
#include "common/arguments.h"

namespace planner {
namespace {
/*! Options in the units people use; Settings has metres and radians. */
struct Raw
{
  std::string intrinsic, cameraName = "Camera", surround = "unknown";
  double focal = focalLength;
  double contrast = 190.;
  double xy = 0., z = 0., normal = 0., wrong = 0., sizeFor = 0.;
};

constexpr double millimetre = 1e-3;
constexpr double perCent = 0.01;

void addCamera(CLI::App &app, Settings &settings, Raw &raw)
{
  const std::string group = "Camera";
  auto *file = app.add_option("--intrinsic", raw.intrinsic, "Camera file of vpXmlParserCamera, any of its models")
                   ->check(CLI::ExistingFile)
                   ->group(group);
  app.add_option("--camera-name", raw.cameraName, "Name of the camera in that file")
      ->needs(file)
      ->capture_default_str()
      ->group(group);
  app.add_option("--focal", raw.focal, "Focal length, pixels, of a camera without distortion")
      ->check(numberIn(1., 1e6))
      ->excludes(file)
      ->capture_default_str()
      ->group(group);
  app.add_option("--width", settings.width, "Width of the image, pixels")
      ->check(CLI::Range(16u, 100000u))
      ->capture_default_str()
      ->group(group);
  app.add_option("--height", settings.height, "Height of the image, pixels")
      ->check(CLI::Range(16u, 100000u))
      ->capture_default_str()
      ->group(group);
}

void addMarker(CLI::App &app, Settings &settings, Raw &raw)
{
  const std::string group = "Marker";
  app.add_option("--family", settings.family, "Family of the marker")
      ->check(CLI::IsMember({"golay23", "bch31", "bch31r", "ring", "disc"}))
      ->capture_default_str()
      ->group(group);
  app.add_option("--id", settings.id, "Number of the marker; codes with more edges do better, by up to a fifth")
      ->check(CLI::Range(0, 1000000))
      ->capture_default_str()
      ->group(group);
  app.add_option("--ratio", settings.ratio, "Inner over outer diameter of a plain ring")
      ->check(numberIn(0., 0.98))
      ->capture_default_str()
      ->group(group);
  app.add_option("--size", settings.size, "Outer diameter of the ring, metres")
      ->check(numberIn(1e-4, 100.))
      ->capture_default_str()
      ->group(group);
  app.add_option("--surround", raw.surround, "Beyond the quiet zone of R/6: anything, or white paper")
      ->check(CLI::IsMember({"unknown", "white"}))
      ->capture_default_str()
      ->group(group);
}

void addImage(CLI::App &app, Settings &settings, Raw &raw)
{
  const std::string group = "Image";
  app.add_option("--blur", settings.photometry.blurSigma, "Gaussian blur, standard deviation, pixels")
      ->check(numberIn(0., 20.))
      ->capture_default_str()
      ->group(group);
  app.add_option("--defocus", settings.photometry.defocusRadius, "Disc of defocus beside it, radius, pixels; known")
      ->check(numberIn(0., 20.))
      ->capture_default_str()
      ->group(group);
  app.add_option("--contrast", raw.contrast, "Paper minus ink, grey levels")
      ->check(numberIn(1., 255.))
      ->capture_default_str()
      ->group(group);
  app.add_option("--noise", settings.photometry.noiseSigma,
                 "Noise, standard deviation, grey levels; that of rounding is added")
      ->check(numberIn(0., 100.))
      ->capture_default_str()
      ->group(group);
}

void addTable(CLI::App &app, Settings &settings)
{
  const std::string group = "Table";
  app.add_option("--angle", settings.angles, "Angles between normal and line of sight, degrees; several: 0,30,60")
      ->delimiter(',')
      ->check(numberIn(0., 88.))
      ->capture_default_str()
      ->group(group);
  app.add_option("--min-distance", settings.minDistance, "Nearest distance, metres")
      ->check(numberIn(1e-3, 1e4))
      ->capture_default_str()
      ->group(group);
  app.add_option("--max-distance", settings.maxDistance, "Farthest distance, metres")
      ->check(numberIn(1e-3, 1e4))
      ->capture_default_str()
      ->group(group);
  app.add_option("--rows", settings.rows, "Number of distances")
      ->check(CLI::Range(1u, 10000u))
      ->capture_default_str()
      ->group(group);
  app.add_option("--jobs", settings.jobs, "Threads")->check(CLI::Range(1u, 256u))->capture_default_str()->group(group);
  app.add_option("--output", settings.output, "Folder for bound.csv, bound.json and the plot bound.svg; made if needed")
      ->group(group);
}

void addWanted(CLI::App &app, Settings &settings, Raw &raw)
{
  const std::string group = "Wanted accuracy (answers: farthest distance, least size)";
  app.add_option("--accuracy-xy", raw.xy, "Standard deviation across the line of sight, x and y each, mm")
      ->check(numberIn(1e-9, 1e9))
      ->group(group);
  app.add_option("--accuracy-z", raw.z, "Standard deviation of the depth, mm")
      ->check(numberIn(1e-9, 1e9))
      ->group(group);
  app.add_option("--accuracy-normal", raw.normal, "Root mean square angle of the normal, degrees")
      ->check(numberIn(1e-9, 180.))
      ->group(group);
  app.add_option("--accuracy-odds", raw.wrong, "Share of images in which the mirrored pose fits better, per cent")
      ->check(numberIn(1e-9, 50.))
      ->group(group);
  app.add_option("--size-for", raw.sizeFor, "Distance for which the least size is sought, metres; else --max-distance")
      ->check(numberIn(1e-3, 1e4))
      ->group(group);
  app.add_option("--reserve", settings.reserve, "Errors of the estimator over the bound, to allow for")
      ->check(numberIn(1., 100.))
      ->capture_default_str()
      ->group(group);
}

void readIntrinsic(const Raw &raw, const CLI::App &app, Settings &settings)
{
  if (raw.intrinsic.empty()) {
    settings.camera.initPersProjWithoutDistortion(raw.focal, raw.focal, 0.5 * (settings.width - 1.),
                                                  0.5 * (settings.height - 1.));
    return;
  }
  const bool hasSize = app.count("--width") > 0 && app.count("--height") > 0;
  const tutorial::NamedCamera camera =
      tutorial::readCamera(raw.intrinsic, raw.cameraName, hasSize ? settings.width : 0, hasSize ? settings.height : 0);
  settings.camera = camera.parameters;
  if (!hasSize && camera.width > 0) {
    settings.width = camera.width;
    settings.height = camera.height;
  }
}

void convert(const Raw &raw, const CLI::App &app, Settings &settings)
{
  const auto given = [&app](const char *option, double value) {
    return app.count(option) > 0 ? std::optional<double>(value) : std::nullopt;
  };
  settings.wanted = {given("--accuracy-xy", millimetre * raw.xy), given("--accuracy-z", millimetre * raw.z),
                     given("--accuracy-normal", vpMath::rad(raw.normal)),
                     given("--accuracy-odds", perCent * raw.wrong)};
  settings.sizeFor = given("--size-for", raw.sizeFor);
  settings.photometry.paper = settings.photometry.ink + raw.contrast; // Only the difference counts.
  settings.surround = raw.surround == "white" ? vpMarkerPoseBound::WHITE_SURROUND : vpMarkerPoseBound::UNKNOWN_SURROUND;
  if (settings.minDistance > settings.maxDistance) {
    throw UsageError("--min-distance is greater than --max-distance; exchange them");
  }
  const auto family = vpCircleMarkerFamily::fromName(settings.family);
  if (family.isCoded() && static_cast<unsigned int>(settings.id) >= family.getNbIds()) {
    throw UsageError("--id " + std::to_string(settings.id) + " is not in " + settings.family + "; use 0 to " +
                     std::to_string(family.getNbIds() - 1));
  }
  if (settings.family == "disc" && settings.wanted.wrong) {
    throw UsageError("--accuracy-odds: one image cannot tell the two poses of a disc apart; use another family");
  }
}
} // namespace

Request parseCommandLine(int argc, const char *const argv[])
{
  Settings settings;
  settings.jobs = std::max(1u, std::thread::hardware_concurrency());
  Raw raw;
  CLI::App app(
      "How well the pose of a circular marker can be known, whatever the method, and so how large a marker must\n"
      "be and how far it reaches: the Cramer-Rao bound of the pose for a camera, a marker, blur, contrast and\n"
      "noise, the levels and the blur unknown. The detector of this project comes close to it.",
      "circle-marker-bound");
  addCamera(app, settings, raw);
  addMarker(app, settings, raw);
  addImage(app, settings, raw);
  addTable(app, settings);
  addWanted(app, settings, raw);
  app.footer(
      "The marker is in the middle of the image, tilted about the camera's x axis. The table has for each angle and\n"
      "distance the ring's diameter in pixels, the standard deviations of the centre (x, y, z), the root mean square\n"
      "angle of the normal, how far the mirrored pose is separated (standard deviations), and the share of images\n"
      "in which it fits better than the true one (Phi(-separation / 2)); at angle 0 the two are one. At angle 0 and a\n"
      "great distance the normal's bound, which is of first order, is too large: what is lost is second order.\n"
      "(off): the marker with its quiet zone does not fit into the image. A row takes 0.1 to 1 s on one core.\n\n"
      "  circle-marker-bound --size 0.18 --angle 30 --accuracy-z 5 --accuracy-odds 1 --output plan\n"
      "  circle-marker-bound --intrinsic camera.xml --camera-name Camera --angle 20,45 --accuracy-xy 0.1 --size-for 8");
  if (!parse(app, argc, argv)) {
    return Request{std::nullopt, app.help()};
  }
  if (app.count("--output") > 0 && settings.output.empty()) {
    throw UsageError("--output is empty; name a folder");
  }
  readIntrinsic(raw, app, settings);
  convert(raw, app, settings);
  return Request{settings, ""};
}
} // namespace planner
