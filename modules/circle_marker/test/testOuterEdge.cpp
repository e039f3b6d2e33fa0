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
 * Tests of what is known of a measured marker by its outer edge, and of what that tells of the pose.
 */

#include <cmath>

#include <gtest/gtest.h>

#include "outer_edge.h"
#include "testRoomTools.h"

using namespace circle_marker;

namespace {
constexpr double odds = 40.; // ln

CameraModel camera()
{
  vpCameraParameters parameters;
  parameters.initPersProjWithoutDistortion(800., 800., 320., 240.);
  return CameraModel(parameters);
}

// Of a marker of 40 pixels radius that faces the camera, two metres away.
Measurement facing()
{
  Measurement measurement;
  FittedPose &fit = measurement.first;
  fit.plane.center = Eigen::Vector3d(0., 0., 2.);
  fit.plane.rotation.setIdentity();
  fit.plane.radius = 0.1;
  fit.photometry.white = 200.;
  fit.photometry.absorption = 0.6; // a contrast of 120
  fit.photometry.blur.sigma = 1.;
  fit.noise = 2.;
  fit.covariance.setIdentity();
  measurement.cost2 = measurement.cost + odds;
  return measurement;
}
} // namespace

TEST(OuterEdge, UnevenLightIsKnownToAPart)
{
  // Of the contrast 0.005, 0.6 grey levels, along half a radius of an edge that is sqrt(2 pi) pixels wide: 50.1 pixels,
  // whose mean is off by the noise, 2 / sqrt(50.1), and by 0.6.
  const double sharing = 1. + std::sqrt(2. * M_PI) * 20. * 0.36 / 4.;
  Measurement measurement = facing();
  measurement.uneven = UnevenLight();
  addLightDoubt(camera(), measurement);
  EXPECT_NEAR(sharing, 5.512, 1e-3);
  EXPECT_LT((measurement.first.covariance - sharing * Eigen::Matrix<double, 6, 6>::Identity()).norm(), 1e-9);
  EXPECT_NEAR(measurement.cost2 - measurement.cost, odds / sharing, 1e-9);
}

TEST(OuterEdge, EvenLightIsKnown)
{
  Measurement measurement = facing();
  addLightDoubt(camera(), measurement);
  EXPECT_TRUE(measurement.first.covariance.isIdentity(0.));
  EXPECT_EQ(measurement.cost2 - measurement.cost, odds);
}

TEST(OuterEdge, HalosMoveTheDepth)
{
  // 14 halos by the radius in pixels: 0.021 pixels of 40, of two metres 1.05 mm; facing, the tilt is not moved.
  Measurement measurement = facing();
  addHaloDoubt(0.06, camera(), measurement);
  Eigen::Matrix<double, 6, 6> expected = Eigen::Matrix<double, 6, 6>::Identity();
  expected(2, 2) += std::pow(0.00105, 2);
  EXPECT_LT((measurement.first.covariance - expected).norm(), 1e-12);
  EXPECT_NEAR(measurement.cost2 - measurement.cost, 0.5 * odds, 1e-9) << "half of the odds is believed";
}

// They move the edges of a marker that is turned about its normal by as much.
TEST(OuterEdge, HalosDoNotSeeTheSpin)
{
  const auto doubtAt = [](double spin) {
    Measurement measurement = facing();
    measurement.first.plane.rotation =
        room_test::turn(1., Eigen::Vector3d::UnitX()) * room_test::turn(spin, Eigen::Vector3d::UnitZ());
    addHaloDoubt(0.06, camera(), measurement);
    return measurement.first.covariance;
  };
  const Eigen::Matrix<double, 6, 6> expected = doubtAt(0.);
  EXPECT_GT(expected(2, 2), 1. + 1e-6);
  for (const double spin : {0.4, M_PI / 4., M_PI / 2.}) {
    EXPECT_LT((doubtAt(spin) - expected).norm(), 0.01 * (expected(2, 2) - 1.)) << spin;
  }
}

TEST(OuterEdge, HalosAreNotToldFromWideBlurs)
{
  Measurement measurement = facing();
  measurement.first.photometry.blur.sigma = 1.3;
  addHaloDoubt(0.06, camera(), measurement);
  EXPECT_TRUE(measurement.first.covariance.isIdentity(0.));
  EXPECT_EQ(measurement.cost2 - measurement.cost, odds);
}
