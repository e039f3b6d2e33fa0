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
 * Ellipses among the edge chains of an image.
 */

#include "ellipse/ellipse_candidates.h"

#include <algorithm>

#include "ellipse/chain_arcs.h"
#include "ellipse/closed_chains.h"
#include "ellipse/joined_arcs.h"
#include "ellipse/joined_caps.h"
#include "ellipse/joined_dots.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
void findEllipses(const vpImage<unsigned char> &I, const Gradient &gradient, const EdgeChains &chains,
                  const SoughtCenters &sought, const OtherScale &other, Workers &workers, const Deadline &deadline,
                  EllipseMemory &memory)
{
  memory.workspaces.resize(std::max<std::size_t>(memory.workspaces.size(), workers.getCount()));
  memory.left.resize(chains.chains.size());
  memory.known.reset(gradient.width, gradient.height);
  for (EllipseMemory::Workspace &workspace : memory.workspaces) {
    workspace.proposals.clear(); // there are some where the last search was ended by an exception
    workspace.refusals.clear();
    workspace.loose.clear();
    workspace.caps.clear();
  }
  const EllipseSearch search = {I, gradient, chains, sought, other, deadline, memory};
  workers.run(chains.chains.size(), [&](std::size_t chain, unsigned int worker) {
    proposeClosedChain(search, chain, memory.workspaces[worker]);
  });
  search.settle();
  workers.run(chains.chains.size(), [&](std::size_t chain, unsigned int worker) {
    proposeArcsOfChain(search, chain, memory.workspaces[worker]);
  });
  search.settle();
  // Which caps may belong together does not depend on what comes of the arcs.
  workers.run(1 + gatherCaps(search), [&](std::size_t task, unsigned int worker) {
    EllipseMemory::Workspace &workspace = memory.workspaces[worker];
    task == 0 ? joinArcs(search, workspace) : findCapPairs(search, task - 1, workspace);
  });
  joinCaps(search, workers);
  joinDots(search, workers);
}
} // namespace circle_marker
END_VISP_NAMESPACE
