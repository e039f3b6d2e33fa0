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
 * Rings that are too thin to have an outer edge.
 */

#include "ellipse/thin_rings.h"

#include <cmath>

#include "ellipse/sheet_ring.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Longer closed edges are not the inside of a ring that is too thin to have an outer edge: one with a minor axis of 22
// pixels at 60 degrees has 100 around its inside. (Wider ones, up to 32, are sought where they face the camera more.)
constexpr std::size_t longestThinRing = 100;
// Nor is one longer than this the edge of its sheet; nor than this that of a sheet so narrow that its shape alone tells
// where the ring is, which may be one of 75 pixels, 7 wide.
constexpr std::size_t longestThinSheet = 150;
// 4 pi times the area that either encloses, of the square of its length in pixels: more than 0.6 of an ellipse or a
// sheet at 75 degrees, and the steps along diagonals are not counted longer.
constexpr double leastRoundness = 0.5;
// The same of a sheet that is known by its shape alone: one of a ring at 84 degrees has 0.25.
constexpr double leastSheetRoundness = 0.2;

// Proposes the ring that the chain is this part of. Whether there is one, or one that is known.
bool proposeAs(const EllipseSearch &search, std::size_t index, ThinRing kind, EllipseMemory::Workspace &workspace)
{
  if (workspace.points.empty()) {
    locateChain(search.gradient, search.chains, search.chains.chains[index], workspace.points);
  }
  if (workspace.points.size() < fewestPoints) {
    return false;
  }
  const EdgePoint *points = workspace.points.data();
  const std::size_t count = workspace.points.size();
  const EllipseReject reason = search.propose(workspace, index, points, count, [&](EllipseCandidate &candidate) {
    const EllipseReject fitted =
        workspace.fitter.fitThinRing(search.I, search.gradient, points, count, kind, search.sought.thinRing, candidate);
    // By its outer edge it is known better.
    return fitted == EllipseReject::NONE && search.memory.known.hasSame(candidate.ellipse, true)
               ? EllipseReject::KNOWN_OUTLINE
               : fitted;
  });
  return reason == EllipseReject::NONE || reason == EllipseReject::KNOWN_OUTLINE;
}
} // namespace

bool proposeThinRing(const EllipseSearch &search, std::size_t index, EllipseMemory::Workspace &workspace)
{
  const EdgeChain &chain = search.chains.chains[index];
  const EdgePixel *pixels = &search.chains.pixels[chain.begin];
  const auto length = static_cast<double>(chain.length());
  const double area = 0.5 * std::abs(static_cast<double>(doubledArea(search.chains, chain)));
  const double roundness = 4. * M_PI * area / (length * length);
  const bool isRound = roundness >= leastRoundness;
  const double rise = riseBesideLine(search.gradient);
  const bool mayBeInside = isRound && search.memory.left[index] == brightInside && chain.length() <= longestThinRing;
  const auto hasDarkLine = [&](RingNeighbour neighbour) {
    return mayHaveDarkLineBeside(search.I, pixels, chain.length(), neighbour, rise);
  };
  workspace.points.clear();
  return (mayBeInside && hasDarkLine(RingNeighbour::INSIDE) &&
          proposeAs(search, index, ThinRing::BY_INSIDE, workspace)) ||
         (isRound && chain.length() <= longestThinSheet && hasDarkLine(RingNeighbour::SHEET) &&
          proposeAs(search, index, ThinRing::BY_SHEET, workspace)) ||
         (roundness >= leastSheetRoundness && mayBeSheet(search.I, pixels, chain.length(), rise) &&
          proposeAs(search, index, ThinRing::BY_SHEETS_SHAPE, workspace));
}
} // namespace circle_marker
END_VISP_NAMESPACE
