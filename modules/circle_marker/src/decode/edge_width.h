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
 * Whether an outline may be a marker seen through a strong blur.
 */

#ifndef VP_CIRCLE_MARKER_EDGE_WIDTH_H
#define VP_CIRCLE_MARKER_EDGE_WIDTH_H

#include "ellipse/conic.h"

#include <visp3/core/vpImage.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Width of an outline's edge, pixels: step across it by its steepest slope, that of the second widest of eight pairs of
  opposite directions, as a motion widens some directions only. A sharp edge is seen two samples wide, that is two
  pixels on outlines of up to 20 pixels radius and a tenth of the radius beyond.
  \param I : The image.
  \param outline : Of a dark ring.
  \param paper : Grey level of the paper, where it is known: a ground beyond the quiet zone that is brighter is none of
  the edge.
  \return Zero if most of the outline is not seen.
*/
double edgeWidth(const vpImage<unsigned char> &I, const EllipseParameters &outline, double paper = 255.);

/*!
  Whether an outline may be a marker seen through a strong blur, one that sectors cannot be read through one by one: its
  edge is wide, its centre is as white as the paper around, its ring is dark and the same in opposite directions and, if
  it has a code, its track has something of both.
  \param I : The image.
  \param outline : Of a dark ring.
  \param isCoded : Whether the ring has a code within.
  \param quietZone : Width of the white around the ring, in outer radii.
*/
bool looksBlurred(const vpImage<unsigned char> &I, const EllipseParameters &outline, bool isCoded, double quietZone);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
