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
 * Response of a pixel to the scene: blur of the lens and integration over the pixel's square.
 */

#include <algorithm>
#include <array>
#include <cmath>

#include <visp3/core/vpException.h>

#include "pixel_response.h"

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

namespace {

// Beyond 6 standard deviations lies 1e-9 of a Gaussian, 2e-7 grey levels.
constexpr double GAUSSIAN_REACH = 6.;
// Samples of the tables per pixel; linear interpolation errs by less than 1e-6 for a blur of 0.05 pixels and more.
constexpr int SAMPLES = 1024;
// A narrower Gaussian would need a finer table, and who wants none should say 0.
constexpr double LEAST_SIGMA = 0.05;
// Window of the tables beyond the reach, so that interpolation never leaves them; in pixels.
constexpr double TABLE_MARGIN = 3.;

// Integral of the normal distribution function: of Phi(t / sigma) from -infinity to u.
double normalRamp(double u, double sigma)
{
  const double z = u / sigma;
  return 0.5 * u * std::erfc(-z / M_SQRT2) + sigma * std::exp(-0.5 * z * z) / std::sqrt(2. * M_PI);
}

double normalStep(double u, double sigma)
{
  return 0.5 * std::erfc(-u / (sigma * M_SQRT2));
}

// Linear interpolation in a table.
double valueAt(const std::vector<double> &table, std::size_t index, double fraction)
{
  return (1. - fraction) * table[index] + fraction * table[index + 1];
}

} // namespace

PixelResponse::PixelResponse(double sigma, double defocusRadius)
{
  const auto usable = [](double width) { return width == 0. || (width >= LEAST_SIGMA && std::isfinite(width)); };
  if (!usable(sigma) || !usable(defocusRadius)) {
    throw vpException(vpException::badValue,
                      "a blur of %g px with a defocus disc of %g px cannot be rendered: each is "
                      "0 or at least %g px",
                      sigma, defocusRadius, LEAST_SIGMA);
  }
  if (defocusRadius > 0.) {
    buildDiscTable(sigma, defocusRadius);
  }
  else if (sigma > 0.) {
    buildGaussianTables(sigma);
  }
}

void PixelResponse::buildGaussianTables(double sigma)
{
  m_reach = std::ceil(0.5 + GAUSSIAN_REACH * sigma);
  m_longestPiece = sigma;
  const int half = static_cast<int>(m_reach + TABLE_MARGIN) * SAMPLES;
  m_density.resize(2 * half + 1);
  m_cumulative.resize(2 * half + 1);
  // The Gaussian is even, so one side tells the other; both ends of a pixel lie on the samples. The functions are the
  // expensive part of a small image, so each is called once for each sample.
  const int pixel = SAMPLES / 2;
  std::vector<double> step(half + 2 * pixel + 1);
  std::vector<double> ramp(half + 2 * pixel + 1);
  for (int i = 0; i <= half + 2 * pixel; ++i) { // from minus half a pixel
    const double t = static_cast<double>(i - pixel) / SAMPLES;
    step[i] = normalStep(t, sigma);
    ramp[i] = normalRamp(t, sigma);
  }
  for (int i = 0; i <= half; ++i) {
    const double t = static_cast<double>(i) / SAMPLES;
    const double density = step[i + 2 * pixel] - step[i];
    // 1 exactly beyond the reach, so that nothing is left over to the right of a region
    const double cumulative = t >= m_reach ? 1. : ramp[i + 2 * pixel] - ramp[i];
    m_density[half + i] = density;
    m_density[half - i] = density;
    m_cumulative[half + i] = cumulative;
    m_cumulative[half - i] = 1. - cumulative;
  }
}

void PixelResponse::add(const Outline &region, double weight, CoverageWindow &window) const
{
  if (m_longestPiece == 0.) {
    window.addExact(region, weight);
    return;
  }
  // Gauss's rules with one, two and three points on [-1, 1].
  static const std::array<std::vector<std::array<double, 2>>, 3> rules = {
      {{{{0., 2.}}},
       {{{-std::sqrt(1. / 3.), 1.}}, {{std::sqrt(1. / 3.), 1.}}},
       {{{-std::sqrt(3. / 5.), 5. / 9.}}, {{0., 8. / 9.}}, {{std::sqrt(3. / 5.), 5. / 9.}}}}};
  const double right = window.left() + window.width() + m_reach;
  const double top = window.top() - 1. - m_reach;
  const double bottom = window.top() + window.height() + m_reach;
  for (const Segment &s : region) {
    const double dx = s.to.x - s.from.x;
    const double dy = s.to.y - s.from.y;
    if (dy == 0. || std::min(s.from.x, s.to.x) > right || std::max(s.from.y, s.to.y) < top ||
        std::min(s.from.y, s.to.y) > bottom) {
      continue;
    }
    const double length = std::hypot(dx, dy) / m_longestPiece;
    const int pieces = std::max(1, static_cast<int>(std::ceil(length)));
    // Short chords of a curve: the error of Gauss's rule with n points falls with the power 2 n of the length.
    const auto &rule = rules[length < 0.02 ? 0 : length < 0.5 ? 1 : 2];
    for (int i = 0; i < pieces; ++i) {
      for (const auto &[node, share] : rule) {
        const double t = (i + 0.5 + 0.5 * node) / pieces;
        const PlanePoint point = {s.from.x + t * dx, s.from.y + t * dy};
        const double height = -weight * 0.5 * share * dy / pieces;
        if (m_disc.empty()) {
          addPoint(point, height, window);
        }
        else {
          addPointOfDisc(point, height, window);
        }
      }
    }
  }
}

void PixelResponse::addPoint(const PlanePoint &point, double weight, CoverageWindow &window) const
{
  const double x = point.x - window.left();
  const double y = point.y - window.top();
  const int firstRow = std::max(0, static_cast<int>(std::ceil(y - m_reach)));
  const int lastRow = std::min(window.height() - 1, static_cast<int>(std::floor(y + m_reach)));
  if (firstRow > lastRow || x - m_reach > window.width()) {
    return;
  }
  // Shares of the columns from firstColumn on: what they see of the boundary more than their left neighbours.
  if (x + m_reach + 1. < 0.) { // to the left of the window: all of it belongs to the first column
    for (int row = firstRow; row <= lastRow; ++row) {
      const double place = (row - y + m_reach + TABLE_MARGIN) * SAMPLES;
      const std::size_t index = static_cast<std::size_t>(place);
      window.row(row)[0] += weight * valueAt(m_density, index, place - index);
    }
    return;
  }
  const int firstColumn = static_cast<int>(std::ceil(x - m_reach));
  const int columns = static_cast<int>(2. * m_reach) + 2;
  const double start = (firstColumn - x + m_reach + TABLE_MARGIN) * SAMPLES;
  std::size_t index = static_cast<std::size_t>(start);
  const double fraction = start - index;
  thread_local std::vector<double> differences;
  differences.resize(columns);
  double before = 0.;
  for (int k = 0; k < columns; ++k, index += SAMPLES) {
    const double now = valueAt(m_cumulative, index, fraction);
    differences[k] = now - before;
    before = now;
  }
  // Columns to the left of the window are summed up in its first one.
  const int skip = std::clamp(-firstColumn, 0, columns - 1);
  for (int k = 0; k < skip; ++k) {
    differences[skip] += differences[k];
  }
  const int end = std::min(columns, window.width() - firstColumn);
  for (int row = firstRow; row <= lastRow; ++row) {
    const double place = (row - y + m_reach + TABLE_MARGIN) * SAMPLES;
    const std::size_t at = static_cast<std::size_t>(place);
    const double height = weight * valueAt(m_density, at, place - at);
    double *values = window.row(row);
    for (int k = skip; k < end; ++k) {
      values[firstColumn + k] += height * differences[k];
    }
  }
}

} // namespace marker_simulator
END_VISP_NAMESPACE
