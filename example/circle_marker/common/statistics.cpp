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
 * Statistics of a list of numbers.
 */

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "statistics.h"

namespace common {
namespace {
double quantile(const std::vector<double> &ascending, double share)
{
  const double place = share * static_cast<double>(ascending.size() - 1);
  const std::size_t below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, ascending.size() - 1);
  return ascending[below] + (place - static_cast<double>(below)) * (ascending[above] - ascending[below]);
}
} // namespace

Statistics statisticsOf(std::vector<double> values)
{
  if (values.empty()) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    return {none, none, none, none, none, none, none};
  }
  std::sort(values.begin(), values.end());
  const double count = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.) / count;
  const double squares = std::inner_product(values.begin(), values.end(), values.begin(), 0.);
  double deviations = 0.; // Their squares; the difference of the two squares would cancel.
  for (const double value : values) {
    deviations += (value - mean) * (value - mean);
  }
  return {mean,
          quantile(values, 0.5),
          quantile(values, 0.95),
          std::sqrt(squares / count),
          std::sqrt(deviations / count),
          values.front(),
          values.back()};
}
} // namespace common
