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
 * The black shapes of one circular marker.
 */

#ifndef VP_CREATE_MARKER_SHAPES_H
#define VP_CREATE_MARKER_SHAPES_H

#include <string>
#include <vector>

#include <visp3/circle_marker/vpCircleMarkerFamily.h>

#include "shapes.h"

namespace create {
#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

/*! The id of the markers of a family without a code. */
constexpr int noId = -1;

/*! Side, millimetres, of the square that holds a marker of the given ring diameter and its quiet zone. */
double squareSide(const vpCircleMarkerFamily &family, double diameter);

/*! Ring diameter, millimetres, of the marker that fills a square with its quiet zone. */
double diameterInSquare(const vpCircleMarkerFamily &family, double side);

/*!
  The shapes of a marker at spin 0: sector 0 of the code starts at +x and the sectors follow toward +y.

  \param family : Layout and code.
  \param id : The marker; noId for a family without a code.
  \param diameter : Outer diameter of the ring, millimetres.
  \param isInverse : Whether black and white are exchanged, in the marker and in the square of its quiet zone.
  \param x, y : Centre on the page, millimetres.
  \exception vpException::badValue : If the family has no such id.
*/
std::vector<Shape> markerShapes(const vpCircleMarkerFamily &family, int id, double diameter, bool isInverse, double x,
                                double y);

/*! What is written beside a marker: "golay23  id 5  ring 180 mm". */
std::string caption(const vpCircleMarkerFamily &family, int id, double diameter, bool isInverse);

/*! A length with up to two decimals, none of them useless: "180", "52.5". */
std::string millimetres(double length);
} // namespace create

#endif
