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
 * Noise that is told from residuals weighed by Tukey's biweight.
 */

#include "refine/biweight_moments.h"

#include <vector>

#include <gtest/gtest.h>

#include "testRandom.h"

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif
using namespace circle_marker;

namespace {
// Means over a normal distribution by the trapezoidal rule, which is exact for it to rounding.
BiweightMoments integratedMoments(double c)
{
  constexpr double step = 0.01;
  BiweightMoments sums = {0., 0., 0.};
  for (double r = -c; r <= c; r += step) {
    const double density = std::exp(-0.5 * r * r) / std::sqrt(2. * M_PI) * step;
    const double w = std::pow(1. - r * r / (c * c), 2.);
    sums.weight += density * w;
    sums.squares += density * w * r * r;
    sums.pull += density * w * w * r * r;
  }
  return sums;
}
} // namespace

TEST(BiweightMoments, AreThoseOfANormalDistribution)
{
  for (const double c : {4.685, 6., 10., 40.}) {
    const BiweightMoments expected = integratedMoments(c);
    const BiweightMoments moments = biweightMoments(c);
    EXPECT_NEAR(moments.weight, expected.weight, 1e-4) << c; // the tails
    EXPECT_NEAR(moments.squares, expected.squares, 1e-4) << c;
    EXPECT_NEAR(moments.pull, expected.pull, 1e-4) << c;
  }
}

TEST(BiweightMoments, TheNoiseIsToldWhateverItIsWeighedBy)
{
  random_test::Random random = random_test::randomOfTest();
  constexpr int count = 20000; // tells the noise to half a per cent
  constexpr double sigma = 0.7;
  std::normal_distribution<double> normal(0., sigma);
  std::vector<double> residuals(count);
  for (double &residual : residuals) {
    residual = normal(random);
  }
  for (const double noise : {sigma, 1., 2., 20.}) {
    const double bound = 4.685 * noise;
    double squares = 0., weights = 0.;
    for (const double residual : residuals) {
      const double kept = std::max(1. - residual * residual / (bound * bound), 0.);
      squares += kept * kept * residual * residual;
      weights += kept * kept;
    }
    EXPECT_NEAR(weighedNoise(squares, weights, noise).sigma, sigma, 0.01 * sigma) << noise;
  }
}
