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

#include "decode/uneven_light.h"

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// The grid reaches so far from the centre, outer radii: over the quiet zone. Its Gaussians are as wide as its steps:
// what changes within less than half a radius is an edge.
constexpr double reach = 1.1;
constexpr double spacing = 2. * reach / (UnevenLight::inRow - 1);
// The step from white to black is no less than this share of its mean anywhere: noise would be made contrast.
constexpr double leastStep = 0.25;

// The Gaussians of a row, or a column, at a coordinate on the sheet.
Eigen::Matrix<double, UnevenLight::inRow, 1> gaussiansAt(double coordinate)
{
  Eigen::Matrix<double, UnevenLight::inRow, 1> values;
  for (int k = 0; k < UnevenLight::inRow; ++k) {
    const double off = (coordinate + reach) / spacing - k;
    values[k] = std::exp(-0.5 * off * off);
  }
  return values;
}
} // namespace

UnevenLight::Terms UnevenLight::termsAt(const Eigen::Vector2d &place) const
{
  const Eigen::Vector2d q = toSheet * (place - center);
  const auto row = gaussiansAt(q.x());
  const auto column = gaussiansAt(q.y());
  Terms terms;
  terms[0] = 1.;
  for (int k = 0; k < inRow; ++k) {
    terms.segment<inRow>(1 + inRow * k) = column[k] * row;
  }
  return terms;
}

double UnevenLight::stepFrom(const Terms &at) const
{
  return std::max(step.dot(at), leastStep * meanStep);
}

double UnevenLight::evened(const Eigen::Vector2d &place, double grey) const
{
  const Terms at = termsAt(place);
  return meanWhite - (white.dot(at) - grey) * meanStep / stepFrom(at);
}

double UnevenLight::uneven(const Eigen::Vector2d &place, double evened) const
{
  const Terms at = termsAt(place);
  return white.dot(at) - (meanWhite - evened) * stepFrom(at) / meanStep;
}
} // namespace circle_marker
END_VISP_NAMESPACE
