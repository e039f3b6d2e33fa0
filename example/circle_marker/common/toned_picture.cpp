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
 * Pictures of a camera that raises the contrast.
 */

#include "common/toned_picture.h"

#include <algorithm>
#include <cmath>

namespace common {
double contrastRaised(double share, double strength)
{
  const auto logistic = [strength](double x) { return 1. / (1. + std::exp(-strength * (x - 0.5))); };
  const double black = logistic(0.);
  return (logistic(share) - black) / (logistic(1.) - black);
}

void raiseContrast(double strength, vpImage<unsigned char> &I)
{
  std::transform(I.bitmap, I.bitmap + I.getSize(), I.bitmap, [strength](unsigned char grey) {
    return static_cast<unsigned char>(std::lround(255. * contrastRaised(grey / 255., strength)));
  });
}
} // namespace common
