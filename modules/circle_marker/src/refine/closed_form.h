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
 * How well the pose of an outline is known that is not refined.
 */

/*!
  \file closed_form.h
  \brief How well the pose of an outline is known that is not refined.
*/

#ifndef VP_CIRCLE_MARKER_CLOSED_FORM_H
#define VP_CIRCLE_MARKER_CLOSED_FORM_H

#include <vector>

#include <Eigen/Core>

#include <visp3/circle_marker/vpCircleMarkerFamily.h>
#include <visp3/core/vpImage.h>

#include "ellipse/ellipse_candidate.h"
#include "pose/marker_plane.h"
#include "support/camera_model.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Covariance of a pose in closed form, from the points of the outline that it was made of. Their noise is what the
  ellipse leaves of them; neighbours share it. What blur, ring, surround and covers do to many of them alike shows in
  little that is left: it is taken from experience. So is the spin's error, of the sectors as they were read.
  \param I : The image.
  \param outline : The outline.
  \param plane : The pose.
  \param family : The marker's family.
  \param camera : The camera.
  \param meters : Working memory for the points in the normalised image plane.
  \return Of (t, w) as FittedPose::covariance; without a code the spin's part is zero.
*/
Eigen::Matrix<double, 6, 6> closedFormCovariance(const vpImage<unsigned char> &I, const EllipseCandidate &outline,
                                                 const MarkerPlane &plane, const vpCircleMarkerFamily &family,
                                                 const CameraModel &camera, std::vector<Eigen::Vector2d> &meters);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
