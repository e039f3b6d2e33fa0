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
 */

/*!
  \file ellipse/ellipse_search.h
  \brief What the ways to find ellipses among edge chains share.
*/

#ifndef VP_CIRCLE_MARKER_ELLIPSE_SEARCH_H
#define VP_CIRCLE_MARKER_ELLIPSE_SEARCH_H

#include <cstdint>
#include <optional>
#include <vector>

#include <visp3/core/vpImage.h>

#include "edges/convex_arcs.h"
#include "edges/dark_dots.h"
#include "edges/edge_caps.h"
#include "ellipse/cap_pairs.h"
#include "ellipse/known_outlines.h"
#include "ellipse/loose_arcs.h"
#include "ellipse/outline_fitter.h"
#include "support/reused_list.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! Shorter chains, in points, fix no ellipse. */
constexpr std::size_t fewestPoints = 8;
/*! What is inside of an outline that is found to this share is its code: its arcs and ends are not joined. */
constexpr double wholeOutline = 0.8;
/*! Mark of a chain that is still to be cut and that encloses something bright. */
constexpr std::uint8_t brightInside = 2;

/*! Working memory of findEllipses(). */
struct EllipseMemory
{
  /*! An outline that a chain has given. */
  struct Proposal
  {
    std::size_t chain = 0; //!< Index of the chain.
    EllipseCandidate candidate;
  };
  /*! A run of edge points that has given no outline. */
  struct Refusal
  {
    std::size_t chain = 0; //!< Index of its chain.
    EllipseReject reason = EllipseReject::NONE;
    EllipseParameters ellipse; //!< a = 0 if there is none.
    std::vector<EdgePoint> points;
  };
  /*! What is known of where a cap is. */
  struct Around
  {
    std::size_t asked = 0; //!< Of the known outlines, so many were asked whether it is inside of them.
    bool isInside = false; //!< Whether it is inside of one of these.
  };
  /*! Two caps that may be the ends of one thing. */
  struct CapPair
  {
    std::size_t one = 0; //!< Places of the caps.
    std::size_t other = 0;
    unsigned int worker = 0;             //!< The thread that has put them together,
    std::optional<std::size_t> proposal; //!< and where it has what came of it.
  };
  /*! A ring between two dots. */
  struct DotRing
  {
    std::size_t one = 0; //!< Places of the dots.
    std::size_t other = 0;
    EllipseParameters ellipse; //!< Its outer edge.
  };
  /*! Working memory of one thread. */
  struct Workspace
  {
    OutlineFitter fitter;
    std::vector<EdgePoint> points;
    std::vector<ConvexArc> arcs;
    ReusedList<EdgeCap> caps;
    std::vector<std::size_t> apart; //!< Numbers of caps.
    std::vector<CapPair> pairs;
    std::vector<DarkDot> dots;
    std::vector<DotRing> rings;
    ReusedList<LooseArc> loose;
    ReusedList<Proposal> proposals;
    std::vector<Refusal> refusals;
  };
  std::vector<Workspace> workspaces;
  std::vector<std::uint8_t> left;         //!< One per chain: whether it is still to be cut into arcs, or brightInside.
  std::vector<Proposal *> proposals;      //!< Of all workspaces, in the order of their chains.
  std::vector<LooseArc *> loose;          //!< Of all workspaces, the longest first.
  std::vector<const EdgeCap *> caps;      //!< Of all workspaces.
  CapOutlooks outlooks;                   //!< Theirs.
  std::vector<Around> around;             //!< One per cap.
  std::vector<CapPair> pairs;             //!< Of caps.
  std::vector<DarkDot> dots;              //!< Of all workspaces.
  std::vector<std::size_t> dotsInSquares; //!< Their numbers.
  std::vector<DotRing> rings;             //!< Between these.
  EllipseCandidate ofDots;                //!< The outline of one of them.
  KnownOutlines known;
  bool keepsRefusals = false; //!< Whether refusals are kept, to be shown.
};

/*! Outlines that are known at another scale, and where a position of this scale is there. */
struct OtherScale
{
  const KnownOutlines *known = nullptr; //!< Nothing if there are none.
  double scale = 1.;                    //!< There: scale * position + shift.
  double shift = 0.;                    //!< Pixels.
};

/*! One search; what all its tasks share. */
struct EllipseSearch
{
  const vpImage<unsigned char> &I;
  const Gradient &gradient;
  const EdgeChains &chains;
  const SoughtCenters &sought;
  const OtherScale &other;
  const Deadline &deadline;
  EllipseMemory &memory;

  /*! Whether most of a run of points lies on an outline that is known at another scale. */
  bool isKnownElsewhere(const EdgePoint *points, std::size_t count) const;

  /*! Notes why a run of points gives no outline, if that is to be shown. */
  void refuse(EllipseMemory::Workspace &workspace, std::size_t chain, const EdgePoint *points, std::size_t count,
              EllipseReject reason, const EllipseParameters &ellipse = EllipseParameters()) const;

  /*! The same of a chain whose points were not located. */
  void refuse(EllipseMemory::Workspace &workspace, std::size_t chain, EllipseReject reason) const;

  /*!
    Proposes the outline of a run of points, or tells why there is none.
    \param workspace : Whose last proposal it is then.
    \param chain : Index of the chain of the points.
    \param points, count : The points.
    \param fit : Fits a candidate: EllipseReject(EllipseCandidate &).
  */
  template <class Fit>
  EllipseReject propose(EllipseMemory::Workspace &workspace, std::size_t chain, const EdgePoint *points,
                        std::size_t count, const Fit &fit) const
  {
    EllipseMemory::Proposal &proposal = workspace.proposals.append();
    proposal.chain = chain;
    proposal.candidate.ellipse = EllipseParameters();
    const EllipseReject reason = fit(proposal.candidate);
    if (reason != EllipseReject::NONE) {
      refuse(workspace, chain, points, count, reason, proposal.candidate.ellipse);
      workspace.proposals.removeLast();
    }
    return reason;
  }

  /*! Keeps what was proposed, in the order of the chains: that does not depend on which thread had which chain. */
  void settle() const;
};
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
