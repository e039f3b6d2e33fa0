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
 * Test of the detector on images that a camera has sharpened: edges are overdone, which the model does not know.
 */

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "detector_scenes.h"

using namespace detector_test;

namespace {
// Unsharp mask: the image, and so many times what a Gaussian takes from it.
vpImage<unsigned char> sharpened(const vpImage<unsigned char> &I, double amount, double sigma)
{
  const int reach = static_cast<int>(std::ceil(4. * sigma));
  std::vector<double> kernel;
  double sum = 0.;
  for (int k = -reach; k <= reach; ++k) {
    kernel.push_back(std::exp(-0.5 * k * k / (sigma * sigma)));
    sum += kernel.back();
  }
  const int rows = static_cast<int>(I.getHeight());
  const int columns = static_cast<int>(I.getWidth());
  const auto inside = [](int place, int count) {
    return static_cast<unsigned int>(std::min(std::max(place, 0), count - 1));
  };
  vpImage<double> across(I.getHeight(), I.getWidth());
  for (int v = 0; v < rows; ++v) {
    for (int u = 0; u < columns; ++u) {
      double mean = 0.;
      for (int k = -reach; k <= reach; ++k) {
        mean += kernel[static_cast<std::size_t>(k + reach)] / sum * I[inside(v, rows)][inside(u + k, columns)];
      }
      across[inside(v, rows)][inside(u, columns)] = mean;
    }
  }
  vpImage<unsigned char> result(I.getHeight(), I.getWidth());
  for (int v = 0; v < rows; ++v) {
    for (int u = 0; u < columns; ++u) {
      double mean = 0.;
      for (int k = -reach; k <= reach; ++k) {
        mean += kernel[static_cast<std::size_t>(k + reach)] / sum * across[inside(v + k, rows)][inside(u, columns)];
      }
      const double grey = I[inside(v, rows)][inside(u, columns)];
      result[inside(v, rows)][inside(u, columns)] =
          static_cast<unsigned char>(std::lround(std::min(std::max(grey + amount * (grey - mean), 0.), 255.)));
    }
  }
  return result;
}

struct Honesty
{
  double squared = 0.; // mean Mahalanobis distance^2 by degrees of freedom
  unsigned int found = 0;
  double wrongOdds = 0.; // greatest log-odds of a pose that is the mirrored one
};

Honesty honestyOf(const vpCircleMarkerFamily &family, double amount, double sigma, Random &random)
{
  constexpr int images = 40;
  vpDetectorCircleMarker detector(family);
  detector.setZAlignedWithCameraAxis(true);
  Honesty honesty;
  for (int i = 0; i < images; ++i) {
    const vpHomogeneousMatrix truth = randomPose(random, uniform(random, 40., 110.), uniform(random, 0.2, 1.));
    vpScenePhotometry photometry;
    photometry.noiseSigma = 1.;
    vpMarkerSceneSimulator simulator(straightCamera(), width, height);
    simulator.setPhotometry(photometry);
    simulator.setBackground(vpSceneBackground::plain(uniform(random, 80., 200.)));
    simulator.addMarker(printed(family, randomId(random, family)).setPose(truth));
    vpImage<unsigned char> I;
    simulator.render(I, random());
    std::vector<vpHomogeneousMatrix> cMo;
    if (!detector.detect(sharpened(I, amount, sigma), size, straightCamera(), cMo)) {
      continue;
    }
    const vpCircleMarkerDetection &detection = detector.getDetections()[0];
    const Eigen::Vector3d normal = rotationOf(truth).col(2);
    if (rotationOf(detection.cMo).col(2).dot(normal) < std::cos(0.15)) {
      honesty.wrongOdds = std::max(honesty.wrongOdds, detection.logOdds);
      continue;
    }
    ++honesty.found;
    honesty.squared += mahalanobis(truth, detection.cMo, detection.covariance, detection.dof) / detection.dof;
  }
  honesty.squared /= std::max(honesty.found, 1u);
  return honesty;
}
} // namespace

TEST(DetectorHalo, ImagesThatAreNotSharpened)
{
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::RING}) {
    const Honesty honesty = honestyOf(type, 0., 1., random);
    EXPECT_EQ(honesty.found, 40u);
    EXPECT_LT(honesty.squared, 1.3);
    EXPECT_GT(honesty.squared, 0.75) << "the covariance is no larger for it";
  }
}

// Without the halo they were 1.5 to 8 times too sure. By more than twice they are not to be.
TEST(DetectorHalo, TheCovarianceKnowsOfIt)
{
  constexpr double twice = 4.; // of standard deviations, squared
  Random random = randomOfTest();
  for (const double sigma : {1., 2.}) {
    const Honesty code = honestyOf(vpCircleMarkerFamily::GOLAY23, 1., sigma, random);
    EXPECT_LT(code.squared, twice) << sigma;
    EXPECT_GE(code.found, sigma > 1. ? 36u : 39u) << sigma;
    const Honesty ring = honestyOf(vpCircleMarkerFamily::RING, 1., sigma, random);
    EXPECT_LT(ring.squared, twice) << sigma;
    EXPECT_GE(ring.found, 39u) << sigma;
    EXPECT_LT(std::max(code.wrongOdds, ring.wrongOdds), 5.) << sigma;
    const std::string of = " of a mask of " + std::to_string(static_cast<int>(sigma)) + " pixels";
    RecordProperty("golay23" + of, std::to_string(code.squared) + ", found " + std::to_string(code.found));
    RecordProperty("ring" + of, std::to_string(ring.squared) + ", found " + std::to_string(ring.found));
  }
}
