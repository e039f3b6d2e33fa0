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
 * What a doubtful calibration of the camera adds to the covariance of a pose.
 */

#include "refine/camera_doubt.h"

#include <cmath>

#include "support/cross_matrix.h"
#include "support/symmetric_eigen.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Points along each circle, and along each border between sectors: the least squares of smooth functions.
constexpr int pointsOfCircle = 32;
constexpr int pointsOfBorder = 2;
// Eigenvalues below this share of the largest are none: the spin of a marker without a code.
constexpr double noInformation = 1e-9;

// The normal equations of the pose and its right-hand sides, one for each of the camera's parameters.
class EdgeEquations
{
public:
  EdgeEquations(const MarkerPlane &plane, const CameraModel &camera) : m_plane(plane), m_camera(camera) {}

  // An edge through the point q of the plane; along: its direction there.
  void add(const Eigen::Vector2d &q, const Eigen::Vector2d &along)
  {
    const Eigen::Vector3d arm = m_plane.radius * (m_plane.rotation.leftCols<2>() * q);
    const Eigen::Vector3d p = m_plane.center + arm;
    Eigen::Matrix<double, 2, 3> byPoint; // of the normalised coordinates
    byPoint << 1., 0., -p.x() / p.z(), 0., 1., -p.y() / p.z();
    byPoint /= p.z();
    Eigen::Matrix<double, 3, 6> byPose; // the point moves by t + w x arm
    byPose << Eigen::Matrix3d::Identity(), crossMatrix(-arm);
    const Eigen::Vector2d tangent = byPoint * (m_plane.rotation.leftCols<2>() * along);
    const Eigen::RowVector2d across = Eigen::RowVector2d(-tangent.y(), tangent.x()).normalized();
    const Eigen::Matrix<double, 1, 6> row = across * byPoint * byPose;
    const Eigen::Vector2d pixel = m_camera.toPixel(p.head<2>() / p.z());
    m_matrix += row.transpose() * row;
    m_right += row.transpose() * (across * m_camera.meterByParameters(pixel));
  }

  Eigen::Matrix<double, 6, 4> solve() const
  {
    // Translations in radii, so that all unknowns are of one size.
    Eigen::Matrix<double, 6, 1> unit;
    unit << Eigen::Vector3d::Constant(m_plane.radius), Eigen::Vector3d::Ones();
    const SymmetricEigen eigen = symmetricEigen(unit.asDiagonal() * m_matrix * unit.asDiagonal());
    const double least = noInformation * eigen.values[5];
    const Eigen::Matrix<double, 6, 1> inverse = (eigen.values.array() > least).select(eigen.values.cwiseInverse(), 0.);
    const Eigen::Matrix<double, 6, 4> turned = eigen.vectors.transpose() * (unit.asDiagonal() * m_right);
    return unit.asDiagonal() * (eigen.vectors * (inverse.asDiagonal() * turned));
  }

private:
  const MarkerPlane &m_plane;
  const CameraModel &m_camera;
  Eigen::Matrix<double, 6, 6> m_matrix = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 4> m_right = Eigen::Matrix<double, 6, 4>::Zero();
};

Eigen::Vector2d directionAt(double angle)
{
  return Eigen::Vector2d(std::cos(angle), std::sin(angle));
}
} // namespace

Eigen::Matrix<double, 6, 4> poseByCamera(const MarkerPlane &plane, const vpCircleMarkerFamily &family,
                                         const CameraModel &camera)
{
  const vpCircleMarkerLayout &layout = family.getLayout();
  EdgeEquations equations(plane, camera);
  for (const double radius : {1., layout.ringInner}) {
    for (int i = 0; i < pointsOfCircle && radius > 0.; ++i) { // a disc has no inner edge
      const Eigen::Vector2d direction = directionAt(2. * M_PI * i / pointsOfCircle);
      equations.add(radius * direction, Eigen::Vector2d(-direction.y(), direction.x()));
    }
  }
  const int sectors = family.isCoded() ? static_cast<int>(family.getNbSectors()) : 0;
  for (int k = 0; k < sectors; ++k) {
    const Eigen::Vector2d direction = directionAt(2. * M_PI * k / sectors);
    for (int i = 0; i < pointsOfBorder; ++i) {
      const double share = (i + 0.5) / pointsOfBorder;
      equations.add((layout.codeInner + share * (layout.codeOuter - layout.codeInner)) * direction, direction);
    }
  }
  return equations.solve();
}

void addCameraDoubt(const Eigen::Matrix4d &covariance, const vpCircleMarkerFamily &family, const CameraModel &camera,
                    FittedPose &fit)
{
  if (covariance.isZero(0.)) {
    return;
  }
  const Eigen::Matrix<double, 6, 4> derivative = poseByCamera(fit.plane, family, camera);
  fit.covariance += derivative * covariance * derivative.transpose();
}
} // namespace circle_marker
END_VISP_NAMESPACE
