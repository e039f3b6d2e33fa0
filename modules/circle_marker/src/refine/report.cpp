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
 * From the refined planes of a marker to the detection a user sees.
 */

#include "refine/report.h"

#include <cmath>

#include "ellipse/fit_conic.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Points from which the image ellipse is described: with lens distortion it is the ellipse nearest to the curve.
constexpr unsigned int outlinePoints = 64;

// Variance of an angle of which nothing is known: uniform in ]-pi, pi].
constexpr double unknownAngleVariance = M_PI * M_PI / 3.;

// A marker without a code has no spin of its own: it gets that of the convention, whatever the refinement did.
MarkerPlane withReportedSpin(const Recognition &marker, const MarkerPlane &plane)
{
  return marker.family.isCoded() ? plane : planeOf({plane.center, plane.rotation.col(2)}, plane.radius);
}

vpHomogeneousMatrix poseOf(const MarkerPlane &plane, bool zAligned)
{
  // A half turn about x takes z into the marker and y down to z toward the camera and y up.
  const Eigen::Vector3d turn = zAligned ? Eigen::Vector3d(1., 1., 1.) : Eigen::Vector3d(1., -1., -1.);
  vpHomogeneousMatrix pose;
  for (unsigned int row = 0; row < 3; ++row) {
    for (unsigned int column = 0; column < 3; ++column) {
      pose[row][column] = plane.rotation(row, column) * turn[column];
    }
    pose[row][3] = plane.center[row];
  }
  return pose;
}

Eigen::Matrix3d crossMatrix(const Eigen::Vector3d &v)
{
  Eigen::Matrix3d matrix;
  matrix << 0., -v.z(), v.y(), v.z(), 0., -v.x(), -v.y(), v.x(), 0.;
  return matrix;
}

// Covariance of -w x t / 2, to be added to that of t: in (t, w) the error is normal, but delta is the logarithm of the
// motion about the camera's centre, and t = v + w x C holds of it to first order only; to second order -w x t / 2 comes
// in. From afar t is a long way in depth, and that term as large as the error across. Its second moment by Isserlis'
// theorem (Biometrika 12, 1918).
Eigen::Matrix3d secondOrder(const Eigen::Matrix<double, 6, 6> &covariance)
{
  const auto sign = [](int i, int j, int k) { return 0.5 * (i - j) * (j - k) * (k - i); };
  const Eigen::Matrix3d tt = covariance.topLeftCorner<3, 3>();
  const Eigen::Matrix3d wt = covariance.bottomLeftCorner<3, 3>();
  const Eigen::Matrix3d ww = covariance.bottomRightCorner<3, 3>();
  Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      // Component i of a cross product has two terms: of the axes a and b that follow it, in either order.
      for (const int a : {(i + 1) % 3, (i + 2) % 3}) {
        for (const int c : {(j + 1) % 3, (j + 2) % 3}) {
          const int b = 3 - i - a;
          const int d = 3 - j - c;
          moment(i, j) +=
              0.25 * sign(i, a, b) * sign(j, c, d) * (wt(a, b) * wt(c, d) + ww(a, c) * tt(b, d) + wt(a, d) * wt(c, b));
        }
      }
    }
  }
  return moment;
}

// From (t, w) about the marker's centre to (v, w) of exp(delta) about the camera's: t = v + w x C.
vpMatrix covarianceInCamera(const FittedPose &fit, bool spinIsKnown)
{
  Eigen::Matrix<double, 6, 6> local = fit.covariance;
  local.topLeftCorner<3, 3>() += secondOrder(fit.covariance);
  if (!spinIsKnown) {
    const Eigen::Vector3d normal = fit.plane.rotation.col(2);
    local.bottomRightCorner<3, 3>() += unknownAngleVariance * normal * normal.transpose();
  }
  Eigen::Matrix<double, 6, 6> change = Eigen::Matrix<double, 6, 6>::Identity();
  change.topRightCorner<3, 3>() = crossMatrix(fit.plane.center);
  const Eigen::Matrix<double, 6, 6> camera = change * local * change.transpose();
  vpMatrix covariance(6, 6);
  for (unsigned int row = 0; row < 6; ++row) {
    for (unsigned int column = 0; column < 6; ++column) {
      covariance[row][column] = 0.5 * (camera(row, column) + camera(column, row));
    }
  }
  return covariance;
}

Eigen::Vector2d outlinePoint(const MarkerPlane &plane, const CameraModel &camera, unsigned int i, unsigned int count)
{
  const double angle = 2. * M_PI * i / count;
  return camera.toPixel(plane.project(Eigen::Vector2d(std::cos(angle), std::sin(angle))));
}

vpImageEllipse ellipseOf(const MarkerPlane &plane, const CameraModel &camera)
{
  std::array<Eigen::Vector2d, outlinePoints> points;
  for (unsigned int i = 0; i < outlinePoints; ++i) {
    points[i] = outlinePoint(plane, camera, i, outlinePoints);
  }
  vpImageEllipse ellipse;
  const auto conic = fitEllipse(points.data(), points.size());
  const auto parameters = conic ? ellipseFromConic(*conic) : std::nullopt;
  if (parameters) {
    ellipse.center = vpImagePoint(parameters->center.y(), parameters->center.x());
    ellipse.a = parameters->a;
    ellipse.b = parameters->b;
    ellipse.angle = parameters->angle;
  }
  return ellipse;
}
} // namespace

std::vector<vpImagePoint> outlineOf(const Recognition &marker, const MarkerPlane &plane, const CameraModel &camera,
                                    unsigned int count)
{
  const MarkerPlane reported = withReportedSpin(marker, plane);
  std::vector<vpImagePoint> outline;
  outline.reserve(count);
  for (unsigned int i = 0; i < count; ++i) {
    const Eigen::Vector2d p = outlinePoint(reported, camera, i, count);
    outline.emplace_back(p.y(), p.x());
  }
  return outline;
}

vpCircleMarkerDetection reportOf(const Recognition &marker, const Measurement &measurement, const CameraModel &camera,
                                 double visible, bool zAligned)
{
  const bool spinIsKnown = marker.family.isCoded();
  const auto framed = [&](const MarkerPlane &plane) { return poseOf(withReportedSpin(marker, plane), zAligned); };
  const MarkerPlane &plane = measurement.first.plane;
  vpCircleMarkerDetection detection;
  detection.family = marker.family;
  detection.id = marker.code.id;
  detection.hamming = marker.code.hamming;
  detection.margin = std::max(marker.code.margin, 0.);
  detection.size = 2. * plane.radius;
  detection.dof = spinIsKnown ? 6 : 5;
  const Eigen::Vector2d center = camera.toPixel(plane.project(Eigen::Vector2d::Zero()));
  detection.center = vpImagePoint(center.y(), center.x());
  detection.ellipse = ellipseOf(plane, camera);
  detection.cMo = framed(plane);
  detection.cost = measurement.cost;
  if (measurement.second) {
    detection.hasSecondPose = true;
    detection.cMo2 = framed(measurement.second->plane);
    detection.cost2 = measurement.cost2;
    detection.logOdds = measurement.cost2 - measurement.cost;
  }
  detection.covariance = covarianceInCamera(measurement.first, spinIsKnown);
  detection.visible = visible;
  return detection;
}
} // namespace circle_marker
END_VISP_NAMESPACE
