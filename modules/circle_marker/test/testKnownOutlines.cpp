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
 * Tests of the outlines found so far.
 */

#include "ellipse/known_outlines.h"

#include "ellipse/conic.h"
#include "ellipse/ellipse_walk.h"
#include "testRoomTools.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr int side = 400;

EllipseParameters ellipseAt(double u, double v, double a)
{
  EllipseParameters ellipse;
  ellipse.center = Eigen::Vector2d(u, v);
  ellipse.a = a;
  ellipse.b = 0.8 * a;
  ellipse.angle = 0.3;
  return ellipse;
}

EllipseCandidate candidateAt(const EllipseParameters &ellipse, double support)
{
  EllipseCandidate candidate;
  candidate.ellipse = ellipse;
  candidate.conic = conicFromEllipse(ellipse);
  candidate.support = support;
  constexpr int count = 64;
  EllipseWalk walk(ellipse, count);
  for (int i = 0; i < count; ++i, walk.next()) {
    candidate.points.push_back(walk.here());
  }
  return candidate;
}

struct Known
{
  KnownOutlines outlines;
  Known() { outlines.reset(side, side); }
  bool take(const EllipseParameters &ellipse, double support, bool isThin = false)
  {
    EllipseCandidate candidate = candidateAt(ellipse, support);
    candidate.isThin = isThin;
    return outlines.take(candidate);
  }
};
} // namespace

TEST(KnownOutlines, OfTwoThatAreTheSameTheBetterStays)
{
  Known known;
  EXPECT_TRUE(known.take(ellipseAt(100., 120., 40.), 0.7));
  EXPECT_FALSE(known.take(ellipseAt(101., 120., 41.), 0.6));
  EXPECT_EQ(known.outlines.outlines[0].ellipse.a, 40.);
  EXPECT_FALSE(known.take(ellipseAt(100., 121., 39.), 0.9));
  EXPECT_EQ(known.outlines.outlines[0].ellipse.a, 39.);
  EXPECT_FALSE(known.take(ellipseAt(100., 121., 38.5), 1., true)) << "a dark line never replaces an edge";
  EXPECT_EQ(known.outlines.outlines[0].ellipse.a, 39.);
  EXPECT_TRUE(known.take(ellipseAt(100., 120., 20.), 0.7)) << "half as large";
  EXPECT_TRUE(known.take(ellipseAt(150., 120., 40.), 0.7)) << "elsewhere";
  EXPECT_EQ(known.outlines.outlines.size(), 3u);
  EXPECT_TRUE(known.outlines.hasSame(ellipseAt(149., 121., 40.)));
  EXPECT_FALSE(known.outlines.hasSame(ellipseAt(200., 121., 40.)));
}

// On bright ground: the edge is in part that of the sheet.
TEST(KnownOutlines, ADarkLineWellInsideOfAnEdgeIsAnotherOutline)
{
  Known known;
  ASSERT_TRUE(known.take(ellipseAt(100., 120., 16.), 0.9));
  EXPECT_FALSE(known.take(ellipseAt(100., 120., 15.5), 1., true));
  EXPECT_TRUE(known.outlines.hasSame(ellipseAt(100., 120., 14.5)));
  EXPECT_FALSE(known.outlines.hasSame(ellipseAt(100., 120., 14.5), true));
  EXPECT_TRUE(known.take(ellipseAt(100., 120., 14.5), 0.8, true));
  EXPECT_FALSE(known.take(ellipseAt(100., 120., 14.), 0.7, true)) << "two lines of one ring";
  EXPECT_EQ(known.outlines.outlines.size(), 2u);
}

TEST(KnownOutlines, HoldsThePointsAlongThem)
{
  Known known;
  const EllipseParameters ellipse = ellipseAt(200., 200., 100.);
  ASSERT_TRUE(known.take(ellipse, 0.7));
  const std::vector<EdgePoint> along = candidateAt(ellipse, 1.).points;
  EXPECT_TRUE(known.outlines.holds(along.data(), along.size()));
  EXPECT_TRUE(known.outlines.holds(along.data(), 20)) << "an arc";
  EXPECT_TRUE(known.outlines.holds(along.data(), along.size(), 1., 0., 0.7));
  EXPECT_FALSE(known.outlines.holds(along.data(), along.size(), 1., 0., 0.8)) << "less is found of it";
  const std::vector<EdgePoint> inside = candidateAt(ellipseAt(200., 200., 80.), 1.).points;
  EXPECT_FALSE(known.outlines.holds(inside.data(), inside.size()));
  // The same outline at half the size: pixel u' is at 2 u' + 1/2.
  const std::vector<EdgePoint> half = candidateAt(ellipseAt(99.75, 99.75, 50.), 1.).points;
  EXPECT_TRUE(known.outlines.holds(half.data(), half.size(), 2., 0.5));
  EXPECT_FALSE(known.outlines.holds(half.data(), half.size()));
}

// An outline of an arc comes after that which has more of the edge, though neither ellipse is the other.
TEST(KnownOutlines, TheBetterOneAlongTheSameEdgeIsKnown)
{
  Known known;
  const EllipseParameters whole = ellipseAt(200., 200., 100.);
  ASSERT_TRUE(known.take(whole, 0.95));
  EllipseCandidate arc = candidateAt(ellipseAt(190., 195., 115.), 0.8); // as it was found, of points of the other
  const std::vector<EdgePoint> beside = arc.points;
  arc.points = candidateAt(whole, 1.).points;
  arc.points.resize(20);
  ASSERT_NE(known.outlines.betterAlong(arc), nullptr);
  EXPECT_EQ(known.outlines.betterAlong(arc)->ellipse.a, 100.);
  const auto isBehindWith = [&](std::size_t points) { // of 20, the rest elsewhere
    EllipseCandidate other = arc;
    std::copy(beside.begin() + 30, beside.begin() + 30 + static_cast<std::ptrdiff_t>(20 - points),
              other.points.begin() + static_cast<std::ptrdiff_t>(points));
    return known.outlines.betterAlong(other) != nullptr;
  };
  EXPECT_TRUE(isBehindWith(12));
  EXPECT_FALSE(isBehindWith(9)) << "less than half of its points are along it";
  arc.support = 0.95;
  EXPECT_EQ(known.outlines.betterAlong(arc), nullptr) << "no more is found of it";
  // Of a thin ring an edge that is well found is better, whatever is found of its dark line.
  arc.isThin = true;
  arc.support = 1.;
  EXPECT_NE(known.outlines.betterAlong(arc), nullptr);
  arc.isThin = false;
  // Of several the largest: it is looked at first.
  arc.support = 0.5;
  EllipseCandidate larger = candidateAt(ellipseAt(200., 200., 140.), 0.9);
  larger.conic = conicFromEllipse(whole); // as if the arc lay along it, too
  larger.points = candidateAt(whole, 1.).points;
  known.outlines.take(larger);
  EXPECT_EQ(known.outlines.betterAlong(arc)->ellipse.a, 140.);
}

TEST(EllipseCandidate, TheLargestComesFirstButForArcsOfAnother)
{
  EllipseCandidate whole = candidateAt(ellipseAt(200., 200., 100.), 0.95);
  EllipseCandidate arc = candidateAt(ellipseAt(190., 195., 115.), 0.8);
  const EllipseCandidate small = candidateAt(ellipseAt(200., 200., 50.), 1.);
  EXPECT_TRUE(comesBefore(arc, whole));
  EXPECT_TRUE(comesBefore(whole, small));
  arc.behind = whole.ellipse.a;
  EXPECT_TRUE(comesBefore(whole, arc));
  EXPECT_FALSE(comesBefore(arc, whole));
  EXPECT_TRUE(comesBefore(arc, small));
}

TEST(KnownOutlines, SurroundsWhatIsInside)
{
  Known known;
  ASSERT_TRUE(known.take(ellipseAt(200., 200., 100.), 0.7)); // 80 across its longer axis
  const Eigen::Vector2d minor(-std::sin(0.3), std::cos(0.3));
  const Eigen::Vector2d center(200., 200.);
  EXPECT_TRUE(known.outlines.surrounds(center, 0.7));
  EXPECT_TRUE(known.outlines.surrounds(center + 79. * minor, 0.7));
  EXPECT_FALSE(known.outlines.surrounds(center + 81. * minor, 0.7));
  EXPECT_FALSE(known.outlines.surrounds(center, 0.8)) << "less is found of it";
  EXPECT_FALSE(known.outlines.surrounds(center, 0.7, known.outlines.outlines.size())) << "all are left out";
}

// The centres of two that are the same may be farther apart than places are looked up by.
TEST(KnownOutlines, LargeOnesAreTheSameThoughTheirCentresAreFarApart)
{
  constexpr int largeSide = 2000;
  constexpr double semiAxis = 550.; // a tenth of the other one, 44 pixels, may be between the same ones
  KnownOutlines outlines;
  outlines.reset(largeSide, largeSide);
  EllipseCandidate first = candidateAt(ellipseAt(1000., 1000., semiAxis), 0.8);
  ASSERT_TRUE(outlines.take(first));
  for (const double away : {-43., -35., 35., 43.}) {
    EllipseCandidate again = candidateAt(ellipseAt(1000. + away, 1000., semiAxis), 0.7);
    EXPECT_FALSE(outlines.take(again)) << away;
  }
  EllipseCandidate other = candidateAt(ellipseAt(1050., 1000., semiAxis), 0.7);
  EXPECT_TRUE(outlines.take(other));
}
