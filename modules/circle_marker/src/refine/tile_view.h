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
 * The neighbourhood of a marker's edges, tile by tile.
 */

/*!
  \file tile_view.h
  \brief Which pixels of the image are near an edge of the print: looked through in tiles of laneCount pixels in either
  direction, because most tiles are far from all edges.
*/

#ifndef VP_CIRCLE_MARKER_TILE_VIEW_H
#define VP_CIRCLE_MARKER_TILE_VIEW_H

#include <array>
#include <cmath>

#include "refine/lane_lists.h"
#include "refine/plane_point.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
constexpr double tileHalf = 0.5 * (laneCount - 1);      // pixels, from its first pixel to its centre
constexpr double tileRadius = 0.7072 * (laneCount - 1); // pixels, from its centre to its corners
// Sectors that are narrower than this at the track's outer rim, in units of the band, are used as a whole.
constexpr double narrowSector = 3.;

/*! A tile as one hypothesis sees it: the plane to first order around the tile's centre. */
struct Tile
{
  PlanePoint center;
  // Of the plane in the image's coordinates where the blur is round: a direction o of the plane has the gradient
  // sqrt(o' metric o).
  Eigen::Matrix2d metric;
  double mostGradient = 0.; // of any direction, in those coordinates
  double reach = 0.;        // how far from the tile's centre an edge may be that it sees, on the plane
  // Unit vectors across edges between sectors, toward the black side, divided by their gradient.
  std::array<Eigen::Vector2f, 3> borders;
  int bordersSeen = 0;
  bool isBlack = false;     // its centre's sector
  bool everySector = false; // sectors are so narrow that there is no need to look for their borders
};

/*! A look at one hypothesis of the pose, tile by tile. */
class TileView
{
public:
  // band: how far a pixel may be from an edge, pixels, in the coordinates where the blur is round.
  TileView(const MarkerPlane &plane, const MarkerPattern &pattern, double band, const Eigen::Matrix2d &blurShape)
      : m_plane(plane), m_pattern(pattern), m_band(band), m_blurShape(blurShape)
  {
  }

  // Whether any pixel of a tile may be near an edge.
  bool enter(const ModelPixel &center)
  {
    m_tile.center = planePoint(center, m_plane);
    const Eigen::Matrix2d byRound = m_tile.center.byPixel * m_blurShape;
    m_tile.metric = byRound * byRound.transpose();
    m_tile.mostGradient = byRound.norm();
    m_tile.reach = m_band * m_tile.mostGradient + tileRadius * m_tile.center.byPixel.norm();
    const double radius = m_tile.center.q.norm();
    // However the tile lies, the radius changes by no more than this to its corners.
    const double change = m_tile.reach;
    bool isNear = false;
    for (unsigned int i = 0; i < m_pattern.ringEdges; ++i) {
      isNear = isNear || std::abs(radius - m_pattern.ring[i].radius) < change;
    }
    if (m_pattern.sectors == 0) {
      return isNear;
    }
    if (radius > m_pattern.track[0].radius + change || radius < m_pattern.track[1].radius - change) {
      return isNear;
    }
    const bool seesBorders = seeBorders(radius);
    const bool isAtRim =
        std::abs(radius - m_pattern.track[0].radius) < change || std::abs(radius - m_pattern.track[1].radius) < change;
    return isNear || seesBorders || (isAtRim && m_tile.isBlack);
  }

  // Where the tile's centre is.
  const PlanePoint &center() const { return m_tile.center; }

  // Distance of the pixels of a row of the tile to the nearest edge; row: its distance below the tile's centre, pixels.
  Lanes distances(double row) const
  {
    const Eigen::Vector2f middle = (m_tile.center.q + row * m_tile.center.byPixel.col(1)).cast<float>();
    const Eigen::Vector2f step = m_tile.center.byPixel.col(0).cast<float>();
    const Lanes offset = Lanes::LinSpaced(-static_cast<float>(tileHalf), static_cast<float>(tileHalf));
    const Lanes qx = middle.x() + step.x() * offset;
    const Lanes qy = middle.y() + step.y() * offset;
    const Lanes radius = (qx * qx + qy * qy).max(1e-12f).sqrt();
    const Eigen::Matrix2f metric = m_tile.metric.cast<float>();
    const Lanes perGradient =
        radius * (metric(0, 0) * qx * qx + 2.f * metric(0, 1) * qx * qy + metric(1, 1) * qy * qy).rsqrt();
    const auto toCircle = [&](const RadialEdge &edge) -> Lanes {
      return (radius - static_cast<float>(edge.radius)).abs() * perGradient;
    };
    Lanes nearest = toCircle(m_pattern.ring[0]);
    if (m_pattern.ringEdges > 1) {
      nearest = nearest.min(toCircle(m_pattern.ring[1]));
    }
    if (m_pattern.sectors == 0) {
      return nearest;
    }
    const Lanes toRim = toCircle(m_pattern.track[0]).min(toCircle(m_pattern.track[1]));
    // Outside of the track a border counts from the rim on: the larger of both distances is near enough.
    const Lanes outside = ((radius - static_cast<float>(m_pattern.track[0].radius))
                               .max(static_cast<float>(m_pattern.track[1].radius) - radius)
                               .max(0.f)) *
                          perGradient;
    if (m_tile.everySector) {
      return nearest.min(toRim).min(outside);
    }
    // The rims are edges where the track is black: on the black side of the nearest border, and a band beyond.
    Lanes toBorder = Lanes::Constant(HUGE_VALF);
    Lanes toBlack = Lanes::Constant(m_tile.isBlack ? 0.f : HUGE_VALF);
    for (int k = 0; k < m_tile.bordersSeen; ++k) {
      const Eigen::Vector2f &across = m_tile.borders[static_cast<std::size_t>(k)];
      const Lanes inside = across.x() * qx + across.y() * qy;
      const Lanes distance = inside.abs();
      const Lanes white = (-inside).max(0.f);
      toBlack = k == 0 ? white : chosen(distance, toBorder, white, toBlack);
      toBorder = toBorder.min(distance);
    }
    return nearest.min(toRim.max(toBlack)).min(toBorder.max(outside));
  }

private:
  // The edges between sectors that a tile may see; whether there are any.
  bool seeBorders(double radius)
  {
    const double sectorAngle = 2. * M_PI / m_pattern.sectors;
    m_tile.everySector = sectorAngle * m_pattern.track[0].radius < narrowSector * m_band * m_tile.mostGradient ||
                         m_tile.reach > sectorAngle * radius;
    m_tile.bordersSeen = 0;
    if (m_tile.everySector) {
      return true;
    }
    const int nearest = m_pattern.nearestBorder(m_tile.center.q);
    m_tile.isBlack =
        m_pattern.isBlack(m_pattern.acrossBorder(nearest).dot(m_tile.center.q) > 0. ? nearest : nearest - 1);
    for (int border = nearest - 1; border <= nearest + 1; ++border) {
      if (m_pattern.isBlack(border) == m_pattern.isBlack(border - 1)) {
        continue;
      }
      const Eigen::Vector2d &across = m_pattern.acrossBorder(border);
      const double gradient = std::sqrt(across.dot(m_tile.metric * across));
      const double perPixel = (m_tile.center.byPixel.transpose() * across).norm();
      if (std::abs(across.dot(m_tile.center.q)) < m_band * gradient + tileRadius * perPixel) {
        const double toBlack = m_pattern.isBlack(border) ? 1. : -1.;
        m_tile.borders[static_cast<std::size_t>(m_tile.bordersSeen++)] = (toBlack / gradient * across).cast<float>();
      }
    }
    return m_tile.bordersSeen > 0;
  }

  const MarkerPlane &m_plane;
  const MarkerPattern &m_pattern;
  const double m_band; // pixels
  const Eigen::Matrix2d m_blurShape;
  Tile m_tile;
};
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
