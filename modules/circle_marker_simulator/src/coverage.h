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

#ifndef VP_SIMULATOR_COVERAGE_H
#define VP_SIMULATOR_COVERAGE_H

#include <vector>

#include "outline.h"

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

/*!
  A window of the image that collects, pixel by pixel, the weighted coverage of regions.

  What is added are the differences from each pixel to its left neighbour, so that a region costs as much as its
  boundary is long; integrateRows() turns the differences into coverage at the end.
*/
class CoverageWindow
{
public:
  //! Window of the pixels that `extent`, widened by `reach`, touches in an image of the given size.
  CoverageWindow(const Box &extent, double reach, unsigned int imageWidth, unsigned int imageHeight);

  bool isEmpty() const { return m_width <= 0 || m_height <= 0; }
  int left() const { return m_left; }
  int top() const { return m_top; }
  int width() const { return m_width; }
  int height() const { return m_height; }

  //! Row `row` of the window: width() values.
  double *row(int row) { return m_values.data() + static_cast<std::size_t>(row) * m_width; }
  const double *row(int row) const { return m_values.data() + static_cast<std::size_t>(row) * m_width; }

  //! Adds `weight` times the exact share of each pixel's square that the region covers.
  void addExact(const Outline &region, double weight);

  //! From differences to coverage, once everything has been added.
  void integrateRows();

private:
  void addPiece(double x0, double y0, double x1, double y1, int row, double weight);

  int m_left = 0;               //!< First column, in pixels of the image.
  int m_top = 0;                //!< First row, in pixels of the image.
  int m_width = 0;              //!< Number of columns.
  int m_height = 0;             //!< Number of rows.
  std::vector<double> m_values; //!< Differences, then coverage.
};

} // namespace marker_simulator
END_VISP_NAMESPACE

#endif
