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
 * What a doubtful calibration of the camera adds to the covariance of a pose.
 */

#ifndef VP_CIRCLE_MARKER_CAMERA_DOUBT_H
#define VP_CIRCLE_MARKER_CAMERA_DOUBT_H

#include <Eigen/Core>

#include <visp3/circle_marker/vpCircleMarkerFamily.h>

#include "refine/fitted_pose.h"
#include "support/camera_model.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  How the pose that fits a marker's edges moves when the camera's parameters are changed and the image stays.

  Each edge point lies at its pixel; a change of the parameters k moves its normalised coordinates m by dm/dk. The pose
  follows so that the edges, of which only the way across is seen, stay where they are: least squares of
  n^T (dm/d(t, w) delta - dm/dk) over points of the ring's edges and, if there is a code, of the borders of its sectors.
  \param plane : The pose.
  \param family : The marker's family.
  \param camera : The camera.
  \return 6 x 4 derivatives of (t, w) as in FittedPose by (px, py, u0, v0), pixels; the spin of a marker without a code
  stays.
*/
Eigen::Matrix<double, 6, 4> poseByCamera(const MarkerPlane &plane, const vpCircleMarkerFamily &family,
                                         const CameraModel &camera);

/*!
  Adds to a pose's covariance what the camera's has done to it: to first order, but for the lean of a marker that nearly
  faces the camera, whose square it is that px / py moves.
  \param covariance : 4 x 4 covariance of (px, py, u0, v0), pixels^2; 0: the camera is known.
  \param family : The marker's family.
  \param camera : The camera.
  \param fit : The pose.
*/
void addCameraDoubt(const Eigen::Matrix4d &covariance, const vpCircleMarkerFamily &family, const CameraModel &camera,
                    FittedPose &fit);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
