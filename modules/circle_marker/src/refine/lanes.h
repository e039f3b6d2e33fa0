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
 * Arithmetic on several pixels at a time.
 */

/*!
  \file lanes.h
  \brief Eight or sixteen pixels at a time: arithmetic that compilers turn into SIMD instructions.

  Single precision is enough: its rounding, 1e-7 of the contrast and 1e-5 of a pixel, is far below what noise leaves.
  There is no branch on a lane; a condition is a product with 0 or 1, or a clamp.

  Code that works on lanes is compiled three times from the same files: for any processor, through Eigen, in the
  namespace plain_lanes, for processors with AVX2 and FMA in the namespace wide_lanes (wide_lanes.cpp) and for those
  with AVX-512 in widest_lanes (widest_lanes.cpp). makeFitter() takes the one that the processor can do. So everything
  that has lanes in it lives in CIRCLE_MARKER_LANES.
*/

#ifndef VP_CIRCLE_MARKER_LANES_H
#define VP_CIRCLE_MARKER_LANES_H

#include <Eigen/Core>

#include <visp3/circle_marker/vpConfigCircleMarker.h>

#if defined(CIRCLE_MARKER_WIDEST_LANES)
#define CIRCLE_MARKER_LANES widest_lanes
#include "refine/avx512_lanes.h"
#include "refine/register_lanes.h"
#elif defined(CIRCLE_MARKER_WIDE_LANES)
#define CIRCLE_MARKER_LANES wide_lanes
#include "refine/avx2_lanes.h"
#include "refine/register_lanes.h"
#else
#define CIRCLE_MARKER_LANES plain_lanes
#endif

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
#if !defined(CIRCLE_MARKER_WIDE_LANES) && !defined(CIRCLE_MARKER_WIDEST_LANES)
/*! Number of pixels that are treated together: two SSE or NEON registers. */
constexpr int laneCount = 8;
using Lanes = Eigen::Array<float, laneCount, 1>;

/*! The numbers valueOf(0), valueOf(1) and so on. */
template <class ValueOf> inline Lanes lanesOf(const ValueOf &valueOf)
{
  Lanes lanes;
  for (int lane = 0; lane < laneCount; ++lane) {
    lanes[lane] = valueOf(lane);
  }
  return lanes;
}

/*! The sum of each of laneCount blocks of lanes. */
inline Lanes sumOfEach(const Lanes *blocks)
{
  Lanes sums;
  for (int k = 0; k < laneCount; ++k) {
    sums[k] = blocks[k].sum();
  }
  return sums;
}

/*! Adds lanes to as many numbers. */
inline void addEach(double *numbers, const Lanes &lanes)
{
  for (int k = 0; k < laneCount; ++k) {
    numbers[k] += static_cast<double>(lanes[k]);
  }
}
#endif

/*! 1 where a value is positive, else 0. */
inline Lanes isPositive(const Lanes &value)
{
  return (1e30f * value).max(0.f).min(1.f);
}

/*! Cumulative distribution and density of the standard normal distribution. */
struct NormalLanes
{
  Lanes cumulative;
  Lanes density;
};

/*!
  The normal distribution by Abramowitz and Stegun (1964), equation 26.2.17: error below 1e-7. Beyond 6.5 standard
  deviations it stays what it is there.
*/
inline NormalLanes normalOf(const Lanes &standardised)
{
  const Lanes z = standardised.max(-6.5f).min(6.5f);
  const Lanes size = z.abs();
  const Lanes t = (1.f + 0.2316419f * size).inverse();
  NormalLanes normal;
  normal.density = 0.39894228f * (-0.5f * z * z).exp();
  const Lanes tail = normal.density * t *
                     (0.319381530f + t * (-0.356563782f + t * (1.781477937f + t * (-1.821255978f + t * 1.330274429f))));
  // 1 - tail to the right, tail to the left: the sign is had by clamping a steep line.
  const Lanes half = 0.5f - tail;
  normal.cumulative = 0.5f + (1e30f * z).min(half).max(-half);
  return normal;
}

/*!
  The cumulative distribution alone, without an exponential: Abramowitz and Stegun (1964), equation 7.1.28. Rounding to
  single precision, which the 16th power makes more of, leaves an error below 1e-6.
*/
inline Lanes cumulativeOf(const Lanes &standardised)
{
  const Lanes z = standardised.max(-6.5f).min(6.5f);
  const Lanes x = 0.70710678f * z.abs();
  const Lanes root =
      1.f +
      x * (0.0705230784f +
           x * (0.0422820123f + x * (0.0092705272f + x * (0.0001520143f + x * (0.0002765672f + x * 0.0000430638f)))));
  const Lanes tail = 0.5f * root.square().square().square().square().inverse();
  const Lanes half = 0.5f - tail;
  return 0.5f + (1e30f * z).min(half).max(-half);
}
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
