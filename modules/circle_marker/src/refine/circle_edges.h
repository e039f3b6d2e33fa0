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
 * Circles about the centre of a marker as blurred pixels see them.
 */

/*!
  \file circle_edges.h
  \brief What blocks of pixels see of circles about the marker's centre.
*/

#ifndef VP_CIRCLE_MARKER_CIRCLE_EDGES_H
#define VP_CIRCLE_MARKER_CIRCLE_EDGES_H

#include "refine/image_model.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
// The second-order distance to a circle is not let further from the first-order one than by this share, and the shift
// by its curvature not beyond half of the blur: only pixels that do not see the circle come so far.
constexpr float leastStretch = 0.8f;
constexpr float mostStretch = 1.25f;
constexpr float mostCurvature = 1.f;
constexpr float leastFading = 0.4f;
constexpr float mostFading = 2.f;
// A block that is farther from an edge than this many standard deviations of the blur, to first order, does not see it.
// Beyond lie 3e-7 of the contrast.
constexpr float farFromEdge = 5.f;
// Edges that bend by less than this within the blur, in units of it, do so at any pose: it is a hundredth of what their
// distance changes with the tilt.
constexpr float steadyBend = 0.02f;

// What the curvature of circles about the centre needs of a block's pixels.
struct CurvatureLanes
{
  Lanes perGradient;        // 1 / length of the radius' gradient in the image, pixels
  Lanes alongNormal;        // second derivative of the radius along the gradient, by the gradient, 1 / pixel
  Lanes alongTangent;       // and along the circle
  Lanes fading;             // share by which the circles' curvature falls on the way out, 1 / pixel
  Lanes stretched[2];       // stretch of the blur across the circles by each part of an elongation
  Lanes tangentU, tangentV; // derivative by the pixel of the place along the circle
};

// Stretch of the blur across an edge by each part of an elongation: cosine and sine of twice the direction of its
// normal (u, v) of length 1 / perLength.
inline void stretchOf(const Lanes &u, const Lanes &v, const Lanes &perLength, Lanes stretched[2])
{
  const Lanes cosine = u * perLength;
  const Lanes sine = v * perLength;
  stretched[0] = cosine * cosine - sine * sine;
  stretched[1] = 2.f * cosine * sine;
}

inline void curvatureOf(const PlaneLanes &p, const SecondOrder &second, CurvatureLanes &curvature)
{
  curvature.perGradient = p.gradient.inverse();
  const Lanes perRadius = p.radius.inverse();
  const Lanes hu = p.qyByU * p.outX - p.qxByU * p.outY;
  const Lanes hv = p.qyByV * p.outX - p.qxByV * p.outY;
  const Lanes normal = (hu * p.gradientU + hv * p.gradientV) * curvature.perGradient;
  const Lanes tangent = (hv * p.gradientU - hu * p.gradientV) * curvature.perGradient;
  curvature.tangentU = hu;
  curvature.tangentV = hv;
  const Lanes ofCircle = normal * normal * perRadius * curvature.perGradient;
  curvature.fading = p.gradient * perRadius + 3.f * ofCircle;
  // Where the scale changes the gradient and what is bent along the edge change alike, so that the curvature does not.
  const Lanes acrossU = p.gradientU * curvature.perGradient;
  const Lanes acrossV = p.gradientV * curvature.perGradient;
  curvature.alongNormal = ofCircle + second.across(p, acrossU, acrossV);
  curvature.alongTangent = tangent * tangent * perRadius * curvature.perGradient + second.along(acrossU, acrossV);
  stretchOf(p.gradientU, p.gradientV, curvature.perGradient, curvature.stretched);
}

// An edge that none of the pixels sees: all are on the same side of it as this distance.
inline void seeNothing(const Lanes &distance, EdgeLanes &edge)
{
  edge.standardised = (1e30f * distance).max(-6.5f).min(6.5f);
  edge.normal.cumulative = (1e30f * distance).max(0.f).min(1.f);
  edge.normal.density.setZero();
  edge.bend.setZero();
  edge.isSeen = false;
}

// Circle of a radius, black inside (blackSide 1) or outside (-1).
template <bool hasSlopes>
void seeCircle(const PlaneLanes &p, const CurvatureLanes &curvature, float radius, float blackSide, float sigma,
               const Lanes &growth, EdgeLanes &edge)
{
  const float perSigma = 1.f / sigma;
  const Lanes first = (radius - p.radius) * curvature.perGradient;
  if (first.abs().minCoeff() > farFromEdge * sigma) {
    seeNothing(blackSide * first, edge);
    return;
  }
  // Second-order distance along the gradient to the level set of the radius.
  const Lanes bow = curvature.alongNormal * first;
  const Lanes distance = first * (1.f - 0.5f * bow).max(leastStretch).min(mostStretch);
  const Lanes scaled = perSigma * distance;
  // Curvature where the edge is, in units of the blur: half of it is the mean, and its square half of the variance, of
  // what the edge bends away within the blur.
  const Lanes atEdge = curvature.alongTangent * (1.f - curvature.fading * distance).max(leastFading).min(mostFading);
  const Lanes bend = (0.5f * sigma) * atEdge.min(mostCurvature * perSigma);
  const Lanes squared = bend * bend;
  edge.bend = blackSide * bend;
  // The density stays what it is from 6.5 on, and the corners' polynomials must not grow on.
  edge.standardised = (blackSide * (scaled - bend) * (1.f - squared) + growth * perSigma).max(-6.5f).min(6.5f);
  edge.normal = normalOf(edge.standardised);
  edge.isSeen = true;
  if constexpr (hasSlopes) {
    SlopeLanes &slope = edge.slope;
    const Lanes way = distance * curvature.perGradient;
    slope.footX = p.qx + way * (p.gradientU * p.qxByU + p.gradientV * p.qxByV);
    slope.footY = p.qy + way * (p.gradientU * p.qyByU + p.gradientV * p.qyByV);
    // The gradient of the radius there; its length is the same for a normal of any length.
    const Lanes gu = p.qxByU * slope.footX + p.qyByU * slope.footY;
    const Lanes gv = p.qxByV * slope.footX + p.qyByV * slope.footY;
    const Lanes perLength = (gu * gu + gv * gv).max(1e-12f).rsqrt();
    slope.gradientU = gu * perLength;
    slope.gradientV = gv * perLength;
    slope.perGradient = radius * perLength;
    const Lanes byNormal = (-blackSide * perSigma) * (1.f - squared) * perLength;
    slope.byX = byNormal * slope.footX;
    slope.byY = byNormal * slope.footY;
    slope.bySigma = -perSigma * (blackSide * (scaled * (1.f + squared) + bend) + growth * perSigma);
    // Distances across shrink, and the curvature with them and with the square of what is longer along the edge.
    const Lanes byStretch = -blackSide * (scaled * (1.f + squared) - 3.f * bend) - growth * perSigma;
    for (std::size_t k = 0; k < 2; ++k) {
      slope.byElongation[k] = byStretch * curvature.stretched[k];
    }
    slope.bySpread = perSigma * curvature.perGradient;
  }
}
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
