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
 * Ellipses as conics, as axes and centred: conversions and distances.
 */

#include "ellipse/conic.h"

#include <array>
#include <cmath>
#include <limits>

#include <Eigen/LU>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
/*!
  Dot product as exact as in doubled precision, then rounded: Dot2 of T. Ogita, S. Rump and S. Oishi, Accurate sum and
  dot product, SIAM Journal on Scientific Computing 26 (2005).
*/
template <std::size_t size> double accurateDot(const std::array<double, size> &x, const std::array<double, size> &y)
{
  double sum = 0., error = 0.;
  for (std::size_t i = 0; i < size; i++) {
    const double product = x[i] * y[i];
    const double next = sum + product;
    const double part = next - sum;
    error += std::fma(x[i], y[i], -product) + ((sum - (next - part)) + (product - part));
    sum = next;
  }
  return sum + error;
}

} // namespace

std::optional<CenteredEllipse> centerConic(const Eigen::Matrix3d &Q)
{
  const Eigen::Matrix3d symmetric = Q.selfadjointView<Eigen::Upper>();
  const double scale = symmetric.cwiseAbs().maxCoeff();
  if (!symmetric.allFinite() || !(scale > 0.)) {
    return std::nullopt;
  }
  // A power of two, so that scaling rounds nothing.
  const double sign = (symmetric(0, 0) + symmetric(1, 1) < 0.) ? -1. : 1.;
  const int exponent = std::ilogb(scale);
  const Eigen::Matrix3d C = symmetric.unaryExpr([=](double c) { return sign * std::scalbn(c, -exponent); });

  CenteredEllipse ellipse;
  ellipse.A = C.topLeftCorner<2, 2>();
  const Eigen::Vector2d b = C.topRightCorner<2, 1>();
  const double det = ellipse.A(0, 0) * ellipse.A(1, 1) - ellipse.A(0, 1) * ellipse.A(0, 1);
  const double epsilon = std::numeric_limits<double>::epsilon();
  // A parabola's determinant, computed, is this small: two products rounded once each, and their difference.
  if (!(det > 2. * epsilon * ellipse.A(0, 0) * ellipse.A(1, 1)) || !(ellipse.A(0, 0) > 0.)) {
    return std::nullopt;
  }
  ellipse.center << (ellipse.A(0, 1) * b(1) - ellipse.A(1, 1) * b(0)) / det,
      (ellipse.A(0, 1) * b(0) - ellipse.A(0, 0) * b(1)) / det;
  // The value of the form at the centre, where an error of the centre counts in the second order only; its terms are up
  // to the square of (distance of the centre / size of the ellipse) larger than their sum.
  const double cx = ellipse.center.x(), cy = ellipse.center.y();
  const double gx = accurateDot<3>({C(0, 0), C(0, 1), C(0, 2)}, {cx, cy, 1.});
  const double gy = accurateDot<3>({C(0, 1), C(1, 1), C(1, 2)}, {cx, cy, 1.});
  ellipse.offset = accurateDot<5>({C(0, 2), C(1, 2), C(2, 2), gx, gy}, {cx, cy, 1., cx, cy});
  // A point's offset is this small: half a unit in the last place of each coefficient times its monomial.
  const double largest = std::fabs(C(0, 2) * cx) + std::fabs(C(1, 2) * cy) + std::fabs(C(2, 2));
  if (!ellipse.center.allFinite() || !(ellipse.offset < -2. * epsilon * largest)) {
    return std::nullopt;
  }
  return ellipse;
}

std::optional<EllipseParameters> ellipseFromConic(const Eigen::Matrix3d &Q)
{
  const std::optional<CenteredEllipse> centered = centerConic(Q);
  if (!centered) {
    return std::nullopt;
  }
  const Eigen::Matrix2d &A = centered->A;
  const double difference = std::hypot(A(0, 0) - A(1, 1), 2. * A(0, 1));
  const double larger = 0.5 * (A(0, 0) + A(1, 1) + difference);
  const double smaller = (A(0, 0) * A(1, 1) - A(0, 1) * A(0, 1)) / larger;
  EllipseParameters ellipse;
  ellipse.center = centered->center;
  ellipse.a = std::sqrt(-centered->offset / smaller);
  ellipse.b = std::sqrt(-centered->offset / larger);
  // The major axis is the direction of the smaller eigenvalue.
  ellipse.angle = (difference > 0.) ? 0.5 * std::atan2(-2. * A(0, 1), A(1, 1) - A(0, 0)) : 0.;
  if (ellipse.angle <= -M_PI_2) {
    ellipse.angle = M_PI_2;
  }
  if (!std::isfinite(ellipse.a) || !(ellipse.b > 0.)) {
    return std::nullopt;
  }
  return ellipse;
}

Eigen::Vector2d halfExtents(const EllipseParameters &ellipse)
{
  const double c = std::cos(ellipse.angle);
  const double s = std::sin(ellipse.angle);
  // The norms of its axes' components.
  return {std::hypot(ellipse.a * c, ellipse.b * s), std::hypot(ellipse.a * s, ellipse.b * c)};
}

Eigen::Matrix3d conicFromEllipse(const EllipseParameters &ellipse)
{
  // Scaled by b^2, so that a slender ellipse stays finite: (distance along b)^2 + (b / a)^2 (distance along a)^2 = b^2.
  const double ratio = ellipse.b / ellipse.a;
  const Eigen::Vector2d major(std::cos(ellipse.angle), std::sin(ellipse.angle));
  const Eigen::Vector2d minor(-major.y(), major.x());
  const Eigen::Matrix2d A = ratio * ratio * major * major.transpose() + minor * minor.transpose();
  Eigen::Matrix3d Q;
  Q.topLeftCorner<2, 2>() = A;
  Q.topRightCorner<2, 1>() = -A * ellipse.center;
  Q.bottomLeftCorner<1, 2>() = Q.topRightCorner<2, 1>().transpose();
  Q(2, 2) = ellipse.center.dot(A * ellipse.center) - ellipse.b * ellipse.b;
  return Q / Q.norm();
}

double sampsonDistance(const Eigen::Matrix3d &Q, const Eigen::Vector2d &point)
{
  const Eigen::Vector3d x(point.x(), point.y(), 1.);
  const Eigen::Vector3d polar = Q * x;
  return x.dot(polar) / (2. * polar.head<2>().norm());
}
} // namespace circle_marker
END_VISP_NAMESPACE
