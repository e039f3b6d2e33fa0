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
 * What the tests of the fit share.
 */

#include "testFitTools.h"

#include <cmath>
#include <random>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace fit_test {
Case makeCase(const MarkerScene &scene, int id, const vpImage<unsigned char> &I)
{
  Case made = {scene, patternOf(scene.family, id), {}};
  const MarkerPlane plane = scene.plane();
  selectPixels(I, CameraModel(scene.camera()), scene.frame(), &plane, 1, made.pattern, {BlurParameters(), 0.3, 3000.},
               made.pixels);
  return made;
}

void fillFromModel(Case &made, const Light &light, const BlurParameters &blur, double noise, Random &random)
{
  std::normal_distribution<double> normal(0., 1.);
  for (FitPixel &pixel : made.pixels) {
    const double darkness = darknessAt(pixel.model(), made.scene.plane(), made.pattern, blur).value;
    const double share = 1. + light.gradient.dot(pixel.offset.cast<double>()) / light.level;
    const double grey = light.level * std::pow(share * (1. - light.contrast * darkness), light.gamma);
    pixel.grey = static_cast<float>(grey + (noise > 0. ? noise * normal(random) : 0.));
    pixel.beyond = {}; // the model's paper has no end
  }
}

MarkerPlane disturbed(const MarkerPlane &plane, Random &random, double amount)
{
  MarkerPlane start = plane;
  const auto unit = [&random] { return uniform(random, -1., 1.); };
  const double depth = plane.center.z();
  start.center +=
      amount * Eigen::Vector3d(0.3 * plane.radius * unit(), 0.3 * plane.radius * unit(), 0.3 * depth * unit());
  start.rotation = turn(amount * 2. * unit(), Eigen::Vector3d(unit(), unit(), 0.01)) * start.rotation;
  start.spin(amount * unit());
  return start;
}

Eigen::Matrix<double, 6, 1> errorOf(const MarkerPlane &fitted, const MarkerPlane &truth)
{
  const Eigen::AngleAxisd rotation(Eigen::Matrix3d(truth.rotation * fitted.rotation.transpose()));
  Eigen::Matrix<double, 6, 1> error;
  error << truth.center - fitted.center, rotation.angle() * rotation.axis();
  return error;
}

double mahalanobis(const FittedPose &fit, const MarkerPlane &truth, bool spinIsKnown)
{
  if (spinIsKnown) {
    const Eigen::Matrix<double, 6, 1> e = errorOf(fit.plane, truth);
    return e.dot(fit.covariance.inverse() * e);
  }
  const Eigen::Vector3d n = fit.plane.rotation.col(2);
  const Eigen::Vector3d across = n.cross(truth.rotation.col(2));
  Eigen::Matrix<double, 5, 6> project = Eigen::Matrix<double, 5, 6>::Zero();
  project.topLeftCorner<3, 3>().setIdentity();
  project.block<1, 3>(3, 3) = fit.plane.rotation.col(0).transpose();
  project.block<1, 3>(4, 3) = fit.plane.rotation.col(1).transpose();
  Eigen::Matrix<double, 6, 1> e;
  e << truth.center - fit.plane.center, across;
  const Eigen::Matrix<double, 5, 1> reduced = project * e;
  return reduced.dot((project * fit.covariance * project.transpose()).inverse() * reduced);
}

FitSettings settingsOf(const vpCircleMarkerFamily &family)
{
  FitSettings settings;
  settings.spinIsKnown = family.isCoded();
  settings.gammaAndSpread = family.getType() != vpCircleMarkerFamily::DISC;
  return settings;
}

std::optional<FittedPose> fitAll(const std::vector<FitPixel> &pixels, const MarkerPlane &start,
                                 const MarkerPattern &pattern, const FitSettings &settings)
{
  FitMemory memory;
  return fitPose(pixels, {start, std::nullopt, std::nullopt}, pattern, settings, memory);
}
} // namespace fit_test
