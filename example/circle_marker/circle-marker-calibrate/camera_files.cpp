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
 * Camera files: writes those of ViSP, reads those of OpenCV and ROS.
 */

#include "camera_files.h"

#include <cmath>
#include <fstream>
#include <iostream>
#include <iterator>
#include <optional>
#include <sstream>
#include <stdexcept>

#include <opencv2/calib3d.hpp>
#include <opencv2/core/persistence.hpp>
#include <visp3/core/vpXmlParserCamera.h>

#include "circle_marker/common/arguments.h"
#include "circle_marker/common/camera_file.h"
#include "circle_marker/common/whole_file.h"

#include "adjust.h"

namespace calibrate {
namespace {
/*! Numbers of a matrix: OpenCV's own type, or a map with "data" as ROS writes it. */
std::vector<double> numbersOf(const cv::FileNode &node)
{
  std::vector<double> numbers;
  const cv::FileNode list = node.isMap() ? node["data"] : node;
  for (const cv::FileNode &number : list) {
    numbers.push_back(number.isInt() || number.isReal() ? static_cast<double>(number) : NAN);
  }
  return numbers;
}

/*! OpenCV reads YAML with its own heading only; ROS writes none. */
std::string withHeading(const std::string &file)
{
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in) {
    throw std::runtime_error("the camera file \"" + file + "\" cannot be read");
  }
  std::string yaml = text.str();
  if (yaml.rfind("%YAML", 0) != 0) {
    yaml = "%YAML:1.0\n---\n" + (yaml.rfind("---", 0) == 0 ? yaml.substr(yaml.find('\n') + 1) : yaml);
  }
  return yaml;
}

/*!
  Ray of a pixel; nothing if there is none: the distortion is no lens's there (it folds the image), or OpenCV's search
  for it does not end. Known by the ray's own pixel, which is another.
*/
std::optional<Eigen::Vector2d> rayOf(const ForeignCamera &camera, const Eigen::Vector2d &pixel)
{
  constexpr double most = 0.01; // pixels: a tenth of what the worst conversion that is of use differs by
  const cv::Mat K = (cv::Mat_<double>(3, 3) << camera.fx, 0., camera.cx, 0., camera.fy, camera.cy, 0., 0., 1.);
  const cv::Vec3d none(0., 0., 0.);
  const std::vector<cv::Point2d> from{{pixel.x(), pixel.y()}};
  std::vector<cv::Point2d> to, back;
  if (camera.isFisheye) {
    cv::fisheye::undistortPoints(from, to, K, camera.distortion);
    cv::fisheye::distortPoints(to, back, K, camera.distortion);
  }
  else {
    const cv::TermCriteria exact(cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 100, 1e-12);
    cv::undistortPoints(from, to, K, camera.distortion, cv::noArray(), cv::noArray(), exact);
    const std::vector<cv::Point3d> ray{{to.front().x, to.front().y, 1.}};
    cv::projectPoints(ray, none, none, K, camera.distortion, back);
  }
  if (!(cv::norm(back.front() - from.front()) < most)) {
    return std::nullopt;
  }
  return Eigen::Vector2d(to.front().x, to.front().y);
}
} // namespace

void checkCameraFile(const std::string &file, const std::string &name)
{
  std::ifstream in(file);
  const std::string text(std::istreambuf_iterator<char>(in), {});
  const std::string opening = "<name>";
  for (std::size_t place = text.find(opening); place != std::string::npos; place = text.find(opening, place + 1)) {
    const std::size_t begin = place + opening.size();
    const std::string other = text.substr(begin, text.find('<', begin) - begin);
    if (other != name) {
      throw tutorial::UsageError("\"" + file + "\" has the camera \"" + other +
                                 "\", which would be lost; name another file with --output");
    }
  }
}

void writeCameras(const std::string &file, const std::string &name, const std::vector<vpCameraParameters> &cameras,
                  unsigned int width, unsigned int height)
{
  tutorial::writeWhole(file, [&](const std::string &temporary) {
    const tutorial::SilentStream silentErrors(std::cerr), silentOutput(std::cout);
    for (const vpCameraParameters &camera : cameras) {
      vpXmlParserCamera parser;
      if (parser.save(camera, temporary, name, width, height) != vpXmlParserCamera::SEQUENCE_OK) {
        throw vpException(vpException::ioError, "vpXmlParserCamera refused it");
      }
    }
  });
}

ForeignCamera readForeignCamera(const std::string &file)
{
  const std::string yaml = withHeading(file);
  const auto refuse = [&file](const std::string &what) {
    return std::runtime_error("the camera file \"" + file + "\" " + what);
  };
  ForeignCamera camera;
  std::vector<double> K;
  try {
    const cv::FileStorage storage(yaml, cv::FileStorage::READ | cv::FileStorage::MEMORY);
    K = numbersOf(storage["camera_matrix"].empty() ? storage["K"] : storage["camera_matrix"]);
    camera.distortion =
        numbersOf(storage["distortion_coefficients"].empty() ? storage["D"] : storage["distortion_coefficients"]);
    camera.width = static_cast<unsigned int>(std::max(0, static_cast<int>(storage["image_width"])));
    camera.height = static_cast<unsigned int>(std::max(0, static_cast<int>(storage["image_height"])));
    const std::string model =
        storage["distortion_model"].isString() ? static_cast<std::string>(storage["distortion_model"]) : "plumb_bob";
    if (model != "plumb_bob" && model != "rational_polynomial" && model != "equidistant" && model != "fisheye") {
      throw refuse("has the distortion_model \"" + model +
                   "\"; plumb_bob, rational_polynomial and equidistant can be read");
    }
    camera.isFisheye = model == "equidistant" || model == "fisheye";
  }
  catch (const cv::Exception &e) {
    throw refuse("is no YAML that OpenCV can read (" + e.err + ")");
  }
  if (K.size() != 9 || !(K[0] > 0.) || !(K[4] > 0.) || !std::isfinite(K[2]) || !std::isfinite(K[5])) {
    throw refuse("has no camera_matrix of nine numbers, the focal lengths positive");
  }
  if (camera.width < 2 || camera.height < 2) {
    throw refuse("does not say image_width and image_height");
  }
  const std::size_t count = camera.distortion.size();
  const bool isKnown = camera.isFisheye ? count == 4 : (count == 0 || count == 4 || count == 5 || count == 8);
  for (const double number : camera.distortion) {
    if (!std::isfinite(number)) {
      throw refuse("has distortion_coefficients that are no numbers");
    }
  }
  if (!isKnown) {
    throw refuse("has " + std::to_string(count) + " distortion_coefficients; 4, 5 or 8 can be read, 4 of equidistant");
  }
  camera.fx = K[0];
  camera.fy = K[4];
  camera.cx = K[2];
  camera.cy = K[5];
  return camera;
}

Conversion convert(const ForeignCamera &camera, LensModel model)
{
  constexpr int steps = 40;           // of a grid over the image; the models are smooth
  constexpr double farthestRay = 50.; // in the plane at the distance 1: at 88.9 degrees from the axis
  // The rays as points of a plane at the distance 1, seen by a camera that stands still.
  Target rays;
  View view;
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; j <= steps; ++j) {
      const Eigen::Vector2d pixel(i * (camera.width - 1.) / steps, j * (camera.height - 1.) / steps);
      const std::optional<Eigen::Vector2d> found = rayOf(camera, pixel);
      if (!found || !(found->norm() < farthestRay)) {
        throw std::runtime_error("the camera has no ray for the pixel " + std::to_string(pixel.x()) + ", " +
                                 std::to_string(pixel.y()) +
                                 (found ? ": it sees 180 degrees or more, which no model of ViSP does"
                                        : ": its distortion cannot be undone there; was it found from pictures with "
                                          "nothing in that part of the image?"));
      }
      TargetPoint ray;
      ray.place = *found;
      view.observations.push_back(Observation{rays.points.size(), pixel});
      rays.points.push_back(ray);
    }
  }
  Adjustment start;
  start.lens = Lens::of(model, camera.fx, camera.fy, camera.cx, camera.cy);
  start.poses.resize(1);
  start.poses.front().translation.z() = 1.;
  const Adjustment fitted = adjustLens(rays, {view}, start);
  Conversion conversion{fitted.lens, fitted.rms(), 0.};
  const auto residuals = residualsOf(rays, {view}, fitted);
  for (const Eigen::Vector2d &r : residuals.front()) {
    conversion.greatest = std::max(conversion.greatest, r.norm());
  }
  return conversion;
}
} // namespace calibrate
