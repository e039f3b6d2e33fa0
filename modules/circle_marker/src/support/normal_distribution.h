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
 * Normal distribution, tabulated.
 */

#ifndef VP_CIRCLE_MARKER_NORMAL_DISTRIBUTION_H
#define VP_CIRCLE_MARKER_NORMAL_DISTRIBUTION_H

#include <array>
#include <cmath>

#include <visp3/circle_marker/vpConfigCircleMarker.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Cumulative distribution and density of the standard normal distribution from a table with cubic interpolation
  (Hermite: the derivative is known): error below 1e-9, of the density below 1e-5; ten times faster than std::erfc.
*/
class NormalDistribution
{
public:
  /*! Value of the cumulative distribution and of the density. */
  struct Value
  {
    double cumulative;
    double density;
  };

  static const NormalDistribution &instance()
  {
    static const NormalDistribution distribution;
    return distribution;
  }

  Value at(double x) const
  {
    if (!(x > -bound)) { // nor is it a number
      return {0., 0.};
    }
    if (x >= bound) {
      return {1., 0.};
    }
    const double position = (x + bound) * perUnit;
    const auto cell = static_cast<std::size_t>(position);
    const double t = position - static_cast<double>(cell);
    const Value &a = m_table[cell];
    const Value &b = m_table[cell + 1];
    // Cubic Hermite interpolation of the cumulative, linear interpolation of the density (error below 1e-5).
    const double difference = b.cumulative - a.cumulative;
    const double slopeA = a.density / perUnit;
    const double slopeB = b.density / perUnit;
    const double cumulative =
        a.cumulative +
        t * (slopeA + t * (3. * difference - 2. * slopeA - slopeB + t * (slopeA + slopeB - 2. * difference)));
    return {cumulative, a.density + t * (b.density - a.density)};
  }

private:
  static constexpr double bound = 6.;       // beyond, the distribution is 0 or 1 to 1e-9
  static constexpr double perUnit = 64.;    // table cells for a unit of x
  static constexpr std::size_t cells = 768; // 2 * bound * perUnit

  NormalDistribution()
  {
    for (std::size_t i = 0; i < m_table.size(); ++i) {
      const double x = static_cast<double>(i) / perUnit - bound;
      m_table[i] = {0.5 * std::erfc(-x * M_SQRT1_2), std::exp(-0.5 * x * x) / std::sqrt(2. * M_PI)};
    }
  }

  std::array<Value, cells + 2> m_table; //!< One more than the last cell's end, so that rounding never reads outside.
};
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
