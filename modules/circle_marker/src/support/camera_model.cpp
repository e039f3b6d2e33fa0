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
 * Camera model as an estimator needs it: pixel to metre exactly, and back.
 */

#include "support/camera_model.h"

#include <cmath>
#include <limits>

#include <Eigen/LU>

#include <visp3/core/vpMeterPixelConversion.h>
#include <visp3/core/vpPixelMeterConversion.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// The distance rho of a pixel from the principal point, in focal lengths, whose normalised radius is r: the least
// positive solution of r = rho (1 + kdu rho^2), not a number without one. From rho = r Newton's method comes from one
// side, whatever the sign of kdu; where the cube prevails a step leaves two thirds.
double pixelRadius(double r, double kdu)
{
  constexpr int mostSteps = 40;
  constexpr double precision = 1e-12; // of r
  double rho = r;
  for (int i = 0; i < mostSteps; ++i) {
    const double left = r - rho * (1. + kdu * rho * rho);
    const double slope = 1. + 3. * kdu * rho * rho;
    if (!(slope > 0.)) { // beyond where the lens folds over
      break;
    }
    if (std::abs(left) <= precision * r) {
      return rho + left / slope;
    }
    rho += left / slope;
  }
  return std::numeric_limits<double>::quiet_NaN();
}
} // namespace

Eigen::Vector2d CameraModel::toMeter(const Eigen::Vector2d &pixel) const
{
  Eigen::Vector2d meter;
  vpPixelMeterConversion::convertPoint(m_camera, pixel.x(), pixel.y(), meter.x(), meter.y());
  return meter;
}

Eigen::Matrix2d CameraModel::meterPerPixel(const Eigen::Vector2d &pixel) const
{
  if (isLinear()) {
    return Eigen::Vector2d(m_camera.get_px_inverse(), m_camera.get_py_inverse()).asDiagonal();
  }
  // Central differences: the models are smooth, and half a pixel leaves an error of third order in 1/f.
  constexpr double step = 0.5;
  Eigen::Matrix2d jacobian;
  jacobian.col(0) = toMeter(pixel + Eigen::Vector2d(step, 0.)) - toMeter(pixel - Eigen::Vector2d(step, 0.));
  jacobian.col(1) = toMeter(pixel + Eigen::Vector2d(0., step)) - toMeter(pixel - Eigen::Vector2d(0., step));
  return jacobian / (2. * step);
}

Eigen::Matrix<double, 2, 4> CameraModel::meterByParameters(const Eigen::Vector2d &pixel) const
{
  // All models begin with ((u - u0) / px, (v - v0) / py).
  const Eigen::Matrix2d byPixel = meterPerPixel(pixel);
  Eigen::Matrix<double, 2, 4> jacobian;
  jacobian.col(0) = -(pixel.x() - m_camera.get_u0()) * m_camera.get_px_inverse() * byPixel.col(0);
  jacobian.col(1) = -(pixel.y() - m_camera.get_v0()) * m_camera.get_py_inverse() * byPixel.col(1);
  jacobian.rightCols<2>() = -byPixel;
  return jacobian;
}

Eigen::Vector2d CameraModel::toPixel(const Eigen::Vector2d &meter) const
{
  if (m_camera.get_projModel() == vpCameraParameters::perspectiveProjWithDistortion) {
    const double r = meter.norm();
    const double scale = r > 0. ? pixelRadius(r, m_camera.get_kdu()) / r : 1.;
    return Eigen::Vector2d(m_camera.get_u0() + m_camera.get_px() * scale * meter.x(),
                           m_camera.get_v0() + m_camera.get_py() * scale * meter.y());
  }
  Eigen::Vector2d pixel;
  vpMeterPixelConversion::convertPoint(m_camera, meter.x(), meter.y(), pixel.x(), pixel.y());
  if (isLinear()) {
    return pixel;
  }
  // From ViSP's approximate inverse, Newton's method gains three digits a step.
  constexpr int mostSteps = 10;
  constexpr double precision = 1e-9; // pixels
  for (int step = 0; step < mostSteps; ++step) {
    const Eigen::Vector2d correction = meterPerPixel(pixel).inverse() * (meter - toMeter(pixel));
    pixel += correction;
    if (correction.squaredNorm() < precision * precision) {
      break;
    }
  }
  return pixel;
}
} // namespace circle_marker
END_VISP_NAMESPACE
