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
 * Where edges turn back: the ends of what is narrow.
 */

#ifndef VP_CIRCLE_MARKER_EDGE_CAPS_H
#define VP_CIRCLE_MARKER_EDGE_CAPS_H

#include <cstddef>
#include <vector>

#include "edges/edge_points.h"
#include "support/reused_list.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! An end of something narrow, dark or bright: where its edge comes from one side and turns back to the other. */
struct EdgeCap
{
  std::size_t chain = 0;  //!< Index of its chain.
  std::size_t pixel = 0;  //!< Number of the tip's pixel in the chain: the one in the middle of the turn.
  std::size_t before = 0; //!< Pixels before the tip up to which the edge does not bend back.
  std::size_t after = 0;  //!< And after the tip. In a closed chain both go on beyond its first pixel.
  Eigen::Vector2d tip;    //!< Where that pixel is.
  Eigen::Vector2d axis;   //!< Unit vector out of what is narrow.
  bool isDark = false;    //!< Whether that is darker than what is around.
};

/*! Finds the caps of a chain by the gradients of its pixels; they are appended in the order of the chain. */
void findCaps(const Gradient &gradient, const EdgeChains &chains, std::size_t index, ReusedList<EdgeCap> &caps);

/*! A pixel on either side of a cap. */
struct CapSides
{
  Eigen::Vector2d before;
  Eigen::Vector2d after;
};

/*! Where a cap is so many pixels before and after its tip, or where it ends if that is nearer. */
CapSides sidesOf(const EdgeChains &chains, const EdgeCap &cap, std::size_t reach);

/*! The edge points of a cap in the order of its chain, so many pixels to either side of the tip, appended to points. */
void locateCap(const Gradient &gradient, const EdgeChains &chains, const EdgeCap &cap, std::size_t reach,
               std::vector<EdgePoint> &points);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
