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

#ifndef VP_COMMON_STATISTICS_H
#define VP_COMMON_STATISTICS_H

#include <cstddef>
#include <vector>

namespace common {
/*! All are not a number (nan) for an empty list. */
struct Statistics
{
  double mean, median, p95, rms;
  double sigma; //!< Root of the mean square difference from the mean.
  double least, most;
};

/*! Quantiles between two values are interpolated in proportion. */
Statistics statisticsOf(std::vector<double> values);
} // namespace common

#endif
