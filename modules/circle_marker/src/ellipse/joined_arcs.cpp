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
 * Outlines of which two arcs show.
 */

#include "ellipse/joined_arcs.h"

#include <algorithm>
#include <functional>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Loose arcs that are joined, the longest of an image, how often one is, and all: a photograph has a hundred, and each
// pair is a fit of an ellipse.
constexpr std::size_t mostLoose = 200;
constexpr int mostJoins = 8;
constexpr int mostJoinsOfAll = 300;
// Points of two arcs that their ellipse is fitted to.
constexpr std::size_t joinedPoints = 32;

// The loose arcs that may be joined, the longest first.
void gatherLoose(const EllipseSearch &search)
{
  std::vector<LooseArc *> &loose = search.memory.loose;
  loose.clear();
  for (EllipseMemory::Workspace &workspace : search.memory.workspaces) {
    for (LooseArc &arc : workspace.loose) {
      loose.push_back(&arc);
    }
  }
  // Those of one chain lie in one workspace, one behind the other.
  std::sort(loose.begin(), loose.end(), [](const LooseArc *p, const LooseArc *q) {
    const auto length = [](const LooseArc *arc) { return arc->points.size(); };
    return length(p) != length(q) ? length(p) > length(q)
           : p->chain != q->chain ? p->chain < q->chain
                                  : std::less<>()(p, q);
  });
  // Those that are a piece of an outline that is known, or lie inside of it, are left out. Each asks all outlines, so
  // no more are asked than are wanted.
  std::size_t kept = 0;
  for (std::size_t i = 0; i < loose.size() && kept < mostLoose && !search.deadline.hasPassed(); ++i) {
    const LooseArc &arc = *loose[i];
    if (!search.memory.known.holds(arc.points.data(), arc.points.size(), 1., 0., wholeOutline) &&
        !search.memory.known.surrounds(arc.ends[1].position, wholeOutline)) {
      loose[kept++] = loose[i];
    }
  }
  loose.resize(kept);
}

// Whether two arcs give an outline, which is kept if it is new or better than the same one.
bool join(const EllipseSearch &search, const LooseArc &one, const LooseArc &other, EllipseMemory::Workspace &workspace)
{
  const std::size_t length = one.points.size() + other.points.size();
  workspace.points.clear();
  for (const LooseArc *arc : {&one, &other}) {
    for (std::size_t i = 0; i < arc->points.size(); i += 1 + length / joinedPoints) {
      workspace.points.push_back(arc->points[i]);
    }
  }
  EllipseMemory::Proposal &proposal = workspace.proposals.append();
  proposal.candidate.ellipse = EllipseParameters();
  const EllipseReject reason =
      workspace.fitter.fitJoined(search.I, search.gradient, workspace.points.data(), workspace.points.size(),
                                 static_cast<double>(length), search.sought, proposal.candidate);
  if (reason == EllipseReject::NONE) {
    search.memory.known.take(proposal.candidate);
  }
  workspace.proposals.removeLast();
  return reason == EllipseReject::NONE;
}
} // namespace

// Joins arcs by twos. What is along an outline that comes of it, however much of that is found, is done with.
void joinArcs(const EllipseSearch &search, EllipseMemory::Workspace &workspace)
{
  gatherLoose(search);
  std::vector<LooseArc *> &loose = search.memory.loose;
  int joins = 0;
  for (std::size_t i = 0; i < loose.size(); ++i) {
    int joinsOfArc = 0;
    for (std::size_t j = i + 1; loose[i] != nullptr && j < loose.size(); ++j) {
      if (loose[j] == nullptr || !mayBelongTogether(*loose[i], *loose[j])) {
        continue;
      }
      if (search.deadline.hasPassed() || ++joins > mostJoinsOfAll) {
        return;
      }
      if (join(search, *loose[i], *loose[j], workspace)) {
        for (LooseArc *&arc : loose) {
          if (arc != nullptr && search.memory.known.holds(arc->points.data(), arc->points.size())) {
            arc = nullptr;
          }
        }
      }
      else if (++joinsOfArc == mostJoins) {
        break;
      }
    }
  }
}
} // namespace circle_marker
END_VISP_NAMESPACE
