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
 * The ring on a small sheet, by the sheet's shape.
 */

/*!
  \file ellipse/sheet_ring.h
  \brief The ring on a small sheet, by the sheet's shape.
*/

#ifndef VP_CIRCLE_MARKER_SHEET_RING_H
#define VP_CIRCLE_MARKER_SHEET_RING_H

#include <cstddef>
#include <optional>

#include <visp3/core/vpImage.h>

#include "edges/edge_points.h"
#include "ellipse/conic.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  A first look: whether a closed chain of pixels encloses something as compact as a square or a disc, small enough, with
  a dark line in it.
  \param I : The image.
  \param pixels, count : The chain.
  \param rise : By how much, in grey levels, the line must be darker than what lies before and beyond it.
*/
bool mayBeSheet(const vpImage<unsigned char> &I, const EdgePixel *pixels, std::size_t count, double rise);

/*! The same of edge points, once around the sheet; where some are missing, a straight line goes on from one to the
 * next. */
bool mayBeSheet(const vpImage<unsigned char> &I, const EdgePoint *points, std::size_t count, double rise);

/*!
  The dark circle in the middle of a sheet that is seen at a slant, so narrow that no direction shows it for certain. A
  square and a disc alike have the shape of their circles in their second moments, seen from afar: only the size of the
  circle is left to be sought, on all directions together.
  \param I : The image.
  \param points, count : The sheet's closed edge.
  \param rise : By how much, in grey levels, the line must be darker than what lies before and beyond it.
  \return The ellipse in the middle of the dark line; nothing if there is none.
*/
std::optional<EllipseParameters> darkLineOfSheet(const vpImage<unsigned char> &I, const EdgePoint *points,
                                                 std::size_t count, double rise);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
