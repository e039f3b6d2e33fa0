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
  \file ellipse/joined_caps.h
  \brief Outlines so narrow that they bend sharply at their tips, put together from these.
*/

#ifndef VP_CIRCLE_MARKER_JOINED_CAPS_H
#define VP_CIRCLE_MARKER_JOINED_CAPS_H

#include <cstddef>

#include "ellipse/ellipse_search.h"
#include "support/workers.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Gathers the ends of narrow things of all workspaces, in an order that does not depend on the threads.
  \return Number of tasks of findCapPairs(); none if there are so many ends that they are of a texture.
*/
std::size_t gatherCaps(const EllipseSearch &search);

/*! Notes in a workspace which of the gathered ends may be two of one thing: a task's share of them. */
void findCapPairs(const EllipseSearch &search, std::size_t task, EllipseMemory::Workspace &workspace);

/*! Puts the ends of all these pairs together; what comes of it is among the known outlines then. */
void joinCaps(const EllipseSearch &search, Workers &workers);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
