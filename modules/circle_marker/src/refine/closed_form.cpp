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
#include <array>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "decode/code_track.h"
#include "pose/circle_covariance.h"
#include "pose/circle_evidence.h"
#include "refine/fit_starts.h"
#include "support/bilinear.h"
#include "support/cross_matrix.h"
#include "support/median.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
using Column = Eigen::Matrix<double, 6, 1>;
using Matrix = Eigen::Matrix<double, 6, 6>;

// The gradient that finds edge points is a mean over pixels: so many neighbouring points have the same noise.
constexpr double sharedNoise = 3.;
// Points are placed on the parabola through three gradients to this, pixels, however little noise there is.
constexpr double leastNoise = 0.02;
// All points are too far out or in by this, pixels: grey levels are not linear, ink spreads. And by this share of the
// blur, which is seldom as even as a Gaussian.
constexpr double tooWide = 0.03;
constexpr double tooWideInBlur = 0.1; // of what the blur has beyond the usual one
// And so are, by as much as this share of the blur, those where the quiet zone or the ring is narrower than the blur:
// what lies beyond moves the steepest place of the edge.
constexpr double mostByNeighbour = 0.35;
// The blur, pixels, standard deviation, is this at least, and is measured along the outline to this factor.
constexpr double leastBlur = 1.2;
constexpr double blurSlack = 1.3;
// What covers a part of the outline draws the points beside it along, a part of it or another, by this, pixels.
constexpr double byCover = 0.5;

// Blur across the outline, pixels: an edge of the step h blurred by sigma is h / (sqrt(2 pi) sigma) steep. The median
// of some points.
double blurAlong(const vpImage<unsigned char> &I, const EllipseCandidate &outline)
{
  constexpr std::size_t most = 32;
  std::array<double, most> blurs;
  std::size_t count = 0;
  const std::size_t step = outline.points.size() / most + 1;
  for (std::size_t i = 0; i < outline.points.size() && count < most; i += step) {
    const EdgePoint &point = outline.points[i];
    const auto outside = bilinear(I, point.position + 0.5 * point.normal());
    const auto inside = bilinear(I, point.position - 0.5 * point.normal());
    if (outside && inside && *outside > *inside) {
      blurs[count++] = outline.contrast / (std::sqrt(2. * M_PI) * (*outside - *inside));
    }
  }
  if (count == 0) {
    return leastBlur;
  }
  return std::max(leastBlur, blurSlack * medianOf(blurs, count));
}

// By how much the pose moves if all points move outward in ways that they may have in common, each a column.
class CommonErrors
{
public:
  CommonErrors(const vpCircleMarkerFamily &family, const EllipseCandidate &outline, double blur)
      : m_layout(family.getLayout()), m_outline(outline), m_blur(blur),
        m_wide(tooWide + tooWideInBlur * (blur - leastBlur))
  {
  }

  // A point, and the derivative of its distance by the pose, for a shift of one pixel.
  void add(const EdgePoint &point, const Column &byShift)
  {
    const EllipseParameters &ellipse = m_outline.ellipse;
    // Of the tangent from the centre: the widths of quiet zone and ring are shares of it, and its cube tells the
    // curvature: a blurred edge of curvature k lies k blur^2 / 2 nearer to the centre of its bend.
    const double height = std::abs(point.normal().dot(point.position - ellipse.center));
    const double curvature = std::pow(height, 3.) / std::pow(ellipse.a * ellipse.b, 2.);
    m_columns[0] += m_wide * byShift;
    m_columns[1] += nearTo(m_layout.quietZone * height) * byShift;
    m_columns[2] += nearTo((1. - m_layout.ringInner) * height) * byShift;
    m_columns[3] += 0.5 * m_blur * m_blur * std::min(curvature, 1. / m_blur) * byShift;
    if (isPartMissing(m_outline.support)) {
      const Eigen::Vector2d from = point.position - ellipse.center;
      m_columns[from.x() > 0. ? (from.y() > 0. ? 4 : 5) : (from.y() > 0. ? 6 : 7)] += byCover * byShift;
    }
  }

  // inverse: of the points' information.
  void addTo(Matrix &covariance, const Matrix &inverse) const
  {
    for (const Column &column : m_columns) {
      const Column moved = inverse * column;
      covariance += moved * moved.transpose();
    }
  }

private:
  // Shift, pixels, by what lies so far beyond the edge.
  double nearTo(double width) const { return mostByNeighbour * m_blur * std::exp(-0.5 * std::pow(width / m_blur, 2.)); }

  const vpCircleMarkerLayout m_layout;
  const EllipseCandidate &m_outline;
  const double m_blur; // pixels
  const double m_wide; // pixels
  std::array<Column, 8> m_columns = {Column::Zero(), Column::Zero(), Column::Zero(), Column::Zero(),
                                     Column::Zero(), Column::Zero(), Column::Zero(), Column::Zero()};
};
} // namespace

Eigen::Matrix<double, 6, 6> closedFormCovariance(const vpImage<unsigned char> &I, const EllipseCandidate &outline,
                                                 const MarkerPlane &plane, const vpCircleMarkerFamily &family,
                                                 const CameraModel &camera, std::vector<Eigen::Vector2d> &meters)
{
  const CirclePosition circle = {plane.center, plane.rotation.col(2)};
  meters.clear();
  for (const EdgePoint &point : outline.points) {
    meters.push_back(camera.toMeter(point.position));
  }
  const double pixel = meterPerPixelAt(plane, camera);
  const double freedom = std::max(static_cast<double>(meters.size()) - 5., 1.);
  const double left = squaredDistances(circle, plane.radius, meters) / freedom;
  const double variance = sharedNoise * (left + std::pow(leastNoise * pixel, 2.));
  Matrix covariance = circleCovariance(circle, meters, std::sqrt(variance));
  const Matrix inverse = covariance / variance;
  CommonErrors errors(family, outline, blurAlong(I, outline));
  for (std::size_t i = 0; i < meters.size(); ++i) {
    const EdgePoint &point = outline.points[i];
    // Of a line that moves by one pixel along its normal, in the normalised image plane.
    const double shift = 1. / (camera.meterPerPixel(point.position).inverse().transpose() * point.normal()).norm();
    errors.add(point, shift * circleDistanceJacobian(circle, meters[i]).transpose());
  }
  errors.addTo(covariance, inverse);
  // From exp(delta) about the camera's centre to (t, w) about the marker's: t = v + w x C.
  Matrix change = Matrix::Identity();
  change.topRightCorner<3, 3>() = crossMatrix(-plane.center);
  covariance = change * covariance * change.transpose();
  // The outline says nothing of the spin: circleCovariance() has the variance of a uniform angle in its place.
  // The reading of a code is off by up to half of a phase.
  const double spin = family.isCoded() ? M_PI / (phasesPerSector * family.getNbSectors()) : 0.;
  covariance.bottomRightCorner<3, 3>() +=
      (spin * spin - uniformSpinVariance) * circle.normal * circle.normal.transpose();
  return covariance;
}
} // namespace circle_marker
END_VISP_NAMESPACE
