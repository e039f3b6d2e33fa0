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
 * Light that is uneven across a marker, such as a soft reflection on glossy paper.
 */

#include "refine/uneven_light.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// The grid of Gaussians reaches so far from the centre, outer radii: over the quiet zone. They are as wide as the
// grid's steps: what changes within less than half a radius is an edge.
constexpr double reach = 1.1;
constexpr double width = 0.55;
// Prior: standard deviation of each Gaussian, in units of the contrast. A reflection is brighter than a shade.
constexpr double priorOfWhite = 1.;
constexpr double priorOfStep = 0.3;
// Pixels that see an edge tell where that is, and not the light: they count as if their noise were larger by this share
// of the contrast.
constexpr double edgeError = 0.5;
// Deviations of more than so many standard deviations, and this share of the contrast, are not of the light. (Cauchy's
// weights.)
constexpr double farOff = 3.;
constexpr double lackingOfModel = 0.02;
constexpr int reweightings = 2;
// The step from white to black is no less than this share of its mean anywhere.
constexpr double leastStep = 0.25;
} // namespace

UnevenLight::Base UnevenLight::baseAt(const Eigen::Vector2f &offset) const
{
  const Eigen::Vector2d q = m_toSheet * offset.cast<double>();
  constexpr double spacing = 2. * reach / (across - 1);
  std::array<double, across> x, y;
  for (int k = 0; k < across; ++k) {
    const double at = spacing * k - reach;
    x[static_cast<std::size_t>(k)] = std::exp(-0.5 * std::pow((q.x() - at) / width, 2));
    y[static_cast<std::size_t>(k)] = std::exp(-0.5 * std::pow((q.y() - at) / width, 2));
  }
  Base base;
  base[0] = 1.;
  for (int i = 0; i < across; ++i) {
    for (int j = 0; j < across; ++j) {
      base[1 + across * i + j] = x[static_cast<std::size_t>(i)] * y[static_cast<std::size_t>(j)];
    }
  }
  return base;
}

std::optional<UnevenLight> UnevenLight::of(const std::vector<ExplainedPixel> &pixels, const Eigen::Matrix2d &toSheet,
                                           double noise)
{
  UnevenLight light;
  light.m_toSheet = toSheet;
  // Even light, for a start.
  double n = 0., d = 0., dd = 0., g = 0., gd = 0.;
  for (const ExplainedPixel &pixel : pixels) {
    const double w = pixel.weight;
    n += w;
    d += w * pixel.darkness;
    dd += w * pixel.darkness * pixel.darkness;
    g += w * pixel.grey;
    gd += w * pixel.grey * pixel.darkness;
  }
  const double step = (d * g - n * gd) / (n * dd - d * d);
  if (!(step > 0.)) {
    return std::nullopt;
  }
  light.m_white.setZero();
  light.m_step.setZero();
  light.m_white[0] = (g + step * d) / n;
  light.m_step[0] = step;
  using Matrix = Eigen::Matrix<double, 2 * size, 2 * size>;
  const double floor = std::hypot(noise, lackingOfModel * step);
  for (int round = 0; round <= reweightings; ++round) {
    Matrix matrix = Matrix::Zero();
    Functions right = Functions::Zero();
    for (int k = 1; k < size; ++k) {
      matrix(k, k) = 1. / std::pow(priorOfWhite * step, 2);
      matrix(size + k, size + k) = 1. / std::pow(priorOfStep * step, 2);
    }
    for (const ExplainedPixel &pixel : pixels) {
      const Base base = light.baseAt(pixel.offset);
      const double atEdge = 4. * pixel.darkness * (1. - pixel.darkness);
      const double sigma = std::hypot(floor, edgeError * step * atEdge);
      double weight = pixel.weight / (sigma * sigma);
      if (round > 0) {
        const double left = pixel.grey - (light.m_white - pixel.darkness * light.m_step).dot(base);
        weight /= 1. + std::pow(left / (farOff * sigma), 2);
      }
      Functions row;
      row << base, -pixel.darkness * base;
      matrix.selfadjointView<Eigen::Lower>().rankUpdate(row, weight);
      right += weight * pixel.grey * row;
    }
    const Functions solution = matrix.selfadjointView<Eigen::Lower>().ldlt().solve(right);
    if (!solution.allFinite()) {
      return std::nullopt;
    }
    light.m_white = solution.head<size>();
    light.m_step = solution.tail<size>();
  }
  double white = 0.;
  double steps = 0.;
  for (const ExplainedPixel &pixel : pixels) {
    const Base base = light.baseAt(pixel.offset);
    white += light.m_white.dot(base);
    steps += light.m_step.dot(base);
  }
  light.m_meanWhite = white / static_cast<double>(pixels.size());
  light.m_meanStep = steps / static_cast<double>(pixels.size());
  return light.m_meanStep > 0. ? std::make_optional(light) : std::nullopt;
}

float UnevenLight::evened(const Eigen::Vector2f &offset, float grey) const
{
  const Base base = baseAt(offset);
  const double step = std::max(m_step.dot(base), leastStep * m_meanStep);
  return static_cast<float>(m_meanWhite - (m_white.dot(base) - grey) * m_meanStep / step);
}

float UnevenLight::uneven(const Eigen::Vector2f &offset, float evened) const
{
  const Base base = baseAt(offset);
  const double step = std::max(m_step.dot(base), leastStep * m_meanStep);
  return static_cast<float>(m_white.dot(base) - (m_meanWhite - evened) * step / m_meanStep);
}

void evenOut(const UnevenLight &light, std::vector<FitPixel> &pixels)
{
  for (FitPixel &pixel : pixels) {
    pixel.grey = light.evened(pixel.offset, pixel.grey);
  }
}
} // namespace circle_marker
END_VISP_NAMESPACE
