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
 * Test of where the edge of a shadow on a marker is looked for.
 */

#include "refine/shadow.h"

#include <gtest/gtest.h>

#include "testRoomTools.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr unsigned int side = 160;

//! A marker with light that changes over the image: share(u, v) of it.
template <class Share> vpImage<unsigned char> lit(const MarkerScene &scene, const Share &share, Random &random)
{
  const auto product = [&](double u, double v) { return scene(u, v) * share(u, v); };
  return digitise(expose(side, side, 0.7, product), 2., random);
}

std::optional<Shadow> seek(const vpImage<unsigned char> &I, const MarkerScene &scene)
{
  return shadowOn(I, CameraModel(scene.camera()), scene.frame(), scene.plane(), scene.family.getLayout().quietZone);
}
} // namespace

TEST(Shadow, ItsEdgeIsFound)
{
  Random random = randomOfTest();
  for (int i = 0; i < 30; ++i) {
    const MarkerScene scene = markerScene(random, vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23), 5, 100.,
                                          uniform(random, 0., 0.7), side);
    const ImageFrame frame = scene.frame();
    const double direction = uniform(random, -M_PI, M_PI);
    const double edge = uniform(random, -0.4, 0.4);
    const double factor = uniform(random, 0.3, 0.6);
    const auto share = [&](double u, double v) {
      const double beyond = (u - frame.center.x()) * std::cos(direction) + (v - frame.center.y()) * std::sin(direction);
      return beyond > edge * frame.size ? factor : 1.;
    };
    const auto shadow = seek(lit(scene, share, random), scene);
    ASSERT_TRUE(shadow) << "factor " << factor << " edge " << edge;
    EXPECT_NEAR(shadow->factor, factor, 0.05);
    EXPECT_NEAR(wrapped(shadow->direction - direction), 0., 0.15) << "edge " << edge;
    EXPECT_NEAR(shadow->edge, edge, 0.1);
  }
}

// A start without any light in the shadow has equations of which some derivatives are not numbers.
TEST(Shadow, ItLeavesSomeLight)
{
  Random random = randomOfTest();
  int seen = 0;
  for (int i = 0; i < 60; ++i) {
    const MarkerScene scene = markerScene(random, vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23), 5, 100.,
                                          uniform(random, 0., 0.5), side);
    const ImageFrame frame = scene.frame();
    const double edge = uniform(random, -0.4, 0.4);
    const auto share = [&](double u, double) { return u - frame.center.x() > edge * frame.size ? 0. : 1.; };
    if (const auto shadow = seek(lit(scene, share, random), scene)) {
      EXPECT_GE(shadow->factor, leastLightInShadow);
      ++seen;
    }
  }
  EXPECT_GT(seen, 30);
}

TEST(Shadow, NoneInEvenLightOrAGradient)
{
  Random random = randomOfTest();
  for (int i = 0; i < 20; ++i) {
    const MarkerScene scene = markerScene(random, vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23), 5,
                                          uniform(random, 40., 100.), uniform(random, 0., 0.7), side);
    const ImageFrame frame = scene.frame();
    const double slope = i % 2 == 0 ? 0. : 0.4; // of the light over a radius
    const auto share = [&](double u, double) { return 1. - slope * (u - frame.center.x()) / frame.size * 0.8; };
    EXPECT_FALSE(seek(lit(scene, share, random), scene)) << "slope " << slope;
  }
}

TEST(Shadow, NoneWhereTheQuietZoneIsNotInTheImage)
{
  Random random = randomOfTest();
  MarkerScene scene = markerScene(random, vpCircleMarkerFamily(vpCircleMarkerFamily::RING), -1, 100., 0.3, side);
  scene.center.x() += scene.radius;
  EXPECT_FALSE(seek(lit(
                        scene, [](double u, double) { return u < 100. ? 0.5 : 1.; }, random),
                    scene));
}
