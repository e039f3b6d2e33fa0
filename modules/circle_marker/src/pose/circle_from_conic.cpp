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
 * Closed-form position of a circle of known radius from its image conic.
 */

#include "pose/circle_from_conic.h"

#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
//! Value of the cone's bilinear form for two directions of the camera frame: a sum without cancellation.
double coneForm(const CenteredEllipse &ellipse, const Eigen::Vector3d &d, const Eigen::Vector3d &e)
{
  const Eigen::Vector2d u = d.head<2>() - ellipse.center * d.z();
  const Eigen::Vector2d v = e.head<2>() - ellipse.center * e.z();
  return u.dot(ellipse.A * v) + ellipse.offset * d.z() * e.z();
}

/*!
  Eigenvector of the cone's negative eigenvalue, the axis of the cone, and that eigenvalue. In a basis (E, d) with d the
  line of sight to the ellipse's centre the cone is [A', b; b^T, q], and the eigenvalue is the root of
  f(l) = q - l - b^T (A' - l I)^-1 b below q and below the eigenvalues of A'. There f is concave and decreasing: Newton
  from q converges monotonically. Where q is not below them, which takes a circle of some 110 degrees and more, no
  digits are lost by the eigenvalues of the whole matrix.
*/
std::optional<Eigen::Vector3d> coneAxis(const CenteredEllipse &ellipse, double &eigenvalue)
{
  const Eigen::Vector3d sight = Eigen::Vector3d(ellipse.center.x(), ellipse.center.y(), 1.).normalized();
  const Eigen::Vector3d e1 = sight.unitOrthogonal();
  const Eigen::Vector3d e2 = sight.cross(e1);
  Eigen::Matrix2d A;
  A(0, 0) = coneForm(ellipse, e1, e1);
  A(1, 1) = coneForm(ellipse, e2, e2);
  A(0, 1) = A(1, 0) = coneForm(ellipse, e1, e2);
  // The ellipse's own centre has no linear term: only the offset is left of the bilinear form.
  const double q = ellipse.offset * sight.z() * sight.z();
  const Eigen::Vector2d b = ellipse.offset * sight.z() * Eigen::Vector2d(e1.z(), e2.z());

  const double least = 0.5 * (A.trace() - std::hypot(A(0, 0) - A(1, 1), 2. * A(0, 1))); // eigenvalue of A'
  if (q >= least) {
    Eigen::Matrix3d cone;
    cone << A, b, b.transpose(), q;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(cone);
    if (eigen.info() != Eigen::Success) {
      return std::nullopt;
    }
    eigenvalue = eigen.eigenvalues()[0];
    const Eigen::Vector3d v = std::copysign(1., eigen.eigenvectors()(2, 0)) * eigen.eigenvectors().col(0);
    return e1 * v[0] + e2 * v[1] + sight * v[2];
  }
  eigenvalue = q;
  Eigen::Vector2d x = Eigen::Vector2d::Zero();
  const int maximumIterations =
      60; // Quadratic convergence: 3 to 6 are used; more only for fields of view near 180 deg.
  for (int i = 0; i < maximumIterations; i++) {
    const Eigen::Matrix2d inverse = (A - eigenvalue * Eigen::Matrix2d::Identity()).inverse();
    x = -inverse * b;
    const double step = (q - eigenvalue + b.dot(x)) / (1. + x.squaredNorm());
    eigenvalue += step;
    if (!(std::fabs(step) > std::numeric_limits<double>::epsilon() * std::fabs(eigenvalue))) {
      break;
    }
  }
  if (!std::isfinite(eigenvalue) || !x.allFinite()) {
    return std::nullopt;
  }
  return (e1 * x(0) + e2 * x(1) + sight).normalized();
}
} // namespace

std::optional<std::array<CirclePosition, 2>> circlesFromConic(const Eigen::Matrix3d &Q, double radius)
{
  const std::optional<CenteredEllipse> ellipse = centerConic(Q);
  return ellipse ? circlesFromEllipse(*ellipse, radius) : std::nullopt;
}

std::optional<std::array<CirclePosition, 2>> circlesFromEllipse(const CenteredEllipse &ellipse, double radius)
{
  if (!(radius > 0.) || !std::isfinite(radius)) {
    return std::nullopt;
  }
  double lambda3 = 0.;
  const std::optional<Eigen::Vector3d> axis = coneAxis(ellipse, lambda3);
  if (!axis) {
    return std::nullopt;
  }

  // Across the axis the other two eigenvalues are those of a 2x2 matrix: their difference is a hypotenuse, exact even
  // where they are nearly equal, that is where the circle is seen along its own axis.
  const Eigen::Vector3d u = axis->unitOrthogonal();
  const Eigen::Vector3d v = axis->cross(u);
  const double uu = coneForm(ellipse, u, u), vv = coneForm(ellipse, v, v), uv = coneForm(ellipse, u, v);
  const double difference = std::hypot(uu - vv, 2. * uv);
  const double lambda1 = 0.5 * (uu + vv + difference);
  const double lambda2 = (uu * vv - uv * uv) / lambda1; // The product of both: no cancellation for a slender ellipse.
  const double angle = 0.5 * std::atan2(2. * uv, uu - vv);
  const Eigen::Vector3d e1 = std::cos(angle) * u + std::sin(angle) * v;

  const double g = std::sqrt(difference / (lambda1 - lambda3));
  const double k = std::sqrt((lambda2 - lambda3) / (lambda1 - lambda3));
  const double factor = radius / std::sqrt(-lambda1 * lambda3);
  std::array<CirclePosition, 2> circles;
  for (int i = 0; i < 2; i++) {
    const double s = (i == 0) ? 1. : -1.;
    circles[i].normal = s * g * e1 + k * *axis;
    circles[i].center = factor * (s * lambda3 * g * e1 + lambda1 * k * *axis);
    if (!circles[i].center.allFinite() || !circles[i].normal.allFinite()) {
      return std::nullopt;
    }
  }
  if (circles[0].normal.z() < circles[1].normal.z()) {
    std::swap(circles[0], circles[1]);
  }
  return circles;
}

Eigen::Matrix3d rotationFromCirclePosition(const CirclePosition &position)
{
  const Eigen::Vector3d z = position.normal.normalized();
  // Below this sine of the angle to the camera's x axis the projection onto the plane is mostly rounding.
  const double leastSine = 1e-6;
  Eigen::Vector3d x = Eigen::Vector3d::UnitX() - z.x() * z;
  Eigen::Vector3d y;
  if (x.norm() > leastSine) {
    x.normalize();
    y = z.cross(x);
  }
  else {
    y = (Eigen::Vector3d::UnitY() - z.y() * z).normalized();
    x = y.cross(z);
  }
  Eigen::Matrix3d rotation;
  rotation << x, y, z;
  return rotation;
}

vpHomogeneousMatrix poseFromCirclePosition(const CirclePosition &position)
{
  const Eigen::Matrix3d rotation = rotationFromCirclePosition(position);
  vpHomogeneousMatrix cMo;
  for (unsigned int i = 0; i < 3; i++) {
    for (unsigned int j = 0; j < 3; j++) {
      cMo[i][j] = rotation(i, j);
    }
    cMo[i][3] = position.center(i);
  }
  return cMo;
}

Eigen::Matrix3d conicFromPose(const vpHomogeneousMatrix &cMo, double radius)
{
  Eigen::Matrix<double, 3, 2> plane;
  Eigen::Vector3d center, normal;
  for (unsigned int i = 0; i < 3; i++) {
    plane(i, 0) = cMo[i][0];
    plane(i, 1) = cMo[i][1];
    normal(i) = cMo[i][2];
    center(i) = cMo[i][3];
  }
  // The ray x meets the plane at x h / (normal . x); P x, divided by normal . x, is that point in marker coordinates.
  const Eigen::Matrix<double, 2, 3> P =
      normal.dot(center) * plane.transpose() - (plane.transpose() * center) * normal.transpose();
  const Eigen::Matrix3d Q = P.transpose() * P - radius * radius * normal * normal.transpose();
  return Q / Q.norm();
}
} // namespace circle_marker
END_VISP_NAMESPACE
