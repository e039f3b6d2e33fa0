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
 * Outlines of plane regions as unordered sets of directed segments.
 */

#ifndef VP_SIMULATOR_OUTLINE_H
#define VP_SIMULATOR_OUTLINE_H

#include <vector>

#include <visp3/circle_marker_simulator/vpConfigCircleMarkerSimulator.h>

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

//! A point of the image, in pixels, or of a marker's plane, in metres.
struct PlanePoint
{
  double x;
  double y;
};

//! A directed piece of an outline.
struct Segment
{
  PlanePoint from;
  PlanePoint to;
};

/*!
  Boundary of a region: directed segments in any order that together form closed curves, turning from +x toward +y
  around the region (and the other way around its holes). With that sense the region's area is the sum of
  (x_from y_to - x_to y_from) / 2. Because order does not matter, cutting regions needs no linking of pieces.
*/
using Outline = std::vector<Segment>;

//! Rectangle parallel to the axes.
struct Box
{
  double left;
  double top;
  double right;
  double bottom;
};

//! Smallest box around an outline; left > right for an empty one.
Box boundingBox(const Outline &outline);

//! Area of the region, in square units.
double area(const Outline &outline);

//! The same boundary run the other way: a region becomes a hole.
void reverse(Outline &outline);

//! Whether a point is inside of the region (winding number above 0).
bool isInside(const Outline &outline, const PlanePoint &point);

/*!
  Outline of \e region without \e cover.

  The result consists of the pieces of the region's boundary outside of the cover, and of the pieces of the cover's
  boundary inside of the region, reversed. Edges of the two that lie on one another must be avoided by the caller: the
  layers of a scene are displaced by multiples of 1e-7 pixels for this.
*/
Outline subtract(const Outline &region, const Outline &cover);

//! Outline of the part of \e region in the rectangle \e frame, under the same condition.
Outline intersect(const Outline &region, const Outline &frame);

//! Outline of a box.
Outline outlineOf(const Box &box);

} // namespace marker_simulator
END_VISP_NAMESPACE

#endif
