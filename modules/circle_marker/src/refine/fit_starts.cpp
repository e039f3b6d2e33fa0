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
 * Where the fits of a marker start from.
 */

#include "refine/fit_starts.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "support/cross_matrix.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Error with which the closed form knows the axes of the outline, pixels.
constexpr double outlineError = 0.1;

// The marker turned about its centre, the shortest way, so that its normal has another direction, which is not the
// opposite one: with the cross product v of the two and their cosine c, by I + [v] + [v]^2 / (1 + c) (Rodrigues).
MarkerPlane turnedTo(const MarkerPlane &plane, const Eigen::Vector3d &normal)
{
  const Eigen::Vector3d former = plane.rotation.col(2);
  const Eigen::Matrix3d cross = crossMatrix(former.cross(normal));
  MarkerPlane turned = plane;
  turned.rotation += (cross + cross * cross / (1. + former.dot(normal))) * plane.rotation;
  return turned;
}
} // namespace

double meterPerPixelAt(const MarkerPlane &plane, const CameraModel &camera)
{
  const Eigen::Vector2d pixel = camera.toPixel(plane.project(Eigen::Vector2d::Zero()));
  return std::sqrt(std::abs(camera.meterPerPixel(pixel).determinant()));
}

Few<FitStart> startsOf(const PosePair &poses, const CameraModel &camera, bool spinIsKnown, bool mayMove)
{
  const MarkerPlane &plane = poses[0];
  const Eigen::Vector3d sight = plane.center.normalized();
  const double radius = plane.radius / (plane.center.z() * meterPerPixelAt(plane, camera)); // pixels
  const double leastTilt = std::sqrt(2. * outlineError / radius); // its cosine shortens an axis by outlineError
  if (!mayMove || std::acos(std::min(plane.rotation.col(2).dot(sight), 1.)) > leastTilt) {
    // Without a code the spins are any: what lies around the marker is known by its direction in one of them.
    MarkerPlane second = poses[1];
    if (!spinIsKnown) {
      copySpin(poses[0], second);
    }
    Few<FitStart> two;
    two.push_back({poses[0], std::nullopt, std::nullopt});
    two.push_back({second, std::nullopt, std::nullopt});
    return two;
  }
  const Eigen::Vector3d first = plane.rotation.col(0) - plane.rotation.col(0).dot(sight) * sight;
  const Eigen::Vector3d across = first.normalized();
  const Eigen::Vector3d along = sight.cross(across);
  Few<FitStart> starts;
  for (const Eigen::Vector3d &direction : {across, Eigen::Vector3d(-across), along, Eigen::Vector3d(-along)}) {
    const Eigen::Vector3d normal = std::cos(leastTilt) * sight + std::sin(leastTilt) * direction;
    starts.push_back({turnedTo(plane, normal), std::nullopt, std::nullopt});
  }
  return starts;
}

MarkerPlane mirrored(const MarkerPlane &plane)
{
  const Eigen::Vector3d sight = plane.center.normalized();
  const Eigen::Vector3d normal = plane.rotation.col(2);
  return turnedTo(plane, 2. * normal.dot(sight) * sight - normal);
}
} // namespace circle_marker
END_VISP_NAMESPACE
