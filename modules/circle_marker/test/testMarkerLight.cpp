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
 * Tests of the light on a marker with the edge of a shadow.
 */

#include "decode/marker_light.h"

#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "decode/code_track.h"
#include "testRandom.h"

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif
using namespace circle_marker;
using namespace random_test;

namespace {
constexpr std::size_t count = 92;
constexpr double radius = 1.1; // outer radii

/*! Light as a camera sees it. */
struct Scene
{
  double center = 100.;
  Eigen::Vector2d slope = Eigen::Vector2d::Zero(); // by outer radii, share of the centre
  double gamma = 1.;
  double factor = 1.; // of a shadow
  Eigen::Vector2d toLight = Eigen::Vector2d::UnitX();
  double edge = 0.;

  double at(const Eigen::Vector2d &q) const
  {
    const double shade = toLight.dot(q) > edge ? 1. : factor;
    return center * std::pow((1. + slope.dot(q)) * shade, gamma);
  }

  MarkerLight seen(Random &random, double noise) const
  {
    std::array<double, mostSamples> whites;
    std::normal_distribution<double> normal(0., 1.);
    for (std::size_t i = 0; i < count; ++i) {
      const double angle = 2. * M_PI * (static_cast<double>(i) + 0.5) / count;
      whites[i] = std::max(0., at(radius * Eigen::Vector2d(std::cos(angle), std::sin(angle))) + noise * normal(random));
    }
    return MarkerLight(whites.data(), count, radius);
  }
};

Eigen::Vector2d anyDirection(Random &random)
{
  const double angle = uniform(random, 0., 2. * M_PI);
  return {std::cos(angle), std::sin(angle)};
}
} // namespace

TEST(MarkerLight, AGradientIsNoShadow)
{
  Random random = randomOfTest();
  for (int i = 0; i < 200; ++i) {
    Scene scene;
    scene.slope = uniform(random, 0., 0.6) * anyDirection(random);
    const MarkerLight light = scene.seen(random, 2.);
    EXPECT_FALSE(light.hasShadow()) << scene.slope.norm();
    const Eigen::Vector2d place = uniform(random, 0., 1.) * anyDirection(random);
    EXPECT_NEAR(light.at(place), scene.at(place), 2.);
  }
}

// The white around a tilted marker with a narrow quiet zone is darker at the ends of its minor axis.
TEST(MarkerLight, DipsOnOppositeSidesAreNoShadow)
{
  Random random = randomOfTest();
  for (int i = 0; i < 200; ++i) {
    const double depth = uniform(random, 20., 60.);
    const double width = uniform(random, 0.3, 0.9); // rad
    const double middle = uniform(random, 0., M_PI);
    std::normal_distribution<double> normal(0., 2.);
    std::array<double, mostSamples> whites;
    for (std::size_t k = 0; k < count; ++k) {
      const double angle = 2. * M_PI * (static_cast<double>(k) + 0.5) / count;
      const double apart = std::asin(std::abs(std::sin(angle - middle)));
      whites[k] = 150. - depth * std::exp(-0.5 * apart * apart / (width * width)) + normal(random);
    }
    EXPECT_FALSE(MarkerLight(whites.data(), count, radius).hasShadow()) << "depth " << depth << " width " << width;
  }
}

// Within a shadow and without, a tenth of a radius from its edge, where the white of the quiet zone tells the light.
TEST(MarkerLight, AShadowOnAGradient)
{
  Random random = randomOfTest();
  for (const double gamma : {1., 2.2}) {
    for (int i = 0; i < 200; ++i) {
      Scene scene;
      scene.gamma = gamma;
      scene.slope = uniform(random, 0., 0.4) * anyDirection(random);
      scene.factor = uniform(random, 0.3, 0.5);
      scene.toLight = anyDirection(random);
      scene.edge = uniform(random, -0.5, 0.5);
      const MarkerLight light = scene.seen(random, 1.);
      ASSERT_TRUE(light.hasShadow()) << "gamma " << gamma << " slope " << scene.slope.transpose() << " factor "
                                     << scene.factor << " edge " << scene.edge << " to " << scene.toLight.transpose();
      EXPECT_NEAR(light.getFactor(), std::pow(scene.factor, gamma), 0.06) << "gamma " << gamma;
      for (int k = 0; k < 10; ++k) {
        const Eigen::Vector2d place = uniform(random, 0., 1.) * anyDirection(random);
        if (std::abs(scene.toLight.dot(place) - scene.edge) > 0.1) {
          EXPECT_EQ(light.distanceToShadow(place) > 0., scene.toLight.dot(place) > scene.edge);
          EXPECT_NEAR(light.at(place), scene.at(place), 0.04 * scene.center + 0.06 * scene.at(place))
              << "gamma " << gamma;
        }
      }
    }
  }
}

TEST(MarkerLight, NothingIsSaidOfBlackness)
{
  const std::array<double, mostSamples> whites{};
  EXPECT_FALSE(MarkerLight(whites.data(), count, radius).hasShadow());
}
