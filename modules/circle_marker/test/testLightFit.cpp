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
 * Tests of the uneven light on a marker.
 */

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "refine/light_fit.h"
#include "testRoomTools.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr double white = 150.; // grey levels
constexpr double black = 30.;
constexpr double noise = 2.;
const ImageFrame frame = {Eigen::Vector2d(320., 240.), 40.};
// Of a sheet that is tilted by 60 degrees about the image's vertical.
const Eigen::Matrix2d toSheet = Eigen::Vector2d(2., 1.).asDiagonal();

// A lamp's spot, which is added to the light, or multiplies it.
struct Spot
{
  Eigen::Vector2d center; // on the sheet, outer radii
  double width = 0.5;
  double added = 0.;  // grey levels
  double factor = 0.; // besides 1

  double greyOf(const Eigen::Vector2d &q, double darkness) const
  {
    const double bright = std::exp(-0.5 * (q - center).squaredNorm() / (width * width));
    return (1. + factor * bright) * (white - (white - black) * darkness) + added * bright;
  }
};

// Pixels all over a marker, a third of which see an edge; a fit has that by up to half of its width elsewhere.
std::vector<ExplainedPixel> pixelsUnder(const Spot &spot, Random &random)
{
  std::normal_distribution<double> normal(0., noise);
  std::vector<ExplainedPixel> pixels;
  for (int i = 0; i < 800; ++i) {
    const double radius = std::sqrt(uniform(random, 0.1, 1.2));
    const double angle = uniform(random, -M_PI, M_PI);
    const Eigen::Vector2d q(radius * std::cos(angle), radius * std::sin(angle));
    const double across = uniform(random, -1., 2.);
    ExplainedPixel pixel;
    pixel.offset = (toSheet.inverse() * q).cast<float>();
    pixel.grey = static_cast<float>(spot.greyOf(q, std::clamp(across, 0., 1.)) + normal(random));
    pixel.darkness = static_cast<float>(std::clamp(across + 0.2, 0., 1.));
    pixel.weight = 1.f;
    pixels.push_back(pixel);
  }
  return pixels;
}

// How far white and black are apart after they were taken to even light, root mean square over the marker.
double unevenAfter(const UnevenLight &light, const Spot &spot, Random &random)
{
  double sum = 0.;
  constexpr int places = 200;
  for (int i = 0; i < places; ++i) {
    const double radius = std::sqrt(uniform(random, 0.1, 1.2));
    const double angle = uniform(random, -M_PI, M_PI);
    const Eigen::Vector2d q(radius * std::cos(angle), radius * std::sin(angle));
    const Eigen::Vector2d place = frame.center + frame.size * (toSheet.inverse() * q);
    sum += std::pow(light.evened(place, spot.greyOf(q, 0.)) - light.meanWhite, 2);
    sum += std::pow(light.evened(place, spot.greyOf(q, 1.)) - (light.meanWhite - light.meanStep), 2);
  }
  return std::sqrt(sum / (2. * places));
}
} // namespace

TEST(LightFit, SpotsAreTakenOut)
{
  Random random = randomOfTest();
  for (int i = 0; i < 40; ++i) {
    Spot spot;
    spot.center << uniform(random, -0.8, 0.8), uniform(random, -0.8, 0.8);
    spot.width = uniform(random, 0.4, 0.6);
    (i % 2 == 0 ? spot.added : spot.factor) = i % 2 == 0 ? 70. : 0.5;
    const auto light = unevenLightOf(pixelsUnder(spot, random), frame, toSheet, noise);
    ASSERT_TRUE(light);
    // Of spots that add 35 and more in the root mean square. What is left is the pixels' noise, the Gaussians' shape
    // and the edges that were told elsewhere.
    EXPECT_LT(unevenAfter(*light, spot, random), 6.) << "spot " << i;
  }
}

TEST(LightFit, EvenLightStaysEven)
{
  Random random = randomOfTest();
  const Spot none = {Eigen::Vector2d::Zero()};
  const auto light = unevenLightOf(pixelsUnder(none, random), frame, toSheet, noise);
  ASSERT_TRUE(light);
  EXPECT_LT(unevenAfter(*light, none, random), 4.);
}

TEST(LightFit, ThereAndBack)
{
  Random random = randomOfTest();
  const Spot spot = {Eigen::Vector2d(0.3, -0.5), 0.5, 60., 0.3};
  const auto light = unevenLightOf(pixelsUnder(spot, random), frame, toSheet, noise);
  ASSERT_TRUE(light);
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector2d place =
        frame.center + Eigen::Vector2d(uniform(random, -25., 25.), uniform(random, -50., 50.));
    const double grey = uniform(random, 0., 255.);
    EXPECT_NEAR(light->uneven(place, light->evened(place, grey)), grey, 1e-9);
  }
}

// A tenth of the pixels are covered by something bright.
TEST(LightFit, WhatCoversIsNotOfTheLight)
{
  Random random = randomOfTest();
  const Spot spot = {Eigen::Vector2d(0.3, -0.5), 0.5, 60.};
  std::vector<ExplainedPixel> pixels = pixelsUnder(spot, random);
  for (std::size_t i = 0; i < pixels.size(); i += 10) {
    pixels[i].grey = 240.f;
  }
  const auto light = unevenLightOf(pixels, frame, toSheet, noise);
  ASSERT_TRUE(light);
  EXPECT_LT(unevenAfter(*light, spot, random), 8.);
}

// White and black are told apart by pixels of both.
TEST(LightFit, NoneWithoutAPrint)
{
  Random random = randomOfTest();
  std::vector<ExplainedPixel> pixels = pixelsUnder({Eigen::Vector2d::Zero()}, random);
  for (ExplainedPixel &pixel : pixels) {
    pixel.darkness = 1.f - pixel.darkness; // a negative
  }
  EXPECT_FALSE(unevenLightOf(pixels, frame, toSheet, noise));
  EXPECT_FALSE(unevenLightOf({}, frame, toSheet, noise));
}
