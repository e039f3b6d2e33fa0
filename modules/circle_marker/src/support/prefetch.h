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
 * Asking for memory ahead of its use.
 */

/*!
  \file support/prefetch.h
  \brief Asking for memory ahead of its use.
*/

#ifndef VP_CIRCLE_MARKER_PREFETCH_H
#define VP_CIRCLE_MARKER_PREFETCH_H

#include <visp3/circle_marker/vpConfigCircleMarker.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! Asks for memory that will be needed soon. It may be anywhere, outside of the image too. */
inline void prefetch(const void *place)
{
#if defined(__GNUC__)
  __builtin_prefetch(place);
#else
  static_cast<void>(place);
#endif
}
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
