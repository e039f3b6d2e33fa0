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
#include <optional>

#include "support/bilinear.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
constexpr double step = 0.5; // pixel
// How far from its inner edge the line is sought, pixels: that of the largest ring that is sought this way is 1.4 wide,
// and the edge lies up to a blur inside of it.
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
  std::array<double, mostSteps + 1> greys;
  const std::size_t steps = std::min(static_cast<std::size_t>(reach / step), mostSteps);
  double brightest = 0.;
  std::size_t darkest = 0; // 0: not yet on the way down
  for (std::size_t i = 0; i <= steps; ++i) {
    const auto grey = bilinear(I, from + static_cast<double>(i) * step * direction);
    if (!grey) {
      return std::nullopt;
    }
    greys[i] = *grey;
    if (darkest == 0) {
      brightest = std::max(brightest, *grey);
      darkest = *grey < brightest - rise ? i : 0;
    }
    else if (*grey < greys[darkest]) {
      darkest = i;
    }
    else if (*grey > greys[darkest] + rise) {
      const double curvature = greys[darkest - 1] - 2. * greys[darkest] + greys[darkest + 1];
      const double offset = curvature > 0. ? 0.5 * (greys[darkest - 1] - greys[darkest + 1]) / curvature : 0.;
      return from + (static_cast<double>(darkest) + offset) * step * direction;
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
                      RingNeighbour neighbour, double rise, std::size_t most, std::vector<EdgePoint> &line)
{
  const Eigen::Vector2d middle = middleOf(count, [&](std::size_t i) { return points[i].position; });
  line.clear();
  std::size_t asked = 0;
  for (std::size_t i = 0; i < count; i += 1 + count / most, ++asked) {
    const Eigen::Vector2d &from = points[i].position;
    // Squarely across the inner edge; a sheet has corners.
    const Eigen::Vector2d outward =
        neighbour == RingNeighbour::INSIDE ? Eigen::Vector2d(-points[i].normal()) : (from - middle).normalized();
    if (const auto position = lineFrom(I, from, outward, middle, neighbour, rise)) {
      line.push_back({*position, outward});
    }
  }
  return static_cast<double>(line.size()) / static_cast<double>(asked);
}

bool mayHaveDarkLineBeside(const vpImage<unsigned char> &I, const EdgePixel *pixels, std::size_t count,
                           RingNeighbour neighbour, double rise)
{
  const auto positionOf = [&](std::size_t i) { return Eigen::Vector2d(pixels[i].x, pixels[i].y); };
  const Eigen::Vector2d middle = middleOf(count, positionOf);
  std::size_t asked = 0;
  std::size_t shown = 0;
  for (std::size_t i = 0; i < count; i += 1 + count / fewDirections, ++asked) {
    const Eigen::Vector2d from = positionOf(i);
    shown += lineFrom(I, from, (from - middle).normalized(), middle, neighbour, rise) ? 1 : 0;
  }
  return static_cast<double>(shown) >= leastInFew * static_cast<double>(asked);
}
} // namespace circle_marker
END_VISP_NAMESPACE
