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
 * The cross product as a matrix.
 */

#ifndef VP_CIRCLE_MARKER_CROSS_MATRIX_H
#define VP_CIRCLE_MARKER_CROSS_MATRIX_H

#include <Eigen/Core>

#include <visp3/circle_marker/vpConfigCircleMarker.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! The matrix that maps w to v x w. */
inline Eigen::Matrix3d crossMatrix(const Eigen::Vector3d &v)
{
  Eigen::Matrix3d matrix;
  matrix << 0., -v.z(), v.y(), v.z(), 0., -v.x(), -v.y(), v.x(), 0.;
  return matrix;
}
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
