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
 * What edges of the print change in the image when the print moves.
 */

/*!
  \file edge_motion.h
  \brief What edges of the print change in the image when the print moves.

  The share of black that a pixel sees is a function of its distances from the edges, of the circles' bend and of the
  angles between edges. Each changes with the pose by the motion q' of the print under the pixel's ray, and by its
  gradient, at the foot of the perpendicular on the edge (image_model.h).
*/

#ifndef VP_CIRCLE_MARKER_EDGE_MOTION_H
#define VP_CIRCLE_MARKER_EDGE_MOTION_H

#include "refine/circle_edges.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
/*! Adds up the derivatives of a block's share of black, edge by edge. */
class EdgeMotion
{
public:
  /*!
    \param cx, cy : The camera's centre in the marker's frame, in radii.
    \param perDepth : 1 / its distance from the plane, in radii.
    \param seesBend : Whether derivatives by the sheet's bend are wanted.
  */
  EdgeMotion(float cx, float cy, float perDepth, bool seesBend)
      : m_cx(cx), m_cy(cy), m_perDepth(perDepth), m_seesBend(seesBend)
  {
  }

  /*! An edge that is straight, with how much the share of black changes with its distance. */
  void addStraight(const SlopeLanes &slope, const Lanes &weight, DarknessLanes &darkness) const
  {
    addMotion(slope, weight * slope.byX, weight * slope.byY, darkness);
    addBlur(slope, weight, darkness);
  }

  /*!
    A circle, with how much the share of black changes with its distance: by its motion, and by how its bend changes.
    The curvature is det(J)^2 / (radius g^3), with J the derivative of q by the pixel and g the radius' gradient at the
    foot.
  */
  void addCircle(const PlaneLanes &p, const EdgeLanes &edge, const Lanes &weight, DarknessLanes &darkness) const;

  /*!
    The cosine of the angle in the image between a border and the circles, with how much the share of black changes with
    it: the circles' direction turns as a ray moves along them, and both turn with the derivative of q by the pixel.
    \param p, curvature : Where the pixels are.
    \param slope : Of the border.
    \param acrossX, acrossY : Unit vector on the marker across it.
    \param weight : Derivative of the share of black by the cosine.
    \param darkness : The sum.
  */
  void addAngle(const PlaneLanes &p, const CurvatureLanes &curvature, const SlopeLanes &slope, const Lanes &acrossX,
                const Lanes &acrossY, const Lanes &weight, DarknessLanes &darkness) const;

  /*!
    What the motion of the print under a ray at a point of the plane changes.
    \param x, y : The point.
    \param byX, byY : Derivative by its place.
    \param darkness : The sum.
  */
  void addMotion(const Lanes &x, const Lanes &y, const Lanes &byX, const Lanes &byY, DarknessLanes &darkness) const
  {
    const Lanes byAngle = (byX * (x - m_cx) + byY * (y - m_cy)) * m_perDepth;
    darkness.byTwist[0] -= byX;
    darkness.byTwist[1] -= byY;
    darkness.byTwist[2] += byAngle;
    darkness.byTwist[3] += byAngle * y;
    darkness.byTwist[4] -= byAngle * x;
    darkness.byTwist[5] += byX * y - byY * x;
    if (m_seesBend) { // the print moves by the sheet's height there
      darkness.byBend[0] += 0.5f * byAngle * (x * x + y * y - 1.f);
      darkness.byBend[1] += 0.5f * byAngle * (x * x - y * y);
      darkness.byBend[2] += byAngle * x * y;
    }
  }

private:
  // The same at the foot of an edge.
  void addMotion(const SlopeLanes &slope, const Lanes &byX, const Lanes &byY, DarknessLanes &darkness) const
  {
    addMotion(slope.footX, slope.footY, byX, byY, darkness);
  }

  // What that motion changes by its gradient: m^T (grad q') x, with m the derivative (byX, byY) and x the vector (x, y)
  // of the plane.
  void addStrain(const SlopeLanes &slope, const Lanes &byX, const Lanes &byY, const Lanes &x, const Lanes &y,
                 DarknessLanes &darkness) const
  {
    const Lanes byScale = (byX * x + byY * y) * m_perDepth;
    const Lanes byAngle = (byX * (slope.footX - m_cx) + byY * (slope.footY - m_cy)) * m_perDepth;
    darkness.byTwist[2] += byScale;
    darkness.byTwist[3] += byAngle * y + byScale * slope.footY;
    darkness.byTwist[4] -= byAngle * x + byScale * slope.footX;
    darkness.byTwist[5] += byX * y - byY * x;
    if (m_seesBend) {
      const Lanes &fx = slope.footX;
      const Lanes &fy = slope.footY;
      darkness.byBend[0] += byAngle * (fx * x + fy * y) + 0.5f * byScale * (fx * fx + fy * fy - 1.f);
      darkness.byBend[1] += byAngle * (fx * x - fy * y) + 0.5f * byScale * (fx * fx - fy * fy);
      darkness.byBend[2] += byAngle * (fx * y + fy * x) + byScale * fx * fy;
    }
  }

  // What blur and spread of ink change by the distance of an edge.
  static void addBlur(const SlopeLanes &slope, const Lanes &weight, DarknessLanes &darkness)
  {
    darkness.bySigma += weight * slope.bySigma;
    darkness.byElongation[0] += weight * slope.byElongation[0];
    darkness.byElongation[1] += weight * slope.byElongation[1];
    darkness.bySpread += weight * slope.bySpread;
  }

  float m_cx, m_cy; // of the camera's centre, radii
  float m_perDepth; // 1 / its distance from the plane
  bool m_seesBend;
};

inline void EdgeMotion::addCircle(const PlaneLanes &p, const EdgeLanes &edge, const Lanes &weight,
                                  DarknessLanes &darkness) const
{
  const SlopeLanes &slope = edge.slope;
  addStraight(slope, weight, darkness);
  if (edge.bend.abs().maxCoeff() < steadyBend) {
    return;
  }
  const Lanes byBend = -weight * edge.bend; // by the logarithm of the curvature
  const Lanes one = Lanes::Ones();
  const Lanes none = Lanes::Zero();
  addStrain(slope, 2.f * byBend, none, one, none, darkness);
  addStrain(slope, none, 2.f * byBend, none, one, darkness);
  const Lanes perRadius = (slope.footX * slope.footX + slope.footY * slope.footY).rsqrt();
  const Lanes outX = slope.footX * perRadius;
  const Lanes outY = slope.footY * perRadius;
  const Lanes x = (p.qxByU * slope.gradientU + p.qxByV * slope.gradientV) * slope.perGradient;
  const Lanes y = (p.qyByU * slope.gradientU + p.qyByV * slope.gradientV) * slope.perGradient;
  const Lanes byGradient = -3.f * byBend;
  addStrain(slope, byGradient * outX, byGradient * outY, x, y, darkness);
  // The foot moves along the circle, to where the gradient is another.
  const Lanes byTangent = byGradient * (outX * y - outY * x) * perRadius;
  addMotion(slope, -byTangent * outY, byTangent * outX, darkness);
}

inline void EdgeMotion::addAngle(const PlaneLanes &p, const CurvatureLanes &curvature, const SlopeLanes &slope,
                                 const Lanes &acrossX, const Lanes &acrossY, const Lanes &weight,
                                 DarknessLanes &darkness) const
{
  const Lanes gu = p.qxByU * acrossX + p.qyByU * acrossY;
  const Lanes gv = p.qxByV * acrossX + p.qyByV * acrossY;
  const Lanes perGradient = (gu * gu + gv * gv).rsqrt();
  const Lanes borderU = gu * perGradient;
  const Lanes borderV = gv * perGradient;
  const Lanes circleU = p.gradientU * curvature.perGradient;
  const Lanes circleV = p.gradientV * curvature.perGradient;
  const Lanes cosine = borderU * circleU + borderV * circleV;
  const Lanes byBorderU = (circleU - cosine * borderU) * perGradient;
  const Lanes byBorderV = (circleV - cosine * borderV) * perGradient;
  const Lanes byCircleU = (borderU - cosine * circleU) * curvature.perGradient;
  const Lanes byCircleV = (borderV - cosine * circleV) * curvature.perGradient;
  const Lanes byTangent = weight * (byCircleU * curvature.tangentU + byCircleV * curvature.tangentV) / p.radius;
  addMotion(slope, -byTangent * p.outY, byTangent * p.outX, darkness);
  addStrain(slope, weight * acrossX, weight * acrossY, p.qxByU * byBorderU + p.qxByV * byBorderV,
            p.qyByU * byBorderU + p.qyByV * byBorderV, darkness);
  addStrain(slope, weight * p.outX, weight * p.outY, p.qxByU * byCircleU + p.qxByV * byCircleV,
            p.qyByU * byCircleU + p.qyByV * byCircleV, darkness);
  // A longer blur draws both directions to the axis across it: E g, with the matrix E of the elongation's part.
  const Lanes border[2] = {borderU * borderU - borderV * borderV, 2.f * borderU * borderV};
  const Lanes circle[2] = {circleU * circleU - circleV * circleV, 2.f * circleU * circleV};
  const Lanes both[2] = {borderU * circleU - borderV * circleV, borderU * circleV + borderV * circleU};
  for (std::size_t k = 0; k < 2; ++k) {
    darkness.byElongation[k] += weight * (2.f * both[k] - cosine * (border[k] + circle[k]));
  }
}
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
