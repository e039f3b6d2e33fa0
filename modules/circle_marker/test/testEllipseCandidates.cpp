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
 * Ellipses among the edges of drawn images.
 */

#include "testRoomTools.h"

#include "ellipse/ellipse_candidates.h"

using namespace circle_marker;
using namespace room_test;

namespace {
std::vector<EllipseCandidate> ellipsesOf(const vpImage<unsigned char> &I, const SoughtCenters &sought = SoughtCenters())
{
  Gradient gradient;
  computeGradient(I, gradient);
  EdgeChains chains;
  linkEdgeChains(gradient, 14, chains);
  Workers workers;
  EllipseMemory memory;
  findEllipses(I, gradient, chains, sought, OtherScale(), workers, Deadline(), memory);
  std::vector<EllipseCandidate> found(memory.known.outlines.begin(), memory.known.outlines.end());
  std::sort(found.begin(), found.end(),
            [](const EllipseCandidate &p, const EllipseCandidate &q) { return p.ellipse.a > q.ellipse.a; });
  return found;
}

//! Largest error of centre and axes, pixels.
double errorOf(const EllipseParameters &found, const EllipseScene &truth)
{
  return std::max({(found.center - truth.center).norm(), std::fabs(found.a - truth.a), std::fabs(found.b - truth.b)});
}

//! The angle of the axes, where they differ enough to have one.
double angleErrorOf(const EllipseParameters &found, const EllipseScene &truth)
{
  return std::fabs(std::remainder(found.angle - truth.angle, M_PI));
}

EllipseScene randomEllipse(Random &random, double least, double most, double leastRatio, double side)
{
  const double a = uniform(random, least, most);
  return {Eigen::Vector2d(0.5 * side + uniform(random, -2., 2.), 0.5 * side + uniform(random, -2., 2.)), a,
          a * uniform(random, leastRatio, 1.), uniform(random, -M_PI_2, M_PI_2)};
}

/*!
  Where the middle of a blurred edge lies: inside the circle by half the curvature times the blur's variance, and
  the gradient's maximum again by as much (Sobel's own smoothing adds 1/2 and the pixel 1/12 to the variance).
*/
double shrinkage(double blur, double radius)
{
  return 1.0 * (blur * blur + 0.58) / radius;
}
} // namespace

TEST(EllipseCandidates, DiscsHaveOneEach)
{
  Random random = randomOfTest();
  for (int i = 0; i < 80; ++i) {
    const EllipseScene disc = randomEllipse(random, 10., 60., 0.45, 150.);
    const auto found = ellipsesOf(photograph(150, 150, 0.7, disc));
    ASSERT_EQ(found.size(), 1u) << "a " << disc.a << " b " << disc.b << " angle " << disc.angle;
    const double radius = disc.b * disc.b / disc.a; // the least radius of curvature
    EXPECT_LT(errorOf(found[0].ellipse, disc), 0.1 + shrinkage(0.7, radius)) << "a " << disc.a << " b " << disc.b;
    if (disc.b < 0.9 * disc.a) {
      EXPECT_LT(angleErrorOf(found[0].ellipse, disc), 0.1 / (disc.a - disc.b) + 0.002);
    }
    EXPECT_GT(found[0].support, 0.95);
    EXPECT_NEAR(found[0].contrast, paper - ink, 0.12 * (paper - ink));
    for (const EdgePoint &point : found[0].points) {
      EXPECT_LT(std::fabs(sampsonDistance(found[0].conic, point.position)), 0.5);
    }
  }
}

// Dots that are the ends of thin rings are few: of a patch of texture none is put together with the others.
TEST(EllipseCandidates, DotsOfATextureAreNoEnds)
{
  constexpr double pitch = 6.;
  const auto scene = [](double u, double v) {
    const bool isInPatch = u > 51. && u < 141. && v > 51. && v < 141.; // of 15 x 15 dots
    const bool isAlone = std::hypot(u - 300., v - 50.) < 1. || std::hypot(u - 320., v - 50.) < 1.;
    const bool isDot = std::hypot(std::remainder(u, pitch), std::remainder(v, pitch)) < 1.;
    return (isInPatch && isDot) || isAlone ? ink : paper;
  };
  const vpImage<unsigned char> I = photograph(400, 400, 0.7, scene);
  SoughtCenters sought;
  sought.thinRing = vpCircleMarkerFamily(vpCircleMarkerFamily::RING).getLayout().ringInner;
  Gradient gradient;
  computeGradient(I, gradient);
  EdgeChains chains;
  linkEdgeChains(gradient, 14, chains);
  Workers workers;
  EllipseMemory memory;
  findEllipses(I, gradient, chains, sought, OtherScale(), workers, Deadline(), memory);
  std::size_t seen = 0;
  for (const EllipseMemory::Workspace &workspace : memory.workspaces) {
    seen += workspace.dots.size();
  }
  EXPECT_EQ(seen, 15u * 15u + 2u);
  EXPECT_EQ(memory.dots.size(), 2u);
}

TEST(EllipseCandidates, AxesOfLargeDiscsToATenthOfAPixel)
{
  Random random = randomOfTest();
  for (int i = 0; i < 30; ++i) {
    const EllipseScene disc = randomEllipse(random, 35., 90., 0.7, 220.);
    const auto found = ellipsesOf(photograph(220, 220, 0.7, disc));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_LT(errorOf(found[0].ellipse, disc), 0.1) << "a " << disc.a << " b " << disc.b;
  }
}

TEST(EllipseCandidates, RingsHaveTheirOuterOutlineOnly)
{
  // The inner outline has its dark side outside: the outline of something bright.
  Random random = randomOfTest();
  for (int i = 0; i < 60; ++i) {
    EllipseScene ring = randomEllipse(random, 15., 60., 0.5, 150.);
    ring.inner = 0.8;
    const auto found = ellipsesOf(photograph(150, 150, 0.7, ring));
    ASSERT_EQ(found.size(), 1u) << "a " << ring.a << " b " << ring.b << " angle " << ring.angle;
    const double radius = ring.b * ring.b / ring.a;
    // A rim of few pixels loses some contrast and widens a little.
    EXPECT_LT(errorOf(found[0].ellipse, ring), 0.15 + shrinkage(0.7, radius)) << "a " << ring.a << " b " << ring.b;
  }
}

TEST(EllipseCandidates, ObliqueDiscsDownToEightyDegrees)
{
  Random random = randomOfTest();
  int missed = 0;
  for (int i = 0; i < 40; ++i) {
    EllipseScene disc = randomEllipse(random, 40., 65., 1., 150.);
    disc.b = disc.a * uniform(random, 0.174, 0.5);
    const auto found = ellipsesOf(photograph(150, 150, 0.7, disc));
    missed += found.size() != 1u;
    if (found.size() == 1u) {
      EXPECT_LT(std::fabs(found[0].ellipse.b - disc.b), 0.15) << "a " << disc.a << " b " << disc.b;
      // The tips of a narrow ellipse are rounded off by the blur.
      EXPECT_LT(std::fabs(found[0].ellipse.a - disc.a), 0.15 + shrinkage(0.7, disc.b * disc.b / disc.a));
      EXPECT_LT((found[0].ellipse.center - disc.center).norm(), 0.1);
    }
  }
  EXPECT_EQ(missed, 0);
}

TEST(EllipseCandidates, MostAreFoundWithAFifthCovered)
{
  Random random = randomOfTest();
  int foundInAll = 0;
  for (int i = 0; i < 60; ++i) {
    EllipseScene ring = randomEllipse(random, 25., 55., 0.6, 150.);
    ring.inner = i % 2 ? 0.8 : 0.;
    // A sheet of its own grey covers all that lies beyond a line: 20 % of the outline's parameter.
    const double direction = uniform(random, 0., 2. * M_PI);
    const Eigen::Vector2d toward(std::cos(direction), std::sin(direction));
    const double c = std::cos(ring.angle), s = std::sin(ring.angle);
    const double along =
        std::hypot(ring.a * (c * toward.x() + s * toward.y()), ring.b * (c * toward.y() - s * toward.x()));
    const double cover = uniform(random, 0., 255.);
    const auto found = ellipsesOf(photograph(150, 150, 0.7, [&](double u, double v) {
      return toward.dot(Eigen::Vector2d(u, v) - ring.center) > along * std::cos(0.2 * M_PI) ? cover : ring(u, v);
    }));
    double best = HUGE_VAL;
    for (const EllipseCandidate &candidate : found) {
      best = std::min(best, errorOf(candidate.ellipse, ring));
      EXPECT_GT(candidate.support, 0.5);
    }
    foundInAll += best < 1. ? 1 : 0;
  }
  // The chord of the cover is a part of the closed chain; where it cannot be trimmed the outline is lost.
  EXPECT_GE(foundInAll, 48);
}

// Three bars leave six arcs of a ring, each of which bends too little, or is too short, to tell the whole alone.
TEST(EllipseCandidates, MostAreFoundBehindThreeBars)
{
  Random random = randomOfTest();
  SoughtCenters rings;
  rings.dark = false; // the pieces are no discs then
  constexpr int count = 60;
  int found = 0;
  for (int i = 0; i < count; ++i) {
    EllipseScene ring = randomEllipse(random, 40., 60., 0.7, 160.);
    ring.inner = 0.8;
    const double first = uniform(random, 0., M_PI);
    const auto behindBars = [&](double u, double v) {
      for (int bar = 0; bar < 3; ++bar) {
        const double angle = first + M_PI / 3. * bar;
        const double across = std::cos(angle) * (u - ring.center.x()) + std::sin(angle) * (v - ring.center.y());
        if (std::fabs(across) < 5.) {
          return 110. + 30. * bar;
        }
      }
      return ring(u, v);
    };
    Random noise(random());
    const vpImage<unsigned char> I = digitise(expose(160, 160, 0.7, behindBars), 2., noise);
    for (const EllipseCandidate &candidate : ellipsesOf(I, rings)) {
      if (errorOf(candidate.ellipse, ring) < 1.) {
        ++found;
        break;
      }
    }
  }
  EXPECT_GE(found, 57); // 60 are; 34 by single arcs
}

// A dark blob covers the inside up to a part of the white gap between code and ring.
TEST(EllipseCandidates, RingsWithADarkMiddleAreFound)
{
  Random random = randomOfTest();
  SoughtCenters rings;
  rings.dark = false;
  for (int i = 0; i < 40; ++i) {
    EllipseScene ring = randomEllipse(random, 25., 60., 0.7, 160.);
    ring.inner = 0.8;
    EllipseScene blob = ring;
    blob.center += uniform(random, 0., 0.1) * ring.b * Eigen::Vector2d::UnitX();
    blob.a *= 0.55;
    blob.b *= 0.55;
    blob.inner = 0.;
    const auto covered = [&](double u, double v) { return blob(u, v) == ink ? ink : ring(u, v); };
    Random noise(random());
    const std::vector<EllipseCandidate> found = ellipsesOf(digitise(expose(160, 160, 0.7, covered), 2., noise), rings);
    ASSERT_FALSE(found.empty()) << "a " << ring.a << " b " << ring.b;
    EXPECT_LT(errorOf(found.front().ellipse, ring), 1.);
  }
}

TEST(EllipseCandidates, BrightDiscsAreNone)
{
  Random random = randomOfTest();
  for (int i = 0; i < 40; ++i) {
    EllipseScene disc = randomEllipse(random, 8., 60., 0.4, 150.);
    disc.inside = paper;
    disc.outside = ink;
    EXPECT_TRUE(ellipsesOf(photograph(150, 150, 0.7, disc)).empty()) << "a " << disc.a << " b " << disc.b;
  }
}

TEST(EllipseCandidates, OtherShapesAreNone)
{
  Random random = randomOfTest();
  for (int i = 0; i < 40; ++i) {
    const double angle = uniform(random, 0., M_PI);
    const double half = uniform(random, 15., 45.);
    const double ratio = uniform(random, 0.3, 1.);
    const auto square = [&](double u, double v) {
      const double x = std::cos(angle) * (u - 75.) + std::sin(angle) * (v - 75.);
      const double y = std::cos(angle) * (v - 75.) - std::sin(angle) * (u - 75.);
      return std::fabs(x) < half && std::fabs(y) < ratio * half ? ink : paper;
    };
    EXPECT_TRUE(ellipsesOf(photograph(150, 150, 0.7, square)).empty()) << "half " << half << " ratio " << ratio;
  }
  const auto halfPlane = [](double u, double v) { return u + 0.3 * v < 80. ? ink : paper; };
  EXPECT_TRUE(ellipsesOf(photograph(150, 150, 0.7, halfPlane)).empty());
  EXPECT_TRUE(ellipsesOf(vpImage<unsigned char>(150, 150, 90)).empty());
}

TEST(EllipseCandidates, SeveralDiscsLargestFirst)
{
  const EllipseScene discs[] = {{{60., 60.}, 25., 20., 0.3},
                                {{160., 60.}, 40., 30., 1.},
                                {{60., 160.}, 10., 10., 0.},
                                {{160., 160.}, 32., 31., -1.}};
  const auto found = ellipsesOf(photograph(220, 220, 0.7, [&](double u, double v) {
    double grey = paper;
    for (const EllipseScene &disc : discs) {
      grey = std::min(grey, disc(u, v));
    }
    return grey;
  }));
  ASSERT_EQ(found.size(), 4u);
  const std::size_t order[] = {1, 3, 0, 2};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_LT(errorOf(found[i].ellipse, discs[order[i]]), 0.25);
  }
}

TEST(EllipseCandidates, NoiseAddsNone)
{
  Random random = randomOfTest();
  for (int i = 0; i < 20; ++i) {
    const EllipseScene disc = randomEllipse(random, 15., 60., 0.6, 150.);
    const auto found = ellipsesOf(digitise(expose(150, 150, 0.7, disc), 8., random));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_LT(errorOf(found[0].ellipse, disc), 0.35) << "a " << disc.a << " b " << disc.b;
    EXPECT_TRUE(ellipsesOf(digitise(vpImage<double>(150, 150, 127.), 12., random)).empty());
  }
}

TEST(EllipseCandidates, CutByTheImageBorder)
{
  // Two fifths of the outline are outside of the image; the rest suffices.
  Random random = randomOfTest();
  for (int i = 0; i < 20; ++i) {
    EllipseScene disc = randomEllipse(random, 30., 50., 0.8, 120.);
    disc.center = Eigen::Vector2d(0.25 * disc.b, 60.);
    const auto found = ellipsesOf(photograph(120, 120, 0.7, disc));
    ASSERT_EQ(found.size(), 1u) << "a " << disc.a << " b " << disc.b << " angle " << disc.angle;
    EXPECT_LT(errorOf(found[0].ellipse, disc), 0.5);
    for (const EdgePoint &point : found[0].points) {
      EXPECT_GE(point.position.x(), 0.);
    }
  }
}

// From where it was in the image before to where it is, if it is not too far.
TEST(OutlineFitter, FollowsAnOutline)
{
  Random random = randomOfTest();
  OutlineFitter fitter;
  Gradient gradient;
  for (int i = 0; i < 60; ++i) {
    const EllipseScene disc = randomEllipse(random, 20., 60., 0.45, 150.);
    const vpImage<unsigned char> I = photograph(150, 150, 0.7, disc);
    computeGradient(I, gradient);
    const EllipseCandidate searched = ellipsesOf(I).at(0);
    const double azimuth = uniform(random, -M_PI, M_PI);
    EllipseParameters expected = searched.ellipse;
    expected.center += disc.b / 12. * Eigen::Vector2d(std::cos(azimuth), std::sin(azimuth));
    expected.angle += 0.03;
    EllipseCandidate followed;
    ASSERT_EQ(fitter.follow(I, gradient, expected, SoughtCenters(), followed), EllipseReject::NONE);
    EXPECT_LT(errorOf(followed.ellipse, {searched.ellipse.center, searched.ellipse.a, searched.ellipse.b, 0.}), 0.02);
    EXPECT_NEAR(followed.support, searched.support, 0.03);
    // Nothing is there.
    expected.center.x() += 1.2 * disc.a;
    EXPECT_NE(fitter.follow(I, gradient, expected, SoughtCenters(), followed), EllipseReject::NONE);
  }
}

TEST(OutlineFitter, AFollowedEdgeIsNoDarkLine)
{
  const EllipseScene disc = {Eigen::Vector2d(75., 75.), 40., 40., 0.};
  const vpImage<unsigned char> I = photograph(150, 150, 0.7, disc);
  Gradient gradient;
  computeGradient(I, gradient);
  EllipseParameters expected;
  expected.center = disc.center;
  expected.a = 40.3;
  expected.b = 39.8;
  OutlineFitter fitter;
  EllipseCandidate followed; // in memory of another one that was
  followed.isThin = true;
  ASSERT_EQ(fitter.follow(I, gradient, expected, SoughtCenters(), followed), EllipseReject::NONE);
  EXPECT_FALSE(followed.isThin);
}
