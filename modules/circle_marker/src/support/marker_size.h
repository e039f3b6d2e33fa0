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
 * Sizes that a marker can have.
 */

#ifndef VP_CIRCLE_MARKER_MARKER_SIZE_H
#define VP_CIRCLE_MARKER_MARKER_SIZE_H

#include <cmath>

#include <visp3/circle_marker/vpConfigCircleMarker.h>
#include <visp3/core/vpException.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! Throws vpException::badValue unless a marker's size, metres, is positive and finite. */
inline void checkMarkerSize(double size)
{
  if (!(size > 0.) || !std::isfinite(size)) {
    throw vpException(vpException::badValue,
                      "vpDetectorCircleMarker: the marker size is %g; it is the outer diameter of the ring in metres "
                      "and must be positive",
                      size);
  }
}
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
