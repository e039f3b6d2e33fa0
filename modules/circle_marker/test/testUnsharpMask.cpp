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
 * Tests of the unsharp mask that is told from a ring, and undone.
 */

#include "refine/unsharp_mask.h"

#include <cmath>

#include <gtest/gtest.h>

#include "testRoomTools.h"
#include "testSharpening.h"

using namespace circle_marker;
using namespace room_test;
using sharpening_test::sharpened;

namespace {
constexpr unsigned int side = 160;

//! White and ink that leave room for a halo.
MarkerScene sceneOf(Random &random, vpCircleMarkerFamily::vpType type, double diameter, double tilt)
{
  MarkerScene scene = markerScene(random, vpCircleMarkerFamily(type), 5, diameter, tilt, side);
  scene.white = 160.;
  scene.black = 70.;
  scene.sheet = 1.4;
  return scene;
}

Few<MarkerPlane> only(const MarkerPlane &plane)
{
  Few<MarkerPlane> poses;
  poses.push_back(plane);
  return poses;
}

std::optional<UnsharpMask> maskIn(const vpImage<unsigned char> &I, const MarkerScene &scene)
{
  return unsharpMaskOf(I, CameraModel(scene.camera()), only(scene.plane()), scene.family.getLayout());
}

double rms(const vpImage<unsigned char> &I, const vpImage<unsigned char> &J, unsigned int margin)
{
  double squares = 0.;
  for (unsigned int v = margin; v < side - margin; ++v) {
    for (unsigned int u = margin; u < side - margin; ++u) {
      squares += std::pow(static_cast<double>(I[v][u]) - J[v][u], 2.);
    }
  }
  return std::sqrt(squares) / (side - 2. * margin);
}
} // namespace

// Amount and width are known together: what matters is by how much an edge is overdone.
TEST(UnsharpMask, IsToldFromBothEdgesOfARing)
{
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::RING, vpCircleMarkerFamily::DISC}) {
    for (const double amount : {0.5, 1., 1.5}) {
      for (const double sigma : {1., 2.}) {
        const MarkerScene scene = sceneOf(random, type, uniform(random, 70., 100.), uniform(random, 0., 0.8));
        const auto I = sharpened(digitise(expose(side, side, 0.7, scene), 1., random), amount, sigma);
        const auto mask = maskIn(I, scene);
        ASSERT_TRUE(mask) << scene.family.getName() << ", " << amount << " times, " << sigma << " pixels";
        EXPECT_NEAR(mask->sigma, sigma, 0.4 * sigma) << scene.family.getName() << ", " << amount;
        // Of a lone edge behind a blur of the lens and of the pixel's area.
        const double blur = std::hypot(0.7, 0.29);
        const double wider = std::hypot(blur, sigma);
        double halo = 0.;
        for (double x = 0.; x < 5.; x += 0.01) {
          const auto within = [x](double s) { return 0.5 * std::erfc(-x / (s * M_SQRT2)); };
          halo = std::max(halo, (1. + amount) * within(blur) - amount * within(wider) - 1.);
        }
        EXPECT_NEAR(mask->halo, halo, 0.01 + 4. * mask->error) << scene.family.getName() << ", " << amount;
        EXPECT_LT(mask->error, 0.5 * halo);
      }
    }
  }
}

// The halo depends on amount, width and blur, which are known together: its error is no less than that of all of them.
TEST(UnsharpMask, TheHaloIsKnownNoWorseThanItSays)
{
  Random random = randomOfTest();
  for (const double diameter : {50., 120.}) {
    constexpr int draws = 100;
    MarkerScene scene = sceneOf(random, vpCircleMarkerFamily::RING, diameter, 0.3);
    double sum = 0.;
    double squares = 0.;
    double told = 0.;
    int seen = 0;
    for (int i = 0; i < draws; ++i) {
      const auto I = sharpened(digitise(expose(side, side, 0.7, scene), 1., random), 1., 1.5);
      if (const auto mask = maskIn(I, scene)) {
        sum += mask->halo;
        squares += mask->halo * mask->halo;
        told += mask->error * mask->error;
        ++seen;
      }
    }
    ASSERT_GT(seen, draws * 9 / 10) << diameter;
    const double deviation = std::sqrt(squares / seen - std::pow(sum / seen, 2.));
    const double ratio = deviation / std::sqrt(told / seen);
    EXPECT_LT(ratio, 1.3) << diameter;
  }
}

TEST(UnsharpMask, ThereIsNoneInAnImageThatIsNotSharpened)
{
  Random random = randomOfTest();
  int found = 0;
  for (int i = 0; i < 30; ++i) {
    const MarkerScene scene =
        sceneOf(random, vpCircleMarkerFamily::GOLAY23, uniform(random, 60., 100.), uniform(random, 0., 0.8));
    found += maskIn(digitise(expose(side, side, uniform(random, 0.5, 1.), scene), 1., random), scene) ? 1 : 0;
  }
  EXPECT_LE(found, 3) << "by chance";
}

TEST(UnsharpMask, OfThePosesThatTheMarkerMayHaveTheBestCounts)
{
  Random random = randomOfTest();
  const MarkerScene scene = sceneOf(random, vpCircleMarkerFamily::RING, 90., 0.8);
  const auto I = sharpened(digitise(expose(side, side, 0.7, scene), 1., random), 1., 2.);
  const CameraModel camera(scene.camera());
  const vpCircleMarkerLayout &layout = scene.family.getLayout();
  const auto right = unsharpMaskOf(I, camera, only(scene.plane()), layout);
  ASSERT_TRUE(right);
  MarkerPlane wrong = scene.plane();
  wrong.center.x() += 1.5 * wrong.center.z() / scene.focal; // 1.5 pixels
  Few<MarkerPlane> poses = only(wrong);
  poses.push_back(scene.plane());
  const auto best = unsharpMaskOf(I, camera, poses, layout);
  ASSERT_TRUE(best);
  EXPECT_EQ(best->amount, right->amount);
  EXPECT_EQ(best->sigma, right->sigma);
}

// Halos that reach beyond black and white are cut off: what is left of them has to be enough.
TEST(UnsharpMask, IsToldThoughItsHaloIsCutOff)
{
  Random random = randomOfTest();
  MarkerScene scene = sceneOf(random, vpCircleMarkerFamily::GOLAY23, 90., 0.5);
  scene.white = 240.;
  scene.black = 15.;
  const auto mask = maskIn(sharpened(digitise(expose(side, side, 0.7, scene), 1., random), 1., 2.), scene);
  ASSERT_TRUE(mask);
  EXPECT_NEAR(mask->amount, 1., 0.25);
  EXPECT_NEAR(mask->white, 240., 5.);
  EXPECT_NEAR(mask->ink, 15., 5.);
}

TEST(UnsharpMask, TooSmallARingTellsNothing)
{
  Random random = randomOfTest();
  const MarkerScene scene = sceneOf(random, vpCircleMarkerFamily::GOLAY23, 4., 0.);
  EXPECT_FALSE(maskIn(sharpened(digitise(expose(side, side, 0.7, scene), 1., random), 1., 1.), scene));
}

TEST(UnsharpMask, UndoingItBringsTheImageBack)
{
  Random random = randomOfTest();
  const MarkerScene scene = sceneOf(random, vpCircleMarkerFamily::GOLAY23, 90., 0.5);
  const vpImage<unsigned char> I = digitise(expose(side, side, 0.7, scene), 1., random);
  for (const double amount : {0.5, 2.}) {
    for (const double sigma : {1., 2.}) {
      UnsharpMask mask;
      mask.amount = amount;
      mask.sigma = sigma;
      const vpImage<unsigned char> J = sharpened(I, amount, sigma);
      ASSERT_GT(rms(I, J, 16), 1.5);
      vpImage<unsigned char> restored;
      ASSERT_TRUE(undo(mask, J, cv::Rect(0, 0, side, side), Deadline(), restored));
      EXPECT_LT(rms(I, restored, 16), 1.2) << amount << " times, " << sigma << " pixels"; // both were rounded
    }
  }
}

TEST(UnsharpMask, UndoingItWritesTheBoxAlone)
{
  Random random = randomOfTest();
  const vpImage<unsigned char> I =
      digitise(expose(side, side, 0.7, sceneOf(random, vpCircleMarkerFamily::RING, 90., 0.)), 1., random);
  UnsharpMask mask;
  mask.amount = 1.;
  mask.sigma = 1.5;
  vpImage<unsigned char> restored(side, side, 7);
  ASSERT_TRUE(undo(mask, I, cv::Rect(20, 30, 50, 40), Deadline(), restored));
  for (unsigned int v = 0; v < side; ++v) {
    for (unsigned int u = 0; u < side; ++u) {
      const bool isInside = u >= 20 && u < 70 && v >= 30 && v < 70;
      if (!isInside) {
        ASSERT_EQ(restored[v][u], 7) << u << ", " << v;
      }
    }
  }
  EXPECT_NE(restored[50][45], 7);
}

TEST(UnsharpMask, UndoingItComesBackWithoutTime)
{
  const vpImage<unsigned char> I(side, side, 100);
  UnsharpMask mask;
  mask.amount = 1.;
  mask.sigma = 1.5;
  vpImage<unsigned char> restored(side, side, 7);
  EXPECT_FALSE(undo(mask, I, cv::Rect(0, 0, side, side), Deadline(1e-6), restored));
  EXPECT_EQ(restored[50][50], 7);
}
