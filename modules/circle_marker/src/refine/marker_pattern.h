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
 * The print of a marker, as its model of the image needs it.
 */

#ifndef VP_CIRCLE_MARKER_MARKER_PATTERN_H
#define VP_CIRCLE_MARKER_MARKER_PATTERN_H

#include <array>
#include <cmath>
#include <cstdint>

#include <Eigen/Core>

#include "decode/cyclic_code.h"
#include "decode/paper_end.h"

#include <visp3/circle_marker/vpCircleMarkerFamily.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! An edge between white and black that is a circle about the marker's centre. */
struct RadialEdge
{
  double radius; //!< In units of the ring's outer radius.
};

/*! What is printed: black between radii, and black sectors of the code track. Unit: the ring's outer radius. */
struct MarkerPattern
{
  std::array<RadialEdge, 2> ring{};  //!< Edges of the ring; a disc has the first alone.
  unsigned int ringEdges = 0;        //!< Their number.
  std::array<RadialEdge, 2> track{}; //!< Outer and inner edge of the code track.
  PaperEnds paper{};                 //!< Where the white paper around it ends at the earliest.
  unsigned int sectors = 0;          //!< Number of sectors of the track; 0 without a code.
  //! Of each sector: 0 is white, 1 is black, between them where it is as it was read.
  std::array<float, 31> darkness{};
  //! For each sector, the unit vector across its first border, toward the sector.
  std::array<Eigen::Vector2d, 31> across{};

  //! Sets black sectors where a word has ones.
  void setWord(std::uint32_t word)
  {
    for (unsigned int k = 0; k < sectors; ++k) {
      darkness[k] = isSectorBlack(word, k, sectors) ? 1.f : 0.f;
    }
  }

  float darknessOf(int sector) const { return darkness[wrap(sector)]; }

  bool isBlack(int sector) const { return darknessOf(sector) > 0.5f; }

  const Eigen::Vector2d &acrossBorder(int sector) const { return across[wrap(sector)]; }

  //! The border, of those before sector 0, 1, ..., that is nearest in angle to a point of the plane.
  int nearestBorder(const Eigen::Vector2d &q) const
  {
    return static_cast<int>(std::lround(std::atan2(q.y(), q.x()) * sectors / (2. * M_PI)));
  }

  //! The sector from 0 to n - 1 that a number of any turn stands for: a remainder would take longer than all the rest.
  unsigned int wrap(int sector) const
  {
    const int n = static_cast<int>(sectors);
    while (sector < 0) {
      sector += n;
    }
    while (sector >= n) {
      sector -= n;
    }
    return static_cast<unsigned int>(sector);
  }
};

/*! Where the white paper around a marker ends at the earliest: at the end of its quiet zone. */
inline PaperEnds papersAround(const vpCircleMarkerLayout &layout)
{
  const double extent = 1. + layout.quietZone;
  return {PaperEnd{PaperShape::ROUND, extent, 0.}, PaperEnd{PaperShape::SQUARE, extent, 0.}};
}

/*!
  The pattern of a marker.
  \param family : Family of the marker.
  \param id : Identity; not used without a code.
*/
inline MarkerPattern patternOf(const vpCircleMarkerFamily &family, int id)
{
  MarkerPattern pattern;
  const double ringInner = family.getLayout().ringInner; // 0 of a disc
  pattern.paper = papersAround(family.getLayout());
  pattern.ring[pattern.ringEdges++] = {1.};
  if (ringInner > 0.) {
    pattern.ring[pattern.ringEdges++] = {ringInner};
  }
  if (family.isCoded()) {
    pattern.track = {RadialEdge{family.getLayout().codeOuter}, RadialEdge{family.getLayout().codeInner}};
    pattern.sectors = family.getNbSectors();
    pattern.setWord(family.getCodeword(id));
    for (unsigned int k = 0; k < pattern.sectors; ++k) {
      const double angle = 2. * M_PI * k / pattern.sectors;
      pattern.across[k] = Eigen::Vector2d(-std::sin(angle), std::cos(angle));
    }
  }
  return pattern;
}
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
