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
 * Convex arcs cut from chains of edge points.
 */

#ifndef VP_CIRCLE_MARKER_CONVEX_ARCS_H
#define VP_CIRCLE_MARKER_CONVEX_ARCS_H

#include <cstddef>
#include <vector>

#include "edges/edge_points.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! Arcs that bend less in all, rad, do not fix an ellipse. */
constexpr double leastArcTurn = 0.9;

/*! A run of a chain's edge points that bends one way. */
struct ConvexArc
{
  std::size_t begin = 0; //!< Half-open range of the points.
  std::size_t end = 0;
  double turn = 0.; //!< What it bends in all, rad.

  std::size_t length() const { return end - begin; }
};

/*!
  Upper bound of what any arc of a chain of pixels bends in all, rad: the turn of the gradient, looked at every few
  pixels, along the run that turns most. It takes a fraction of what locating the chain's points takes.
*/
double mostTurn(const Gradient &gradient, const EdgeChains &chains, const EdgeChain &chain);

/*!
  Cuts a chain where it bends the wrong way (bright inside) or sharply, and returns the pieces that bend enough.
  \param points : Edge points in the order of their chain.
  \param leastTurn : What a piece has to bend in all, rad.
  \param arcs : The pieces, in the order of the chain.
  \param deadline : When to stop; the arcs so far are kept.
*/
void cutConvexArcs(const std::vector<EdgePoint> &points, double leastTurn, std::vector<ConvexArc> &arcs,
                   const Deadline &deadline = Deadline());

/*!
  Where an arc that is no piece of an ellipse has caught something else, which it meets at a corner blunter than those
  that cutConvexArcs() cuts at: the sharpest bend, if it is far sharper than the arc's others.
  \param points : Edge points in the order of their chain.
  \param arc : An arc of them.
  \param arcs : What is on either side of the bend, and bends enough, is appended.
  \param leastTurn : What it has to bend in all, rad.
  \return Whether there is such a bend.
*/
bool cutAtCorner(const std::vector<EdgePoint> &points, const ConvexArc &arc, double leastTurn,
                 std::vector<ConvexArc> &arcs);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
