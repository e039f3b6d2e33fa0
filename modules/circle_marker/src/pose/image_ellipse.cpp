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
 * Ellipses from moments and pixels to normalised coordinates.
 */

#include "pose/image_ellipse.h"

#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <visp3/core/vpPixelMeterConversion.h>

#include "ellipse/fit_conic.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
std::optional<CenteredEllipse> ellipseFromMoments(const Eigen::Vector2d &center, double n20, double n11, double n02)
{
  const double det = n20 * n02 - n11 * n11;
  if (!center.allFinite() || !std::isfinite(det) || !(det > 0.) || !(n20 > 0.)) {
    return std::nullopt;
  }
  CenteredEllipse ellipse;
  ellipse.A << n02, -n11, -n11, n20;
  ellipse.A /= 4. * det;
  ellipse.center = center;
  ellipse.offset = -1.;
  return ellipse.A.allFinite() ? std::optional<CenteredEllipse>(ellipse) : std::nullopt;
}

std::vector<Eigen::Vector2d> sampleEllipse(const CenteredEllipse &ellipse, std::size_t size)
{
  // With A = U^T U, the vector U (x - c) / sqrt(-offset) is on the unit circle.
  const Eigen::Matrix2d map = std::sqrt(-ellipse.offset) * Eigen::Matrix2d(ellipse.A.llt().matrixU()).inverse();
  std::vector<Eigen::Vector2d> points;
  points.reserve(size);
  for (std::size_t i = 0; i < size; i++) {
    const double t = 2. * M_PI * static_cast<double>(i) / static_cast<double>(size);
    points.push_back(ellipse.center + map * Eigen::Vector2d(std::cos(t), std::sin(t)));
  }
  return points;
}

std::optional<Eigen::Vector2d> normalizePoint(const vpImagePoint &point, const vpCameraParameters &cam)
{
  if (!std::isfinite(point.get_u()) || !std::isfinite(point.get_v())) {
    return std::nullopt;
  }
  double x = 0., y = 0.;
  vpPixelMeterConversion::convertPoint(cam, point, x, y);
  // A fisheye's pixel beyond 90 degrees of the axis, or one beyond the model's range, comes out on the opposite side.
  const bool front = x * (point.get_u() - cam.get_u0()) >= 0. && y * (point.get_v() - cam.get_v0()) >= 0.;
  return (std::isfinite(x) && std::isfinite(y) && front) ? std::optional<Eigen::Vector2d>({x, y}) : std::nullopt;
}

std::optional<CenteredEllipse> normalizeEllipse(const CenteredEllipse &pixels, const vpCameraParameters &cam)
{
  if (cam.get_projModel() == vpCameraParameters::perspectiveProjWithoutDistortion) {
    const Eigen::Vector2d focal(cam.get_px(), cam.get_py());
    CenteredEllipse ellipse = pixels;
    ellipse.A = focal.asDiagonal() * pixels.A * focal.asDiagonal();
    ellipse.center = (pixels.center - Eigen::Vector2d(cam.get_u0(), cam.get_v0())).cwiseQuotient(focal);
    return (ellipse.A.allFinite() && ellipse.center.allFinite()) ? std::optional<CenteredEllipse>(ellipse)
                                                                 : std::nullopt;
  }
  const std::size_t samples = 72; // Every 5 degrees: distortion changes little over that.
  std::vector<Eigen::Vector2d> points;
  for (const Eigen::Vector2d &pixel : sampleEllipse(pixels, samples)) {
    const std::optional<Eigen::Vector2d> point = normalizePoint(vpImagePoint(pixel.y(), pixel.x()), cam);
    if (!point) {
      return std::nullopt;
    }
    points.push_back(*point);
  }
  const std::optional<Eigen::Matrix3d> Q = fitEllipse(points.data(), points.size());
  return Q ? centerConic(*Q) : std::nullopt;
}

std::optional<std::vector<vpImagePoint>> outlineFromBorder(const std::vector<vpImagePoint> &border)
{
  std::vector<Eigen::Vector2d> points;
  for (const vpImagePoint &pixel : border) {
    points.emplace_back(pixel.get_u(), pixel.get_v());
  }
  const std::optional<Eigen::Matrix3d> Q = fitEllipse(points.data(), points.size());
  if (!Q) {
    return std::nullopt;
  }
  std::vector<vpImagePoint> outline;
  for (const Eigen::Vector2d &point : points) {
    const Eigen::Vector2d normal = (*Q * point.homogeneous()).head<2>().normalized();
    const Eigen::Vector2d moved = point + 0.5 * normal.cwiseAbs().maxCoeff() * normal;
    outline.emplace_back(moved.y(), moved.x());
  }
  return outline;
}
} // namespace circle_marker
END_VISP_NAMESPACE
