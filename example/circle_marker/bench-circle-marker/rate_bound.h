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
 * How high a rate may be of which a few events, or none, were seen.
 */

#ifndef VP_BENCH_RATE_BOUND_H
#define VP_BENCH_RATE_BOUND_H

#include <cmath>

namespace bench {
/*!
  The upper bound at 95 % of the rate of events in trials (C. Clopper and E. Pearson, Biometrika 26 (1934)): the rate p
  at which so many events or fewer have a chance of 5 %, sum_k C(n, k) p^k (1 - p)^(n - k) = 0.05. About 3 / n for none.
*/
inline double upperBound(unsigned int events, unsigned int trials)
{
  double low = 0.;
  double high = 1.;
  for (int i = 0; i < 60; ++i) {
    const double p = 0.5 * (low + high);
    double chance = 0.;
    double term = trials * std::log1p(-p); // logarithm of the binomial term
    for (unsigned int k = 0; k <= events && k <= trials; ++k) {
      chance += std::exp(term);
      term += std::log((trials - k) / (k + 1.)) + std::log(p / (1. - p));
    }
    (chance > 0.05 ? low : high) = p;
  }
  return high;
}
} // namespace bench

#endif
