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
 * What the tests of the detector share: simulated scenes, and the distance of a pose from the truth.
 */

#ifndef VP_TEST_DETECTOR_SCENES_H
#define VP_TEST_DETECTOR_SCENES_H

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <visp3/circle_marker/vpDetectorCircleMarker.h>
#include <visp3/circle_marker_simulator/vpMarkerSceneSimulator.h>

#include "../../modules/circle_marker/test/testRandom.h"

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace detector_test {
using random_test::Random;
using random_test::randomOfTest;
using random_test::uniform;

constexpr unsigned int width = 640;
constexpr unsigned int height = 480;
constexpr double focal = 800.; // pixels
constexpr double size = 0.18;  // m

inline vpCameraParameters straightCamera()
{
  return vpCameraParameters(focal, focal, 319.5, 239.5);
}

inline Eigen::Matrix3d rotationOf(const vpHomogeneousMatrix &cMo)
{
  Eigen::Matrix3d R;
  for (unsigned int row = 0; row < 3; ++row) {
    for (unsigned int column = 0; column < 3; ++column) {
      R(row, column) = cMo[row][column];
    }
  }
  return R;
}

inline Eigen::Vector3d translationOf(const vpHomogeneousMatrix &cMo)
{
  return Eigen::Vector3d(cMo[0][3], cMo[1][3], cMo[2][3]);
}

inline vpHomogeneousMatrix poseOf(const Eigen::Matrix3d &R, const Eigen::Vector3d &t)
{
  vpHomogeneousMatrix cMo;
  for (unsigned int row = 0; row < 3; ++row) {
    for (unsigned int column = 0; column < 3; ++column) {
      cMo[row][column] = R(row, column);
    }
    cMo[row][3] = t[row];
  }
  return cMo;
}

inline Eigen::Matrix3d turn(double angle, const Eigen::Vector3d &axis)
{
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

/*!
  A z-aligned pose of any spin.
  \e diameter: Of the ring in the image, pixels.
  \e tilt: Angle between normal and line of sight, rad.
  \e u and \e v: Image of the centre by a camera without distortion, pixels.
*/
inline vpHomogeneousMatrix randomPose(Random &random, double diameter, double tilt, double u, double v)
{
  const double depth = focal * size / diameter;
  const Eigen::Vector3d center = depth * Eigen::Vector3d((u - 319.5) / focal, (v - 239.5) / focal, 1.);
  const Eigen::Vector3d sight = center.normalized();
  const Eigen::Matrix3d facing = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), sight).toRotationMatrix();
  const double azimuth = uniform(random, 0., 2. * M_PI);
  return poseOf(facing * turn(tilt, Eigen::Vector3d(std::cos(azimuth), std::sin(azimuth), 0.)) *
                    turn(uniform(random, -M_PI, M_PI), Eigen::Vector3d::UnitZ()),
                center);
}

//! The same anywhere in the image, off its rim.
inline vpHomogeneousMatrix randomPose(Random &random, double diameter, double tilt)
{
  const double margin = std::min(0.75 * diameter, 0.5 * height);
  return randomPose(random, diameter, tilt, uniform(random, margin, width - margin),
                    uniform(random, margin, height - margin));
}

//! A marker of any family as it is printed.
inline vpSimulatedMarker printed(const vpCircleMarkerFamily &family, int id, double diameter = size)
{
  switch (family.getType()) {
  case vpCircleMarkerFamily::RING:
    return vpSimulatedMarker::ring(diameter, family.getLayout().ringInner);
  case vpCircleMarkerFamily::DISC:
    return vpSimulatedMarker::disc(diameter);
  default:
    return vpSimulatedMarker::circle(family.getName(), id, diameter);
  }
}

inline int randomId(Random &random, const vpCircleMarkerFamily &family)
{
  return family.isCoded() ? static_cast<int>(random() % family.getNbIds()) : -1;
}

inline vpImage<unsigned char> imageOf(const vpCameraParameters &cam, const std::vector<vpSimulatedMarker> &markers,
                                      Random &random)
{
  vpMarkerSceneSimulator simulator(cam, width, height);
  for (const vpSimulatedMarker &marker : markers) {
    simulator.addMarker(marker);
  }
  vpImage<unsigned char> I;
  simulator.render(I, random());
  return I;
}

inline vpImage<unsigned char> imageOf(const vpSimulatedMarker &marker, Random &random)
{
  return imageOf(straightCamera(), {marker}, random);
}

/*!
  Squared Mahalanobis distance of the truth from a z-aligned pose, by the definition of the covariance:
  truth = exp(delta) estimate. Both are moved to the marker's centre, t = v + w x C, where the numbers are well
  conditioned; a marker without a code is compared up to its spin, in 5 dimensions.
*/
inline double mahalanobis(const vpHomogeneousMatrix &truth, const vpHomogeneousMatrix &estimate,
                          const vpMatrix &covariance, unsigned int freedom)
{
  const Eigen::Matrix3d R = rotationOf(estimate);
  const Eigen::Vector3d C = translationOf(estimate);
  Eigen::Matrix<double, 6, 6> camera;
  for (unsigned int row = 0; row < 6; ++row) {
    for (unsigned int column = 0; column < 6; ++column) {
      camera(row, column) = covariance[row][column];
    }
  }
  Eigen::Matrix3d cross;
  cross << 0., -C.z(), C.y(), C.z(), 0., -C.x(), -C.y(), C.x(), 0.;
  Eigen::Matrix<double, 6, 6> move = Eigen::Matrix<double, 6, 6>::Identity();
  move.topRightCorner<3, 3>() = -cross;
  // Rows: translation, turns about the marker's x and y, its spin.
  Eigen::Matrix<double, 6, 6> axes = Eigen::Matrix<double, 6, 6>::Identity();
  axes.bottomRightCorner<3, 3>() = R.transpose();
  const Eigen::Matrix<double, 6, 6> local = axes * move * camera * move.transpose() * axes.transpose();
  const Eigen::Matrix3d trueR = rotationOf(truth);
  Eigen::Vector3d w;
  if (freedom == 6) {
    const Eigen::AngleAxisd rotation(Eigen::Matrix3d(trueR * R.transpose()));
    w = rotation.angle() * rotation.axis();
  }
  else {
    const Eigen::Vector3d across = R.col(2).cross(trueR.col(2));
    const double sine = across.norm();
    w = sine > 0. ? Eigen::Vector3d(std::atan2(sine, R.col(2).dot(trueR.col(2))) / sine * across) : across;
  }
  Eigen::Matrix<double, 6, 1> error;
  error << translationOf(truth) - C, R.transpose() * w;
  const auto n = static_cast<Eigen::Index>(freedom);
  const Eigen::MatrixXd used = local.topLeftCorner(n, n);
  const Eigen::VectorXd e = error.head(n);
  // Metres and radians differ in size: each in its own standard deviation.
  const Eigen::VectorXd sigma = used.diagonal().cwiseSqrt();
  const Eigen::MatrixXd correlation = sigma.cwiseInverse().asDiagonal() * used * sigma.cwiseInverse().asDiagonal();
  const Eigen::VectorXd standardised = e.cwiseQuotient(sigma);
  return standardised.dot(correlation.inverse() * standardised);
}

//! What a squared Mahalanobis distance exceeds as seldom as a normal variable 5 standard deviations: 5.7e-7.
inline double fiveSigma(unsigned int freedom)
{
  return freedom == 6 ? 40.9 : 37.4;
}

//! Largest difference of two poses: of translation relative to the depth, and of rotation, rad.
inline double differenceOf(const vpHomogeneousMatrix &a, const vpHomogeneousMatrix &b)
{
  return std::max((translationOf(a) - translationOf(b)).norm() / translationOf(b).z(),
                  (rotationOf(a) - rotationOf(b)).norm() / M_SQRT2);
}

//! Two markers, 5 and 9, of any spin.
struct TwoMarkers
{
  Random random = randomOfTest();
  vpHomogeneousMatrix poses[2] = {randomPose(random, 110., 0.5, 180., 220.), randomPose(random, 80., 0.7, 460., 250.)};
  vpImage<unsigned char> I = imageOf(straightCamera(),
                                     {printed(vpCircleMarkerFamily::GOLAY23, 5).setPose(poses[0]),
                                      printed(vpCircleMarkerFamily::GOLAY23, 9).setPose(poses[1])},
                                     random);
};
} // namespace detector_test

#endif
