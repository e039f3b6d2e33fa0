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
 * What a fit says at its end, against what theory says of it.
 */

#include <array>

#include <Eigen/LU>

#include "testFitTools.h"

using namespace fit_test;

namespace {
constexpr int known = 15; // pose, light, its gradient, ink, blur, its elongation, gamma, spread
using Information = Eigen::Matrix<double, known, known>;

/*!
  Covariance of (t, w) that no unbiased estimator is better than (Cramer and Rao), in normal noise of variance 1, if
  all of light, ink and blur are unknown; at a light without gradient and a gamma of 1.
*/
Eigen::Matrix<double, 6, 6> boundOf(const Case &made, const Light &light, const BlurParameters &blur)
{
  Information information = Information::Zero();
  for (const FitPixel &pixel : made.pixels) {
    const Darkness darkness = darknessAt(pixel.model(), made.scene.plane(), made.pattern, blur);
    const double share = 1. - light.contrast * darkness.value;
    const double byDarkness = -light.level * light.contrast;
    Eigen::Matrix<double, known, 1> row;
    row << byDarkness * darkness.byPose, share, light.level * share * pixel.offset.cast<double>(),
        -light.level * darkness.value, byDarkness * darkness.bySigma, byDarkness * darkness.byElongation,
        light.level * share * std::log(share), byDarkness * darkness.bySpread;
    information += row * row.transpose();
  }
  // Metres and grey levels to one size, for the inverse.
  const Eigen::Matrix<double, known, 1> scale = information.diagonal().cwiseSqrt().cwiseInverse();
  const Information inverse = (scale.asDiagonal() * information * scale.asDiagonal()).inverse();
  return (scale.asDiagonal() * inverse * scale.asDiagonal()).topLeftCorner<6, 6>();
}

Case markerOf(double diameter, Random &random)
{
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  const int id = randomId(random, family);
  return makeCase(markerScene(random, family, id, diameter, uniform(random, 0.35, 0.9), side), id,
                  vpImage<unsigned char>(side, side, 0));
}

FitSettings modelSettings()
{
  FitSettings settings;
  settings.exactBends = false; // the images are made of parabolas
  return settings;
}
} // namespace

// Tukey's biweight at its usual constant has an efficiency of 95 % in normal noise: its covariance is that of the
// bound, over 0.95. In so little noise the priors of gamma, spread and the like say nothing beside the image.
TEST(FitConclusion, CovarianceIsThatOfTheBoundAtTheBiweightsEfficiency)
{
  Random random = randomOfTest();
  constexpr int count = 100;
  constexpr double noise = 0.5;
  double ratio = 0.;
  for (int i = 0; i < count; ++i) {
    Case made = markerOf(uniform(random, 70., 90.), random);
    fillFromModel(made, Light(), BlurParameters(), noise, random);
    const auto fit = fitAll(made.pixels, made.scene.plane(), made.pattern, modelSettings());
    ASSERT_TRUE(fit);
    const Eigen::Matrix<double, 6, 6> bound = noise * noise * boundOf(made, Light(), BlurParameters());
    ratio += (fit->covariance * bound.inverse()).trace() / (6 * count);
  }
  // By its noise each covariance is known to some 3 %, the mean of 100 to 0.3 %: the fit's own noise variance is that
  // of some 3000 pixels.
  RecordProperty("ratio", std::to_string(ratio));
  EXPECT_NEAR(ratio, 1. / 0.95, 0.015);
}

// What pixels are off by where edges are, because of how these are drawn or printed, counts by its own variance: twice
// the noise there makes four times the covariance, and a quarter of the log-odds.
TEST(FitConclusion, NoiseAtEdgesIsToldFromThatOfThePaper)
{
  Random random = randomOfTest();
  constexpr int count = 20;
  std::array<double, 2> ratios = {{0., 0.}};
  for (int i = 0; i < count; ++i) {
    Case made = markerOf(80., random);
    for (std::size_t noisy = 0; noisy < ratios.size(); ++noisy) {
      fillFromModel(made, Light(), BlurParameters(), 2., random);
      for (FitPixel &pixel : made.pixels) {
        const double black = darknessAt(pixel.model(), made.scene.plane(), made.pattern, BlurParameters()).value;
        const bool isAtEdge = black > 0.02 && black < 0.98;
        const double grey = Light().level * (1. - Light().contrast * black);
        pixel.grey += static_cast<float>(noisy > 0 && isAtEdge ? pixel.grey - grey : 0.);
      }
      const auto fit = fitAll(made.pixels, made.scene.plane(), made.pattern, FitSettings());
      ASSERT_TRUE(fit);
      const Eigen::Matrix<double, 6, 6> bound = 4. * boundOf(made, Light(), BlurParameters());
      ratios[noisy] += (fit->covariance * bound.inverse()).trace() / (6 * count);
    }
  }
  RecordProperty("ratios", std::to_string(ratios[0]) + " " + std::to_string(ratios[1]));
  EXPECT_NEAR(ratios[0], 1. / 0.95, 0.08);
  EXPECT_GT(ratios[1] / ratios[0], 3.6);
  EXPECT_LT(ratios[1] / ratios[0], 4.4); // the coherence does not have it, too
}

// Of pixels that share their noise fewer count, as far as that is what is left: of the residuals' variance a quarter,
// where the image's noise is half as large.
TEST(FitConclusion, SharedNoiseWidensTheCovariance)
{
  Random random = randomOfTest();
  Case made = markerOf(80., random);
  fillFromModel(made, Light(), BlurParameters(), 2., random);
  FitSettings settings = modelSettings();
  const auto independent = fitAll(made.pixels, made.scene.plane(), made.pattern, settings);
  ASSERT_TRUE(independent);
  EXPECT_EQ(independent->sharing, 1.);
  const double blur = independent->photometry.blur.sigma;
  const double left = independent->noise;
  for (const double sigma : {left, 0.5 * left, 3. * left}) {
    settings.noise = {sigma, 5.};
    const auto shared = fitAll(made.pixels, made.scene.plane(), made.pattern, settings);
    ASSERT_TRUE(shared);
    const double share = std::min(1., std::pow(sigma / left, 2.));
    const double expected = 1. + share * 4. * 2. * blur / std::hypot(blur, 1.47);
    EXPECT_NEAR(shared->sharing, expected, 1e-6 * expected);
    EXPECT_TRUE(shared->covariance.isApprox(expected * independent->covariance, 1e-6));
    EXPECT_EQ(shared->squares, independent->squares);
  }
}

// The decrement is what another step takes off the squares. In normal noise it is 0.762 / 0.915 of that, by what the
// weights change on the way, to first order.
TEST(FitConclusion, DecrementIsWhatIsLeftToGain)
{
  Random random = randomOfTest();
  constexpr int count = 30;
  double ratio = 0.;
  for (int i = 0; i < count; ++i) {
    Case made = markerOf(80., random);
    fillFromModel(made, Light(), BlurParameters(), 2., random);
    FitSettings settings = modelSettings();
    settings.convergence = 0.01;
    const auto best = fitAll(made.pixels, made.scene.plane(), made.pattern, settings);
    ASSERT_TRUE(best);
    MarkerPlane beside = best->plane; // by three standard deviations of the place across
    beside.center.x() += 3. * std::sqrt(best->covariance(0, 0));
    settings.mostIterations = 0; // both are judged at one noise
    FitMemory memory;
    const auto judged = [&](const MarkerPlane &plane) {
      return fitPose(made.pixels, {plane, best->photometry, best->noise}, made.pattern, settings, memory);
    };
    const auto end = judged(best->plane);
    const auto start = judged(beside);
    ASSERT_TRUE(end && start);
    ratio += start->decrement / (start->squares - end->squares) / count;
    EXPECT_LT(end->decrement, 0.1 * start->decrement);
  }
  RecordProperty("ratio", std::to_string(ratio));
  EXPECT_NEAR(ratio, 0.762 / 0.915, 0.05);
}
