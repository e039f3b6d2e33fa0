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
 * From the light on the sensor to grey levels: illumination, gamma, noise, 8 bits.
 */

#include <algorithm>
#include <cmath>

#include "random_numbers.h"
#include "sensor.h"

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

namespace {

constexpr float WHITE_LEVEL = 255.f;
unsigned char toByte(float grey)
{
  return static_cast<unsigned char>(std::min(std::max(grey + 0.5f, 0.f), WHITE_LEVEL));
}

} // namespace

void illuminate(const vpScenePhotometry &photometry, vpImage<float> &I)
{
  if (photometry.gradientU == 0. && photometry.gradientV == 0.) {
    return;
  }
  const double width = I.getWidth();
  const double height = I.getHeight();
  const double centerU = photometry.lightCenter ? photometry.lightCenter->get_u() : 0.5 * (width - 1.);
  const double centerV = photometry.lightCenter ? photometry.lightCenter->get_v() : 0.5 * (height - 1.);
  for (unsigned int i = 0; i < I.getHeight(); ++i) {
    for (unsigned int j = 0; j < I.getWidth(); ++j) {
      const double light =
          1. + photometry.gradientU * (j - centerU) / width + photometry.gradientV * (i - centerV) / height;
      I[i][j] = static_cast<float>(std::max(light, 0.) * I[i][j]);
    }
  }
}

void reflect(const vpSceneReflection &reflection, vpImage<float> &I)
{
  for (unsigned int i = 0; i < I.getHeight(); ++i) {
    for (unsigned int j = 0; j < I.getWidth(); ++j) {
      const double distance = std::hypot(j - reflection.center.get_u(), i - reflection.center.get_v());
      I[i][j] += static_cast<float>(reflection.grey * std::exp(-0.5 * std::pow(distance / reflection.radius, 2)));
    }
  }
}

void applyGamma(double gamma, vpImage<float> &I)
{
  if (gamma == 1.) {
    return;
  }
  for (unsigned int i = 0; i < I.getSize(); ++i) {
    const float share = std::clamp(I.bitmap[i] / WHITE_LEVEL, 0.f, 1.f);
    I.bitmap[i] = WHITE_LEVEL * std::pow(share, static_cast<float>(gamma));
  }
}

void quantise(const vpImage<float> &exact, double sigma, std::uint64_t seed, vpImage<unsigned char> &I)
{
  I.resize(exact.getHeight(), exact.getWidth());
  const unsigned int size = exact.getSize();
  if (sigma <= 0.) {
    std::transform(exact.bitmap, exact.bitmap + size, I.bitmap, toByte);
    return;
  }
  const std::vector<float> &quantiles = normalQuantiles();
  const float scale = static_cast<float>(sigma);
  RandomNumbers random(seed);
  for (unsigned int i = 0; i < size; i += 4) { // four quantiles of 16 bits from each number
    std::uint64_t bits = random.bits();
    for (unsigned int k = i; k < std::min(i + 4, size); ++k, bits >>= 16) {
      I.bitmap[k] = toByte(exact.bitmap[k] + scale * quantiles[bits & 0xFFFF]);
    }
  }
}

} // namespace marker_simulator
END_VISP_NAMESPACE
