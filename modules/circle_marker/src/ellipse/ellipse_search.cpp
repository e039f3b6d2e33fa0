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
 * What the ways to find ellipses among edge chains share.
 */

#include "ellipse/ellipse_search.h"

#include <algorithm>
#include <functional>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
bool EllipseSearch::isKnownElsewhere(const EdgePoint *points, std::size_t count) const
{
  return other.known != nullptr && other.known->holds(points, count, other.scale, other.shift);
}

void EllipseSearch::refuse(EllipseMemory::Workspace &workspace, std::size_t chain, const EdgePoint *points,
                           std::size_t count, EllipseReject reason, const EllipseParameters &ellipse) const
{
  if (memory.keepsRefusals) {
    workspace.refusals.push_back({chain, reason, ellipse, std::vector<EdgePoint>(points, points + count)});
  }
}

void EllipseSearch::refuse(EllipseMemory::Workspace &workspace, std::size_t chain, EllipseReject reason) const
{
  if (memory.keepsRefusals) {
    std::vector<EdgePoint> points;
    for (std::size_t i = chains.chains[chain].begin; i < chains.chains[chain].end; ++i) {
      const EdgePixel pixel = chains.pixels[i];
      points.push_back({Eigen::Vector2d(pixel.x, pixel.y), Eigen::Vector2d::Zero()});
    }
    refuse(workspace, chain, points.data(), points.size(), reason);
  }
}

void EllipseSearch::settle() const
{
  memory.proposals.clear();
  for (EllipseMemory::Workspace &workspace : memory.workspaces) {
    for (EllipseMemory::Proposal &proposal : workspace.proposals) {
      memory.proposals.push_back(&proposal);
    }
  }
  // Proposals of one chain lie in one workspace, one behind the other; workspaces do not order addresses, so chains
  // come first.
  std::sort(memory.proposals.begin(), memory.proposals.end(),
            [](const EllipseMemory::Proposal *p, const EllipseMemory::Proposal *q) {
              return p->chain != q->chain ? p->chain < q->chain : std::less<>()(p, q);
            });
  for (EllipseMemory::Proposal *proposal : memory.proposals) {
    if (deadline.hasPassed()) {
      break;
    }
    if (!memory.known.take(proposal->candidate)) {
      const EllipseCandidate &dropped = proposal->candidate;
      refuse(memory.workspaces.front(), proposal->chain, dropped.points.data(), dropped.points.size(),
             EllipseReject::KNOWN_OUTLINE, dropped.ellipse);
    }
  }
  for (EllipseMemory::Workspace &workspace : memory.workspaces) {
    workspace.proposals.clear();
  }
}
} // namespace circle_marker
END_VISP_NAMESPACE
