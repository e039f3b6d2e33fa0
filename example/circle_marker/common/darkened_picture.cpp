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
 * Pictures before a lens that darkens the corners.
 */

#include "common/darkened_picture.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace common {
void darkenCorners(double corner, const vpCameraParameters &camera, double noise, std::uint64_t seed,
                   vpImage<unsigned char> &I)
{
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const double lastU = I.getWidth() - 1.;
  const double lastV = I.getHeight() - 1.;
  const double farthest = std::hypot(std::max(camera.get_u0(), lastU - camera.get_u0()),
                                     std::max(camera.get_v0(), lastV - camera.get_v0()));
  const double tangent = std::sqrt(1. / std::sqrt(corner) - 1.); // of the angle in that corner
  for (unsigned int v = 0; v < I.getHeight(); ++v) {
    for (unsigned int u = 0; u < I.getWidth(); ++u) {
      const double share = std::hypot(u - camera.get_u0(), v - camera.get_v0()) / farthest;
      const double left = std::pow(1. + std::pow(share * tangent, 2.), -2.);
      // Noise that the sensor makes does not fall off with the light: what was lost of it comes back.
      const double lost = noise * std::sqrt(std::max(0., 1. - left * left));
      const double grey = left * I[v][u] + lost * normal(random);
      I[v][u] = static_cast<unsigned char>(std::lround(std::min(255., std::max(0., grey))));
    }
  }
}
} // namespace common
