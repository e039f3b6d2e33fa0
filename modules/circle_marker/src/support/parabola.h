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
 * Where a row of values is least.
 */

#ifndef VP_CIRCLE_MARKER_PARABOLA_H
#define VP_CIRCLE_MARKER_PARABOLA_H

#include <visp3/circle_marker/vpConfigCircleMarker.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Vertex of the parabola through three equally spaced values of which the middle one is the least.
  \return Where it lies from the middle one, in steps: from -0.5 to 0.5; 0 if all three are the same.
*/
inline double vertexOfParabola(double before, double middle, double after)
{
  const double curvature = before - 2. * middle + after;
  return curvature > 0. ? 0.5 * (before - after) / curvature : 0.;
}
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
