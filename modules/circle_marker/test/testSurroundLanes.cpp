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
 * Test of what the pixels of a block see beyond the paper.
 */

#include "testRoomTools.h"

#include "refine/surround.h"
#include "refine/surround_lanes.h"

using namespace circle_marker;
using namespace room_test;

namespace {
// Points of a plane seen at some angle, near where the paper ends.
PlaneLanes drawPoints(Random &random, std::array<PlanePoint, laneCount> &points)
{
  PlaneLanes lanes;
  for (int k = 0; k < laneCount; ++k) {
    PlanePoint &point = points[static_cast<std::size_t>(k)];
    const double angle = uniform(random, 0., 2. * M_PI);
    point.q = uniform(random, 0.9, 1.5) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    for (int i = 0; i < 4; ++i) {
      point.byPixel(i / 2, i % 2) = (i % 3 == 0 ? 0.1 : 0.) + uniform(random, -0.04, 0.04);
    }
    const Eigen::Vector2d out = point.q.normalized();
    const Eigen::Vector2d gradient = point.byPixel.transpose() * out;
    const auto put = [k](Lanes &to, double value) { to[k] = static_cast<float>(value); };
    put(lanes.qx, point.q.x());
    put(lanes.qy, point.q.y());
    put(lanes.qxByU, point.byPixel(0, 0));
    put(lanes.qxByV, point.byPixel(0, 1));
    put(lanes.qyByU, point.byPixel(1, 0));
    put(lanes.qyByV, point.byPixel(1, 1));
    put(lanes.radius, point.q.norm());
    put(lanes.outX, out.x());
    put(lanes.outY, out.y());
    put(lanes.gradientU, gradient.x());
    put(lanes.gradientV, gradient.y());
    put(lanes.gradient, gradient.norm());
  }
  return lanes;
}
} // namespace

TEST(SurroundLanes, SharesAreThoseOfEachPixel)
{
  Random random = randomOfTest();
  for (int i = 0; i < 200; ++i) {
    std::array<PlanePoint, laneCount> points;
    const PlaneLanes lanes = drawPoints(random, points);
    PaperEnd paper;
    paper.shape = i % 2 == 0 ? PaperShape::ROUND : PaperShape::SQUARE;
    paper.extent = 1. + 1. / 6.;
    paper.angle = uniform(random, 0., 0.5 * M_PI);
    const double blur = uniform(random, 0.5, 2.);
    const ShareLanes shares = shareBeyond(lanes, paper, static_cast<float>(blur));
    for (int k = 0; k < laneCount; ++k) {
      const ShareBeyond expected = shareBeyond(points[static_cast<std::size_t>(k)], paper, blur);
      // The table's densities, which make the corner's part, are right to 1e-5.
      EXPECT_NEAR(shares.share[k], expected.share, 1e-5);
      EXPECT_NEAR(shares.byDistance[k], expected.byDistance, 3e-5);
    }
  }
}

TEST(SurroundLanes, WhatIsSeenAndWhatIsNot)
{
  Random random = randomOfTest();
  std::array<PlanePoint, laneCount> points;
  const PlaneLanes lanes = drawPoints(random, points);
  const PaperEnds papers = {{{PaperShape::ROUND, 1.2, 0.}, {PaperShape::SQUARE, 1.2, 0.3}}};
  Photometry photometry;
  photometry.white = 200.;
  photometry.surround = {{0.5, 0.}};
  std::array<FitPixel, laneCount> pixels;
  std::array<const FitPixel *, laneCount> pointers;
  for (std::size_t k = 0; k < pixels.size(); ++k) {
    pointers[k] = &pixels[k];
  }
  pixels[1].beyond[0] = {0.5f, 80.f, 0.f};      // even ground
  pixels[2].beyond[0] = {0.5f, 0.f, HUGE_VALF}; // nobody has looked there
  pixels[3].beyond[1] = {0.5f, 80.f, 0.f};      // of the shape that the paper does not have
  PixelBlock block;
  block.offsetU.setZero();
  block.offsetV.setZero();
  block.variance.setZero();
  block.variance[4] = noPixel;
  SurroundLanes surround;
  putSurround(pointers, lanes, papers, photometry, 1.f, block, surround);
  const auto shareAt = [&](std::size_t k) { return shareBeyond(points[k], papers[0], photometry.blur.sigma); };
  EXPECT_EQ(block.variance[0], 0.f);
  EXPECT_EQ(surround.share[0][0], 0.f);
  EXPECT_NEAR(surround.share[0][1], shareAt(1).share, 1e-5);
  EXPECT_EQ(surround.beyond[0][1], 80.f);
  EXPECT_NEAR(surround.spread[1], 120. * shareAt(1).share, 1e-3);
  const double even = std::pow(photometry.unevenShare * 120. * shareAt(1).share, 2.);
  const double end = std::pow(photometry.endError * 0.5 * 120. * shareAt(1).byDistance, 2.);
  EXPECT_NEAR(block.variance[1], even + end, 1e-3 * (even + end) + 1e-6);
  EXPECT_EQ(surround.share[0][2], 0.f);
  const double anything = std::pow(100. * shareAt(2).share, 2.);
  EXPECT_NEAR(block.variance[2], anything, 1e-3 * anything + 1e-6);
  EXPECT_EQ(surround.share[0][3], 0.f);
  EXPECT_GT(surround.share[1][3], 0.f);
  EXPECT_EQ(block.variance[4], noPixel);
}
