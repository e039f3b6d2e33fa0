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
 * Near markers before a wide lens, whose perspective changes within the blur of an edge.
 */

#include "detector_scenes.h"

using namespace detector_test;

namespace {
struct Squares
{
  double sum = 0.; // of squared Mahalanobis distances per degree of freedom
  int count = 0;
};

//! How far markers are off, one in each image.
Squares squaresOf(const vpCircleMarkerFamily &family, const vpCameraParameters &cam,
                  const std::vector<vpHomogeneousMatrix> &poses, Random &random)
{
  vpDetectorCircleMarker detector(family);
  detector.setZAlignedWithCameraAxis(true);
  Squares squares;
  for (const vpHomogeneousMatrix &truth : poses) {
    std::vector<vpHomogeneousMatrix> cMo;
    detector.detect(imageOf(cam, {printed(family, randomId(random, family)).setPose(truth)}, random), size, cam, cMo);
    EXPECT_EQ(cMo.size(), 1u);
    for (const vpCircleMarkerDetection &detection : detector.getDetections()) {
      squares.sum += mahalanobis(truth, detection.cMo, detection.covariance, detection.dof) / detection.dof;
      ++squares.count;
    }
  }
  return squares;
}

//! The means of forty are within four standard deviations.
void expectTrue(const vpCircleMarkerFamily &family, const Squares &squares)
{
  EXPECT_GE(squares.count, 39) << family.getName();
  EXPECT_LT(squares.sum / squares.count, 1.37) << family.getName();
  EXPECT_GT(squares.sum / squares.count, 0.63) << family.getName();
}
} // namespace

// If edges are as far as in a parallel projection, the means are 1.8 and 1.7.
TEST(DetectorWideLens, CovarianceOfNearMarkersIsTrue)
{
  constexpr double shorter = 220. / focal; // a focal length of 220 pixels sees 640 of them under 111 degrees
  const vpCameraParameters cam(shorter * focal, shorter * focal, 319.5, 239.5);
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::RING}) {
    std::vector<vpHomogeneousMatrix> poses;
    for (int i = 0; i < 40; ++i) {
      poses.push_back(randomPose(random, uniform(random, 160., 320.), uniform(random, 0.5, 1.), 320., 240.));
      poses.back()[2][3] *= shorter; // the same image through this lens
    }
    expectTrue(type, squaresOf(type, cam, poses, random));
  }
}

// Far from the axis a fisheye's pixels see ever wider, and a marker that faces them is farther away at its outer side:
// both together leave its scale as it is. (With the perspective everywhere and without the lens golay23 had 1.5; with
// neither it has 1.3, which this test allows.)
TEST(DetectorWideLens, CovarianceOfMarkersBesideTheAxisOfAFisheyeIsTrue)
{
  vpCameraParameters cam;
  cam.initProjWithKannalaBrandtDistortion(220., 220., 319.5, 239.5, {-0.01, 0.002, -0.0005, 0.0001});
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::RING}) {
    std::vector<vpHomogeneousMatrix> poses;
    for (int i = 0; i < 40; ++i) {
      const double azimuth = uniform(random, 0., 2. * M_PI);
      const double off = uniform(random, 0.55, 0.75); // rad from the axis
      const double distance = uniform(random, 0.4, 0.8);
      const Eigen::Matrix3d sight =
          turn(off, Eigen::Vector3d(-std::sin(azimuth), std::cos(azimuth), 0.)); // takes z there
      const double lean = uniform(random, 0.3, 0.8);
      const double around = uniform(random, 0., 2. * M_PI);
      poses.push_back(poseOf(sight * turn(lean, Eigen::Vector3d(std::cos(around), std::sin(around), 0.)) *
                                 turn(uniform(random, -M_PI, M_PI), Eigen::Vector3d::UnitZ()),
                             distance * sight.col(2)));
    }
    expectTrue(type, squaresOf(type, cam, poses, random));
  }
}
