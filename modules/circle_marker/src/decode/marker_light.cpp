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
 * Light on a marker, by the white around it.
 */

#include "decode/marker_light.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "decode/code_track.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Less than this share of the white, root mean square, about the plane is noise or a narrow quiet zone: noise of 20
// grey levels on white of 190.
constexpr double leastUneven = 0.11;
// Of a shadow at most this share of the light is left; the plane does for less.
constexpr double mostShadow = 0.85;
// Two levels are a shadow if they leave at most this share of what the plane leaves: the edge's own width takes some.
constexpr double mostLeft = 0.5;
} // namespace

MarkerLight::MarkerLight(const double *whites, std::size_t count, double radius, double first)
{
  const double n = static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2. * M_PI * (static_cast<double>(i) + first) / n;
    m_mean += whites[i] / n;
    m_slope += 2. * whites[i] / (n * radius) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  }
  seekShadow(whites, count, radius, first);
}

void MarkerLight::seekShadow(const double *whites, std::size_t count, double radius, double first)
{
  const double n = static_cast<double>(count);
  double squares = 0.;
  for (std::size_t i = 0; i < count; ++i) {
    squares += whites[i] * whites[i] / n;
  }
  // The mean and the two slopes are orthogonal over the circle.
  const double leftByPlane = squares - m_mean * m_mean - 0.5 * radius * radius * m_slope.squaredNorm();
  if (leftByPlane < std::pow(leastUneven * m_mean, 2.)) {
    return;
  }
  // The two groups of least spread, by the sorted levels.
  std::array<double, mostSamples> sorted;
  std::copy(whites, whites + count, sorted.begin());
  std::sort(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(count));
  double best = -1.;
  double below = 0.;
  for (std::size_t i = 1; i < count; ++i) {
    below += sorted[i - 1];
    const double share = static_cast<double>(i) / n;
    const double dark = below / static_cast<double>(i);
    const double bright = (n * m_mean - below) / static_cast<double>(count - i);
    const double between = share * (1. - share) * (bright - dark) * (bright - dark);
    if (between > best) {
      best = between;
      m_dark = dark;
      m_bright = bright;
    }
  }
  if (m_dark > mostShadow * m_bright) {
    return;
  }
  // The lit arc: its middle is the direction of the light, its length the distance of the chord. Levels between the two
  // lie on the edge.
  double lit = 0.;
  Eigen::Vector2d toward = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2. * M_PI * (static_cast<double>(i) + first) / n;
    const double share = std::clamp((whites[i] - m_dark) / (m_bright - m_dark), 0., 1.);
    lit += share / n;
    toward += share * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  }
  if (toward.norm() == 0.) {
    return;
  }
  m_toLight = toward.normalized();
  m_edge = radius * std::cos(M_PI * lit);
  double left = 0.;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2. * M_PI * (static_cast<double>(i) + first) / n;
    const Eigen::Vector2d q = radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    const double residual = whites[i] - (distanceToShadow(q) > 0. ? m_bright : m_dark);
    left += residual * residual / n;
  }
  m_hasShadow = left < mostLeft * mostLeft * leftByPlane;
}
} // namespace circle_marker
END_VISP_NAMESPACE
