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

// What the curvature of circles about the centre needs of a block's pixels.
struct CurvatureLanes
{
  Lanes perGradient;  // 1 / length of the radius' gradient in the image, pixels
  Lanes alongNormal;  // second derivative of the radius along the gradient, by the gradient, 1 / pixel
  Lanes alongTangent; // and along the circle
  Lanes fading;       // share by which the circles' curvature falls on the way out, 1 / pixel
  Lanes stretched[2]; // stretch of the blur across the circles by each part of an elongation
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

inline void curvatureOf(const PlaneLanes &p, CurvatureLanes &curvature)
{
  curvature.perGradient = p.gradient.inverse();
  const Lanes perRadius = p.radius.inverse();
  const Lanes hu = p.qyByU * p.outX - p.qxByU * p.outY;
  const Lanes hv = p.qyByV * p.outX - p.qxByV * p.outY;
  const Lanes normal = (hu * p.gradientU + hv * p.gradientV) * curvature.perGradient;
  const Lanes tangent = (hv * p.gradientU - hu * p.gradientV) * curvature.perGradient;
  curvature.alongNormal = normal * normal * perRadius * curvature.perGradient;
  curvature.alongTangent = tangent * tangent * perRadius * curvature.perGradient;
  curvature.fading = p.gradient * perRadius + 3.f * curvature.alongNormal;
  stretchOf(p.gradientU, p.gradientV, curvature.perGradient, curvature.stretched);
}

// An edge that none of the pixels sees: all are on the same side of it as this distance.
inline void seeNothing(const Lanes &distance, EdgeLanes &edge)
{
  edge.standardised = (1e30f * distance).max(-6.5f).min(6.5f);
  edge.normal.cumulative = (1e30f * distance).max(0.f).min(1.f);
  edge.normal.density.setZero();
  edge.bend.setZero();
  edge.byRadius.setZero();
  edge.bySigma.setZero();
  edge.byStretch.setZero();
}

// Circle of a radius, black inside (blackSide 1) or outside (-1).
inline void seeCircle(const PlaneLanes &p, const CurvatureLanes &curvature, float radius, float blackSide, float sigma,
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
  const Lanes stretch = (1.f - 0.5f * bow).max(leastStretch).min(mostStretch);
  const Lanes scaled = perSigma * first * stretch;
  // Curvature where the edge is, in units of the blur: half of it is the mean, and its square half of the variance, of
  // what the edge bends away within the blur.
  const Lanes atEdge =
      curvature.alongTangent * (1.f - curvature.fading * first * stretch).max(leastFading).min(mostFading);
  const Lanes bend = (0.5f * sigma) * atEdge.min(mostCurvature * perSigma);
  const Lanes squared = bend * bend;
  edge.bend = blackSide * bend;
  // The density stays what it is from 6.5 on, and the corners' polynomials must not grow on.
  edge.standardised = (blackSide * (scaled - bend) * (1.f - squared) + growth * perSigma).max(-6.5f).min(6.5f);
  edge.normal = normalOf(edge.standardised);
  edge.byRadius =
      (-blackSide * perSigma) * curvature.perGradient * (1.f - bow - squared).max(leastStretch).min(mostStretch);
  edge.bySigma = -perSigma * (blackSide * (scaled * (1.f + squared) + bend) + growth * perSigma);
  // Distances across shrink, and the curvature with them and with the square of what is longer along the edge.
  edge.byStretch = -blackSide * (scaled * (1.f + squared) - 3.f * bend);
}

// Black between two circles.
inline void seeBand(const PlaneLanes &p, const EdgeLanes &outer, const EdgeLanes &inner, float perSigma,
                    const CurvatureLanes &curvature, SumLanes &band)
{
  band.value = outer.normal.cumulative + inner.normal.cumulative - 1.f;
  const Lanes byRadius = outer.normal.density * outer.byRadius + inner.normal.density * inner.byRadius;
  band.byX = byRadius * p.outX;
  band.byY = byRadius * p.outY;
  band.bySigma = outer.normal.density * outer.bySigma + inner.normal.density * inner.bySigma;
  band.byGrowth = perSigma * (outer.normal.density + inner.normal.density);
  band.bySpread = curvature.perGradient * band.byGrowth;
  const Lanes byStretch = outer.normal.density * outer.byStretch + inner.normal.density * inner.byStretch;
  band.byElongation[0] = byStretch * curvature.stretched[0];
  band.byElongation[1] = byStretch * curvature.stretched[1];
}
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
