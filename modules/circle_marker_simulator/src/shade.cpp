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
 * The shadow that falls on what stands in a scene, before the lens.
 */

#include <algorithm>
#include <cmath>

#include "shade.h"

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

namespace {

// Beyond this many standard deviations a shadow's edge is over (1e-9), and of a sum of sharp ones (1e-6).
constexpr double PENUMBRA_REACH = 6.;
constexpr double SUM_REACH = 5.;
// Nodes over the disc of a defocus for each standard deviation of the edge in its radius, and so many more: the sum is
// right to 1e-7.
constexpr double NODES_PER_SOFTNESS = 8.;
constexpr int MORE_NODES = 2;
// Far beyond any image, in pixels.
constexpr double FAR_AWAY = 1e5;
// So that no edge of a layer lies on it, in pixels.
constexpr double DISPLACEMENT = 0.37e-7;

Outline darkSideOf(const vpSceneShadow &shadow, double offset)
{
  const PlanePoint toDark = {std::cos(shadow.direction), std::sin(shadow.direction)};
  const PlanePoint edge = {shadow.edge.get_u() + (offset + DISPLACEMENT) * toDark.x,
                           shadow.edge.get_v() + (offset + DISPLACEMENT) * toDark.y};
  const auto corner = [&](double along, double beyond) {
    return PlanePoint{edge.x - along * toDark.y + beyond * toDark.x, edge.y + along * toDark.x + beyond * toDark.y};
  };
  const PlanePoint corners[] = {corner(-FAR_AWAY, 0.), corner(-FAR_AWAY, FAR_AWAY), corner(FAR_AWAY, FAR_AWAY),
                                corner(FAR_AWAY, 0.)};
  Outline side;
  for (int i = 0; i < 4; ++i) {
    side.push_back({corners[i], corners[(i + 1) % 4]});
  }
  return side;
}

} // namespace

std::vector<SharpShadow> sharpShadows(const vpSceneShadow &shadow, double blur)
{
  const double taken = 1. - shadow.factor;
  if (shadow.penumbra <= 0.) {
    return {{darkSideOf(shadow, 0.), taken}};
  }
  // The rule of equal steps integrates the penumbra's normal density times an edge's blurred image, whose spectra are
  // normal, too: at the steps' frequency their product has 1e-5 left.
  const double width = std::hypot(1. / shadow.penumbra, 1. / blur);
  const double longest = 2. * M_PI / (std::sqrt(2. * std::log(1e5)) * width);
  const int steps = static_cast<int>(std::ceil(2. * SUM_REACH * shadow.penumbra / longest));
  const double step = 2. * SUM_REACH * shadow.penumbra / steps;
  std::vector<SharpShadow> shadows;
  for (int k = 0; k < steps; ++k) {
    const double offset = (k + 0.5) * step - SUM_REACH * shadow.penumbra;
    const double z = offset / shadow.penumbra;
    const double share = step * std::exp(-0.5 * z * z) / (std::sqrt(2. * M_PI) * shadow.penumbra);
    shadows.push_back({darkSideOf(shadow, offset), share * taken});
  }
  return shadows;
}

void castShadow(const vpSceneShadow &shadow, double blur, double defocusRadius, vpImage<float> &I)
{
  const double softness = std::hypot(shadow.penumbra, blur);
  const auto softAt = [softness](double d) {
    const double z = d / softness;
    return z <= -PENUMBRA_REACH ? 0. : z >= PENUMBRA_REACH ? 1. : 0.5 * std::erfc(-z / M_SQRT2);
  };
  // The mean over the disc of a defocus: across the edge that is as dense as its chords are long, for which the
  // quadrature of Gauss and Chebyshev is made.
  const double perRadius = NODES_PER_SOFTNESS / softness;
  const int nodes = defocusRadius > 0. ? static_cast<int>(std::ceil(perRadius * defocusRadius)) + MORE_NODES : 0;
  const auto darkAt = [&](double d) {
    if (nodes == 0 || std::abs(d) > defocusRadius + PENUMBRA_REACH * softness) {
      return softAt(d);
    }
    double sum = 0.;
    for (int k = 1; k <= nodes; ++k) {
      const double angle = M_PI * k / (nodes + 1.);
      sum += 2. / (nodes + 1.) * std::pow(std::sin(angle), 2.) * softAt(d - defocusRadius * std::cos(angle));
    }
    return sum;
  };
  const auto leftAt = [&](double u, double v) {
    const double d =
        (u - shadow.edge.get_u()) * std::cos(shadow.direction) + (v - shadow.edge.get_v()) * std::sin(shadow.direction);
    return 1. - (1. - shadow.factor) * darkAt(d);
  };
  for (unsigned int i = 0; i < I.getHeight(); ++i) {
    for (unsigned int j = 0; j < I.getWidth(); ++j) {
      I[i][j] = static_cast<float>(leftAt(j, i) * I[i][j]);
    }
  }
}

} // namespace marker_simulator
END_VISP_NAMESPACE
