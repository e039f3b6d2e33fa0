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
 * What the tests of the pose of a circle share.
 */

#include "testPoseCircleTools.h"

#include <Eigen/Geometry>

namespace pose_circle_test {
double View::tilt() const
{
  return static_cast<double>(std::atan2(normal.cross(center).norm(), normal.dot(center)));
}

double View::nearest() const
{
  return static_cast<double>(center.z() - radius * std::sqrt(1.L - normal.z() * normal.z()));
}

Vector3 View::point(long double angle, long double factor) const
{
  const Vector3 u = normal.unitOrthogonal();
  return center + factor * radius * (std::cos(angle) * u + std::sin(angle) * normal.cross(u));
}

Matrix3 View::exactConic() const
{
  const long double h = normal.dot(center);
  return h * h * Matrix3::Identity() - h * (center * normal.transpose() + normal * center.transpose()) +
         (center.squaredNorm() - radius * radius) * normal * normal.transpose();
}

std::vector<Eigen::Vector2d> View::contour(int size, double factor) const
{
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < size; i++) {
    const Vector3 P = point(2.L * M_PI * i / size, factor);
    points.emplace_back(static_cast<double>(P.x() / P.z()), static_cast<double>(P.y() / P.z()));
  }
  return points;
}

View randomView(std::mt19937_64 &random, double radius, double nearDepth, double farDepth, double tilt)
{
  while (true) {
    View view;
    view.radius = radius;
    const double offset = std::tan(M_PI / 6.) * std::sqrt(uniform(random, 0., 1.));
    const double direction = uniform(random, 0., 2. * M_PI);
    const long double z = uniform(random, nearDepth, farDepth);
    view.center = z * Vector3(offset * std::cos(direction), offset * std::sin(direction), 1.L);
    const Vector3 sight = view.center.normalized();
    const Vector3 u = sight.unitOrthogonal();
    const long double azimuth = uniform(random, 0., 2. * M_PI);
    const long double sine = std::sin(static_cast<long double>(tilt));
    view.normal = std::cos(static_cast<long double>(tilt)) * sight +
                  sine * (std::cos(azimuth) * u + std::sin(azimuth) * sight.cross(u));
    view.normal.normalize();
    // A circle that reaches the plane of the camera's centre has no ellipse for an image.
    if (view.nearest() > 0.01 * static_cast<double>(z)) {
      return view;
    }
  }
}

Errors better(const Errors &a, const Errors &b)
{
  return (a.normal + a.center < b.normal + b.center) ? a : b;
}

vpMatrix toVisp(const Matrix3 &Q)
{
  vpMatrix matrix(3, 3);
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      matrix[i][j] = static_cast<double>(Q(i, j));
    }
  }
  return matrix;
}

Errors errorsOf(const View &view, const Eigen::Vector3d &center, const Eigen::Vector3d &normal)
{
  return {static_cast<double>((center.cast<long double>() - view.center).norm() / view.center.z()),
          static_cast<double>((normal.cast<long double>() - view.normal).norm())};
}

Errors errorsOf(const View &view, const vpHomogeneousMatrix &cMo, bool zAligned)
{
  const double sign = zAligned ? 1. : -1.;
  return errorsOf(view, {cMo[0][3], cMo[1][3], cMo[2][3]}, {sign * cMo[0][2], sign * cMo[1][2], sign * cMo[2][2]});
}
} // namespace pose_circle_test
