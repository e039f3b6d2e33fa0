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
 * Test of the search for a shadow's edge in what a fit without one leaves.
 */

#include "refine/shadow_split.h"

#include <gtest/gtest.h>

#include "refine/shadow.h"
#include "testRoomTools.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr double frameSize = 20.; // pixels
constexpr double white = 180.;    // grey levels
constexpr double black = 40.;
constexpr double noise = 2.;

struct Case
{
  Shadow shadow;
  double slope = 0.; // of the light over a radius, along u
};

// Pixels all over a marker, of all shares of black, and a fit that knows all but the shadow: it has the mean light.
std::vector<ExplainedPixel> pixelsUnder(const Case &light, Random &random)
{
  std::normal_distribution<double> normal(0., noise);
  const double mean = 0.5 * (1. + light.shadow.factor);
  std::vector<ExplainedPixel> pixels;
  for (int i = 0; i < 400; ++i) {
    const double radius = std::sqrt(uniform(random, 0.1, 1.2));
    const double angle = uniform(random, -M_PI, M_PI);
    const Eigen::Vector2d offset(radius * std::cos(angle), radius * std::sin(angle));
    const double darkness = std::clamp(uniform(random, -1., 2.), 0., 1.); // a third of it edges
    const double print = (white - (white - black) * darkness) * (1. + light.slope * offset.x());
    const double beyond =
        offset.dot(Eigen::Vector2d(std::cos(light.shadow.direction), std::sin(light.shadow.direction)));
    const double share = beyond > light.shadow.edge ? light.shadow.factor : 1.;
    ExplainedPixel pixel;
    pixel.offset = offset.cast<float>();
    pixel.grey = static_cast<float>(share * print + normal(random));
    pixel.fitted = static_cast<float>(mean * print);
    pixel.darkness = static_cast<float>(darkness);
    pixel.weight = 1.f;
    pixels.push_back(pixel);
  }
  return pixels;
}
} // namespace

TEST(ShadowSplit, ItsEdgeIsFound)
{
  Random random = randomOfTest();
  for (int i = 0; i < 100; ++i) {
    Case light;
    light.shadow.factor = uniform(random, 0.15, 0.8);
    light.shadow.direction = uniform(random, -M_PI, M_PI);
    light.shadow.edge = uniform(random, -0.6, 0.6);
    const auto found = shadowBySplit(pixelsUnder(light, random), frameSize);
    ASSERT_TRUE(found) << "factor " << light.shadow.factor << " edge " << light.shadow.edge;
    EXPECT_NEAR(found->factor, light.shadow.factor, 0.08);
    EXPECT_NEAR(wrapped(found->direction - light.shadow.direction), 0., 0.2) << "edge " << light.shadow.edge;
    EXPECT_NEAR(found->edge, light.shadow.edge, 0.1) << "factor " << light.shadow.factor;
    EXPECT_EQ(found->softness, softnessAtStart(frameSize));
  }
}

// The light and gamma of a fit that did not know of the shadow have followed it: its grey levels tell nothing.
TEST(ShadowSplit, TheFitsLightDoesNotCount)
{
  Random random = randomOfTest();
  Case light;
  light.shadow.factor = 0.5;
  light.shadow.direction = 0.4;
  light.shadow.edge = 0.2;
  std::vector<ExplainedPixel> pixels = pixelsUnder(light, random);
  const auto expected = shadowBySplit(pixels, frameSize);
  ASSERT_TRUE(expected);
  for (ExplainedPixel &pixel : pixels) {
    pixel.fitted *= 1.f - 0.3f * pixel.offset.x();
  }
  const auto found = shadowBySplit(pixels, frameSize);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->factor, expected->factor);
  EXPECT_EQ(found->direction, expected->direction);
  EXPECT_EQ(found->edge, expected->edge);
}

// The fit's own light may explain more than two strengths do: it leaves two fifths of what these leave at least.
TEST(ShadowSplit, MayLeaveMoreThanTheFit)
{
  Random random = randomOfTest();
  Case light;
  light.shadow.direction = 0.4;
  light.shadow.edge = 0.2;
  std::vector<ExplainedPixel> pixels = pixelsUnder(light, random);
  constexpr double places = 0.06; // of the marker: the edge is found to about this, and pixels beside it leave more
  double left = 0.;
  for (ExplainedPixel &pixel : pixels) {
    const double beyond = pixel.offset.x() * std::cos(0.4) + pixel.offset.y() * std::sin(0.4) - 0.2;
    pixel.weight = std::abs(beyond) > places ? 1.f : 0.f;
    const double print = white - (white - black) * pixel.darkness;
    const double off = pixel.grey - print * (beyond > 0. ? light.shadow.factor : 1.);
    left += pixel.weight * off * off;
  }
  const auto isFoundIfTheFitLeaves = [&](double share) { // of what the split leaves
    double weights = 0.;
    for (const ExplainedPixel &pixel : pixels) {
      weights += pixel.weight;
    }
    for (ExplainedPixel &pixel : pixels) {
      pixel.fitted = pixel.grey + static_cast<float>(std::sqrt(share * left / weights));
    }
    return shadowBySplit(pixels, frameSize).has_value();
  };
  EXPECT_TRUE(isFoundIfTheFitLeaves(0.44));
  EXPECT_FALSE(isFoundIfTheFitLeaves(0.36));
}

TEST(ShadowSplit, NoneWhereTheFitExplainsTheLight)
{
  Random random = randomOfTest();
  for (int i = 0; i < 50; ++i) {
    Case light;
    light.shadow.factor = 1.;
    light.slope = i % 2 == 0 ? 0. : 0.5;
    EXPECT_FALSE(shadowBySplit(pixelsUnder(light, random), frameSize)) << "slope " << light.slope;
  }
}

// Of so little shade the gradient takes enough, and through so much no print is seen.
TEST(ShadowSplit, LightThatIsLeftIsBetweenItsBounds)
{
  Random random = randomOfTest();
  const auto isFound = [&](double factor) {
    Case light;
    light.shadow.factor = factor;
    return shadowBySplit(pixelsUnder(light, random), frameSize).has_value();
  };
  EXPECT_TRUE(isFound(0.82));
  EXPECT_FALSE(isFound(0.88));
  EXPECT_TRUE(isFound(0.13));
  EXPECT_FALSE(isFound(0.07));
}

// How bright white is on a side is told from how it differs from black.
TEST(ShadowSplit, NoneWithoutBlackAndWhite)
{
  Random random = randomOfTest();
  const Case light;
  std::vector<ExplainedPixel> pixels = pixelsUnder(light, random);
  ASSERT_TRUE(shadowBySplit(pixels, frameSize));
  for (ExplainedPixel &pixel : pixels) {
    pixel.darkness = 0.f;
  }
  EXPECT_FALSE(shadowBySplit(pixels, frameSize));
  EXPECT_FALSE(shadowBySplit({}, frameSize));
}

// What lies beyond the paper may be anything.
TEST(ShadowSplit, PixelsWithoutWeightDoNotCount)
{
  Random random = randomOfTest();
  Case light;
  light.shadow.direction = -1.;
  light.shadow.edge = -0.3;
  std::vector<ExplainedPixel> pixels = pixelsUnder(light, random);
  const auto expected = shadowBySplit(pixels, frameSize);
  ASSERT_TRUE(expected);
  for (int i = 0; i < 100; ++i) {
    ExplainedPixel pixel = pixels[static_cast<std::size_t>(i)];
    pixel.grey = static_cast<float>(uniform(random, 0., 255.));
    pixel.weight = 0.f;
    pixels.push_back(pixel);
  }
  const auto found = shadowBySplit(pixels, frameSize);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->edge, expected->edge);
  EXPECT_EQ(found->direction, expected->direction);
}
