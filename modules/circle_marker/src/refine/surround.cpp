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
 * What lies beyond a marker's quiet zone.
 */

#include "refine/surround.h"

#include <cmath>
#include <limits>
#include <utility>

#include "support/bilinear.h"
#include "support/normal_distribution.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Looks in each direction: from where the blur of the quiet zone's end has gone, a pixel apart.
constexpr unsigned int looks = 4;
constexpr double clearOfBlur = 1.5; // standard deviations
// Where the square is looked for, in units of half of its width: its corners are at 1.41.
constexpr std::array<double, 4> sampleExtents = {{1.07, 1.14, 1.21, 1.28}};
// Angles of the square that are tried, 5 degrees apart: an error of half of that moves its sides by 1 % of the radius.
constexpr int squareAngles = 18;
} // namespace

unsigned int Surround::directionOf(const Eigen::Vector2d &q)
{
  const double turns = std::atan2(q.y(), q.x()) / (2. * M_PI);
  return static_cast<unsigned int>(std::lround((turns + 1.) * directions)) % directions;
}

Surround surroundOf(const vpImage<unsigned char> &I, const CameraModel &camera, const MarkerPlane &plane,
                    const PaperEnd &paper, double blur)
{
  Surround surround;
  for (unsigned int k = 0; k < Surround::directions; ++k) {
    const double angle = 2. * M_PI * k / Surround::directions;
    const Eigen::Vector2d q(std::cos(angle), std::sin(angle));
    const double scale = paper.shape == PaperShape::SQUARE ? paper.alongAxes(q).cwiseAbs().maxCoeff() : 1.;
    const Eigen::Vector2d end = camera.toPixel(plane.project(paper.extent / scale * q));
    const Eigen::Vector2d outward = (end - camera.toPixel(plane.project(q))).normalized();
    double sum = 0., squares = 0.;
    bool isInside = true;
    for (unsigned int i = 0; i < looks && isInside; ++i) {
      const Eigen::Vector2d p = end + (clearOfBlur * blur + i) * outward;
      const auto grey = bilinear(I, p);
      isInside = grey.has_value();
      if (isInside) {
        sum += *grey;
        squares += *grey * *grey;
      }
    }
    const double mean = sum / looks;
    surround.grey[k] = static_cast<float>(mean);
    surround.spread[k] = isInside ? static_cast<float>(std::sqrt(std::max(squares / looks - mean * mean, 0.)))
                                  : std::numeric_limits<float>::infinity();
  }
  return surround;
}

double shareBeyond(const PlanePoint &point, const PaperEnd &paper, double blur)
{
  const NormalDistribution &normal = NormalDistribution::instance();
  if (paper.shape == PaperShape::ROUND) {
    const double radius = point.q.norm();
    const double gradient = (point.byPixel.transpose() * (point.q / radius)).norm();
    return normal.at((radius - paper.extent) / (gradient * blur)).cumulative;
  }
  const Eigen::Vector2d q = paper.alongAxes(point.q);
  const Eigen::Vector2d byU = paper.alongAxes(point.byPixel.col(0));
  const Eigen::Vector2d byV = paper.alongAxes(point.byPixel.col(1));
  double inside = 1.;
  for (int axis = 0; axis < 2; ++axis) {
    const double distance =
        (paper.extent - std::abs(q[axis])) / std::sqrt(byU[axis] * byU[axis] + byV[axis] * byV[axis]);
    inside *= normal.at(distance / blur).cumulative;
  }
  return 1. - inside;
}

double squareAngleOf(const vpImage<unsigned char> &I, const CameraModel &camera, const MarkerPlane &plane,
                     double outermost)
{
  // Samples between the square's sides and its corners; those near the edge count for both.
  std::array<std::pair<Eigen::Vector2d, double>, Surround::directions * sampleExtents.size()> samples;
  std::size_t count = 0;
  double total = 0.;
  for (unsigned int k = 0; k < Surround::directions; ++k) {
    const double direction = 2. * M_PI * k / Surround::directions;
    for (const double extent : sampleExtents) {
      const Eigen::Vector2d q = extent * outermost * Eigen::Vector2d(std::cos(direction), std::sin(direction));
      if (const auto grey = bilinear(I, camera.toPixel(plane.project(q)))) {
        samples[count++] = {q, *grey};
        total += *grey;
      }
    }
  }
  double best = 0., bestScore = 0.;
  for (int k = 0; k < squareAngles; ++k) {
    PaperEnd paper;
    paper.angle = 0.5 * M_PI * k / squareAngles;
    double inside = 0., insideTotal = 0.;
    for (std::size_t i = 0; i < count; ++i) {
      const auto &[q, grey] = samples[i];
      if (paper.alongAxes(q).cwiseAbs().maxCoeff() < outermost) {
        inside += 1.;
        insideTotal += grey;
      }
    }
    const double outside = static_cast<double>(count) - inside;
    if (inside < 1. || outside < 1.) {
      continue;
    }
    // Variance between both parts.
    const double difference = insideTotal / inside - (total - insideTotal) / outside;
    const double score = inside * outside * difference * difference;
    if (difference > 0. && score > bestScore) {
      best = paper.angle;
      bestScore = score;
    }
  }
  return best;
}
} // namespace circle_marker
END_VISP_NAMESPACE
