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
 * The middle one of some numbers.
 */

#ifndef VP_CIRCLE_MARKER_MEDIAN_H
#define VP_CIRCLE_MARKER_MEDIAN_H

#include <algorithm>
#include <array>
#include <cstddef>

#include <visp3/circle_marker/vpConfigCircleMarker.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Median of the first \e count numbers, at least one, which are put into another order; of an even count the larger of
  the two in the middle.
*/
template <class Number, std::size_t size> Number medianOf(std::array<Number, size> &numbers, std::size_t count)
{
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(numbers.begin(), middle, numbers.begin() + static_cast<std::ptrdiff_t>(count));
  return *middle;
}
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
