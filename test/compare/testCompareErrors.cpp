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
 * Errors of a pose against the truth, and their statistics.
 */

#include <cmath>
#include <functional>
#include <random>
#include <string>

#include <gtest/gtest.h>
#include <visp3/core/vpRotationMatrix.h>
#include <visp3/core/vpThetaUVector.h>
#include <visp3/core/vpTranslationVector.h>

#include "common/pose_error.h"
#include "summary.h"

using namespace compare;

namespace {
constexpr int draws = 1000;

std::mt19937_64 generator()
{
  return std::mt19937_64(std::hash<std::string>()(::testing::UnitTest::GetInstance()->current_test_info()->name()));
}

double uniform(std::mt19937_64 &random, double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

/*! Turn about an axis; with the angle 0 the identity. */
vpRotationMatrix turn(double angle, double x, double y, double z)
{
  const double length = std::sqrt(x * x + y * y + z * z);
  return vpRotationMatrix(vpThetaUVector(angle * x / length, angle * y / length, angle * z / length));
}

/*! A marker in front of the camera whose normal is `tilt` away from its line of sight; also the line of sight. */
struct Scene
{
  vpTranslationVector center;
  vpRotationMatrix tilted;   //!< Toward one side.
  vpRotationMatrix mirrored; //!< Toward the other.
};

Scene sceneOf(std::mt19937_64 &random, double tilt)
{
  const double x = uniform(random, -3, 3);
  const double y = uniform(random, 0.1, 3);
  const double z = uniform(random, 1, 20);
  const vpRotationMatrix sight = turn(std::atan2(std::hypot(x, y), z), -y, x, 0.);
  const double azimuth = uniform(random, 0, 2 * M_PI);
  const double c = std::cos(azimuth);
  const double s = std::sin(azimuth);
  return {vpTranslationVector(x, y, z), sight * turn(tilt, c, s, 0.), sight * turn(-tilt, c, s, 0.)};
}
} // namespace

TEST(CompareErrors, OfTheTruthAreZero)
{
  std::mt19937_64 random = generator();
  for (int i = 0; i < draws; ++i) {
    const Scene scene = sceneOf(random, uniform(random, 0.1, 1.5));
    const vpHomogeneousMatrix truth(scene.center, scene.tilted);
    const PoseError error = errorOf(truth, truth);
    EXPECT_EQ(error.position, 0.);
    EXPECT_EQ(error.normal, 0.);
    EXPECT_NEAR(error.rotation, 0., 1e-12);
    EXPECT_FALSE(error.wrongSolution);
  }
}

TEST(CompareErrors, TiltIsTheAngleToTheLineOfSight)
{
  std::mt19937_64 random = generator();
  for (int i = 0; i < draws; ++i) {
    const double tilt = uniform(random, 0., 1.57);
    const Scene scene = sceneOf(random, tilt);
    EXPECT_NEAR(tiltOf(vpHomogeneousMatrix(scene.center, scene.tilted)), tilt, 1e-12);
  }
}

TEST(CompareErrors, MirroredNormalIsTheWrongSolution)
{
  std::mt19937_64 random = generator();
  for (int i = 0; i < draws; ++i) {
    const double tilt = uniform(random, 0.01, 1.5);
    const Scene scene = sceneOf(random, tilt);
    const PoseError error =
        errorOf(vpHomogeneousMatrix(scene.center, scene.mirrored), vpHomogeneousMatrix(scene.center, scene.tilted));
    EXPECT_TRUE(error.wrongSolution);
    EXPECT_NEAR(error.normal, 2. * tilt, 1e-12);
  }
}

TEST(CompareErrors, SpinAboutTheNormalIsRotationOnly)
{
  std::mt19937_64 random = generator();
  for (int i = 0; i < draws; ++i) {
    const double spin = std::pow(10., uniform(random, -9., 0.49)); // To half a turn.
    const Scene scene = sceneOf(random, uniform(random, 0.1, 1.5));
    const PoseError error = errorOf(vpHomogeneousMatrix(scene.center, scene.tilted * turn(spin, 0., 0., 1.)),
                                    vpHomogeneousMatrix(scene.center, scene.tilted));
    EXPECT_NEAR(error.normal, 0., 1e-12);
    // The angle is taken by its sine: near half a turn, where the sine is flat, the rounding's root is lost.
    EXPECT_NEAR(error.rotation, spin, spin < 3. ? 1e-12 : 1e-7);
  }
}

TEST(CompareErrors, OffsetIsMeasuredMinusTrue)
{
  const vpHomogeneousMatrix truth(1., 2., 5., 0.1, 0.2, 0.3);
  const vpHomogeneousMatrix measured(1.003, 1.996, 5.012, 0.1, 0.2, 0.3);
  const PoseError error = errorOf(measured, truth);
  EXPECT_NEAR(error.x, 0.003, 1e-12);
  EXPECT_NEAR(error.y, -0.004, 1e-12);
  EXPECT_NEAR(error.z, 0.012, 1e-12);
  EXPECT_NEAR(error.position, 0.013, 1e-12);
  EXPECT_NEAR(distanceOf(truth), std::sqrt(30.), 1e-12);
}

TEST(CompareStatistics, OfKnownNumbers)
{
  const Statistics statistics = statisticsOf({4., 1., 3., 2., 10.});
  EXPECT_DOUBLE_EQ(statistics.mean, 4.);
  EXPECT_DOUBLE_EQ(statistics.median, 3.);
  EXPECT_DOUBLE_EQ(statistics.p95, 8.8); // Four fifths of the way from 4 to 10.
  EXPECT_DOUBLE_EQ(statistics.rms, std::sqrt(26.));
  EXPECT_DOUBLE_EQ(statisticsOf({1., 2.}).median, 1.5);
  EXPECT_DOUBLE_EQ(statisticsOf({7.}).p95, 7.);
  EXPECT_TRUE(std::isnan(statisticsOf({}).mean));
}

TEST(CompareStatistics, CommonFramesAreThoseAllMethodsFound)
{
  PoseError small = {0.001, 0., 0., 0.001, 0.01, 0.01, false};
  PoseError large = {0.003, 0., 0., 0.003, 0.03, 0.03, true};
  std::vector<Trial> trials(2);
  for (Measurement &measurement : trials[0].measurements) {
    measurement.error = small;
  }
  trials[1].measurements[indexOf(Method::Circle)].error = large;
  trials[1].measurements[indexOf(Method::AprilTag2)].wrongIds = 2;

  const CellSummary cell = summaryOf(trials)[0];
  EXPECT_EQ(cell.frames, 2u);
  EXPECT_EQ(cell.common, 1u);
  EXPECT_EQ(cell[Method::Circle].found, 2u);
  EXPECT_EQ(cell[Method::Circle].own.wrongSolutions, 1u);
  EXPECT_EQ(cell[Method::Circle].common.wrongSolutions, 0u);
  EXPECT_NEAR(cell[Method::Circle].own.position.mean, 2., 1e-12);
  EXPECT_NEAR(cell[Method::Circle].common.position.mean, 1., 1e-12);
  EXPECT_EQ(cell[Method::AprilTag2].found, 1u);
  EXPECT_EQ(cell[Method::AprilTag2].wrongIds, 2u);
  EXPECT_NEAR(circleOver(Method::AprilTag2, cell).x, 1., 1e-12);
}
