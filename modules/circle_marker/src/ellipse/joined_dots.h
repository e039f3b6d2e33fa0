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
 * Outlines put together from two dark dots.
 */

/*!
  \file ellipse/joined_dots.h
  \brief Rings so narrow that they have no edges along their sides, put together from the dark dots at their ends.
*/

#ifndef VP_CIRCLE_MARKER_JOINED_DOTS_H
#define VP_CIRCLE_MARKER_JOINED_DOTS_H

#include "ellipse/ellipse_search.h"
#include "support/workers.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! Puts the dark dots of an image together by twos, if thin rings are sought, at the full size alone. */
void joinDots(const EllipseSearch &search, Workers &workers);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
