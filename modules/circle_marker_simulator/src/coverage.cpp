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
 * Sums of regions' coverage of pixels, exact for unblurred outlines.
 */

#include <algorithm>
#include <cmath>

#include "coverage.h"

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

namespace {

// First and last pixel that an interval touches, within 0 ... size - 1.
int firstPixel(double from, unsigned int size)
{
  return static_cast<int>(std::floor(std::clamp(from + 0.5, 0., static_cast<double>(size))));
}

int lastPixel(double to, unsigned int size)
{
  return static_cast<int>(std::floor(std::clamp(to + 0.5, -1., static_cast<double>(size) - 1.)));
}

} // namespace

CoverageWindow::CoverageWindow(const Box &extent, double reach, unsigned int imageWidth, unsigned int imageHeight)
{
  if (!(extent.left <= extent.right)) {
    return; // nothing to be drawn
  }
  m_left = firstPixel(extent.left - reach, imageWidth);
  m_top = firstPixel(extent.top - reach, imageHeight);
  m_width = std::max(0, lastPixel(extent.right + reach, imageWidth) - m_left + 1);
  m_height = std::max(0, lastPixel(extent.bottom + reach, imageHeight) - m_top + 1);
  m_values.assign(static_cast<std::size_t>(m_width) * m_height, 0.);
}

// A piece of an edge within one row of pixels. Downward edges are right borders of a region: every pixel to their left
// gains the height crossed and every pixel to the right nothing; in a closed outline this is the same as taking the
// height away from the pixels to the right.
void CoverageWindow::addPiece(double x0, double y0, double x1, double y1, int row, double weight)
{
  double *values = this->row(row);
  const double dy = y1 - y0;
  if (dy == 0. || std::min(x0, x1) >= m_width) {
    return;
  }
  const double slope = (x1 - x0) / dy;
  const double direction = x1 >= x0 ? 1. : -1.;
  double x = x0;
  double y = y0;
  while (true) {
    // Pixel in which the piece goes on, and where it leaves it.
    const double column = direction > 0. ? std::floor(x) : std::ceil(x) - 1.;
    const double border = direction > 0. ? column + 1. : column;
    const bool last = direction > 0. ? border >= x1 : border <= x1;
    const double nextX = last ? x1 : border;
    const double nextY = last || slope == 0. ? y1 : y0 + (border - x0) / slope;
    const double height = weight * (nextY - y);
    if (column >= m_width && direction > 0.) {
      return;
    }
    if (column < 0.) {
      values[0] -= height;
    }
    else if (column < m_width) {
      const int c = static_cast<int>(column);
      const double share = std::clamp(0.5 * (x + nextX) - column, 0., 1.); // of the pixel's width, left of the edge
      values[c] -= height * (1. - share);
      if (c + 1 < m_width) {
        values[c + 1] -= height * share;
      }
    }
    if (last) {
      return;
    }
    x = nextX;
    y = nextY;
  }
}

void CoverageWindow::addExact(const Outline &region, double weight)
{
  for (const Segment &segment : region) {
    // From here on pixel (0, 0) of the window is the square [0, 1] x [0, 1].
    double x0 = segment.from.x + 0.5 - m_left;
    double y0 = segment.from.y + 0.5 - m_top;
    double x1 = segment.to.x + 0.5 - m_left;
    double y1 = segment.to.y + 0.5 - m_top;
    const double sign = y1 >= y0 ? weight : -weight;
    if (y1 < y0) {
      std::swap(x0, x1);
      std::swap(y0, y1);
    }
    if (y1 <= 0. || y0 >= m_height || y0 == y1) {
      continue;
    }
    const double slope = (x1 - x0) / (y1 - y0);
    const int first = static_cast<int>(std::floor(std::max(y0, 0.)));
    const int last = std::min(static_cast<int>(std::floor(y1)), m_height - 1);
    for (int row = first; row <= last; ++row) {
      const double top = std::max(y0, static_cast<double>(row));
      const double bottom = std::min(y1, row + 1.);
      const double xTop = top == y0 ? x0 : x0 + slope * (top - y0);
      const double xBottom = bottom == y1 ? x1 : x0 + slope * (bottom - y0);
      addPiece(xTop, top, xBottom, bottom, row, sign);
    }
  }
}

void CoverageWindow::integrateRows()
{
  for (int i = 0; i < m_height; ++i) {
    double sum = 0.;
    double *values = row(i);
    for (int j = 0; j < m_width; ++j) {
      sum += values[j];
      values[j] = sum;
    }
  }
}

} // namespace marker_simulator
END_VISP_NAMESPACE
