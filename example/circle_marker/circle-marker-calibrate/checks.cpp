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
 * Whether pictures say enough about a camera.
 */

#include "checks.h"

#include <algorithm>
#include <cmath>

#include "common/numbers.h"

namespace calibrate {
namespace {
constexpr double degree = M_PI / 180.;
// Each view of a plane gives two equations, a camera without distortion has four numbers; the third view is the first
// that says whether they agree.
constexpr std::size_t fewestViews = 3;
// A depth is as wrong as the focal length: a standard deviation of 1 % is 10 cm at 10 m, and no longer a calibration.
constexpr double mostFocalDeviation = 0.01;
// Share of the image's width; 1 % turns all poses by half a degree.
constexpr double mostCenterDeviation = 0.01;
// Below, focal length and distance cannot be told apart with any care.
constexpr double leastTurn = 10. * degree;
// Of the scaled normal matrix; beyond, half of the digits of the numbers that a computer keeps are lost.
constexpr double worstCondition = 1e8;
// Below, the distortion at the image's corners is a guess.
constexpr double goodReach = 0.7;

double deviation(const Adjustment &a, int number)
{
  return std::sqrt(std::max(0., a.covariance(number, number)));
}
} // namespace

ViewSpread spreadOf(const std::vector<View> &views, const Adjustment &adjustment)
{
  ViewSpread spread;
  for (std::size_t a = 0; a < views.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const double cosine = adjustment.poses[a].rotation.col(2).dot(adjustment.poses[b].rotation.col(2));
      // A target seen upside down is the same plane.
      spread.greatestTurn = std::max(spread.greatestTurn, std::acos(std::min(1., std::abs(cosine))));
    }
    const Eigen::Vector2d middle(0.5 * (views[a].width - 1.), 0.5 * (views[a].height - 1.));
    for (const Observation &o : views[a].observations) {
      spread.reach = std::max(spread.reach, (o.pixel - middle).norm() / middle.norm());
    }
  }
  return spread;
}

std::string problemOfViews(const std::vector<View> &views)
{
  if (views.size() < fewestViews) {
    return std::to_string(views.size()) + " views show the target; at least " + std::to_string(fewestViews) +
           " are needed, and ten or more are better: tilt the target to and fro and to the sides";
  }
  for (const View &view : views) {
    if (view.width != views.front().width || view.height != views.front().height) {
      return "\"" + view.name + "\" has another size than \"" + views.front().name +
             "\"; all pictures must be of one camera, and whole";
    }
  }
  return "";
}

std::vector<std::string> problemsOf(const Calibration &calibration)
{
  const Adjustment &a = calibration.adjustment;
  std::vector<std::string> problems;
  const ViewSpread spread = spreadOf(calibration.views, a);
  if (!a.converged || !(a.cost < 1e29)) {
    problems.push_back("no camera of this model explains the pictures; check the target's measures, or try another "
                       "--model");
    return problems;
  }
  if (spread.greatestTurn < leastTurn) {
    problems.push_back(
        "the target has nearly the same tilt in all views (" + common::digits(spread.greatestTurn / degree) +
        " degrees between the most different ones), so a longer focal length and a greater distance look "
        "the same; tilt it by 30 to 45 degrees to all sides");
  }
  if (!(a.condition < worstCondition)) {
    problems.push_back("the views leave a combination of the camera's numbers open (condition of the normal matrix " +
                       std::string(std::isfinite(a.condition) ? common::digits(a.condition) : "infinite") +
                       "); add views with other tilts and at other places in the image");
  }
  for (int i = 0; i < 2; ++i) {
    const double share = deviation(a, i) / std::abs(a.lens.numbers[i]);
    if (!(share <= mostFocalDeviation)) {
      problems.push_back("the focal length " + a.lens.names()[static_cast<std::size_t>(i)] + " is known to " +
                         common::digits(100. * share) +
                         " % only (1 % is asked for); add views with more tilt, or nearer");
    }
  }
  for (int i = 2; i < 4; ++i) {
    const double share = deviation(a, i) / calibration.views.front().width;
    if (!(share <= mostCenterDeviation)) {
      problems.push_back("the principal point's " + a.lens.names()[static_cast<std::size_t>(i)] + " is known to " +
                         common::digits(deviation(a, i)) +
                         " pixels only (1 % of the width is asked for); add views with "
                         "tilts to all sides, and turn the target by 90 degrees");
    }
  }
  return problems;
}

std::vector<std::string> remarksOn(const Calibration &calibration)
{
  std::vector<std::string> remarks;
  const ViewSpread spread = spreadOf(calibration.views, calibration.adjustment);
  if (calibration.adjustment.lens.model != LensModel::Plain && spread.reach < goodReach) {
    remarks.push_back(
        "no point lies in the outer part of the image (the farthest at " + common::digits(100. * spread.reach) +
        " % of the way to the corner): the distortion there is a guess; add views that reach the corners");
  }
  if (calibration.leftOut > 0) {
    remarks.push_back(std::to_string(calibration.leftOut) + " points were left out: they did not belong to the rest");
  }
  return remarks;
}
} // namespace calibrate
