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
 * Tests of what is seen of a plain ring that something covers in part.
 */

#include "decode/covered_shape.h"

#include <gtest/gtest.h>

#include "testRoomTools.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr unsigned int side = 160;

MarkerScene plain(Random &random, vpCircleMarkerFamily::vpType type, int id = -1)
{
  return markerScene(random, vpCircleMarkerFamily(type), id, uniform(random, 40., 110.), uniform(random, 0., 0.9),
                     side);
}

std::optional<SeenParts> seenOf(const vpImage<unsigned char> &I, const MarkerScene &scene)
{
  return seenPartsOfRing(I, CameraModel(scene.camera()), scene.plane(),
                         vpCircleMarkerFamily(vpCircleMarkerFamily::RING).getLayout());
}

// A scene with a half plane of one grey level in front, from a line at a distance from the marker's centre, in outer
// radii, on.
template <typename Scene> auto behindEdge(const Scene &scene, double direction, double distance, double grey)
{
  const ImageFrame frame = scene.frame();
  return [&scene, frame, direction, distance, grey](double u, double v) {
    const double way =
        ((u - frame.center.x()) * std::cos(direction) + (v - frame.center.y()) * std::sin(direction)) / frame.size;
    return way > distance ? grey : scene(u, v);
  };
}

// A scene with two discs of one grey level, so far to either side of the marker's centre; in outer radii.
template <typename Scene> auto underDiscs(const Scene &scene, double radius, double aside, double grey)
{
  return [&scene, radius, aside, grey](double u, double v) {
    const Eigen::Vector2d place = scene.onMarker(u, v);
    const Eigen::Vector2d nearest(std::abs(place.x()) - aside, place.y());
    return nearest.norm() < radius ? grey : scene(u, v);
  };
}
} // namespace

TEST(CoveredShape, AWholeRingIsSeenAllAround)
{
  Random random = randomOfTest();
  for (int i = 0; i < 30; ++i) {
    const MarkerScene scene = plain(random, vpCircleMarkerFamily::RING);
    const auto seen = seenOf(digitise(expose(side, side, 0.7, scene), 2., random), scene);
    ASSERT_TRUE(seen) << i;
    EXPECT_GT(seen->shareOfRing(), 0.95);
  }
}

// Of a circle a line at half of its radius leaves two thirds, one at nine tenths all but a seventh; and what lies
// beside the line in the image is not seen.
TEST(CoveredShape, BehindAnEdgeItIsSeenOnOneSide)
{
  Random random = randomOfTest();
  for (int i = 0; i < 40; ++i) {
    const MarkerScene scene =
        markerScene(random, vpCircleMarkerFamily(vpCircleMarkerFamily::RING), -1, uniform(random, 60., 110.), 0., side);
    const double direction = uniform(random, -M_PI, M_PI);
    const double distance = i % 2 == 0 ? 0.5 : 0.9;
    const auto covered = behindEdge(scene, direction, distance, uniform(random, 20., 230.));
    const auto seen = seenOf(digitise(expose(side, side, 0.7, covered), 2., random), scene);
    ASSERT_TRUE(seen) << i;
    EXPECT_NEAR(seen->shareOfRing(), 1. - std::acos(distance) / M_PI, 0.1) << i;
    const Eigen::Vector2d toEdge(std::cos(direction), std::sin(direction));
    const CameraModel camera(scene.camera());
    EXPECT_FALSE(seen->holds(camera.toMeter(scene.frame().center + scene.frame().size * toEdge))) << i;
    EXPECT_TRUE(seen->holds(camera.toMeter(scene.frame().center - scene.frame().size * toEdge))) << i;
  }
}

TEST(CoveredShape, LessThanHalfIsNotEnough)
{
  Random random = randomOfTest();
  for (int i = 0; i < 20; ++i) {
    const MarkerScene scene = plain(random, vpCircleMarkerFamily::RING);
    const auto covered = behindEdge(scene, uniform(random, -M_PI, M_PI), -0.3, uniform(random, 20., 230.));
    EXPECT_FALSE(seenOf(digitise(expose(side, side, 0.7, covered), 2., random), scene)) << i;
  }
}

// The sectors of a code lie between white and white: nothing covers them.
TEST(CoveredShape, ACodedMarkerIsNoCoveredRing)
{
  Random random = randomOfTest();
  unsigned int seen = 0;
  constexpr unsigned int markers = 80;
  for (unsigned int i = 0; i < markers; ++i) {
    const auto type = i % 2 == 0 ? vpCircleMarkerFamily::GOLAY23 : vpCircleMarkerFamily::BCH31R;
    const MarkerScene scene = plain(random, type, static_cast<int>(random() % 66));
    seen += seenOf(digitise(expose(side, side, 0.7, scene), 2., random), scene) ? 1 : 0;
  }
  EXPECT_LE(seen, markers / 20);
}

// With something on its centre neither is a marker's print white there, but before its sectors it is.
TEST(CoveredShape, ACodedMarkerWithACoveredCentreIsNoCoveredRing)
{
  Random random = randomOfTest();
  unsigned int seen = 0;
  constexpr unsigned int markers = 80;
  for (unsigned int i = 0; i < markers; ++i) {
    const auto type = i % 2 == 0 ? vpCircleMarkerFamily::GOLAY23 : vpCircleMarkerFamily::BCH31R;
    const MarkerScene scene = plain(random, type, static_cast<int>(random() % 66));
    const auto covered = underDiscs(scene, 0.36, 0., 30.);
    seen += seenOf(digitise(expose(side, side, 0.7, covered), 2., random), scene) ? 1 : 0;
  }
  EXPECT_LE(seen, markers / 20);
}

// What lies in a plain ring without touching it is not taken for sectors: here in a third of all directions.
TEST(CoveredShape, SomethingInsideOfAPlainRingCoversIt)
{
  Random random = randomOfTest();
  for (int i = 0; i < 30; ++i) {
    const MarkerScene scene = plain(random, vpCircleMarkerFamily::RING);
    const auto covered = underDiscs(scene, 0.36, 0.3, uniform(random, 20., 60.));
    EXPECT_TRUE(seenOf(digitise(expose(side, side, 0.7, covered), 2., random), scene)) << i;
  }
}

TEST(CoveredShape, ADiscIsNoCoveredRing)
{
  Random random = randomOfTest();
  for (int i = 0; i < 20; ++i) {
    const MarkerScene scene = plain(random, vpCircleMarkerFamily::DISC);
    EXPECT_FALSE(seenOf(digitise(expose(side, side, 0.7, scene), 2., random), scene)) << i;
  }
}
