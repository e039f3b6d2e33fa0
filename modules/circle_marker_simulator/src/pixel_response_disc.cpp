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
 * Response of a pixel with a defocus disc: a table in two dimensions.
 */

#include <algorithm>
#include <cmath>

#include "pixel_response.h"

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

namespace {

// Samples of the table per pixel. Bilinear interpolation errs by an eighth of the squared step times the response's
// second derivative, which is about 1: 1e-4 of the contrast, and much of it cancels along an edge.
constexpr int SAMPLES = 32;
// Reach of the Gaussian in standard deviations, as without a disc.
constexpr double GAUSSIAN_REACH = 6.;
// Longest piece of an edge for Gauss's rule when the disc's sharp edge is not blurred, in pixels.
constexpr double LEAST_PIECE = 0.2;

using Table = std::vector<double>;

// Shares of the table's cells in a disc around the table's middle; together 1.
Table discShares(int side, double radius)
{
  const double middle = 0.5 * (side - 1);
  const int corners = 20000; // 1e-8 of the radius between chord and arc
  Outline disc;
  const auto corner = [&](int i) {
    const double angle = 2. * M_PI * i / corners;
    return PlanePoint{middle + radius * SAMPLES * std::cos(angle), middle + radius * SAMPLES * std::sin(angle)};
  };
  for (int i = 0; i < corners; ++i) {
    disc.push_back({corner(i), corner(i + 1)});
  }
  const double last = side - 1.;
  CoverageWindow window({0., 0., last, last}, 0., side, side);
  window.addExact(disc, 1. / area(disc));
  window.integrateRows();
  return Table(window.row(0), window.row(0) + static_cast<std::size_t>(side) * side);
}

Table transposed(const Table &table, int side)
{
  Table result(table.size());
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      result[static_cast<std::size_t>(j) * side + i] = table[static_cast<std::size_t>(i) * side + j];
    }
  }
  return result;
}

// Convolution of each row with a kernel of odd length around its middle.
Table convolveRows(const Table &table, int side, const std::vector<double> &kernel)
{
  const int half = static_cast<int>(kernel.size()) / 2;
  Table result(table.size(), 0.);
  for (int i = 0; i < side; ++i) {
    const double *from = table.data() + static_cast<std::size_t>(i) * side;
    double *to = result.data() + static_cast<std::size_t>(i) * side;
    for (int k = -half; k <= half; ++k) {
      const double share = kernel[k + half];
      for (int j = std::max(0, -k); j < std::min(side, side - k); ++j) {
        to[j + k] += share * from[j];
      }
    }
  }
  return result;
}

std::vector<double> gaussianKernel(double sigma)
{
  const int half = static_cast<int>(std::ceil(GAUSSIAN_REACH * sigma * SAMPLES));
  std::vector<double> kernel(2 * half + 1, 1.);
  for (int k = -half; k <= half && sigma > 0.; ++k) {
    const double scale = 1. / (sigma * SAMPLES * M_SQRT2);
    kernel[k + half] = 0.5 * (std::erf((k + 0.5) * scale) - std::erf((k - 0.5) * scale));
  }
  return kernel;
}

// The width of a pixel. An even number of samples with a middle: half of a sample at either end.
std::vector<double> pixelKernel()
{
  std::vector<double> kernel(SAMPLES + 1, 1. / SAMPLES);
  kernel.front() *= 0.5;
  kernel.back() *= 0.5;
  return kernel;
}

} // namespace

void PixelResponse::buildDiscTable(double sigma, double defocusRadius)
{
  // Disc, Gaussian and half a pixel, and half a pixel more for the difference between neighbours.
  m_reach = std::ceil(defocusRadius + GAUSSIAN_REACH * sigma + 1.);
  m_longestPiece = std::max(sigma, LEAST_PIECE);
  m_discSide = static_cast<int>(2. * (m_reach + 1.)) * SAMPLES + 1;
  Table table = discShares(m_discSide, defocusRadius);
  const std::vector<double> gaussian = gaussianKernel(sigma);
  const std::vector<double> pixel = pixelKernel();
  // Along y: Gaussian and pixel. Along x: Gaussian, pixel, and the pixel again, since F(x) - F(x - 1) is an integral
  // of K over the width of a pixel.
  table = transposed(convolveRows(convolveRows(transposed(table, m_discSide), m_discSide, gaussian), m_discSide, pixel),
                     m_discSide);
  table = convolveRows(convolveRows(convolveRows(table, m_discSide, gaussian), m_discSide, pixel), m_discSide, pixel);
  for (double &value : table) {
    value *= static_cast<double>(SAMPLES) * SAMPLES; // from shares of cells to a density
  }
  m_disc = table;
}

void PixelResponse::addPointOfDisc(const PlanePoint &point, double weight, CoverageWindow &window) const
{
  const double x = point.x - window.left();
  const double y = point.y - window.top();
  const int firstRow = std::max(0, static_cast<int>(std::ceil(y - m_reach)));
  const int lastRow = std::min(window.height() - 1, static_cast<int>(std::floor(y + m_reach)));
  // The difference between the pixels at c and c - 1 is the table's value half a pixel to the left of c.
  const int firstColumn = static_cast<int>(std::ceil(x + 0.5 - m_reach));
  const int lastColumn = std::min(window.width() - 1, static_cast<int>(std::floor(x + 0.5 + m_reach)));
  const double placeX = (firstColumn - 0.5 - x + m_reach + 1.) * SAMPLES;
  const std::size_t column = static_cast<std::size_t>(placeX);
  const double fx = placeX - column;
  for (int row = firstRow; row <= lastRow; ++row) {
    const double placeY = (row - y + m_reach + 1.) * SAMPLES;
    const std::size_t line = static_cast<std::size_t>(placeY);
    const double fy = placeY - line;
    const double *upper = m_disc.data() + line * m_discSide + column;
    const double *lower = upper + m_discSide;
    double *values = window.row(row);
    for (int c = firstColumn; c <= lastColumn; ++c, upper += SAMPLES, lower += SAMPLES) {
      const double value =
          (1. - fy) * ((1. - fx) * upper[0] + fx * upper[1]) + fy * ((1. - fx) * lower[0] + fx * lower[1]);
      values[std::max(c, 0)] += weight * value; // what lies to the left of the window is summed up in its first column
    }
  }
}

} // namespace marker_simulator
END_VISP_NAMESPACE
