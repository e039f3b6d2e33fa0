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
 * A page: markers, captions, cut marks and the scale bar.
 */

#ifndef VP_CREATE_PAGE_H
#define VP_CREATE_PAGE_H

#include <vector>

#include "marker_shapes.h"
#include "sheet_layout.h"
#include "shapes.h"

namespace create {
/*! A marker on a page: its id and its centre, millimetres. */
struct PlacedMarker
{
  int id;
  double x, y;
};

struct Page
{
  Picture picture;
  std::vector<PlacedMarker> markers;
};

/*! Just the square of a marker and its quiet zone, the marker in its middle. */
Page squarePage(const vpCircleMarkerFamily &family, int id, double diameter, bool isInverse);

/*!
  A sheet with markers, each with a caption and cut marks, and a scale bar at the foot. Nothing but the markers enters
  their squares.
  \e diameter: Of the rings, millimetres.
  \e isInverse: Whether the markers are white on black.
  \e ids: At most as many as capacity(sheet, squareSide(family, diameter)).
*/
Page sheetPage(const vpCircleMarkerFamily &family, const std::vector<int> &ids, double diameter, bool isInverse,
               const Sheet &sheet);
} // namespace create

#endif
