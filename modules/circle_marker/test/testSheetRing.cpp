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
 * Tests of the ring on a small sheet, by the sheet's shape.
 */

#include "ellipse/sheet_ring.h"

#include <gtest/gtest.h>

#include "ellipse/fit_conic.h"
#include "testSheetTools.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr unsigned int side = 100;
constexpr double rise = 2.; // grey levels

// A marker at a grazing angle: its ring is less than a pixel wide where it is narrow.
MarkerScene grazingScene(Random &random, double ground)
{
  return sheetScene(random, side, {7., 8.}, {1.2, 1.4}, ground);
}

vpImage<unsigned char> imageOf(const MarkerScene &scene, Random &random)
{
  return digitise(expose(side, side, 0.7, scene), 2., random);
}

// The image of the circle in the middle of the ring.
EllipseParameters middleOfRing(const MarkerScene &scene)
{
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < 40; ++i) {
    const double angle = 2. * M_PI * i / 40.;
    const double radius = 0.5 * (1. + scene.family.getLayout().ringInner);
    points.push_back(project(scene, radius * Eigen::Vector2d(std::cos(angle), std::sin(angle))));
  }
  return *ellipseFromConic(*fitEllipse(points.data(), points.size()));
}
} // namespace

TEST(SheetRing, IsFoundAtGrazingAngles)
{
  Random random = randomOfTest();
  for (const double ground : {20., 110., 250.}) {
    constexpr int scenes = 20;
    int found = 0;
    for (int i = 0; i < scenes; ++i) {
      const MarkerScene scene = grazingScene(random, ground);
      const vpImage<unsigned char> I = imageOf(scene, random);
      const std::vector<EdgePoint> sheet = sheetOf(scene);
      const std::vector<EdgePixel> pixels = pixelsOf(sheet);
      const auto ellipse = darkLineOfSheet(I, sheet.data(), sheet.size(), rise);
      if (!ellipse) {
        continue;
      }
      ++found;
      EXPECT_TRUE(mayBeSheet(I, pixels.data(), pixels.size(), rise));
      EXPECT_TRUE(mayBeSheet(I, sheet.data(), sheet.size(), rise));
      const EllipseParameters truth = middleOfRing(scene);
      EXPECT_LT((ellipse->center - truth.center).norm(), 0.5);
      EXPECT_NEAR(ellipse->a, truth.a, 0.06 * truth.a) << "ground " << ground;
      EXPECT_NEAR(ellipse->b, truth.b, 0.06 * truth.b) << "ground " << ground;
      EXPECT_NEAR(std::sin(ellipse->angle - truth.angle), 0., 0.02);
    }
    EXPECT_EQ(found, scenes) << "ground " << ground;
  }
}

TEST(SheetRing, NoneOnAnEmptySheetNorBeyondTheImage)
{
  Random random = randomOfTest();
  MarkerScene scene = grazingScene(random, 20.);
  const std::vector<EdgePoint> sheet = sheetOf(scene);
  const std::vector<EdgePixel> pixels = pixelsOf(sheet);
  scene.black = scene.white;
  const vpImage<unsigned char> empty = imageOf(scene, random);
  EXPECT_FALSE(mayBeSheet(empty, pixels.data(), pixels.size(), rise));
  EXPECT_FALSE(darkLineOfSheet(empty, sheet.data(), sheet.size(), rise));
  const vpImage<unsigned char> corner(8, 8, 100);
  EXPECT_FALSE(mayBeSheet(corner, pixels.data(), pixels.size(), rise));
  EXPECT_FALSE(darkLineOfSheet(corner, sheet.data(), sheet.size(), rise));
}

// The same dark line in what is not as compact as a sheet.
TEST(SheetRing, NoneInATriangle)
{
  Random random = randomOfTest();
  const MarkerScene scene = grazingScene(random, 20.);
  const vpImage<unsigned char> I = imageOf(scene, random);
  std::vector<EdgePixel> triangle;
  for (const Eigen::Vector2d &corner :
       {Eigen::Vector2d(-1.5, -1.), Eigen::Vector2d(1.5, -1.), Eigen::Vector2d(0., 2.)}) {
    const Eigen::Vector2d position = project(scene, corner);
    triangle.push_back({static_cast<short>(std::lround(position.x())), static_cast<short>(std::lround(position.y()))});
  }
  EXPECT_FALSE(mayBeSheet(I, triangle.data(), triangle.size(), rise));
}

TEST(SheetRing, NothingOfALineWithoutArea)
{
  const vpImage<unsigned char> I(20, 20, 100);
  const std::vector<EdgePoint> line = {{Eigen::Vector2d(5., 5.), Eigen::Vector2d::Zero()},
                                       {Eigen::Vector2d(10., 10.), Eigen::Vector2d::Zero()},
                                       {Eigen::Vector2d(15., 15.), Eigen::Vector2d::Zero()}};
  const std::vector<EdgePixel> pixels = pixelsOf(line);
  EXPECT_FALSE(mayBeSheet(I, pixels.data(), pixels.size(), rise));
  EXPECT_FALSE(darkLineOfSheet(I, line.data(), line.size(), rise));
}
