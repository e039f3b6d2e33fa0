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

#include "../../modules/circle_marker/test/testSharpening.h"
#include "detector_scenes.h"

using namespace detector_test;
using sharpening_test::sharpened;

namespace {
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

// What the camera sharpened is undone before markers are measured. Taken for a Gaussian's edges, those poses were 1.5
// to 8 times too sure of themselves.
TEST(DetectorHalo, SharpenedImagesAreMeasuredAsOthers)
{
  Random random = randomOfTest();
  const auto measure = [&](vpCircleMarkerFamily::vpType type, double amount, double sigma) {
    const Honesty honesty = honestyOf(vpCircleMarkerFamily(type), amount, sigma, random);
    const std::string what = vpCircleMarkerFamily(type).getName() + " of " + std::to_string(static_cast<int>(amount)) +
                             " times, " + std::to_string(static_cast<int>(sigma)) + " pixels";
    RecordProperty(what, std::to_string(honesty.squared) + ", found " + std::to_string(honesty.found) + ", odds " +
                             std::to_string(honesty.wrongOdds));
    EXPECT_LT(honesty.squared, 1.5) << what;
    EXPECT_GE(honesty.found, 36u) << what;
    EXPECT_LT(honesty.wrongOdds, 5.) << what;
  };
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::RING}) {
    measure(type, 1., 1.);
    measure(type, 1., 2.);
    measure(type, 2., 2.);
  }
}
