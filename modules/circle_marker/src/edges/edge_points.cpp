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
 * Edge points located to a fraction of a pixel.
 */

#include "edges/edge_points.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "support/prefetch.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Cosine of the largest angle between an edge's normal and the direction it is searched along: 60 degrees.
constexpr double leastCosine = 0.5;

bool inside(const Gradient &gradient, int x, int y, int margin)
{
  return x >= margin && y >= margin && x < gradient.width - margin && y < gradient.height - margin;
}

double component(const Gradient &gradient, int x, int y, const Eigen::Vector2d &direction)
{
  const GradientVector vector = gradient.at(x, y);
  return vector.dx * direction.x() + vector.dy * direction.y();
}

// The edge point nearest to a pixel of an edge: see locateEdge(). Whether there is one.
inline bool locate(const Gradient &gradient, int x, int y, EdgePoint &point)
{
  constexpr int margin = 3; // the parabola's three pixels, one pixel of search and the image's outermost pixel
  if (!inside(gradient, x, y, margin)) {
    return false;
  }
  // The components along this edge's own normal, times its magnitude, so that the opposite edge of a thin line does not
  // count. They are whole numbers.
  const GradientVector *ridge = &gradient.at(x, y);
  const GradientVector across = *ridge;
  const int ax = std::abs(across.dx) >= std::abs(across.dy) ? 1 : 0;
  const int ay = 1 - ax;
  const std::ptrdiff_t step = ax + ay * static_cast<std::ptrdiff_t>(gradient.width);
  const auto along = [&](std::ptrdiff_t steps) {
    const GradientVector vector = ridge[steps * step];
    return vector.dx * across.dx + vector.dy * across.dy;
  };
  const int squared = across.squared();
  int before = along(-1);
  int here = squared;
  int after = along(1);
  // To the stronger neighbour, without a branch: on which side of the pixel the ridge lies cannot be foreseen.
  const int isBefore = static_cast<int>(before > here) & static_cast<int>(before >= after);
  const int shift = (static_cast<int>(after > here) & (1 - isBefore)) - isBefore;
  ridge += shift * step;
  before = along(-1);
  here = along(0);
  after = along(1);
  const int curvature = before - 2 * here + after;
  const double least = static_cast<double>(gradient.continueAbove) * gradient.continueAbove;
  if (before > here || after > here || curvature >= 0 || static_cast<double>(here) * here < least * squared) {
    return false;
  }
  const double offset = shift + 0.5 * (before - after) / curvature;
  point.position = Eigen::Vector2d(x + offset * ax, y + offset * ay);
  point.across = Eigen::Vector2d(ridge->dx, ridge->dy);
  return true;
}
} // namespace

std::optional<EdgePoint> locateEdge(const Gradient &gradient, int x, int y)
{
  EdgePoint point;
  return locate(gradient, x, y, point) ? std::optional<EdgePoint>(point) : std::nullopt;
}

void locateChain(const Gradient &gradient, const EdgeChains &chains, const EdgeChain &chain,
                 std::vector<EdgePoint> &points, const Deadline &deadline)
{
  constexpr std::size_t pointsAtOnce = 4096; // between two looks at the clock: 0.1 ms
  // A chain crosses rows, each of which is on another page of memory, and what it passes was last looked at long ago.
  constexpr std::size_t pointsAhead = 8;
  std::size_t count = points.size();
  points.resize(count + chain.length());
  for (std::size_t i = chain.begin; i < chain.end; ++i) {
    const EdgePixel later = chains.pixels[std::min(i + pointsAhead, chain.end - 1)];
    for (const int row : {-1, 0, 1}) {
      prefetch(gradient.vectors.data() + gradient.index(later.x, later.y) + row * gradient.width);
    }
    const EdgePixel pixel = chains.pixels[i];
    count += locate(gradient, pixel.x, pixel.y, points[count]) ? 1 : 0;
    if ((i - chain.begin) % pointsAtOnce == pointsAtOnce - 1 && deadline.hasPassed()) {
      break;
    }
  }
  points.resize(count);
}

std::optional<EdgePoint> searchEdge(const Gradient &gradient, const Eigen::Vector2d &position,
                                    const Eigen::Vector2d &direction, double reach)
{
  const int steps = static_cast<int>(std::ceil(reach));
  // The way is straight: between two ends inside of the image, a pixel is left for rounding, no sample asks for it.
  const auto endsInside = [&](int step) {
    constexpr double margin = 4.;
    const double x = position.x() + step * direction.x();
    const double y = position.y() + step * direction.y();
    return x >= margin && y >= margin && x < gradient.width - 1 - margin && y < gradient.height - 1 - margin;
  };
  const bool isInside = endsInside(-steps) && endsInside(steps);
  double strongest = gradient.continueAbove;
  int bestX = -1;
  int bestY = -1;
  for (int step = -steps; step <= steps; ++step) {
    // Rounds what is not negative; what is lies outside all the same.
    const int x = static_cast<int>(position.x() + step * direction.x() + 0.5);
    const int y = static_cast<int>(position.y() + step * direction.y() + 0.5);
    if (!isInside && !inside(gradient, x, y, 3)) {
      continue;
    }
    const double along = component(gradient, x, y, direction);
    if (along > strongest && along * along > leastCosine * leastCosine * gradient.squaredMagnitude(x, y)) {
      strongest = along;
      bestX = x;
      bestY = y;
    }
  }
  if (bestX < 0) {
    return std::nullopt;
  }
  return locateEdge(gradient, bestX, bestY);
}
} // namespace circle_marker
END_VISP_NAMESPACE
