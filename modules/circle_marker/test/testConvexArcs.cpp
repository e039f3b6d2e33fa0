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
 * Cutting chains into arcs that may belong to an ellipse.
 */

#include "testRoomTools.h"

#include "edges/convex_arcs.h"

using namespace circle_marker;
using namespace room_test;

namespace {
using Arcs = std::vector<ConvexArc>;

//! Points about a pixel apart on an arc, walked with the angle growing (dark inside) or falling.
void appendArc(std::vector<EdgePoint> &points, const Eigen::Vector2d &center, double radius, double from, double to)
{
  const int count = static_cast<int>(std::fabs(to - from) * radius);
  for (int i = 0; i < count; ++i) {
    const double angle = from + (to - from) * i / count;
    const Eigen::Vector2d outward(std::cos(angle), std::sin(angle));
    points.push_back({center + radius * outward, outward});
  }
}

void appendLine(std::vector<EdgePoint> &points, const Eigen::Vector2d &from, const Eigen::Vector2d &to)
{
  const int count = static_cast<int>((to - from).norm());
  const Eigen::Vector2d along = (to - from) / count;
  for (int i = 0; i < count; ++i) {
    points.push_back({from + i * along, Eigen::Vector2d(along.y(), -along.x())});
  }
}

void shake(std::vector<EdgePoint> &points, Random &random, double sigma)
{
  std::normal_distribution<double> normal(0., sigma);
  for (EdgePoint &point : points) {
    point.position += Eigen::Vector2d(normal(random), normal(random));
  }
}

Arcs arcsOf(const std::vector<EdgePoint> &points)
{
  Arcs arcs = {{7, 9, 1.}}; // left over from before
  cutConvexArcs(points, leastArcTurn, arcs);
  return arcs;
}
} // namespace

TEST(ConvexArcs, ArcsOfCirclesStayWhole)
{
  Random random = randomOfTest();
  for (int i = 0; i < 200; ++i) {
    std::vector<EdgePoint> points;
    const double radius = uniform(random, 10., 200.);
    const double from = uniform(random, 0., 2. * M_PI);
    appendArc(points, Eigen::Vector2d(300., 300.), radius, from, from + uniform(random, 1.8, 6.));
    shake(points, random, 0.05);
    if (points.size() < 40) {
      continue;
    }
    const Arcs arcs = arcsOf(points);
    ASSERT_EQ(arcs.size(), 1u) << "radius " << radius;
    EXPECT_EQ(arcs[0].begin, 0u);
    EXPECT_EQ(arcs[0].end, points.size());
  }
}

TEST(ConvexArcs, BrightInsideGivesNone)
{
  for (const double radius : {8., 20., 40.}) {
    std::vector<EdgePoint> points;
    appendArc(points, Eigen::Vector2d(300., 300.), radius, 0., -5.);
    EXPECT_TRUE(arcsOf(points).empty()) << radius;
  }
}

TEST(ConvexArcs, StraightLinesAndShortArcsGiveNone)
{
  Random random = randomOfTest();
  std::vector<EdgePoint> line;
  appendLine(line, Eigen::Vector2d(10., 10.), Eigen::Vector2d(200., 90.));
  shake(line, random, 0.1);
  EXPECT_TRUE(arcsOf(line).empty());
  std::vector<EdgePoint> few;
  appendArc(few, Eigen::Vector2d(30., 30.), 4., 0., 3.);
  EXPECT_TRUE(arcsOf(few).empty());
  EXPECT_TRUE(arcsOf({}).empty());
  // A shallow bend fixes no ellipse.
  std::vector<EdgePoint> shallow;
  appendArc(shallow, Eigen::Vector2d(0., 0.), 200., 0., 0.5);
  EXPECT_TRUE(arcsOf(shallow).empty());
}

TEST(ConvexArcs, ALetterSIsCutAtItsWaist)
{
  // Half a turn to one side, half a turn to the other: the first half is dark inside.
  std::vector<EdgePoint> points;
  appendArc(points, Eigen::Vector2d(100., 100.), 20., 0., M_PI);
  const std::size_t waist = points.size();
  appendArc(points, Eigen::Vector2d(60., 100.), 20., 0., -M_PI);
  const Arcs arcs = arcsOf(points);
  ASSERT_EQ(arcs.size(), 1u);
  EXPECT_EQ(arcs[0].begin, 0u);
  EXPECT_NEAR(static_cast<double>(arcs[0].end), static_cast<double>(waist), 6.);
}

TEST(ConvexArcs, TwoDiscsThatTouchAreTwoArcs)
{
  // The outline of two overlapping discs has two sharp corners that bend the wrong way.
  std::vector<EdgePoint> points;
  appendArc(points, Eigen::Vector2d(100., 100.), 30., -M_PI / 2., M_PI * 1.25);
  const std::size_t corner = points.size();
  appendArc(points, Eigen::Vector2d(100. - 30. * M_SQRT2, 100.), 30., M_PI * -0.25 + M_PI / 2. + 0.01, M_PI * 1.5);
  const Arcs arcs = arcsOf(points);
  ASSERT_EQ(arcs.size(), 2u);
  EXPECT_NEAR(static_cast<double>(arcs[0].end), static_cast<double>(corner), 6.);
  EXPECT_NEAR(static_cast<double>(arcs[1].begin), static_cast<double>(corner), 6.);
  EXPECT_EQ(arcs[1].end, points.size());
}

TEST(ConvexArcs, SquaresAreCutAtTheirCorners)
{
  std::vector<EdgePoint> points;
  const Eigen::Vector2d corners[] = {{50., 50.}, {120., 50.}, {120., 120.}, {50., 120.}};
  for (std::size_t i = 0; i < 4; ++i) {
    appendLine(points, corners[i], corners[(i + 1) % 4]);
  }
  EXPECT_TRUE(arcsOf(points).empty());
}

// An arc that goes on along a line, which it meets at a corner that is too blunt to be cut at first.
TEST(ConvexArcs, CutAtABluntCorner)
{
  Random random = randomOfTest();
  for (const double corner : {0.5, 0.8, 1.}) {
    const Eigen::Vector2d center(100., 100.);
    const double radius = 60.;
    const double last = uniform(random, 0.5, 1.);
    std::vector<EdgePoint> points;
    appendArc(points, center, radius, -1.5, last);
    const std::size_t end = points.size();
    const Eigen::Vector2d from = center + radius * Eigen::Vector2d(std::cos(last), std::sin(last));
    const double along = last + M_PI_2 + corner;
    appendLine(points, from, from + 40. * Eigen::Vector2d(std::cos(along), std::sin(along)));
    shake(points, random, 0.05);
    Arcs arcs = arcsOf(points);
    ASSERT_EQ(arcs.size(), 1u) << corner;
    ASSERT_EQ(arcs[0].length(), points.size());
    const ConvexArc whole = arcs[0];
    ASSERT_TRUE(cutAtCorner(points, whole, 0.3, arcs)) << corner;
    ASSERT_EQ(arcs.size(), 2u) << "the line bends too little";
    EXPECT_EQ(arcs[1].begin, 0u);
    EXPECT_NEAR(static_cast<double>(arcs[1].end), static_cast<double>(end), 8.);
    EXPECT_LE(arcs[1].end, end);
    EXPECT_NEAR(arcs[1].turn, last + 1.5, 0.25);
    EXPECT_FALSE(cutAtCorner(points, arcs[1], 0.3, arcs)) << "a circle has no corner";
    EXPECT_EQ(arcs.size(), 2u);
  }
}

// Gradients of the first and the last pixel that noise turns by a tenth of a radian each, toward one another: the arc
// bends by two tenths more than they say, and must not be dropped for it.
TEST(ConvexArcs, NoiseDoesNotLowerTheBoundOfTheTurn)
{
  constexpr int imageSide = 200;
  constexpr double noiseOfDirection = 0.1; // rad
  constexpr double turnOfArc = 0.85;       // rad, less than what an arc has to have
  constexpr double magnitude = 400.;
  for (const double radius : {20., 40., 80.}) {
    Gradient gradient;
    gradient.width = imageSide;
    gradient.height = imageSide;
    gradient.vectors.assign(static_cast<std::size_t>(imageSide) * imageSide, GradientVector{0, 0});
    EdgeChains chains;
    const int last = static_cast<int>(turnOfArc * radius);
    for (int i = 0; i <= last; ++i) {
      const double angle = turnOfArc * i / last;
      const double seen = angle + (i == 0 ? noiseOfDirection : 0.) - (i == last ? noiseOfDirection : 0.);
      const EdgePixel pixel = {static_cast<short>(std::lround(100. + radius * std::cos(angle))),
                               static_cast<short>(std::lround(100. + radius * std::sin(angle)))};
      chains.pixels.push_back(pixel);
      gradient.vectors[gradient.index(pixel.x, pixel.y)] = {
          static_cast<short>(std::lround(magnitude * std::cos(seen))),
          static_cast<short>(std::lround(magnitude * std::sin(seen)))};
    }
    const EdgeChain chain = {0, chains.pixels.size(), false};
    EXPECT_GE(mostTurn(gradient, chains, chain), turnOfArc) << radius;
  }
}
