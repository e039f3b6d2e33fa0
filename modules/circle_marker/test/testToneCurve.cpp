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
 * Test of fits of a marker in the image of a camera whose tone curve is no power of the light.
 */

#include "refine/tone_curve.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "testFitTools.h"
#include "testMeasureTools.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr unsigned int side = 160;

FittedPose fitThatLeaves(double noise, double spread)
{
  FittedPose fit;
  fit.noise = noise;
  fit.inliers = 0.915; // of normal noise
  fit.photometry.blur.sigma = 0.7;
  fit.photometry.blur.spread = spread;
  return fit;
}

//! Grey levels from 0 to 255 on a logistic curve: steeper in the middle by strength / 4 / tanh(strength / 4).
double contrastRaised(double grey, double strength)
{
  const auto logistic = [strength](double share) { return 1. / (1. + std::exp(-strength * (share - 0.5))); };
  return 255. * (logistic(grey / 255.) - logistic(0.)) / (logistic(1.) - logistic(0.));
}

struct Measured
{
  int curves = 0;      // of which a tone curve was told
  double squared = 0.; // mean Mahalanobis distance^2 by degrees of freedom
};

//! Strength 0: a linear camera.
Measured measuredThrough(double strength, const vpCircleMarkerFamily &family, int count, Random &random)
{
  Measured measured;
  for (int i = 0; i < count; ++i) {
    const MarkerScene scene = markerScene(random, family, family.isCoded() ? 5 : -1, uniform(random, 30., 100.),
                                          uniform(random, 0.2, 0.9), side);
    auto exposed = expose(side, side, 0.7, scene);
    if (strength > 0.) {
      for (unsigned int k = 0; k < exposed.getSize(); ++k) {
        exposed.bitmap[k] = contrastRaised(exposed.bitmap[k], strength);
      }
    }
    const Recognition marker = recognised(scene, family.isCoded() ? 5 : -1, false);
    MeasureMemory memory;
    const auto measurement = measure(digitise(exposed, 1., random), CameraModel(scene.camera()), marker, true, memory,
                                     Deadline(), ImageNoise{1., 1., false});
    if (measurement) {
      const FittedPose &fit = measurement->first;
      measured.curves += fit.photometry.toneCurve ? 1 : 0;
      measured.squared +=
          fit_test::mahalanobis(fit, scene.plane(), family.isCoded()) / (family.isCoded() ? 6. : 5.) / count;
    }
    else {
      measured.squared = HUGE_VAL;
    }
  }
  return measured;
}
} // namespace

TEST(ToneCurve, IsSoughtWhereMoreOrLessThanNoiseIsLeftOrInkHasSpread)
{
  constexpr double noise = 2.;
  constexpr double radius = 30.; // pixels
  constexpr std::size_t pixels = 10000;
  const auto mayHave = [&](double left, double spread, std::size_t count) {
    return mayHaveToneCurve(fitThatLeaves(left, spread), count, radius, noise);
  };
  EXPECT_FALSE(mayHave(noise, 0., pixels));
  EXPECT_TRUE(mayHave(1.05 * noise, 0., pixels));
  EXPECT_TRUE(mayHave(0.95 * noise, 0., pixels));
  // Of few pixels more is chance.
  EXPECT_FALSE(mayHave(1.05 * noise, 0., 100));
  EXPECT_FALSE(mayHave(0.95 * noise, 0., 100));
  // A tenth of the blur of 0.7 pixels, in radii.
  EXPECT_FALSE(mayHave(noise, -0.9 * 0.07 / radius, pixels));
  EXPECT_TRUE(mayHave(noise, -1.1 * 0.07 / radius, pixels));
}

TEST(ToneCurve, IsToldWhereTheContrastIsRaised)
{
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::RING}) {
    const vpCircleMarkerFamily family(type);
    constexpr int count = 20;
    const Measured linear = measuredThrough(0., family, count, random);
    const Measured raised = measuredThrough(5., family, count, random);
    RecordProperty(family.getName(), std::to_string(linear.squared) + ", " + std::to_string(raised.squared));
    EXPECT_LE(linear.curves, 4) << family.getName();
    EXPECT_GE(raised.curves, count - 2) << family.getName();
    EXPECT_LT(linear.squared, 1.6) << family.getName();
    EXPECT_LT(raised.squared, 1.6) << family.getName();
  }
}
