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
 * Covariance of the pose of a circle from the noise of its contour.
 */

#include "pose/circle_covariance.h"

#include <cmath>
#include <limits>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
Eigen::Matrix<double, 1, 6> circleDistanceJacobian(const CirclePosition &circle, const Eigen::Vector2d &point)
{
  const Eigen::Vector3d &normal = circle.normal;
  const Eigen::Vector3d x = point.homogeneous();
  const double s = normal.dot(circle.center) / normal.dot(x);
  const Eigen::Vector3d e = (s * x - circle.center).normalized();
  const Eigen::Vector3d g = e - normal * (e.dot(x) / normal.dot(x));
  Eigen::Matrix<double, 1, 6> J;
  J << -g.transpose(), -s * x.cross(g).transpose();
  return J / (s * g.head<2>().norm());
}

Eigen::Matrix<double, 6, 6> circleCovariance(const CirclePosition &circle, const std::vector<Eigen::Vector2d> &points,
                                             double sigma)
{
  // delta = B (translation of the centre, rotation about it): a rotation about C moves the origin by C x omega.
  Eigen::Matrix<double, 6, 6> B = Eigen::Matrix<double, 6, 6>::Zero();
  const Eigen::Vector3d first = circle.normal.unitOrthogonal();
  B.topLeftCorner<3, 3>().setIdentity();
  B.bottomRightCorner<3, 3>() << first, circle.normal.cross(first), circle.normal;
  for (int i = 3; i < 6; i++) {
    B.block<3, 1>(0, i) = circle.center.cross(B.block<3, 1>(3, i));
  }

  Eigen::Matrix<double, 5, 5> information = Eigen::Matrix<double, 5, 5>::Zero();
  for (const Eigen::Vector2d &point : points) {
    const Eigen::Matrix<double, 1, 5> J = circleDistanceJacobian(circle, point) * B.leftCols<5>();
    if (J.allFinite()) { // the image of the centre itself is as far from all of the circle
      information += J.transpose() * J / (sigma * sigma);
    }
  }
  const double uniformTiltVariance = M_PI * M_PI / 12.; // Of an interval of length pi.
  information(3, 3) += 1. / uniformTiltVariance;
  information(4, 4) += 1. / uniformTiltVariance;

  // Metres and radians differ by orders of magnitude: scaled to a unit diagonal the inverse loses no digits to that. It
  // is the product of a factor and its transpose, so that no variance is negative where terms of a circle far from the
  // axis cancel each other.
  const Eigen::Matrix<double, 5, 1> scale = information.diagonal().cwiseSqrt().cwiseInverse();
  Eigen::Matrix<double, 5, 5> scaled = scale.asDiagonal() * information * scale.asDiagonal();
  // What rounding leaves unknown of sums over the points; with it the factor is always there.
  scaled.diagonal().array() += static_cast<double>(points.size()) * std::numeric_limits<double>::epsilon();
  Eigen::Matrix<double, 6, 5> seen = B.leftCols<5>() * scale.asDiagonal();
  scaled.llt().matrixU().solveInPlace<Eigen::OnTheRight>(seen);
  Eigen::Matrix<double, 6, 6> factor;
  factor << seen, std::sqrt(uniformSpinVariance) * B.col(5);
  Eigen::Matrix<double, 6, 6> half = Eigen::Matrix<double, 6, 6>::Zero();
  half.selfadjointView<Eigen::Lower>().rankUpdate(factor);
  return half.selfadjointView<Eigen::Lower>();
}
} // namespace circle_marker
END_VISP_NAMESPACE
