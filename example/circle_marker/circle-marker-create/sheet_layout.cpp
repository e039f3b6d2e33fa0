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

#include <algorithm>
#include <cmath>

#include "sheet_layout.h"

namespace create {
namespace {
// Between squares side by side: room for the cut marks of both, 3.5 mm each.
constexpr double gap = 8;

// Around several squares, because printers leave about 4 mm of the paper's edge unprinted and cut marks stand there.
// One square alone may reach the edges: its margin is white anyway.
constexpr double margin = 5;

// Lengths that differ by less are equal: a ring of 180 mm with its quiet zone is exactly as wide as a4 paper.
constexpr double rounding = 1e-6;

unsigned int columnsOf(const Sheet &sheet, double side)
{
  const double several = std::floor((sheet.width - 2 * margin + gap + rounding) / (side + gap));
  return std::max(1u, static_cast<unsigned int>(several));
}

unsigned int rowsOf(const Sheet &sheet, double side)
{
  const double several = std::floor((sheet.height - footHeight - margin + rounding) / (side + captionHeight));
  return std::max(1u, static_cast<unsigned int>(several));
}
} // namespace

std::optional<Sheet> sheetOfName(const std::string &name)
{
  // ISO 216; ANSI/ASME Y14.1 (8.5 by 11 inches).
  for (const Sheet &sheet : {Sheet{"a4", 210, 297}, Sheet{"a3", 297, 420}, Sheet{"letter", 215.9, 279.4}}) {
    if (sheet.name == name) {
      return sheet;
    }
  }
  return std::nullopt;
}

double largestSquare(const Sheet &sheet)
{
  return std::min(sheet.width, sheet.height - footHeight - captionHeight);
}

unsigned int capacity(const Sheet &sheet, double side)
{
  if (side > largestSquare(sheet) + rounding) {
    return 0;
  }
  return columnsOf(sheet, side) * rowsOf(sheet, side);
}

std::vector<Square> placeSquares(const Sheet &sheet, double side, unsigned int count)
{
  const unsigned int columns = std::min(count, columnsOf(sheet, side));
  const unsigned int rows = (count + columns - 1) / columns;
  const double width = columns * side + (columns - 1) * gap;
  const double height = rows * (side + captionHeight);
  const double left = (sheet.width - width) / 2;
  const double top = (sheet.height - footHeight - height) / 2;

  std::vector<Square> squares;
  for (unsigned int i = 0; i < count; ++i) {
    squares.push_back(Square{left + (i % columns) * (side + gap), top + (i / columns) * (side + captionHeight), side});
  }
  return squares;
}
} // namespace create
