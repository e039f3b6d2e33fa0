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
 * Edges of a print where the edge of a shadow falls on them.
 */

/*!
  \file shaded_edges.h
  \brief Edges of a print where the edge of a shadow falls on them.

  The light falls on the paper before the lens blurs both: a pixel sees the blurred product of light s and print, not
  the product of what each is when it is blurred. With a Gaussian blur of covariance C these differ by (Mehler's
  formula) \f[ \overline{s d} - \bar s \bar d = \sum_{k \ge 1} \frac{1}{k!} (C : \nabla \otimes \nabla)^k \bar s \bar d,
  \f] each pair of derivatives one of s and one of the share of black d. The light changes across the shadow's edge
  only, so that \f$ C \nabla \f$ is a derivative along one direction of the image, which two shifts of the pixels tell.
*/

#ifndef VP_CIRCLE_MARKER_SHADED_EDGES_H
#define VP_CIRCLE_MARKER_SHADED_EDGES_H

#include "refine/image_model.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
/*!
  Adds to PixelBlock::correction what the product of light and print lacks. Nothing without a shadow, or if the size of
  its frame is not known.
  \param plane : The pose.
  \param pattern : The print.
  \param photometry : Light and blur.
  \param blocks : The pixels, corrected otherwise.
  \return Whether any pixel is corrected.
*/
bool correctShadedEdges(const MarkerPlane &plane, const MarkerPattern &pattern, const Photometry &photometry,
                        PixelBlocks &blocks);
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
