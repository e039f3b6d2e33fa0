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
 * Pictures of rectangular cells, such as tags, as regions of the marker's plane.
 */

#include <array>
#include <cmath>

#include "printed_grid.h"

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

namespace {

constexpr unsigned char WHITE = 255;
constexpr unsigned char BLACK = 0;

// Cells between the lines x[0] < x[1] < ... and y[0] < y[1] < ... of the marker's plane, in metres.
struct Grid
{
  std::vector<double> x;
  std::vector<double> y;
  vpImage<unsigned char> cells;
};

std::vector<double> equalCells(double length, unsigned int number)
{
  std::vector<double> lines(number + 1);
  for (unsigned int i = 0; i <= number; ++i) {
    lines[i] = length * (static_cast<double>(i) / number - 0.5);
  }
  return lines;
}

// Each cell cut in three: two strips of width `strip` and what is left between them.
std::vector<double> stripes(const std::vector<double> &lines, double strip)
{
  std::vector<double> cut;
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    cut.insert(cut.end(), {lines[i], lines[i] + strip, lines[i + 1] - strip});
  }
  cut.push_back(lines.back());
  return cut;
}

vpImage<unsigned char> withWhiteBorder(const vpImage<unsigned char> &picture)
{
  vpImage<unsigned char> bordered(picture.getHeight() + 2, picture.getWidth() + 2, WHITE);
  for (unsigned int i = 0; i < picture.getHeight(); ++i) {
    for (unsigned int j = 0; j < picture.getWidth(); ++j) {
      bordered[i + 1][j + 1] = picture[i][j];
    }
  }
  return bordered;
}

unsigned char cellOr(const vpImage<unsigned char> &cells, int row, int column, unsigned char otherwise)
{
  const bool within = row >= 0 && column >= 0 && row < static_cast<int>(cells.getHeight()) &&
                      column < static_cast<int>(cells.getWidth());
  return within ? cells[row][column] : otherwise;
}

// A black and white picture in which the ink has spread: strips and corners of white cells next to black ones turn
// black (and the other way round for a negative spread).
Grid spreadGrid(const vpSimulatedMarker &marker)
{
  const vpImage<unsigned char> cells = withWhiteBorder(marker.getPicture());
  const double scale = static_cast<double>(cells.getWidth()) / marker.getPicture().getWidth();
  const double spread = marker.getInkSpread();
  const unsigned char winner = spread > 0. ? BLACK : WHITE;
  const unsigned int rows = cells.getHeight();
  const unsigned int columns = cells.getWidth();
  Grid grid = {stripes(equalCells(scale * marker.getSize(), columns), std::fabs(spread)),
               stripes(equalCells(scale * marker.getHeight(), rows), std::fabs(spread)),
               vpImage<unsigned char>(3 * rows, 3 * columns)};
  for (int i = 0; i < static_cast<int>(3 * rows); ++i) {
    for (int j = 0; j < static_cast<int>(3 * columns); ++j) {
      const int row = i / 3;
      const int column = j / 3;
      const int nextRow = row + i % 3 - 1;
      const int nextColumn = column + j % 3 - 1;
      const bool won = cells[row][column] == winner || cellOr(cells, nextRow, column, WHITE) == winner ||
                       cellOr(cells, row, nextColumn, WHITE) == winner ||
                       cellOr(cells, nextRow, nextColumn, WHITE) == winner;
      grid.cells[i][j] = won ? winner : cells[row][column];
    }
  }
  return grid;
}

Grid gridOf(const vpSimulatedMarker &marker)
{
  if (marker.getInkSpread() != 0.) {
    return spreadGrid(marker);
  }
  const vpImage<unsigned char> &picture = marker.getPicture();
  return {equalCells(marker.getSize(), picture.getWidth()), equalCells(marker.getHeight(), picture.getHeight()),
          picture};
}

} // namespace

std::vector<PrintedRegion> printedGrid(const vpSimulatedMarker &marker)
{
  const Grid grid = gridOf(marker);
  std::array<std::vector<PlaneCurve>, 256> boundaries;
  for (int i = 0; i < static_cast<int>(grid.cells.getHeight()); ++i) {
    for (int j = 0; j < static_cast<int>(grid.cells.getWidth()); ++j) {
      const unsigned char shade = grid.cells[i][j];
      if (shade == WHITE) {
        continue;
      }
      const Outline sides = outlineOf({grid.x[j], grid.y[i], grid.x[j + 1], grid.y[i + 1]}); // from the top, turning
      const std::array<unsigned char, 4> beyond = {
          {cellOr(grid.cells, i - 1, j, WHITE), cellOr(grid.cells, i, j + 1, WHITE),
           cellOr(grid.cells, i + 1, j, WHITE), cellOr(grid.cells, i, j - 1, WHITE)}};
      for (std::size_t side = 0; side < beyond.size(); ++side) {
        if (beyond[side] != shade) {
          boundaries[shade].push_back(PlaneCurve::line(sides[side].from, sides[side].to));
        }
      }
    }
  }
  std::vector<PrintedRegion> regions;
  for (std::size_t shade = 0; shade < boundaries.size(); ++shade) {
    if (!boundaries[shade].empty()) {
      regions.push_back({boundaries[shade], static_cast<double>(shade) / WHITE});
    }
  }
  return regions;
}

} // namespace marker_simulator
END_VISP_NAMESPACE
