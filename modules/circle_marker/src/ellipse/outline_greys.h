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
 * Grey levels inside and beside an outline.
 */

#ifndef VP_CIRCLE_MARKER_OUTLINE_GREYS_H
#define VP_CIRCLE_MARKER_OUTLINE_GREYS_H

#include "ellipse/ellipse_candidate.h"

#include <visp3/core/vpImage.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! Step between the brightest pixel outside and the darkest inside of an outline, median over it, grey levels. */
double medianContrast(const vpImage<unsigned char> &I, const EllipseCandidate &candidate);

/*! Grey levels beside an edge, means over its length. */
struct GreysBeside
{
  double dark = 0.;
  double bright = 0.;
};

/*! The grey levels on either side of a run of edge points, a pixel and a half from it; zeros outside of the image. */
GreysBeside greysBeside(const vpImage<unsigned char> &I, const EdgePoint *points, std::size_t count);

/*! Whether the centre of an outline is like that of the markers sought, judged by the grey levels beside its edge. */
bool hasSoughtCenter(const vpImage<unsigned char> &I, const EdgePoint *points, std::size_t count,
                     const Eigen::Vector2d &center, const SoughtCenters &sought);

/*!
  Whether a closed outline is as dark at its centre, and halfway to it in four directions, as along its edge: a blob, or
  a sector of a code; no fit is needed to know that it is no ring.
*/
bool isDarkThroughout(const vpImage<unsigned char> &I, const EdgePoint *points, std::size_t count);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
