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

#include <vector>

#include "edges/edge_points.h"
#include "ellipse/fit_conic.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! Why a chain of edge points was not taken for the outline of a marker. */
enum class EllipseReject
{
  NONE,           //!< It was taken.
  TOO_SHORT,      //!< Too few edge points.
  BRIGHT_INSIDE,  //!< The outline of something bright, or no outline at all.
  NOT_AN_ELLIPSE, //!< No ellipse fits, or its axes are out of bounds.
  BAD_FIT,        //!< The points lie too far from the ellipse.
  LITTLE_SUPPORT, //!< Too small a part of the ellipse has an edge in the image.
  NOT_DARK_INSIDE //!< There is no dark band along the inside of the ellipse.
};

/*! An ellipse with a dark band on its inside and the edge points found along it. */
struct EllipseCandidate
{
  Eigen::Matrix3d conic;         //!< In pixels.
  EllipseParameters ellipse;     //!< The same, as centre, axes and angle.
  std::vector<EdgePoint> points; //!< Along the ellipse, at most about one a pixel.
  double support = 0.;           //!< Share of the ellipse along which an edge was found, in [0, 1].
  double contrast = 0.;          //!< Median step from the dark band to the outside, grey levels.
};

/*! Whether two ellipses are one outline, to a tenth of their size and a pixel. */
bool isSameOutline(const EllipseParameters &p, const EllipseParameters &q);

/*!
  Finds the ellipses among the edge chains of an image. A closed chain is fitted as it is; the others are cut where they
  bend the wrong way or sharply, and the ellipse fitted to an arc is completed by searching its whole outline for edges.
  \param I : The image.
  \param gradient : Its gradient.
  \param chains : Its edge chains.
  \param candidates : The ellipses, largest first; no two of the same outline.
*/
void findEllipses(const vpImage<unsigned char> &I, const Gradient &gradient, const EdgeChains &chains,
                  std::vector<EllipseCandidate> &candidates);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
