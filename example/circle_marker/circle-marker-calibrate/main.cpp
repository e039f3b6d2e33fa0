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
 * Calibrates a camera from pictures of a flat target.
 */

/*!
  \example circle-marker-calibrate/main.cpp
  Calibrates a camera from pictures of a chessboard, a grid of circles, or a sheet of circular markers.
*/

#include <algorithm>
#include <iostream>
#include <optional>

#include "circle_marker/common/program.h"
#include "circle_marker/common/whole_file.h"
#include "common/numbers.h"
#include "common/progress.h"

#include "camera_files.h"
#include "checks.h"
#include "command_line.h"
#include "find.h"
#include "pictures.h"
#include "report.h"
#include "simulate.h"

using namespace calibrate;

namespace {
const tutorial::Program program("circle-marker-calibrate");

/*! Looks for the target in all pictures; those without it are named once. */
std::vector<View> findAll(Finder &finder, const std::vector<Picture> &pictures, const std::optional<Lens> &lens,
                          bool isTold)
{
  std::vector<View> views;
  common::ProgressLine line("pictures");
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const Search search = finder.find(pictures[i].image, pictures[i].name, lens);
    if (search.view) {
      views.push_back(*search.view);
    }
    else if (isTold) {
      program.complain("\"" + pictures[i].name + "\": " + search.problem);
    }
    line.show(i + 1, pictures.size());
  }
  return views;
}

/*! The points that ViSP's calibrate-camera takes of a grid: OpenCV's blobs. Empty if they are not found in all views.
 */
std::vector<View> viewsOfBlobs(const Target &target, const std::vector<Picture> &pictures,
                               const std::vector<View> &views)
{
  std::vector<View> result;
  for (const Picture &picture : pictures) {
    const auto centers = target.hasCircles() && target.kind != TargetKind::Markers ? blobCenters(target, picture.image)
                                                                                   : std::vector<Eigen::Vector2d>();
    if (centers.size() == target.points.size()) {
      View view;
      view.name = picture.name;
      view.width = picture.image.getWidth();
      view.height = picture.image.getHeight();
      for (std::size_t i = 0; i < centers.size(); ++i) {
        view.observations.push_back(Observation{i, centers[i]});
      }
      result.push_back(view);
    }
  }
  return result.size() == views.size() ? result : std::vector<View>();
}

ModelReport calibrateModel(const Order &order, LensModel model, Finder &finder, const std::vector<Picture> &pictures,
                           std::vector<View> views)
{
  ModelReport report;
  report.model = model;
  report.calibration = calibrate::calibrate(order.target, views, model, Centers::True);
  if (order.target.hasCircles()) {
    // Once more with the camera that is now known: outlines were drawn with a nominal one.
    const std::vector<View> again = findAll(finder, pictures, report.calibration.adjustment.lens, false);
    const auto isOfOnePicture = [](const View &p, const View &q) { return p.name == q.name; };
    if (std::equal(again.begin(), again.end(), views.begin(), views.end(), isOfOnePicture)) { // poses go by their order
      views = again;
      report.calibration =
          calibrate::calibrate(order.target, views, model, Centers::True, &report.calibration.adjustment);
    }
    report.byEllipses =
        calibrate::calibrate(order.target, views, model, Centers::Ellipse, &report.calibration.adjustment);
  }
  report.problems = problemsOf(report.calibration);
  report.remarks = remarksOn(report.calibration);
  if (order.compareVisp && model != LensModel::KannalaBrandt) {
    report.visp = calibrateByVisp(order.target, views, model == LensModel::Distortion);
    const std::vector<View> blobs = viewsOfBlobs(order.target, pictures, views);
    if (!blobs.empty()) {
      report.vispOwn = calibrateByVisp(order.target, blobs, model == LensModel::Distortion);
    }
  }
  return report;
}

void writeFiles(const Order &order, const Report &report)
{
  if (!order.json.empty()) {
    tutorial::writeWholeText(order.json, jsonOf(report));
  }
  if (!order.residuals.empty()) {
    tutorial::writeWholeText(order.residuals, residualPicture(report));
  }
  std::vector<vpCameraParameters> cameras;
  for (const ModelReport &model : report.models) {
    if (model.problems.empty()) {
      cameras.push_back(model.calibration.adjustment.lens.parameters(report.width, report.height));
    }
    for (const std::string &problem : model.problems) {
      program.complain("the model " + nameOf(model.model) + " is refused: " + problem);
    }
  }
  if (!order.output.empty() && !cameras.empty()) {
    writeCameras(order.output, order.cameraName, cameras, report.width, report.height);
  }
}

int carryOut(const Order &order)
{
  if (!order.output.empty()) {
    checkCameraFile(order.output, order.cameraName);
  }
  bool isGood = true;
  const std::vector<Picture> pictures = gatherPictures(order, [&isGood](const std::string &message) {
    isGood = false;
    program.complain(message);
  });
  Finder finder(order.target);
  const std::vector<View> views = findAll(finder, pictures, std::nullopt, true);
  if (const std::string problem = problemOfViews(views); !problem.empty()) {
    throw std::runtime_error(problem);
  }
  Report report;
  report.target = order.target;
  report.width = views.front().width;
  report.height = views.front().height;
  report.pictures = pictures.size();
  if (order.pictures.simulated > 0) {
    report.truth = lensOf(order.simulation.camera);
  }
  isGood = isGood && views.size() == pictures.size();
  for (const LensModel model : order.models) {
    report.models.push_back(calibrateModel(order, model, finder, pictures, views));
    isGood = isGood && report.models.back().problems.empty();
  }
  std::cout << tableOf(report) << std::flush;
  writeFiles(order, report);
  return isGood ? 0 : 1;
}

int convertFile(const Order &order)
{
  checkCameraFile(order.output, order.cameraName);
  const ForeignCamera camera = readForeignCamera(order.convert);
  std::vector<vpCameraParameters> cameras;
  for (const LensModel model : order.models) {
    const Conversion conversion = convert(camera, model);
    cameras.push_back(conversion.lens.parameters(camera.width, camera.height));
    std::cout << "model " << nameOf(model) << ": differs by " << common::digits(conversion.rms) << " pixels (rms), "
              << common::digits(conversion.greatest) << " pixels at most over the image\n";
  }
  writeCameras(order.output, order.cameraName, cameras, camera.width, camera.height);
  return 0;
}
} // namespace

int main(int argc, const char *argv[])
{
  return program.run(parseCommandLine, argc, argv,
                     [](const Order &order) { return order.convert.empty() ? carryOut(order) : convertFile(order); });
}
