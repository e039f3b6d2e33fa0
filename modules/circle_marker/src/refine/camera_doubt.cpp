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

#include "refine/edge_equations.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
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
  const Eigen::Matrix<double, 6, 4> derivative = poseByCamera(fit.plane, family, camera);
  fit.covariance += derivative * covariance * derivative.transpose();
}
} // namespace circle_marker
END_VISP_NAMESPACE
