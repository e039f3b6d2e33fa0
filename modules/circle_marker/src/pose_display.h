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
 * What is drawn of a pose in an image's display.
 */

#ifndef VP_CIRCLE_MARKER_POSE_DISPLAY_H
#define VP_CIRCLE_MARKER_POSE_DISPLAY_H

#include <array>
#include <optional>

#include <Eigen/Geometry>

#include <visp3/core/vpColor.h>
#include <visp3/core/vpDisplay.h>
#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/core/vpImagePoint.h>

#include "support/camera_model.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  The pixel at which a point of the marker's frame is seen, metres; nothing if it is not in front of the camera.
  vpDisplay::displayFrame() goes by kud, which the pose does not know of: where it is no exact inverse of kdu, that is
  beside the marker, by 3 pixels in the corner of a wide lens.
*/
inline std::optional<vpImagePoint> seenPoint(const Eigen::Vector3d &point, const vpHomogeneousMatrix &cMo,
                                             const CameraModel &camera)
{
  Eigen::Vector3d seen;
  for (unsigned int row = 0; row < 3; ++row) {
    seen[row] = cMo[row][0] * point.x() + cMo[row][1] * point.y() + cMo[row][2] * point.z() + cMo[row][3];
  }
  const Eigen::Vector2d pixel = camera.toPixel(seen.hnormalized());
  return seen.z() > 0. && pixel.allFinite() ? std::make_optional(vpImagePoint(pixel.y(), pixel.x())) : std::nullopt;
}

/*! The axes of the marker's frame, of a length in metres; vpColor::none: in red, green and blue. */
template <class Pixel>
void displayAxes(const vpImage<Pixel> &I, const vpHomogeneousMatrix &cMo, const CameraModel &camera, double length,
                 const vpColor &color, unsigned int thickness)
{
  constexpr unsigned int head = 4; // pixels and that much wide, as vpDisplay::displayFrame() has it
  const std::array<vpColor, 3> colors = {vpColor::red, vpColor::green, vpColor::blue};
  const auto origin = seenPoint(Eigen::Vector3d::Zero(), cMo, camera);
  for (unsigned int axis = 0; axis < 3; ++axis) {
    const auto tip = seenPoint(length * Eigen::Vector3d::Unit(axis), cMo, camera);
    if (origin && tip) {
      vpDisplay::displayArrow(I, *origin, *tip, color == vpColor::none ? colors[axis] : color, head, head / 2,
                              thickness);
    }
  }
}
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
