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
 * Where a pixel lies on a marker.
 */

#include "refine/plane_point.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
PlanePoint planePoint(const ModelPixel &pixel, const MarkerPlane &plane)
{
  const Eigen::Vector3d ray(pixel.meter.x(), pixel.meter.y(), 1.);
  const Eigen::Vector3d normal = plane.rotation.col(2);
  const double perSlope = 1. / normal.dot(ray);
  const double perRadius = 1. / plane.radius;
  const double depth = normal.dot(plane.center) * perSlope * perRadius; // in radii
  const Eigen::Vector3d center = perRadius * plane.center;
  PlanePoint point;
  for (int axis = 0; axis < 2; ++axis) {
    const Eigen::Vector3d e = plane.rotation.col(axis);
    const double along = e.dot(ray);
    point.q[axis] = depth * along - e.dot(center);
    const Eigen::Vector2d byRay = depth * (e - along * perSlope * normal).head<2>();
    point.byPixel.row(axis) = byRay.transpose() * pixel.meterPerPixel;
  }
  if (plane.bend.isAny()) {
    // q' = q + h(q') s with the ray's slant s, whose own derivative is that of q over the camera's distance; the shift
    // along the plane changes it by some ten thousandths only.
    const Eigen::Vector2d slant = plane.slantAt(point.q);
    point.q = plane.bend.seenAt(point.q, slant);
    const double height = plane.bend.height(point.q);
    const Eigen::Vector2d slope = plane.bend.slope(point.q);
    const double perDepth = plane.radius / normal.dot(plane.center);
    point.byPixel *= 1. + height * perDepth;
    point.byPixel += slant * (slope.transpose() * point.byPixel).eval() / (1. - slope.dot(slant));
  }
  return point;
}
} // namespace circle_marker
END_VISP_NAMESPACE
