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
 * What JPEG compression takes from a grey image.
 */

#include <algorithm>
#include <array>
#include <cmath>

#include <visp3/core/vpException.h>

#include "jpeg_loss.h"

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

namespace {

constexpr int SIDE = 8; // of a block, in pixels
using Block = std::array<double, SIDE * SIDE>;

// Quantisation table for luminance, ITU-T T.81, annex K.1, row by row.
constexpr std::array<int, SIDE *SIDE> LUMINANCE = {
    {16, 11,  10,  16, 24, 40, 51, 61, 12,  12,  14,  19,  26, 58, 60, 55,  14,  13,  16,  24, 40, 57,
     69, 56,  14,  17, 22, 29, 51, 87, 80,  62,  18,  22,  37, 56, 68, 109, 103, 77,  24,  35, 55, 64,
     81, 104, 113, 92, 49, 64, 78, 87, 103, 121, 120, 101, 72, 92, 95, 98,  112, 100, 103, 99}};

Block quantisationSteps(int quality)
{
  const int scale = quality < 50 ? 5000 / quality : 200 - 2 * quality;
  Block steps;
  std::transform(LUMINANCE.begin(), LUMINANCE.end(), steps.begin(),
                 [scale](int step) { return static_cast<double>(std::clamp((step * scale + 50) / 100, 1, 255)); });
  return steps;
}

// Row k: the k-th orthonormal cosine.
Block cosines()
{
  Block c;
  for (int k = 0; k < SIDE; ++k) {
    for (int i = 0; i < SIDE; ++i) {
      c[k * SIDE + i] = (k == 0 ? std::sqrt(0.125) : 0.5) * std::cos((2 * i + 1) * k * M_PI / 16.);
    }
  }
  return c;
}

Block transposed(const Block &a)
{
  Block t;
  for (int i = 0; i < SIDE * SIDE; ++i) {
    t[(i % SIDE) * SIDE + i / SIDE] = a[i];
  }
  return t;
}

Block product(const Block &a, const Block &b)
{
  Block c = {};
  for (int i = 0; i < SIDE; ++i) {
    for (int k = 0; k < SIDE; ++k) {
      for (int j = 0; j < SIDE; ++j) {
        c[i * SIDE + j] += a[i * SIDE + k] * b[k * SIDE + j];
      }
    }
  }
  return c;
}

} // namespace

void checkJpegQuality(int quality)
{
  if (quality < 1 || quality > 100) {
    throw vpException(vpException::badValue, "a JPEG quality is from 1 to 100, not %d", quality);
  }
}

void loseToJpeg(int quality, vpImage<unsigned char> &I)
{
  checkJpegQuality(quality);
  const Block steps = quantisationSteps(quality);
  const Block forward = cosines();
  const Block backward = transposed(forward);
  const int rows = I.getHeight();
  const int columns = I.getWidth();
  for (int top = 0; top < rows; top += SIDE) {
    for (int left = 0; left < columns; left += SIDE) {
      Block block;
      for (int k = 0; k < SIDE * SIDE; ++k) { // blocks over the border repeat the last row and column
        block[k] = I[std::min(top + k / SIDE, rows - 1)][std::min(left + k % SIDE, columns - 1)] - 128.;
      }
      Block coefficients = product(product(forward, block), backward);
      for (int k = 0; k < SIDE * SIDE; ++k) {
        coefficients[k] = std::round(coefficients[k] / steps[k]) * steps[k];
      }
      block = product(product(backward, coefficients), forward);
      for (int k = 0; k < SIDE * SIDE; ++k) {
        const int i = top + k / SIDE;
        const int j = left + k % SIDE;
        if (i < rows && j < columns) {
          I[i][j] = static_cast<unsigned char>(std::clamp(std::floor(block[k] + 128.5), 0., 255.));
        }
      }
    }
  }
}

} // namespace marker_simulator
END_VISP_NAMESPACE
