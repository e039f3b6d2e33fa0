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
 * Random numbers that are the same on every machine.
 */

#include <cmath>

#include "random_numbers.h"

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

namespace {

// Quantile of the standard normal distribution, by Newton's method from the previous, smaller one.
double quantile(double probability, double start)
{
  double z = start;
  for (int i = 0; i < 50; ++i) {
    const double density = std::exp(-0.5 * z * z) / std::sqrt(2. * M_PI);
    const double step = (0.5 * std::erfc(-z / M_SQRT2) - probability) / density;
    z -= step;
    if (std::fabs(step) < 1e-13) {
      break;
    }
  }
  return z;
}

std::vector<float> computeQuantiles()
{
  constexpr int size = 65536;
  std::vector<double> upper(size / 2);
  double z = 0.;
  double sum = 0.;
  for (int i = 0; i < size / 2; ++i) {
    z = quantile(0.5 + (i + 0.5) / size, z);
    upper[i] = z;
    sum += z * z;
  }
  const double scale = 1. / std::sqrt(2. * sum / size);
  std::vector<float> all(size);
  for (int i = 0; i < size / 2; ++i) {
    all[size / 2 + i] = static_cast<float>(scale * upper[i]);
    all[size / 2 - 1 - i] = -all[size / 2 + i];
  }
  return all;
}

} // namespace

const std::vector<float> &normalQuantiles()
{
  static const std::vector<float> quantiles = computeQuantiles();
  return quantiles;
}

} // namespace marker_simulator
END_VISP_NAMESPACE
