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
 * Covariances on simulated images: the squared Mahalanobis distances of true poses.
 */

#include "detector_scenes.h"

#include <numeric>

using namespace detector_test;

TEST(DetectorCovariance, OfThePose)
{
  // Mean of 60 squared Mahalanobis distances: 6, and 3.5 standard deviations of the mean to either side; above, the
  // 5 % that the biweight costs.
  Random random = randomOfTest();
  constexpr int count = 60;
  double sum = 0.;
  vpDetectorCircleMarker detector(vpCircleMarkerFamily::GOLAY23);
  detector.setZAlignedWithCameraAxis(true);
  for (int i = 0; i < count; ++i) {
    const vpHomogeneousMatrix truth = randomPose(random, uniform(random, 50., 120.), uniform(random, 0.4, 1.));
    std::vector<vpHomogeneousMatrix> cMo;
    ASSERT_TRUE(detector.detect(imageOf(printed(vpCircleMarkerFamily::GOLAY23, 7).setPose(truth), random), size,
                                straightCamera(), cMo));
    sum += mahalanobis(truth, cMo[0], detector.getCovariance(0), 6);
  }
  const double slack = 3.5 * std::sqrt(12. / count);
  EXPECT_GT(sum / count, 6. - slack);
  EXPECT_LT(sum / count, 6. / 0.95 + slack);
}

namespace {
//! Squared Mahalanobis distances of the poses of discs that were the true ones.
struct TruePoses
{
  std::vector<double> first;
  std::vector<double> second;
};

// One image of a disc has two poses, and in every other one the second is the true one.
TruePoses truePosesOfDiscs(bool refine, Random random)
{
  vpDetectorCircleMarker detector(vpCircleMarkerFamily::DISC);
  detector.setZAlignedWithCameraAxis(true);
  detector.setRefinePose(refine);
  TruePoses distances;
  for (int i = 0; i < 120; ++i) {
    const vpHomogeneousMatrix truth = randomPose(random, uniform(random, 50., 120.), uniform(random, 0.4, 1.));
    const vpImage<unsigned char> I = imageOf(printed(vpCircleMarkerFamily::DISC, -1).setPose(truth), random);
    std::vector<vpHomogeneousMatrix> cMo, cMo2;
    if (!detector.detect(I, size, straightCamera(), cMo, &cMo2) || !detector.getDetections()[0].hasSecondPose) {
      continue;
    }
    const vpCircleMarkerDetection &found = detector.getDetections()[0];
    const Eigen::Vector3d normal = rotationOf(truth).col(2);
    if (normal.dot(rotationOf(cMo[0]).col(2)) >= normal.dot(rotationOf(cMo2[0]).col(2))) {
      distances.first.push_back(mahalanobis(truth, cMo[0], found.covariance, 5));
    }
    else {
      distances.second.push_back(mahalanobis(truth, cMo2[0], found.covariance2, 5));
    }
  }
  return distances;
}

double meanOf(const std::vector<double> &values)
{
  return std::accumulate(values.begin(), values.end(), 0.) / static_cast<double>(values.size());
}
} // namespace

TEST(DetectorCovariance, OfTheSecondPose)
{
  const std::vector<double> distances = truePosesOfDiscs(true, randomOfTest()).second;
  ASSERT_GT(distances.size(), 30u);
  const double slack = 3.5 * std::sqrt(10. / static_cast<double>(distances.size())); // as above, of 5
  EXPECT_GT(meanOf(distances), 5. - slack);
  EXPECT_LT(meanOf(distances), 5. / 0.95 + slack);
}

TEST(DetectorCovariance, OfTheSecondPoseWithoutRefinement)
{
  // That of the closed form allows for what discs in a clear image do not have: as much for one pose as for the other.
  const TruePoses distances = truePosesOfDiscs(false, randomOfTest());
  ASSERT_GT(distances.first.size(), 30u);
  ASSERT_GT(distances.second.size(), 30u);
  EXPECT_NEAR(meanOf(distances.second), meanOf(distances.first), 0.4 * meanOf(distances.first));
  EXPECT_LT(meanOf(distances.second), 5. / 0.95);
}

TEST(DetectorCovariance, OfWhatFacesTheCamera)
{
  // The image tells the square of the lean from the line of sight: by the normal equations' covariance the mean is 11.
  // The bounds are four standard deviations of the mean of some 100 squared distances, which have longer tails here.
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::RING);
  vpDetectorCircleMarker detector(family);
  detector.setZAlignedWithCameraAxis(true);
  double sum = 0.;
  int count = 0;
  for (int i = 0; i < 300; ++i) {
    const vpHomogeneousMatrix truth = randomPose(random, uniform(random, 25., 35.), uniform(random, 0., 0.009));
    std::vector<vpHomogeneousMatrix> cMo, cMo2;
    ASSERT_TRUE(
        detector.detect(imageOf(printed(family, -1).setPose(truth), random), size, straightCamera(), cMo, &cMo2));
    const Eigen::Vector3d normal = rotationOf(truth).col(2);
    if (normal.dot(rotationOf(cMo[0]).col(2)) >= normal.dot(rotationOf(cMo2[0]).col(2))) {
      sum += mahalanobis(truth, cMo[0], detector.getCovariance(0), 5);
      ++count;
    }
  }
  EXPECT_GT(count, 80);
  EXPECT_GT(sum / count, 3.);
  EXPECT_LT(sum / count, 8.);
}

namespace {
//! Of the truth from the nearer of the first marker's poses: which of both it is, is not the matter here.
double distanceOfNearer(const vpHomogeneousMatrix &truth, const vpHomogeneousMatrix &cMo,
                        const vpHomogeneousMatrix &cMo2, const vpDetectorCircleMarker &detector)
{
  const double first = mahalanobis(truth, cMo, detector.getCovariance(0), 6);
  const bool hasSecond = detector.getDetections()[0].hasSecondPose;
  return hasSecond ? std::min(first, mahalanobis(truth, cMo2, detector.getCovariance(0), 6)) : first;
}
} // namespace

TEST(DetectorCovariance, OfSmallMarkersOnDarkGround)
{
  // The blur reaches across the quiet zone, which is two pixels wide: what is thought of the paper's end, which moves
  // with the pose, makes the covariance too small.
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  vpDetectorCircleMarker detector(family);
  detector.setZAlignedWithCameraAxis(true);
  vpScenePhotometry photometry;
  photometry.paper = 200.;
  photometry.ink = 60.;
  photometry.blurSigma = 1.3;
  photometry.noiseSigma = 2.;
  double sum = 0.;
  int found = 0;
  for (int i = 0; i < 200; ++i) {
    const vpHomogeneousMatrix truth = randomPose(random, uniform(random, 22., 32.), uniform(random, 0.3, 0.7));
    vpMarkerSceneSimulator simulator(straightCamera(), width, height);
    simulator.setPhotometry(photometry);
    simulator.setBackground(vpSceneBackground::plain(30.));
    simulator.addMarker(printed(family, randomId(random, family)).setPose(truth));
    vpImage<unsigned char> I;
    simulator.render(I, random());
    std::vector<vpHomogeneousMatrix> cMo, cMo2;
    if (!detector.detect(I, size, straightCamera(), cMo, &cMo2)) {
      continue;
    }
    ++found;
    sum += distanceOfNearer(truth, cMo[0], cMo2[0], detector);
  }
  ASSERT_GT(found, 120);
  EXPECT_LT(sum / found, 1.2 * 6.); // 1.39 with the paper's end taken for certain
}

TEST(DetectorCovariance, OfSmallObliqueMarkersOnDarkGround)
{
  // The quiet zone is a pixel wide at the narrow ends, where the paper ends aslant to the line from the centre. With
  // the paper's end held where a fit has started, what lies beyond it looked at along that line, and the sheet's
  // corners taken for right angles, the mean was 1.6 times its due, and nine were beyond 30.
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  vpDetectorCircleMarker detector(family);
  detector.setZAlignedWithCameraAxis(true);
  double sum = 0.;
  int found = 0, far = 0;
  for (int i = 0; i < 200; ++i) {
    const vpHomogeneousMatrix truth =
        randomPose(random, uniform(random, 18., 25.), vpMath::rad(uniform(random, 55., 70.)));
    vpScenePhotometry photometry;
    photometry.paper = 210.;
    photometry.ink = 60.;
    photometry.blurSigma = uniform(random, 1., 1.2);
    photometry.noiseSigma = uniform(random, 1., 3.);
    vpMarkerSceneSimulator simulator(straightCamera(), width, height);
    simulator.setPhotometry(photometry);
    simulator.setBackground(vpSceneBackground::plain(uniform(random, 30., 130.)));
    simulator.addMarker(printed(family, randomId(random, family)).setPose(truth));
    vpImage<unsigned char> I;
    simulator.render(I, random());
    std::vector<vpHomogeneousMatrix> cMo, cMo2;
    if (!detector.detect(I, size, straightCamera(), cMo, &cMo2)) {
      continue;
    }
    ++found;
    const double distance = distanceOfNearer(truth, cMo[0], cMo2[0], detector);
    sum += distance;
    far += distance > 30.;
  }
  ASSERT_GT(found, 120);
  EXPECT_LT(sum / found, 1.2 * 6.);
  EXPECT_LE(far, 3);
}
