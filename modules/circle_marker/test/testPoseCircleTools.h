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
 * What the tests of the pose of a circle share: random views with their exact images.
 */

#ifndef VP_TEST_POSE_CIRCLE_TOOLS_H
#define VP_TEST_POSE_CIRCLE_TOOLS_H

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/core/vpMatrix.h>

#include "testRandom.h"

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace pose_circle_test {
// The truth is computed with more digits than what is tested.
using Vector3 = Eigen::Matrix<long double, 3, 1>;
using Matrix3 = Eigen::Matrix<long double, 3, 3>;

using random_test::randomOfTest;
using random_test::uniform;

//! A circle in front of a camera.
struct View
{
  Vector3 center;
  Vector3 normal; // away from the camera
  long double radius;

  Eigen::Vector3d c() const { return center.cast<double>(); }
  Eigen::Vector3d n() const { return normal.cast<double>(); }
  double depth() const { return static_cast<double>(center.z()); }

  //! Angle between the normal and the line of sight, radians.
  double tilt() const { return static_cast<double>(std::atan2(normal.cross(center).norm(), normal.dot(center))); }

  //! Depth of the circle's nearest point.
  double nearest() const { return static_cast<double>(center.z() - radius * std::sqrt(1.L - normal.z() * normal.z())); }

  Vector3 point(long double angle, long double factor = 1.L) const
  {
    const Vector3 u = normal.unitOrthogonal();
    return center + factor * radius * (std::cos(angle) * u + std::sin(angle) * normal.cross(u));
  }

  //! Image of the circle in normalised coordinates, correctly rounded but for its scale.
  Matrix3 exactConic() const
  {
    const long double h = normal.dot(center);
    return h * h * Matrix3::Identity() - h * (center * normal.transpose() + normal * center.transpose()) +
           (center.squaredNorm() - radius * radius) * normal * normal.transpose();
  }

  std::vector<Eigen::Vector2d> contour(int size, double factor = 1.) const
  {
    std::vector<Eigen::Vector2d> points;
    for (int i = 0; i < size; i++) {
      const Vector3 P = point(2.L * M_PI * i / size, factor);
      points.emplace_back(static_cast<double>(P.x() / P.z()), static_cast<double>(P.y() / P.z()));
    }
    return points;
  }
};

//! Centre anywhere in a cone of 60 degrees, normal at the angle tilt from the line of sight, all of it in front.
inline View randomView(std::mt19937_64 &random, double radius, double nearDepth, double farDepth, double tilt)
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

//! Errors of a position: |dC| / Z and the length of the difference of the normals.
struct Errors
{
  double center;
  double normal;
};

inline Errors errorsOf(const View &view, const Eigen::Vector3d &center, const Eigen::Vector3d &normal)
{
  return {static_cast<double>((center.cast<long double>() - view.center).norm() / view.center.z()),
          static_cast<double>((normal.cast<long double>() - view.normal).norm())};
}

//! The same for a pose; the normal is z, or -z where z points toward the camera.
inline Errors errorsOf(const View &view, const vpHomogeneousMatrix &cMo, bool zAligned = false)
{
  const double sign = zAligned ? 1. : -1.;
  return errorsOf(view, {cMo[0][3], cMo[1][3], cMo[2][3]}, {sign * cMo[0][2], sign * cMo[1][2], sign * cMo[2][2]});
}

//! Of two pairs of errors the smaller one: that of the solution meant.
inline Errors better(const Errors &a, const Errors &b)
{
  return (a.normal + a.center < b.normal + b.center) ? a : b;
}

inline vpMatrix toVisp(const Matrix3 &Q)
{
  vpMatrix matrix(3, 3);
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      matrix[i][j] = static_cast<double>(Q(i, j));
    }
  }
  return matrix;
}
} // namespace pose_circle_test

#endif
