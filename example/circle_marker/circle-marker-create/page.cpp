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

#include <algorithm>
#include <optional>

#include "page.h"

namespace create {
namespace {
constexpr double hairline = 0.2;      // Thickness of cut marks and scale bar: thin, yet every printer draws it.
constexpr double cutMarkOffset = 0.5; // Between the quiet zone and a cut mark: a cut on the line leaves no black.
constexpr double cutMarkLength = 3;   // Two face to face fit the gap between squares.
constexpr double edgeMarkLength = 15; // Along the square where there is no room beside it: longer than the 4 mm or so
                                      // at the edge of the paper that printers leave out.
constexpr double textHeight = 3.5;
constexpr double scaleBarLength = 100;

/*! The cut mark of one corner for the cut along x; the one along y by exchanging the axes. */
struct CutMark
{
  double from, to; // Along the cut.
  double across;   // Position of the cut.
};

/*!
  A mark that prolongs a cut beyond the corner, or, without room there, runs along the square just outside of it.
  Nothing where the cut is the edge of the paper.

  \param corner, outward : Position of the corner along the cut, and -1 or +1, away from the square.
  \param cut, cutOutward : Position of the cut and its direction away from the square.
  \param extent, cutExtent : Size of the paper along the cut and across it.
*/
std::optional<CutMark> cutMark(double corner, double outward, double cut, double cutOutward, double extent,
                               double cutExtent)
{
  const double roomAcross = cutOutward > 0 ? cutExtent - cut : cut;
  if (roomAcross < hairline) {
    return std::nullopt;
  }
  const double reach = cutMarkOffset + cutMarkLength;
  const double room = outward > 0 ? extent - corner : corner;
  if (room >= reach) {
    return CutMark{corner + outward * cutMarkOffset, corner + outward * reach, cut};
  }
  return CutMark{corner, corner - outward * edgeMarkLength, cut + cutOutward * hairline / 2};
}

void addCutMarks(const Square &square, const Sheet &sheet, std::vector<Shape> &shapes)
{
  for (const double sideX : {-1., 1.}) {
    for (const double sideY : {-1., 1.}) {
      const double x = square.left + (sideX > 0 ? square.side : 0);
      const double y = square.top + (sideY > 0 ? square.side : 0);
      if (const auto mark = cutMark(x, sideX, y, sideY, sheet.width, sheet.height)) {
        shapes.push_back(Line{mark->from, mark->across, mark->to, mark->across, hairline});
      }
      if (const auto mark = cutMark(y, sideY, x, sideX, sheet.height, sheet.width)) {
        shapes.push_back(Line{mark->across, mark->from, mark->across, mark->to, hairline});
      }
    }
  }
}

void addScaleBar(const Sheet &sheet, std::vector<Shape> &shapes)
{
  const double y = sheet.height - 10; // Above the part of the edge that printers leave out.
  const double left = (sheet.width - scaleBarLength) / 2;
  shapes.push_back(Line{left, y, left + scaleBarLength, y, hairline});
  for (int tick = 0; tick <= 10; ++tick) {
    const double x = left + tick * scaleBarLength / 10;
    const double height = tick % 5 == 0 ? 3 : 1.5;
    shapes.push_back(Line{x, y - hairline / 2, x, y - height, hairline});
  }
  shapes.push_back(Text{left - 5, y, textHeight, "0"});
  shapes.push_back(Text{left + scaleBarLength + 10, y, textHeight, millimetres(scaleBarLength) + " mm"});
  shapes.push_back(Text{sheet.width / 2, y - 6, textHeight,
                        "Size: outer diameter of the ring. Print at 100 %, then measure this bar."});
}

void addAll(const std::vector<Shape> &more, std::vector<Shape> &shapes)
{
  shapes.insert(shapes.end(), more.begin(), more.end());
}
} // namespace

Page squarePage(const vpCircleMarkerFamily &family, int id, double diameter, bool isInverse)
{
  const double side = squareSide(family, diameter);
  const PlacedMarker marker{id, side / 2, side / 2};
  return Page{Picture{side, side, caption(family, id, diameter, isInverse),
                      markerShapes(family, id, diameter, isInverse, marker.x, marker.y)},
              {marker}};
}

Page sheetPage(const vpCircleMarkerFamily &family, const std::vector<int> &ids, double diameter, bool isInverse,
               const Sheet &sheet)
{
  const double side = squareSide(family, diameter);
  const std::vector<Square> squares = placeSquares(sheet, side, static_cast<unsigned int>(ids.size()));
  Page page{Picture{sheet.width, sheet.height, caption(family, ids.front(), diameter, isInverse), {}}, {}};
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const PlacedMarker marker{ids[i], squares[i].left + side / 2, squares[i].top + side / 2};
    page.markers.push_back(marker);
    addAll(markerShapes(family, marker.id, diameter, isInverse, marker.x, marker.y), page.picture.shapes);
    addCutMarks(squares[i], sheet, page.picture.shapes);
    // About 40 characters of half their height at most: within the width of the square, also of a small one.
    const double height = std::min(textHeight, side / 18);
    page.picture.shapes.push_back(Text{marker.x, squares[i].top + side + 1 + 1.2 * height, height,
                                       caption(family, marker.id, diameter, isInverse)});
  }
  addScaleBar(sheet, page.picture.shapes);
  return page;
}
} // namespace create
