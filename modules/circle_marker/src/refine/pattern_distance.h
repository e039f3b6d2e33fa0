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
 * Distance of a pixel to the edges of a print.
 */

#ifndef VP_CIRCLE_MARKER_PATTERN_DISTANCE_H
#define VP_CIRCLE_MARKER_PATTERN_DISTANCE_H

#include "refine/fit_pixels.h"

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

/*! Where a pixel lies on the pattern. */
struct PatternDistance
{
  double toEdges = 0.;        //!< Distance to the nearest edge, pixels, to first order.
  double radius = 0.;         //!< Distance to the marker's centre, in units of the outer radius.
  double radiusPerPixel = 0.; //!< Length of its gradient in the image.
};

/*! Where a pixel lies on the pattern at a pose. */
PatternDistance distanceToPattern(const ModelPixel &pixel, const MarkerPlane &plane, const MarkerPattern &pattern);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
