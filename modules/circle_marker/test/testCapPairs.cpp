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
 * The two ends of one narrow thing.
 */

#include "ellipse/cap_pairs.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "ellipse/fit_conic.h"
#include "testRoomTools.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr unsigned int side = 120;
const Eigen::Vector2d center(60., 60.);

struct Capped
{
  Gradient gradient;
  EdgeChains edges;
  ReusedList<EdgeCap> caps;

  template <class Scene> explicit Capped(const Scene &scene)
  {
    computeGradient(photograph(side, side, 0.7, scene), gradient);
    linkEdgeChains(gradient, 14, edges);
    for (std::size_t chain = 0; chain < edges.chains.size(); ++chain) {
      findCaps(gradient, edges, chain, caps);
    }
  }
};

// The chains without what lies so near to the centre along a direction.
EdgeChains brokenAt(const EdgeChains &whole, double angle, double reach)
{
  EdgeChains broken;
  for (const EdgeChain &chain : whole.chains) {
    const auto isLeft = [&](std::size_t i) {
      const EdgePixel &pixel = whole.pixels[chain.begin + i % chain.length()];
      return std::fabs(std::cos(angle) * (pixel.x - center.x()) + std::sin(angle) * (pixel.y - center.y())) >= reach;
    };
    std::size_t start = 0;
    while (isLeft(start)) {
      ++start;
    }
    for (std::size_t i = start; i < start + chain.length(); ++i) {
      if (isLeft(i)) {
        if (!isLeft(i - 1)) {
          broken.chains.push_back({broken.pixels.size(), broken.pixels.size(), false});
        }
        broken.pixels.push_back(whole.pixels[chain.begin + i % chain.length()]);
        broken.chains.back().end = broken.pixels.size();
      }
    }
  }
  return broken;
}
} // namespace

TEST(CapPairs, EndsOfABrokenEllipse)
{
  Random random = randomOfTest();
  for (int i = 0; i < 20; ++i) {
    const EllipseScene ellipse = {center, uniform(random, 25., 40.), uniform(random, 3., 4.),
                                  uniform(random, -M_PI_2, M_PI_2)};
    Capped found(ellipse);
    const EdgeChains broken = brokenAt(found.edges, ellipse.angle, 5.);
    ASSERT_EQ(broken.chains.size(), 2U);
    found.caps.clear();
    for (std::size_t chain = 0; chain < 2; ++chain) {
      findCaps(found.gradient, broken, chain, found.caps);
    }
    ASSERT_EQ(found.caps.size(), 2U);
    ASSERT_TRUE(mayBeEnds(broken, found.caps[0], found.caps[1]));
    std::vector<EdgePoint> points = {{center, center}}; // left over from before
    locateEnds(found.gradient, broken, found.caps[0], found.caps[1], points);
    ASSERT_GT(points.size(), 2. * ellipse.a);
    std::vector<Eigen::Vector2d> positions;
    for (const EdgePoint &point : points) {
      positions.push_back(point.position);
    }
    const auto conic = fitEllipse(positions.data(), positions.size());
    const auto fitted = conic ? ellipseFromConic(*conic) : std::nullopt;
    ASSERT_TRUE(fitted);
    EXPECT_LT((fitted->center - center).norm(), 0.2);
    EXPECT_NEAR(fitted->a, ellipse.a, 0.05 * ellipse.a) << "the blur takes a little of the tips";
    EXPECT_NEAR(fitted->b, ellipse.b, 0.3);
  }
}

TEST(CapPairs, EveryPairNearEnoughIsACandidateOnce)
{
  Random random = randomOfTest();
  std::vector<EdgeCap> caps(300);
  std::vector<const EdgeCap *> sorted;
  for (EdgeCap &cap : caps) {
    cap.tip = Eigen::Vector2d(std::floor(uniform(random, 0., 1000.)), std::floor(uniform(random, 0., 700.)));
    cap.chain = sorted.size();
    sorted.push_back(&cap);
  }
  sortCaps(sorted);
  std::set<std::pair<const EdgeCap *, const EdgeCap *>> pairs;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    for (const CapRange &range : candidatesFor(sorted, i)) {
      for (std::size_t j = range.begin; j < range.end; ++j) {
        EXPECT_TRUE(pairs.insert(std::minmax(sorted[i], sorted[j])).second) << "only once";
      }
    }
  }
  std::size_t near = 0;
  for (std::size_t i = 0; i < caps.size(); ++i) {
    for (std::size_t j = i + 1; j < caps.size(); ++j) {
      if ((caps[i].tip - caps[j].tip).norm() < longestNarrow) {
        ++near;
        EXPECT_EQ(pairs.count(std::minmax<const EdgeCap *>(&caps[i], &caps[j])), 1U);
      }
    }
  }
  EXPECT_GT(near, 3000U);
  EXPECT_LT(pairs.size(), 6 * near) << "those far away are left out";
}

TEST(CapPairs, LookApartAlongTheLineBetweenThem)
{
  constexpr double mostAngle = 0.5548; // acos(0.85)
  Random random = randomOfTest();
  const auto randomCap = [&]() {
    EdgeCap cap;
    const double angle = uniform(random, -M_PI, M_PI);
    cap.tip = Eigen::Vector2d(uniform(random, 0., 40.), uniform(random, 0., 40.));
    cap.axis = Eigen::Vector2d(std::cos(angle), std::sin(angle));
    cap.isDark = uniform(random, 0., 1.) < 0.5;
    return cap;
  };
  unsigned int apart = 0;
  for (int i = 0; i < 20000; ++i) {
    const EdgeCap one = randomCap();
    const EdgeCap other = randomCap();
    const Eigen::Vector2d along = one.tip - other.tip;
    const auto angleTo = [](const Eigen::Vector2d &p, const Eigen::Vector2d &q) {
      return std::abs(std::atan2(p.x() * q.y() - p.y() * q.x(), p.dot(q)));
    };
    const double angle = std::max(angleTo(along, one.axis), angleTo(-along, other.axis));
    if (std::abs(angle - mostAngle) < 1e-3) {
      continue;
    }
    const bool isApart = one.isDark == other.isDark && angle < mostAngle && along.norm() >= 10.;
    EXPECT_EQ(lookApart(CapOutlook(one), CapOutlook(other)), isApart);
    apart += isApart ? 1 : 0;
  }
  EXPECT_GT(apart, 100U);
  EdgeCap near;
  EdgeCap far;
  near.axis = -Eigen::Vector2d::UnitX();
  far.axis = Eigen::Vector2d::UnitX();
  near.tip = Eigen::Vector2d::Zero();
  for (const double length : {9.9, 10.1, longestNarrow - 0.1, longestNarrow + 0.1}) {
    far.tip = Eigen::Vector2d(length, 0.);
    EXPECT_EQ(lookApart(CapOutlook(near), CapOutlook(far)), length > 10. && length < longestNarrow);
  }
}

TEST(CapPairs, LookApartInARowAsByTwos)
{
  Random random = randomOfTest();
  std::vector<EdgeCap> caps;
  CapOutlooks outlooks;
  for (int i = 0; i < 300; ++i) { // and some left over from rows of 64
    EdgeCap cap;
    const double angle = uniform(random, -M_PI, M_PI);
    cap.tip = Eigen::Vector2d(uniform(random, 0., 500.), uniform(random, 0., 500.));
    cap.axis = Eigen::Vector2d(std::cos(angle), std::sin(angle));
    cap.isDark = i % 2 == 0;
    caps.push_back(cap);
    outlooks.add(cap);
  }
  std::size_t found = 0;
  std::vector<std::size_t> apart;
  for (std::size_t one = 0; one < caps.size(); ++one) {
    std::vector<std::size_t> expected;
    for (std::size_t other = one + 1; other < caps.size(); ++other) {
      if (lookApart(CapOutlook(caps[one]), CapOutlook(caps[other]))) {
        expected.push_back(other);
      }
    }
    outlooks.findApart(one, one + 1, caps.size(), apart);
    EXPECT_EQ(apart, expected);
    found += apart.size();
  }
  EXPECT_GT(found, 100U);
}

TEST(CapPairs, WhatIsNoPair)
{
  const EllipseScene dark = {center, 30., 3.5, 0.4};
  EllipseScene bright = dark;
  std::swap(bright.inside, bright.outside);
  const Capped one(dark);
  ASSERT_EQ(one.caps.size(), 2U);
  EdgeCap first = one.caps[0];
  EdgeCap second = one.caps[1];
  EXPECT_TRUE(mayBeEnds(one.edges, first, second));
  EXPECT_TRUE(mayBeEnds(one.edges, second, first));
  EXPECT_FALSE(mayBeEnds(one.edges, first, first));

  EdgeCap other = second;
  other.isDark = false;
  EXPECT_FALSE(mayBeEnds(one.edges, first, other)) << "one end dark and one bright";
  other = second;
  other.axis = first.axis;
  EXPECT_FALSE(mayBeEnds(one.edges, first, other)) << "both look the same way";
  other = second;
  other.axis = Eigen::Vector2d(-second.axis.y(), second.axis.x());
  EXPECT_FALSE(mayBeEnds(one.edges, first, other)) << "one looks aside";
  other = second;
  other.before = 5;
  other.after = 5;
  first.before = 5;
  first.after = 5;
  EXPECT_FALSE(mayBeEnds(one.edges, first, other)) << "most of the outline is missing";
  first = one.caps[0];
  other = second;
  other.isDark = false;
  first.isDark = false;
  EXPECT_FALSE(mayBeEnds(one.edges, first, other)) << "walked the wrong way round";
  first = one.caps[0];
  other = second;
  other.tip += 200. * second.axis;
  EXPECT_FALSE(mayBeEnds(one.edges, first, other)) << "too far away";
  EXPECT_TRUE(mayBeEnds(Capped(bright).edges, Capped(bright).caps[0], Capped(bright).caps[1]));
}
