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
 * Tests of small dark dots of an image.
 */

#include "edges/dark_dots.h"

#include <cmath>

#include "testRoomTools.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr int side = 200; // pixels: more than are looked at together
constexpr int rise = 12;  // grey levels

// A round dot with soft edges.
struct Dot
{
  double u, v;
  double radius = 1.6;
  double depth = 100.;

  double operator()(double x, double y) const { return 200. - (std::hypot(x - u, y - v) < radius ? depth : 0.); }
};

std::vector<DarkDot> dotsIn(const vpImage<unsigned char> &I)
{
  std::vector<DarkDot> dots;
  findDarkDots(I, 0, static_cast<int>(I.getHeight()), rise, dots);
  return dots;
}
} // namespace

TEST(DarkDots, IsWhereTheDotIs)
{
  Random random = randomOfTest();
  for (int i = 0; i < 20; ++i) {
    const Dot dot = {uniform(random, 10., side - 10.), uniform(random, 10., side - 10.)};
    const std::vector<DarkDot> dots = dotsIn(photograph(side, side, 0.7, dot));
    ASSERT_EQ(dots.size(), 1U) << dot.u << ' ' << dot.v;
    EXPECT_LT((dots[0].place - Eigen::Vector2d(dot.u, dot.v)).norm(), 0.15);
    EXPECT_LT(dots[0].grey, 140.);
    EXPECT_NEAR(dots[0].grey + dots[0].depth, 200., 1.);
  }
}

// Every place in a row, whatever is looked at together, up to the margin.
TEST(DarkDots, AllAlongARow)
{
  for (int u = dotReach; u < side - dotReach; ++u) {
    vpImage<unsigned char> I(9, side, 200);
    I[4][u] = 100;
    const std::vector<DarkDot> dots = dotsIn(I);
    ASSERT_EQ(dots.size(), 1U) << u;
    EXPECT_EQ(dots[0].place, Eigen::Vector2d(u, 4.));
    EXPECT_EQ(dots[0].depth, 100.);
  }
}

TEST(DarkDots, NeedTheRise)
{
  for (const int depth : {rise - 1, rise}) {
    vpImage<unsigned char> I(20, 20, 200);
    I[10][10] = static_cast<unsigned char>(200 - depth);
    EXPECT_EQ(dotsIn(I).size(), depth < rise ? 0U : 1U);
  }
}

// Of equals one is taken.
TEST(DarkDots, OneOfTwoPixelsThatAreAsDark)
{
  for (const int dv : {0, 1}) {
    vpImage<unsigned char> I(20, 20, 200);
    I[10][10] = 100;
    I[10 + dv][11] = 100;
    EXPECT_EQ(dotsIn(I).size(), 1U);
  }
}

// Lines between the directions that are asked have some.
TEST(DarkDots, NoneOnStraightLinesNorEdgesNorWideDiscs)
{
  Random random = randomOfTest();
  for (int i = 0; i < 20; ++i) {
    const double angle = M_PI_4 * static_cast<double>(i % 4) + uniform(random, -0.1, 0.1);
    const Eigen::Vector2d normal(std::cos(angle), std::sin(angle));
    const double offset = uniform(random, -5., 5.);
    const auto acrossAt = [&](double u, double v) {
      return normal.dot(Eigen::Vector2d(u - 0.5 * side, v - 0.5 * side)) - offset;
    };
    EXPECT_TRUE(dotsIn(photograph(side, side, 0.7,
                                  [&](double u, double v) { return std::fabs(acrossAt(u, v)) < 1.5 ? 100. : 200.; }))
                    .empty())
        << "a line at " << angle;
    EXPECT_TRUE(
        dotsIn(photograph(side, side, 0.7, [&](double u, double v) { return acrossAt(u, v) < 0. ? 100. : 200.; }))
            .empty())
        << "an edge at " << angle;
    EXPECT_TRUE(dotsIn(photograph(side, side, 0.7, Dot{100. + offset, 100., uniform(random, 4.5, 20.)})).empty());
  }
}

TEST(DarkDots, OnlyInTheRowsThatAreAskedFor)
{
  vpImage<unsigned char> I(40, 40, 200);
  I[10][20] = 100;
  I[30][20] = 100;
  std::vector<DarkDot> dots;
  findDarkDots(I, 0, 20, rise, dots);
  ASSERT_EQ(dots.size(), 1U);
  EXPECT_EQ(dots[0].place.y(), 10.);
  findDarkDots(I, 20, 40, rise, dots); // they are appended
  EXPECT_EQ(dots.size(), 2U);
}

TEST(DarkDots, NoneInImagesWithoutRoom)
{
  for (const unsigned int height : {1U, 6U, 7U}) {
    for (const unsigned int width : {1U, 6U, 7U}) {
      EXPECT_TRUE(dotsIn(vpImage<unsigned char>(height, width, 100)).empty());
    }
  }
}
