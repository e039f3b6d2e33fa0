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
 * A camera that sharpens its images, for tests; written apart from what undoes it.
 */

#ifndef TEST_SHARPENING_H
#define TEST_SHARPENING_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <visp3/core/vpImage.h>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace sharpening_test {
//! Unsharp mask: the image, and so many times what a Gaussian takes from it.
inline vpImage<unsigned char> sharpened(const vpImage<unsigned char> &I, double amount, double sigma)
{
  const int reach = static_cast<int>(std::ceil(4. * sigma));
  std::vector<double> kernel;
  double sum = 0.;
  for (int k = -reach; k <= reach; ++k) {
    kernel.push_back(std::exp(-0.5 * k * k / (sigma * sigma)));
    sum += kernel.back();
  }
  const int rows = static_cast<int>(I.getHeight());
  const int columns = static_cast<int>(I.getWidth());
  const auto inside = [](int place, int count) {
    return static_cast<unsigned int>(std::min(std::max(place, 0), count - 1));
  };
  vpImage<double> across(I.getHeight(), I.getWidth());
  for (int v = 0; v < rows; ++v) {
    for (int u = 0; u < columns; ++u) {
      double mean = 0.;
      for (int k = -reach; k <= reach; ++k) {
        mean += kernel[static_cast<std::size_t>(k + reach)] / sum * I[inside(v, rows)][inside(u + k, columns)];
      }
      across[inside(v, rows)][inside(u, columns)] = mean;
    }
  }
  vpImage<unsigned char> result(I.getHeight(), I.getWidth());
  for (int v = 0; v < rows; ++v) {
    for (int u = 0; u < columns; ++u) {
      double mean = 0.;
      for (int k = -reach; k <= reach; ++k) {
        mean += kernel[static_cast<std::size_t>(k + reach)] / sum * across[inside(v + k, rows)][inside(u, columns)];
      }
      const double grey = I[inside(v, rows)][inside(u, columns)];
      result[inside(v, rows)][inside(u, columns)] =
          static_cast<unsigned char>(std::lround(std::min(std::max(grey + amount * (grey - mean), 0.), 255.)));
    }
  }
  return result;
}
} // namespace sharpening_test

#endif
