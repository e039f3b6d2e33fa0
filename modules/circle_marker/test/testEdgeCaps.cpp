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
 * Where edges turn back: the ends of what is narrow.
 */

#include "edges/edge_caps.h"

#include <cmath>

#include "testRoomTools.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr unsigned int side = 120;

struct Capped
{
  Gradient gradient;
  EdgeChains edges;
  ReusedList<EdgeCap> caps;

  explicit Capped(const vpImage<unsigned char> &I)
  {
    computeGradient(I, gradient);
    linkEdgeChains(gradient, 14, edges);
    for (std::size_t chain = 0; chain < edges.chains.size(); ++chain) {
      findCaps(gradient, edges, chain, caps);
    }
  }
};

EllipseScene narrowScene(Random &random, bool isDark)
{
  EllipseScene scene = {Eigen::Vector2d(uniform(random, 55., 65.), uniform(random, 55., 65.)),
                        uniform(random, 18., 40.), uniform(random, 2.5, 4.), uniform(random, -M_PI_2, M_PI_2)};
  if (!isDark) {
    std::swap(scene.inside, scene.outside);
  }
  return scene;
}
} // namespace

TEST(EdgeCaps, EndsOfNarrowEllipses)
{
  Random random = randomOfTest();
  for (const bool isDark : {true, false}) {
    for (int i = 0; i < 20; ++i) {
      const EllipseScene ellipse = narrowScene(random, isDark);
      const Capped found(photograph(side, side, 0.7, ellipse));
      ASSERT_EQ(found.caps.size(), 2U) << "axes " << ellipse.a << ' ' << ellipse.b;
      const Eigen::Vector2d major(std::cos(ellipse.angle), std::sin(ellipse.angle));
      double ends = 0.;
      for (const EdgeCap &cap : found.caps) {
        EXPECT_EQ(cap.isDark, isDark);
        const double end = cap.axis.dot(major) > 0. ? 1. : -1.;
        ends += end;
        EXPECT_GT(end * cap.axis.dot(major), 0.95);
        // The blur takes a little of so sharp a tip.
        EXPECT_LT((cap.tip - ellipse.center - end * ellipse.a * major).norm(), 2.5);
      }
      EXPECT_EQ(ends, 0.) << "one at either end";
    }
  }
}

TEST(EdgeCaps, NoneOnDiscsAndSquares)
{
  Random random = randomOfTest();
  for (int i = 0; i < 10; ++i) {
    const EllipseScene disc = {Eigen::Vector2d(60., 60.), uniform(random, 15., 50.), 0., 0.};
    EllipseScene round = disc;
    round.b = round.a;
    EXPECT_TRUE(Capped(photograph(side, side, 0.7, round)).caps.empty());
    const double turn = uniform(random, 0., M_PI);
    const auto square = [&](double u, double v) {
      const double x = std::cos(turn) * (u - 60.) + std::sin(turn) * (v - 60.);
      const double y = std::cos(turn) * (v - 60.) - std::sin(turn) * (u - 60.);
      return std::max(std::fabs(x), std::fabs(y)) < 30. ? ink : paper;
    };
    EXPECT_TRUE(Capped(photograph(side, side, 0.7, square)).caps.empty());
  }
}

// Wherever the chain begins: the points run once around the tip, as far as is asked.
TEST(EdgeCaps, PointsAroundATip)
{
  Random random = randomOfTest();
  for (int i = 0; i < 20; ++i) {
    const EllipseScene ellipse = narrowScene(random, true);
    const Capped found(photograph(side, side, 0.7, ellipse));
    ASSERT_EQ(found.caps.size(), 2U);
    for (const EdgeCap &cap : found.caps) {
      constexpr std::size_t reach = 12;
      ASSERT_TRUE(found.edges.chains[cap.chain].closed);
      EXPECT_GE(cap.before, reach);
      EXPECT_GE(cap.after, reach);
      std::vector<EdgePoint> points;
      locateCap(found.gradient, found.edges, cap, reach, points);
      ASSERT_GT(points.size(), 2 * reach - 4);
      ASSERT_LE(points.size(), 2 * reach + 1);
      for (std::size_t k = 0; k < points.size(); ++k) {
        EXPECT_LT((points[k].position - cap.tip).norm(), 1.5 * reach);
        if (k > 0) {
          EXPECT_LT((points[k].position - points[k - 1].position).norm(), 3.5) << "in the order of the chain";
        }
      }
      // Clockwise as the image is seen: what lies after the tip lies to the right of the way out.
      const CapSides sides = sidesOf(found.edges, cap, reach);
      const auto beside = [&](const Eigen::Vector2d &p) {
        return cap.axis.x() * (p - cap.tip).y() - cap.axis.y() * (p - cap.tip).x();
      };
      EXPECT_GT(beside(sides.after), 0.5);
      EXPECT_LT(beside(sides.before), -0.5);
    }
  }
}

TEST(EdgeCaps, NoneOnShortOrStraightChains)
{
  const auto half = [](double u, double) { return u < 60. ? ink : paper; };
  const Capped straight(photograph(side, side, 0.7, half));
  EXPECT_EQ(straight.edges.chains.size(), 1U);
  EXPECT_TRUE(straight.caps.empty());
}
