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
 * Where the squares of the markers stand on a sheet of paper.
 */

#ifndef VP_CREATE_SHEET_LAYOUT_H
#define VP_CREATE_SHEET_LAYOUT_H

#include <optional>
#include <string>
#include <vector>

namespace create {
/*! A sheet of paper, upright, millimetres. */
struct Sheet
{
  std::string name;
  double width, height;
};

/*! The square of a marker and its quiet zone, which nothing else may enter; millimetres. */
struct Square
{
  double left, top, side;
};

/*! Height, millimetres, kept at the foot of a sheet for the scale bar and its line of text. */
constexpr double footHeight = 24;

/*! Height, millimetres, kept below each square for its caption and the cut marks. */
constexpr double captionHeight = 9;

/*! a4, a3 or letter; nothing for another name. */
std::optional<Sheet> sheetOfName(const std::string &name);

/*! Side of the largest square that fits a sheet. */
double largestSquare(const Sheet &sheet);

/*! How many squares of a side fit a sheet; 0 if not even one. */
unsigned int capacity(const Sheet &sheet, double side);

/*!
  Places squares in rows, centred on the part of the sheet above its foot. They do not overlap and leave room between
  them for captions and cut marks.
  \e count: From 1 to capacity(sheet, side).
*/
std::vector<Square> placeSquares(const Sheet &sheet, double side, unsigned int count);
} // namespace create

#endif
