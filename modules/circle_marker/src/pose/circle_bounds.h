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
 * Where in the image a marker is.
 */

#ifndef VP_CIRCLE_MARKER_CIRCLE_BOUNDS_H
#define VP_CIRCLE_MARKER_CIRCLE_BOUNDS_H

#include <Eigen/Core>

#include "pose/marker_plane.h"
#include "support/camera_model.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! An upright box in the image, pixels. */
struct ImageBounds
{
  Eigen::Vector2d least;
  Eigen::Vector2d most;
};

/*!
  The box around the centre of a marker and equally spaced points of a circle about it.
  \param plane : Pose of the marker.
  \param camera : The camera.
  \param radius : Of the circle, outer radii.
  \param points : Their number n: what lies between them may reach out by 1 - cos(pi / n) of the radius.
*/
ImageBounds boundsOfCircle(const MarkerPlane &plane, const CameraModel &camera, double radius, int points);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
