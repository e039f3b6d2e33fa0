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
 * Unit and property tests of the covariance of a circle's pose.
 */

#include "testPoseCircleTools.h"

#include <Eigen/Geometry>

#include "pose/circle_covariance.h"

using namespace circle_marker;
using namespace pose_circle_test;

namespace {
CirclePosition positionOf(const View &view)
{
  return {view.c(), view.n()};
}

// The circle moved by exp(delta) where either the first or the last three of delta are zero.
View moved(const View &view, const Eigen::Matrix<double, 6, 1> &delta)
{
  View result = view;
  const Vector3 rotation = delta.tail<3>().cast<long double>();
  const long double angle = rotation.norm();
  if (angle > 0.L) {
    const Eigen::AngleAxis<long double> R(angle, rotation / angle);
    result.center = R * view.center;
    result.normal = R * view.normal;
  }
  result.center += delta.head<3>().cast<long double>();
  return result;
}

// Distance between a point and the image of a circle, positive outside of it: to the nearest of points around it, whose
// angle is found by trisection.
double distanceTo(const View &view, const Eigen::Vector2d &point)
{
  const auto squaredAt = [&](long double angle) {
    const Vector3 P = view.point(angle);
    return std::pow(P.x() / P.z() - point.x(), 2) + std::pow(P.y() / P.z() - point.y(), 2);
  };
  const int parts = 720;
  int nearest = 0;
  for (int i = 1; i < parts; i++) {
    nearest = squaredAt(2.L * M_PI * i / parts) < squaredAt(2.L * M_PI * nearest / parts) ? i : nearest;
  }
  long double low = 2.L * M_PI * (nearest - 1) / parts;
  long double high = 2.L * M_PI * (nearest + 1) / parts;
  for (int round = 0; round < 60; round++) {
    const long double first = (2.L * low + high) / 3.L;
    const long double second = (low + 2.L * high) / 3.L;
    (squaredAt(first) < squaredAt(second) ? high : low) = squaredAt(first) < squaredAt(second) ? second : first;
  }
  const Vector3 x = point.homogeneous().cast<long double>();
  const Vector3 onPlane = view.normal.dot(view.center) / view.normal.dot(x) * x;
  const double sign = (onPlane - view.center).norm() > view.radius ? 1. : -1.;
  return sign * static_cast<double>(std::sqrt(squaredAt(0.5L * (low + high))));
}
} // namespace

TEST(CircleCovariance, JacobianAgainstFiniteDifferences)
{
  std::mt19937_64 random = randomOfTest();
  const double step = 1e-5; // metres and radians
  for (int i = 0; i < 20; i++) {
    const View view = randomView(random, 0.1, 0.5, 3., uniform(random, 5., 70.) * M_PI / 180.);
    for (const Eigen::Vector2d &point : view.contour(7)) {
      const Eigen::Matrix<double, 1, 6> J = circleDistanceJacobian(positionOf(view), point);
      for (int k = 0; k < 6; k++) {
        const Eigen::Matrix<double, 6, 1> delta = step * Eigen::Matrix<double, 6, 1>::Unit(k);
        const double numeric =
            (distanceTo(moved(view, delta), point) - distanceTo(moved(view, -delta), point)) / (2. * step);
        EXPECT_NEAR(J[k], numeric, 1e-4 * (1. + J.norm())) << k;
      }
    }
  }
}

// Of a speck at 70 metres, off the axis and from the side, the terms of the centre's variance cancel each other to
// their last digits.
TEST(CircleCovariance, NoVarianceIsNegative)
{
  const View specks[] = {{{-8.3758763281157513L, -47.170795805756057L, 50.508214038105429L},
                          {0.13362093533364588L, -0.73591954962893158L, -0.66375286222698293L},
                          0.00011550279584303548L},
                         {{9.9157297026137474L, 60.958003408159449L, 40.098776269164404L},
                          {-0.16875801509206373L, 0.56160439717294286L, -0.81001310694222839L},
                          0.0001228813954322762L}};
  for (const View &view : specks) {
    const Eigen::Matrix<double, 6, 6> C = circleCovariance(positionOf(view), view.contour(60), 1e-4);
    EXPECT_TRUE(C.allFinite());
    EXPECT_GE(C.diagonal().minCoeff(), 0.) << C.diagonal().transpose();
  }
}

TEST(CircleCovariance, SymmetricWithoutNegativeVariances)
{
  std::mt19937_64 random = randomOfTest();
  for (int i = 0; i < 5000; i++) {
    const View view = randomView(random, std::pow(10., uniform(random, -3., -1.)), 1., 100., uniform(random, 0., 1.5));
    const Eigen::Matrix<double, 6, 6> C = circleCovariance(positionOf(view), view.contour(60), 1e-4);
    ASSERT_TRUE(C.allFinite());
    ASSERT_GE(C.diagonal().minCoeff(), 0.) << C.diagonal().transpose();
    ASSERT_LE((C - C.transpose()).norm(), 1e-12 * C.norm());
  }
}
