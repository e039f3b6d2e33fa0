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
  double tilt() const;

  //! Depth of the circle's nearest point.
  double nearest() const;

  Vector3 point(long double angle, long double factor = 1.L) const;

  //! Image of the circle in normalised coordinates, correctly rounded but for its scale.
  Matrix3 exactConic() const;

  std::vector<Eigen::Vector2d> contour(int size, double factor = 1.) const;
};

//! Centre anywhere in a cone of 60 degrees, normal at the angle tilt from the line of sight, all of it in front.
View randomView(std::mt19937_64 &random, double radius, double nearDepth, double farDepth, double tilt);

//! Errors of a position: |dC| / Z and the length of the difference of the normals.
struct Errors
{
  double center;
  double normal;
};

Errors errorsOf(const View &view, const Eigen::Vector3d &center, const Eigen::Vector3d &normal);

//! The same for a pose; the normal is z, or -z where z points toward the camera.
Errors errorsOf(const View &view, const vpHomogeneousMatrix &cMo, bool zAligned = false);

//! Of two pairs of errors the smaller one: that of the solution meant.
Errors better(const Errors &a, const Errors &b);

vpMatrix toVisp(const Matrix3 &Q);
} // namespace pose_circle_test

#endif
