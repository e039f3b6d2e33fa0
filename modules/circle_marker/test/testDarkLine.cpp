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
 * Tests of the dark line that is left of a thin ring.
 */

#include "ellipse/dark_line.h"

#include <gtest/gtest.h>

#include "testSheetTools.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr unsigned int side = 100;
constexpr double blur = 0.9;
constexpr double rise = 3.; // grey levels
const LineSearch all = {48, 0.};

// The edge of the white inside of the ring, whose bright side is that of the centre.
std::vector<EdgePoint> insideOf(const MarkerScene &scene)
{
  std::vector<EdgePoint> points;
  for (int i = 0; i < 60; ++i) {
    const double angle = 2. * M_PI * i / 60.;
    const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
    const Eigen::Vector2d position = project(scene, scene.family.getLayout().ringInner * direction);
    points.push_back({position, project(scene, 0.7 * direction) - position});
  }
  return points;
}

// Of a line on the ring's middle all points are 0.9 radii from the centre; what lies beside it pulls at a line as wide
// as the blur.
void expectMiddleOfRing(const MarkerScene &scene, const std::vector<EdgePoint> &line)
{
  const double pixel = scene.center.z() / (scene.focal * scene.radius) / std::abs(scene.rotation(2, 2));
  double sum = 0.;
  for (const EdgePoint &point : line) {
    const double radius = scene.onMarker(point.position.x(), point.position.y()).norm();
    EXPECT_NEAR(radius, 0.9, 0.8 * pixel);
    EXPECT_GT(point.across.dot(point.position - project(scene, Eigen::Vector2d::Zero())), 0.);
    sum += radius;
  }
  EXPECT_NEAR(sum / static_cast<double>(line.size()), 0.9, 0.3 * pixel);
}

MarkerScene thinScene(Random &random, double ground)
{
  MarkerScene scene = sheetScene(random, side, {16., 22.}, {0., 0.8}, ground);
  scene.white = 150.;
  return scene;
}
} // namespace

TEST(DarkLine, IsTheMiddleOfTheRing)
{
  Random random = randomOfTest();
  for (const double ground : {20., 110., 240.}) {
    constexpr int scenes = 20;
    double fromInside = 0.;
    double fromSheet = 0.;
    for (int i = 0; i < scenes; ++i) {
      const MarkerScene scene = thinScene(random, ground);
      const vpImage<unsigned char> I = digitise(expose(side, side, blur, scene), 1., random);
      std::vector<EdgePoint> line;
      const std::vector<EdgePoint> inside = insideOf(scene);
      fromInside += darkLineBeside(I, inside.data(), inside.size(), RingNeighbour::INSIDE, rise, all, line) / scenes;
      expectMiddleOfRing(scene, line);
      EXPECT_LE(line.size(), all.most);
      const std::vector<EdgePoint> sheet = sheetOf(scene);
      fromSheet += darkLineBeside(I, sheet.data(), sheet.size(), RingNeighbour::SHEET, rise, all, line) / scenes;
      expectMiddleOfRing(scene, line);
    }
    EXPECT_GT(fromInside, 0.9) << "of the directions, ground " << ground;
    EXPECT_GT(fromSheet, 0.9) << "of the directions, ground " << ground;
  }
}

TEST(DarkLine, TheFirstLookSeesIt)
{
  Random random = randomOfTest();
  for (int i = 0; i < 20; ++i) {
    const MarkerScene scene = thinScene(random, 20.);
    const vpImage<unsigned char> I = digitise(expose(side, side, blur, scene), 1., random);
    for (const RingNeighbour neighbour : {RingNeighbour::INSIDE, RingNeighbour::SHEET}) {
      const std::vector<EdgePixel> pixels =
          pixelsOf(neighbour == RingNeighbour::INSIDE ? insideOf(scene) : sheetOf(scene));
      EXPECT_TRUE(mayHaveDarkLineBeside(I, pixels.data(), pixels.size(), neighbour, rise));
    }
  }
}

TEST(DarkLine, NoneOnAnEmptySheetNorBeyondTheImage)
{
  Random random = randomOfTest();
  MarkerScene scene = thinScene(random, 20.);
  const std::vector<EdgePoint> sheet = sheetOf(scene);
  const std::vector<EdgePoint> inside = insideOf(scene);
  scene.black = scene.white;
  const vpImage<unsigned char> I = digitise(expose(side, side, blur, scene), 0., random);
  std::vector<EdgePoint> line;
  EXPECT_EQ(darkLineBeside(I, sheet.data(), sheet.size(), RingNeighbour::SHEET, rise, all, line), 0.);
  EXPECT_EQ(darkLineBeside(I, inside.data(), inside.size(), RingNeighbour::INSIDE, rise, all, line), 0.);
  EXPECT_TRUE(line.empty());
  const vpImage<unsigned char> corner(8, 8, 100);
  EXPECT_EQ(darkLineBeside(corner, sheet.data(), sheet.size(), RingNeighbour::SHEET, rise, all, line), 0.);
}

TEST(DarkLine, TheSearchEndsWhereTooFewCanBeLeft)
{
  Random random = randomOfTest();
  const MarkerScene scene = thinScene(random, 20.);
  const vpImage<unsigned char> seen = digitise(expose(side, side, blur, scene), 1., random);
  const std::vector<EdgePoint> inside = insideOf(scene);
  std::vector<EdgePoint> line;
  // A first quarter of the edge beyond the image: three quarters are left, and no more.
  std::vector<EdgePoint> cut = inside;
  for (std::size_t i = 0; i < cut.size() / 4; ++i) {
    cut[i].position += Eigen::Vector2d(2. * side, 0.);
  }
  const double share = darkLineBeside(seen, cut.data(), cut.size(), RingNeighbour::INSIDE, rise, all, line);
  EXPECT_GT(share, 0.5);
  EXPECT_EQ(darkLineBeside(seen, cut.data(), cut.size(), RingNeighbour::INSIDE, rise, {all.most, share}, line), share);
  const std::size_t found = line.size();
  EXPECT_LT(darkLineBeside(seen, cut.data(), cut.size(), RingNeighbour::INSIDE, rise, {all.most, 0.9}, line), 0.9);
  EXPECT_LT(line.size(), found);
}
