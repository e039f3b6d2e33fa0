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
 * Edge chains that are whole outlines.
 */

#include "ellipse/closed_chains.h"

#include "ellipse/outline_greys.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// A dark blob of fewer pixels around hides no piece of a ring: covered markers have a semi-minor axis of 6 pixels.
constexpr std::size_t longestBlob = 38;
// No outline inside of the image is longer than the image's own: longer closed chains are something else.
constexpr std::size_t longestOutline = 2;
} // namespace

void proposeClosedChain(const EllipseSearch &search, std::size_t index, EllipseMemory::Workspace &workspace)
{
  const EdgeChain &chain = search.chains.chains[index];
  std::uint8_t &left = search.memory.left[index];
  left = 0;
  if (search.deadline.hasPassed()) {
    return search.refuse(workspace, index, EllipseReject::TIMEOUT);
  }
  if (!chain.closed) {
    left = 1;
    return;
  }
  if (doubledArea(search.chains, chain) <= 0) {
    // White paper between a ring and what covers the rest of it: the ring's edge is a piece of its outline.
    left = brightInside;
    return;
  }
  const std::size_t longest = longestOutline * (search.I.getWidth() + search.I.getHeight());
  if (chain.length() > longest) {
    left = 1;
    return;
  }
  workspace.points.clear();
  locateChain(search.gradient, search.chains, chain, workspace.points);
  if (workspace.points.size() < fewestPoints) {
    return search.refuse(workspace, index, EllipseReject::TOO_SHORT);
  }
  if (search.isKnownElsewhere(workspace.points.data(), workspace.points.size())) {
    return search.refuse(workspace, index, EllipseReject::KNOWN_OUTLINE);
  }
  left = 1;
  if (!search.sought.dark && isDarkThroughout(search.I, workspace.points.data(), workspace.points.size())) {
    // A larger one may be a covered ring together with what covers it.
    left = chain.length() > longestBlob ? 1 : 0;
    return search.refuse(workspace, index, EllipseReject::OTHER_CENTER);
  }
  double support = 0.;
  const EllipseReject reason = search.propose(
      workspace, index, workspace.points.data(), workspace.points.size(), [&](EllipseCandidate &candidate) {
        const EllipseReject verdict = workspace.fitter.fit(search.I, search.gradient, workspace.points.data(),
                                                           workspace.points.size(), true, search.sought, candidate);
        support = candidate.support;
        return verdict;
      });
  // Where one ellipse fits all of the chain and is none that is sought, its arcs are none either. Of that of a ring
  // together with a dark blob on its edge a part is missing.
  const bool isDone = reason == EllipseReject::OTHER_CENTER ||
                      (reason == EllipseReject::NONE && (support >= wellFound || chain.length() <= longestBlob));
  left = isDone ? 0 : 1;
}
} // namespace circle_marker
END_VISP_NAMESPACE
