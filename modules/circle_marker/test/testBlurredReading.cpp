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
 * Tests of reading codes through a blur.
 */

#include "testRoomTools.h"

#include "decode/blurred_reading.h"

#include <array>

#include <gtest/gtest.h>

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr unsigned int side = 200; // pixels
constexpr double lens = 0.7;       // blur, pixels

//! What is out of focus: the image of a point is a disc of a radius in pixels.
vpImage<double> defocused(const vpImage<double> &sharp, int radius)
{
  vpImage<double> I(sharp.getHeight(), sharp.getWidth(), 0.);
  const int width = static_cast<int>(sharp.getWidth());
  const int height = static_cast<int>(sharp.getHeight());
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      double sum = 0.;
      double count = 0.;
      for (int y = -radius; y <= radius; ++y) {
        for (int x = -radius; x <= radius; ++x) {
          if (x * x + y * y <= radius * radius) {
            sum += sharp[static_cast<unsigned int>(std::clamp(v + y, 0, height - 1))]
                        [static_cast<unsigned int>(std::clamp(u + x, 0, width - 1))];
            count += 1.;
          }
        }
      }
      I[static_cast<unsigned int>(v)][static_cast<unsigned int>(u)] = sum / count;
    }
  }
  return I;
}

constexpr double diameter = 80.; // pixels
constexpr double leastMargin = 0.5;

MarkerScene sceneOf(Random &random, const vpCircleMarkerFamily &family)
{
  MarkerScene scene = markerScene(random, family, static_cast<int>(random() % family.getNbIds()), diameter, 0.2, side);
  scene.sheet = 2.;
  return scene;
}

//! The outline through a motion along u, longer at both ends; nearly a circle without.
EllipseParameters outlineOf(const MarkerScene &scene, double way)
{
  EllipseParameters outline;
  outline.center = scene.frame().center;
  outline.a = 0.5 * diameter + 0.28 * way;
  outline.b = 0.5 * diameter * std::cos(0.1); // half way between frontal and tilted
  outline.angle = 0.;
  return outline;
}

void expectRead(const vpImage<unsigned char> &I, const MarkerScene &scene, double way)
{
  const vpCircleMarkerFamily &family = scene.family;
  const CameraModel camera(scene.camera());
  const auto reading = readBlurred(I, camera, outlineOf(scene, way), scene.radius, family, leastMargin);
  ASSERT_TRUE(reading) << family.getName();
  EXPECT_EQ(family.getCodeword(reading->code.id), scene.word) << family.getName();
  MarkerPlane plane = reading->fit.plane;
  plane.spin(reading->code.spin);
  const double cosine = plane.rotation.col(0).dot(scene.rotation.col(0));
  EXPECT_GT(cosine, std::cos(0.5 * M_PI / family.getNbSectors())) << family.getName();
  EXPECT_LT((plane.center - scene.center).head<2>().norm(), 0.02 * scene.radius);
}
} // namespace

TEST(BlurredReading, CodesOfMarkersThatMoveAreRead)
{
  constexpr int way = 17; // pixels, a fifth of the diameter
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31R}) {
    const MarkerScene scene = sceneOf(random, vpCircleMarkerFamily(type));
    expectRead(digitise(moved(expose(side, side, lens, scene), way), 1., random), scene, way);
  }
}

TEST(BlurredReading, CodesOutOfFocusAreRead)
{
  constexpr int radius = 10; // pixels, an eighth of the diameter
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31R}) {
    const MarkerScene scene = sceneOf(random, vpCircleMarkerFamily(type));
    expectRead(digitise(defocused(expose(side, side, lens, scene), radius), 1., random), scene, 0.);
  }
}

TEST(BlurredReading, NothingWithoutACodeword)
{
  Random random = randomOfTest();
  MarkerScene scene = sceneOf(random, vpCircleMarkerFamily(vpCircleMarkerFamily::BCH31R));
  scene.word ^= 0x1f0f0000; // of 31 sectors nine others: codewords differ in eleven at least
  const vpImage<unsigned char> I = digitise(defocused(expose(side, side, lens, scene), 8), 1., random);
  EXPECT_FALSE(
      readBlurred(I, CameraModel(scene.camera()), outlineOf(scene, 0.), scene.radius, scene.family, leastMargin));
}

// Where a defocus wipes out alternating sectors other prints are like a codeword, but do not leave as little: here one
// with two sectors of grey.
TEST(BlurredReading, FarOutOfFocusNoSectorMayBeGrey)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  for (int i = 0; i < 3; ++i) {
    MarkerScene scene = sceneOf(random, family);
    vpImage<double> sharp = expose(side, side, lens, scene);
    scene.word ^= 0x801U << (random() % 10);
    const vpImage<double> other = expose(side, side, lens, scene);
    for (unsigned int k = 0; k < sharp.getSize(); ++k) {
      sharp.bitmap[k] = 0.5 * (sharp.bitmap[k] + other.bitmap[k]);
    }
    for (const int radius : {7, 10}) { // 0.18 and 0.25 of the outline
      const auto reading = readBlurred(digitise(defocused(sharp, radius), 1., random), CameraModel(scene.camera()),
                                       outlineOf(scene, 0.), scene.radius, family, leastMargin);
      EXPECT_EQ(reading.has_value(), radius < 10) << i;
    }
  }
}

// Two dots of a grid were joined to an outline, and explained by a code that moves by three times its semi-major axis.
TEST(BlurredReading, NothingThatMovesByMoreThanMarkersDo)
{
  constexpr int way = 30; // pixels, 0.64 of the semi-major axis, and 0.71 of one that is seen a tenth too small
  Random random = randomOfTest();
  const MarkerScene scene = sceneOf(random, vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23));
  const vpImage<unsigned char> I = digitise(moved(expose(side, side, lens, scene), way), 1., random);
  for (const double share : {1., 0.9}) {
    EllipseParameters outline = outlineOf(scene, way);
    outline.a *= share;
    outline.b *= share;
    EXPECT_EQ(readBlurred(I, CameraModel(scene.camera()), outline, scene.radius, scene.family, leastMargin).has_value(),
              share == 1.);
  }
}

TEST(BlurredReading, NothingWithoutMarginOrTime)
{
  Random random = randomOfTest();
  const MarkerScene scene = sceneOf(random, vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23));
  const vpImage<unsigned char> I = digitise(defocused(expose(side, side, lens, scene), 10), 1., random);
  const CameraModel camera(scene.camera());
  const EllipseParameters outline = outlineOf(scene, 0.);
  EXPECT_TRUE(readBlurred(I, camera, outline, scene.radius, scene.family, leastMargin));
  EXPECT_FALSE(readBlurred(I, camera, outline, scene.radius, scene.family, 1.)) << "margin";
  for (const double milliseconds : {1e-6, 1., 5.}) { // it takes a tenth of a second
    EXPECT_FALSE(readBlurred(I, camera, outline, scene.radius, scene.family, leastMargin, Deadline(milliseconds)))
        << milliseconds << " ms";
  }
}

TEST(BlurredReading, RingsThatMoveAreFitted)
{
  constexpr int way = 17;
  const vpCircleMarkerFamily ring(vpCircleMarkerFamily::RING);
  Random random = randomOfTest();
  for (int i = 0; i < 3; ++i) {
    MarkerScene scene = markerScene(random, ring, -1, diameter, 0.3, side);
    scene.sheet = 2.;
    const vpImage<unsigned char> I = digitise(moved(expose(side, side, lens, scene), way), 1., random);
    const CameraModel camera(scene.camera());
    const auto reading = fitBlurredRing(I, camera, outlineOf(scene, way), scene.radius, ring);
    ASSERT_TRUE(reading);
    EXPECT_NEAR(reading->fit.blur.motion.norm(), way, 0.07 * way);
    EXPECT_LT((reading->fit.plane.center - scene.center).head<2>().norm(), 0.02 * scene.radius);
    EXPECT_LT(std::abs(reading->fit.plane.center.z() / scene.center.z() - 1.), 0.01);
    const Eigen::Matrix<double, 6, 6> &covariance = reading->poses.covariance[0];
    EXPECT_TRUE(covariance.allFinite());
    EXPECT_GT(covariance.diagonal().head<5>().minCoeff(), 0.);
    EXPECT_EQ(covariance(5, 5), 0.) << "its spin is held";
  }
}

TEST(BlurredReading, NoRingWhereItsCentreIsFull)
{
  constexpr int way = 17;
  const vpCircleMarkerFamily ring(vpCircleMarkerFamily::RING);
  Random random = randomOfTest();
  // A coded marker is more than its ring, and a thinner ring another one.
  const std::array<MarkerScene, 2> scenes = {
      sceneOf(random, vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23)),
      markerScene(random, vpCircleMarkerFamily::ring(0.9), -1, diameter, 0.2, side)};
  for (MarkerScene scene : scenes) {
    scene.sheet = 2.;
    const vpImage<unsigned char> I = digitise(moved(expose(side, side, lens, scene), way), 1., random);
    EXPECT_FALSE(fitBlurredRing(I, CameraModel(scene.camera()), outlineOf(scene, way), scene.radius, ring));
  }
}
