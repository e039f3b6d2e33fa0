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
 * Where the programs draw what is seen in a direction.
 */

#include <cmath>

#include <gtest/gtest.h>

#include <visp3/core/vpPixelMeterConversion.h>

#include "circle_marker/common/draw.h"

using namespace tutorial;

namespace {
constexpr double k = 0.2; // kdu, of (x, y) by pixels

void expectInverse(const vpCameraParameters &cam)
{
  for (double x = -0.5; x <= 0.5; x += 0.25) {
    for (double y = -0.4; y <= 0.4; y += 0.2) {
      double back[2] = {NAN, NAN};
      vpPixelMeterConversion::convertPoint(cam, pixelOf(x, y, cam), back[0], back[1]);
      EXPECT_NEAR(back[0], x, 1e-9);
      EXPECT_NEAR(back[1], y, 1e-9);
    }
  }
}
} // namespace

TEST(Draw, PixelsAreTheInverseOfWhatPosesAreMadeOf)
{
  vpCameraParameters cam(800., 790., 319.5, 239.5);
  expectInverse(cam);
  // kud of a calibration is no exact inverse of it: beside it by 2 pixels here, at most.
  cam.initPersProjWithDistortion(800., 790., 319.5, 239.5, k, -k);
  expectInverse(cam);
  cam.initPersProjWithDistortion(800., 790., 319.5, 239.5, -k, k);
  expectInverse(cam);
}

// By hand: x = 0.4 (1 + 0.2 0.4^2) = 0.4128 at 0.4 focal lengths from the principal point.
TEST(Draw, ThePixelOfADirectionByHand)
{
  vpCameraParameters cam;
  cam.initPersProjWithDistortion(1000., 1000., 100., 200., 0., k);
  EXPECT_NEAR(pixelOf(0.4128, 0., cam).get_u(), 500., 1e-6);
  EXPECT_NEAR(pixelOf(0., -0.4128, cam).get_v(), -200., 1e-6);
  EXPECT_EQ(pixelOf(0., 0., cam), vpImagePoint(200., 100.));
}

// With kdu = -0.2 the lens folds over at a distance of 1 / sqrt(0.6) focal lengths, where x is 0.86: beyond, nothing.
TEST(Draw, WhatALensDoesNotShowIsNotDrawn)
{
  vpCameraParameters cam;
  cam.initPersProjWithDistortion(800., 800., 319.5, 239.5, 0., -k);
  EXPECT_TRUE(std::isfinite(pixelOf(0.8, 0., cam).get_u()));
  EXPECT_FALSE(std::isfinite(pixelOf(0.9, 0., cam).get_u()));
  const vpImage<vpRGBa> I(480, 640);
  EXPECT_FALSE(isDrawable(I, {pixelOf(0.9, 0., cam)}));
}
