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
 * Whether two families of markers are the same.
 */

#ifndef VP_CIRCLE_MARKER_SAME_FAMILY_H
#define VP_CIRCLE_MARKER_SAME_FAMILY_H

#include <tuple>

#include <visp3/circle_marker/vpCircleMarkerFamily.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! Whether two prints have the same radii. */
inline bool isSameLayout(const vpCircleMarkerLayout &one, const vpCircleMarkerLayout &other)
{
  return std::tie(one.ringInner, one.codeOuter, one.codeInner, one.quietZone) ==
         std::tie(other.ringInner, other.codeOuter, other.codeInner, other.quietZone);
}

/*! Whether two families have the same code and print; their names may be the same though their prints are not. */
inline bool isSameFamily(const vpCircleMarkerFamily &one, const vpCircleMarkerFamily &other)
{
  return one.getType() == other.getType() && isSameLayout(one.getLayout(), other.getLayout());
}
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
