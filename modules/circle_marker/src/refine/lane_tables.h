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
 * Small tables for lanes.
 */

/*!
  \file lane_tables.h
  \brief Entries of small tables, one for each lane, and lanes as small whole numbers.
*/

#ifndef VP_CIRCLE_MARKER_LANE_TABLES_H
#define VP_CIRCLE_MARKER_LANE_TABLES_H

#include <array>
#include <cstddef>
#include <tuple>

#include "refine/lanes.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
/*! As many numbers as two of the widest registers hold. */
struct alignas(64) LaneTable
{
  std::array<float, 32> entries{};
};

/*! For each lane the entry whose number, cut off, it is; of what is no number of an entry, any. */
inline Lanes entriesOf(const LaneTable &table, const Lanes &number)
{
  constexpr auto last = static_cast<float>(std::tuple_size<decltype(table.entries)>::value - 1);
  const float *entries = table.entries.data();
#if defined(CIRCLE_MARKER_WIDEST_LANES)
  const __m512i place = _mm512_cvttps_epi32(number.max(0.f).min(last).value());
  return _mm512_permutex2var_ps(_mm512_load_ps(entries), place, _mm512_load_ps(entries + laneCount));
#else // gathering instructions are slower on many processors than loads one by one
  const Lanes place = number.min(last);
  return lanesOf([&](int lane) { return entries[place[lane] > 0.f ? static_cast<int>(place[lane]) : 0]; });
#endif
}

/*! Writes lanes, whole numbers from 0 to 255, as bytes. */
inline void writeBytes(const Lanes &number, unsigned char *bytes)
{
#if defined(CIRCLE_MARKER_WIDEST_LANES)
  _mm_storeu_si128(reinterpret_cast<__m128i *>(bytes), _mm512_cvtepi32_epi8(_mm512_cvttps_epi32(number.value())));
#else
  for (std::size_t lane = 0; lane < static_cast<std::size_t>(laneCount); ++lane) {
    bytes[lane] = static_cast<unsigned char>(static_cast<int>(number[static_cast<std::ptrdiff_t>(lane)]));
  }
#endif
}
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
