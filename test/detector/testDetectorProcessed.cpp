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
 * Test of the detector on pictures whose pixels share their noise: of colour sensors, smoothed, enlarged.
 */

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "common/processed_picture.h"
#include "common/undistorted_picture.h"
#include "detector_scenes.h"

using namespace detector_test;
using common::Processing;

namespace {
Honesty honestyBehind(Processing processing, const vpCircleMarkerFamily &family, double noise,
                      const std::pair<double, double> &diameters, Random &random)
{
  HonestyScenes scenes(family);
  scenes.diameters = diameters;
  scenes.noise = noise;
  scenes.process = [processing](vpImage<unsigned char> &I, Random &) { process(processing, I); };
  scenes.camera = cameraOf(processing, straightCamera());
  return honestyOf(scenes, random);
}
} // namespace

// The covariance counts pixels that share their noise as fewer, and does not take the noise for what the model lacks.
// With the noise told as if it were independent, a half to a tenth of it, Mahalanobis^2 by degree of freedom was 0.02
// to 0.15 behind a smoothing and an enlarging, and 1.4 to 1.6 behind a colour sensor.
TEST(DetectorProcessed, CovariancesAreHonest)
{
  struct Row
  {
    vpCircleMarkerFamily::vpType family;
    Processing processing;
    double noise;                         // grey levels
    double leastSquared, greatestSquared; // mean Mahalanobis^2 by degree of freedom
  };
  Random random = randomOfTest();
  for (const Row &row : {Row{vpCircleMarkerFamily::GOLAY23, Processing::NONE, 2., 0.8, 1.3},
                         {vpCircleMarkerFamily::GOLAY23, Processing::DEMOSAICED, 2., 0.3, 1.5},
                         {vpCircleMarkerFamily::GOLAY23, Processing::DEMOSAICED, 8., 0.6, 1.5},
                         {vpCircleMarkerFamily::GOLAY23, Processing::SMOOTHED, 2., 0.6, 1.8},
                         {vpCircleMarkerFamily::GOLAY23, Processing::SMOOTHED, 8., 0.6, 1.5},
                         {vpCircleMarkerFamily::GOLAY23, Processing::ENLARGED, 8., 0.3, 1.5},
                         {vpCircleMarkerFamily::RING, Processing::DEMOSAICED, 8., 0.6, 1.5},
                         {vpCircleMarkerFamily::RING, Processing::SMOOTHED, 8., 0.5, 1.5}}) {
    const vpCircleMarkerFamily family(row.family);
    const Honesty honesty = honestyBehind(row.processing, family, row.noise, {40., 110.}, random);
    const std::string what = family.getName() + " processing " + std::to_string(static_cast<int>(row.processing)) +
                             " noise " + std::to_string(static_cast<int>(row.noise));
    RecordProperty(what, honesty.text());
    EXPECT_GE(honesty.found + honesty.mirrored, 39u) << what;
    EXPECT_GT(honesty.squared, row.leastSquared) << what;
    EXPECT_LT(honesty.squared, row.greatestSquared) << what;
    EXPECT_LT(honesty.wrongOdds, 5.) << what;
  }
}

// Codes that are read from few pixels have their odds from those that are independent: counted all, a golay23 of 14
// pixels behind a smoothing was another one with odds of e^50.
TEST(DetectorProcessed, SmallCodesAreProvenByIndependentPixels)
{
  Random random = randomOfTest();
  unsigned int found = 0;
  for (const Processing processing : {Processing::DEMOSAICED, Processing::SMOOTHED, Processing::ENLARGED}) {
    const Honesty honesty = honestyBehind(processing, vpCircleMarkerFamily::GOLAY23, 8., {12., 30.}, random);
    EXPECT_EQ(honesty.others, 0u) << static_cast<int>(processing);
    EXPECT_LT(honesty.squared, 2.) << static_cast<int>(processing);
    found += honesty.found + honesty.mirrored;
  }
  RecordProperty("found", std::to_string(found));
  EXPECT_GE(found, 80u); // of 120
}

// An undistorted picture's marker is where the straight camera sees it, to some hundredths of a pixel: the
// interpolation moves the edges by a hundredth, which no model has, and many pixels agree on. The covariance knows of
// it from the noise; without, the mean was 6.9.
TEST(DetectorProcessed, UndistortedPicturesAreMeasuredWithTheStraightCamera)
{
  constexpr int images = 40;
  constexpr double mostOff = 0.05; // pixels, of the marker's centre
  Random random = randomOfTest();
  vpDetectorCircleMarker detector(vpCircleMarkerFamily::GOLAY23);
  detector.setZAlignedWithCameraAxis(true);
  double squared = 0.;
  for (int i = 0; i < images; ++i) {
    vpCameraParameters camera = straightCamera();
    const double kdu = uniform(random, -0.15, 0.2);
    camera.initPersProjWithDistortion(camera.get_px(), camera.get_py(), camera.get_u0(), camera.get_v0(), -kdu, kdu);
    const vpHomogeneousMatrix truth = randomPose(random, uniform(random, 40., 110.), uniform(random, 0.2, 1.));
    vpScenePhotometry photometry;
    photometry.noiseSigma = 2.;
    vpMarkerSceneSimulator simulator(camera, width, height);
    simulator.setPhotometry(photometry);
    simulator.setBackground(vpSceneBackground::plain(120.));
    simulator.addMarker(printed(vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23), 7).setPose(truth));
    vpImage<unsigned char> I;
    simulator.render(I, random());
    common::undistort(camera, I);
    std::vector<vpHomogeneousMatrix> cMo;
    ASSERT_TRUE(detector.detect(I, size, common::straightened(camera), cMo)) << i;
    const vpCircleMarkerDetection &detection = detector.getDetections()[0];
    ASSERT_EQ(detection.id, 7);
    const Eigen::Vector3d there = translationOf(truth);
    const Eigen::Vector3d found = translationOf(detection.cMo);
    EXPECT_LT(focal * (found / found.z() - there / there.z()).norm(), mostOff);
    squared += mahalanobis(truth, detection.cMo, detection.covariance, detection.dof) / (images * detection.dof);
  }
  RecordProperty("squared", std::to_string(squared));
  EXPECT_GT(squared, 0.5);
  EXPECT_LT(squared, 1.4);
}
