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

// The outline whose two ends are the points of the workspace, as two dark caps or as those of its sheet.
void putTogether(const EllipseSearch &search, const EdgeCap &cap, EllipseMemory::Workspace &workspace)
{
  const std::vector<EdgePoint> &points = workspace.points;
  if (!cap.isDark && !mayBeSheet(search.I, points.data(), points.size(), riseBesideLine(search.gradient))) {
    return search.refuse(workspace, cap.chain, points.data(), points.size(), EllipseReject::BRIGHT_INSIDE);
  }
  const EllipseReject reason =
      search.propose(workspace, cap.chain, points.data(), points.size(), [&](EllipseCandidate &candidate) {
        return cap.isDark ? workspace.fitter.fitEnds(search.I, search.gradient, points.data(), points.size(),
                                                     search.sought, candidate)
                          : workspace.fitter.fitThinRing(search.I, search.gradient, points.data(), points.size(),
                                                         ThinRing::BY_SHEETS_SHAPE, search.sought.thinRing, candidate);
      });
  if (reason == EllipseReject::NONE) {
    search.memory.known.take(workspace.proposals[workspace.proposals.size() - 1].candidate);
    workspace.proposals.removeLast();
  }
}
} // namespace

// Puts narrow things together from their ends.
void joinCaps(const EllipseSearch &search)
{
  std::vector<const EdgeCap *> &caps = search.memory.caps;
  caps.clear();
  for (EllipseMemory::Workspace &workspace : search.memory.workspaces) {
    for (EdgeCap &cap : workspace.caps) {
      caps.push_back(&cap);
    }
  }
  if (search.deadline.hasPassed() || caps.size() > fewestCaps + search.I.getSize() / pixelsForCap) {
    return;
  }
  sortCaps(caps);
  std::vector<CapOutlook> &outlooks = search.memory.outlooks;
  outlooks.clear();
  for (const EdgeCap *cap : caps) {
    outlooks.emplace_back(*cap);
  }
  search.memory.around.assign(caps.size(), {});
  EllipseMemory::Workspace &workspace = search.memory.workspaces.front();
  std::size_t left = fewestEnds + search.I.getSize() / pixelsForEnds;
  for (std::size_t i = 0; i < caps.size(); ++i) {
    if (search.deadline.hasPassed()) {
      return;
    }
    for (const CapRange &range : candidatesFor(caps, i)) {
      for (std::size_t j = range.begin; j < range.end; ++j) {
        if (!lookApart(outlooks[i], outlooks[j]) || !mayBeEnds(search.chains, *caps[i], *caps[j])) {
          continue;
        }
        if (left == 0 || search.deadline.hasPassed()) {
          return;
        }
        if (isInside(search, i) || isInside(search, j)) {
          continue;
        }
        --left;
        locateEnds(search.gradient, search.chains, *caps[i], *caps[j], workspace.points);
        putTogether(search, *caps[i], workspace);
      }
    }
  }
}
} // namespace circle_marker
END_VISP_NAMESPACE
