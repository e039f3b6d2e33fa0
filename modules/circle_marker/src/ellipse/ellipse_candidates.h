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
 * Ellipses that may be the outer edge of a marker.
 */

#ifndef VP_CIRCLE_MARKER_ELLIPSE_CANDIDATES_H
#define VP_CIRCLE_MARKER_ELLIPSE_CANDIDATES_H

#include <cstdint>
#include <vector>

#include "edges/convex_arcs.h"
#include "edges/edge_caps.h"
#include "ellipse/known_outlines.h"
#include "ellipse/loose_arcs.h"
#include "ellipse/outline_fitter.h"
#include "support/reused_list.h"
#include "support/workers.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
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
  /*! Memory of one thread. */
  struct Bench
  {
    OutlineFitter fitter;
    std::vector<EdgePoint> points;
    std::vector<ConvexArc> arcs;
    ReusedList<EdgeCap> caps;
    ReusedList<LooseArc> loose;
    ReusedList<Proposal> proposals;
    std::vector<Refusal> refusals;
  };
  std::vector<Bench> benches;
  std::vector<std::uint8_t> left;    //!< One per chain: whether it is still to be cut into arcs.
  std::vector<Proposal *> proposals; //!< Of all benches, in the order of their chains.
  std::vector<LooseArc *> loose;     //!< Of all benches, the longest first.
  std::vector<const EdgeCap *> caps; //!< Of all benches.
  std::vector<Around> around;        //!< One per cap.
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

/*!
  Finds the ellipses among the edge chains of an image. A closed chain is fitted as it is; the others are cut where they
  bend the wrong way or sharply, and the ellipse fitted to an arc, or else to two arcs with something between them, is
  completed by searching its whole outline for edges. Where an ellipse is so narrow that it bends sharply itself, at its
  tips, it is put together from these.
  The chains are shared among the workers; the result does not depend on their number.
  \param I : The image.
  \param gradient : Its gradient.
  \param chains : Its edge chains.
  \param sought : What the markers have inside.
  \param other : Chains that lie on outlines known at another scale are left out.
  \param workers : Threads.
  \param deadline : When to stop; what is found by then is kept.
  \param memory : Working memory; memory.known has the ellipses, no two of the same outline.
*/
void findEllipses(const vpImage<unsigned char> &I, const Gradient &gradient, const EdgeChains &chains,
                  const SoughtCenters &sought, const OtherScale &other, Workers &workers, const Deadline &deadline,
                  EllipseMemory &memory);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
