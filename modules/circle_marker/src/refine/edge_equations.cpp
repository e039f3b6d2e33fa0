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
 * How a pose follows the edges of its marker when they are moved in the image.
 */

#include "refine/edge_equations.h"

#include "support/cross_matrix.h"
#include "support/symmetric_eigen.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Eigenvalues below this share of the largest are none: the spin of a marker without a code.
constexpr double noInformation = 1e-9;
} // namespace

EdgeEquations::Seen EdgeEquations::add(const MarkerEdge &edge)
{
  const Eigen::Vector3d arm = m_plane.radius * (m_plane.rotation.leftCols<2>() * edge.place);
  const Eigen::Vector3d p = m_plane.center + arm;
  Eigen::Matrix<double, 2, 3> byPoint; // of the normalised coordinates
  byPoint << 1., 0., -p.x() / p.z(), 0., 1., -p.y() / p.z();
  byPoint /= p.z();
  Eigen::Matrix<double, 3, 6> pointByPose; // the point moves by t + w x arm
  pointByPose << Eigen::Matrix3d::Identity(), crossMatrix(-arm);
  Seen seen;
  seen.byPlace = m_plane.radius * (byPoint * m_plane.rotation.leftCols<2>());
  const Eigen::Vector2d tangent = seen.byPlace * edge.along;
  seen.meter = p.head<2>() / p.z();
  seen.across = Eigen::RowVector2d(-tangent.y(), tangent.x()).normalized();
  seen.byPose = (seen.across * byPoint * pointByPose).transpose();
  m_matrix += seen.byPose * seen.byPose.transpose();
  return seen;
}

PoseColumns EdgeEquations::solve(const PoseColumns &right) const
{
  // Translations in radii, so that all unknowns are of one size.
  Eigen::Matrix<double, 6, 1> unit;
  unit << Eigen::Vector3d::Constant(m_plane.radius), Eigen::Vector3d::Ones();
  const SymmetricEigen eigen = symmetricEigen(unit.asDiagonal() * m_matrix * unit.asDiagonal());
  const double least = noInformation * eigen.values[5];
  const Eigen::Matrix<double, 6, 1> inverse = (eigen.values.array() > least).select(eigen.values.cwiseInverse(), 0.);
  const PoseColumns turned = eigen.vectors.transpose() * (unit.asDiagonal() * right);
  return unit.asDiagonal() * (eigen.vectors * (inverse.asDiagonal() * turned));
}
} // namespace circle_marker
END_VISP_NAMESPACE
