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
 * Tests of the covariance of the pose of a marker that nearly faces the camera.
 */

#include "refine/nearly_frontal.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <random>

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "testRandom.h"

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif
using namespace circle_marker;
using random_test::Random;
using random_test::randomOfTest;
using random_test::uniform;

namespace {
using Complex = std::complex<double>;

constexpr double distance = 5.;  // m
constexpr double alpha = 2000.;  // 1/rad^2: two poses are told apart from some 2 degrees on
constexpr double byDepth = 2e-4; // standard deviation of the distance at a known lean, m
constexpr double spinError = 1e-3;

double normal(Random &random)
{
  return std::normal_distribution<double>()(random);
}

MarkerPlane facing()
{
  MarkerPlane plane;
  plane.center = distance * Eigen::Vector3d(0.1, -0.2, 1.).normalized();
  plane.rotation = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), plane.center).toRotationMatrix();
  plane.radius = 0.1;
  return plane;
}

// How the marker's frame of a pose sees another pose: shift, then turn about x and y.
Eigen::Vector3d errorOf(const MarkerPlane &pose, const MarkerPlane &truth)
{
  const Eigen::Vector3d normal = pose.rotation.transpose() * truth.rotation.col(2);
  const Eigen::Vector3d shift = pose.rotation.transpose() * (truth.center - pose.center);
  return {shift.z(), -normal.y(), normal.x()};
}

// A fit as the normal equations leave it, where the narrowing alone tells the lean.
FittedPose fitLeaningBy(const Complex &lean)
{
  FittedPose fit;
  fit.plane = leaningBy(facing(), {lean.real(), lean.imag()});
  fit.leanInformation = alpha * alpha;
  const double turns = 1. / (alpha * alpha * std::norm(lean));
  const Eigen::Vector2d byTurn(lean.imag(), -lean.real()); // of the lean's square by a turn about x and y, halved
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Identity() * 1e-10;
  covariance.block<2, 2>(3, 3) = turns * Eigen::Matrix2d::Identity();
  const Eigen::Vector2d follows = 0.5 * distance * byTurn;
  covariance.block<1, 2>(2, 3) = turns * follows.transpose();
  covariance.block<2, 1>(3, 2) = turns * follows;
  covariance(2, 2) = byDepth * byDepth + turns * follows.squaredNorm();
  covariance(5, 5) = spinError * spinError;
  Eigen::Matrix<double, 6, 6> change = Eigen::Matrix<double, 6, 6>::Zero();
  change.topLeftCorner<3, 3>() = change.bottomRightCorner<3, 3>() = fit.plane.rotation;
  fit.covariance = change * covariance * change.transpose();
  return fit;
}

// Squared Mahalanobis distance of distance and lean, by degree of freedom.
double squaredDistance(const FittedPose &fit, const Eigen::Matrix<double, 6, 6> &covariance, const MarkerPlane &truth)
{
  Eigen::Matrix<double, 6, 6> change = Eigen::Matrix<double, 6, 6>::Zero();
  change.topLeftCorner<3, 3>() = change.bottomRightCorner<3, 3>() = fit.plane.rotation.transpose();
  const Eigen::Matrix3d known = (change * covariance * change.transpose()).block<3, 3>(2, 2);
  const Eigen::Vector3d error = errorOf(fit.plane, truth);
  return error.dot(known.inverse() * error) / 3.;
}

struct Means
{
  double before = 0.; // by the normal equations' covariance
  double after = 0.;
};

// Mean over fits of images of a marker that leans by an angle: the image tells the lean's square with some noise.
Means meansAt(double angle, Random &random)
{
  constexpr int count = 1000;
  Means means;
  for (int i = 0; i < count; ++i) {
    const Complex lean = std::polar(angle, uniform(random, 0., 2. * M_PI));
    const Complex square = lean * lean + 2. / alpha * Complex(normal(random), normal(random));
    Complex seen = std::sqrt(square);
    if (std::real(seen * std::conj(lean)) < 0.) {
      seen = -seen; // of two poses the nearer one
    }
    FittedPose fit = fitLeaningBy(seen);
    fit.plane.center *= 1. + byDepth * normal(random) / distance;
    const MarkerPlane truth = leaningBy(facing(), {lean.real(), lean.imag()});
    means.before += squaredDistance(fit, fit.covariance, truth) / count;
    means.after += squaredDistance(fit, nearlyFrontalCovariance(fit, true), truth) / count;
  }
  return means;
}
} // namespace

TEST(NearlyFrontal, TheLeanIsThatOfTheNormalFromTheLineOfSight)
{
  EXPECT_NEAR(leanOf(facing()).norm(), 0., 1e-12);
  const MarkerPlane leaning = leaningBy(facing(), {0.03, -0.05});
  EXPECT_NEAR((leanOf(leaning) - Eigen::Vector2d(0.03, -0.05)).norm(), 0., 1e-4);
  // Toward the marker's x and y: the normal has that much of the axes that it had.
  const Eigen::Vector3d normal = facing().rotation.transpose() * leaning.rotation.col(2);
  EXPECT_NEAR(normal.x(), 0.03, 1e-4);
  EXPECT_NEAR(normal.y(), -0.05, 1e-4);
  EXPECT_NEAR(leaning.center.norm() / distance, 1. - 0.25 * (0.03 * 0.03 + 0.05 * 0.05), 1e-9);
}

TEST(NearlyFrontal, WhereTheTwoPosesAreFarApartItIsTheNormalEquations)
{
  const double unit = 1. / std::sqrt(alpha); // its square is known to that: a lean of k units to k^2 deviations
  const FittedPose far = fitLeaningBy(std::polar(3.1 * unit, 1.));
  EXPECT_FALSE(isNearlyFrontal(far));
  const FittedPose near = fitLeaningBy(std::polar(2.9 * unit, 1.));
  EXPECT_TRUE(isNearlyFrontal(near));
  const Eigen::Matrix<double, 6, 6> covariance = nearlyFrontalCovariance(far, true);
  EXPECT_LT((covariance - far.covariance).norm(), 0.3 * far.covariance.norm());
}

TEST(NearlyFrontal, TheCovarianceIsTrueAtAnyLean)
{
  Random random = randomOfTest();
  const double unit = 1. / std::sqrt(alpha);
  EXPECT_GT(meansAt(1e-6, random).before, 2.5) << "nothing is to be mended";
  for (const double angle : {1e-6, 0.5, 1., 1.5, 2., 2.25, 2.5, 2.75, 3.}) {
    const Means means = meansAt(angle * unit, random);
    EXPECT_GT(means.after, 0.6) << angle;
    EXPECT_LT(means.after, 1.4) << angle;
  }
}

TEST(NearlyFrontal, AloneItMayLeanToTheOtherSide)
{
  const double unit = 1. / std::sqrt(alpha);
  const FittedPose fit = fitLeaningBy(2. * unit);
  const MarkerPlane other = leaningBy(facing(), {-2. * unit, 0.});
  EXPECT_GT(squaredDistance(fit, nearlyFrontalCovariance(fit, true), other), 10.);
  EXPECT_LT(squaredDistance(fit, nearlyFrontalCovariance(fit, false), other), 2.);
}
