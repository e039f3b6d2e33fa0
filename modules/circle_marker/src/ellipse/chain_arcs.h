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
  \file ellipse/chain_arcs.h
  \brief Pieces of outlines in edge chains.
*/

#ifndef VP_CIRCLE_MARKER_CHAIN_ARCS_H
#define VP_CIRCLE_MARKER_CHAIN_ARCS_H

#include "ellipse/ellipse_search.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  The outlines of the arcs of a chain that is left, and of the thin ring that it may be a part of.
  \param search : The search.
  \param index : The chain.
  \param workspace : Memory of this thread; has the proposals, and the arcs and ends that may belong to others.
*/
void proposeArcsOfChain(const EllipseSearch &search, std::size_t index, EllipseMemory::Workspace &workspace);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
