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
 * Tests of which arcs may belong to one ellipse.
 */

#include "ellipse/loose_arcs.h"

#include "testRoomTools.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr unsigned int side = 200;

// The arc of an ellipse between two of its parameters, with a point a pixel or so.
std::vector<EdgePoint> arcOf(const EllipseScene &ellipse, double from, double to)
{
  const Eigen::Vector2d major(std::cos(ellipse.angle), std::sin(ellipse.angle));
  const Eigen::Vector2d minor(-major.y(), major.x());
  std::vector<EdgePoint> points;
  const int count = static_cast<int>((to - from) * ellipse.a);
  for (int i = 0; i < count; ++i) {
    const double t = from + (to - from) * i / count;
    const Eigen::Vector2d outward = ellipse.b * std::cos(t) * major + ellipse.a * std::sin(t) * minor;
    points.push_back(
        {ellipse.center + ellipse.a * std::cos(t) * major + ellipse.b * std::sin(t) * minor, outward.normalized()});
  }
  return points;
}

// The same as a loose arc of an image; what it bends is the angle between the normals at its ends.
LooseArc looseArcOf(const vpImage<unsigned char> &I, const EllipseScene &ellipse, double from, double to)
{
  const std::vector<EdgePoint> points = arcOf(ellipse, from, to);
  const auto direction = [](const EdgePoint &point) { return std::atan2(point.across.y(), point.across.x()); };
  const double turn = direction(points.back()) - direction(points.front());
  LooseArc arc;
  arc.set(I, 3, points.data(), points.size(), turn - 2. * M_PI * std::floor(turn / (2. * M_PI)));
  return arc;
}

EllipseScene discAt(const Eigen::Vector2d &center, double a)
{
  return {center, a, 0.7 * a, 0.4};
}
} // namespace

TEST(LooseArcs, WhatAnArcIsLike)
{
  const EllipseScene disc = discAt(Eigen::Vector2d(100., 100.), 60.);
  const LooseArc arc = looseArcOf(photograph(side, side, 0.7, disc), disc, 1., 1.8);
  EXPECT_EQ(arc.chain, 3u);
  EXPECT_EQ(arc.points.size(), arcOf(disc, 1., 1.8).size() - 4) << "without the two at either end";
  EXPECT_NEAR(arc.greys.dark, ink, 10.); // a twentieth of the step is still in the blur
  EXPECT_NEAR(arc.greys.bright, paper, 10.);
  for (const EdgePoint &end : arc.ends) {
    EXPECT_NEAR(end.across.norm(), 1., 1e-12);
  }
}

TEST(LooseArcs, ArcsOfOneEllipseBelongTogether)
{
  Random random = randomOfTest();
  for (int i = 0; i < 30; ++i) {
    EllipseScene disc = discAt(Eigen::Vector2d(100., 100.), uniform(random, 30., 60.));
    disc.b = disc.a * uniform(random, 0.5, 1.);
    disc.angle = uniform(random, -M_PI_2, M_PI_2);
    const vpImage<unsigned char> I = photograph(side, side, 0.7, disc);
    const double from = uniform(random, 0., 2. * M_PI);
    const LooseArc one = looseArcOf(I, disc, from, from + 1.2);
    const LooseArc other = looseArcOf(I, disc, from + uniform(random, 1.4, 4.), from + uniform(random, 5.2, 6.));
    EXPECT_TRUE(mayBelongTogether(one, other)) << i;
    EXPECT_TRUE(mayBelongTogether(other, one)) << i;
  }
}

TEST(LooseArcs, ArcsOfTwoDiscsDoNot)
{
  const EllipseScene left = discAt(Eigen::Vector2d(50., 100.), 40.);
  const EllipseScene right = discAt(Eigen::Vector2d(150., 100.), 40.);
  const auto both = [&](double u, double v) { return std::min(left(u, v), right(u, v)); };
  const vpImage<unsigned char> I = photograph(side, side, 0.7, both);
  // The sides that face each other: each lies outside of the other's tangents.
  const LooseArc one = looseArcOf(I, left, -1., 1.);
  const LooseArc other = looseArcOf(I, right, M_PI - 1., M_PI + 1.);
  EXPECT_FALSE(mayBelongTogether(one, other));
  EXPECT_FALSE(mayBelongTogether(other, one));
  // The same side of either: they look to the same direction.
  EXPECT_FALSE(mayBelongTogether(one, looseArcOf(I, right, -1., 1.)));
}

TEST(LooseArcs, ArcsThatAreNotAlikeDoNot)
{
  const EllipseScene disc = discAt(Eigen::Vector2d(100., 100.), 60.);
  // As ink on the right, as something grey on the left.
  const auto halved = [&](double u, double v) { return u > 100. || disc(u, v) > 100. ? disc(u, v) : 130.; };
  const vpImage<unsigned char> I = photograph(side, side, 0.7, halved);
  const vpImage<unsigned char> whole = photograph(side, side, 0.7, disc);
  EXPECT_TRUE(mayBelongTogether(looseArcOf(whole, disc, -0.7, 0.5), looseArcOf(whole, disc, 2.4, 3.7)));
  EXPECT_FALSE(mayBelongTogether(looseArcOf(I, disc, -0.7, 0.5), looseArcOf(I, disc, 2.4, 3.7)));
}

TEST(LooseArcs, ArcsThatBendTooLittleTogetherDoNot)
{
  const EllipseScene disc = discAt(Eigen::Vector2d(100., 100.), 60.);
  const vpImage<unsigned char> I = photograph(side, side, 0.7, disc);
  EXPECT_FALSE(mayBelongTogether(looseArcOf(I, disc, 1.2, 1.6), looseArcOf(I, disc, 4.4, 4.8)));
}
