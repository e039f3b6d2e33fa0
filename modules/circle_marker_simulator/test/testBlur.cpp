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
 * Blur of the simulated camera, against analytic profiles and a finer image.
 */

#include "test_support.h"

using namespace simulator_test;

namespace {

constexpr double PAPER = 220.;
constexpr double INK = 30.;

// A half-plane of ink: its edge runs through (u, v), with the ink on the side of `direction`. The ink is a picture of
// one black pixel, a metre wide; its other edges are far away.
vpMarkerSceneSimulator halfPlane(double u, double v, double direction, const vpScenePhotometry &photometry)
{
  const vpCameraParameters cam = pinhole(40, 40, 1000.);
  const vpImage<unsigned char> black(1, 1, 0);
  vpMarkerSceneSimulator simulator(cam, 40, 40);
  simulator.setPhotometry(photometry);
  simulator.setBackground(vpSceneBackground::plain(PAPER));
  const double x = (u - 19.5) / 1000. + 0.5 * std::cos(direction);
  const double y = (v - 19.5) / 1000. + 0.5 * std::sin(direction);
  simulator.addMarker(vpSimulatedMarker::bitmap(black, 1., 1.).setPose(tiltedPose(x, y, 1., 0., 0., direction)));
  return simulator;
}

// Mean of a profile, a function of the distance into the ink, over the square of the pixel (j, i): midpoint rule.
double overPixel(const std::function<double(double)> &profile, double u, double v, double direction, double j, double i)
{
  constexpr int n = 100;
  double sum = 0.;
  for (int k = 0; k < n * n; ++k) {
    const double x = j - 0.5 + (k % n + 0.5) / n;
    const double y = i - 0.5 + (k / n + 0.5) / n;
    sum += profile((x - u) * std::cos(direction) + (y - v) * std::sin(direction));
  }
  return sum / (n * n);
}

} // namespace

TEST(Blur, EdgeHasTheProfileOfANormalDistribution)
{
  std::mt19937_64 random = seededFromTestName();
  for (const double sigma : {0.3, 0.7, 1.5}) {
    for (const double direction : {0., M_PI / 2., 0.3, 2.2, 4.}) {
      vpScenePhotometry photometry = idealSensor();
      photometry.blurSigma = sigma;
      const double u = uniform(random, 18., 20.), v = uniform(random, 18., 20.);
      vpImage<float> I;
      halfPlane(u, v, direction, photometry).renderNoiseFree(I);
      const auto profile = [sigma](double d) {
        return PAPER + (INK - PAPER) * 0.5 * std::erfc(-d / (sigma * M_SQRT2));
      };
      for (unsigned int i = 10; i < 30; ++i) {
        for (unsigned int j = 10; j < 30; ++j) {
          // The midpoint rule errs by (1/100)^2 / 24 times the second derivative, at most 190 x 0.24 / 0.3^2: 0.002.
          ASSERT_NEAR(I[i][j], overPixel(profile, u, v, direction, j, i), 4e-3)
              << "sigma " << sigma << " direction " << direction << " pixel (" << j << ", " << i << ")";
        }
      }
    }
  }
}

TEST(Blur, EdgeHasTheProfileOfADefocusDisc)
{
  std::mt19937_64 random = seededFromTestName();
  const double radius = 2.3;
  for (const double direction : {0., M_PI / 2., 0.3, 2.2, 4.}) {
    vpScenePhotometry photometry = idealSensor();
    photometry.defocusRadius = radius;
    const double u = uniform(random, 18., 20.), v = uniform(random, 18., 20.);
    vpImage<float> I;
    halfPlane(u, v, direction, photometry).renderNoiseFree(I);
    // Share of a disc on one side of a chord at the distance d from its centre.
    const auto profile = [radius](double d) {
      const double t = std::min(std::max(d / radius, -1.), 1.);
      return PAPER + (INK - PAPER) * (0.5 + (t * std::sqrt(1. - t * t) + std::asin(t)) / M_PI);
    };
    for (unsigned int i = 10; i < 30; ++i) {
      for (unsigned int j = 10; j < 30; ++j) {
        ASSERT_NEAR(I[i][j], overPixel(profile, u, v, direction, j, i), 0.03)
            << "direction " << direction << " pixel (" << j << ", " << i << ")";
      }
    }
  }
}

namespace {

// A marker with something in front without blur in an image 16 times as fine, in the light `lightAt` (u, v, pixels of
// the coarse image), blurred there, and summed up over the pixels; and what the simulator makes of it.
void expectAsBlurredFinerImage(const std::optional<vpSceneShadow> &shadow,
                               const std::function<double(double, double)> &lightAt, double tolerance)
{
  constexpr int fine = 16;
  constexpr int size = 48;
  constexpr double sigma = 0.7;
  const vpHomogeneousMatrix cMo = tiltedPose(0.011, -0.013, 1., 0.6, 1., 0.4);
  const auto image = [&](int scale, double blur) {
    vpCameraParameters cam;
    const double u0 = scale * 23.5 + 0.5 * (scale - 1); // the middle of the same pixel
    cam.initPersProjWithoutDistortion(200. * scale, 200. * scale, u0, u0);
    vpMarkerSceneSimulator simulator(cam, size * scale, size * scale);
    vpScenePhotometry photometry = idealSensor();
    photometry.blurSigma = blur;
    if (scale == 1) {
      photometry.shadow = shadow;
    }
    simulator.setPhotometry(photometry);
    simulator.addMarker(vpSimulatedMarker::circle("golay23", 5, 0.16).setPose(cMo));
    const auto finer = [scale](double c) { return (c + 0.5) * scale - 0.5; }; // the same place in the finer image
    simulator.addOccluder(
        vpSceneOccluder::ellipse(vpImagePoint(finer(28.5), finer(30.5)), scale * 5., scale * 3., 0.5, 90.));
    vpImage<float> I;
    simulator.renderNoiseFree(I);
    return I;
  };
  const vpImage<float> coarse = image(1, sigma);
  vpImage<float> exact = image(fine, 0.);
  for (unsigned int i = 0; i < exact.getHeight(); ++i) {
    for (unsigned int j = 0; j < exact.getWidth(); ++j) {
      exact[i][j] *= static_cast<float>(lightAt((j + 0.5) / fine - 0.5, (i + 0.5) / fine - 0.5));
    }
  }
  // Along either axis: Gaussian over the fine pixels, then their sum over a pixel. The fine pixels' squares are no blur
  // of their own: side by side they make up the pixel's square.
  const double fineSigma = fine * sigma;
  const int reach = static_cast<int>(6. * fineSigma);
  std::vector<double> kernel(2 * reach + 1);
  for (int k = -reach; k <= reach; ++k) {
    kernel[k + reach] = std::exp(-0.5 * k * k / (fineSigma * fineSigma)) / (fineSigma * std::sqrt(2. * M_PI));
  }
  std::vector<double> response(2 * reach + fine, 0.); // to the fine pixels from -reach to fine - 1 + reach
  for (int f = 0; f < fine; ++f) {
    for (int k = -reach; k <= reach; ++k) {
      response[f + k + reach] += kernel[k + reach] / fine;
    }
  }
  for (int i = 6; i < size - 6; ++i) {
    for (int j = 6; j < size - 6; ++j) {
      double expected = 0.;
      for (int a = 0; a < static_cast<int>(response.size()); ++a) {
        double row = 0.;
        for (int b = 0; b < static_cast<int>(response.size()); ++b) {
          row += response[b] * exact[i * fine + a - reach][j * fine + b - reach];
        }
        expected += response[a] * row;
      }
      ASSERT_NEAR(coarse[i][j], expected, tolerance) << "pixel (" << j << ", " << i << ")";
    }
  }
}

} // namespace

TEST(Blur, MarkerIsTheBlurredFinerImage)
{
  expectAsBlurredFinerImage(
      std::nullopt, [](double, double) { return 1.; }, 0.02);
}

// Light falls on the print before the lens blurs both.
TEST(Blur, ShadowIsBlurredWithThePrint)
{
  for (const double penumbra : {0., 0.5, 2.}) {
    const vpSceneShadow shadow = {vpImagePoint(22., 25.), 0.7, 0.4, penumbra};
    const auto lightAt = [&](double u, double v) {
      const double beyond = (u - 25.) * std::cos(0.7) + (v - 22.) * std::sin(0.7);
      return penumbra > 0. ? 1. - 0.6 * 0.5 * std::erfc(-beyond / (penumbra * M_SQRT2)) : beyond > 0. ? 0.4 : 1.;
    };
    // The finer image has one light in each of its pixels: along an edge of the print it changes within them.
    expectAsBlurredFinerImage(shadow, lightAt, penumbra > 0. ? 0.1 : 1.);
  }
}

TEST(Blur, WithoutBlurAndWithTheLeastBlurAgree)
{
  const auto image = [](double sigma) {
    vpMarkerSceneSimulator simulator(pinhole(120, 100, 400.), 120, 100);
    vpScenePhotometry photometry = idealSensor();
    photometry.blurSigma = sigma;
    simulator.setPhotometry(photometry);
    simulator.addMarker(vpSimulatedMarker::circle("bch31", 7, 0.18).setPose(tiltedPose(0., 0., 1., 0.5, 2., 0.)));
    vpImage<float> I;
    simulator.renderNoiseFree(I);
    return I;
  };
  const vpImage<float> sharp = image(0.);
  const vpImage<float> least = image(0.05);
  // The blur moves light across a pixel's border by 0.05 / sqrt(2 pi) of a pixel at most, for each of its four sides.
  for (unsigned int k = 0; k < sharp.getSize(); ++k) {
    ASSERT_NEAR(sharp.bitmap[k], least.bitmap[k], 2. * 190. * 0.05 / std::sqrt(2. * M_PI));
  }
  EXPECT_THROW(image(0.01), vpException);
  EXPECT_THROW(image(-1.), vpException);
}

TEST(Blur, NothingIsLeftOverBesideAMarker)
{
  // Coverage is summed up along the rows: a leak would leave streaks to the right of the marker. A tenth of the
  // promised accuracy is what they may have.
  constexpr double tolerance = 0.01;
  vpMarkerSceneSimulator simulator(pinhole(640, 480, 800.), 640, 480);
  for (const double defocus : {0., 1.5}) {
    vpScenePhotometry photometry = idealSensor();
    photometry.blurSigma = 0.7;
    photometry.defocusRadius = defocus;
    simulator.setPhotometry(photometry);
    simulator.setBackground(vpSceneBackground::plain(110.));
    simulator.clearMarkers();
    // A big sheet around a small ring: the window reaches to the right, where there is only paper.
    simulator.addMarker(
        vpSimulatedMarker::circle("bch31", 7, 0.10).setSheetSide(0.4).setPose(tiltedPose(-0.05, 0., 1., 0.2, 2., 0.)));
    vpImage<float> I;
    simulator.renderNoiseFree(I);
    for (unsigned int i = 160; i < 320; ++i) {
      for (unsigned int j = 350; j < 420; ++j) {
        ASSERT_NEAR(I[i][j], 220., tolerance) << "defocus " << defocus << " pixel (" << j << ", " << i << ")";
      }
      ASSERT_NEAR(I[i][600], 110., tolerance);
    }
  }
}
