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

#include "circle_from_conic.h"

#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <Eigen/LU>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
/*!
  An ellipse (x - center)^T A (x - center) + offset = 0 with A positive definite and offset < 0. Unlike the conic's nine
  coefficients it keeps the size of a small ellipse far from the image's centre free of cancellation.
*/
struct CenteredEllipse
{
  Eigen::Matrix2d A;
  Eigen::Vector2d center;
  double offset;

  //! Value of the cone's bilinear form for two directions of the camera frame: a sum without cancellation.
  double form(const Eigen::Vector3d &d, const Eigen::Vector3d &e) const
  {
    const Eigen::Vector2d u = d.head<2>() - center * d.z();
    const Eigen::Vector2d v = e.head<2>() - center * e.z();
    return u.dot(A * v) + offset * d.z() * e.z();
  }
};

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

/*!
  Eigenvector of the cone's negative eigenvalue, the axis of the cone, and that eigenvalue. In a basis (E, d) with d the
  line of sight to the ellipse's centre the cone is [A', b; b^T, q], and the eigenvalue is the root below q of
  f(l) = q - l - b^T (A' - l I)^-1 b, which is concave and decreasing there: Newton from q converges monotonically.
*/
std::optional<Eigen::Vector3d> coneAxis(const CenteredEllipse &ellipse, double &eigenvalue)
{
  const Eigen::Vector3d sight = Eigen::Vector3d(ellipse.center.x(), ellipse.center.y(), 1.).normalized();
  const Eigen::Vector3d e1 = sight.unitOrthogonal();
  const Eigen::Vector3d e2 = sight.cross(e1);
  Eigen::Matrix2d A;
  A(0, 0) = ellipse.form(e1, e1);
  A(1, 1) = ellipse.form(e2, e2);
  A(0, 1) = A(1, 0) = ellipse.form(e1, e2);
  // The ellipse's own centre has no linear term: only the offset is left of the bilinear form.
  const double q = ellipse.offset * sight.z() * sight.z();
  const Eigen::Vector2d b = ellipse.offset * sight.z() * Eigen::Vector2d(e1.z(), e2.z());

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
  if (!(radius > 0.) || !std::isfinite(radius)) {
    return std::nullopt;
  }
  const std::optional<CenteredEllipse> ellipse = centerConic(Q);
  if (!ellipse) {
    return std::nullopt;
  }
  double lambda3 = 0.;
  const std::optional<Eigen::Vector3d> axis = coneAxis(*ellipse, lambda3);
  if (!axis) {
    return std::nullopt;
  }

  // Across the axis the other two eigenvalues are those of a 2x2 matrix: their difference is a hypotenuse, exact even
  // where they are nearly equal, that is where the circle is seen along its own axis.
  const Eigen::Vector3d u = axis->unitOrthogonal();
  const Eigen::Vector3d v = axis->cross(u);
  const double uu = ellipse->form(u, u), vv = ellipse->form(v, v), uv = ellipse->form(u, v);
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

vpHomogeneousMatrix poseFromCirclePosition(const CirclePosition &position)
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
  vpHomogeneousMatrix cMo;
  for (unsigned int i = 0; i < 3; i++) {
    cMo[i][0] = x(i);
    cMo[i][1] = y(i);
    cMo[i][2] = z(i);
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
