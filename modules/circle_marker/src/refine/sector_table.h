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
 * The sectors of a code as pixels near them see them.
 */

/*!
  \file sector_table.h
  \brief What pixels see of a code: the borders between sectors that are near, and what lies between them.
*/

#ifndef VP_CIRCLE_MARKER_SECTOR_TABLE_H
#define VP_CIRCLE_MARKER_SECTOR_TABLE_H

#include <array>
#include <cmath>

#include "refine/lane_tables.h"
#include "refine/marker_pattern.h"
#include "refine/pixel_blocks.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
// Angle of vectors in [-pi, pi], to 1e-3 rad: enough to know the nearest border.
inline Lanes roughAngle(const Lanes &x, const Lanes &y)
{
  const Lanes width = x.abs();
  const Lanes height = y.abs();
  const Lanes t = width.min(height) / width.max(height).max(1e-12f);
  // Chebyshev's polynomial of the arc tangent on [0, 1], odd, of degree 5.
  const Lanes square = t * t;
  const Lanes octant = t * (0.995354f + square * (-0.288679f + square * 0.079331f));
  const Lanes quadrant = octant + isPositive(height - width) * (1.5707963f - 2.f * octant);
  const Lanes half = quadrant + isPositive(-x) * (3.1415927f - 2.f * quadrant);
  return half * (1.f - 2.f * isPositive(-y));
}

// For each border between sectors, what a pixel sees to which it is the nearest.
class SectorTable
{
public:
  SectorTable(const MarkerPattern &pattern, int borders)
      : m_sectors(static_cast<float>(pattern.sectors)), m_borders(borders)
  {
    for (unsigned int sector = 0; sector < pattern.sectors; ++sector) {
      const int nearest = static_cast<int>(sector);
      m_acrossX.entries[sector] = static_cast<float>(pattern.acrossBorder(nearest).x());
      m_acrossY.entries[sector] = static_cast<float>(pattern.acrossBorder(nearest).y());
      const int first = nearest - borders / 2;
      float before = pattern.darknessOf(first - 1);
      m_base.entries[sector] = before;
      for (int k = 0; k < borders; ++k) {
        const float after = pattern.darknessOf(first + k);
        m_change[static_cast<std::size_t>(k)].entries[sector] = after - before;
        before = after;
      }
      m_isEdge.entries[sector] = pattern.darknessOf(nearest) != pattern.darknessOf(nearest - 1) ? 1.f : 0.f;
    }
  }

  // 1 for pixels at an angle on the plane that are farther than a margin from the border nearest to them, or have none
  // there, else 0.
  Lanes seesNoBorder(const Lanes &radius, const Lanes &margin, const Lanes &angle) const
  {
    const Lanes turned = bordersFrom(angle);
    const Lanes border = turned.floor();
    const Lanes isEdge = entriesOf(m_isEdge, numberOf(border));
    const Lanes away = (turned - border - 0.5f).abs() * (6.2831853f / m_sectors) * radius;
    return (isPositive(away - margin) + 1.f - isEdge).min(1.f);
  }

  // Puts what the pixels of a block see that are at (x, y) on the marker's plane.
  void put(const Lanes &x, const Lanes &y, SectorLanes &sectors) const
  {
    const Lanes border = numberOf(bordersFrom(roughAngle(x, y)).floor());
    sectors.acrossX = entriesOf(m_acrossX, border);
    sectors.acrossY = entriesOf(m_acrossY, border);
    sectors.base = entriesOf(m_base, border);
    for (int k = 0; k < m_borders; ++k) {
      sectors.change[k + (mostBorders - m_borders) / 2] = entriesOf(m_change[static_cast<std::size_t>(k)], border);
    }
  }

private:
  // Angles counted in sectors, from -n / 2 to n / 2, shifted by n so that cutting off rounds to the nearest border.
  Lanes bordersFrom(const Lanes &angle) const { return angle * (m_sectors * 0.15915494f) + (m_sectors + 0.5f); }

  // A border's number, of one from that turn or the turn before.
  Lanes numberOf(const Lanes &border) const { return border - m_sectors * isPositive(border - (m_sectors - 0.5f)); }

  // Of each border.
  LaneTable m_acrossX, m_acrossY, m_base;
  std::array<LaneTable, mostBorders> m_change;
  LaneTable m_isEdge; // 1 if the sectors to its sides differ
  float m_sectors;
  int m_borders;
};
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
