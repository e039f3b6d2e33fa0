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
 * The camera that explains the pictures.
 */

#include "solve.h"

#include <algorithm>
#include <cmath>

#include "start.h"

namespace calibrate {
namespace {
/*! The views with each circle's centre moved to the image of the true centre, as an adjustment has it. */
std::vector<View> corrected(const Target &target, const std::vector<View> &views, const Adjustment &a, double &greatest)
{
  std::vector<View> result = views;
  greatest = 0.;
  for (std::size_t v = 0; v < views.size(); ++v) {
    for (Observation &o : result[v].observations) {
      const Eigen::Vector2d offset = centerOffset(a.lens, a.poses[v], target.points[o.point]);
      o.pixel -= offset;
      greatest = std::max(greatest, offset.norm());
    }
  }
  return result;
}

/*! The adjustment and the circles' true centres, in turn. */
Calibration settle(const Target &target, const std::vector<View> &views, const Adjustment &start, Centers centers)
{
  Calibration result;
  result.views = views;
  result.adjustment = adjust(target, views, start);
  if (centers == Centers::Ellipse || !target.hasCircles()) {
    return result;
  }
  constexpr int mostRounds = 20;
  for (int round = 0; round < mostRounds; ++round) {
    const Eigen::VectorXd before = result.adjustment.lens.numbers;
    result.views = corrected(target, views, result.adjustment, result.greatestOffset);
    result.adjustment = adjust(target, result.views, result.adjustment);
    // A thousandth of a pixel of focal length and principal point is far below what any picture tells.
    if ((result.adjustment.lens.numbers - before).head<4>().cwiseAbs().maxCoeff() < 1e-3) {
      break;
    }
  }
  return result;
}

/*! Leaves out the points that do not belong to the rest; how many. */
std::size_t leaveOut(const Target &target, const Calibration &calibration, std::vector<View> &views)
{
  const auto residuals = residualsOf(target, calibration.views, calibration.adjustment);
  std::vector<double> lengths;
  for (const auto &view : residuals) {
    for (const Eigen::Vector2d &r : view) {
      lengths.push_back(r.norm());
    }
  }
  std::nth_element(lengths.begin(), lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2), lengths.end());
  // Of two normal coordinates the median length is 1.18 sigma; six sigma has a rate of 1e-8.
  const double bound = std::max(6. / 1.18 * lengths[lengths.size() / 2], 1e-3);
  std::size_t count = 0;
  for (std::size_t v = 0; v < views.size(); ++v) {
    std::vector<Observation> kept;
    for (std::size_t i = 0; i < residuals[v].size(); ++i) {
      if (residuals[v][i].norm() <= bound) {
        kept.push_back(views[v].observations[i]);
      }
    }
    if (kept.size() >= 4) { // fewer do not fix the target's pose
      count += views[v].observations.size() - kept.size();
      views[v].observations = kept;
    }
  }
  return count;
}
} // namespace

Eigen::Vector2d centroidOf(const std::vector<Eigen::Vector2d> &outline)
{
  // Relative to the first point, for the sake of rounding.
  double area = 0.;
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d a = outline[i] - outline.front(), b = outline[(i + 1) % outline.size()] - outline.front();
    const double part = a.x() * b.y() - a.y() * b.x();
    area += part;
    moment += part * (a + b) / 3.;
  }
  return outline.front() + moment / area;
}

Eigen::Vector2d centerOffset(const Lens &lens, const TargetPose &pose, const TargetPoint &circle)
{
  constexpr int corners = 64; // the polygon's centre is then within 1e-4 of the offset
  const auto center = lens.project(pose * circle.place);
  std::vector<Eigen::Vector2d> outline;
  for (int i = 0; i < corners && circle.radius > 0.; ++i) {
    const double angle = 2. * M_PI * i / corners;
    const auto image =
        lens.project(pose * (circle.place + circle.radius * Eigen::Vector2d(std::cos(angle), std::sin(angle))));
    if (!image) {
      return Eigen::Vector2d::Zero();
    }
    outline.push_back(*image);
  }
  return center && !outline.empty() ? Eigen::Vector2d(centroidOf(outline) - *center) : Eigen::Vector2d::Zero();
}

Calibration calibrate(const Target &target, const std::vector<View> &views, LensModel model, Centers centers,
                      const Adjustment *start)
{
  Calibration result = settle(target, views, start != nullptr ? *start : firstGuess(target, views, model), centers);
  std::vector<View> kept = views;
  constexpr int mostRounds = 5;
  std::size_t leftOut = 0;
  for (int round = 0; round < mostRounds; ++round) {
    const std::size_t more = leaveOut(target, result, kept);
    if (more == 0) {
      break;
    }
    leftOut += more;
    result = settle(target, kept, result.adjustment, centers);
  }
  result.leftOut = leftOut;
  return result;
}
} // namespace calibrate
