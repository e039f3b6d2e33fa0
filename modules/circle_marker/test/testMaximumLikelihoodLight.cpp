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
 * Test of fits under motion, a shadow and too much light.
 */

#include "testFitTools.h"

using namespace circle_marker;
using namespace fit_test;
using namespace room_test;

// Ink that takes nearly all light, and a camera whose gamma makes a visible grey of what it leaves: on the way there a
// fit from the light of the image, whose gamma is 1, passes through ink that takes more than all.
TEST(MaximumLikelihoodLight, InkThatIsNearlyBlack)
{
  Random random = randomOfTest();
  const vpImage<unsigned char> I(side, side, 0);
  constexpr double noise = 2.;
  constexpr int count = 40;
  for (const vpCircleMarkerFamily::vpType type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::RING}) {
    const vpCircleMarkerFamily family(type);
    for (const double contrast : {0.97, 0.985, 0.995}) {
      double sum = 0.;
      for (int i = 0; i < count; ++i) {
        const int id = randomId(random, family);
        Case made = makeCase(
            markerScene(random, family, id, uniform(random, 50., 90.), uniform(random, 0.3, 0.9), side), id, I);
        Light light;
        light.level = 220.;
        light.contrast = contrast;
        light.gamma = 0.45;
        fillFromModel(made, light, BlurParameters(), noise, random);
        const auto fit =
            fitAll(made.pixels, disturbed(made.scene.plane(), random, 0.01), made.pattern, settingsOf(family));
        ASSERT_TRUE(fit);
        EXPECT_LT(fit->noise, 1.2 * noise) << contrast;
        sum += mahalanobis(*fit, made.scene.plane(), family.isCoded());
      }
      const double freedom = family.isCoded() ? 6. : 5.;
      EXPECT_LT(sum / count, 1.1 * freedom + 3.5 * std::sqrt(2. * freedom / count)) << family.getName() << contrast;
    }
  }
}

// Ink that is darker than the sensor tells: where it is cut off no noise is seen, and what is left there is none.
TEST(MaximumLikelihoodLight, InkThatIsCutOffTellsNothingOfTheNoise)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  constexpr double noise = 3.;
  constexpr int count = 40;
  double sum = 0.;
  for (int i = 0; i < count; ++i) {
    MarkerScene scene = markerScene(random, family, 5, uniform(random, 40., 60.), uniform(random, 0.3, 0.9), side);
    scene.white = 270.; // and paper is, too: edges alone are left
    scene.black = -60.;
    Case made = {scene, patternOf(family, 5), {}};
    const vpImage<unsigned char> I = digitise(expose(side, side, 0.7, scene), noise, random);
    const MarkerPlane plane = scene.plane();
    BlurParameters blur;
    blur.sigma = 0.8;
    selectPixels(I, CameraModel(scene.camera()), scene.frame(), &plane, 1, made.pattern, {blur, 0., 3000.},
                 made.pixels);
    const auto fit = fitAll(made.pixels, disturbed(plane, random, 0.01), made.pattern, settingsOf(family));
    ASSERT_TRUE(fit);
    EXPECT_GT(fit->noise, 0.7 * noise);
    sum += mahalanobis(*fit, plane, true);
  }
  EXPECT_LT(sum / count, 6. / 0.95 + 3.5 * std::sqrt(12. / count));
}

TEST(MaximumLikelihoodLight, MotionIsNoError)
{
  // Moved evenly by 3 pixels while the shutter is open: not the Gaussian that the model has, but nearly.
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  constexpr int count = 40;
  constexpr double moved = 3.;
  constexpr int steps = 6;
  double sum = 0.;
  for (int i = 0; i < count; ++i) {
    const int id = randomId(random, family);
    const MarkerScene scene = markerScene(random, family, id, 70., uniform(random, 0.35, 0.9), side);
    const double angle = uniform(random, 0., M_PI);
    vpImage<double> exposed(side, side, 0.);
    for (int step = 0; step < steps; ++step) {
      const double place = moved * ((step + 0.5) / steps - 0.5);
      const auto shifted = [&](double u, double v) {
        return scene(u + place * std::cos(angle), v + place * std::sin(angle));
      };
      const vpImage<double> still = expose(side, side, 0.7, shifted);
      for (unsigned int k = 0; k < exposed.getSize(); ++k) {
        exposed.bitmap[k] += still.bitmap[k] / steps;
      }
    }
    Case made = {scene, patternOf(family, id), {}};
    const vpImage<unsigned char> I = digitise(exposed, 2., random);
    const MarkerPlane plane = scene.plane();
    BlurParameters blur;
    blur.sigma = 1.2;
    selectPixels(I, CameraModel(scene.camera()), scene.frame(), &plane, 1, made.pattern, {blur, 0.3, 3000.},
                 made.pixels);
    const auto fit = fitAll(made.pixels, disturbed(plane, random, 0.01), made.pattern, settingsOf(family));
    ASSERT_TRUE(fit);
    sum += mahalanobis(*fit, plane, true);
    // Its variance 3^2 / 12 adds to that of the lens and the pixel in one direction.
    const double ratio = (0.49 + 1. / 12. + moved * moved / 12.) / (0.49 + 1. / 12.);
    const Eigen::Vector2d elongation =
        0.25 * std::log(ratio) * Eigen::Vector2d(std::cos(2. * angle), std::sin(2. * angle));
    EXPECT_LT((fit->photometry.blur.elongation - elongation).norm(), 0.05) << "angle " << angle;
  }
  // With round blur it is 20 and more.
  EXPECT_LT(sum / count, 6. / 0.95 + 3.5 * std::sqrt(12. / count));
}

// Poses are exact in the light to the power of gamma too, but for what the prior pulls.
TEST(MaximumLikelihoodLight, GammaIsFound)
{
  Random random = randomOfTest();
  const vpImage<unsigned char> I(side, side, 0);
  for (const vpCircleMarkerFamily::vpType type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::RING}) {
    const vpCircleMarkerFamily family(type);
    for (const double gamma : {0.45, 0.7, 1.5, 2.2}) {
      for (int i = 0; i < 10; ++i) {
        const int id = randomId(random, family);
        Case made = makeCase(
            markerScene(random, family, id, uniform(random, 50., 90.), uniform(random, 0.3, 0.9), side), id, I);
        Light light;
        light.level = uniform(random, 80., 160.); // below 255 at the brighter end
        light.gradient = 0.15 * light.level * Eigen::Vector2d(uniform(random, -1., 1.), uniform(random, -1., 1.));
        light.contrast = uniform(random, 0.6, 0.9);
        light.gamma = gamma;
        fillFromModel(made, light, BlurParameters(), 0., random);
        FitSettings settings = settingsOf(family);
        settings.exactBends = false; // the images are made of parabolas
        settings.convergence = 0.0003;
        settings.mostIterations = 300; // from a gamma of 1, which a low contrast hardly tells
        const auto fit = fitAll(made.pixels, disturbed(made.scene.plane(), random, 0.02), made.pattern, settings);
        ASSERT_TRUE(fit);
        const MarkerPlane truth = made.scene.plane();
        EXPECT_LT((fit->plane.center - truth.center).norm() / truth.center.z(), 2e-6) << gamma;
        EXPECT_LT((fit->plane.rotation.col(2) - truth.rotation.col(2)).norm(), 1e-5) << gamma;
        EXPECT_NEAR(std::log(fit->photometry.gamma / gamma), 0., 0.02);
        EXPECT_NEAR(fit->photometry.contrast(), 1. - std::pow(1. - light.contrast, gamma), 1e-4);
        EXPECT_NEAR(fit->photometry.whiteAt(Eigen::Vector2d(0.5, 0.5)),
                    light.level * std::pow(1. + 0.5 * light.gradient.sum() / light.level, gamma), 0.01);
      }
    }
  }
}

namespace {
struct GradientError
{
  double rms = 0.;    // grey levels
  double along = 0.;  // mean of what the fits have too much along the true gradient
  double chance = 0.; // standard deviation of that mean
};

//! Errors of the light's gradient on small rings in noise; steep: its size, grey levels.
GradientError errorOfGradient(double steep, Random &random)
{
  constexpr int count = 200;
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::RING);
  const vpImage<unsigned char> I(side, side, 0);
  std::vector<double> along;
  double squares = 0.;
  for (int i = 0; i < count; ++i) {
    Case made = makeCase(markerScene(random, family, -1, 20., uniform(random, 0.3, 0.9), side), -1, I);
    const double angle = uniform(random, 0., 2. * M_PI);
    const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
    Light light;
    light.gradient = steep * direction;
    fillFromModel(made, light, BlurParameters(), 10., random);
    const auto fit = fitAll(made.pixels, disturbed(made.scene.plane(), random, 0.01), made.pattern, settingsOf(family));
    if (fit) {
      const Eigen::Vector2d error =
          fit->photometry.gamma * light.level * fit->photometry.lightGradient - light.gradient;
      squares += error.squaredNorm();
      along.push_back(error.dot(direction));
    }
  }
  EXPECT_GT(along.size(), count * 9 / 10);
  GradientError error;
  const auto fits = static_cast<double>(along.size());
  error.rms = std::sqrt(squares / fits);
  error.chance = std::sqrt(0.5 * squares) / fits;
  for (const double one : along) {
    error.along += one / fits;
  }
  return error;
}
} // namespace

// The prior helps where the light is as even as it mostly is, and does not hold it back where it is not.
TEST(MaximumLikelihoodLight, LightIsThoughtEvenUntilItIsNot)
{
  Random random = randomOfTest();
  const GradientError even = errorOfGradient(0., random);
  const GradientError steep = errorOfGradient(60., random);
  EXPECT_LT(even.rms, 0.8 * steep.rms);
  EXPECT_LT(std::abs(steep.along), 3.5 * steep.chance);
}

// A start that expects dark ink is not led to bright ink on dark paper, which would correlate as well.
TEST(MaximumLikelihoodLight, NegativeOfAMarkerIsNone)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  const vpImage<unsigned char> I(side, side, 0);
  for (int i = 0; i < 20; ++i) {
    const int id = randomId(random, family);
    Case made = makeCase(markerScene(random, family, id, 60., uniform(random, 0.2, 0.9), side), id, I);
    fillFromModel(made, Light(), BlurParameters(), 2., random);
    for (FitPixel &pixel : made.pixels) {
      pixel.grey = 255.f - pixel.grey;
    }
    FitMemory memory;
    const FitStart start = {made.scene.plane(), Photometry(), std::nullopt};
    const auto fit = fitPose(made.pixels, start, made.pattern, settingsOf(family), memory);
    if (fit) {
      EXPECT_GT(fit->photometry.absorption, 0.);
      EXPECT_LT(fit->correlation, 0.5);
    }
  }
}

TEST(MaximumLikelihoodLight, ExactWhereThePaperIsOverExposed)
{
  Random random = randomOfTest();
  const vpImage<unsigned char> I(side, side, 0);
  for (const vpCircleMarkerFamily::vpType type : families) {
    const vpCircleMarkerFamily family(type);
    for (int i = 0; i < 10; ++i) {
      const int id = randomId(random, family);
      Case made =
          makeCase(markerScene(random, family, id, uniform(random, 50., 90.), uniform(random, 0.3, 0.9), side), id, I);
      Light light;
      light.level = uniform(random, 260., 400.);
      fillFromModel(made, light, BlurParameters(), 0., random);
      for (FitPixel &pixel : made.pixels) {
        pixel.grey = std::min(pixel.grey, 255.f);
      }
      FitSettings settings = settingsOf(family);
      settings.exactBends = false;
      settings.convergence = 0.003;
      settings.mostIterations = 200; // how bright the paper is is learnt slowly, from what is left of the edges
      const auto fit = fitAll(made.pixels, disturbed(made.scene.plane(), random, 0.01), made.pattern, settings);
      ASSERT_TRUE(fit) << family.getName() << " level " << light.level;
      const MarkerPlane truth = made.scene.plane();
      EXPECT_LT((fit->plane.center - truth.center).norm() / truth.center.z(), 1e-5) << family.getName() << light.level;
      EXPECT_LT((fit->plane.rotation.col(2) - truth.rotation.col(2)).norm(), 1e-5) << family.getName() << light.level;
      EXPECT_NEAR(fit->photometry.white, light.level, 0.5) << family.getName();
    }
  }
}

TEST(MaximumLikelihoodLight, ExactUnderTheEdgeOfAShadow)
{
  Random random = randomOfTest();
  const vpImage<unsigned char> I(side, side, 0);
  for (const vpCircleMarkerFamily::vpType type : families) {
    const vpCircleMarkerFamily family(type);
    for (int i = 0; i < 10; ++i) {
      const int id = randomId(random, family);
      Case made =
          makeCase(markerScene(random, family, id, uniform(random, 60., 90.), uniform(random, 0.2, 0.9), side), id, I);
      fillFromModel(made, Light(), BlurParameters(), 0., random);
      Shadow shadow;
      shadow.factor = uniform(random, 0.3, 0.7);
      shadow.direction = uniform(random, -M_PI, M_PI);
      shadow.edge = uniform(random, -0.3, 0.3);
      shadow.softness = uniform(random, 0.05, 0.15);
      for (FitPixel &pixel : made.pixels) {
        const Eigen::Vector2d offset = pixel.offset.cast<double>();
        const double beyond =
            (offset.dot(Eigen::Vector2d(std::cos(shadow.direction), std::sin(shadow.direction))) - shadow.edge) /
            shadow.softness;
        pixel.grey *= static_cast<float>(1. - (1. - shadow.factor) * 0.5 * std::erfc(-beyond * M_SQRT1_2));
      }
      FitSettings settings = settingsOf(family);
      settings.exactBends = false;
      settings.convergence = 0.003;
      settings.shadow = shadow;
      settings.shadow->factor += uniform(random, -0.05, 0.05);
      settings.shadow->direction += uniform(random, -0.05, 0.05);
      settings.shadow->edge += uniform(random, -0.03, 0.03);
      settings.shadow->softness = 0.08;
      const auto fit = fitAll(made.pixels, disturbed(made.scene.plane(), random, 0.01), made.pattern, settings);
      ASSERT_TRUE(fit && fit->photometry.shadow) << family.getName() << " " << i;
      const MarkerPlane truth = made.scene.plane();
      EXPECT_LT((fit->plane.center - truth.center).norm() / truth.center.z(), 2e-6) << family.getName() << " " << i;
      EXPECT_LT((fit->plane.rotation.col(2) - truth.rotation.col(2)).norm(), 5e-6) << family.getName() << " " << i;
      EXPECT_NEAR(fit->photometry.shadow->factor, shadow.factor, 1e-4);
      EXPECT_NEAR(wrapped(fit->photometry.shadow->direction - shadow.direction), 0., 1e-3);
      EXPECT_NEAR(fit->photometry.shadow->edge, shadow.edge, 1e-3);
      EXPECT_NEAR(fit->photometry.shadow->softness, shadow.softness, 1e-3);
      EXPECT_GT(fit->inliers, 0.99);
    }
  }
}
