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
 * What vpPoseCircle holds.
 */

#include "pose/pose_circle_impl.h"

#include <cmath>

#include <visp3/core/vpException.h>

#include "ellipse/fit_conic.h"
#include "pose/circle_evidence.h"
#include "pose/image_ellipse.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
void refuse(const std::string &reason)
{
  throw vpException(vpException::badValue, "vpPoseCircle: " + reason);
}

bool isPositive(double value)
{
  return value > 0. && std::isfinite(value);
}

bool isDeviation(double value)
{
  constexpr double least = 1e-12; // its square divides: what is measured to 1e-12 is exact
  return std::isfinite(value) && value >= least;
}

Eigen::Matrix3d conicFromMatrix(const vpMatrix &Q)
{
  if (Q.getRows() != 3 || Q.getCols() != 3) {
    throw vpException(vpException::dimensionError, "vpPoseCircle: the conic must be a 3 x 3 matrix, not %u x %u",
                      Q.getRows(), Q.getCols());
  }
  Eigen::Matrix3d conic;
  for (unsigned int i = 0; i < 3; i++) {
    for (unsigned int j = 0; j < 3; j++) {
      conic(i, j) = 0.5 * Q[i][j] + 0.5 * Q[j][i];
    }
  }
  return conic;
}

Eigen::Matrix3d conicFromCoefficients(const vpColVector &K)
{
  if (K.size() != 5 && K.size() != 6) {
    throw vpException(vpException::dimensionError, "vpPoseCircle: a conic has 5 or 6 coefficients, not %u", K.size());
  }
  // The five coefficients are the last five of six whose first is 1.
  const unsigned int shift = (K.size() == 5) ? 1 : 0;
  const double first = shift ? 1. : K[0];
  Eigen::Matrix3d conic;
  conic << first, K[2 - shift], K[3 - shift], K[2 - shift], K[1 - shift], K[4 - shift], K[3 - shift], K[4 - shift],
      K[5 - shift];
  return conic;
}

CenteredEllipse ellipseOrReason(const Eigen::Matrix3d &Q)
{
  if (const std::optional<CenteredEllipse> ellipse = centerConic(Q)) {
    return *ellipse;
  }
  if (!Q.allFinite()) {
    refuse("a coefficient of the conic is not finite");
  }
  const double scale = Q.cwiseAbs().maxCoeff();
  if (!(scale > 0.)) {
    refuse("all coefficients of the conic are zero");
  }
  const Eigen::Matrix2d A = Q.topLeftCorner<2, 2>() / scale;
  if (A(0, 0) * A(1, 1) - A(0, 1) * A(0, 1) < 0.) {
    refuse("the conic is a hyperbola: the circle crosses the plane of the camera's centre, or it is not a circle");
  }
  refuse("the conic is not an ellipse of visible size: a point, a parabola, a line or an imaginary ellipse");
}

} // namespace circle_marker

using namespace circle_marker;

namespace {
CenteredEllipse ellipseOfPoints(const std::vector<Eigen::Vector2d> &points)
{
  if (points.size() < 5) {
    throw vpException(vpException::notInitialized,
                      "vpPoseCircle: %u contour points are too few: give at least 5, or a measured ellipse",
                      static_cast<unsigned int>(points.size()));
  }
  const std::optional<Eigen::Matrix3d> Q = fitEllipse(points.data(), points.size());
  if (!Q) {
    refuse("no ellipse fits the contour points: they lie on a line or on fewer than 5 places");
  }
  return ellipseOrReason(*Q);
}
} // namespace

void vpPoseCircle::Impl::setEllipse(const CenteredEllipse &ellipse)
{
  m_points.clear();
  m_ellipse = ellipse;
}

void vpPoseCircle::Impl::addPoints(const std::vector<Eigen::Vector2d> &points)
{
  for (const Eigen::Vector2d &point : points) {
    if (!point.allFinite()) {
      refuse("a contour point is not finite");
    }
  }
  m_points.insert(m_points.end(), points.begin(), points.end()); // or nothing, and then the ellipse stays
  m_ellipse.reset();
}

CenteredEllipse vpPoseCircle::Impl::ellipse() const
{
  return m_ellipse ? *m_ellipse : ellipseOfPoints(m_points);
}

std::vector<Eigen::Vector2d> vpPoseCircle::Impl::contour() const
{
  return m_ellipse ? sampleEllipse(*m_ellipse, samplesOfAnEllipse) : m_points;
}

double vpPoseCircle::Impl::logOdds(const std::array<CirclePosition, 2> &circles) const
{
  double sum = 0.;
  if (!m_concentric.empty()) {
    sum += concentricLogOdds(circles, m_concentricRadius, m_concentric, m_sigma, contour().size());
  }
  if (m_priorNormal) {
    sum += normalLogOdds(circles, *m_priorNormal, m_priorSigma);
  }
  return sum;
}

vpHomogeneousMatrix vpPoseCircle::Impl::pose(const CirclePosition &circle) const
{
  vpHomogeneousMatrix cMo = poseFromCirclePosition(circle);
  if (!m_zAligned) {
    // Half a turn about x: y and z change their signs.
    for (unsigned int i = 0; i < 3; i++) {
      cMo[i][1] = -cMo[i][1];
      cMo[i][2] = -cMo[i][2];
    }
  }
  return cMo;
}
END_VISP_NAMESPACE
