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
 * Command line of circle-marker-calibrate.
 */

#include "command_line.h"

#include "circle_marker/common/camera_file.h"
#include "circle_marker/common/detection/detector_options.h"
#include "circle_marker/common/numbered_name.h"
#include "common/arguments.h"
#include "common/reference_camera.h"

namespace calibrate {
namespace {
using common::numberIn;
using common::UsageError;
using common::wholeNumber;

/*! The arguments as they were given. */
struct Raw
{
  std::string target, sheet, models = "plain,distortion";
  int columns = 0, rows = 0;
  double spacing = 0., diameter = 0.;
  std::string truth, truthName = "Camera";
  std::vector<double> tilts{10., 45.};
  bool displayOff = false;
};

void addTarget(CLI::App &app, Raw &raw)
{
  const std::string group = "Target";
  app.add_option(
         "--target", raw.target,
         "chessboard, circles (rows and columns of discs), asymmetric (every second row shifted), or markers (a "
         "sheet of circle-marker-create)")
      ->check(CLI::IsMember({"chessboard", "circles", "asymmetric", "markers"}))
      ->group(group);
  app.add_option("--columns", raw.columns, "Discs in a row; inner corners in a row of a chessboard")
      ->check(CLI::Range(2, 200))
      ->group(group);
  app.add_option("--rows", raw.rows, "Rows of discs or of inner corners")->check(CLI::Range(2, 200))->group(group);
  app.add_option("--spacing", raw.spacing,
                 "Distance of neighbours, metres; asymmetric: distance of two rows, half of that of discs in a row")
      ->check(common::numberIn(1e-5, 100.))
      ->group(group);
  app.add_option("--diameter", raw.diameter, "Diameter of the discs, metres")
      ->check(common::numberIn(1e-5, 100.))
      ->group(group);
  app.add_option("--sheet", raw.sheet,
                 "markers: file with the lines that circle-marker-create wrote to its standard output for that page")
      ->group(group);
}

void addPictures(CLI::App &app, Order &order, Raw &raw, tutorial::CameraOptions &camera)
{
  PictureOrder &pictures = order.pictures;
  std::string group = "Pictures";
  app.add_option("--input", pictures.input, "An image, a video, img%04d.png, or @list.txt with a path on each line")
      ->group(group);
  app.add_option("--first", pictures.first, "First number of --input")->check(wholeNumber())->group(group);
  app.add_option("--last", pictures.last, "Last number of --input")->check(wholeNumber())->group(group);
  group = "Live camera";
  CLI::App options;
  camera.addTo(options);
  camera.addTo(app);
  for (const CLI::Option *option : options.get_options()) {
    if (option->get_name() != "--help" && option->get_name() != "-h,--help") {
      app.get_option(option->get_name())->group(group);
    }
  }
  app.add_option("--views", pictures.wanted, "Views to take; one is taken when the target has moved and stands still")
      ->check(CLI::Range(3U, 1000U))
      ->capture_default_str()
      ->group(group);
  app.add_option("--timeout", pictures.timeout, "Seconds without an image after which the camera is given up")
      ->check(numberIn(0.1, 3600.))
      ->capture_default_str()
      ->group(group);
  app.add_flag("--display-off", raw.displayOff, "Open no window, for use over SSH; Ctrl-C ends with the views so far")
      ->group(group);
  group = "Simulated camera";
  app.add_option("--simulate", pictures.simulated, "Number of simulated pictures of the target, in random poses")
      ->check(CLI::Range(1U, 1000U))
      ->group(group);
  app.add_option("--truth", raw.truth, "Camera file of ViSP of the simulated camera; data/camera.xml's unless told")
      ->group(group);
  app.add_option("--truth-name", raw.truthName, "Name of the camera in that file")->capture_default_str()->group(group);
  app.add_option("--tilts", raw.tilts, "Least and greatest tilt of the target, degrees")
      ->expected(2)
      ->check(common::numberIn(0., 70.))
      ->capture_default_str()
      ->group(group);
  app.add_option("--seed", order.simulation.seed, "Of the poses and the noise")
      ->check(wholeNumber())
      ->capture_default_str()
      ->group(group);
  app.add_option("--save-views", order.savedViews,
                 "Save the pictures that are used, live or simulated, as views/img%04d.png")
      ->group(group);
}

void addResults(CLI::App &app, Order &order, Raw &raw)
{
  const std::string group = "Results";
  app.add_option("--model", raw.models, "Camera models, with commas: plain, distortion, kannala-brandt")
      ->capture_default_str()
      ->group(group);
  app.add_option("--output", order.output, "Camera file to write, as ViSP's vpXmlParserCamera does; all models")
      ->group(group);
  app.add_option("--camera-name", order.cameraName, "Name of the camera in that file")
      ->capture_default_str()
      ->group(group);
  app.add_option("--json", order.json, "File for all numbers, with standard deviations")->group(group);
  app.add_option("--residuals", order.residuals, "Picture of the residuals, SVG")->group(group);
  app.add_flag("--compare-visp", order.compareVisp, "Calibrate with ViSP's vpCalibration on the same pictures as well")
      ->group(group);
  app.add_option("--convert", order.convert,
                 "Instead of calibrating, write --output from a YAML camera file of OpenCV or ROS")
      ->group(group);
}

void needs(bool isGiven, const std::string &what, const std::string &target)
{
  if (!isGiven) {
    throw UsageError("the target " + target + " needs " + what);
  }
}

Target targetOf(const Raw &raw)
{
  if (raw.target.empty()) {
    throw UsageError("no target is named; add --target chessboard, circles, asymmetric or markers");
  }
  if (raw.target == "markers") {
    needs(!raw.sheet.empty(), "--sheet, the lines that circle-marker-create wrote", raw.target);
    return readSheet(raw.sheet);
  }
  needs(raw.columns > 0 && raw.rows > 0, "--columns and --rows", raw.target);
  needs(raw.spacing > 0., "--spacing in metres", raw.target);
  if (raw.target == "chessboard") {
    return makeGrid(TargetKind::Chessboard, raw.columns, raw.rows, raw.spacing, 0.);
  }
  needs(raw.diameter > 0., "--diameter in metres: the centre of a disc's image depends on it", raw.target);
  const bool isAsymmetric = raw.target == "asymmetric";
  const double nearest = (isAsymmetric ? std::sqrt(2.) : 1.) * raw.spacing;
  if (raw.diameter >= nearest) {
    throw UsageError("discs of that --diameter overlap at that --spacing; both are in metres");
  }
  return makeGrid(isAsymmetric ? TargetKind::Asymmetric : TargetKind::Grid, raw.columns, raw.rows, raw.spacing,
                  raw.diameter);
}

std::vector<LensModel> modelsOf(const std::string &text)
{
  std::vector<LensModel> models;
  for (const std::string &name : tutorial::splitAtCommas(text)) {
    bool isKnown = false;
    for (const LensModel model : {LensModel::Plain, LensModel::Distortion, LensModel::KannalaBrandt}) {
      if (nameOf(model) == name) {
        models.push_back(model);
        isKnown = true;
      }
    }
    if (!isKnown || std::count(models.begin(), models.end(), models.back()) > 1) {
      throw UsageError("--model takes plain, distortion and kannala-brandt, each once, not \"" + name + "\"");
    }
  }
  if (models.empty()) {
    throw UsageError("--model is empty; it takes plain, distortion and kannala-brandt");
  }
  return models;
}

void readTruth(const Raw &raw, SimulationOrder &simulation)
{
  if (raw.tilts[0] > raw.tilts[1]) {
    throw UsageError("--tilts takes the least tilt first");
  }
  simulation.leastTilt = raw.tilts[0];
  simulation.mostTilt = raw.tilts[1];
  simulation.camera = common::referenceCamera();
  simulation.width = common::imageWidth;
  simulation.height = common::imageHeight;
  if (!raw.truth.empty()) {
    const tutorial::NamedCamera camera = tutorial::readCamera(raw.truth, raw.truthName, 0, 0);
    if (camera.width == 0 || camera.height == 0) {
      throw UsageError("\"" + raw.truth + "\" does not say the size of the images");
    }
    simulation.camera = camera.parameters;
    simulation.width = camera.width;
    simulation.height = camera.height;
  }
}

void check(const Order &order)
{
  const PictureOrder &pictures = order.pictures;
  const int sources = (pictures.input.empty() ? 0 : 1) + (pictures.camera ? 1 : 0) + (pictures.simulated > 0 ? 1 : 0);
  if (sources != 1) {
    throw UsageError(sources == 0 ? "there are no pictures; add --input, --source or --simulate"
                                  : "--input, --source and --simulate exclude each other");
  }
  if (!order.savedViews.empty() && !tutorial::NumberedName::parse(order.savedViews)) {
    throw UsageError("--save-views takes a name with a number, such as views/img%04d.png");
  }
  if (!order.savedViews.empty() && !pictures.input.empty()) {
    throw UsageError("--save-views is for --source and --simulate: the pictures of --input are files already");
  }
}

void fill(Order &order, const Raw &raw, const tutorial::CameraOptions &camera)
{
  order.models = modelsOf(raw.models);
  if (!order.convert.empty()) {
    if (order.output.empty()) {
      throw UsageError("--convert needs --output, the camera file to write");
    }
    return;
  }
  if (!camera.source.empty()) {
    order.pictures.camera = camera.settings();
  }
  order.pictures.display = !raw.displayOff;
  check(order);
  readTruth(raw, order.simulation);
  order.target = targetOf(raw);
}
} // namespace

Request parseCommandLine(int argc, const char *const argv[])
{
  Order order;
  order.cameraName = "Camera";
  Raw raw;
  tutorial::CameraOptions camera;
  CLI::App app(
      "Calibrates a camera from pictures of a flat target: focal lengths, principal point and distortion, with "
      "their standard\ndeviations. The centre of a circle's image is not the image of the circle's centre: that "
      "is taken into account.",
      "circle-marker-calibrate");
  addTarget(app, raw);
  addPictures(app, order, raw, camera);
  addResults(app, order, raw);
  app.footer(
      "Ten pictures or more, the target large and tilted by 20 to 45 degrees to all sides, and in all corners of the "
      "image. Views that\ndo not constrain the camera are refused with the reason (status 1). In the live window: "
      "space or left click takes a view,\nright click or q ends with the views so far.\n"
      "Example: circle-marker-create --ids 0-19 --size 0.03 --per-sheet auto --output sheet.pdf > sheet.jsonl\n"
      "         circle-marker-calibrate --target markers --sheet sheet.jsonl --input img%02d.png --output camera.xml");
  if (!common::parse(app, argc, argv)) {
    return Request{std::nullopt, app.help()};
  }
  fill(order, raw, camera);
  return Request{order, ""};
}
} // namespace calibrate
