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
 * The poses a marker may have, from the ellipse of its outer edge.
 */

#ifndef VP_CIRCLE_MARKER_HYPOTHESES_H
#define VP_CIRCLE_MARKER_HYPOTHESES_H

#include <array>
#include <optional>
#include <vector>

#include "edges/edge_points.h"
#include "pose/marker_plane.h"
#include "support/camera_model.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! The two poses of a circle with one image; their spin is that of poseFromCirclePosition(). */
using PosePair = std::array<MarkerPlane, 2>;

/*! Poses of a circle of another diameter with the same image, which fixes them up to the size: everything scales. */
void scaleTo(double size, PosePair &poses);

/*! The z-aligned frame of a circle. */
MarkerPlane planeOf(const CirclePosition &position, double radius);

/*!
  Both poses of the circle whose outline was found at \e points (pixels): each point is moved to the normalised image
  plane, where lenses are straight, and the ellipse is fitted there.
*/
std::optional<PosePair> posesFromOutline(const std::vector<EdgePoint> &points, const CameraModel &camera,
                                         double radius);

/*! The same with working memory for the points in the normalised image plane. */
std::optional<PosePair> posesFromOutline(const std::vector<EdgePoint> &points, const CameraModel &camera, double radius,
                                         std::vector<Eigen::Vector2d> &meters);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
