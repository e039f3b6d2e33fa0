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
  \file ellipse/joined_arcs.h
  \brief Outlines of which two arcs show, with something between them.
*/

#ifndef VP_CIRCLE_MARKER_JOINED_ARCS_H
#define VP_CIRCLE_MARKER_JOINED_ARCS_H

#include "ellipse/ellipse_search.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Joins the loose arcs of all workspaces by twos; what comes of it is among the known outlines at once.
  \param search : The search; nothing else may use its known outlines meanwhile.
  \param workspace : Memory to work in.
*/
void joinArcs(const EllipseSearch &search, EllipseMemory::Workspace &workspace);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
