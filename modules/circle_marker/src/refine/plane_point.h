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
 * Where a pixel lies on a marker.
 */

#ifndef VP_CIRCLE_MARKER_PLANE_POINT_H
#define VP_CIRCLE_MARKER_PLANE_POINT_H

#include "refine/fit_pixel.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! A pixel on the marker's plane. */
struct PlanePoint
{
  Eigen::Vector2d q;       //!< In units of the outer radius.
  Eigen::Matrix2d byPixel; //!< Derivative of q by the pixel.
};

/*! Where the ray through a pixel meets the marker's plane. */
PlanePoint planePoint(const ModelPixel &pixel, const MarkerPlane &plane);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
