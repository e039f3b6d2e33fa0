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
 * Distance of a pixel to the edges of a print.
 */

#ifndef VP_TEST_PATTERN_DISTANCE_H
#define VP_TEST_PATTERN_DISTANCE_H

#include <algorithm>
#include <cmath>

#include "refine/plane_point.h"

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace room_test {
using namespace circle_marker;

/*! Where a pixel lies on the pattern. */
struct PatternDistance
{
  double toEdges = 0.;        //!< Distance to the nearest edge, pixels, to first order.
  double radius = 0.;         //!< Distance to the marker's centre, in units of the outer radius.
  double radiusPerPixel = 0.; //!< Length of its gradient in the image.
};

/*! Where a pixel lies on the pattern at a pose. */
inline PatternDistance distanceToPattern(const ModelPixel &pixel, const MarkerPlane &plane,
                                         const MarkerPattern &pattern)
{
  const PlanePoint point = planePoint(pixel, plane);
  PatternDistance distance;
  // At the very centre the direction does not matter: no edge is near.
  distance.radius = std::max(point.q.norm(), 1e-6);
  distance.radiusPerPixel = (point.byPixel.transpose() * (point.q / distance.radius)).norm();
  distance.toEdges = HUGE_VAL;
  const auto circle = [&distance](const RadialEdge &edge) {
    distance.toEdges = std::min(distance.toEdges, std::abs(edge.radius - distance.radius) / distance.radiusPerPixel);
  };
  for (unsigned int i = 0; i < pattern.ringEdges; ++i) {
    circle(pattern.ring[i]);
  }
  if (pattern.sectors == 0) {
    return distance;
  }
  circle(pattern.track[0]);
  circle(pattern.track[1]);
  if (distance.radius < pattern.track[0].radius && distance.radius > pattern.track[1].radius) {
    const int nearest = pattern.nearestBorder(point.q);
    for (int border = nearest - 1; border <= nearest + 1; ++border) {
      if (pattern.isBlack(border) != pattern.isBlack(border - 1)) {
        const Eigen::Vector2d &across = pattern.acrossBorder(border);
        distance.toEdges =
            std::min(distance.toEdges, std::abs(across.dot(point.q)) / (point.byPixel.transpose() * across).norm());
      }
    }
  }
  return distance;
}
} // namespace room_test

#endif
