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
 * From a run of edge points to the outline of something dark.
 */

#ifndef VP_CIRCLE_MARKER_OUTLINE_FITTER_H
#define VP_CIRCLE_MARKER_OUTLINE_FITTER_H

#include <cstddef>
#include <vector>

#include <visp3/circle_marker/vpCircleMarkerReject.h>
#include <visp3/core/vpImage.h>

#include "ellipse/dark_line.h"
#include "ellipse/ellipse_candidate.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! How a ring is found whose outer edge does not show. */
enum class ThinRing
{
  BY_INSIDE,      //!< By the dark line around its inner edge.
  BY_SHEET,       //!< By the dark line within the edge of its sheet, direction by direction.
  BY_SHEETS_SHAPE //!< By that line on all directions together, if the sheet has the shape of its circles.
};

/*!
  Fits ellipses to runs of edge points and completes them by searching their whole outline for edges. It holds working
  memory and no state: what it makes of a run does not depend on what it has seen before. One for each thread.
*/
class OutlineFitter
{
public:
  /*!
    \param I : The image.
    \param gradient : Its gradient.
    \param points, count : The run of edge points.
    \param isWhole : Whether it is one outline from its beginning to its end, which may have caught a piece of something
    else, or only an arc.
    \param sought : What the markers have inside.
    \param candidate : The outline, if the result is EllipseReject::NONE; undefined otherwise.
  */
  EllipseReject fit(const vpImage<unsigned char> &I, const Gradient &gradient, const EdgePoint *points,
                    std::size_t count, bool isWhole, const SoughtCenters &sought, EllipseCandidate &candidate);

  /*!
    The outline of two arcs with something between them.
    \param I : The image.
    \param gradient : Its gradient.
    \param points, count : Points of both arcs; some of them will do.
    \param length : Of both arcs, pixels.
    \param sought : What the markers have inside.
    \param candidate : The outline, if the result is EllipseReject::NONE; undefined otherwise.
  */
  EllipseReject fitJoined(const vpImage<unsigned char> &I, const Gradient &gradient, const EdgePoint *points,
                          std::size_t count, double length, const SoughtCenters &sought, EllipseCandidate &candidate);

  /*!
    The outline of a ring so narrow that only its ends show an edge: the ellipse through these.
    \param I : The image.
    \param gradient : Its gradient.
    \param points, count : Points of both ends.
    \param sought : What the markers have inside.
    \param candidate : The outline, if the result is EllipseReject::NONE; undefined otherwise.
  */
  EllipseReject fitEnds(const vpImage<unsigned char> &I, const Gradient &gradient, const EdgePoint *points,
                        std::size_t count, const SoughtCenters &sought, EllipseCandidate &candidate);

  /*!
    The outline of a ring so small that its black line and the quiet zone around it are thinner than the blur: its outer
    edge is then no edge any more, and its inner one lies too far in. What stays in its place is the darkest line
    between them, halfway between the two radii.
    \param I : The image.
    \param gradient : Its gradient.
    \param points, count : The closed edge of what lies beside the ring.
    \param kind : Of what, and how the line is found from there.
    \param ringInner : Inner radius of the ring, of the outer one.
    \param candidate : The outline, if the result is EllipseReject::NONE; undefined otherwise.
  */
  EllipseReject fitThinRing(const vpImage<unsigned char> &I, const Gradient &gradient, const EdgePoint *points,
                            std::size_t count, ThinRing kind, double ringInner, EllipseCandidate &candidate);

  /*!
    The outline of a marker that was seen in the image before.
    \param I : The image.
    \param gradient : Its gradient.
    \param expected : Where the outline is expected, off by a twelfth of its semi-minor axis at most.
    \param sought : What the markers have inside.
    \param candidate : The outline, if the result is EllipseReject::NONE; undefined otherwise.
  */
  EllipseReject follow(const vpImage<unsigned char> &I, const Gradient &gradient, const EllipseParameters &expected,
                       const SoughtCenters &sought, EllipseCandidate &candidate);

private:
  EllipseReject fitDarkLine(const vpImage<unsigned char> &I, const EdgePoint *points, std::size_t count,
                            RingNeighbour neighbour, double rise, EllipseCandidate &candidate);
  bool fitPoints(const EdgePoint *points, std::size_t count, EllipseCandidate &candidate,
                 const FitLimits &limits = roughFit);
  bool fitMost(const EdgePoint *points, std::size_t count, EllipseCandidate &candidate);
  EllipseReject complete(const vpImage<unsigned char> &I, const Gradient &gradient, const SoughtCenters &sought,
                         EllipseCandidate &candidate);

  std::vector<Eigen::Vector2d> m_positions; //!< Of the points of a fit.
  std::vector<double> m_distances;          //!< Of points from an ellipse.
  std::vector<double> m_sorted;             //!< The same in another order.
  std::vector<EdgePoint> m_kept;            //!< What is left of an outline without a piece of something else.
};

/*! By how much a thin ring's dark line must differ from what is beside it, grey levels. */
double riseBesideLine(const Gradient &gradient);

/*! Root-mean-square distance that points may have from their ellipse, pixels. */
double fitToleranceOf(const EllipseParameters &ellipse);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
