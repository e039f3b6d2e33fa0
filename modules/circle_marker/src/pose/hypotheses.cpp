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
 * The poses a marker may have, from the ellipse of its outer edge.
 */

#include "pose/hypotheses.h"

#include "ellipse/fit_conic.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
void scaleTo(double size, PosePair &poses)
{
  for (MarkerPlane &plane : poses) {
    plane.center *= 0.5 * size / plane.radius;
    plane.radius = 0.5 * size;
  }
}

MarkerPlane planeOf(const CirclePosition &position, double radius)
{
  MarkerPlane plane;
  plane.center = position.center;
  plane.radius = radius;
  plane.rotation = rotationFromCirclePosition(position);
  return plane;
}

std::optional<PosePair> posesFromOutline(const std::vector<EdgePoint> &points, const CameraModel &camera, double radius)
{
  std::vector<Eigen::Vector2d> meters;
  return posesFromOutline(points, camera, radius, meters);
}

std::optional<PosePair> posesFromOutline(const std::vector<EdgePoint> &points, const CameraModel &camera, double radius,
                                         std::vector<Eigen::Vector2d> &meters)
{
  meters.clear();
  for (const EdgePoint &point : points) {
    meters.push_back(camera.toMeter(point.position));
  }
  const auto conic = fitEllipse(meters.data(), meters.size());
  if (!conic) {
    return std::nullopt;
  }
  const auto circles = circlesFromConic(*conic, radius);
  if (!circles) {
    return std::nullopt;
  }
  return PosePair{planeOf((*circles)[0], radius), planeOf((*circles)[1], radius)};
}
} // namespace circle_marker
END_VISP_NAMESPACE
