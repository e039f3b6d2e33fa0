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
 * From pixels to the marker's plane, a vector of them at a time.
 */

#include "refine/plane_lanes.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
PlaneHomography::PlaneHomography(const MarkerPlane &plane, const ImageReference &reference,
                                 const Eigen::Matrix2d &blurShape)
    : m_suu(static_cast<float>(blurShape(0, 0))), m_suv(static_cast<float>(blurShape(0, 1))),
      m_svv(static_cast<float>(blurShape(1, 1))), m_isBent(plane.bend.isAny()),
      m_bow(static_cast<float>(plane.bend.bow)), m_saddleX(static_cast<float>(plane.bend.saddle.x())),
      m_saddleY(static_cast<float>(plane.bend.saddle.y()))
{
  // The camera's centre and the ray m = (x, y, 1) in the marker's frame meet its plane at
  // q = (c_x n - c_z e_x, c_y n - c_z e_y) m / (n m), with the frame's axes e_x, e_y, n in that of the camera.
  const Eigen::Vector3d c = -plane.rotation.transpose() * plane.center / plane.radius;
  m_cx = static_cast<float>(c.x());
  m_cy = static_cast<float>(c.y());
  m_perDepth = static_cast<float>(-1. / c.z());
  const Eigen::Vector3d normal = plane.rotation.col(2);
  const Eigen::Vector3d origin(reference.meter.x(), reference.meter.y(), 1.);
  const double perSlope = 1. / normal.dot(origin);
  const Eigen::Vector3d rowX = perSlope * (c.x() * normal - c.z() * plane.rotation.col(0));
  const Eigen::Vector3d rowY = perSlope * (c.y() * normal - c.z() * plane.rotation.col(1));
  const Eigen::Vector3d rowW = perSlope * normal;
  m_axx = static_cast<float>(reference.unit * rowX.x());
  m_axy = static_cast<float>(reference.unit * rowX.y());
  m_ayx = static_cast<float>(reference.unit * rowY.x());
  m_ayy = static_cast<float>(reference.unit * rowY.y());
  m_wx = static_cast<float>(reference.unit * rowW.x());
  m_wy = static_cast<float>(reference.unit * rowW.y());
  m_bx = static_cast<float>(rowX.dot(origin));
  m_by = static_cast<float>(rowY.dot(origin));
}
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE
