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
 * Tests of the unsharp mask that is undone.
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
