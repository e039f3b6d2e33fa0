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
 * Where markers are, so that nothing is sought inside of them.
 */

#include "decode/marker_places.h"

#include <cmath>

#include <Eigen/Geometry>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Inside a ring there is room for another marker in its white centre only, of this radius in units of the ring's.
constexpr double whiteCenter = 0.4;
} // namespace

void MarkerPlaces::reset(int width, int height)
{
  m_places.clear();
  m_index.reset(width, height);
}

void MarkerPlaces::add(const EllipseParameters &outline, bool isDisc)
{
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(-outline.angle).toRotationMatrix();
  const Eigen::Matrix2d toUnit = Eigen::Vector2d(1. / outline.a, 1. / outline.b).asDiagonal() * turn;
  const auto number = static_cast<int>(m_places.size());
  m_places.push_back({outline, toUnit, isDisc ? 0. : whiteCenter});
  // Half the sides of the box around an ellipse: the norms of its axes' components.
  const double halfWidth = std::hypot(outline.a * turn(0, 0), outline.b * turn(1, 0));
  const double halfHeight = std::hypot(outline.a * turn(0, 1), outline.b * turn(1, 1));
  m_index.addBox(number, outline.center.x() - halfWidth, outline.center.y() - halfHeight,
                 outline.center.x() + halfWidth, outline.center.y() + halfHeight);
}

bool MarkerPlaces::hold(const EllipseParameters &outline) const
{
  return m_index.any(outline.center.x(), outline.center.y(), 0., [&](int number) {
    const Place &place = m_places[static_cast<std::size_t>(number)];
    // Distance of the centres, and the larger reach of the outline, in units of the marker.
    const double distance = (place.toUnit * (outline.center - place.outline.center)).norm();
    const double reach = distance + outline.a / place.outline.a;
    return distance < 1. && reach > place.room;
  });
}
} // namespace circle_marker
END_VISP_NAMESPACE
