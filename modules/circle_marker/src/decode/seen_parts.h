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
 * Parts of a marker that nothing covers.
 */

#ifndef VP_CIRCLE_MARKER_SEEN_PARTS_H
#define VP_CIRCLE_MARKER_SEEN_PARTS_H

#include <array>
#include <bitset>
#include <cmath>

#include "decode/code_track.h"
#include "decode/cyclic_code.h"
#include "pose/marker_plane.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! What is seen of a marker, by directions from its centre and three zones: ring, code track and centre. */
struct SeenParts
{
  MarkerPlane plane;               //!< The pose at which it was looked at.
  unsigned int directions = 0;     //!< Their number.
  double gap = 0.;                 //!< Radius between ring and track, in units of the outer radius.
  double core = 0.;                //!< Radius inside of which is the centre.
  std::bitset<mostSamples> ring;   //!< Directions that show the ring.
  std::bitset<mostSamples> track;  //!< Directions that show the code track.
  std::bitset<mostSamples> center; //!< Directions in which the centre is white.

  /*! Whether a point of the image, in normalised coordinates, is in a part that is seen. */
  bool holds(const Eigen::Vector2d &meter) const
  {
    const Eigen::Vector2d q = plane.intersect(meter);
    const std::size_t direction = directionOf(q);
    const double squared = q.squaredNorm();
    return squared > gap * gap ? ring[direction] : squared > core * core ? track[direction] : center[direction];
  }

  /*! Whether a point of the image, in normalised coordinates, is on the code track, seen or not. */
  bool isOnTrack(const Eigen::Vector2d &meter) const
  {
    const double squared = plane.intersect(meter).squaredNorm();
    return squared <= gap * gap && squared > core * core;
  }

  /*!
    Number of the borders between black and white sectors that are seen, with the directions beside them.
    \param word : The code: its first bit of so many is sector 0.
    \param sectors : Their number.
    \param pose : The marker, with its spin.
  */
  unsigned int bordersSeen(CyclicCode::Word word, unsigned int sectors, const MarkerPlane &pose) const
  {
    const double middle = 0.5 * (gap + core);
    unsigned int seen = 0;
    for (unsigned int k = 0; k < sectors; ++k) {
      const unsigned int before = (k + sectors - 1) % sectors;
      const double angle = 2. * M_PI * k / sectors;
      const std::size_t here =
          directionOf(plane.intersect(pose.project(middle * Eigen::Vector2d(std::cos(angle), std::sin(angle)))));
      const bool isEdge = isSectorBlack(word, k, sectors) != isSectorBlack(word, before, sectors);
      const bool isSeen = track[here] && track[(here + 1) % directions] && track[(here + directions - 1) % directions];
      seen += isEdge && isSeen ? 1 : 0;
    }
    return seen;
  }

  /*! In how many pieces what is not seen of the track lies, around the centre; 0 if all or nothing is. */
  unsigned int piecesNotSeen() const
  {
    unsigned int pieces = 0;
    for (unsigned int direction = 0; direction < directions; ++direction) {
      pieces += !track[direction] && track[(direction + 1) % directions] ? 1 : 0;
    }
    return pieces;
  }

  /*! Share of the ring that is seen. */
  double shareOfRing() const { return static_cast<double>(ring.count()) / directions; }

private:
  // The direction in which a point of the plane lies.
  std::size_t directionOf(const Eigen::Vector2d &q) const
  {
    const double turns = std::atan2(q.y(), q.x()) / (2. * M_PI) + 1.;
    return static_cast<std::size_t>(turns * directions) % directions;
  }
};
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
