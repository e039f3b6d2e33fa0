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
 * A ring whose pose, light and blur are measured: what the pixels of its code are compared with.
 */

#include "decode/measured_ring.h"

#include <algorithm>
#include <cmath>

#include "support/normal_distribution.h"
#include "support/sensor_range.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Ink is no darker than this share of paper, in grey levels, when its noise is asked for: a gamma above 1 would make
// that of black endless.
constexpr double darkestInk = 0.05;
// The light's slope leaves no less than this share of it.
constexpr double leastLight = 1e-3;
} // namespace

double MeasuredRing::whiteAt(const Eigen::Vector2d &place) const
{
  const Eigen::Vector2d offset = place - origin;
  double lit = std::max(1. + slope.dot(offset), leastLight);
  if (shade < 1.) {
    lit *= 1. - (1. - shade) * NormalDistribution::instance().at(toShade.dot(offset) - shadeEdge).cumulative;
  }
  return light * std::pow(lit, gamma);
}

double MeasuredRing::levelAt(const Eigen::Vector2d &place, double grey) const
{
  return 1. - (1. - std::pow(std::max(grey, 0.) / whiteAt(place), 1. / gamma)) / absorption;
}

bool MeasuredRing::isCutOff(const Eigen::Vector2d &place, double grey) const
{
  return mayBeTooBright(grey) && whiteAt(place) > brightestTold;
}

double MeasuredRing::noiseOfLevel() const
{
  const double ink = std::max(std::pow(std::max(1. - absorption, 0.), gamma), darkestInk);
  const double slope = std::max(1., std::pow(ink, 1. / gamma - 1.)) / gamma; // of the light by the grey level
  return noise / light * slope / absorption;
}
} // namespace circle_marker
END_VISP_NAMESPACE
