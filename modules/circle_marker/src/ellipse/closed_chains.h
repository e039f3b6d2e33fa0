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
  \file ellipse/closed_chains.h
  \brief Edge chains that are whole outlines.
*/

#ifndef VP_CIRCLE_MARKER_CLOSED_CHAINS_H
#define VP_CIRCLE_MARKER_CLOSED_CHAINS_H

#include "ellipse/ellipse_search.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  A closed chain as one outline; open ones, and closed ones that are none or not well found, are left to be cut into
  arcs.
  \param search : The search; its mark of the chain is set.
  \param index : The chain.
  \param workspace : Memory of this thread; has the proposal.
*/
void proposeClosedChain(const EllipseSearch &search, std::size_t index, EllipseMemory::Workspace &workspace);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
