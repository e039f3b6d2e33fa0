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
 * Closed-form position of a circle: exactness, conventions, degenerate conics.
 */

#include "testPoseCircleTools.h"

#include <limits>

#include <Eigen/LU>

#include "pose/circle_from_conic.h"

using namespace circle_marker;
using namespace pose_circle_test;

namespace {
// The default print's ring, 180 mm: of a circle of 20 mm at 30 m a conic in doubles has kept fewer digits than asked.
const double radius = 0.09;

Errors errorsOfBetter(const View &view, const std::array<CirclePosition, 2> &circles)
{
  return better(errorsOf(view, circles[0].center, circles[0].normal),
                errorsOf(view, circles[1].center, circles[1].normal));
}

Eigen::Matrix3d diagonal(double a, double b, double c)
{
  return Eigen::Vector3d(a, b, c).asDiagonal();
}
} // namespace

TEST(CircleFromConic, ExactOnExactConics)
{
  std::mt19937_64 random = randomOfTest();
  const double bound = 1e-9;
  // Nearer to the view along the axis rounding the conic alone moves the normal by more than the bound: by about
  // 1e-16 / tilt. Views that close to the axis are not checked here, but in NearlyAlongTheAxis.
  const double leastTilt = 1e-6;
  int checked = 0;
  for (int i = 0; i < 100000; i++) {
    const View view = randomView(random, radius, 0.2, 30., uniform(random, 0., 85.) * M_PI / 180.);
    const auto circles = circlesFromConic(view.exactConic().cast<double>(), radius);
    ASSERT_TRUE(circles) << "tilt " << view.tilt() << " depth " << view.depth();
    const Errors errors = errorsOfBetter(view, *circles);
    if (view.tilt() > leastTilt) {
      ASSERT_LT(errors.center, bound) << "tilt " << view.tilt() << " depth " << view.depth();
      ASSERT_LT(errors.normal, bound) << "tilt " << view.tilt() << " depth " << view.depth();
      checked++;
    }
  }
  EXPECT_GT(checked, 99990);
}

TEST(CircleFromConic, NearlyAlongTheAxis)
{
  // As good as a conic in doubles allows: 1e-15 / tilt, and never worse than a few times the root of the rounding.
  std::mt19937_64 random = randomOfTest();
  for (int i = 0; i < 20000; i++) {
    const double tilt = std::pow(10., uniform(random, -12., -1.));
    const View view = randomView(random, radius, 0.2, 30., tilt);
    const auto circles = circlesFromConic(view.exactConic().cast<double>(), radius);
    ASSERT_TRUE(circles);
    const Errors errors = errorsOfBetter(view, *circles);
    // A normal that is off by d moves the centre by r^2 / Z d across the line of sight.
    const double ratio = radius / view.depth();
    ASSERT_LT(errors.center, 1e-9 + ratio * ratio * errors.normal) << tilt;
    ASSERT_LT(errors.normal, std::min(1e-15 / tilt, 4. * std::sqrt(std::numeric_limits<double>::epsilon()))) << tilt;
  }
}

// Large circles near a wide lens, all of them in front of the camera.
TEST(CircleFromConic, OfMostOfTheView)
{
  std::mt19937_64 random = randomOfTest();
  int wide = 0;
  for (int i = 0; i < 20000; i++) {
    const View view = randomView(random, radius, 0.01, 0.2, uniform(random, 1., 80.) * M_PI / 180.);
    const auto circles = circlesFromConic(view.exactConic().cast<double>(), radius);
    ASSERT_TRUE(circles) << "tilt " << view.tilt() << " depth " << view.depth();
    const Errors errors = errorsOfBetter(view, *circles);
    ASSERT_LT(errors.center, 1e-9) << "tilt " << view.tilt() << " depth " << view.depth();
    ASSERT_LT(errors.normal, 1e-9) << "tilt " << view.tilt() << " depth " << view.depth();
    wide += view.nearest() < 0.3 * radius ? 1 : 0;
  }
  RecordProperty("wide", wide);
  EXPECT_GT(wide, 1000);
}

TEST(CircleFromConic, CentredFormIsExactForTinyCircles)
{
  std::mt19937_64 random = randomOfTest();
  for (int i = 0; i < 20000; i++) {
    const double tiny = 1e-3;
    const View view = randomView(random, tiny, 5., 30., uniform(random, 1., 85.) * M_PI / 180.);
    const Matrix3 Q = view.exactConic();
    CenteredEllipse ellipse;
    const Eigen::Matrix<long double, 2, 2> A = Q.topLeftCorner<2, 2>();
    const long double det = A(0, 0) * A(1, 1) - A(0, 1) * A(0, 1);
    const Eigen::Matrix<long double, 2, 1> center((A(0, 1) * Q(1, 2) - A(1, 1) * Q(0, 2)) / det,
                                                  (A(0, 1) * Q(0, 2) - A(0, 0) * Q(1, 2)) / det);
    ellipse.A = A.cast<double>();
    ellipse.center = center.cast<double>();
    // The value of the form at the centre is det Q / det A; det Q = -h^4 r^2 for the conic of the circle.
    const long double h = view.normal.dot(view.center);
    ellipse.offset = static_cast<double>(-h * h * h * h * view.radius * view.radius / det);
    const auto circles = circlesFromEllipse(ellipse, tiny);
    ASSERT_TRUE(circles);
    const Errors errors = errorsOfBetter(view, *circles);
    ASSERT_LT(errors.center, 1e-12);
    ASSERT_LT(errors.normal, 1e-12);
  }
}

TEST(CircleFromConic, CentringAConicLosesNothing)
{
  // The value at the centre of the conic as it was rounded, against the same with more digits. In plain double
  // precision it would lose (distance from the axis / size)^2, here up to 1e6 times the rounding.
  std::mt19937_64 random = randomOfTest();
  for (int i = 0; i < 5000; i++) {
    const View view = randomView(random, 0.02, 5., 20., uniform(random, 0., 80.) * M_PI / 180.);
    const Eigen::Matrix3d rounded = view.exactConic().cast<double>();
    const auto centered = centerConic(rounded);
    ASSERT_TRUE(centered);
    const Matrix3 Q = rounded.cast<long double>();
    const long double det = Q(0, 0) * Q(1, 1) - Q(0, 1) * Q(0, 1);
    const long double x = (Q(0, 1) * Q(1, 2) - Q(1, 1) * Q(0, 2)) / det,
                      y = (Q(0, 1) * Q(0, 2) - Q(0, 0) * Q(1, 2)) / det;
    const long double offset = Q(0, 2) * x + Q(1, 2) * y + Q(2, 2);
    const double scale = rounded(0, 0) / centered->A(0, 0);
    const double lost = std::sqrt(std::numeric_limits<long double>::epsilon() * std::numeric_limits<double>::epsilon());
    ASSERT_NEAR(scale * centered->offset / static_cast<double>(offset), 1., std::max(1e-11, 1e6 * lost)) << i;
  }
}

TEST(CircleFromConic, BothCirclesHaveTheSameImage)
{
  std::mt19937_64 random = randomOfTest();
  for (int i = 0; i < 5000; i++) {
    const double r = uniform(random, 0.05, 0.5);
    const View view = randomView(random, r, 1., 10., uniform(random, 5., 80.) * M_PI / 180.);
    const Eigen::Matrix3d Q = view.exactConic().cast<double>().normalized();
    const auto circles = circlesFromConic(Q, r);
    ASSERT_TRUE(circles);
    for (const CirclePosition &circle : *circles) {
      EXPECT_NEAR(circle.normal.norm(), 1., 1e-14);
      EXPECT_GT(circle.normal.dot(circle.center), 0.);
      EXPECT_LT((conicFromPose(poseFromCirclePosition(circle), r) - Q).norm(), 1e-13);
    }
    EXPECT_GE((*circles)[0].normal.z(), (*circles)[1].normal.z());
    EXPECT_GT(((*circles)[0].normal - (*circles)[1].normal).norm(), 0.05);
  }
}

TEST(CircleFromConic, AnyScaleAndSign)
{
  std::mt19937_64 random = randomOfTest();
  const View view = randomView(random, radius, 1., 5., 0.5);
  const Eigen::Matrix3d Q = view.exactConic().cast<double>().normalized();
  for (double scale : {1., -1., 3.7, -1e-290, 1e290}) {
    const auto circles = circlesFromConic(scale * Q, radius);
    ASSERT_TRUE(circles) << scale;
    const Errors errors = errorsOfBetter(view, *circles);
    EXPECT_LT(errors.center, 1e-12) << scale;
    EXPECT_LT(errors.normal, 1e-12) << scale;
  }
}

TEST(CircleFromConic, SeenAlongTheAxisBothAreEqual)
{
  // A circle of radius 1 m whose image has the radius 0.25 is at 4 m.
  const auto circles = circlesFromConic(diagonal(1., 1., -0.0625), 1.);
  ASSERT_TRUE(circles);
  for (const CirclePosition &circle : *circles) {
    EXPECT_LT((circle.center - Eigen::Vector3d(0., 0., 4.)).norm(), 1e-15);
    EXPECT_LT((circle.normal - Eigen::Vector3d(0., 0., 1.)).norm(), 1e-15);
  }
}

TEST(CircleFromConic, RefusesWhatIsNoCircle)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const Eigen::Matrix3d circle = diagonal(1., 1., -1.);
  ASSERT_TRUE(circlesFromConic(circle, 1.));
  for (double r : {0., -1., nan, infinity}) {
    EXPECT_FALSE(circlesFromConic(circle, r)) << r;
  }
  EXPECT_FALSE(circlesFromConic(diagonal(1., -1., -1.), 1.)) << "hyperbola";
  EXPECT_FALSE(circlesFromConic(diagonal(1., 1., 0.), 1.)) << "point";
  EXPECT_FALSE(circlesFromConic(diagonal(1., 1., 1.), 1.)) << "imaginary ellipse";
  EXPECT_FALSE(circlesFromConic(diagonal(1., 0., -1.), 1.)) << "two parallel lines";
  EXPECT_FALSE(circlesFromConic(diagonal(0., 0., 0.), 1.)) << "nothing";
  EXPECT_FALSE(circlesFromConic(diagonal(nan, 1., -1.), 1.));
  EXPECT_FALSE(circlesFromConic(diagonal(1., infinity, -1.), 1.));
  Eigen::Matrix3d parabola = diagonal(1., 0., 0.);
  parabola(1, 2) = parabola(2, 1) = -0.5;
  EXPECT_FALSE(circlesFromConic(parabola, 1.));

  // Points off the axis, where the offset of the conic is rounding and may have either sign.
  std::mt19937_64 random = randomOfTest();
  for (int i = 0; i < 1000; i++) {
    const double x = uniform(random, -1., 1.), y = uniform(random, -1., 1.), k = uniform(random, 0.01, 1.);
    Eigen::Matrix3d point;
    point << 1., 0., -x, 0., k, -k * y, -x, -k * y, x * x + k * y * y;
    EXPECT_FALSE(circlesFromConic(point, 1.));
  }
}

TEST(CircleFromConic, CirclesAcrossTheCameraPlaneAreRefused)
{
  // The circle reaches behind the camera: its image is a hyperbola.
  View view;
  view.center = Vector3(0.1L, 0.L, 0.5L);
  view.normal = Vector3(0.9L, 0.1L, 0.1L).normalized();
  view.radius = 1.L;
  ASSERT_LT(view.nearest(), 0.);
  EXPECT_FALSE(circlesFromConic(view.exactConic().cast<double>(), 1.));
}

TEST(CircleFromConic, SpinConvention)
{
  const vpHomogeneousMatrix frontal = poseFromCirclePosition({{0.1, 0.2, 3.}, {0., 0., 1.}});
  for (unsigned int i = 0; i < 3; i++) {
    for (unsigned int j = 0; j < 3; j++) {
      EXPECT_EQ(frontal[i][j], (i == j) ? 1. : 0.);
    }
  }
  EXPECT_EQ(frontal[0][3], 0.1);
  EXPECT_EQ(frontal[1][3], 0.2);
  EXPECT_EQ(frontal[2][3], 3.);

  std::mt19937_64 random = randomOfTest();
  for (int i = 0; i < 1000; i++) {
    // Every tenth normal along the camera's x axis or hardly off it, where the convention changes.
    Eigen::Vector3d normal(uniform(random, -1., 1.), uniform(random, -1., 1.), uniform(random, 0., 1.));
    if (i % 10 == 0) {
      normal = Eigen::Vector3d((i % 20 == 0) ? 1. : -1., (i % 30 == 0) ? 1e-9 : 0., 0.);
    }
    normal.normalize();
    const vpHomogeneousMatrix cMo = poseFromCirclePosition({{0., 0., 1.}, normal});
    Eigen::Matrix3d R;
    for (int k = 0; k < 3; k++) {
      for (int l = 0; l < 3; l++) {
        R(k, l) = cMo[k][l];
      }
    }
    ASSERT_LT((R.transpose() * R - Eigen::Matrix3d::Identity()).norm(), 1e-14);
    ASSERT_GT(R.determinant(), 0.);
    ASSERT_LT((R.col(2) - normal).norm(), 1e-14);
    if (i % 10 != 0) {
      // No other direction of the plane is closer to the camera's x axis: y has no part of it, x a positive one.
      ASSERT_NEAR(R(0, 1), 0., 1e-14);
      ASSERT_GT(R(0, 0), 0.);
    }
  }
}

TEST(CircleFromConic, ConicFromPoseHoldsTheProjectedPoints)
{
  std::mt19937_64 random = randomOfTest();
  for (int i = 0; i < 1000; i++) {
    const View view = randomView(random, 0.3, 1., 5., uniform(random, 0., 80.) * M_PI / 180.);
    const Eigen::Matrix3d Q = conicFromPose(poseFromCirclePosition({view.c(), view.n()}), 0.3);
    EXPECT_NEAR(Q.norm(), 1., 1e-14);
    for (const Eigen::Vector2d &point : view.contour(12)) {
      EXPECT_NEAR(sampsonDistance(Q, point), 0., 1e-13);
    }
    EXPECT_LT(sampsonDistance(Q, view.contour(1, 0.9)[0]), 0.) << "negative inside";
    EXPECT_GT(sampsonDistance(Q, view.contour(1, 1.1)[0]), 0.) << "positive outside";
  }
}
