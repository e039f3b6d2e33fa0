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
 * A possible outline of a marker.
 */

#ifndef VP_CIRCLE_MARKER_ELLIPSE_CANDIDATE_H
#define VP_CIRCLE_MARKER_ELLIPSE_CANDIDATE_H

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Core>

#include "edges/edge_points.h"
#include "ellipse/fit_conic.h"

#include <visp3/circle_marker/vpCircleMarkerReject.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! Why a chain of edge points was not taken for the outline of a marker. */
using EllipseReject = vpCircleMarkerReject;

/*! What the markers that are sought have inside. */
struct SoughtCenters
{
  bool bright = true;   //!< Markers with a white centre: rings, with a code or without.
  bool dark = true;     //!< Markers with a black centre: discs.
  double thinRing = 0.; //!< Inner radius of the thinnest ring that is sought, of the outer one; 0: none is.
};

/*! An ellipse with a dark band on its inside and the edge points found along it. */
struct EllipseCandidate
{
  Eigen::Matrix3d conic = Eigen::Matrix3d::Zero(); //!< In pixels.
  EllipseParameters ellipse;                       //!< The same, as centre, axes and angle.
  std::vector<EdgePoint> points;                   //!< Along the ellipse, at most about one a pixel.
  double support = 0.;                             //!< Share of the ellipse along which an edge was found, in [0, 1].
  double contrast = 0.;                            //!< Median step from the dark band to the outside, grey levels.
  double behind = HUGE_VAL; //!< Semi-axis a of an outline of the same edge, of more of it: it comes after that one.
  bool isThin = false;      //!< Whether it was found as a thin ring: by its dark line, its sheet or its two ends.

  /*! What has more is looked at first: its semi-axis, or that of the one it comes after. */
  double rank() const { return std::min(ellipse.a, behind); }
};

/*! Makes an ellipse the whole outline, with so many points along it. */
void setOutline(const EllipseParameters &ellipse, int points, EllipseCandidate &candidate);

/*!
  An outline of which less than this share is found may be that of a piece of a ring's edge and of something else: the
  ring's other arcs along it, and those of its chain, are tried as well.
*/
constexpr double wellFound = 0.9;

/*! Whether so little of an outline is found that something may cover a part of it. */
inline bool isPartMissing(double support)
{
  constexpr double leastSupportOfWhole = 0.9;
  return support < leastSupportOfWhole;
}

/*! The order in which outlines are looked at: the largest first. */
inline bool comesBefore(const EllipseCandidate &p, const EllipseCandidate &q)
{
  return p.rank() != q.rank() ? p.rank() > q.rank() : p.support > q.support;
}
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
