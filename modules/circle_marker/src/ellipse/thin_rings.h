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
 */

/*!
  \file ellipse/thin_rings.h
  \brief Rings that are too thin to have an outer edge.
*/

#ifndef VP_CIRCLE_MARKER_THIN_RINGS_H
#define VP_CIRCLE_MARKER_THIN_RINGS_H

#include "ellipse/ellipse_search.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! Longer chains, in pixels, are neither the inside of a thin ring nor the edge of its sheet: that of a ring of 75
 * pixels, 7 wide, is not. */
constexpr std::size_t longestNarrowSheet = 260;

/*!
  The closed edge of something bright may be the inside of a ring whose outer edge does not show, and any closed edge
  that of its sheet.
  \param search : The search.
  \param index : The chain.
  \param workspace : Memory of this thread; has the proposal.
  \return Whether it is one of these, or leads to an outline that is known.
*/
bool proposeThinRing(const EllipseSearch &search, std::size_t index, EllipseMemory::Workspace &workspace);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
