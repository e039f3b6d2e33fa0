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
 * How well the pose of an outline is known that is not refined.
 */

#include "refine/closed_form.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include "pose/circle_covariance.h"
#include "pose/circle_evidence.h"
#include "refine/fit_starts.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
using Column = Eigen::Matrix<double, 6, 1>;
using Matrix = Eigen::Matrix<double, 6, 6>;

// The gradient that finds edge points is a mean over pixels: so many neighbouring points have the same noise.
constexpr double sharedNoise = 3.;
// Points are placed on the parabola through three gradients to this, pixels, however little noise there is.
constexpr double leastNoise = 0.02;
// All points are too far out or in by this, pixels: grey levels are not linear, ink spreads.
constexpr double tooWide = 0.03;
// And so are, by as much as this, those where the quiet zone is narrower than a usual blur: what lies beyond it
// moves the steepest place of the edge.
constexpr double mostByGround = 0.4; // pixels
constexpr double blur = 1.2;         // pixels, standard deviation
// A blurred edge of curvature k lies k blur^2 / 2 nearer to the centre of its bend, where it bends more than it blurs.
constexpr double byCurvature = 0.5 * blur * blur; // pixels^2
// Phases of the sectors' grid are tried in steps of this part of a sector; the reading is off by up to half of one.
constexpr double stepOfPhase = 1. / 8.;

// By how much each mode of what all points may have in common would move the pose. inverse: of the points' information.
void addCommonErrors(const EllipseCandidate &outline, const std::vector<Eigen::Vector2d> &meters,
                     const CirclePosition &circle, double quietZone, double meterPerPixel, const Matrix &inverse,
                     Matrix &covariance)
{
  Column wide = Column::Zero();
  Column narrow = Column::Zero();
  Column bent = Column::Zero();
  const double product = outline.ellipse.a * outline.ellipse.b;
  for (std::size_t i = 0; i < meters.size(); ++i) {
    const EdgePoint &point = outline.points[i];
    const Column byShift = meterPerPixel * circleDistanceJacobian(circle, meters[i]).transpose();
    // Of the tangent from the centre: the quiet zone's width there is a share of it, and its cube tells the curvature.
    const double height = std::abs(point.normal().dot(point.position - outline.ellipse.center));
    wide += tooWide * byShift;
    narrow += mostByGround * std::exp(-0.5 * std::pow(quietZone * height / blur, 2.)) * byShift;
    bent += byCurvature * std::pow(height, 3.) / (product * product) * byShift;
  }
  for (const Column &pull : {wide, narrow, bent}) {
    const Column moved = inverse * pull;
    covariance += moved * moved.transpose();
  }
}
} // namespace

Eigen::Matrix<double, 6, 6> closedFormCovariance(const EllipseCandidate &outline, const MarkerPlane &plane,
                                                 const vpCircleMarkerFamily &family, const CameraModel &camera)
{
  const CirclePosition circle = {plane.center, plane.rotation.col(2)};
  std::vector<Eigen::Vector2d> meters;
  meters.reserve(outline.points.size());
  for (const EdgePoint &point : outline.points) {
    meters.push_back(camera.toMeter(point.position));
  }
  const double pixel = meterPerPixelAt(plane, camera);
  const double freedom = std::max(static_cast<double>(meters.size()) - 5., 1.);
  const double left = squaredDistances(circle, plane.radius, meters) / freedom;
  const double variance = sharedNoise * (left + std::pow(leastNoise * pixel, 2.));
  Matrix covariance = circleCovariance(circle, meters, std::sqrt(variance));
  addCommonErrors(outline, meters, circle, family.getLayout().quietZone, pixel, Matrix(covariance / variance),
                  covariance);
  // From exp(delta) about the camera's centre to (t, w) about the marker's: t = v + w x C.
  Matrix change = Matrix::Identity();
  const Eigen::Vector3d &c = plane.center;
  change.topRightCorner<3, 3>() << 0., c.z(), -c.y(), -c.z(), 0., c.x(), c.y(), -c.x(), 0.;
  covariance = change * covariance * change.transpose();
  // The outline says nothing of the spin: circleCovariance() has the variance of a uniform angle in its place.
  const double spin = family.isCoded() ? 0.5 * stepOfPhase * 2. * M_PI / family.getNbSectors() : 0.;
  covariance.bottomRightCorner<3, 3>() += (spin * spin - M_PI * M_PI / 3.) * circle.normal * circle.normal.transpose();
  return covariance;
}
} // namespace circle_marker
END_VISP_NAMESPACE
