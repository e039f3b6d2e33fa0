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
 * Eigenvalues and eigenvectors of covariances of poses.
 */

#include "support/symmetric_eigen.h"

#include <Eigen/Eigenvalues>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
SymmetricEigen symmetricEigen(const Eigen::Matrix<double, 6, 6> &matrix)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> solver(matrix);
  return {solver.eigenvalues(), solver.eigenvectors()};
}
} // namespace circle_marker
END_VISP_NAMESPACE
