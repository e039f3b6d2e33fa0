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
 * Which of the two circles on a cone is the right one.
 */

#include "pose/circle_evidence.h"

#include <cmath>

#include <Eigen/Geometry>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
double squaredDistances(const Eigen::Matrix3d &conic, const std::vector<Eigen::Vector2d> &points)
{
  double sum = 0.;
  for (const Eigen::Vector2d &point : points) {
    const double distance = sampsonDistance(conic, point);
    sum += std::isfinite(distance) ? distance * distance : 0.; // the very centre is as far from all of the conic
  }
  return sum;
}

double squaredDistances(const CirclePosition &circle, double radius, const std::vector<Eigen::Vector2d> &points)
{
  return squaredDistances(conicFromPose(poseFromCirclePosition(circle), radius), points);
}

double concentricLogOdds(const std::array<CirclePosition, 2> &circles, double radius,
                         const std::vector<Eigen::Vector2d> &points, double sigma, std::size_t firstSize)
{
  const double variance = sigma * sigma * (1. + static_cast<double>(points.size()) / static_cast<double>(firstSize));
  return (squaredDistances(circles[1], radius, points) - squaredDistances(circles[0], radius, points)) /
         (2. * variance);
}

double normalLogOdds(const std::array<CirclePosition, 2> &circles, const Eigen::Vector3d &normal, double sigma)
{
  double squares[2];
  for (int i = 0; i < 2; i++) {
    // The side of the circle that the camera sees decides the sign.
    const Eigen::Vector3d away = (normal.dot(circles[i].center) < 0.) ? Eigen::Vector3d(-normal) : normal;
    // From sine and cosine, precise for small angles too.
    const double angle = std::atan2(away.cross(circles[i].normal).norm(), away.dot(circles[i].normal));
    squares[i] = angle * angle;
  }
  return (squares[1] - squares[0]) / (2. * sigma * sigma);
}
} // namespace circle_marker
END_VISP_NAMESPACE
