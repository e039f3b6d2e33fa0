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
 * Corners between the edges of a code as blurred pixels see them.
 */

/*!
  \file corners.h
  \brief What pixels, one by one or in blocks, see of corners: where a border between sectors meets a rim of the track,
  and those of a square sheet.
*/

#ifndef VP_CIRCLE_MARKER_CORNERS_H
#define VP_CIRCLE_MARKER_CORNERS_H

#include <cmath>

#include "refine/lanes.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
// Terms of the tetrachoric series: as many as leave 2e-4 of the contrast, but no more than these.
constexpr int mostCornerTerms = 10;
constexpr double cornerPrecision = 2e-4;
// Product of two densities below which a corner is not seen.
constexpr float leastCorner = 1e-5f;
// Edges that bend by less than this within the blur, in units of it, are straight at corners: 2e-4 of the contrast.
constexpr float leastBend = 2e-3f;
// Squared sine of the angle between two edges: corners are not sharper.
constexpr float leastSquaredSine = 0.05f;
// Probability of both sides of two edges less the product of the probabilities, and its derivatives. Number: Lanes, or
// double for a pixel of its own.
template <class Number> struct Corner
{
  Number value;
  Number byA;
  Number byB;
  Number byRho;
};
using CornerLanes = Corner<Lanes>;

inline void setConstant(float value, Lanes &number)
{
  number = Lanes::Constant(value);
}
inline void setConstant(float value, double &number)
{
  number = static_cast<double>(value);
}

// By the tetrachoric series, whose n-th term is rho^(n+1) / (n+1)! He_n(a) He_n(b) with the Hermite polynomials He_n,
// all times both densities; the derivative of a density times He_n is that of - He_(n+1), and by rho it is Mehler's
// series of the two variables' common density.
template <class Number>
inline Corner<Number> cornerOf(const Number &a, const Number &b, const Number &density, const Number &rho, int terms)
{
  Number power = rho;
  Number byPower, hermiteA, hermiteB, previousA, previousB; // byPower: rho^n / n!
  Corner<Number> corner;
  for (Number *one : {&byPower, &hermiteA, &hermiteB}) {
    setConstant(1.f, *one);
  }
  for (Number *zero : {&previousA, &previousB, &corner.value, &corner.byA, &corner.byB, &corner.byRho}) {
    setConstant(0.f, *zero);
  }
  for (int n = 0; n < terms; ++n) {
    const auto order = static_cast<float>(n);
    const Number nextA = a * hermiteA - order * previousA;
    const Number nextB = b * hermiteB - order * previousB;
    corner.value += power * hermiteA * hermiteB;
    corner.byA -= power * nextA * hermiteB;
    corner.byB -= power * hermiteA * nextB;
    corner.byRho += byPower * hermiteA * hermiteB;
    byPower = power;
    power *= rho / (order + 2.f);
    previousA = hermiteA;
    previousB = hermiteB;
    hermiteA = nextA;
    hermiteB = nextB;
  }
  corner.value *= density;
  corner.byA *= density;
  corner.byB *= density;
  corner.byRho *= density;
  return corner;
}

// What the bend of the circular edge b adds to a corner. The edge's distance is less by bend t^2 at the place t along
// it, on average over the black side of the straight edge, t < h = (a - rho b) / sqrt(1 - rho^2), by
// bend (Phi(h) - h phi(h)) instead of bend Phi(h).
inline void addBend(const Lanes &a, const Lanes &b, const Lanes &bend, const Lanes &isEdge, const Lanes &densityOfB,
                    const Lanes &rho, CornerLanes &corner)
{
  const Lanes perSine = (1.f - rho * rho).max(leastSquaredSine).rsqrt();
  const Lanes h = ((a - rho * b) * perSine).max(-6.5f).min(6.5f);
  const Lanes factor = isEdge * bend * densityOfB * 0.39894228f * (-0.5f * h * h).exp();
  const Lanes byH = factor * (1.f - h * h) * perSine;
  corner.value += factor * h;
  corner.byA += byH;
  corner.byB -= byH * rho + factor * h * b;
  corner.byRho += byH * (h * rho * perSine - b);
}

inline int cornerTermsFor(double rho)
{
  int terms = 1;
  // The Hermite functions are bounded so that term n is about a tenth of rho^(n+1) / (n+1).
  while (terms < mostCornerTerms && 0.1 * std::pow(rho, terms + 1) / (terms + 1) > cornerPrecision) {
    ++terms;
  }
  return terms;
}
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
