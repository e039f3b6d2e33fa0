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
 * The dark line that is left of a thin ring.
 */

/*!
  \file ellipse/dark_line.h
  \brief The dark line that is left of a ring whose width is below the blur's.
*/

#ifndef VP_CIRCLE_MARKER_DARK_LINE_H
#define VP_CIRCLE_MARKER_DARK_LINE_H

#include <cstddef>
#include <vector>

#include <visp3/core/vpImage.h>

#include "edges/edge_points.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! Which closed edge near a thin ring is seen. */
enum class RingNeighbour
{
  INSIDE, //!< That of the white inside of the ring.
  SHEET   //!< That of the sheet, on ground brighter or darker than paper.
};

/*! How much of an edge is asked for a line. */
struct LineSearch
{
  std::size_t most = 48; //!< Directions at most.
  double least = 0.;     //!< Share of them that must show a line: the search ends where that cannot be any more.
};

/*!
  Follows the directions from a closed edge to the first dark line on the way to the ring, from the white inside away
  from it, from the sheet towards its middle; to a fraction of a pixel by a parabola through three samples.
  \param I : The image.
  \param points, count : The closed edge.
  \param neighbour : What it is the edge of.
  \param rise : By how much, in grey levels, the line must be darker than what lies before and beyond it.
  \param search : How much of the edge is asked.
  \param line : The points of the line, with the way out of the ring as the way across.
  \return The share of directions that show a line; something below search.least if it is less than that.
*/
double darkLineBeside(const vpImage<unsigned char> &I, const EdgePoint *points, std::size_t count,
                      RingNeighbour neighbour, double rise, const LineSearch &search, std::vector<EdgePoint> &line);

/*!
  A first look at a few directions from the middle of a closed chain of pixels: most of what is no ring shows it there.
*/
bool mayHaveDarkLineBeside(const vpImage<unsigned char> &I, const EdgePixel *pixels, std::size_t count,
                           RingNeighbour neighbour, double rise);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
