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
 * Test of the blur's shape, and of light, ink and gamma.
 */

#include "decode/photometry.h"

#include <Eigen/LU>

#include <gtest/gtest.h>

#include "testRoomTools.h"

using namespace circle_marker;
using namespace room_test;

TEST(Photometry, BlurIsLongerInTheDirectionOfTheMotion)
{
  // Twice as long as the mean along v, half as long along u.
  BlurParameters blur;
  blur.sigma = 0.9;
  blur.elongation = Eigen::Vector2d(-std::log(2.), 0.);
  EXPECT_LT((blur.shape() - Eigen::Vector2d(0.5, 2.).asDiagonal().toDenseMatrix()).norm(), 1e-12);
  EXPECT_NEAR(blur.widest(), 1.8, 1e-12);
  // And along the diagonal.
  blur.elongation = Eigen::Vector2d(0., std::log(2.));
  const Eigen::Vector2d diagonal = Eigen::Vector2d(1., 1.).normalized();
  EXPECT_LT((blur.shape() * diagonal - 2. * diagonal).norm(), 1e-12);
  EXPECT_NEAR(blur.along(diagonal), 1.8, 1e-12);
}

TEST(Photometry, ElongationsAddUpAsCovariancesDo)
{
  Random random = randomOfTest();
  for (int i = 0; i < 200; ++i) {
    BlurParameters blur;
    blur.elongation =
        i == 0 ? Eigen::Vector2d::Zero().eval() : Eigen::Vector2d(uniform(random, -1., 1.), uniform(random, -1., 1.));
    const Eigen::Vector2d step(uniform(random, -0.3, 0.3), uniform(random, -0.3, 0.3));
    const Eigen::Matrix2d before = blur.shape();
    EXPECT_NEAR(before.determinant(), 1., 1e-12);
    // exp(2 A) by scaling and squaring.
    Eigen::Matrix2d change;
    change << step.x(), step.y(), step.y(), -step.x();
    Eigen::Matrix2d power = Eigen::Matrix2d::Identity() + change / 512. + 0.5 * change * change / (512. * 512.);
    for (int k = 0; k < 10; ++k) {
      power = (power * power).eval();
    }
    blur.elongate(step);
    EXPECT_LT((blur.shape() * blur.shape() - before * power * before).norm(), 1e-4 * before.squaredNorm());
    EXPECT_NEAR(blur.shape().determinant(), 1., 1e-12);
  }
}

// Ink at 0.2 of white and a curve of -0.5: a quarter of the way up from ink, by the curve 0.25 - 0.5 * 0.25 * 0.75 *
// 0.5.
TEST(Photometry, BlackIsToldThroughATone)
{
  Photometry photometry;
  photometry.absorption = 0.8;
  photometry.toneCurve = -0.5;
  EXPECT_NEAR(photometry.blackOf(0.2), 1., 1e-9);
  EXPECT_NEAR(photometry.blackOf(1.), 0., 1e-9);
  EXPECT_NEAR(photometry.blackOf(0.6), 0.5, 1e-9);
  EXPECT_NEAR(photometry.blackOf(0.2 + 0.8 * (0.25 - 0.5 * 0.25 * 0.75 * 0.5)), 0.75, 1e-9);
  for (const double curve : {-0.9, -0.3, 0.}) {
    photometry.toneCurve = curve;
    for (double w = 0.02; w < 1.; w += 0.02) {
      const double grey = 0.2 + 0.8 * (w + curve * w * (1. - w) * (1. - 2. * w));
      EXPECT_NEAR(photometry.blackOf(grey), 1. - w, 1e-6) << curve;
    }
  }
}

TEST(Photometry, GreyLevelsAreTheLightToThePowerOfGamma)
{
  Photometry photometry;
  photometry.white = 200.;
  photometry.lightGradient = Eigen::Vector2d(0.5, 0.);
  photometry.absorption = 0.75;
  EXPECT_NEAR(photometry.contrast(), 0.75, 1e-12);
  EXPECT_NEAR(photometry.whiteAt(Eigen::Vector2d(0.5, 3.)), 250., 1e-9);
  EXPECT_NEAR(photometry.blackOf(0.625), 0.5, 1e-12);
  photometry.gamma = 2.;
  EXPECT_NEAR(photometry.contrast(), 1. - 0.0625, 1e-12);
  EXPECT_NEAR(photometry.whiteAt(Eigen::Vector2d(0.5, 3.)), 200. * 1.5625, 1e-9);
  EXPECT_NEAR(photometry.blackOf(0.625 * 0.625), 0.5, 1e-12);
  // Where a shadow's edge passes, softly, half of the light that it takes is gone; far on either side all or nothing.
  photometry.shadow = Shadow{0.4, 0.5 * M_PI, 1., 0.1}; // dark toward larger v
  const double slope = 1.25;                            // of the light at u = 1/2, besides the shadow
  EXPECT_NEAR(photometry.whiteAt(Eigen::Vector2d(0.5, 3.)), 200. * std::pow(slope * 0.4, 2.), 1e-9);
  EXPECT_NEAR(photometry.whiteAt(Eigen::Vector2d(0.5, 1.)), 200. * std::pow(slope * 0.7, 2.), 1e-9);
  EXPECT_NEAR(photometry.whiteAt(Eigen::Vector2d(0.5, -1.)), 200. * std::pow(slope, 2.), 1e-9);
  // One standard deviation before the edge 15.87 % of what it takes is gone.
  EXPECT_NEAR(photometry.shadow->leavesAt(Eigen::Vector2d(0., 0.9)), 1. - 0.6 * 0.158655, 1e-6);
  photometry.shadow.reset();
  // Ink that takes more light than there is, as noise may have it.
  photometry.absorption = 1.02;
  EXPECT_EQ(photometry.contrast(), 1.02);
}

TEST(Photometry, ASensorTellsNoMoreThanWhiteAndNoLessThanBlack)
{
  Photometry photometry;
  photometry.white = 200.;
  photometry.absorption = 0.75;
  EXPECT_NEAR(photometry.tellableContrast(), 150., 1e-9);
  photometry.absorption = 1.2; // ink at -40
  EXPECT_NEAR(photometry.tellableContrast(), 200., 1e-9);
  photometry.white = 400.;
  EXPECT_NEAR(photometry.tellableContrast(), 255., 1e-9);
  photometry.absorption = 0.5; // ink at 200
  EXPECT_NEAR(photometry.tellableContrast(), 55., 1e-9);
  photometry.absorption = 0.25; // at 300
  EXPECT_EQ(photometry.tellableContrast(), 0.);
}
