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
 * First guess of a camera and of the target's poses.
 */

#include "start.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include <opencv2/calib3d.hpp>

namespace calibrate {
namespace {
/*! Pose of the target in one view for a lens, by OpenCV's solver for planes. */
std::optional<TargetPose> poseOf(const Target &target, const View &view, const Lens &lens)
{
  std::vector<cv::Point3d> places;
  std::vector<cv::Point2d> images;
  for (const Observation &o : view.observations) {
    const auto x = lens.normalised(o.pixel);
    if (!x) {
      return std::nullopt;
    }
    const Eigen::Vector2d &place = target.points[o.point].place;
    places.emplace_back(place.x(), place.y(), 0.);
    images.emplace_back(x->x(), x->y());
  }
  cv::Mat turn, shift;
  try {
    if (!cv::solvePnP(places, images, cv::Mat::eye(3, 3, CV_64F), cv::noArray(), turn, shift, false,
                      cv::SOLVEPNP_IPPE)) {
      return std::nullopt;
    }
  }
  catch (const cv::Exception &) {
    return std::nullopt;
  }
  cv::Mat rotation;
  cv::Rodrigues(turn, rotation);
  TargetPose pose;
  for (int i = 0; i < 3; ++i) {
    pose.translation[i] = shift.at<double>(i);
    for (int j = 0; j < 3; ++j) {
      pose.rotation(i, j) = rotation.at<double>(i, j);
    }
  }
  return pose;
}

/*! Focal length that the views' homographies ask for (Zhang's equations, in OpenCV). */
std::optional<double> focalOfHomographies(const Target &target, const std::vector<View> &views)
{
  std::vector<std::vector<cv::Point3f>> places;
  std::vector<std::vector<cv::Point2f>> images;
  for (const View &view : views) {
    places.emplace_back();
    images.emplace_back();
    for (const Observation &o : view.observations) {
      const Eigen::Vector2f place = target.points[o.point].place.cast<float>();
      places.back().emplace_back(place.x(), place.y(), 0.F);
      images.back().emplace_back(static_cast<float>(o.pixel.x()), static_cast<float>(o.pixel.y()));
    }
  }
  try {
    const cv::Size size(static_cast<int>(views.front().width), static_cast<int>(views.front().height));
    const double focal = cv::initCameraMatrix2D(places, images, size, 1.).at<double>(0, 0);
    return std::isfinite(focal) && focal > 0. ? std::optional<double>(focal) : std::nullopt;
  }
  catch (const cv::Exception &) {
    return std::nullopt;
  }
}

std::optional<Adjustment> tryFocal(const Target &target, const std::vector<View> &views, LensModel model, double focal)
{
  const View &view = views.front();
  Adjustment guess;
  guess.lens = Lens::of(model, focal, focal, 0.5 * (view.width - 1.), 0.5 * (view.height - 1.));
  for (const View &v : views) {
    const auto pose = poseOf(target, v, guess.lens);
    if (!pose) {
      return std::nullopt;
    }
    guess.poses.push_back(*pose);
  }
  const Adjustment adjusted = adjust(target, views, guess);
  const bool isCamera = adjusted.lens.numbers[0] > 0. && adjusted.lens.numbers[1] > 0. && adjusted.cost < 1e29;
  return isCamera ? std::optional<Adjustment>(adjusted) : std::nullopt;
}
} // namespace

Adjustment firstGuess(const Target &target, const std::vector<View> &views, LensModel model)
{
  const double width = std::max(views.front().width, views.front().height);
  // Angles of view of 40 to 90 degrees; fisheyes of more have less than half of the width.
  std::vector<double> focals{1.3 * width, 0.7 * width, 0.4 * width, 0.25 * width};
  if (const auto focal = focalOfHomographies(target, views)) {
    focals.insert(focals.begin(), *focal);
  }
  std::optional<Adjustment> best;
  for (const double focal : focals) {
    const auto guess = tryFocal(target, views, model, focal);
    if (guess && (!best || guess->cost < best->cost)) {
      best = guess;
    }
    // Points seen to a pixel or so: no other start finds anything else.
    if (best && best->converged && best->rms() < 1.) {
      return *best;
    }
  }
  if (!best) {
    throw std::runtime_error(
        "no camera of the model " + nameOf(model) +
        " can see the target as it was seen; check rows, columns and spacing, or try another --model");
  }
  return *best;
}
} // namespace calibrate
