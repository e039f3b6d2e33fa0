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
 * Where the fit of a marker to a blurred image may start.
 */

#include "decode/blurred_looks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <Eigen/Eigenvalues>

#include "pose/hypotheses.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Samples.
constexpr std::size_t fewSamples = 250;
// Radii of the disc that are tried first, and lengths of the way, in semi-major axes of the outline; directions of it.
constexpr std::array<double, 2> firstDiscs = {0.07, 0.14};
constexpr std::array<double, 2> firstWays = {0.22, 0.42};
constexpr int firstDirections = 8;
// The outline of something that moved is longer along the way by this share of it on each side.
constexpr double outlineGrowth = 0.28;
// Starts that are followed, and those of them that are followed to the end.
constexpr std::size_t followed = 4;
constexpr std::size_t finished = 2;
constexpr int followedSteps = 4;
// A first look that leaves more than this share of the image's variance unexplained is none of a marker. If the best
// one still leaves more than the second after a step, there is none: of 809 true markers the best left up to 0.09 then,
// of rings with another code 0.09 to 0.3. Nor is one that leaves more than the third after some steps: the best ones of
// true markers leave up to 0.05. (Before the first step it does not tell: markers in a defocus of a quarter of their
// radius left up to 0.4, and with a start of that defocus so did what is none leave less.)
constexpr double mostUnexplainedAtFirst = 0.6;
constexpr double mostUnexplainedAfterStep = 0.12;
constexpr double mostUnexplainedAfterSteps = 0.1;

// The outline without what a motion adds to it; nothing if nothing is left.
std::optional<EllipseParameters> shrunk(const EllipseParameters &ellipse, const Eigen::Vector2d &way)
{
  const Eigen::Vector2d major(std::cos(ellipse.angle), std::sin(ellipse.angle));
  const Eigen::Vector2d minor(-major.y(), major.x());
  Eigen::Matrix2d shape =
      ellipse.a * ellipse.a * major * major.transpose() + ellipse.b * ellipse.b * minor * minor.transpose();
  const Eigen::Vector2d direction = way.normalized();
  const double extent = std::sqrt(direction.dot(shape * direction));
  const double less = extent - outlineGrowth * way.norm();
  if (less < 0.3 * extent) {
    return std::nullopt;
  }
  // A dual conic: the squared extent in each direction.
  shape -= (extent * extent - less * less) * direction * direction.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(shape);
  if (eigen.eigenvalues()[0] <= 0.) {
    return std::nullopt;
  }
  EllipseParameters result = ellipse;
  result.a = std::sqrt(eigen.eigenvalues()[1]);
  result.b = std::sqrt(eigen.eigenvalues()[0]);
  result.angle = std::atan2(eigen.eigenvectors()(1, 1), eigen.eigenvectors()(0, 1));
  return result;
}

std::optional<PosePair> posesOfEllipse(const EllipseParameters &ellipse, const CameraModel &camera, double radius)
{
  constexpr int count = 32;
  std::vector<EdgePoint> points(count);
  const Eigen::Vector2d major(std::cos(ellipse.angle), std::sin(ellipse.angle));
  const Eigen::Vector2d minor(-major.y(), major.x());
  for (int i = 0; i < count; ++i) {
    const double angle = 2. * M_PI * i / count;
    points[static_cast<std::size_t>(i)].position =
        ellipse.center + ellipse.a * std::cos(angle) * major + ellipse.b * std::sin(angle) * minor;
  }
  return posesFromOutline(points, camera, radius);
}

// All starts, the best first.
std::vector<BlurredFit> firstLooks(BlurredMarker &marker, const CameraModel &camera, const EllipseParameters &outline,
                                   double radius, const Deadline &deadline)
{
  std::vector<BlurredFit> looks;
  const auto look = [&](const EllipseParameters &ellipse, const ImageBlur &blur) {
    if (deadline.hasPassed()) {
      return;
    }
    const auto poses = posesOfEllipse(ellipse, camera, radius);
    if (!poses) {
      return;
    }
    for (const MarkerPlane &plane : *poses) {
      marker.select(plane, blur, fewSamples);
      BlurredFit fit;
      fit.plane = plane;
      fit.blur = blur;
      if (marker.size() > fewSamples / 4) {
        marker.solve(fit);
        if (fit.unexplained() < mostUnexplainedAtFirst) {
          looks.push_back(fit);
        }
      }
    }
  };
  for (const double disc : firstDiscs) {
    look(outline, {Eigen::Vector2d::Zero(), disc * outline.a});
  }
  for (const double way : firstWays) {
    for (int i = 0; i < firstDirections; ++i) {
      const double angle = M_PI * i / firstDirections;
      const Eigen::Vector2d motion = way * outline.a * Eigen::Vector2d(std::cos(angle), std::sin(angle));
      if (const auto ellipse = shrunk(outline, motion)) {
        look(*ellipse, {motion, 0.});
      }
    }
  }
  std::sort(looks.begin(), looks.end(),
            [](const BlurredFit &p, const BlurredFit &q) { return p.unexplained() < q.unexplained(); });
  return looks;
}
} // namespace

std::vector<BlurredFit> bestLooks(BlurredMarker &marker, const CameraModel &camera, const EllipseParameters &outline,
                                  double radius, const Deadline &deadline)
{
  std::vector<BlurredFit> fits = firstLooks(marker, camera, outline, radius, deadline);
  fits.resize(std::min(fits.size(), followed));
  double least = HUGE_VAL;
  for (BlurredFit &fit : fits) {
    marker.select(fit.plane, fit.blur, fewSamples);
    if (marker.size() < fewSamples / 4) {
      fit.squares = HUGE_VAL;
      continue;
    }
    marker.solve(fit);
    marker.improve(fit, 1, false);
    least = std::min(least, fit.unexplained());
  }
  if (!(least < mostUnexplainedAfterStep)) {
    return {};
  }
  for (BlurredFit &fit : fits) {
    if (fit.squares < HUGE_VAL) {
      marker.select(fit.plane, fit.blur, fewSamples);
      marker.solve(fit);
      marker.improve(fit, followedSteps - 1, false);
    }
  }
  std::sort(fits.begin(), fits.end(),
            [](const BlurredFit &p, const BlurredFit &q) { return p.unexplained() < q.unexplained(); });
  fits.resize(std::min(fits.size(), finished));
  fits.erase(std::remove_if(fits.begin(), fits.end(),
                            [](const BlurredFit &fit) { return !(fit.unexplained() < mostUnexplainedAfterSteps); }),
             fits.end());
  return fits;
}
} // namespace circle_marker
END_VISP_NAMESPACE
