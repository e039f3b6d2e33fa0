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
 * Fit of an ellipse to points, and the conversions of conics.
 */

#include "testPoseCircleTools.h"

#include <limits>

#include <Eigen/LU>

#include "ellipse/fit_conic.h"

using namespace circle_marker;
using namespace pose_circle_test;

namespace {
using Points = std::vector<Eigen::Vector2d>;

Eigen::Vector2d pointOf(const EllipseParameters &e, double t)
{
  const Eigen::Vector2d major(std::cos(e.angle), std::sin(e.angle));
  return e.center + e.a * std::cos(t) * major + e.b * std::sin(t) * Eigen::Vector2d(-major.y(), major.x());
}

Points arcOf(const EllipseParameters &e, int size, double from, double length)
{
  Points points;
  for (int i = 0; i < size; i++) {
    points.push_back(pointOf(e, from + length * i / size));
  }
  return points;
}

EllipseParameters randomEllipse(std::mt19937_64 &random, double leastRatio)
{
  EllipseParameters e;
  e.a = uniform(random, 5., 50.);
  e.b = e.a * uniform(random, leastRatio, 1.);
  e.center << uniform(random, -640., 640.), uniform(random, -480., 480.);
  e.angle = uniform(random, -M_PI_2, M_PI_2);
  return e;
}

//! Largest error of centre and semi-axes, pixels.
double errorOf(const EllipseParameters &truth, const EllipseParameters &e)
{
  return std::max({(truth.center - e.center).norm(), std::fabs(truth.a - e.a), std::fabs(truth.b - e.b)});
}

//! Derivative of the distance of a point of the ellipse to it by centre, a, b, angle.
Eigen::Matrix<double, 1, 5> distanceJacobian(const EllipseParameters &e, double t)
{
  const double c = std::cos(t), s = std::sin(t);
  const Eigen::Vector2d major(std::cos(e.angle), std::sin(e.angle)), minor(-major.y(), major.x());
  const Eigen::Vector2d normal = (e.b * c * major + e.a * s * minor).normalized();
  const Eigen::Vector2d turned = e.a * c * minor - e.b * s * major;
  Eigen::Matrix<double, 1, 5> J;
  J << -normal.transpose(), -c * normal.dot(major), -s * normal.dot(minor), -normal.dot(turned);
  return J;
}
} // namespace

TEST(FitConic, ConversionsAreInverse)
{
  std::mt19937_64 random = randomOfTest();
  for (int i = 0; i < 2000; i++) {
    const EllipseParameters e = randomEllipse(random, 0.02);
    const double scale = uniform(random, -5., 5.);
    const auto back = ellipseFromConic(scale * conicFromEllipse(e));
    ASSERT_TRUE(back);
    EXPECT_LT(errorOf(e, *back), 1e-7); // A conic in pixels has lost (distance / b)^2 of its 16 digits.
    if (e.b < 0.9 * e.a) {
      EXPECT_NEAR(std::remainder(e.angle - back->angle, M_PI), 0., 1e-8);
    }
    EXPECT_GT(back->angle, -M_PI_2);
    EXPECT_LE(back->angle, M_PI_2);
  }
  // The end of the interval, either way it is rounded, and a circle.
  EllipseParameters e;
  e.a = 2.;
  e.b = 1.;
  e.angle = M_PI_2;
  EXPECT_NEAR(ellipseFromConic(conicFromEllipse(e))->angle, M_PI_2, 1e-15);
  e.angle = -M_PI_2;
  EXPECT_NEAR(std::fabs(ellipseFromConic(conicFromEllipse(e))->angle), M_PI_2, 1e-15);
  e.b = e.a;
  e.angle = 0.;
  EXPECT_EQ(ellipseFromConic(conicFromEllipse(e))->angle, 0.);
}

TEST(FitConic, ConicIsNegativeInside)
{
  EllipseParameters e;
  e.center << 3., 4.;
  e.a = 2.;
  e.b = 1.;
  const Eigen::Matrix3d Q = conicFromEllipse(e);
  EXPECT_NEAR(Q.norm(), 1., 1e-15);
  EXPECT_LT(Q(2, 2) + 6. * Q(0, 2) + 8. * Q(1, 2) + 9. * Q(0, 0) + 24. * Q(0, 1) + 16. * Q(1, 1), 0.);
}

TEST(FitConic, SampsonDistanceOfACircle)
{
  // F = rho^2 - R^2 has the slope 2 rho.
  EllipseParameters e;
  e.a = e.b = 10.;
  e.center << 100., 50.;
  const Eigen::Matrix3d Q = conicFromEllipse(e);
  for (double rho : {9., 9.99, 10., 10.01, 11.}) {
    EXPECT_NEAR(sampsonDistance(Q, e.center + rho * Eigen::Vector2d(0.6, 0.8)), (rho * rho - 100.) / (2. * rho), 1e-9);
    EXPECT_NEAR(sampsonDistance(7. * Q, e.center + rho * Eigen::Vector2d(0.6, 0.8)), (rho * rho - 100.) / (2. * rho),
                1e-9);
  }
}

TEST(FitConic, ExactOnExactPoints)
{
  std::mt19937_64 random = randomOfTest();
  for (int i = 0; i < 5000; i++) {
    const EllipseParameters e = randomEllipse(random, 0.1);
    const int size = 5 + i % 60;
    const Points points = arcOf(e, size, uniform(random, 0., 2. * M_PI), uniform(random, M_PI_2, 2. * M_PI));
    const auto Q = fitEllipse(points.data(), points.size());
    ASSERT_TRUE(Q);
    EXPECT_NEAR(Q->norm(), 1., 1e-14);
    const auto fitted = ellipseFromConic(*Q);
    ASSERT_TRUE(fitted);
    // Coordinates of some hundred pixels are rounded to 1e-13; five points of a quarter make 1e4 times that of it.
    EXPECT_LT(errorOf(e, *fitted), 2e-8) << size << " points, axes " << e.a << " " << e.b;
  }
}

TEST(FitConic, ExactOnSlenderEllipses)
{
  EllipseParameters e;
  e.a = 100.;
  e.b = 0.1;
  e.angle = 0.3;
  e.center << 1., 2.;
  const Points points = arcOf(e, 40, 0., 2. * M_PI);
  const auto Q = fitEllipse(points.data(), points.size());
  ASSERT_TRUE(Q);
  EXPECT_LT(errorOf(e, *ellipseFromConic(*Q)), 1e-7);
}

TEST(FitConic, AsGoodAsTheBoundOnNoisyArcs)
{
  // The squared error in units of the Cramer-Rao bound has the mean 5, the number of parameters, and there is no bias
  // beyond a tenth of the standard deviation.
  std::mt19937_64 random = randomOfTest();
  const double sigma = 0.1; // pixels
  std::normal_distribution<double> noise(0., sigma);
  EllipseParameters e;
  e.a = 40.;
  e.b = 26.;
  e.angle = 0.4;
  e.center << 300., 200.;
  for (double arc : {2. * M_PI, M_PI}) {
    const int size = 120, trials = 3000;
    Eigen::Matrix<double, 5, 5> information = Eigen::Matrix<double, 5, 5>::Zero();
    for (int i = 0; i < size; i++) {
      const Eigen::Matrix<double, 1, 5> J = distanceJacobian(e, arc * i / size);
      information += J.transpose() * J / (sigma * sigma);
    }
    const Eigen::Matrix<double, 5, 5> bound = information.inverse();
    double mean = 0.;
    Eigen::Matrix<double, 5, 1> bias = Eigen::Matrix<double, 5, 1>::Zero();
    for (int k = 0; k < trials; k++) {
      Points points = arcOf(e, size, 0., arc);
      for (Eigen::Vector2d &point : points) {
        point += Eigen::Vector2d(noise(random), noise(random));
      }
      const auto Q = fitEllipse(points.data(), points.size());
      ASSERT_TRUE(Q);
      const auto fitted = ellipseFromConic(*Q);
      Eigen::Matrix<double, 5, 1> error;
      error << fitted->center - e.center, fitted->a - e.a, fitted->b - e.b, fitted->angle - e.angle;
      mean += error.dot(information * error) / trials;
      bias += error / trials;
    }
    // The mean of 3000 chi-square values of 5 degrees of freedom has the standard deviation 0.058.
    EXPECT_NEAR(mean, 5., 0.25) << arc;
    for (int j = 0; j < 5; j++) {
      EXPECT_LT(std::fabs(bias(j)), 0.1 * std::sqrt(bound(j, j))) << "parameter " << j << " arc " << arc;
    }
  }
}

TEST(FitConic, RefusesWhatIsNoEllipse)
{
  EllipseParameters e;
  e.a = 2.;
  e.b = 1.;
  Points points = arcOf(e, 5, 0., 6.);
  ASSERT_TRUE(fitEllipse(points.data(), 5));
  EXPECT_FALSE(fitEllipse(points.data(), 4));
  EXPECT_FALSE(fitEllipse(nullptr, 0));
  points[3].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(fitEllipse(points.data(), 5));
  Points line, place;
  for (int i = 0; i < 20; i++) {
    line.emplace_back(100.3 + 0.7 * i, 50.1 - 0.31 * i);
    place.emplace_back(1.1, 2.3);
  }
  EXPECT_FALSE(fitEllipse(line.data(), line.size()));
  EXPECT_FALSE(fitEllipse(place.data(), place.size()));
  // Three places, each several times, are too few for an ellipse.
  Points three;
  for (int i = 0; i < 12; i++) {
    three.push_back(Eigen::Vector2d(std::cos(2. * (i % 3)), std::sin(2. * (i % 3))));
  }
  const auto Q = fitEllipse(three.data(), three.size());
  if (Q) {
    for (const Eigen::Vector2d &point : three) {
      EXPECT_LT(std::fabs(sampsonDistance(*Q, point)), 1e-6);
    }
  }
}
