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
 * What a doubtful calibration of the camera adds to the covariance of a pose.
 */

#include "refine/camera_doubt.h"

#include <algorithm>
#include <cmath>

#include "refine/edge_equations.h"
#include "refine/nearly_frontal.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// The image tells the square of the lean: px / py that is off by the share e moves that by 2 e, and the lean by
// e / lean, to first order. A marker that faces the camera leans by sqrt(2 e) then, with both parts of a complex number
// as in nearly_frontal.h; with e normal, of standard deviation s, the mean of its square is 2 s sqrt(2 / pi), as if the
// derivative were taken at a lean whose square is this part of s.
constexpr double leanOfDoubt = 0.627;

// Standard deviation of ln(px / py).
double doubtOfRatio(const Eigen::Matrix4d &covariance, const vpCameraParameters &camera)
{
  const Eigen::Vector2d byParameters(1. / camera.get_px(), -1. / camera.get_py());
  return std::sqrt(std::max(byParameters.dot(covariance.topLeftCorner<2, 2>() * byParameters), 0.));
}
} // namespace

Eigen::Matrix<double, 6, 4> poseByCamera(const MarkerPlane &plane, const vpCircleMarkerFamily &family,
                                         const CameraModel &camera)
{
  EdgeEquations equations(plane);
  PoseColumns right = PoseColumns::Zero(6, 4);
  forEachEdge(patternOf(family, 0), [&](const MarkerEdge &edge) {
    const EdgeEquations::Seen seen = equations.add(edge);
    right += seen.byPose * (seen.across * camera.meterByParameters(camera.toPixel(seen.meter)));
  });
  return equations.solve(right);
}

void addCameraDoubt(const Eigen::Matrix4d &covariance, const vpCircleMarkerFamily &family, const CameraModel &camera,
                    FittedPose &fit)
{
  if (covariance.isZero(0.)) {
    return;
  }
  const Eigen::Vector2d lean = leanOf(fit.plane);
  const double size = std::sqrt(lean.squaredNorm() + leanOfDoubt * doubtOfRatio(covariance, camera.getParameters()));
  if (size == 0.) {
    return;
  }
  const double share = lean.norm() / size;
  const Eigen::Vector2d along = lean.norm() > 0. ? Eigen::Vector2d(lean.normalized()) : Eigen::Vector2d::UnitX();
  const auto add = [&](const Eigen::Vector2d &toward, double weight) {
    const Eigen::Matrix<double, 6, 4> derivative = poseByCamera(leaningBy(fit.plane, size * toward), family, camera);
    fit.covariance += weight * derivative * covariance * derivative.transpose();
  };
  // One that faces the camera may lean either way, and with it the direction of what is added turns.
  add(along, 0.5 * (1. + share * share));
  add(Eigen::Vector2d(-along.y(), along.x()), 0.5 * (1. - share * share));
}
} // namespace circle_marker
END_VISP_NAMESPACE
