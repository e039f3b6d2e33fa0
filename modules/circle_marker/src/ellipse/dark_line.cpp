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
 * The dark line that is left of a thin ring.
 */

#include "ellipse/dark_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "support/bilinear.h"
#include "support/parabola.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
constexpr double step = 0.5; // pixel
// How far from its inner edge the line is sought, pixels: that of the largest ring that is sought this way, of 32,
// is 3.2 wide, and the edge lies up to a blur inside of it.
constexpr double inReach = 4.;
// The middle of the ring lies at 0.77 of the way from the sheet's centre to a side, at 0.55 of that to a corner.
constexpr double sheetReach = 0.55;
constexpr std::size_t mostSteps = 40; // 20 pixels
// Directions of the first look, at most, and the share of them that must show a line.
constexpr std::size_t fewDirections = 12;
constexpr double leastInFew = 0.55;

// The first dark line along a ray: darker by \e rise than what is brightest before it, and than what follows. The ray
// may begin on a slope either way.
std::optional<Eigen::Vector2d> firstDarkLine(const vpImage<unsigned char> &I, const Eigen::Vector2d &from,
                                             const Eigen::Vector2d &direction, double reach, double rise)
{
  const auto positionAt = [&](double steps) { return Eigen::Vector2d(from + steps * step * direction); };
  if (!isBetweenPixels(I, from)) {
    return std::nullopt;
  }
  std::size_t steps = std::min(static_cast<std::size_t>(reach / step), mostSteps);
  while (!isBetweenPixels(I, positionAt(static_cast<double>(steps)))) { // and then all that are nearer are
    --steps;
  }
  std::array<double, mostSteps + 1> greys;
  double brightest = 0.;
  std::size_t darkest = 0; // 0: not yet on the way down
  for (std::size_t i = 0; i <= steps; ++i) {
    const double grey = bilinearBetween(I, positionAt(static_cast<double>(i)));
    greys[i] = grey;
    if (darkest == 0) {
      brightest = std::max(brightest, grey);
      darkest = grey < brightest - rise ? i : 0;
    }
    else if (grey < greys[darkest]) {
      darkest = i;
    }
    else if (grey > greys[darkest] + rise) {
      const double offset = vertexOfParabola(greys[darkest - 1], greys[darkest], greys[darkest + 1]);
      return positionAt(static_cast<double>(darkest) + offset);
    }
  }
  return std::nullopt;
}

// The mean of positionOf(0), positionOf(1) and so on.
template <class PositionOf> Eigen::Vector2d middleOf(std::size_t count, const PositionOf &positionOf)
{
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < count; ++i) {
    sum += positionOf(i);
  }
  return sum / static_cast<double>(count);
}

// The points of an edge whose directions are asked.
struct Directions
{
  // most: of them at most.
  Directions(std::size_t points, std::size_t most) : stride(1 + points / most), count((points + stride - 1) / stride) {}

  // How many may show no line where a share must.
  std::size_t mostMissed(double least) const
  {
    return count - std::min(count, static_cast<std::size_t>(std::ceil(least * static_cast<double>(count))));
  }

  std::size_t stride; // points
  std::size_t count;
};

// The line beyond a point of a closed edge, if the ring is seen from there. outward: the way out of the ring.
std::optional<Eigen::Vector2d> lineFrom(const vpImage<unsigned char> &I, const Eigen::Vector2d &from,
                                        const Eigen::Vector2d &outward, const Eigen::Vector2d &middle,
                                        RingNeighbour neighbour, double rise)
{
  return neighbour == RingNeighbour::INSIDE
             ? firstDarkLine(I, from, outward, inReach, rise)
             : firstDarkLine(I, from, -outward, sheetReach * (from - middle).norm(), rise);
}
} // namespace

double darkLineBeside(const vpImage<unsigned char> &I, const EdgePoint *points, std::size_t count,
                      RingNeighbour neighbour, double rise, const LineSearch &search, std::vector<EdgePoint> &line)
{
  const Eigen::Vector2d middle = middleOf(count, [&](std::size_t i) { return points[i].position; });
  const Directions directions(count, search.most);
  const std::size_t mostMissed = directions.mostMissed(search.least);
  line.clear();
  std::size_t missed = 0;
  for (std::size_t i = 0; i < count && missed <= mostMissed; i += directions.stride) {
    const Eigen::Vector2d &from = points[i].position;
    // Squarely across the inner edge; a sheet has corners.
    const Eigen::Vector2d outward =
        neighbour == RingNeighbour::INSIDE ? Eigen::Vector2d(-points[i].normal()) : (from - middle).normalized();
    if (const auto position = lineFrom(I, from, outward, middle, neighbour, rise)) {
      line.push_back({*position, outward});
    }
    else {
      ++missed;
    }
  }
  return static_cast<double>(line.size()) / static_cast<double>(directions.count);
}

bool mayHaveDarkLineBeside(const vpImage<unsigned char> &I, const EdgePixel *pixels, std::size_t count,
                           RingNeighbour neighbour, double rise)
{
  const auto positionOf = [&](std::size_t i) { return Eigen::Vector2d(pixels[i].x, pixels[i].y); };
  const Eigen::Vector2d middle = middleOf(count, positionOf);
  const Directions directions(count, fewDirections);
  const std::size_t mostMissed = directions.mostMissed(leastInFew);
  std::size_t missed = 0;
  for (std::size_t i = 0; i < count && missed <= mostMissed; i += directions.stride) {
    const Eigen::Vector2d from = positionOf(i);
    missed += lineFrom(I, from, (from - middle).normalized(), middle, neighbour, rise) ? 0 : 1;
  }
  return missed <= mostMissed;
}
} // namespace circle_marker
END_VISP_NAMESPACE
