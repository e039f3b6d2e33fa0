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
 * Points of a marker's sheet and their images, flat and bent.
 */

#include "testRoomTools.h"

#include <Eigen/Geometry>

#include "pose/marker_plane.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr unsigned int side = 130;

MarkerPlane randomPlane(Random &random)
{
  return markerScene(random, vpCircleMarkerFamily(vpCircleMarkerFamily::RING), -1, uniform(random, 20., 110.),
                     uniform(random, 0., 1.2), side)
      .plane();
}

//! Bent about an axis: the paper's curvature, 1 / radius, and the direction across the axis, rad.
SheetBend cylinder(double curvature, double across)
{
  SheetBend bend;
  bend.bow = 0.5 * curvature;
  bend.saddle = 0.5 * curvature * Eigen::Vector2d(std::cos(2. * across), std::sin(2. * across));
  return bend;
}

Eigen::Vector2d randomPoint(Random &random)
{
  return Eigen::Vector2d(uniform(random, -1., 1.), uniform(random, -1., 1.));
}
} // namespace

// A frontal marker of 0.1 m at 2 m, bowed by b_0 = 0.04: its centre lies 0.02 radii before the plane, 1.998 m away. The
// point (0.5, 0) is at the height 0.04 (0.25 - 1) / 2 = -0.015 and is drawn in by 0.5 0.02 0.02 / 6 = 3.3e-5.
TEST(MarkerPlane, ABowByHand)
{
  MarkerPlane plane;
  plane.center = Eigen::Vector3d(0., 0., 2.);
  plane.rotation.setIdentity();
  plane.radius = 0.1;
  plane.bend.bow = 0.04;
  EXPECT_TRUE(plane.bend.isAny());
  EXPECT_NEAR(plane.bend.height(Eigen::Vector2d::Zero()), -0.02, 1e-15);
  EXPECT_NEAR(plane.bend.height(Eigen::Vector2d::UnitY()), 0., 1e-15);
  const Eigen::Vector2d seen = plane.project(Eigen::Vector2d(0.5, 0.));
  EXPECT_NEAR(seen.x(), 0.1 * (0.5 - 0.0001 / 3.) / 1.9985, 1e-9);
  EXPECT_EQ(seen.y(), 0.);
  plane.bend = SheetBend();
  EXPECT_FALSE(plane.bend.isAny());
  EXPECT_NEAR(plane.project(Eigen::Vector2d(0.5, 0.)).x(), 0.025, 1e-15);
}

// Paper around a cylinder, by its sine and cosine: what the third and fourth orders lack.
TEST(MarkerPlane, SemiMinorAxisOfTheOutlinesImage)
{
  // Of a small circle near the optical axis: the least distance of its image's points from the centre's.
  Random random = randomOfTest();
  for (int i = 0; i < 50; ++i) {
    MarkerPlane plane = randomPlane(random);
    plane.bend = SheetBend();
    plane.center = Eigen::Vector3d(uniform(random, -0.02, 0.02), uniform(random, -0.02, 0.02), 1.);
    plane.radius = 0.001;
    if (plane.rotation.col(2).z() < 0.2) {
      continue;
    }
    const Eigen::Vector2d middle = plane.project(Eigen::Vector2d::Zero());
    double least = HUGE_VAL;
    for (int k = 0; k < 720; ++k) {
      const double angle = M_PI / 360. * k;
      least = std::min(least, (plane.project(Eigen::Vector2d(std::cos(angle), std::sin(angle))) - middle).norm());
    }
    constexpr double unit = 1e-4;
    EXPECT_NEAR(plane.semiMinor(unit), least / unit, 0.05 * least / unit);
  }
}

TEST(MarkerPlane, ASheetAboutAnAxisIsACylinder)
{
  Random random = randomOfTest();
  for (int i = 0; i < 100; ++i) {
    MarkerPlane plane = randomPlane(random);
    const double k = uniform(random, -0.1, 0.1);
    const double across = uniform(random, 0., M_PI);
    plane.bend = cylinder(k, across);
    const Eigen::Vector2d n(std::cos(across), std::sin(across));
    const Eigen::Vector2d q = randomPoint(random);
    const double s = n.dot(q);
    const Eigen::Vector2d bent = q + (std::sin(k * s) / k - s) * n;
    const double height = (1. - std::cos(k * s)) / k - 0.25 * k; // its mean on the outer circle is 0, to second order
    const Eigen::Vector3d p =
        plane.center + plane.radius * (plane.rotation.leftCols<2>() * bent + height * plane.rotation.col(2));
    const double tolerance = std::pow(std::abs(k), 3.) * plane.radius / p.z();
    EXPECT_LT((plane.project(q) - p.head<2>() / p.z()).norm(), tolerance) << "curvature " << k;
  }
}

TEST(MarkerPlane, WhatIsProjectedIsFoundAgain)
{
  Random random = randomOfTest();
  for (int i = 0; i < 200; ++i) {
    MarkerPlane plane = randomPlane(random);
    if (i % 2 == 1) {
      plane.bend = cylinder(uniform(random, -0.06, 0.06), uniform(random, 0., M_PI));
    }
    const Eigen::Vector2d q = randomPoint(random);
    // Three steps leave a few hundredths of the way to the third power.
    EXPECT_LT((plane.intersect(plane.project(q)) - q).norm(), i % 2 == 1 ? 1e-4 : 1e-12);
  }
}

TEST(MarkerPlane, AFrameThatIsTurnedHasTheSameSheet)
{
  Random random = randomOfTest();
  for (int i = 0; i < 50; ++i) {
    MarkerPlane plane = randomPlane(random);
    plane.bend = {uniform(random, -0.03, 0.03), 0.03 * randomPoint(random)};
    MarkerPlane turned = plane;
    const double angle = uniform(random, -3., 3.);
    turned.spin(angle);
    const Eigen::Vector2d q = randomPoint(random);
    EXPECT_LT((turned.project(Eigen::Rotation2Dd(-angle) * q) - plane.project(q)).norm(), 1e-14);
  }
}
