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
 * Sub-pixel places of edges.
 */

#include "testRoomTools.h"

#include "edges/edge_points.h"

using namespace circle_marker;
using namespace room_test;

namespace {
//! A straight edge, bright where the distance along the normal is positive.
struct StraightEdge
{
  double angle;
  double offset;
  double centre = 32.;

  Eigen::Vector2d normal() const { return Eigen::Vector2d(std::cos(angle), std::sin(angle)); }
  double distance(const Eigen::Vector2d &p) const { return normal().dot(p - Eigen::Vector2d(centre, centre)) - offset; }
  double operator()(double u, double v) const { return distance(Eigen::Vector2d(u, v)) > 0. ? paper : ink; }
};

Gradient gradientOf(const vpImage<unsigned char> &I)
{
  Gradient gradient;
  computeGradient(I, gradient);
  return gradient;
}
} // namespace

TEST(EdgePoints, StraightEdgesHaveNoBias)
{
  Random random = randomOfTest();
  for (int i = 0; i < 180; ++i) {
    const StraightEdge edge = {2. * M_PI * i / 180., uniform(random, -3., 3.)};
    const double blur = uniform(random, 0.5, 1.5);
    const Gradient gradient = gradientOf(photograph(64, 64, blur, edge));
    double sum = 0.;
    double squares = 0.;
    double worstNormal = 1.;
    int count = 0;
    for (int t = -22; t <= 22; ++t) {
      const Eigen::Vector2d on = Eigen::Vector2d(32., 32.) + edge.offset * edge.normal() +
                                 t * Eigen::Vector2d(-edge.normal().y(), edge.normal().x());
      const auto point =
          locateEdge(gradient, static_cast<int>(std::lround(on.x())), static_cast<int>(std::lround(on.y())));
      ASSERT_TRUE(point) << "angle " << edge.angle << " blur " << blur;
      const double distance = edge.distance(point->position);
      sum += distance;
      squares += distance * distance;
      worstNormal = std::min(worstNormal, point->normal().dot(edge.normal()));
      EXPECT_NEAR(point->normal().norm(), 1., 1e-12);
      ++count;
    }
    EXPECT_LT(std::fabs(sum / count), 0.05) << "angle " << edge.angle << " blur " << blur << " offset " << edge.offset;
    // A single point: the parabola is no Gaussian, which costs a little more.
    EXPECT_LT(std::sqrt(squares / count), 0.1) << "angle " << edge.angle << " blur " << blur;
    EXPECT_GT(worstNormal, std::cos(3. * M_PI / 180.)) << "angle " << edge.angle << " blur " << blur;
  }
}

TEST(EdgePoints, OnePixelAwayFindsTheSameEdge)
{
  Random random = randomOfTest();
  int looked = 0;
  for (int i = 0; i < 60; ++i) {
    const StraightEdge edge = {uniform(random, 0., 2. * M_PI), uniform(random, -3., 3.)};
    const Gradient gradient = gradientOf(photograph(64, 64, 0.8, edge));
    const Eigen::Vector2d on = Eigen::Vector2d(32., 32.) + edge.offset * edge.normal();
    const bool horizontal = std::fabs(edge.normal().x()) >= std::fabs(edge.normal().y());
    for (int side = -1; side <= 1; ++side) {
      const int x = static_cast<int>(std::lround(on.x())) + (horizontal ? side : 0);
      const int y = static_cast<int>(std::lround(on.y())) + (horizontal ? 0 : side);
      // Along the axis that crosses the edge: a pixel and the half that the parabola bridges, less some margin.
      const double away =
          edge.distance(Eigen::Vector2d(x, y)) / std::max(std::fabs(edge.normal().x()), std::fabs(edge.normal().y()));
      if (std::fabs(away) > 1.3) {
        continue;
      }
      ++looked;
      const auto point = locateEdge(gradient, x, y);
      ASSERT_TRUE(point) << "angle " << edge.angle << " side " << side;
      EXPECT_LT(std::fabs(edge.distance(point->position)), 0.15);
    }
  }
  EXPECT_GT(looked, 100);
}

TEST(EdgePoints, FlatAreasHaveNone)
{
  const Gradient gradient = gradientOf(vpImage<unsigned char>(40, 40, 100));
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 40; ++x) {
      EXPECT_FALSE(locateEdge(gradient, x, y));
      EXPECT_FALSE(searchEdge(gradient, Eigen::Vector2d(x, y), Eigen::Vector2d(0.6, 0.8), 5.));
    }
  }
}

TEST(EdgePoints, SearchFindsWhatIsInReach)
{
  Random random = randomOfTest();
  int found = 0;
  for (int i = 0; i < 300; ++i) {
    const StraightEdge edge = {uniform(random, 0., 2. * M_PI), uniform(random, -3., 3.)};
    static Gradient gradient;
    computeGradient(photograph(64, 64, 0.7, edge), gradient);
    // Looked for along a direction that is up to 40 degrees off the normal.
    const double off = uniform(random, -0.7, 0.7);
    const Eigen::Vector2d direction(std::cos(edge.angle + off), std::sin(edge.angle + off));
    const Eigen::Vector2d on = Eigen::Vector2d(32., 32.) + edge.offset * edge.normal();
    const double away = uniform(random, -4., 4.);
    const auto point = searchEdge(gradient, on + away * direction, direction, 4.);
    ASSERT_TRUE(point) << "angle " << edge.angle << " off " << off << " away " << away;
    EXPECT_LT(std::fabs(edge.distance(point->position)), 0.15);
    ++found;
    // The wrong side bright, across, and out of reach: nothing.
    EXPECT_FALSE(searchEdge(gradient, on, -direction, 4.));
    const Eigen::Vector2d along(-edge.normal().y(), edge.normal().x());
    EXPECT_FALSE(searchEdge(gradient, on, along, 4.));
    EXPECT_FALSE(searchEdge(gradient, on + 9. * direction, direction, 3.));
  }
  EXPECT_EQ(found, 300);
}

TEST(EdgePoints, SearchTakesTheStrongerEdge)
{
  // Two edges of the same polarity, 6 pixels apart: 40 and 100 grey levels.
  const Gradient gradient =
      gradientOf(photograph(64, 64, 0.7, [](double u, double) { return u < 29.3 ? 60. : (u < 35.3 ? 100. : 200.); }));
  const auto point = searchEdge(gradient, Eigen::Vector2d(32., 32.), Eigen::Vector2d(1., 0.), 5.);
  ASSERT_TRUE(point);
  EXPECT_NEAR(point->position.x(), 35.3, 0.1);
}

TEST(EdgePoints, ImageBorderIsSafe)
{
  // Edges everywhere, so that nothing is left out for want of one.
  Random random = randomOfTest();
  vpImage<unsigned char> I(24, 31);
  for (unsigned int i = 0; i < I.getSize(); ++i) {
    I.bitmap[i] = static_cast<unsigned char>(random() % 256);
  }
  Gradient gradient = gradientOf(I);
  gradient.continueAbove = 1;
  int inside = 0;
  for (int y = -5; y < 29; ++y) {
    for (int x = -5; x < 36; ++x) {
      if (x < 0 || y < 0 || x >= 31 || y >= 24) {
        EXPECT_FALSE(locateEdge(gradient, x, y)) << x << ", " << y;
      }
      else if (const auto point = locateEdge(gradient, x, y)) {
        // What is found lies in the image, off the pixels whose gradient knows only half of their surroundings.
        EXPECT_GE(point->position.minCoeff(), 1.);
        EXPECT_LE(point->position.x(), 29.);
        EXPECT_LE(point->position.y(), 22.);
        ++inside;
      }
      const double angle = uniform(random, 0., 2. * M_PI);
      const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
      searchEdge(gradient, Eigen::Vector2d(x + uniform(random, -0.5, 0.5), y), direction, 12.);
    }
  }
  EXPECT_GT(inside, 100);
  EXPECT_FALSE(searchEdge(gradient, Eigen::Vector2d(-1e5, 1e5), Eigen::Vector2d(1., 0.), 5.));
}

TEST(EdgePoints, ThinLineHasBothItsEdges)
{
  // A dark line of 2 pixels: each side is found as its own edge, with opposite normals.
  const Gradient gradient =
      gradientOf(photograph(64, 64, 0.7, [](double u, double) { return std::fabs(u - 32.2) < 1. ? ink : paper; }));
  const auto left = searchEdge(gradient, Eigen::Vector2d(32.2, 32.), Eigen::Vector2d(-1., 0.), 3.);
  const auto right = searchEdge(gradient, Eigen::Vector2d(32.2, 32.), Eigen::Vector2d(1., 0.), 3.);
  ASSERT_TRUE(left && right);
  // The two blurred edges push each other apart by a few tenths of a pixel: a property of the image.
  EXPECT_NEAR(left->position.x(), 31.2, 0.4);
  EXPECT_NEAR(right->position.x(), 33.2, 0.4);
  EXPECT_LT(left->normal().x(), -0.99);
  EXPECT_GT(right->normal().x(), 0.99);
}

// The normal is that of the ridge, which may be a pixel beside where it is looked for: there, on a small circle, the
// gradient has another direction.
TEST(EdgePoints, NormalsOfSmallCirclesPointOutward)
{
  constexpr double lookedAt = 1.2; // pixels from the edge
  const Eigen::Vector2d center(50.3, 49.8);
  int looked = 0;
  for (double radius = 4.; radius < 9.; radius += 0.37) {
    const EllipseScene disc = {center, radius, radius, 0.};
    const Gradient gradient = gradientOf(photograph(100, 100, 0.7, disc));
    for (int y = 35; y < 65; ++y) {
      for (int x = 35; x < 65; ++x) {
        if (std::fabs((Eigen::Vector2d(x, y) - center).norm() - radius) > lookedAt) {
          continue;
        }
        if (const auto point = locateEdge(gradient, x, y)) {
          ++looked;
          EXPECT_GT(point->normal().dot((point->position - center).normalized()), std::cos(0.2))
              << "radius " << radius << " at " << x << ", " << y;
        }
      }
    }
  }
  EXPECT_GT(looked, 500);
}
