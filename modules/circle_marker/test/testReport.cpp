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
 * The covariance as the user gets it.
 */

#include "testRoomTools.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <visp3/core/vpColVector.h>
#include <visp3/core/vpExponentialMap.h>

#include "refine/report.h"

using namespace circle_marker;
using namespace room_test;

namespace {
vpHomogeneousMatrix poseOf(const Eigen::Vector3d &center, const Eigen::Matrix3d &rotation)
{
  vpHomogeneousMatrix pose;
  for (unsigned int i = 0; i < 3; ++i) {
    for (unsigned int j = 0; j < 3; ++j) {
      pose[i][j] = rotation(i, j);
    }
    pose[i][3] = center[i];
  }
  return pose;
}

//! A fit of a small marker far away: depth known to centimetres, normal to half a degree, the place across to 0.05 mm.
FittedPose farFit(Random &random)
{
  FittedPose fit;
  fit.plane.radius = 0.09;
  fit.plane.center = uniform(random, 12., 16.) * Eigen::Vector3d(0.3, -0.2, 1.).normalized();
  fit.plane.rotation = turn(uniform(random, 0.1, 0.6), Eigen::Vector3d(1., uniform(random, -1., 1.), 0.1));
  const Eigen::Vector3d sight = fit.plane.center.normalized();
  fit.covariance.setZero();
  fit.covariance.topLeftCorner<3, 3>() =
      5e-5 * 5e-5 * Eigen::Matrix3d::Identity() + 0.013 * 0.013 * sight * sight.transpose();
  fit.covariance.bottomRightCorner<3, 3>() = 0.0065 * 0.0065 * Eigen::Matrix3d::Identity();
  return fit;
}

//! A fit of a marker of any spin near the camera.
FittedPose nearFit(double spin)
{
  FittedPose fit;
  fit.plane.radius = 0.09;
  fit.plane.center = Eigen::Vector3d(0.1, 0.05, 1.);
  fit.plane.rotation = turn(0.4, Eigen::Vector3d::UnitY()) * turn(spin, Eigen::Vector3d::UnitZ());
  return fit;
}

vpCircleMarkerDetection reported(const Recognition &marker, const Measurement &measurement)
{
  const CameraModel camera(vpCameraParameters(800., 800., 319.5, 239.5));
  vpCircleMarkerDetection detection;
  putReport(marker, measurement, camera, 1., true, detection);
  return detection;
}
} // namespace

// Errors drawn from the covariance about the marker's centre, looked at as the convention has it: delta with
// truth = exp(delta) pose. To first order alone the mean would be 7.3 instead of 6.
TEST(Report, CovarianceOfDeltaIsRightToSecondOrder)
{
  Random random = randomOfTest();
  Recognition marker;
  marker.family = vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23);
  marker.code.id = 3;
  const CameraModel camera(vpCameraParameters(1600., 1600., 639.5, 479.5));
  std::normal_distribution<double> normal(0., 1.);
  double mean = 0.;
  constexpr int fits = 5, draws = 4000;
  for (int i = 0; i < fits; ++i) {
    Measurement measurement;
    measurement.first = farFit(random);
    vpCircleMarkerDetection detection;
    putReport(marker, measurement, camera, 1., true, detection);
    // Metres and radians to the same size, for the inverse.
    Eigen::Matrix<double, 6, 6> covariance;
    Eigen::Matrix<double, 6, 1> scale;
    for (unsigned int k = 0; k < 6; ++k) {
      scale[k] = 1. / std::sqrt(detection.covariance[k][k]);
    }
    for (unsigned int k = 0; k < 6; ++k) {
      for (unsigned int l = 0; l < 6; ++l) {
        covariance(k, l) = scale[k] * detection.covariance[k][l] * scale[l];
      }
    }
    const Eigen::LLT<Eigen::Matrix<double, 6, 6>> known(covariance);
    const Eigen::Matrix<double, 6, 6> root = measurement.first.covariance.llt().matrixL();
    for (int draw = 0; draw < draws; ++draw) {
      Eigen::Matrix<double, 6, 1> error;
      for (int k = 0; k < 6; ++k) {
        error[k] = normal(random);
      }
      error = (root * error).eval();
      const Eigen::Vector3d turned = error.tail<3>();
      const vpHomogeneousMatrix truth =
          poseOf(measurement.first.plane.center + error.head<3>(),
                 Eigen::AngleAxisd(turned.norm(), turned.normalized()) * measurement.first.plane.rotation);
      const vpColVector delta = vpExponentialMap::inverse(truth * detection.cMo.inverse());
      Eigen::Matrix<double, 6, 1> scaled;
      for (unsigned int k = 0; k < 6; ++k) {
        scaled[k] = scale[k] * delta[k];
      }
      mean += scaled.dot(known.solve(scaled)) / (fits * draws);
    }
  }
  EXPECT_NEAR(mean, 6., 0.15); // its own standard deviation is 0.03
}

// A single random number z moves the centre by tau z along x and turns the marker by omega z about y. To first order
// the camera sees no motion in depth; to second order, -w x t / 2, there is omega tau z^2 / 2, and the mean of z^4
// is 3.
TEST(Report, DepthOfACorrelatedErrorIsOfSecondOrder)
{
  constexpr double tau = 0.02;   // m
  constexpr double omega = 0.05; // rad
  Recognition marker;
  marker.family = vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23);
  marker.code.id = 3;
  Measurement measurement;
  measurement.first = nearFit(0.);
  measurement.first.plane.center = Eigen::Vector3d(0., 0., 1.);
  Eigen::Matrix<double, 6, 1> error;
  error << tau, 0., 0., 0., omega, 0.;
  measurement.first.covariance = error * error.transpose();
  const vpCircleMarkerDetection detection = reported(marker, measurement);
  EXPECT_NEAR(detection.covariance[2][2], 3. * std::pow(0.5 * omega * tau, 2.), 1e-12);
  EXPECT_NEAR(detection.covariance[0][0], std::pow(tau - omega, 2.), 1e-12); // t - w x C
  EXPECT_NEAR(detection.covariance[4][4], omega * omega, 1e-12);
  EXPECT_EQ(detection.covarianceAtMarker[2][2], 0.); // its depth is exact
  EXPECT_NEAR(detection.covarianceAtMarker[0][0], tau * tau, 1e-12);
  EXPECT_NEAR(detection.covarianceAtMarker[0][4], tau * omega, 1e-12);
}

// The spin of a marker without a code is not seen: whatever both fits have, one is reported.
TEST(Report, SpinOfAMarkerWithoutACodeIsThatOfTheConvention)
{
  Recognition ring;
  ring.family = vpCircleMarkerFamily(vpCircleMarkerFamily::RING);
  Measurement measurement;
  measurement.first = nearFit(0.);
  measurement.second = nearFit(0.);
  measurement.cost2 = 1.;
  const vpCircleMarkerDetection unspun = reported(ring, measurement);
  measurement.first = nearFit(2.);
  measurement.second = nearFit(1.);
  const vpCircleMarkerDetection spun = reported(ring, measurement);
  for (unsigned int row = 0; row < 3; ++row) {
    for (unsigned int column = 0; column < 4; ++column) {
      EXPECT_NEAR(spun.cMo[row][column], unspun.cMo[row][column], 1e-12);
      EXPECT_NEAR(spun.cMo2[row][column], unspun.cMo2[row][column], 1e-12);
    }
  }
}

// Each pose has the covariance of its own fit: that of the second is what it would be as the first. Where there was one
// before and is none now, nothing of it is left.
TEST(Report, EachPoseHasItsCovariance)
{
  Recognition marker;
  marker.family = vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23);
  marker.code.id = 3;
  Random random = randomOfTest();
  Measurement measurement;
  measurement.first = farFit(random);
  measurement.second = farFit(random);
  measurement.second->covariance *= 2.;
  measurement.cost2 = 1.;
  const CameraModel camera(vpCameraParameters(800., 800., 319.5, 239.5));
  vpCircleMarkerDetection detection;
  putReport(marker, measurement, camera, 1., true, detection);
  Measurement swapped;
  swapped.first = *measurement.second;
  const vpCircleMarkerDetection other = reported(marker, swapped);
  // Not by vpMatrix's comparison, which takes small numbers for equal.
  const auto isSame = [](const vpMatrix &a, const vpMatrix &b) {
    return a.size() == 36 && b.size() == 36 && std::equal(a.data, a.data + 36, b.data);
  };
  EXPECT_GT(other.covariance[2][2], 0.);
  EXPECT_TRUE(isSame(detection.covariance2, other.covariance));
  EXPECT_FALSE(isSame(detection.covariance2, detection.covariance));
  EXPECT_TRUE(isSame(detection.covarianceAtMarker2, other.covarianceAtMarker));
  EXPECT_FALSE(isSame(detection.covarianceAtMarker2, detection.covarianceAtMarker));
  putReport(marker, swapped, camera, 1., true, detection);
  EXPECT_TRUE(isSame(detection.covariance2, vpMatrix(6, 6)));
  EXPECT_TRUE(isSame(detection.covarianceAtMarker2, vpMatrix(6, 6)));
}

TEST(Report, MarginIsNeverNegative)
{
  Recognition marker;
  marker.family = vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23);
  marker.code.id = 3;
  Measurement measurement;
  measurement.first = nearFit(0.);
  for (const double margin : {-0.2, 0., 0.7}) {
    marker.code.margin = margin;
    EXPECT_EQ(reported(marker, measurement).margin, std::max(margin, 0.));
  }
}
