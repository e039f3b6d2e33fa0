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
// Of the white of a ring without a code: an outline that reaches nearer to the ring's inner edge is that edge again.
constexpr double roomOfWhite = 0.95;

// Radius of the white in a marker's middle, in units of its outer radius.
double roomOf(const Recognition &marker)
{
  const vpCircleMarkerFamily &family = marker.family;
  return family.isCoded() ? family.getLayout().codeInner : roomOfWhite * family.getLayout().ringInner; // 0 for a disc
}

// Whether a circle about the centre of a marker's print holds an outline, as eight of its points show it.
bool isWithin(const EllipseParameters &outline, const MarkerPlane &plane, double radius, const CameraModel &camera)
{
  constexpr int points = 8;
  const Eigen::Rotation2Dd turn(outline.angle);
  for (int i = 0; i < points; ++i) {
    const double t = 2. * M_PI * i / points;
    const Eigen::Vector2d point =
        outline.center + turn * Eigen::Vector2d(outline.a * std::cos(t), outline.b * std::sin(t));
    if (!(plane.intersect(camera.toMeter(point)).norm() <= radius)) {
      return false;
    }
  }
  return true;
}
} // namespace

void MarkerPlaces::reset(int width, int height)
{
  m_places.clear();
  m_index.reset(width, height);
}

void MarkerPlaces::add(const EllipseCandidate &outline, const Recognition &marker)
{
  keep({outline.ellipse, outline.rank(), Eigen::Matrix2d::Zero(), roomOf(marker), marker.poses});
}

void MarkerPlaces::add(const EllipseCandidate &outline)
{
  keep({outline.ellipse, outline.rank(), Eigen::Matrix2d::Zero(), 0., PosePair()});
}

void MarkerPlaces::keep(Place place)
{
  const EllipseParameters &outline = place.outline;
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(-outline.angle).toRotationMatrix();
  place.toUnit = Eigen::Vector2d(1. / outline.a, 1. / outline.b).asDiagonal() * turn;
  const auto number = static_cast<int>(m_places.size());
  const Eigen::Vector2d half = halfExtents(outline);
  const Eigen::Vector2d least = outline.center - half;
  const Eigen::Vector2d most = outline.center + half;
  m_index.addBox(number, least.x(), least.y(), most.x(), most.y());
  m_places.push_back(place);
}

bool MarkerPlaces::hold(const EllipseCandidate &candidate, const CameraModel &camera) const
{
  const EllipseParameters &outline = candidate.ellipse;
  return m_index.any(outline.center.x(), outline.center.y(), 0., [&](int number) {
    const Place &place = m_places[static_cast<std::size_t>(number)];
    if (candidate.rank() > place.rank || (place.toUnit * (outline.center - place.outline.center)).norm() >= 1.) {
      return false;
    }
    return place.room <= 0. || (!isWithin(outline, place.poses[0], place.room, camera) &&
                                !isWithin(outline, place.poses[1], place.room, camera));
  });
}
} // namespace circle_marker
END_VISP_NAMESPACE
