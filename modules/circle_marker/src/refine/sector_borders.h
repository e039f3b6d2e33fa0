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
 * The borders between the sectors of a code track.
 */

#ifndef VP_CIRCLE_MARKER_SECTOR_BORDERS_H
#define VP_CIRCLE_MARKER_SECTOR_BORDERS_H

#include <array>
#include <cmath>

#include <Eigen/Core>

#include "decode/code_track.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! Where the sectors of a code track lie on the plane. */
class SectorBorders
{
public:
  /*!
    \param sectors : Their number.
    \param start : Where the first one begins, from the plane's x axis, rad.
  */
  SectorBorders(int sectors, double start) : m_sectors(sectors), m_start(start), m_pitch(2. * M_PI / sectors)
  {
    for (int k = 0; k < sectors; ++k) {
      const double angle = start + k * m_pitch;
      m_across[static_cast<std::size_t>(k)] = {-std::sin(angle), std::cos(angle)};
    }
  }

  int count() const { return m_sectors; }

  /*! An angle from the plane's x axis in sectors from where the first one begins; by any number of turns. */
  double place(double angle) const { return (angle - m_start) / m_pitch; }

  /*! An angle in sectors. */
  double inSectors(double angle) const { return angle / m_pitch; }

  /*! The sector with a number that counts on through the turns. */
  int sector(int number) const
  {
    const int rest = number % m_sectors;
    return rest < 0 ? rest + m_sectors : rest;
  }

  /*! The unit normal, toward larger angles, of the border where the sector with such a number begins. */
  const Eigen::Vector2d &across(int number) const { return m_across[static_cast<std::size_t>(sector(number))]; }

private:
  int m_sectors;
  double m_start; // rad
  double m_pitch; // rad
  std::array<Eigen::Vector2d, mostSectors> m_across;
};
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
