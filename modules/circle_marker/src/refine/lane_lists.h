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
 * Lanes that are chosen by their values.
 */

/*!
  \file lane_lists.h
  \brief Lanes that are chosen by their values, for what looks through an image eight pixels at a time.
*/

#ifndef VP_CIRCLE_MARKER_LANE_LISTS_H
#define VP_CIRCLE_MARKER_LANE_LISTS_H

#include <array>
#include <cstdint>
#include <cstring>

#include "refine/lanes.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
/*! Numbers of some lanes, in their order. */
struct LaneList
{
  std::array<unsigned char, laneCount> lanes;
  int count;
};

#ifdef CIRCLE_MARKER_WIDE_LANES
/*! For each set of lanes, as the bits of a number, those lanes in their order, a byte each. */
struct LaneLists
{
  constexpr LaneLists()
  {
    for (unsigned int set = 0; set < lists.size(); ++set) {
      unsigned int count = 0;
      for (unsigned int lane = 0; lane < static_cast<unsigned int>(laneCount); ++lane) {
        if ((set >> lane & 1U) != 0) {
          lists[set] |= static_cast<std::uint64_t>(lane) << (8 * count++);
        }
      }
      counts[set] = static_cast<unsigned char>(count);
    }
  }

  std::array<std::uint64_t, 256> lists{};
  std::array<unsigned char, 256> counts{};
};
constexpr LaneLists laneLists;
#endif

/*! The lanes whose value is below a bound. Without a branch that nobody can foretell. */
inline LaneList lanesBelow(const Lanes &value, float bound)
{
  LaneList list;
#ifdef CIRCLE_MARKER_WIDE_LANES
  const auto set =
      static_cast<unsigned int>(_mm256_movemask_ps(_mm256_cmp_ps(value.value(), _mm256_set1_ps(bound), _CMP_LT_OQ)));
  std::memcpy(list.lanes.data(), &laneLists.lists[set], sizeof(list.lanes)); // AVX is little-endian
  list.count = laneLists.counts[set];
#else
  list.count = 0;
  if (value.minCoeff() >= bound) {
    return list;
  }
  for (int lane = 0; lane < laneCount; ++lane) {
    list.lanes[static_cast<std::size_t>(list.count)] = static_cast<unsigned char>(lane);
    list.count += value[lane] < bound ? 1 : 0;
  }
#endif
  return list;
}

/*! Where a < b the value of ifLess, else that of ifNot. */
inline Lanes chosen(const Lanes &a, const Lanes &b, const Lanes &ifLess, const Lanes &ifNot)
{
#ifdef CIRCLE_MARKER_WIDE_LANES
  return _mm256_blendv_ps(ifNot.value(), ifLess.value(), _mm256_cmp_ps(a.value(), b.value(), _CMP_LT_OQ));
#else
  return (a < b).select(ifLess, ifNot);
#endif
}
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
