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
 * Pieces of outlines in edge chains.
 */

#include "ellipse/chain_arcs.h"

#include "edges/convex_arcs.h"
#include "edges/edge_caps.h"
#include "ellipse/thin_rings.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Pieces that are cut from a chain's arcs at their corners, at most: a spiral of short lines has thousands.
constexpr std::size_t mostPieces = 16;
// Longer chains have no caps that count: once around a sheet whose ends are those of the longest narrow thing, and
// more.
constexpr std::size_t longestCapChain = 1400;

// Whether an arc gives an outline that is well found. One that is not is kept, too, but may be that of a ring's edge
// and what it goes on along behind a corner.
bool proposeArc(const EllipseSearch &search, std::size_t index, const EdgePoint *points, std::size_t count,
                EllipseMemory::Workspace &workspace)
{
  double support = 0.;
  search.propose(workspace, index, points, count, [&](EllipseCandidate &candidate) {
    const EllipseReject reason =
        workspace.fitter.fit(search.I, search.gradient, points, count, false, search.sought, candidate);
    support = reason == EllipseReject::NONE ? candidate.support : 0.;
    return reason;
  });
  return support >= wellFound;
}
} // namespace

void proposeArcsOfChain(const EllipseSearch &search, std::size_t index, EllipseMemory::Workspace &workspace)
{
  if (search.memory.left[index] == 0) {
    return;
  }
  if (search.deadline.hasPassed()) {
    return search.refuse(workspace, index, EllipseReject::TIMEOUT);
  }
  const EdgeChain &chain = search.chains.chains[index];
  workspace.points.clear();
  if (search.sought.thinRing > 0. && chain.closed && chain.length() <= longestNarrowSheet &&
      proposeThinRing(search, index, workspace)) {
    return;
  }
  // What is so narrow shows at the full size, if at all.
  if (search.sought.thinRing > 0. && search.other.known == nullptr && chain.length() <= longestCapChain) {
    findCaps(search.gradient, search.chains, index, workspace.caps);
  }
  if (mostTurn(search.gradient, search.chains, chain) < leastArcTurn) {
    return search.refuse(workspace, index,
                         search.memory.left[index] == brightInside ? EllipseReject::BRIGHT_INSIDE
                                                                   : EllipseReject::LITTLE_BEND);
  }
  if (workspace.points.empty()) { // or they were located for a thin ring
    locateChain(search.gradient, search.chains, chain, workspace.points, search.deadline);
  }
  cutConvexArcs(workspace.points, leastLooseTurn, workspace.arcs, search.deadline);
  if (workspace.arcs.empty()) {
    search.refuse(workspace, index, workspace.points.data(), workspace.points.size(), EllipseReject::LITTLE_BEND);
  }
  const std::size_t most = workspace.arcs.size() + mostPieces;
  for (std::size_t k = 0; k < workspace.arcs.size(); ++k) { // pieces of them are appended
    const ConvexArc arc = workspace.arcs[k];
    const EdgePoint *points = workspace.points.data() + arc.begin;
    if (search.deadline.hasPassed()) {
      return search.refuse(workspace, index, EllipseReject::TIMEOUT);
    }
    if (search.memory.known.holds(points, arc.length(), 1., 0., wellFound) ||
        search.isKnownElsewhere(points, arc.length())) {
      search.refuse(workspace, index, points, arc.length(), EllipseReject::KNOWN_OUTLINE);
      continue;
    }
    if (arc.turn < leastArcTurn) {
      search.refuse(workspace, index, points, arc.length(), EllipseReject::LITTLE_BEND);
    }
    else if (proposeArc(search, index, points, arc.length(), workspace)) {
      workspace.loose.append().set(search.I, index, points, arc.length(),
                                   arc.turn); // another outline may have more of it
      continue;
    }
    if (workspace.arcs.size() > most || !cutAtCorner(workspace.points, arc, leastLooseTurn, workspace.arcs)) {
      workspace.loose.append().set(search.I, index, points, arc.length(), arc.turn);
    }
  }
}
} // namespace circle_marker
END_VISP_NAMESPACE
