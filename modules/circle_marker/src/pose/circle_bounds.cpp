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
 * Where in the image a marker is.
 */

#include "pose/circle_bounds.h"

#include <cmath>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
ImageBounds boundsOfCircle(const MarkerPlane &plane, const CameraModel &camera, double radius, int points)
{
  ImageBounds bounds = {Eigen::Vector2d(HUGE_VAL, HUGE_VAL), Eigen::Vector2d(-HUGE_VAL, -HUGE_VAL)};
  const auto add = [&](const Eigen::Vector2d &q) {
    const Eigen::Vector2d p = camera.toPixel(plane.project(q));
    if (p.allFinite()) { // a lens does not show all of the space in front of it
      bounds.least = bounds.least.cwiseMin(p);
      bounds.most = bounds.most.cwiseMax(p);
    }
  };
  add(Eigen::Vector2d::Zero());
  for (int i = 0; i < points; ++i) {
    const double angle = 2. * M_PI * i / points;
    add(radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return bounds;
}
} // namespace circle_marker
END_VISP_NAMESPACE
