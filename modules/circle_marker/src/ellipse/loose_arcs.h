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
 * Arcs of one ellipse with something between them.
 */

#ifndef VP_CIRCLE_MARKER_LOOSE_ARCS_H
#define VP_CIRCLE_MARKER_LOOSE_ARCS_H

#include <array>
#include <cstddef>
#include <vector>

#include <visp3/core/vpImage.h>

#include "edges/convex_arcs.h"
#include "ellipse/outline_greys.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! An arc that gave no outline by itself: something may cover what is between it and others. */
struct LooseArc
{
  std::size_t chain = 0;         //!< Index of its chain.
  std::vector<EdgePoint> points; //!< In the chain's order: clockwise as the image is seen, dark inside.
  double turn = 0.;              //!< What it bends in all, rad.
  GreysBeside greys;             //!< Of what is inside and outside.
  std::array<EdgePoint, 3> ends; //!< Near its beginning, its middle and near its end; normals to the bright side.

  /*! The arc of a chain; its memory is used again. */
  void set(const vpImage<unsigned char> &I, std::size_t chainIndex, const EdgePoint *chainPoints, std::size_t count,
           double bend);
};

/*! Arcs that bend less in all, rad, are not joined: they are too straight to tell what they are a part of. */
constexpr double leastLooseTurn = 0.35;

/*!
  Whether two arcs may belong to one ellipse: they are dark and bright alike, bend enough together, look to different
  directions, and each lies on the inner side of the other's tangents, as all of a convex curve does (Prasad, Leung and
  Cho, "Edge curvature and convexity based ellipse detection method", Pattern Recognition 45, 2012, give such tests).
*/
bool mayBelongTogether(const LooseArc &one, const LooseArc &other);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
