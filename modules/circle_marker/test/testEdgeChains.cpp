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
 * Linking of edge pixels into oriented chains.
 */

#include "testRoomTools.h"

#include <algorithm>
#include <set>

#include <opencv2/imgproc.hpp>

#include "edges/edge_points.h"
#include "segment/edge_chains.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr std::size_t shortest = 14;

struct Linked
{
  Gradient gradient;
  EdgeChains edges;

  explicit Linked(const vpImage<unsigned char> &I)
  {
    computeGradient(I, gradient);
    linkEdgeChains(gradient, shortest, edges);
  }

  double doubledAreaOf(const EdgeChain &chain) const
  {
    std::vector<EdgePoint> points;
    locateChain(gradient, edges, chain, points);
    std::vector<cv::Point2f> contour;
    for (const EdgePoint &point : points) {
      contour.emplace_back(static_cast<float>(point.position.x()), static_cast<float>(point.position.y()));
    }
    return 2. * cv::contourArea(contour, true);
  }
};

//! What holds for the chains of any image.
void expectSound(const Linked &linked, unsigned int width, unsigned int height)
{
  std::set<std::pair<int, int>> seen;
  std::size_t previousEnd = 0;
  for (const EdgeChain &chain : linked.edges.chains) {
    ASSERT_GE(chain.length(), shortest);
    ASSERT_GE(chain.begin, previousEnd) << "chains overlap";
    ASSERT_LE(chain.end, linked.edges.pixels.size());
    previousEnd = chain.end;
    for (std::size_t i = chain.begin; i < chain.end; ++i) {
      const EdgePixel pixel = linked.edges.pixels[i];
      ASSERT_TRUE(pixel.x >= 1 && pixel.y >= 1 && pixel.x < static_cast<int>(width) - 1 &&
                  pixel.y < static_cast<int>(height) - 1);
      ASSERT_TRUE(seen.insert({pixel.x, pixel.y}).second) << "pixel twice: " << pixel.x << ", " << pixel.y;
      if (i > chain.begin) {
        const EdgePixel before = linked.edges.pixels[i - 1];
        ASSERT_LE(std::max(std::abs(before.x - pixel.x), std::abs(before.y - pixel.y)), 1) << "a gap in a chain";
      }
    }
    std::vector<cv::Point> contour;
    for (std::size_t i = chain.begin; i < chain.end; ++i) {
      contour.emplace_back(linked.edges.pixels[i].x, linked.edges.pixels[i].y);
    }
    ASSERT_EQ(static_cast<double>(doubledArea(linked.edges, chain)), 2. * cv::contourArea(contour, true));
    if (chain.closed) {
      const EdgePixel first = linked.edges.pixels[chain.begin];
      const EdgePixel last = linked.edges.pixels[chain.end - 1];
      ASSERT_LE(std::max(std::abs(first.x - last.x), std::abs(first.y - last.y)), 2) << "closed, but open";
    }
  }
}
} // namespace

TEST(EdgeChains, DarkDiscIsOneClosedLoop)
{
  Random random = randomOfTest();
  for (int i = 0; i < 60; ++i) {
    const double a = uniform(random, 5., 45.);
    const double b = a * uniform(random, 0.6, 1.);
    const EllipseScene disc = {Eigen::Vector2d(60. + uniform(random, -1., 1.), 60. + uniform(random, -1., 1.)), a, b,
                               uniform(random, 0., M_PI)};
    const Linked linked(photograph(120, 120, 0.7, disc));
    expectSound(linked, 120, 120);
    ASSERT_EQ(linked.edges.chains.size(), 1u) << "a " << a << " b " << b << " angle " << disc.angle;
    const EdgeChain &chain = linked.edges.chains[0];
    EXPECT_TRUE(chain.closed);
    // Twice the area, positive for dark inside; the blurred edge of a circle lies inside of it by about blur^2 / 2b.
    EXPECT_NEAR(linked.doubledAreaOf(chain), 2. * M_PI * a * b, 0.02 * 2. * M_PI * a * b + 4. * (a + b) / b);
  }
}

TEST(EdgeChains, BrightDiscRunsTheOtherWay)
{
  Random random = randomOfTest();
  for (int i = 0; i < 20; ++i) {
    const double radius = uniform(random, 5., 40.);
    const EllipseScene disc = {
        Eigen::Vector2d(60., 60.), radius, 0.8 * radius, uniform(random, 0., M_PI), 0., paper, ink};
    const Linked linked(photograph(120, 120, 0.7, disc));
    ASSERT_EQ(linked.edges.chains.size(), 1u);
    EXPECT_TRUE(linked.edges.chains[0].closed);
    EXPECT_LT(linked.doubledAreaOf(linked.edges.chains[0]), -0.9 * 2. * M_PI * 0.8 * radius * radius);
  }
}

TEST(EdgeChains, ThinRingIsTwoLoops)
{
  Random random = randomOfTest();
  for (int i = 0; i < 40; ++i) {
    const double a = uniform(random, 12., 50.);
    const double b = a * uniform(random, 0.7, 1.);
    // From 2 to 4 pixels thick.
    const double inner = 1. - uniform(random, 2., 4.) / b;
    const EllipseScene ring = {Eigen::Vector2d(60. + uniform(random, -1., 1.), 60. + uniform(random, -1., 1.)), a, b,
                               uniform(random, 0., M_PI), inner};
    const Linked linked(photograph(120, 120, 0.7, ring));
    expectSound(linked, 120, 120);
    ASSERT_EQ(linked.edges.chains.size(), 2u) << "a " << a << " b " << b << " inner " << inner;
    double areas[2];
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_TRUE(linked.edges.chains[k].closed);
      areas[k] = linked.doubledAreaOf(linked.edges.chains[k]);
    }
    // The outer edge has dark inside, the inner one bright.
    EXPECT_GT(std::max(areas[0], areas[1]), 0.93 * 2. * M_PI * a * b);
    EXPECT_LT(std::min(areas[0], areas[1]), -0.85 * 2. * M_PI * a * b * inner * inner);
  }
}

TEST(EdgeChains, LassoGivesItsLoop)
{
  // A dark half plane reaches a dark disc through a bar: the walk comes in along the bar. What must be found is the
  // disc's outline but for the bar's root, whatever the direction the bar comes from.
  Random random = randomOfTest();
  for (int i = 0; i < 40; ++i) {
    const double radius = uniform(random, 12., 30.);
    const double angle = uniform(random, 0., 2. * M_PI);
    const double halfWidth = uniform(random, 1., 2.);
    const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
    const EllipseScene disc = {Eigen::Vector2d(60., 60.), radius, radius, 0.};
    const vpImage<unsigned char> I = photograph(120, 120, 0.7, [&](double u, double v) {
      const Eigen::Vector2d p(u - 60., v - 60.);
      // A bar of another grey than the disc's: the loop's own edge goes on across its root.
      const bool onBar = p.dot(along) > 0. && std::fabs(p.x() * along.y() - p.y() * along.x()) < halfWidth;
      const double grey = disc(u, v);
      return grey == paper && onBar ? 130. : grey;
    });
    const Linked linked(I);
    expectSound(linked, 120, 120);
    double best = 0.;
    for (const EdgeChain &chain : linked.edges.chains) {
      if (chain.closed) {
        best = std::max(best, linked.doubledAreaOf(chain));
      }
    }
    // The loop alone: with the bar it would hold more than the disc, without closing it would not be here.
    EXPECT_NEAR(best, 2. * M_PI * radius * radius, 0.05 * 2. * M_PI * radius * radius)
        << "radius " << radius << " angle " << angle << " half-width " << halfWidth;
  }
}

TEST(EdgeChains, NoiseAndCheckerboardsEnd)
{
  Random random = randomOfTest();
  std::uniform_int_distribution<int> grey(0, 255);
  for (int i = 0; i < 30; ++i) {
    const unsigned int width = 16 + static_cast<unsigned int>(random() % 100);
    const unsigned int height = 16 + static_cast<unsigned int>(random() % 100);
    vpImage<unsigned char> I(height, width);
    const unsigned int cell = 1 + static_cast<unsigned int>(i) / 3;
    for (unsigned int v = 0; v < height; ++v) {
      for (unsigned int u = 0; u < width; ++u) {
        const bool black = ((u / cell) + (v / cell)) % 2;
        switch (i % 3) {
        case 0:
          I[v][u] = static_cast<unsigned char>(grey(random));
          break;
        case 1:
          I[v][u] = black ? 0 : 255;
          break;
        default:
          I[v][u] = static_cast<unsigned char>(black ? grey(random) / 4 : 255 - grey(random) / 4);
        }
      }
    }
    // A threshold that lets noise through: the worst for the walk.
    Gradient gradient;
    computeGradient(I, gradient);
    gradient.startAt = 30;
    gradient.continueAbove = 1;
    Linked linked(I);
    linkEdgeChains(gradient, shortest, linked.edges);
    expectSound(linked, width, height);
  }
}

TEST(EdgeChains, MemoryOfAnEarlierImageIsForgotten)
{
  const EllipseScene disc = {Eigen::Vector2d(60., 60.), 30., 30., 0.};
  const Linked fresh(photograph(120, 120, 0.7, disc));
  Linked used(vpImage<unsigned char>(200, 300, 0));
  const EllipseScene large = {Eigen::Vector2d(100., 100.), 80., 60., 0.3};
  computeGradient(photograph(200, 210, 0.7, large), used.gradient);
  linkEdgeChains(used.gradient, shortest, used.edges);
  computeGradient(photograph(120, 120, 0.7, disc), used.gradient);
  linkEdgeChains(used.gradient, shortest, used.edges);
  ASSERT_EQ(used.edges.chains.size(), fresh.edges.chains.size());
  ASSERT_EQ(used.edges.pixels.size(), fresh.edges.pixels.size());
  for (std::size_t i = 0; i < fresh.edges.pixels.size(); ++i) {
    EXPECT_EQ(used.edges.pixels[i].x, fresh.edges.pixels[i].x);
    EXPECT_EQ(used.edges.pixels[i].y, fresh.edges.pixels[i].y);
  }
}

TEST(EdgeChains, ShortChainsAreDropped)
{
  const EllipseScene disc = {Eigen::Vector2d(30., 30.), 6., 6., 0.};
  Linked linked(photograph(60, 60, 0.7, disc));
  ASSERT_EQ(linked.edges.chains.size(), 1u);
  const std::size_t length = linked.edges.chains[0].length();
  linkEdgeChains(linked.gradient, length, linked.edges);
  EXPECT_EQ(linked.edges.chains.size(), 1u);
  linkEdgeChains(linked.gradient, length + 1, linked.edges);
  EXPECT_TRUE(linked.edges.chains.empty());
  EXPECT_TRUE(linked.edges.pixels.empty());
}

// A flat row across the edge ends the walk on either side of it, a pixel or two short of having come around.
TEST(EdgeChains, ALoopWithAGapOfAPixelIsClosed)
{
  constexpr int reachOfEdge = 3; // pixels from its middle to either side
  int loops = 0;
  for (double radius = 8.; radius < 40.; radius += 0.7) {
    const EllipseScene disc = {Eigen::Vector2d(50.3, 49.8), radius, radius, 0.};
    Linked linked(photograph(100, 100, 0.7, disc));
    const int column = static_cast<int>(disc.center.x() + radius);
    for (int x = column - reachOfEdge; x <= column + reachOfEdge; ++x) {
      linked.gradient.vectors[linked.gradient.index(x, 50)] = {0, 0};
    }
    linkEdgeChains(linked.gradient, shortest, linked.edges);
    for (const EdgeChain &chain : linked.edges.chains) {
      if (static_cast<double>(chain.length()) > 4. * radius) {
        ++loops;
        EXPECT_TRUE(chain.closed) << "radius " << radius;
      }
    }
  }
  EXPECT_GT(loops, 40);
}
