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
 * Tests of the ring whose two ends are two dark dots.
 */

#include "ellipse/dot_pairs.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "ellipse/fit_conic.h"
#include "testSheetTools.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr unsigned int side = 100;
constexpr double ringInner = 0.8;

// A marker whose ring is half a pixel wide along its sides.
MarkerScene narrowScene(Random &random, double ground)
{
  return sheetScene(random, side, {5., 7.}, {1.3, 1.45}, ground);
}

EllipseParameters outlineOf(const MarkerScene &scene)
{
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < 40; ++i) {
    const double angle = 2. * M_PI * i / 40.;
    points.push_back(project(scene, Eigen::Vector2d(std::cos(angle), std::sin(angle))));
  }
  return *ellipseFromConic(*fitEllipse(points.data(), points.size()));
}

// The rings that the pairs of dots of an image make. The code may have dots, too.
std::vector<EllipseParameters> ringsIn(const vpImage<unsigned char> &I)
{
  std::vector<EllipseParameters> rings;
  std::vector<DarkDot> dots;
  findDarkDots(I, 0, static_cast<int>(I.getHeight()), 12, dots);
  for (std::size_t i = 0; i < dots.size(); ++i) {
    for (std::size_t j = i + 1; j < dots.size(); ++j) {
      if (const auto ring = ringBetween(I, dots[i], dots[j], ringInner)) {
        rings.push_back(*ring);
      }
    }
  }
  return rings;
}
} // namespace

// Ground as dark as ink runs into the dots, and of a ring two pixels high bright ground takes the sides.
TEST(DotPairs, OutlineOfANarrowMarkerOnAnyGround)
{
  struct Ground
  {
    double grey;
    int floor; // of the scenes
  };
  constexpr int scenes = 50;
  Random random = randomOfTest();
  for (const auto &[ground, floor] : {Ground{20., 29}, Ground{110., 47}, Ground{160., 47}, Ground{250., 37}}) {
    int found = 0;
    for (int i = 0; i < scenes; ++i) {
      const MarkerScene scene = narrowScene(random, ground);
      const EllipseParameters truth = outlineOf(scene);
      const auto isTrue = [&truth](const EllipseParameters &ring) {
        return (ring.center - truth.center).norm() < 0.6 && std::fabs(ring.a - truth.a) < 0.5 + 0.03 * truth.a &&
               std::fabs(ring.b - truth.b) < 0.7 && std::fabs(truth.a * std::sin(ring.angle - truth.angle)) < 0.6;
      };
      const auto rings = ringsIn(digitise(expose(side, side, 0.7, scene), 2., random));
      found += std::any_of(rings.begin(), rings.end(), isTrue) ? 1 : 0;
    }
    EXPECT_GE(found, floor) << "ground " << ground;
  }
}

TEST(DotPairs, NoneOfTwoDotsOnPaper)
{
  Random random = randomOfTest();
  for (int i = 0; i < 20; ++i) {
    const double distance = uniform(random, 12., 40.);
    const auto paper = [distance](double u, double v) {
      const double du = std::fabs(u - 50.) - 0.5 * distance;
      return std::hypot(du, v - 50.) < 1.5 ? 30. : 220.;
    };
    EXPECT_TRUE(ringsIn(digitise(expose(side, side, 0.7, paper), 2., random)).empty()) << distance;
  }
}

// A line between them is no ring, dark or with a white one inside of it.
TEST(DotPairs, NoneOfBars)
{
  Random random = randomOfTest();
  for (int i = 0; i < 20; ++i) {
    const double length = uniform(random, 12., 40.);
    const double width = uniform(random, 1., 3.);
    const auto bar = [&](double u, double v) {
      return std::fabs(u - 50.) < 0.5 * length && std::fabs(v - 50.) < width ? 30. : 220.;
    };
    EXPECT_TRUE(ringsIn(digitise(expose(side, side, 0.7, bar), 2., random)).empty()) << length << " x " << width;
  }
}

TEST(DotPairs, NoneTooFarApartNorTooNearNorUneven)
{
  const vpImage<unsigned char> I(side, side, 200);
  const DarkDot dot = {Eigen::Vector2d(50., 50.), 100., 100.};
  const auto at = [](double u, double grey) { return DarkDot{Eigen::Vector2d(u, 50.), grey, 200. - grey}; };
  EXPECT_FALSE(ringBetween(I, dot, dot, ringInner));
  EXPECT_FALSE(ringBetween(I, dot, at(55., 100.), ringInner));
  EXPECT_FALSE(ringBetween(I, dot, at(80., 150.), ringInner));
  EXPECT_FALSE(ringBetween(I, dot, at(50. + farthestDots + 1., 100.), ringInner));
}
