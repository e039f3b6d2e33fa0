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
 * Random numbers that are the same on every machine.
 */

#ifndef VP_SIMULATOR_RANDOM_NUMBERS_H
#define VP_SIMULATOR_RANDOM_NUMBERS_H

#include <cstdint>
#include <vector>

#include <visp3/circle_marker_simulator/vpConfigCircleMarkerSimulator.h>

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

/*!
  Generator of G. Steele, D. Lea and C. Flood, "Fast splittable pseudorandom number generators" (2014): the n-th number
  is a scrambled multiple of n, so that any of them is at hand without the ones before.
*/
class RandomNumbers
{
public:
  explicit RandomNumbers(std::uint64_t seed) : m_state(scramble(seed + INCREMENT)) {}

  //! The next 64 random bits.
  std::uint64_t bits() { return scramble(m_state += INCREMENT); }
  //! A number from `low` to `high`, evenly distributed.
  double uniform(double low, double high) { return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53; }
  //! An index from 0 to `size` - 1; the bias of the remainder is below 1e-15 for the small sizes used here.
  unsigned int index(unsigned int size) { return static_cast<unsigned int>(bits() % size); }

private:
  static constexpr std::uint64_t INCREMENT = 0x9E3779B97F4A7C15; // 2^64 over the golden ratio, made odd

  static std::uint64_t scramble(std::uint64_t z)
  {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
    return z ^ (z >> 31);
  }

  std::uint64_t m_state; //!< The multiple.
};

/*!
  65536 values that are distributed as a standard normal variable when one is drawn evenly: the quantiles at the middles
  of as many equal shares, scaled to a variance of 1. They end at 4.3 standard deviations.
*/
const std::vector<float> &normalQuantiles();

} // namespace marker_simulator
END_VISP_NAMESPACE

#endif
