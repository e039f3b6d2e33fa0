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
 * Tests of the width of an outline's edge, and of what looks blurred.
 */

#include "testRoomTools.h"

#include "decode/edge_width.h"

#include <gtest/gtest.h>

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr unsigned int side = 200; // pixels
const double quietZone = vpCircleMarkerLayout().quietZone;

//! The outline of a marker that is seen frontally.
EllipseParameters outlineOf(const MarkerScene &scene)
{
  EllipseParameters outline;
  outline.center = scene.frame().center;
  outline.a = scene.frame().size;
  outline.b = outline.a;
  outline.angle = 0.;
  return outline;
}

EllipseParameters outlineOf(const EllipseScene &scene)
{
  EllipseParameters outline;
  outline.center = scene.center;
  outline.a = scene.a;
  outline.b = scene.b;
  outline.angle = scene.angle;
  return outline;
}
} // namespace

// The step of an edge that a Gaussian blurs, by its steepest slope, is sqrt(2 pi) standard deviations.
TEST(EdgeWidth, IsThatOfTheBlur)
{
  for (const double blur : {2.5, 4., 5.}) {
    const EllipseScene scene = {Eigen::Vector2d(100.3, 98.6), 64., 50., 0.4};
    const double width = edgeWidth(photograph(side, side, blur, scene), outlineOf(scene));
    EXPECT_NEAR(width / (std::sqrt(2. * M_PI) * blur), 1.1, 0.2) << "blur " << blur;
  }
}

TEST(EdgeWidth, SharpOutlinesAreTwoSamplesWide)
{
  for (const double radius : {10., 18., 60.}) {
    const EllipseScene scene = {Eigen::Vector2d(100.3, 98.6), radius, 0.8 * radius, 0.4};
    const double width = edgeWidth(photograph(side, side, 0.7, scene), outlineOf(scene));
    const double sample = std::max(1., 0.05 * std::sqrt(0.8) * radius);
    EXPECT_GT(width, 1.5 * sample) << "radius " << radius;
    EXPECT_LT(width, 2.9 * sample) << "radius " << radius;
  }
}

// Of the eighth of the outline that is in the image, and of what is no edge, nothing is told.
TEST(EdgeWidth, IsNoneWhereTheOutlineIsNotSeen)
{
  const EllipseScene atCorner = {Eigen::Vector2d(-24., -24.), 60., 60., 0.};
  EXPECT_EQ(edgeWidth(photograph(side, side, 0.7, atCorner), outlineOf(atCorner)), 0.);
  const EllipseScene scene = {Eigen::Vector2d(100., 100.), 60., 60., 0.};
  EXPECT_EQ(edgeWidth(vpImage<unsigned char>(side, side, 128), outlineOf(scene)), 0.);
}

TEST(LooksBlurred, MarkersThroughAStrongBlurOnly)
{
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31R}) {
    const vpCircleMarkerFamily family(type);
    for (int i = 0; i < 5; ++i) {
      const double diameter = uniform(random, 70., 90.);
      const int id = static_cast<int>(random() % family.getNbIds());
      MarkerScene scene = markerScene(random, family, id, diameter, 0., side);
      scene.sheet = 2.;
      const vpImage<unsigned char> blurred = photograph(side, side, 0.045 * diameter, scene);
      EXPECT_TRUE(looksBlurred(blurred, outlineOf(scene), true, quietZone)) << family.getName();
      EXPECT_FALSE(looksBlurred(photograph(side, side, 0.8, scene), outlineOf(scene), true, quietZone))
          << family.getName();
    }
  }
}

// The sheet ends within the reach of the profiles, and what lies beyond is brighter than dim paper.
TEST(LooksBlurred, ABrighterGroundIsNoBlur)
{
  Random random = randomOfTest();
  for (int i = 0; i < 5; ++i) {
    MarkerScene scene = markerScene(random, vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23), i, 56., 0., side);
    scene.black = 40.;
    scene.white = 100.;
    scene.surround = 230.;
    EXPECT_FALSE(looksBlurred(photograph(side, side, 0.8, scene), outlineOf(scene), true, quietZone));
  }
}

TEST(LooksBlurred, NoBlurredDiscAndNothingSmall)
{
  Random random = randomOfTest();
  const EllipseScene disc = {Eigen::Vector2d(100., 100.), 40., 40., 0.};
  EXPECT_FALSE(looksBlurred(photograph(side, side, 3.6, disc), outlineOf(disc), true, quietZone));
  MarkerScene small = markerScene(random, vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23), 3, 16., 0., side);
  small.sheet = 2.;
  EXPECT_FALSE(looksBlurred(photograph(side, side, 0.9, small), outlineOf(small), true, quietZone));
}

TEST(LooksBlurred, APlainRingHasNothingInItsTrack)
{
  Random random = randomOfTest();
  MarkerScene ring = markerScene(random, vpCircleMarkerFamily(vpCircleMarkerFamily::RING), -1, 80., 0., side);
  ring.sheet = 2.;
  const vpImage<unsigned char> I = photograph(side, side, 3.6, ring);
  EXPECT_TRUE(looksBlurred(I, outlineOf(ring), false, quietZone));
  EXPECT_FALSE(looksBlurred(I, outlineOf(ring), true, quietZone));
}

// Where one side of a blurred marker is covered with grey, no blur that lenses or motions make explains what is left.
TEST(LooksBlurred, NothingThatDiffersInOppositeDirections)
{
  Random random = randomOfTest();
  MarkerScene scene = markerScene(random, vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23), 5, 80., 0., side);
  scene.sheet = 2.;
  vpImage<unsigned char> I = photograph(side, side, 3.6, scene);
  EXPECT_TRUE(looksBlurred(I, outlineOf(scene), true, quietZone));
  // The ring's side from 0.75 of the radius on, over a little more than a quarter of the circle.
  const Eigen::Vector2d center = scene.frame().center;
  for (unsigned int v = 0; v < side; ++v) {
    for (unsigned int u = 0; u < side; ++u) {
      const Eigen::Vector2d away = Eigen::Vector2d(u, v) - center;
      if (away.x() > std::abs(away.y()) && away.norm() > 0.75 * scene.frame().size &&
          away.norm() < 1.05 * scene.frame().size) {
        I[v][u] = static_cast<unsigned char>(std::lround(scene.white));
      }
    }
  }
  EXPECT_FALSE(looksBlurred(I, outlineOf(scene), true, quietZone));
}
