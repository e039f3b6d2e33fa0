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
 * What lies beyond a marker's quiet zone.
 */

#include "refine/surround.h"

#include <cmath>
#include <limits>

#include "support/bilinear.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Looks in each direction: from where the blur of the quiet zone's end has gone, a pixel apart.
constexpr unsigned int looks = 4;
constexpr double clearOfBlur = 1.5; // standard deviations
} // namespace

unsigned int Surround::directionOf(const Eigen::Vector2d &q)
{
  const double turns = std::atan2(q.y(), q.x()) / (2. * M_PI);
  return static_cast<unsigned int>(std::lround((turns + 1.) * directions)) % directions;
}

Surround surroundOf(const vpImage<unsigned char> &I, const CameraModel &camera, const MarkerPlane &plane,
                    double outermost, double blur)
{
  Surround surround;
  for (unsigned int k = 0; k < Surround::directions; ++k) {
    const double angle = 2. * M_PI * k / Surround::directions;
    const Eigen::Vector2d q(std::cos(angle), std::sin(angle));
    const Eigen::Vector2d end = camera.toPixel(plane.project(outermost * q));
    const Eigen::Vector2d outward = (end - camera.toPixel(plane.project(q))).normalized();
    double sum = 0., squares = 0.;
    bool isInside = true;
    for (unsigned int i = 0; i < looks && isInside; ++i) {
      const Eigen::Vector2d p = end + (clearOfBlur * blur + i) * outward;
      const auto grey = bilinear(I, p);
      isInside = grey.has_value();
      if (isInside) {
        sum += *grey;
        squares += *grey * *grey;
      }
    }
    const double mean = sum / looks;
    surround.grey[k] = static_cast<float>(mean);
    surround.spread[k] = isInside ? static_cast<float>(std::sqrt(std::max(squares / looks - mean * mean, 0.)))
                                  : std::numeric_limits<float>::infinity();
  }
  return surround;
}
} // namespace circle_marker
END_VISP_NAMESPACE
