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
 * Numbers for people.
 */

#include <cmath>
#include <cstdio>

#include "numbers.h"

namespace common {
std::string digits(double value)
{
  if (!std::isfinite(value)) {
    return "-";
  }
  const double magnitude = std::fabs(value);
  const int decimals = magnitude >= 100. ? 0 : magnitude >= 10. ? 1 : magnitude >= 1. ? 2 : 3;
  char text[64];
  std::snprintf(text, sizeof(text), "%.*f", decimals, value);
  return text;
}

std::string percent(std::size_t part, std::size_t whole)
{
  if (whole == 0) {
    return "-";
  }
  char text[64];
  std::snprintf(text, sizeof(text), "%.1f", 100. * static_cast<double>(part) / static_cast<double>(whole));
  return text;
}
} // namespace common
