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
 * What a method made of one frame.
 */

#include <cmath>

#include "sample.h"

namespace experiments {
double Deviation::position() const
{
  return std::sqrt(dx * dx + dy * dy + dz * dz);
}

double Sample::distance() const
{
  return std::sqrt(x * x + y * y + z * z);
}

bool isWrong(const Sample &sample)
{
  constexpr double mostShare = 0.1;   // Of the distance: no noise does that to a marker of 20 pixels.
  constexpr double mostNormal = 20.;  // Degrees: no noise does that to a marker seen at a slant.
  constexpr double millimetres = 1e3; // In a metre.
  return sample.first &&
         (sample.first->position() > mostShare * millimetres * sample.distance() || sample.first->normal > mostNormal);
}
} // namespace experiments
