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
 * Grey levels inside and beside an outline.
 */

#include "ellipse/outline_greys.h"

#include <algorithm>
#include <array>

#include "ellipse/ellipse_walk.h"
#include "support/bilinear.h"
#include "support/median.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Where dark and bright are read beside an edge point, pixels: past most of the blur, short of the other side of a ring
// of 15 pixels, which is 1.5 pixels thick.
constexpr double besideEdge = 1.5;
// A centre is bright (dark) if it lies this share of the step at the outline above the dark side (below the bright
// side). The centre of a ring of 8 pixels keeps a third after the blur; a dark blob has none.
constexpr double leastCenter = 0.1;
// Where that is looked for if something covers the centre: share of the way to the edge, inside of the code track; and
// how bright it has to be there, share of the step.
constexpr double besideCenter = 0.3;
constexpr double clearlyBright = 0.6;
// Or, if the code track is covered as well, between that and the ring: share of the way, and of the directions.
constexpr double gap = 0.74;
constexpr int gapDirections = 8;
constexpr int leastBrightInGap = 6;
} // namespace

double medianContrast(const vpImage<unsigned char> &I, const EllipseCandidate &candidate)
{
  constexpr int directions = 32;
  constexpr int reach = 3; // pixels to either side: past the blur of the edge
  std::array<int, directions> steps;
  std::size_t count = 0;
  EllipseWalk walk(candidate.ellipse, directions);
  for (int i = 0; i < directions; ++i, walk.next()) {
    const EdgePoint where = walk.here();
    const Eigen::Vector2d normal = where.normal();
    int brightest = -1;
    int darkest = 256;
    for (int t = -reach; t <= reach; ++t) {
      const Eigen::Vector2d p = where.position + t * normal;
      if (!(p.x() > -0.5 && p.y() > -0.5 && p.x() < I.getWidth() - 0.5 && p.y() < I.getHeight() - 0.5)) {
        continue;
      }
      const int grey = I[static_cast<unsigned int>(p.y() + 0.5)][static_cast<unsigned int>(p.x() + 0.5)];
      if (t > 0) {
        brightest = std::max(brightest, grey);
      }
      else {
        darkest = std::min(darkest, grey);
      }
    }
    if (brightest >= 0 && darkest <= 255) {
      steps[count++] = brightest - darkest;
    }
  }
  if (count == 0) {
    return 0.;
  }
  return medianOf(steps, count);
}

GreysBeside greysBeside(const vpImage<unsigned char> &I, const EdgePoint *points, std::size_t count)
{
  constexpr std::size_t samples = 16;
  GreysBeside beside;
  int seen = 0;
  for (std::size_t k = 0; k < samples; ++k) {
    const EdgePoint &point = points[k * count / samples];
    const Eigen::Vector2d beyond = besideEdge * point.normal();
    const auto inside = bilinear(I, point.position - beyond);
    const auto outside = bilinear(I, point.position + beyond);
    if (inside && outside) {
      beside.dark += *inside;
      beside.bright += *outside;
      ++seen;
    }
  }
  beside.dark /= std::max(seen, 1);
  beside.bright /= std::max(seen, 1);
  return beside;
}

bool hasSoughtCenter(const vpImage<unsigned char> &I, const EdgePoint *points, std::size_t count,
                     const Eigen::Vector2d &center, const SoughtCenters &sought)
{
  if (sought.bright && sought.dark) {
    return true;
  }
  const auto grey = bilinear(I, center);
  if (!grey) {
    return true; // cut by the image's border: what is left of it decides later
  }
  const GreysBeside beside = greysBeside(I, points, count);
  const double step = beside.bright - beside.dark;
  const double aboveDark = *grey - beside.dark;
  if (!sought.bright) {
    return aboveDark <= (1. - leastCenter) * step;
  }
  if (aboveDark >= leastCenter * step) {
    return true;
  }
  // Something dark may cover the middle: what lies toward the edge that is seen is white then.
  const auto brightAt = [&](double share, int directions) {
    int bright = 0;
    for (int k = 0; k < directions; ++k) {
      const EdgePoint &point = points[static_cast<std::size_t>(k) * count / static_cast<std::size_t>(directions)];
      const auto toward = bilinear(I, center + share * (point.position - center));
      bright += toward && *toward - beside.dark >= clearlyBright * step ? 1 : 0;
    }
    return bright;
  };
  constexpr int directions = 4;
  return brightAt(besideCenter, directions) > 0 || brightAt(gap, gapDirections) >= leastBrightInGap;
}

bool isDarkThroughout(const vpImage<unsigned char> &I, const EdgePoint *points, std::size_t count)
{
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < count; ++i) {
    center += points[i].position;
  }
  center /= static_cast<double>(count);
  const GreysBeside beside = greysBeside(I, points, count);
  const double most = beside.dark + leastCenter * (beside.bright - beside.dark);
  constexpr std::size_t directions = 4;
  bool isDark = bilinear(I, center).value_or(255.) < most;
  for (std::size_t k = 0; k < directions && isDark; ++k) {
    const Eigen::Vector2d halfway = 0.5 * (center + points[k * count / directions].position);
    isDark = bilinear(I, halfway).value_or(255.) < most;
  }
  return isDark;
}
} // namespace circle_marker
END_VISP_NAMESPACE
