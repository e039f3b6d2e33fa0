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
 * What grey levels at a measured ring are between ink and paper.
 */

#include "testRoomTools.h"

#include "decode/measured_ring.h"

using namespace circle_marker;
using namespace room_test;

namespace {
//! Light of 200 at pixel (50, 40), 1 more by the pixel to the right; ink leaves a quarter of it.
MeasuredRing slopedRing()
{
  MeasuredRing ring;
  ring.frame = {Eigen::Vector2d(50., 40.), 10.};
  ring.photometry.white = 200.;
  ring.photometry.lightGradient = Eigen::Vector2d(1. / 20., 0.);
  ring.photometry.absorption = 0.75;
  ring.noise = 3.;
  return ring;
}
} // namespace

TEST(MeasuredRing, LevelsGoFromInkToPaperInTheLightOfTheirPlace)
{
  const MeasuredRing ring = slopedRing();
  const Eigen::Vector2d right(70., 10.); // paper is 220 there, ink 55
  EXPECT_DOUBLE_EQ(ring.whiteAt(right), 220.);
  EXPECT_NEAR(ring.levelAt(right, 220.), 1., 1e-12);
  EXPECT_NEAR(ring.levelAt(right, 55.), 0., 1e-12);
  EXPECT_NEAR(ring.levelAt(right, 137.5), 0.5, 1e-12);
}

TEST(MeasuredRing, LevelsAreThoseOfTheLightWhateverTheGamma)
{
  MeasuredRing ring = slopedRing();
  for (const double gamma : {0.45, 2.2}) {
    ring.photometry.gamma = gamma;
    for (const double level : {0., 0.3, 0.5, 1.}) {
      const double light = 1. - ring.photometry.absorption * (1. - level); // share of the paper's
      EXPECT_NEAR(ring.levelAt(ring.frame.center, 200. * std::pow(light, gamma)), level, 1e-12) << gamma;
      const Eigen::Vector2d right(70., 10.); // the light is 1.1 times that
      EXPECT_NEAR(ring.levelAt(right, 200. * std::pow(1.1 * light, gamma)), level, 1e-12) << gamma;
    }
  }
}

TEST(MeasuredRing, LightIsTheSameInOtherCoordinates)
{
  MeasuredRing ring = slopedRing();
  ring.photometry.gamma = 1.8;
  for (const bool bends : {false, true}) {
    if (bends) {
      ring.photometry.lightCurvature = Eigen::Vector3d(-0.03, 0.01, -0.02);
    }
    MeasuredRing other = ring;
    other.frame = {Eigen::Vector2d(58., 33.), 17.};
    other.photometry = ring.photometryIn(other.frame);
    for (const Eigen::Vector2d &place :
         {Eigen::Vector2d(50., 40.), Eigen::Vector2d(70., 28.), Eigen::Vector2d(44., 55.)}) {
      EXPECT_NEAR(other.whiteAt(place), ring.whiteAt(place), 1e-9) << bends;
    }
  }
}

TEST(MeasuredRing, PaperIsDarkerBeyondTheEdgeOfAShadow)
{
  MeasuredRing ring = slopedRing();
  ring.photometry.lightGradient.setZero();
  Shadow shadow;
  shadow.factor = 0.5;
  shadow.direction = M_PI_2; // downwards
  shadow.edge = 0.5;         // 5 pixels
  shadow.softness = 0.1;
  ring.photometry.shadow = shadow;
  EXPECT_NEAR(ring.whiteAt(Eigen::Vector2d(50., 35.)), 200., 1e-6);
  EXPECT_NEAR(ring.whiteAt(Eigen::Vector2d(50., 45.)), 150., 1e-6);
  EXPECT_NEAR(ring.whiteAt(Eigen::Vector2d(50., 55.)), 100., 1e-6);
  ring.photometry.gamma = 2.2;
  EXPECT_NEAR(ring.whiteAt(Eigen::Vector2d(50., 45.)), 200. * std::pow(0.75, 2.2), 1e-6);
}

TEST(MeasuredRing, NoiseOfALevelIsTheGreatestOnInkOrPaper)
{
  MeasuredRing ring = slopedRing();
  EXPECT_NEAR(ring.noiseOfLevel(), 3. / (200. * 0.75), 1e-12);
  const double little = 1e-4; // grey levels
  for (const double gamma : {0.45, 1.3, 1.9}) {
    ring.photometry.gamma = gamma;
    const auto noiseAt = [&](double grey) {
      const double more =
          ring.levelAt(ring.frame.center, grey + little) - ring.levelAt(ring.frame.center, grey - little);
      return ring.noise * more / (2. * little);
    };
    const double ink = 200. * std::pow(0.25, gamma);
    EXPECT_NEAR(ring.noiseOfLevel() / std::max(noiseAt(ink), noiseAt(200.)), 1., 1e-3) << gamma;
  }
  ring.photometry.gamma = 2.2;
  ring.photometry.absorption = 1.; // black ink, at which levels have no end of noise: that of grey ink is told
  EXPECT_NEAR(ring.noiseOfLevel(), 3. / 200. * std::pow(0.05, 1. / 2.2 - 1.) / 2.2, 1e-12);
}

TEST(MeasuredRing, WhiteIsCutOffWherePaperIsBrighterThanTheSensorTells)
{
  MeasuredRing ring = slopedRing();
  const Eigen::Vector2d right(110., 40.); // paper is 260 there
  EXPECT_FALSE(ring.isCutOff(ring.frame.center, 255.));
  EXPECT_TRUE(ring.isCutOff(right, 255.));
  EXPECT_TRUE(ring.isCutOff(right, 254.));
  EXPECT_FALSE(ring.isCutOff(right, 250.));
}
