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

#include <cmath>
#include <cstdio>
#include <utility>

#include "marker_shapes.h"

namespace create {
namespace {
const double fullTurn = 2 * std::acos(-1.);

/*! Adjacent black sectors as one shape: drawn apart, a hair of paper would show along their common edge. */
void addCode(const vpCircleMarkerFamily &family, int id, double radius, double x, double y,
             std::vector<AnnularSector> &shapes)
{
  const unsigned int n = family.getNbSectors();
  const vpCircleMarkerLayout &layout = family.getLayout();
  for (unsigned int first = 0; first < n; ++first) {
    const bool startsRun = family.isSectorBlack(id, first) && !family.isSectorBlack(id, (first + n - 1) % n);
    if (!startsRun) {
      continue;
    }
    unsigned int length = 1;
    while (family.isSectorBlack(id, (first + length) % n)) {
      ++length; // Ends: a marker's word is not constant.
    }
    shapes.push_back(AnnularSector{x, y, radius * layout.codeOuter, radius * layout.codeInner, fullTurn * first / n,
                                   fullTurn * length / n});
  }
}
} // namespace

double squareSide(const vpCircleMarkerFamily &family, double diameter)
{
  return diameter * (1 + family.getLayout().quietZone);
}

double diameterInSquare(const vpCircleMarkerFamily &family, double side)
{
  return side / (1 + family.getLayout().quietZone);
}

std::vector<Shape> markerShapes(const vpCircleMarkerFamily &family, int id, double diameter, bool isInverse, double x,
                                double y)
{
  const double radius = diameter / 2;
  std::vector<AnnularSector> shapes;
  shapes.push_back(AnnularSector{x, y, radius, radius * family.getLayout().ringInner, 0, fullTurn});
  if (family.isCoded()) {
    addCode(family, id, radius, x, y, shapes);
  }
  if (isInverse) { // One shape: white drawn over black leaves a dark hair on the edges.
    const double side = squareSide(family, diameter);
    return {PiercedSquare{x - side / 2, y - side / 2, side, std::move(shapes)}};
  }
  return std::vector<Shape>(shapes.begin(), shapes.end());
}

std::string millimetres(double length)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.2f", length);
  std::string shortest = text;
  shortest.erase(shortest.find_last_not_of('0') + 1);
  if (shortest.back() == '.') {
    shortest.pop_back();
  }
  return shortest;
}

std::string caption(const vpCircleMarkerFamily &family, int id, double diameter, bool isInverse)
{
  const bool isDisc = family.getType() == vpCircleMarkerFamily::DISC;
  std::string text = family.getName() + (isInverse ? "  inverse" : "");
  if (family.isCoded()) {
    text += "  id " + std::to_string(id) + "  ring ";
  }
  else if (!isDisc) {
    text += " of ratio " + millimetres(family.getLayout().ringInner) + "  ";
  }
  else {
    text += "  ";
  }
  return text + millimetres(diameter) + " mm";
}
} // namespace create
