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
 * Tests of what tells small codes from small rings and pieces of them: opposite pixels.
 */

#include "testRoomTools.h"

#include "decode/code_asymmetry.h"

#include <gtest/gtest.h>

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr unsigned int side = 60; // pixels
constexpr double noise = 2.;      // grey levels

//! The outline as it is found: some tenths of a pixel beside what it is.
EllipseParameters outlineNear(Random &random, const Eigen::Vector2d &center, double a, double b, double angle)
{
  EllipseParameters outline;
  outline.center = center + Eigen::Vector2d(uniform(random, -0.2, 0.2), uniform(random, -0.2, 0.2));
  outline.a = a + uniform(random, -0.2, 0.3);
  outline.b = b + uniform(random, -0.2, 0.3);
  outline.angle = angle;
  return outline;
}

//! The same for a marker: its conic is that of the scene's circle.
EllipseParameters outlineOf(Random &random, const MarkerScene &scene)
{
  const double tilt = std::acos(scene.rotation(2, 2));
  const double a = scene.frame().size;
  // In the image the normal's direction is that of the minor axis: the view is nearly along the optical axis.
  const double across = std::atan2(scene.rotation(1, 2), scene.rotation(0, 2));
  return outlineNear(random, scene.frame().center, a, a * std::cos(tilt), across + M_PI_2);
}

template <class Scene> vpImage<unsigned char> noisyPhotograph(Random &random, const Scene &scene)
{
  return digitise(expose(side, side, 0.7, scene), noise, random);
}
} // namespace

TEST(CodeAsymmetry, SmallMarkersHaveIt)
{
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31, vpCircleMarkerFamily::BCH31R}) {
    const vpCircleMarkerFamily family(type);
    for (int i = 0; i < 25; ++i) {
      const int id = static_cast<int>(random() % family.getNbIds());
      MarkerScene scene = markerScene(random, family, id, uniform(random, 10., 20.), uniform(random, 0., 1.), side);
      scene.sheet = 2.;
      EXPECT_TRUE(isAsymmetricAsCode(noisyPhotograph(random, scene), outlineOf(random, scene), noise))
          << family.getName() << " " << id;
    }
  }
}

// Whether what a ring surrounds is as bright as what surrounds it does not matter. Of sharp thin rings that lie a
// quarter of a pixel beside the places of pixels the gradients do not explain all.
TEST(CodeAsymmetry, RingsAndDiscsHaveNone)
{
  Random random = randomOfTest();
  int count = 0;
  for (int i = 0; i < 75; ++i) {
    const double a = uniform(random, 5., 10.);
    EllipseScene scene = {Eigen::Vector2d(0.5 * side + uniform(random, -0.5, 0.5), 0.5 * side), a,
                          uniform(random, 0.5, 1.) * a, uniform(random, -1.5, 1.5)};
    scene.inner = i % 3 == 0 ? 0. : uniform(random, 0.5, 0.8);
    const EllipseScene hole = {scene.center, scene.inner * scene.a, scene.inner * scene.b, scene.angle, 0., 130., 0.};
    const bool isGrey = i % 3 == 2;
    const auto both = [&](double u, double v) { return isGrey && hole(u, v) > 0. ? hole(u, v) : scene(u, v); };
    const EllipseParameters outline = outlineNear(random, scene.center, scene.a, scene.b, scene.angle);
    count += isAsymmetricAsCode(noisyPhotograph(random, both), outline, noise) ? 1 : 0;
  }
  EXPECT_LE(count, 4);
}

// Half a ring is where something covers the rest: it differs in opposite directions as a whole.
TEST(CodeAsymmetry, HalvesOfRingsHaveTooMuch)
{
  Random random = randomOfTest();
  for (int i = 0; i < 20; ++i) {
    const EllipseScene ring = {Eigen::Vector2d(0.5 * side, 0.5 * side), 8., 7., 0.3, 0.6};
    const double direction = uniform(random, -M_PI, M_PI);
    const auto half = [&](double u, double v) {
      const double off = (u - ring.center.x()) * std::cos(direction) + (v - ring.center.y()) * std::sin(direction);
      return off > 0. ? paper : ring(u, v);
    };
    EXPECT_FALSE(
        isAsymmetricAsCode(noisyPhotograph(random, half), outlineNear(random, ring.center, 8., 7., 0.3), noise));
  }
}

// Half a light over the marker makes opposite pixels differ, and means nothing.
TEST(CodeAsymmetry, AGradientOfLightIsNone)
{
  Random random = randomOfTest();
  for (int i = 0; i < 20; ++i) {
    const EllipseScene disc = {Eigen::Vector2d(0.5 * side, 0.5 * side), 8., 7., 0.3, 0., 100., 200.};
    const auto lit = [&](double u, double v) { return disc(u, v) + 2. * (u - disc.center.x()); };
    EXPECT_FALSE(
        isAsymmetricAsCode(noisyPhotograph(random, lit), outlineNear(random, disc.center, 8., 7., 0.3), noise));
  }
}

// What lies at the image's border has few opposite pixels, or none.
TEST(CodeAsymmetry, NothingIsSeenOutside)
{
  const vpImage<unsigned char> I(side, side, 128);
  EllipseParameters outline;
  outline.center = Eigen::Vector2d(-3., 70.);
  outline.a = 6.;
  outline.b = 5.;
  outline.angle = 0.;
  EXPECT_FALSE(isAsymmetricAsCode(I, outline, noise));
  outline.center = Eigen::Vector2d(30., 30.); // and where all is grey
  EXPECT_FALSE(isAsymmetricAsCode(I, outline, noise));
}
