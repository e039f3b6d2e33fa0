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
 * Arithmetic on lanes that are in a register of their own.
 */

/*!
  \file register_lanes.h
  \brief What lanes in registers have in common: sums with numbers, exponential and logarithm.

  Included by lanes.h only, after the class Lanes of a set of instructions.
*/

#ifndef VP_CIRCLE_MARKER_REGISTER_LANES_H
#define VP_CIRCLE_MARKER_REGISTER_LANES_H

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
inline Lanes operator+(const Lanes &a, float b)
{
  return a + Lanes::Constant(b);
}
inline Lanes operator-(const Lanes &a, float b)
{
  return a - Lanes::Constant(b);
}
inline Lanes operator*(const Lanes &a, float b)
{
  return a * Lanes::Constant(b);
}
inline Lanes operator/(const Lanes &a, float b)
{
  return a * Lanes::Constant(1.f / b);
}
inline Lanes operator+(float a, const Lanes &b)
{
  return Lanes::Constant(a) + b;
}
inline Lanes operator-(float a, const Lanes &b)
{
  return Lanes::Constant(a) - b;
}
inline Lanes operator*(float a, const Lanes &b)
{
  return Lanes::Constant(a) * b;
}
inline Lanes operator/(float a, const Lanes &b)
{
  return Lanes::Constant(a) / b;
}

// 2^n e^r with |r| < log(2) / 2: Taylor's series of e^r up to r^7 / 7!, whose next term is below 6e-9.
inline Lanes Lanes::exp() const
{
  const Lanes x = min(88.f).max(-87.f);
  const Lanes n = (x * 1.44269504f).rounded();
  // log(2) in two parts, so that the product with the first is exact.
  const Lanes r = x - n * 0.693359375f - n * -2.12194440e-4f;
  Lanes sum = 1.f / 720.f + r * (1.f / 5040.f);
  for (const float factor : {1.f / 120.f, 1.f / 24.f, 1.f / 6.f, 0.5f, 1.f, 1.f}) {
    sum = factor + r * sum;
  }
  return sum.scaledBy(n);
}

// With 2^n m and s = (m - 1) / (m + 1) the series log(m) = 2 (s + s^3 / 3 + ...) up to s^9, whose next term is below
// 1e-9.
inline Lanes Lanes::log() const
{
  Lanes n, m;
  split(n, m);
  const Lanes s = (m - 1.f) / (m + 1.f);
  const Lanes squared = s.square();
  Lanes sum = Constant(2.f / 9.f);
  for (const float factor : {2.f / 7.f, 2.f / 5.f, 2.f / 3.f, 2.f}) {
    sum = factor + squared * sum;
  }
  return s * sum + n * -2.12194440e-4f + n * 0.693359375f;
}
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
