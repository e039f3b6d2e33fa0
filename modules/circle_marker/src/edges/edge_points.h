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
 * Edge points located to a fraction of a pixel.
 */

#ifndef VP_CIRCLE_MARKER_EDGE_POINTS_H
#define VP_CIRCLE_MARKER_EDGE_POINTS_H

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "segment/edge_chains.h"
#include "segment/gradient.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! A point of an edge. */
struct EdgePoint
{
  Eigen::Vector2d position; //!< Pixels; integer coordinates are pixel centres.
  Eigen::Vector2d across;   //!< Across the edge, to the bright side; of any length, which few ask for.

  /*! Unit vector across the edge, to the bright side. */
  Eigen::Vector2d normal() const { return across.normalized(); }
};

/*!
  The edge point nearest to a pixel of an edge: the maximum of the parabola through three gradient magnitudes along
  the image axis that crosses the edge more squarely (Devernay, INRIA report 2724, 1995). Looks one pixel to either
  side for the ridge. Nothing if there is no maximum there.
*/
std::optional<EdgePoint> locateEdge(const Gradient &gradient, int x, int y);

/*! The edge points of a chain, in its order, appended to \e points; after the deadline those so far. */
void locateChain(const Gradient &gradient, const EdgeChains &chains, const EdgeChain &chain,
                 std::vector<EdgePoint> &points, const Deadline &deadline = Deadline());

/*!
  Searches along the line position + t * direction, |t| <= reach, for the strongest edge whose bright side lies within
  60 degrees of \e direction.
  \param gradient : Gradient of the image.
  \param position : Where to start, pixels.
  \param direction : Unit vector.
  \param reach : How far to look to either side, pixels.
*/
std::optional<EdgePoint> searchEdge(const Gradient &gradient, const Eigen::Vector2d &position,
                                    const Eigen::Vector2d &direction, double reach);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
