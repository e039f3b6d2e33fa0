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

/*!
  \file symmetric_eigen.h
  \brief Eigenvalues and eigenvectors of symmetric matrices of six rows, compiled once: Eigen's solver takes ten seconds
  of a compiler for each file that has it.
*/

#ifndef VP_CIRCLE_MARKER_SYMMETRIC_EIGEN_H
#define VP_CIRCLE_MARKER_SYMMETRIC_EIGEN_H

#include <Eigen/Core>

#include <visp3/circle_marker/vpConfigCircleMarker.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! A symmetric matrix: vectors * values * vectors^T. */
struct SymmetricEigen
{
  Eigen::Matrix<double, 6, 1> values;  //!< Ascending.
  Eigen::Matrix<double, 6, 6> vectors; //!< Columns, of length 1.
};

/*! \param matrix : Symmetric; only its lower triangle is read. */
SymmetricEigen symmetricEigen(const Eigen::Matrix<double, 6, 6> &matrix);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
