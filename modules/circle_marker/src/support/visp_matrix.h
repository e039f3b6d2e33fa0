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
 * Eigen's matrices as ViSP's.
 */

#ifndef VP_CIRCLE_MARKER_VISP_MATRIX_H
#define VP_CIRCLE_MARKER_VISP_MATRIX_H

#include <Eigen/Core>

#include <visp3/circle_marker/vpConfigCircleMarker.h>
#include <visp3/core/vpMatrix.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! The same matrix for a user. */
template <int rows, int columns> vpMatrix vispMatrix(const Eigen::Matrix<double, rows, columns> &matrix)
{
  vpMatrix copy(rows, columns);
  for (unsigned int i = 0; i < rows; ++i) {
    for (unsigned int j = 0; j < columns; ++j) {
      copy[i][j] = matrix(i, j);
    }
  }
  return copy;
}
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
