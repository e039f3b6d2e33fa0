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

#include "refine/pattern_distance.h"

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
PlanePoint planePoint(const ModelPixel &pixel, const MarkerPlane &plane)
{
  const Eigen::Vector3d ray(pixel.meter.x(), pixel.meter.y(), 1.);
  const Eigen::Vector3d normal = plane.rotation.col(2);
  const double slope = normal.dot(ray);
  const double depth = normal.dot(plane.center) / slope;
  const Eigen::Vector3d m = depth * ray - plane.center;
  PlanePoint point;
  for (int axis = 0; axis < 2; ++axis) {
    const Eigen::Vector3d e = plane.rotation.col(axis);
    point.q[axis] = e.dot(m) / plane.radius;
    const Eigen::Vector3d byRay = depth * (e - e.dot(ray) / slope * normal) / plane.radius;
    point.byPixel.row(axis) = byRay.head<2>().transpose() * pixel.meterPerPixel;
  }
  return point;
}

PatternDistance distanceToPattern(const ModelPixel &pixel, const MarkerPlane &plane, const MarkerPattern &pattern)
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
} // namespace circle_marker
END_VISP_NAMESPACE
