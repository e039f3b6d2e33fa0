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
 * Tests of the shape by which markers without a code are told.
 */

#include "decode/shape_evidence.h"

#include <gtest/gtest.h>

#include "testRoomTools.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr unsigned int side = 160;

bool isShaped(const vpImage<unsigned char> &I, const MarkerScene &scene)
{
  const vpCircleMarkerLayout &layout = scene.family.getLayout();
  return hasShapeAllAround(I, CameraModel(scene.camera()), scene.plane(), layout, layout.ringInner);
}

MarkerScene plain(Random &random, vpCircleMarkerFamily::vpType type, double diameter, double tilt)
{
  return markerScene(random, vpCircleMarkerFamily(type), -1, diameter, tilt, side);
}
} // namespace

// Where the ellipse is narrow its edges are a few pixels apart, and slant across the directions from the centre.
TEST(ShapeEvidence, SmallTiltedRingsHaveIt)
{
  Random random = randomOfTest();
  for (int i = 0; i < 60; ++i) {
    const double tilt = uniform(random, 0., 1.3);
    const double minor = uniform(random, 8.5, 12.);
    const MarkerScene scene = plain(random, vpCircleMarkerFamily::RING, minor / std::cos(tilt), tilt);
    EXPECT_TRUE(isShaped(digitise(expose(side, side, 0.7, scene), 2., random), scene))
        << "minor axis " << minor << " tilt " << tilt;
  }
}

// A tenth of the light is left on one side.
TEST(ShapeEvidence, AnEvenFallOffOfLightDoesNotHideIt)
{
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::RING, vpCircleMarkerFamily::DISC}) {
    for (int i = 0; i < 20; ++i) {
      const MarkerScene scene = plain(random, type, uniform(random, 40., 100.), uniform(random, 0., 0.8));
      const ImageFrame frame = scene.frame();
      const double direction = uniform(random, -M_PI, M_PI);
      const auto lit = [&](double u, double v) {
        const double way =
            ((u - frame.center.x()) * std::cos(direction) + (v - frame.center.y()) * std::sin(direction)) /
            (scene.sheet * frame.size); // from -1 to 1 over the marker
        return scene(u, v) * std::max(0.55 - 0.45 * way, 0.02);
      };
      EXPECT_TRUE(isShaped(digitise(expose(side, side, 0.7, lit), 2., random), scene)) << "direction " << direction;
    }
  }
}

// The leg of a letter beside a ring, or a gap in it, takes a tenth of all directions.
TEST(ShapeEvidence, LettersAndBrokenRingsDoNotHaveIt)
{
  Random random = randomOfTest();
  constexpr double share = 0.1;
  for (int i = 0; i < 40; ++i) {
    const MarkerScene scene =
        plain(random, vpCircleMarkerFamily::RING, uniform(random, 25., 100.), uniform(random, 0., 0.6));
    const double direction = uniform(random, -M_PI, M_PI);
    const bool isGap = i % 2 == 0;
    const auto letter = [&](double u, double v) {
      const Eigen::Vector2d q = scene.onMarker(u, v);
      const double off = std::remainder(std::atan2(q.y(), q.x()) - direction, 2. * M_PI);
      const bool isThere = std::abs(off) < share * M_PI && q.norm() > scene.family.getLayout().ringInner;
      return isThere && (isGap || q.norm() < 1.6) ? (isGap ? scene.white : scene.black) : scene(u, v);
    };
    EXPECT_FALSE(isShaped(digitise(expose(side, side, 0.7, letter), 2., random), scene))
        << (isGap ? "gap" : "leg") << " at " << direction;
  }
}

// Their outlines are found too far out, by a part of a pixel.
TEST(ShapeEvidence, SmallCodedMarkersShowADarkRing)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  int shown = 0; // it is a first look, which misses some
  for (int i = 0; i < 60; ++i) {
    const double tilt = uniform(random, 0., 1.);
    const double minor = uniform(random, 8.5, 14.);
    const int id = static_cast<int>(random() % family.getNbIds());
    const MarkerScene scene = markerScene(random, family, id, minor / std::cos(tilt), tilt, side);
    MarkerPlane found = scene.plane();
    found.radius *= 1. + 0.6 / minor;
    shown += hasDarkRing(digitise(expose(side, side, 0.7, scene), 2., random), CameraModel(scene.camera()), found);
  }
  EXPECT_GE(shown, 56);
}

// A quarter of the ring is missing, of small ones or of large ones.
TEST(ShapeEvidence, BrokenRingsAreNoDarkRings)
{
  Random random = randomOfTest();
  for (int i = 0; i < 16; ++i) {
    const bool isSlanted = i % 2 == 0;
    const unsigned int width = isSlanted ? 440 : side;
    const MarkerScene scene =
        isSlanted ? markerScene(random, vpCircleMarkerFamily::RING, -1, uniform(random, 300., 400.), 1.48, width)
                  : plain(random, vpCircleMarkerFamily::RING, uniform(random, 12., 30.), uniform(random, 0., 0.6));
    const double direction = uniform(random, -M_PI, M_PI);
    const auto broken = [&](double u, double v) {
      const Eigen::Vector2d q = scene.onMarker(u, v);
      return std::abs(wrapped(std::atan2(q.y(), q.x()) - direction)) < 0.25 * M_PI ? scene.white : scene(u, v);
    };
    EXPECT_FALSE(hasDarkRing(digitise(expose(width, width, 0.7, broken), 2., random), CameraModel(scene.camera()),
                             scene.plane()))
        << (isSlanted ? "slanted, " : "small, ") << "gap at " << direction;
  }
}
