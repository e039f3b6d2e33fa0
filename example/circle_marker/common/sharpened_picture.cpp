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
 * A picture of a camera that sharpens.
 */

#include "common/sharpened_picture.h"

#include <algorithm>
#include <cmath>

#include <visp3/core/vpImageFilter.h>

namespace common {
void sharpen(double amount, double sigma, vpImage<unsigned char> &I)
{
  const unsigned int kernel = 2 * static_cast<unsigned int>(std::ceil(4. * sigma)) + 1; // pixels
  vpImage<double> smoothed;
  vpImageFilter::gaussianBlur(I, smoothed, kernel, sigma);
  std::transform(I.bitmap, I.bitmap + I.getSize(), smoothed.bitmap, I.bitmap, [amount](double grey, double mean) {
    return static_cast<unsigned char>(std::clamp(std::round(grey + amount * (grey - mean)), 0., 255.));
  });
}
} // namespace common
