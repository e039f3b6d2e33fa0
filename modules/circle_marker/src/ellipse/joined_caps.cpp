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
 * Outlines put together from their tips.
 */

#include "ellipse/joined_caps.h"

#include <algorithm>

#include "ellipse/cap_pairs.h"
#include "ellipse/sheet_ring.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Where there are more ends than these, of any image, and one more for so many pixels, most are of a texture, and each
// has too many others around. Clutter has one for 2300 pixels.
constexpr std::size_t fewestCaps = 200;
constexpr std::size_t pixelsForCap = 600;
// Ellipses that are put together from ends: so many are tried of any image, and one more for so many pixels. Clutter
// has one for 40000.
constexpr std::size_t fewestEnds = 100;
constexpr std::size_t pixelsForEnds = 2000;
// Ends that a thread takes at once: for one alone, taking it would cost as much as looking at it.
constexpr std::size_t capsAtOnce = 16;

// Whether a cap is inside of an outline that is mostly found. All outlines are gone through, so each cap asks only
// when it is one of a pair, and only for those that it has not asked for yet.
bool isInside(const EllipseSearch &search, std::size_t cap)
{
  EllipseMemory::Around &around = search.memory.around[cap];
  const std::size_t known = search.memory.known.outlines.size();
  if (!around.isInside && around.asked < known) {
    around.isInside = search.memory.known.surrounds(search.memory.caps[cap]->tip, wholeOutline, around.asked);
    around.asked = known;
  }
  return around.isInside;
}

// The pairs of all workspaces that are not inside of an outline, in the order of their caps, as many as are tried.
void gatherPairs(const EllipseSearch &search)
{
  using CapPair = EllipseMemory::CapPair;
  std::vector<CapPair> &pairs = search.memory.pairs;
  pairs.clear();
  for (const EllipseMemory::Workspace &workspace : search.memory.workspaces) {
    pairs.insert(pairs.end(), workspace.pairs.begin(), workspace.pairs.end());
  }
  std::sort(pairs.begin(), pairs.end(),
            [](const CapPair &p, const CapPair &q) { return p.one != q.one ? p.one < q.one : p.other < q.other; });
  const std::size_t most = fewestEnds + search.I.getSize() / pixelsForEnds;
  std::size_t kept = 0;
  for (std::size_t k = 0; k < pairs.size() && kept < most && !search.deadline.hasPassed(); ++k) {
    if (!isInside(search, pairs[k].one) && !isInside(search, pairs[k].other)) {
      pairs[kept++] = pairs[k];
    }
  }
  pairs.resize(kept);
}

// Proposes the outline whose two ends are those of a pair, as two dark caps or as those of its sheet.
EllipseReject putTogether(const EllipseSearch &search, const EllipseMemory::CapPair &pair,
                          EllipseMemory::Workspace &workspace)
{
  const EdgeCap &cap = *search.memory.caps[pair.one];
  locateEnds(search.gradient, search.chains, cap, *search.memory.caps[pair.other], workspace.points);
  const std::vector<EdgePoint> &points = workspace.points;
  if (!cap.isDark && !mayBeSheet(search.I, points.data(), points.size(), riseBesideLine(search.gradient))) {
    search.refuse(workspace, cap.chain, points.data(), points.size(), EllipseReject::BRIGHT_INSIDE);
    return EllipseReject::BRIGHT_INSIDE;
  }
  return search.propose(workspace, cap.chain, points.data(), points.size(), [&](EllipseCandidate &candidate) {
    return cap.isDark ? workspace.fitter.fitEnds(search.I, search.gradient, points.data(), points.size(), search.sought,
                                                 candidate)
                      : workspace.fitter.fitThinRing(search.I, search.gradient, points.data(), points.size(),
                                                     ThinRing::BY_SHEETS_SHAPE, search.sought.thinRing, candidate);
  });
}
} // namespace

std::size_t gatherCaps(const EllipseSearch &search)
{
  std::vector<const EdgeCap *> &caps = search.memory.caps;
  CapOutlooks &outlooks = search.memory.outlooks;
  caps.clear();
  outlooks.clear();
  for (EllipseMemory::Workspace &workspace : search.memory.workspaces) {
    workspace.pairs.clear();
    for (EdgeCap &cap : workspace.caps) {
      caps.push_back(&cap);
    }
  }
  if (search.deadline.hasPassed() || caps.size() > fewestCaps + search.I.getSize() / pixelsForCap) {
    caps.clear();
  }
  sortCaps(caps);
  for (const EdgeCap *cap : caps) {
    outlooks.add(*cap);
  }
  search.memory.around.assign(caps.size(), {});
  return (caps.size() + capsAtOnce - 1) / capsAtOnce;
}

void findCapPairs(const EllipseSearch &search, std::size_t task, EllipseMemory::Workspace &workspace)
{
  const std::vector<const EdgeCap *> &caps = search.memory.caps;
  const CapOutlooks &outlooks = search.memory.outlooks;
  const std::size_t end = std::min((task + 1) * capsAtOnce, caps.size());
  for (std::size_t i = task * capsAtOnce; i < end && !search.deadline.hasPassed(); ++i) {
    for (const CapRange &range : candidatesFor(caps, i)) {
      outlooks.findApart(i, range.begin, range.end, workspace.apart);
      for (const std::size_t j : workspace.apart) {
        if (mayBeEnds(search.chains, *caps[i], *caps[j])) {
          workspace.pairs.push_back({i, j, 0, std::nullopt});
        }
      }
    }
  }
}

// Each pair is put together on its own, and what comes of it is known in their order: it does not depend on the
// threads.
void joinCaps(const EllipseSearch &search, Workers &workers)
{
  using CapPair = EllipseMemory::CapPair;
  gatherPairs(search);
  std::vector<CapPair> &pairs = search.memory.pairs;
  workers.run(pairs.size(), [&](std::size_t k, unsigned int worker) {
    EllipseMemory::Workspace &workspace = search.memory.workspaces[worker];
    if (!search.deadline.hasPassed() && putTogether(search, pairs[k], workspace) == EllipseReject::NONE) {
      pairs[k].worker = worker;
      pairs[k].proposal = workspace.proposals.size() - 1;
    }
  });
  for (const CapPair &pair : pairs) {
    if (pair.proposal && !isInside(search, pair.one) && !isInside(search, pair.other)) {
      search.memory.known.take(search.memory.workspaces[pair.worker].proposals[*pair.proposal].candidate);
    }
  }
  for (EllipseMemory::Workspace &workspace : search.memory.workspaces) {
    workspace.proposals.clear();
  }
}
} // namespace circle_marker
END_VISP_NAMESPACE
