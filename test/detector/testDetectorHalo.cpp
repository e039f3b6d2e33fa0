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
#include <sstream>
#include <string>
#include <utility>

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

constexpr int images = 40;

//! diameters: least and greatest, pixels.
Honesty honestyOf(const vpCircleMarkerFamily &family, double amount, double sigma, Random &random,
                  const std::pair<double, double> &diameters = {40., 110.})
{
  vpDetectorCircleMarker detector(family);
  detector.setZAlignedWithCameraAxis(true);
  Honesty honesty;
  for (int i = 0; i < images; ++i) {
    const vpHomogeneousMatrix truth =
        randomPose(random, uniform(random, diameters.first, diameters.second), uniform(random, 0.2, 1.));
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

namespace {
//! What sharpened images of a family are measured like, by name, as it is recorded.
struct Sharpened
{
  Honesty honesty;
  std::string what;
};

Sharpened sharpenedBy(vpCircleMarkerFamily::vpType type, double amount, double sigma, Random &random,
                      const std::pair<double, double> &diameters)
{
  const vpCircleMarkerFamily family(type);
  std::ostringstream what;
  what << family.getName() << " of " << diameters.first << " pixels, " << amount << " times, " << sigma << " pixels";
  return {honestyOf(family, amount, sigma, random, diameters), what.str()};
}

std::string recorded(const Honesty &honesty)
{
  return std::to_string(honesty.squared) + ", found " + std::to_string(honesty.found) + ", odds " +
         std::to_string(honesty.wrongOdds);
}
} // namespace

// What the camera sharpened is undone before markers are measured. Taken for a Gaussian's edges, those poses were 1.5
// to 8 times too sure of themselves; and codes whose halos were cut off at both ends of the grey levels, one in ten of
// 40 to 60 pixels, 50 times.
TEST(DetectorHalo, SharpenedImagesAreMeasuredAsOthers)
{
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::RING}) {
    for (const auto &[amount, sigma] : {std::pair<double, double>(1., 1.), {1., 2.}, {2., 2.}}) {
      const auto [honesty, what] = sharpenedBy(type, amount, sigma, random, {40., 110.});
      RecordProperty(what, recorded(honesty));
      EXPECT_LT(honesty.squared, 1.5) << what;
      EXPECT_GE(honesty.found, 36u) << what;
      EXPECT_LT(honesty.wrongOdds, 5.) << what;
    }
  }
}

// Small markers have no ring that is wide enough for a halo: all of their pixels tell the mask.
TEST(DetectorHalo, SoAreSmallMarkersInSharpenedImages)
{
  Random random = randomOfTest();
  for (const auto &[amount, sigma] : {std::pair<double, double>(0.5, 1.), {1., 1.}, {0.5, 2.}, {1., 2.}}) {
    const auto [honesty, what] = sharpenedBy(vpCircleMarkerFamily::GOLAY23, amount, sigma, random, {20., 40.});
    RecordProperty(what, recorded(honesty));
    EXPECT_LT(honesty.squared, 1.5) << what;
    EXPECT_GE(honesty.found, 38u) << what;
    EXPECT_LT(honesty.wrongOdds, 5.) << what;
  }
  const auto [honesty, what] = sharpenedBy(vpCircleMarkerFamily::RING, 1., 1., random, {20., 40.});
  RecordProperty(what, recorded(honesty));
  EXPECT_LT(honesty.squared, 1.5) << what;
  EXPECT_GE(honesty.found, 38u) << what;
}
