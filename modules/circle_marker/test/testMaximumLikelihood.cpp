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
 * The maximum-likelihood fit: exact on the model's own images, its covariance true, occluders without weight.
 */

#include "testFitTools.h"

#include <Eigen/Geometry>

using namespace circle_marker;
using namespace fit_test;
using namespace room_test;

TEST(MaximumLikelihood, ExactOnTheModelsOwnImages)
{
  Random random = randomOfTest();
  const vpImage<unsigned char> I(side, side, 0);
  for (const vpCircleMarkerFamily::vpType type : families) {
    const vpCircleMarkerFamily family(type);
    for (int i = 0; i < 20; ++i) {
      const int id = randomId(random, family);
      // From 12 degrees on, so that the truth is the only minimum near the start.
      Case made =
          makeCase(markerScene(random, family, id, uniform(random, 40., 90.), uniform(random, 0.2, 0.9), side), id, I);
      Light light;
      light.level = uniform(random, 100., 230.); // below 255 at the brighter end
      light.gradient = Eigen::Vector2d(uniform(random, -20., 20.), uniform(random, -20., 20.));
      light.contrast = uniform(random, 0.4, 0.95);
      BlurParameters blur;
      blur.sigma = uniform(random, 0.6, 1.2);
      blur.elongation = Eigen::Vector2d(uniform(random, -0.2, 0.2), uniform(random, -0.2, 0.2));
      fillFromModel(made, light, blur, 0., random);
      FitSettings settings = settingsOf(family);
      settings.exactBends = false;   // the images are made of parabolas
      settings.convergence = 0.0003; // with noise less would do; here it would be the largest error
      settings.mostIterations = 100;
      const auto fit = fitAll(made.pixels, disturbed(made.scene.plane(), random, 0.03), made.pattern, settings);
      ASSERT_TRUE(fit);
      const MarkerPlane truth = made.scene.plane();
      // The priors of gradient and elongation pull a little, and gamma, the least well known of all, gives way.
      EXPECT_LT((fit->plane.center - truth.center).norm() / truth.center.z(), 1e-6)
          << family.getName() << " tilt " << std::acos(truth.rotation(2, 2));
      EXPECT_LT((fit->plane.rotation.col(2) - truth.rotation.col(2)).norm(), 2e-6) << family.getName();
      if (family.isCoded()) {
        EXPECT_LT((fit->plane.rotation - truth.rotation).norm(), 2e-6) << family.getName();
      }
      EXPECT_NEAR(fit->photometry.white, light.level, 2e-3);
      EXPECT_NEAR(fit->photometry.contrast(), light.contrast, 2e-5);
      EXPECT_NEAR(fit->photometry.gamma, 1., 3e-3);
      EXPECT_LT((fit->photometry.gamma * light.level * fit->photometry.lightGradient - light.gradient).norm(), 5e-3);
      EXPECT_NEAR(fit->photometry.blur.sigma, blur.sigma, 1e-4);
      EXPECT_LT((fit->photometry.blur.elongation - blur.elongation).norm(), 2e-4);
      EXPECT_NEAR(fit->photometry.blur.spread, 0., 3e-5);
      EXPECT_GT(fit->correlation, 0.999999);
      EXPECT_GT(fit->inliers, 0.99);
    }
  }
}

namespace {
//! Mean of Mahalanobis distances squared over 200 fits of the model's own images with noise.
double meanMahalanobis(const vpCircleMarkerFamily &family, double diameter, Random &random, double &noise)
{
  constexpr int count = 200;
  const vpImage<unsigned char> I(side, side, 0);
  double sum = 0.;
  noise = 0.;
  for (int i = 0; i < count; ++i) {
    const int id = randomId(random, family);
    Case made = makeCase(markerScene(random, family, id, diameter, uniform(random, 0.35, 0.9), side), id, I);
    fillFromModel(made, Light(), BlurParameters(), 2., random);
    const auto fit = fitAll(made.pixels, disturbed(made.scene.plane(), random, 0.01), made.pattern, settingsOf(family));
    EXPECT_TRUE(fit);
    if (!fit) {
      return HUGE_VAL;
    }
    sum += mahalanobis(*fit, made.scene.plane(), family.isCoded());
    noise += fit->noise / count;
  }
  return sum / count;
}
} // namespace

TEST(MaximumLikelihood, CovarianceIsTrue)
{
  Random random = randomOfTest();
  for (const vpCircleMarkerFamily::vpType type : families) {
    const vpCircleMarkerFamily family(type);
    const double freedom = family.isCoded() ? 6. : 5.;
    double noise = 0.;
    const double mean = meanMahalanobis(family, 50., random, noise);
    // The mean of 200 chi-square variables has the variance 2 freedom / 200; 3.5 of its standard deviations.
    const double slack = 3.5 * std::sqrt(2. * freedom / 200.);
    EXPECT_GT(mean, freedom - slack) << family.getName();
    EXPECT_LT(mean, freedom + slack) << family.getName();
    EXPECT_NEAR(noise, 2., 0.06) << family.getName();
  }
}

TEST(MaximumLikelihood, CovarianceIsTrueOnDrawnImages)
{
  // Drawn, rounded and noisy images: what the model leaves out must be small beside the noise.
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  constexpr int count = 100;
  double sum = 0.;
  for (int i = 0; i < count; ++i) {
    const int id = randomId(random, family);
    const MarkerScene scene = markerScene(random, family, id, 60., uniform(random, 0.35, 0.9), side);
    const Case made = makeCase(scene, id, digitise(expose(side, side, 0.7, scene), 2., random));
    const auto fit = fitAll(made.pixels, disturbed(scene.plane(), random, 0.01), made.pattern, settingsOf(family));
    ASSERT_TRUE(fit);
    sum += mahalanobis(*fit, scene.plane(), true);
  }
  const double slack = 3.5 * std::sqrt(12. / count);
  EXPECT_GT(sum / count, 6. - slack);
  EXPECT_LT(sum / count, 6. + slack);
}

TEST(MaximumLikelihood, OccludedPixelsHaveNoWeight)
{
  Random random = randomOfTest();
  const vpImage<unsigned char> I(side, side, 0);
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  constexpr int trials = 40;
  double sum = 0.;
  for (int i = 0; i < trials; ++i) {
    const int id = randomId(random, family);
    Case made = makeCase(markerScene(random, family, id, 70., uniform(random, 0.3, 0.8), side), id, I);
    fillFromModel(made, Light(), BlurParameters(), 2., random);
    // A stripe across the print, of a grey that neither paper nor ink has, covers a part of it.
    const double direction = uniform(random, 0., 2. * M_PI);
    const double where = uniform(random, 0.7, 0.9);
    std::vector<FitPixel> uncovered;
    for (FitPixel &pixel : made.pixels) {
      if (pixel.offset.x() * std::cos(direction) + pixel.offset.y() * std::sin(direction) > where) {
        pixel.grey = 110.f;
      }
      else {
        uncovered.push_back(pixel);
      }
    }
    const MarkerPlane start = disturbed(made.scene.plane(), random, 0.005);
    const auto all = fitAll(made.pixels, start, made.pattern, settingsOf(family));
    const auto seen = fitAll(uncovered, start, made.pattern, settingsOf(family));
    ASSERT_TRUE(all && seen);
    // The covered pixels of a blurred edge that happen to look right do count: a fifth of a standard deviation, and in
    // one of 100 such stripes (of 600 that were looked at) 0.6 to 0.8 of it.
    const Eigen::Matrix<double, 6, 1> e = errorOf(all->plane, seen->plane);
    const double squared = e.dot(seen->covariance.inverse() * e);
    EXPECT_LT(squared, 6.) << "covered beyond " << where;
    sum += squared;
    EXPECT_NEAR(all->inliers, seen->inliers * static_cast<double>(uncovered.size()) / made.pixels.size(), 0.05);
    EXPECT_NEAR(all->noise, 2., 0.3);
  }
  EXPECT_LT(sum / trials, 6. * 0.3 * 0.3);
}

TEST(MaximumLikelihood, WithoutIterationsTheStartIsOnlyJudged)
{
  Random random = randomOfTest();
  const vpImage<unsigned char> I(side, side, 0);
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  Case made = makeCase(markerScene(random, family, 9, 70., 0.5, side), 9, I);
  fillFromModel(made, Light(), BlurParameters(), 1., random);
  FitSettings settings = settingsOf(family);
  settings.mostIterations = 0;
  const MarkerPlane start = disturbed(made.scene.plane(), random, 0.01);
  const auto fit = fitAll(made.pixels, start, made.pattern, settings);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->plane.center, start.center);
  EXPECT_EQ(fit->plane.rotation, start.rotation);
  const auto truth = fitAll(made.pixels, made.scene.plane(), made.pattern, settings);
  ASSERT_TRUE(truth);
  EXPECT_GT(truth->correlation, fit->correlation);
  FitMemory memory;
  EXPECT_LT(robustSquares(made.pixels, *truth, made.pattern, truth->photometry, 1., true, memory),
            robustSquares(made.pixels, *fit, made.pattern, truth->photometry, 1., true, memory));
}

// The first steps lower the noise, by which all residuals are large: who is behind then is not yet beaten.
TEST(MaximumLikelihood, ARivalIsNoReasonToGiveUpEarly)
{
  Random random = randomOfTest();
  const vpImage<unsigned char> I(side, side, 0);
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::BCH31);
  int givenUp = 0;
  for (int i = 0; i < 40; ++i) {
    const int id = randomId(random, family);
    Case made = makeCase(markerScene(random, family, id, uniform(random, 20., 60.), 0.6, side), id, I);
    BlurParameters blur;
    blur.sigma = 1.1;
    fillFromModel(made, Light(), blur, 1.5, random);
    FitSettings settings = settingsOf(family);
    settings.exactBends = false;
    const auto best = fitAll(made.pixels, made.scene.plane(), made.pattern, settings);
    ASSERT_TRUE(best);
    settings.rival = Rival{best->squares, best->scale, 90.};
    const auto other = fitAll(made.pixels, disturbed(made.scene.plane(), random, 0.08), made.pattern, settings);
    ASSERT_TRUE(other);
    EXPECT_LT(other->squares, 1.05 * best->squares) << "image " << i; // each is judged by its own noise
    EXPECT_TRUE(other->isSettled);
    // Another code has no chance, and needs not go to its end.
    const MarkerPattern others = patternOf(family, (id + 1) % static_cast<int>(family.getNbIds()));
    const auto wrong = fitAll(made.pixels, made.scene.plane(), others, settings);
    givenUp += wrong && !wrong->isSettled ? 1 : 0;
  }
  EXPECT_GT(givenUp, 30);
}

TEST(MaximumLikelihood, SpinStaysWithoutACode)
{
  Random random = randomOfTest();
  const vpImage<unsigned char> I(side, side, 0);
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::RING);
  for (int i = 0; i < 10; ++i) {
    Case made = makeCase(markerScene(random, family, -1, 70., uniform(random, 0.2, 0.8), side), -1, I);
    fillFromModel(made, Light(), BlurParameters(), 2., random);
    const MarkerPlane start = disturbed(made.scene.plane(), random, 0.01);
    const auto fit = fitAll(made.pixels, start, made.pattern, settingsOf(family));
    ASSERT_TRUE(fit);
    const Eigen::AngleAxisd change(Eigen::Matrix3d(fit->plane.rotation * start.rotation.transpose()));
    EXPECT_LT(std::fabs(change.angle() * change.axis().dot(fit->plane.rotation.col(2))), 1e-3);
    const Eigen::Vector3d n = fit->plane.rotation.col(2);
    const double spinVariance = n.dot(fit->covariance.bottomRightCorner<3, 3>() * n);
    EXPECT_LT(spinVariance, 1e-7);
    EXPECT_GE(spinVariance, -1e-15); // 0, to rounding
  }
}

TEST(MaximumLikelihood, EveryThirdPixelWillDo)
{
  // A third of the pixels gives a covariance wider by the root of 3.
  Random random = randomOfTest();
  const vpImage<unsigned char> I(side, side, 0);
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  // Without the coherence, which one image in 100 has by chance: it widens the covariance, too.
  FitSettings settings = settingsOf(family);
  settings.exactBends = false;
  for (int i = 0; i < 10; ++i) {
    Case made = makeCase(markerScene(random, family, 9, 80., uniform(random, 0.3, 0.8), side), 9, I);
    fillFromModel(made, Light(), BlurParameters(), 2., random);
    const MarkerPlane truth = made.scene.plane();
    const auto all = fitAll(made.pixels, truth, made.pattern, settings);
    std::vector<FitPixel> thinned;
    for (std::size_t k = 0; k < made.pixels.size(); k += 3) {
      thinned.push_back(made.pixels[k]);
    }
    const auto third = fitAll(thinned, truth, made.pattern, settings);
    ASSERT_TRUE(all && third);
    EXPECT_NEAR(std::sqrt(third->covariance(2, 2) / all->covariance(2, 2)), std::sqrt(3.), 0.35);
    EXPECT_LT(mahalanobis(*third, truth, true), 40.9);
    // From where another fit ended there is nothing left to do.
    FitMemory memory;
    const auto again = fitPose(made.pixels, {all->plane, all->photometry, all->noise}, made.pattern, settings, memory);
    ASSERT_TRUE(again);
    const Eigen::Matrix<double, 6, 1> e = errorOf(again->plane, all->plane);
    EXPECT_LT(e.dot(all->covariance.inverse() * e), 6. * 0.1 * 0.1);
  }
}

TEST(MaximumLikelihood, RefusesWhatIsNoImageOfIt)
{
  Random random = randomOfTest();
  const vpImage<unsigned char> I(side, side, 0);
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  Case made = makeCase(markerScene(random, family, 9, 70., 0.5, side), 9, I);
  // Inverted: no positive contrast explains it.
  fillFromModel(made, Light(), BlurParameters(), 0., random);
  for (FitPixel &pixel : made.pixels) {
    pixel.grey = 255.f - pixel.grey;
  }
  EXPECT_FALSE(fitAll(made.pixels, made.scene.plane(), made.pattern, settingsOf(family)));
  // Black all over, and too few pixels.
  for (FitPixel &pixel : made.pixels) {
    pixel.grey = 0.f;
  }
  EXPECT_FALSE(fitAll(made.pixels, made.scene.plane(), made.pattern, settingsOf(family)));
  fillFromModel(made, Light(), BlurParameters(), 0., random);
  made.pixels.resize(20);
  EXPECT_FALSE(fitAll(made.pixels, made.scene.plane(), made.pattern, settingsOf(family)));
  made.pixels.clear();
  EXPECT_FALSE(fitAll(made.pixels, made.scene.plane(), made.pattern, settingsOf(family)));
}

TEST(MaximumLikelihood, CovarianceGrowsWhereNeighboursPullTogether)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  const vpImage<unsigned char> I(side, side, 0);
  double independent = 0., together = 0.;
  constexpr int trials = 10;
  for (int i = 0; i < trials; ++i) {
    Case made =
        makeCase(markerScene(random, family, 7, uniform(random, 50., 90.), uniform(random, 0.2, 0.6), side), 7, I);
    BlurParameters blur;
    blur.sigma = 0.8;
    FitSettings settings = settingsOf(family);
    const auto varianceOf = [&](bool judged) {
      settings.exactBends = judged;
      const auto fit = fitAll(made.pixels, made.scene.plane(), made.pattern, settings);
      return fit->covariance.trace() / (fit->noise * fit->noise);
    };
    fillFromModel(made, Light(), blur, 2., random);
    independent += varianceOf(true) / varianceOf(false) / trials;
    // A wave over the marker that no parameter explains, as large as the noise.
    for (FitPixel &pixel : made.pixels) {
      pixel.grey += 3.f * std::cos(6.f * pixel.offset.x() + 2.f * pixel.offset.y());
    }
    together += varianceOf(true) / varianceOf(false) / trials;
  }
  EXPECT_GT(independent, 0.96); // the noise at edges is told by itself, each time to some 5 %
  EXPECT_LT(independent, 1.1);
  EXPECT_GT(together, 2.);
}
