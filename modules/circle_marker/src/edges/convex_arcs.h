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
#include <utility>
#include <vector>

#include "edges/edge_points.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Twice the signed area enclosed by a chain of edge points (closed by its chord), square pixels: positive if the chain
  runs clockwise as the image is seen, which is the outline of something dark.
*/
double doubledArea(const std::vector<EdgePoint> &points);

/*! Arcs that bend less in all, rad, do not fix an ellipse. */
constexpr double leastArcTurn = 0.9;

/*!
  Upper bound of what any arc of a chain of pixels bends in all, rad: the turn of the gradient, looked at every few
  pixels, along the run that turns most. It takes a fraction of what locating the chain's points takes.
*/
double mostTurn(const Gradient &gradient, const EdgeChains &chains, const EdgeChain &chain);

/*!
  Cuts a chain where it bends the wrong way (bright inside) or sharply, and returns the pieces that bend enough to fix
  an ellipse.
  \param points : Edge points in the order of their chain.
  \param arcs : Half-open index ranges.
  \param deadline : When to stop; the arcs so far are kept.
*/
void cutConvexArcs(const std::vector<EdgePoint> &points, std::vector<std::pair<std::size_t, std::size_t>> &arcs,
                   const Deadline &deadline = Deadline());
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
