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

#include <Eigen/Geometry>

#include "ellipse/fit_conic.h"
#include "pose/circle_covariance.h"
#include "support/cross_matrix.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Points from which the image ellipse is described: with lens distortion it is the ellipse nearest to the curve.
constexpr unsigned int outlinePoints = 64;

// A marker without a code has no spin of its own: it gets that of the convention, whatever the refinement did.
MarkerPlane withReportedSpin(const Recognition &marker, const MarkerPlane &plane)
{
  return marker.family.isCoded() ? plane : planeOf({plane.center, plane.rotation.col(2)}, plane.radius);
}

void putPose(const MarkerPlane &plane, bool zAligned, vpHomogeneousMatrix &pose)
{
  // A half turn about x takes z into the marker and y down to z toward the camera and y up.
  const Eigen::Vector3d turn = zAligned ? Eigen::Vector3d(1., 1., 1.) : Eigen::Vector3d(1., -1., -1.);
  for (unsigned int row = 0; row < 3; ++row) {
    for (unsigned int column = 0; column < 3; ++column) {
      pose[row][column] = plane.rotation(row, column) * turn[column];
    }
    pose[row][3] = plane.center[row];
  }
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

void putSymmetric(const Eigen::Matrix<double, 6, 6> &matrix, vpMatrix &covariance)
{
  covariance.resize(6, 6, false, false);
  for (unsigned int row = 0; row < 6; ++row) {
    for (unsigned int column = 0; column < 6; ++column) {
      covariance[row][column] = 0.5 * (matrix(row, column) + matrix(column, row));
    }
  }
}

// Of (t, w) about the marker's centre, and of (v, w) of exp(delta) about the camera's: t = v + w x C.
void putCovariances(const FittedPose &fit, bool spinIsKnown, vpMatrix &atMarker, vpMatrix &atCamera)
{
  Eigen::Matrix<double, 6, 6> local = fit.covariance;
  if (!spinIsKnown) {
    const Eigen::Vector3d normal = fit.plane.rotation.col(2);
    local.bottomRightCorner<3, 3>() += uniformSpinVariance * normal * normal.transpose();
  }
  putSymmetric(local, atMarker);
  // The spin of a convention moves nothing: it has no part in the second order.
  local.topLeftCorner<3, 3>() += secondOrder(fit.covariance);
  Eigen::Matrix<double, 6, 6> change = Eigen::Matrix<double, 6, 6>::Identity();
  change.topRightCorner<3, 3>() = crossMatrix(fit.plane.center);
  putSymmetric(change * local * change.transpose(), atCamera);
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

void putOutline(const Recognition &marker, const MarkerPlane &plane, const CameraModel &camera, unsigned int count,
                std::vector<vpImagePoint> &outline)
{
  const MarkerPlane reported = withReportedSpin(marker, plane);
  outline.resize(count);
  for (unsigned int i = 0; i < count; ++i) {
    const Eigen::Vector2d p = outlinePoint(reported, camera, i, count);
    outline[i].set_ij(p.y(), p.x());
  }
}

void putReport(const Recognition &marker, const Measurement &measurement, const CameraModel &camera, double visible,
               bool zAligned, vpCircleMarkerDetection &detection)
{
  const bool spinIsKnown = marker.family.isCoded();
  const MarkerPlane &plane = measurement.first.plane;
  detection.family = marker.family;
  detection.id = marker.code.id;
  detection.hamming = marker.code.hamming;
  detection.margin = std::max(marker.code.margin, 0.);
  detection.size = 2. * plane.radius;
  detection.dof = spinIsKnown ? 6 : 5;
  const Eigen::Vector2d center =
      camera.toPixel(plane.center.hnormalized()); // of a bent sheet beside the print's middle
  detection.center.set_ij(center.y(), center.x());
  detection.ellipse = ellipseOf(plane, camera);
  putPose(withReportedSpin(marker, plane), zAligned, detection.cMo);
  detection.cost = measurement.cost;
  detection.hasSecondPose = measurement.second.has_value();
  if (measurement.second) {
    putPose(withReportedSpin(marker, measurement.second->plane), zAligned, detection.cMo2);
    putCovariances(*measurement.second, spinIsKnown, detection.covarianceAtMarker2, detection.covariance2);
    detection.cost2 = measurement.cost2;
    detection.logOdds = measurement.cost2 - measurement.cost;
  }
  else {
    detection.cMo2.eye();
    detection.covariance2.resize(6, 6, true, false);
    detection.covarianceAtMarker2.resize(6, 6, true, false);
    detection.cost2 = HUGE_VAL;
    detection.logOdds = HUGE_VAL;
  }
  putCovariances(measurement.first, spinIsKnown, detection.covarianceAtMarker, detection.covariance);
  detection.isInverse = false;
  detection.visible = visible;
}
} // namespace circle_marker
END_VISP_NAMESPACE
