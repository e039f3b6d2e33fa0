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
 * Seeds that depend on what they are for, not on the order in which they are asked for.
 */

#ifndef VP_COMMON_SEEDS_H
#define VP_COMMON_SEEDS_H

#include <cstdint>

namespace common {
/*!
  Mixes a number into a seed: the generator of Steele, Lea and Flood (2014), one step. A chain of them,
  mixed(mixed(seed, cell), frame), gives every frame a seed of its own, whatever the number of threads and frames.
*/
inline std::uint64_t mixed(std::uint64_t seed, std::uint64_t number)
{
  std::uint64_t z = seed + 0x9E3779B97F4A7C15 * (number + 1);
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
  return z ^ (z >> 31);
}
} // namespace common

#endif
