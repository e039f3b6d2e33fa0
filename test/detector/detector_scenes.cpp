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
 * What the tests of the detector share, compiled once.
 */

#include "detector_scenes.h"

#include <array>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace detector_test {
vpCameraParameters straightCamera()
{
  return vpCameraParameters(focal, focal, 319.5, 239.5);
}

Eigen::Matrix3d rotationOf(const vpHomogeneousMatrix &cMo)
{
  Eigen::Matrix3d R;
  for (unsigned int row = 0; row < 3; ++row) {
    for (unsigned int column = 0; column < 3; ++column) {
      R(row, column) = cMo[row][column];
    }
  }
  return R;
}

Eigen::Vector3d translationOf(const vpHomogeneousMatrix &cMo)
{
  return Eigen::Vector3d(cMo[0][3], cMo[1][3], cMo[2][3]);
}

vpHomogeneousMatrix poseOf(const Eigen::Matrix3d &R, const Eigen::Vector3d &t)
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

Eigen::Matrix3d turn(double angle, const Eigen::Vector3d &axis)
{
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

vpHomogeneousMatrix randomPose(Random &random, double diameter, double tilt, double u, double v)
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

vpHomogeneousMatrix randomPose(Random &random, double diameter, double tilt)
{
  const double margin = std::min(0.75 * diameter, 0.5 * height);
  return randomPose(random, diameter, tilt, uniform(random, margin, width - margin),
                    uniform(random, margin, height - margin));
}

vpSimulatedMarker printed(const vpCircleMarkerFamily &family, int id, double diameter)
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

int randomId(Random &random, const vpCircleMarkerFamily &family)
{
  return family.isCoded() ? static_cast<int>(random() % family.getNbIds()) : -1;
}

vpImage<unsigned char> imageOf(const vpCameraParameters &cam, const std::vector<vpSimulatedMarker> &markers,
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

vpImage<unsigned char> imageOf(const vpSimulatedMarker &marker, Random &random)
{
  return imageOf(straightCamera(), {marker}, random);
}

double mahalanobis(const vpHomogeneousMatrix &truth, const vpHomogeneousMatrix &estimate, const vpMatrix &covariance,
                   unsigned int freedom)
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

namespace {
// Of t_z = v_z + (w x C)_z.
double depthVariance(const vpCircleMarkerDetection &detection)
{
  const Eigen::Vector3d C = translationOf(detection.cMo);
  const std::array<double, 6> by = {0., 0., 1., C.y(), -C.x(), 0.};
  double variance = 0.;
  for (unsigned int row = 0; row < 6; ++row) {
    for (unsigned int column = 0; column < 6; ++column) {
      variance += by[row] * by[column] * detection.covariance[row][column];
    }
  }
  return variance;
}
} // namespace

Honesty honestyOf(const HonestyScenes &scenes, Random &random)
{
  vpDetectorCircleMarker detector(scenes.family);
  detector.setZAlignedWithCameraAxis(true);
  Honesty honesty;
  for (unsigned int i = 0; i < scenes.images; ++i) {
    const double tilt = uniform(random, 0.2, 1.);
    const double diameter = uniform(random, scenes.diameters.first, scenes.diameters.second);
    const vpHomogeneousMatrix truth = randomPose(random, diameter, tilt);
    vpScenePhotometry photometry;
    photometry.noiseSigma = scenes.noise;
    vpMarkerSceneSimulator simulator(straightCamera(), width, height);
    simulator.setPhotometry(photometry);
    simulator.setBackground(vpSceneBackground::plain(uniform(random, 80., 200.)));
    const int id = randomId(random, scenes.family);
    simulator.addMarker(printed(scenes.family, id).setPose(truth));
    vpImage<unsigned char> I;
    simulator.render(I, random());
    scenes.process(I, random);
    std::vector<vpHomogeneousMatrix> cMo;
    if (!detector.detect(I, size, scenes.camera, cMo)) {
      continue;
    }
    const vpCircleMarkerDetection &detection = detector.getDetections()[0];
    if (detection.id != id) {
      ++honesty.others;
      continue;
    }
    const Eigen::Vector3d normal = rotationOf(truth).col(2);
    if (rotationOf(detection.cMo).col(2).dot(normal) < std::cos(0.15)) {
      ++honesty.mirrored;
      honesty.wrongOdds = std::max(honesty.wrongOdds, detection.logOdds);
      continue;
    }
    ++honesty.found;
    honesty.squared += mahalanobis(truth, detection.cMo, detection.covariance, detection.dof) / detection.dof;
    honesty.bias += (detection.cMo[2][3] - truth[2][3]) / std::sqrt(depthVariance(detection));
  }
  honesty.squared /= std::max(honesty.found, 1u);
  honesty.bias /= std::max(honesty.found, 1u);
  return honesty;
}

std::string Honesty::text() const
{
  return std::to_string(squared) + ", bias of the depth " + std::to_string(bias) + ", found " + std::to_string(found) +
         ", mirrored " + std::to_string(mirrored) + " with odds to " + std::to_string(wrongOdds) + ", as others " +
         std::to_string(others);
}

double differenceOf(const vpHomogeneousMatrix &a, const vpHomogeneousMatrix &b)
{
  return std::max((translationOf(a) - translationOf(b)).norm() / translationOf(b).z(),
                  (rotationOf(a) - rotationOf(b)).norm() / M_SQRT2);
}
} // namespace detector_test
