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
 * Grey levels that a sensor of 8 bits can tell.
 */

#ifndef VP_CIRCLE_MARKER_SENSOR_RANGE_H
#define VP_CIRCLE_MARKER_SENSOR_RANGE_H

#include <visp3/circle_marker/vpConfigCircleMarker.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! Grey levels from these on may have been cut off: noise takes one off what is. */
constexpr double darkestTold = 1.;
constexpr double brightestTold = 254.;

/*! Whether paper may have been brighter than this grey level tells. */
inline bool mayBeTooBright(double grey)
{
  return grey >= brightestTold;
}

/*! Whether ink may have been darker than it tells. */
inline bool mayBeTooDark(double grey)
{
  return grey <= darkestTold;
}

/*! Standard deviation of the rounding to whole grey levels: 1 / sqrt(12). */
constexpr double quantisation = 0.28867513459481287;
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
