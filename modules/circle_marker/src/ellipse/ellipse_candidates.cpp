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
#include <cmath>
#include <functional>

#include "edges/convex_arcs.h"
#include "ellipse/cap_pairs.h"
#include "ellipse/outline_greys.h"
#include "ellipse/sheet_ring.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Shorter chains fix no ellipse.
constexpr std::size_t fewestPoints = 8;
// Marks of EllipseMemory::left for chains that are still to be cut: those that enclose something bright, too.
constexpr std::uint8_t brightInside = 2;
// A dark blob of fewer pixels around hides no piece of a ring: covered markers have a semi-minor axis of 6 pixels.
constexpr std::size_t longestBlob = 38;
// Longer closed edges are not the inside of a ring that is too thin to have an outer edge: one of 22 pixels at 60
// degrees has 100 around its inside.
constexpr std::size_t longestThinRing = 100;
// Nor is one longer than this the edge of its sheet; nor than this that of a sheet so narrow that its shape alone tells
// where the ring is, which may be one of 75 pixels, 7 wide.
constexpr std::size_t longestThinSheet = 150;
constexpr std::size_t longestNarrowSheet = 260;
// 4 pi times the area that either encloses, of the square of its length in pixels: more than 0.6 of an ellipse or a
// sheet at 75 degrees, and the steps along diagonals are not counted longer.
constexpr double leastRoundness = 0.5;
// The same of a sheet that is known by its shape alone: one of a ring at 84 degrees has 0.25.
constexpr double leastSheetRoundness = 0.2;
// Pieces that are cut from a chain's arcs at their corners, at most: a spiral of short lines has thousands.
constexpr std::size_t mostPieces = 16;
// What is inside of an outline that is found to this share is its code: its arcs are not joined.
constexpr double wholeOutline = 0.8;
// Loose arcs that are joined, the longest of an image, how often one is, and all: a photograph has a hundred, and each
// pair is a fit of an ellipse.
constexpr std::size_t mostLoose = 200;
constexpr int mostJoins = 8;
constexpr int mostJoinsOfAll = 300;
// Points of two arcs that their ellipse is fitted to.
constexpr std::size_t joinedPoints = 32;
// Longer chains have no caps that count: once around a sheet whose ends are those of the longest narrow thing, and
// more.
constexpr std::size_t longestCapChain = 400;
// Where there are more ends than these, of any image, and one more for so many pixels, most are of a texture, and each
// has too many others around. Clutter has one for 2300 pixels.
constexpr std::size_t fewestCaps = 200;
constexpr std::size_t pixelsForCap = 600;
// Ellipses that are put together from ends: so many are tried of any image, and one more for so many pixels. Clutter
// has one for 40000.
constexpr std::size_t fewestEnds = 100;
constexpr std::size_t pixelsForEnds = 2000;
// No outline inside of the image is longer than the image's own: longer closed chains are something else.
constexpr std::size_t longestOutline = 2;

// Twice the signed area that a chain of pixels encloses, as doubledArea().
std::int64_t doubledPixelArea(const EdgeChains &chains, const EdgeChain &chain)
{
  std::int64_t area = 0;
  EdgePixel previous = chains.pixels[chain.end - 1];
  for (std::size_t i = chain.begin; i < chain.end; ++i) {
    const EdgePixel here = chains.pixels[i];
    area += previous.x * here.y - previous.y * here.x;
    previous = here;
  }
  return area;
}

// One search; what all its tasks share.
struct Search
{
  const vpImage<unsigned char> &I;
  const Gradient &gradient;
  const EdgeChains &chains;
  const SoughtCenters &sought;
  const OtherScale &other;
  const Deadline &deadline;
  EllipseMemory &memory;

  bool isKnownElsewhere(const EdgePoint *points, std::size_t count) const
  {
    return other.known != nullptr && other.known->holds(points, count, other.scale, other.shift);
  }

  // Notes why a run of points gives no outline, if that is to be shown.
  void refuse(EllipseMemory::Bench &bench, std::size_t chain, const EdgePoint *points, std::size_t count,
              EllipseReject reason, const EllipseParameters &ellipse = EllipseParameters()) const
  {
    if (memory.keepsRefusals) {
      bench.refusals.push_back({chain, reason, ellipse, std::vector<EdgePoint>(points, points + count)});
    }
  }

  // The same for a chain whose points were not located.
  void refuse(EllipseMemory::Bench &bench, std::size_t chain, EllipseReject reason) const
  {
    if (memory.keepsRefusals) {
      std::vector<EdgePoint> points;
      for (std::size_t i = chains.chains[chain].begin; i < chains.chains[chain].end; ++i) {
        const EdgePixel pixel = chains.pixels[i];
        points.push_back({Eigen::Vector2d(pixel.x, pixel.y), Eigen::Vector2d::Zero()});
      }
      refuse(bench, chain, points.data(), points.size(), reason);
    }
  }

  // Proposes the outline of a run of points, or tells why there is none.
  EllipseReject propose(EllipseMemory::Bench &bench, std::size_t chain, const EdgePoint *points, std::size_t count,
                        bool isWhole) const
  {
    EllipseMemory::Proposal &proposal = bench.proposals.append();
    proposal.chain = chain;
    proposal.candidate.ellipse = EllipseParameters();
    const EllipseReject reason = bench.fitter.fit(I, gradient, points, count, isWhole, sought, proposal.candidate);
    if (reason != EllipseReject::NONE) {
      refuse(bench, chain, points, count, reason, proposal.candidate.ellipse);
      bench.proposals.removeLast();
    }
    return reason;
  }

  // A closed chain as one outline; open ones, and closed ones that are none, are left to be cut into arcs.
  void closedChain(std::size_t index, EllipseMemory::Bench &bench) const
  {
    const EdgeChain &chain = chains.chains[index];
    std::uint8_t &left = memory.left[index];
    left = 0;
    if (deadline.hasPassed()) {
      return refuse(bench, index, EllipseReject::TIMEOUT);
    }
    if (!chain.closed) {
      left = 1;
      return;
    }
    if (doubledPixelArea(chains, chain) <= 0) {
      // White paper between a ring and what covers the rest of it: the ring's edge is a piece of its outline.
      left = brightInside;
      return;
    }
    const std::size_t longest = longestOutline * (I.getWidth() + I.getHeight());
    if (chain.length() > longest) {
      left = 1;
      return;
    }
    bench.points.clear();
    locateChain(gradient, chains, chain, bench.points);
    if (bench.points.size() < fewestPoints) {
      return refuse(bench, index, EllipseReject::TOO_SHORT);
    }
    if (isKnownElsewhere(bench.points.data(), bench.points.size())) {
      return refuse(bench, index, EllipseReject::KNOWN_OUTLINE);
    }
    left = 1;
    if (!sought.dark && isDarkThroughout(I, bench.points.data(), bench.points.size())) {
      // A larger one may be a covered ring together with what covers it.
      left = chain.length() > longestBlob ? 1 : 0;
      return refuse(bench, index, EllipseReject::OTHER_CENTER);
    }
    const EllipseReject reason = propose(bench, index, bench.points.data(), bench.points.size(), true);
    // Where one ellipse fits all of the chain and is none that is sought, its arcs are none either.
    left = reason == EllipseReject::NONE || reason == EllipseReject::OTHER_CENTER ? 0 : 1;
  }

  void arcsOfChain(std::size_t index, EllipseMemory::Bench &bench) const
  {
    if (memory.left[index] == 0) {
      return;
    }
    if (deadline.hasPassed()) {
      return refuse(bench, index, EllipseReject::TIMEOUT);
    }
    const EdgeChain &chain = chains.chains[index];
    if (sought.thinRing > 0. && chain.closed && chain.length() <= longestNarrowSheet && thinRing(index, bench)) {
      return;
    }
    // What is so narrow shows at the full size, if at all.
    if (sought.thinRing > 0. && other.known == nullptr && chain.length() <= longestCapChain) {
      findCaps(gradient, chains, index, bench.caps);
    }
    if (mostTurn(gradient, chains, chain) < leastArcTurn) {
      return refuse(bench, index,
                    memory.left[index] == brightInside ? EllipseReject::BRIGHT_INSIDE : EllipseReject::LITTLE_BEND);
    }
    bench.points.clear();
    locateChain(gradient, chains, chain, bench.points, deadline);
    cutConvexArcs(bench.points, leastLooseTurn, bench.arcs, deadline);
    if (bench.arcs.empty()) {
      refuse(bench, index, bench.points.data(), bench.points.size(), EllipseReject::LITTLE_BEND);
    }
    const std::size_t most = bench.arcs.size() + mostPieces;
    for (std::size_t k = 0; k < bench.arcs.size(); ++k) { // pieces of them are appended
      const ConvexArc arc = bench.arcs[k];
      const EdgePoint *points = bench.points.data() + arc.begin;
      if (deadline.hasPassed()) {
        return refuse(bench, index, EllipseReject::TIMEOUT);
      }
      if (memory.known.holds(points, arc.length()) || isKnownElsewhere(points, arc.length())) {
        refuse(bench, index, points, arc.length(), EllipseReject::KNOWN_OUTLINE);
        continue;
      }
      if (arc.turn < leastArcTurn) {
        refuse(bench, index, points, arc.length(), EllipseReject::LITTLE_BEND);
      }
      else if (propose(bench, index, points, arc.length(), false) == EllipseReject::NONE) {
        bench.loose.append().set(I, index, points, arc.length(), arc.turn); // another outline may have more of it
        continue;
      }
      if (bench.arcs.size() > most || !cutAtCorner(bench.points, arc, leastLooseTurn, bench.arcs)) {
        bench.loose.append().set(I, index, points, arc.length(), arc.turn);
      }
    }
  }

  // The closed edge of something bright may be the inside of a ring whose outer edge does not show, and any closed edge
  // that of its sheet. Whether it is one, or leads to an outline that is known.
  bool thinRing(std::size_t index, EllipseMemory::Bench &bench) const
  {
    const EdgeChain &chain = chains.chains[index];
    const EdgePixel *pixels = &chains.pixels[chain.begin];
    const auto length = static_cast<double>(chain.length());
    const double area = 0.5 * std::abs(static_cast<double>(doubledPixelArea(chains, chain)));
    const double roundness = 4. * M_PI * area / (length * length);
    const bool isRound = roundness >= leastRoundness;
    const double rise = riseBesideLine(gradient);
    const bool mayBeInside = isRound && memory.left[index] == brightInside && chain.length() <= longestThinRing;
    const auto hasDarkLine = [&](RingNeighbour neighbour) {
      return mayHaveDarkLineBeside(I, pixels, chain.length(), neighbour, rise);
    };
    bench.points.clear();
    return (mayBeInside && hasDarkLine(RingNeighbour::INSIDE) && proposeThinRing(index, ThinRing::BY_INSIDE, bench)) ||
           (isRound && chain.length() <= longestThinSheet && hasDarkLine(RingNeighbour::SHEET) &&
            proposeThinRing(index, ThinRing::BY_SHEET, bench)) ||
           (roundness >= leastSheetRoundness && mayBeSheet(I, pixels, chain.length(), rise) &&
            proposeThinRing(index, ThinRing::BY_SHEETS_SHAPE, bench));
  }

  bool proposeThinRing(std::size_t index, ThinRing kind, EllipseMemory::Bench &bench) const
  {
    if (bench.points.empty()) {
      locateChain(gradient, chains, chains.chains[index], bench.points);
    }
    if (bench.points.size() < fewestPoints) {
      return false;
    }
    EllipseMemory::Proposal &proposal = bench.proposals.append();
    proposal.chain = index;
    proposal.candidate.ellipse = EllipseParameters();
    EllipseReject reason = bench.fitter.fitThinRing(I, gradient, bench.points.data(), bench.points.size(), kind,
                                                    sought.thinRing, proposal.candidate);
    // By its outer edge it is known better.
    if (reason == EllipseReject::NONE && memory.known.hasSame(proposal.candidate.ellipse, true)) {
      reason = EllipseReject::KNOWN_OUTLINE;
    }
    if (reason != EllipseReject::NONE) {
      refuse(bench, index, bench.points.data(), bench.points.size(), reason, proposal.candidate.ellipse);
      bench.proposals.removeLast();
    }
    return reason == EllipseReject::NONE || reason == EllipseReject::KNOWN_OUTLINE;
  }

  // The loose arcs that may be joined, the longest first.
  void gatherLoose() const
  {
    std::vector<LooseArc *> &loose = memory.loose;
    loose.clear();
    for (EllipseMemory::Bench &bench : memory.benches) {
      for (LooseArc &arc : bench.loose) {
        if (!memory.known.holds(arc.points.data(), arc.points.size(), 1., 0., wholeOutline) &&
            !memory.known.surrounds(arc.ends[1].position, wholeOutline)) {
          loose.push_back(&arc);
        }
      }
    }
    // Those of one chain lie in one bench, one behind the other.
    std::sort(loose.begin(), loose.end(), [](const LooseArc *p, const LooseArc *q) {
      const auto length = [](const LooseArc *arc) { return arc->points.size(); };
      return length(p) != length(q) ? length(p) > length(q)
             : p->chain != q->chain ? p->chain < q->chain
                                    : std::less<>()(p, q);
    });
    loose.resize(std::min(loose.size(), mostLoose));
  }

  // Joins arcs by twos. What is along an outline that comes of it, however much of that is found, is done with.
  void joinArcs() const
  {
    gatherLoose();
    std::vector<LooseArc *> &loose = memory.loose;
    EllipseMemory::Bench &bench = memory.benches.front();
    int joins = 0;
    for (std::size_t i = 0; i < loose.size(); ++i) {
      int joinsOfArc = 0;
      for (std::size_t j = i + 1; loose[i] != nullptr && j < loose.size(); ++j) {
        if (loose[j] == nullptr || !mayBelongTogether(*loose[i], *loose[j])) {
          continue;
        }
        if (deadline.hasPassed() || ++joins > mostJoinsOfAll) {
          return;
        }
        if (join(*loose[i], *loose[j], bench)) {
          for (LooseArc *&arc : loose) {
            if (arc != nullptr && memory.known.holds(arc->points.data(), arc->points.size())) {
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

  // Whether two arcs give an outline, which is kept if it is new or better than the same one.
  bool join(const LooseArc &one, const LooseArc &other, EllipseMemory::Bench &bench) const
  {
    const std::size_t length = one.points.size() + other.points.size();
    bench.points.clear();
    for (const LooseArc *arc : {&one, &other}) {
      for (std::size_t i = 0; i < arc->points.size(); i += 1 + length / joinedPoints) {
        bench.points.push_back(arc->points[i]);
      }
    }
    EllipseMemory::Proposal &proposal = bench.proposals.append();
    proposal.candidate.ellipse = EllipseParameters();
    const EllipseReject reason = bench.fitter.fitJoined(I, gradient, bench.points.data(), bench.points.size(),
                                                        static_cast<double>(length), sought, proposal.candidate);
    if (reason == EllipseReject::NONE) {
      memory.known.take(proposal.candidate);
    }
    bench.proposals.removeLast();
    return reason == EllipseReject::NONE;
  }

  // Whether a cap is inside of an outline that is mostly found. All outlines are gone through, so each cap asks only
  // when it is one of a pair, and only for those that it has not asked for yet.
  bool isInside(std::size_t cap) const
  {
    EllipseMemory::Around &around = memory.around[cap];
    const std::size_t known = memory.known.outlines.size();
    if (!around.isInside && around.asked < known) {
      around.isInside = memory.known.surrounds(memory.caps[cap]->tip, wholeOutline, around.asked);
      around.asked = known;
    }
    return around.isInside;
  }

  // Puts narrow things together from their ends.
  void joinCaps() const
  {
    std::vector<const EdgeCap *> &caps = memory.caps;
    caps.clear();
    for (EllipseMemory::Bench &bench : memory.benches) {
      for (EdgeCap &cap : bench.caps) {
        caps.push_back(&cap);
      }
    }
    if (deadline.hasPassed() || caps.size() > fewestCaps + I.getSize() / pixelsForCap) {
      return;
    }
    sortCaps(caps);
    memory.around.assign(caps.size(), {});
    EllipseMemory::Bench &bench = memory.benches.front();
    std::size_t left = fewestEnds + I.getSize() / pixelsForEnds;
    for (std::size_t i = 0; i < caps.size(); ++i) {
      if (deadline.hasPassed()) {
        return;
      }
      for (const CapRange &range : candidatesFor(caps, i)) {
        for (std::size_t j = range.begin; j < range.end; ++j) {
          if (!mayBeEnds(chains, *caps[i], *caps[j])) {
            continue;
          }
          if (left == 0 || deadline.hasPassed()) {
            return;
          }
          if (isInside(i) || isInside(j)) {
            continue;
          }
          --left;
          locateEnds(gradient, chains, *caps[i], *caps[j], bench.points);
          putTogether(*caps[i], bench);
        }
      }
    }
  }

  // The outline whose two ends are the points of the bench, as two dark caps or as those of its sheet.
  void putTogether(const EdgeCap &cap, EllipseMemory::Bench &bench) const
  {
    const std::vector<EdgePoint> &points = bench.points;
    if (!cap.isDark && !mayBeSheet(I, points.data(), points.size(), riseBesideLine(gradient))) {
      return refuse(bench, cap.chain, points.data(), points.size(), EllipseReject::BRIGHT_INSIDE);
    }
    EllipseMemory::Proposal &proposal = bench.proposals.append();
    proposal.candidate.ellipse = EllipseParameters();
    const EllipseReject reason =
        cap.isDark ? bench.fitter.fitEnds(I, gradient, points.data(), points.size(), sought, proposal.candidate)
                   : bench.fitter.fitThinRing(I, gradient, points.data(), points.size(), ThinRing::BY_SHEETS_SHAPE,
                                              sought.thinRing, proposal.candidate);
    if (reason == EllipseReject::NONE) {
      memory.known.take(proposal.candidate);
    }
    else {
      refuse(bench, cap.chain, points.data(), points.size(), reason, proposal.candidate.ellipse);
    }
    bench.proposals.removeLast();
  }

  // Keeps what was proposed, in the order of the chains: that does not depend on which thread had which chain.
  void settle() const
  {
    memory.proposals.clear();
    for (EllipseMemory::Bench &bench : memory.benches) {
      for (EllipseMemory::Proposal &proposal : bench.proposals) {
        memory.proposals.push_back(&proposal);
      }
    }
    // Proposals of one chain lie in one bench, one behind the other; benches do not order addresses, so chains first.
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
        refuse(memory.benches.front(), proposal->chain, dropped.points.data(), dropped.points.size(),
               EllipseReject::KNOWN_OUTLINE, dropped.ellipse);
      }
    }
    for (EllipseMemory::Bench &bench : memory.benches) {
      bench.proposals.clear();
    }
  }
};
} // namespace

void findEllipses(const vpImage<unsigned char> &I, const Gradient &gradient, const EdgeChains &chains,
                  const SoughtCenters &sought, const OtherScale &other, Workers &workers, const Deadline &deadline,
                  EllipseMemory &memory)
{
  memory.benches.resize(std::max<std::size_t>(memory.benches.size(), workers.getCount()));
  memory.left.resize(chains.chains.size());
  memory.known.reset(gradient.width, gradient.height);
  for (EllipseMemory::Bench &bench : memory.benches) {
    bench.refusals.clear();
    bench.loose.clear();
    bench.caps.clear();
  }
  const Search search = {I, gradient, chains, sought, other, deadline, memory};
  workers.run(chains.chains.size(),
              [&](std::size_t chain, unsigned int worker) { search.closedChain(chain, memory.benches[worker]); });
  search.settle();
  workers.run(chains.chains.size(),
              [&](std::size_t chain, unsigned int worker) { search.arcsOfChain(chain, memory.benches[worker]); });
  search.settle();
  search.joinArcs();
  search.joinCaps();
}
} // namespace circle_marker
END_VISP_NAMESPACE
