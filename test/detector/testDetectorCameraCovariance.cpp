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
 * Cameras that are not what they are thought to be: the covariance of a pose when that is stated.
 */

#include "detector_scenes.h"

#include <Eigen/Geometry>

using namespace detector_test;

namespace {
// How well the cameras are known: standard deviations, pixels.
constexpr double focalDeviation = 0.003 * focal;
constexpr double centerDeviation = 2.;

//! Focal lengths that are off together, and a principal point that is off on its own.
vpMatrix stated()
{
  vpMatrix covariance(4, 4);
  for (unsigned int i = 0; i < 2; ++i) {
    for (unsigned int j = 0; j < 2; ++j) {
      covariance[i][j] = focalDeviation * focalDeviation;
    }
    covariance[2 + i][2 + i] = centerDeviation * centerDeviation;
  }
  return covariance;
}

vpCameraParameters doubtful(Random &random)
{
  std::normal_distribution<double> normal(0., 1.);
  const double f = focal + focalDeviation * normal(random);
  const vpCameraParameters right = straightCamera();
  const double u0 = right.get_u0() + centerDeviation * normal(random);
  vpCameraParameters camera;
  camera.initPersProjWithoutDistortion(f, f, u0, right.get_v0() + centerDeviation * normal(random));
  return camera;
}

//! Of a marker's place: a pose that is wrong by a twist (v, w) in the camera frame has it wrong by v + w x place.
Eigen::Matrix3d placeCovariance(const vpMatrix &covariance, const vpHomogeneousMatrix &cMo)
{
  const Eigen::Vector3d place = translationOf(cMo);
  Eigen::Matrix<double, 3, 6> byTwist;
  byTwist.leftCols<3>().setIdentity();
  for (int k = 0; k < 3; ++k) {
    byTwist.col(3 + k) = Eigen::Vector3d::Unit(k).cross(place);
  }
  const Eigen::Map<const Eigen::Matrix<double, 6, 6>> ofTwist(covariance.data); // symmetric: by rows or columns
  return byTwist * ofTwist * byTwist.transpose();
}
} // namespace

TEST(DetectorCameraCovariance, IsAPartOfEveryCovariance)
{
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::RING}) {
    const vpCircleMarkerFamily family(type);
    constexpr int count = 60;
    double told = 0.;
    double untold = 0.;
    double dof = 0.;
    for (int i = 0; i < count; ++i) {
      const vpHomogeneousMatrix truth = randomPose(random, uniform(random, 50., 120.), uniform(random, 0.4, 1.),
                                                   uniform(random, 120., 520.), uniform(random, 100., 380.));
      const vpImage<unsigned char> I = imageOf(printed(family, randomId(random, family)).setPose(truth), random);
      const vpCameraParameters camera = doubtful(random);
      vpDetectorCircleMarker detector(family);
      detector.setZAlignedWithCameraAxis(true);
      std::vector<vpHomogeneousMatrix> cMo;
      ASSERT_TRUE(detector.detect(I, size, camera, cMo));
      dof = detector.getDetections()[0].dof;
      untold += mahalanobis(truth, cMo[0], detector.getCovariance(0), detector.getDetections()[0].dof);
      detector.setCameraCovariance(stated());
      ASSERT_TRUE(detector.detect(I, size, camera, cMo));
      told += mahalanobis(truth, cMo[0], detector.getCovariance(0), detector.getDetections()[0].dof);
    }
    // The mean of n squares of chi square with k degrees of freedom has the variance 2 k / n.
    EXPECT_NEAR(told / count, dof, 3.5 * std::sqrt(2. * dof / count)) << family.getName();
    EXPECT_GT(untold / count, 100. * dof) << family.getName();
  }
}

// By hand, near the image's middle: the depth is as wrong as the focal length, the place across as the principal point,
// at whichever of the poses.
TEST(DetectorCameraCovariance, IsAPartOfTheSecondPosesToo)
{
  Random random = randomOfTest();
  int seconds = 0;
  for (int i = 0; i < 20; ++i) {
    const vpHomogeneousMatrix truth = randomPose(random, uniform(random, 30., 45.), uniform(random, 0.4, 0.8),
                                                 uniform(random, 280., 360.), uniform(random, 200., 280.));
    const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
    const vpImage<unsigned char> I = imageOf(printed(family, randomId(random, family)).setPose(truth), random);
    vpDetectorCircleMarker detector(family);
    std::vector<vpHomogeneousMatrix> cMo;
    ASSERT_TRUE(detector.detect(I, size, straightCamera(), cMo));
    const vpCircleMarkerDetection untold = detector.getDetections()[0];
    detector.setCameraCovariance(stated());
    ASSERT_TRUE(detector.detect(I, size, straightCamera(), cMo));
    const vpCircleMarkerDetection told = detector.getDetections()[0];
    ASSERT_EQ(told.hasSecondPose, untold.hasSecondPose);
    if (!told.hasSecondPose) {
      continue;
    }
    ++seconds;
    const Eigen::Matrix3d added =
        placeCovariance(told.covariance2, told.cMo2) - placeCovariance(untold.covariance2, untold.cMo2);
    const double depth = told.cMo2[2][3];
    const double along = std::pow(depth * focalDeviation / focal, 2.);
    const double across = std::pow(depth * centerDeviation / focal, 2.);
    // The radius is a fortieth of the depth: by as much the front and the back of it see the camera otherwise, and
    // their squares by twice as much.
    EXPECT_NEAR(added(0, 0), across, 0.1 * across);
    EXPECT_NEAR(added(1, 1), across, 0.1 * across);
    EXPECT_NEAR(added(2, 2), along, 0.1 * along);
  }
  EXPECT_GE(seconds, 10);
}

TEST(DetectorCameraCovariance, IsKeptAndTakenBack)
{
  vpDetectorCircleMarker detector;
  EXPECT_EQ(detector.getCameraCovariance().sumSquare(), 0.);
  detector.setCameraCovariance(stated());
  const vpDetectorCircleMarker copy(detector);
  for (unsigned int i = 0; i < 16; ++i) {
    EXPECT_EQ(detector.getCameraCovariance().data[i], stated().data[i]);
    EXPECT_EQ(copy.getCameraCovariance().data[i], stated().data[i]);
  }
  EXPECT_THROW(detector.setCameraCovariance(vpMatrix(3, 3)), vpException);
  vpMatrix negative = stated();
  negative[3][3] = -1.;
  EXPECT_THROW(detector.setCameraCovariance(negative), vpException);
  vpMatrix uneven = stated();
  uneven[0][2] = 1.;
  EXPECT_THROW(detector.setCameraCovariance(uneven), vpException);
  EXPECT_EQ(detector.getCameraCovariance().data[15], stated().data[15]) << "what was refused changes nothing";
  detector.setCameraCovariance(vpMatrix());
  EXPECT_EQ(detector.getCameraCovariance().sumSquare(), 0.);
}
