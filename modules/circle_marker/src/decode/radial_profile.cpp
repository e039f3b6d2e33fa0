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
 * Radial structure of a marker: ring, disc or neither.
 */

#include "decode/radial_profile.h"

#include <algorithm>
#include <cmath>

#include "decode/marker_light.h"
#include "support/bilinear.h"
#include "support/median.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Directions of the median: enough that a code's sectors and an occluder of a quarter do not decide it.
constexpr unsigned int directions = 48;
// The white around is taken no farther out than this: outside the blur of the edge, and within the profile.
constexpr double farthestWhite = 1.10;
// A ring is sought no thinner than this, and a band that reaches further in than discRadius is a disc.
constexpr double thinnest = 0.95;
constexpr double discRadius = 0.15;

double at(const RadialProfile &profile, double radius)
{
  const double position = std::clamp(radius / RadialProfile::step - 0.5, 0., RadialProfile::size - 1.001);
  const auto i = static_cast<std::size_t>(position);
  return profile.grey[i] + (position - static_cast<double>(i)) * (profile.grey[i + 1] - profile.grey[i]);
}
} // namespace

std::optional<RadialProfile> radialProfile(const vpImage<unsigned char> &I, const CameraModel &camera,
                                           const MarkerPlane &plane)
{
  std::array<Eigen::Vector2d, directions> outward;
  for (unsigned int k = 0; k < directions; ++k) {
    const double angle = 2. * M_PI * (k + 0.5) / directions;
    outward[k] << std::cos(angle), std::sin(angle);
  }
  RadialProfile profile;
  std::array<double, directions> greys;
  for (unsigned int i = 0; i < RadialProfile::size; ++i) {
    std::size_t count = 0;
    for (const Eigen::Vector2d &direction : outward) {
      const Eigen::Vector2d q = RadialProfile::radiusAt(i) * direction;
      if (const auto grey = bilinear(I, camera.toPixel(plane.project(q)))) {
        greys[count++] = *grey;
      }
    }
    if (2 * count < directions) {
      return std::nullopt;
    }
    profile.grey[i] = medianOf(greys, count);
  }
  return profile;
}

std::optional<double> innerRadius(const RadialProfile &profile, double quietZone, double leastContrast)
{
  const double white = at(profile, std::min(radiusOfWhite(quietZone), farthestWhite));
  // The darkest radius near the outer edge: the middle of a thin ring, or the rim of a thick one.
  double black = HUGE_VAL;
  double darkest = 1.;
  for (double radius = 1.; radius > 0.6; radius -= RadialProfile::step) {
    const double grey = at(profile, radius);
    if (grey < black) {
      black = grey;
      darkest = radius;
    }
    else if (grey > 0.5 * (black + white) && white - black > leastContrast) {
      break;
    }
  }
  if (white - black < leastContrast) {
    return std::nullopt;
  }
  const double middle = 0.5 * (white + black);
  double previous = black;
  for (double radius = darkest; radius > discRadius; radius -= RadialProfile::step) {
    const double grey = at(profile, radius);
    if (grey >= middle) {
      const double crossing = radius + RadialProfile::step * (grey - middle) / (grey - previous);
      return crossing < thinnest ? std::optional<double>(crossing) : std::nullopt;
    }
    previous = grey;
  }
  return 0.;
}
} // namespace circle_marker
END_VISP_NAMESPACE
