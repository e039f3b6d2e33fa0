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
 * Covariance of the pose of a marker that nearly faces the camera.
 */

/*!
  \file nearly_frontal.h
  \brief Covariance of the pose of a marker that nearly faces the camera.

  A circle whose normal leans by the angle l from the line of sight, in the direction of the vector l, looks narrower
  along l by |l|^2 / 2: the image depends on the square of the lean. Taken as complex numbers, z for where the marker
  may lean and m for the maximum of the likelihood, the image tells z^2 and no more, besides what perspective does,
  which is linear in z. With \f$ \alpha^2 |m|^2 \f$ the information on the lean that the narrowing gives and B the
  matrix of what does not depend on the lean,

  \f[ -2 \log L = \frac{\alpha^2}{4} |z^2 - m^2|^2 + (z - m)^T B \, (z - m) . \f]

  Far from m = 0 that is the ellipse of the normal equations' covariance. Near it the likelihood has two maxima, m and
  -m, and little between them; and at m = 0 the normal equations say that nothing is known of the lean, which is not so
  either. The second moments of this likelihood about its maximum are what the error is, there as elsewhere; with every
  angle of lean |z| as likely before, for some markers are made to face the camera.
*/

#ifndef VP_CIRCLE_MARKER_NEARLY_FRONTAL_H
#define VP_CIRCLE_MARKER_NEARLY_FRONTAL_H

#include <Eigen/Core>

#include "refine/fitted_pose.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! The marker's lean: its normal's deviation from the line of sight, along the marker's x and y, rad. */
Eigen::Vector2d leanOf(const MarkerPlane &plane);

/*! The same marker, leaning otherwise, at a distance at which it looks as large. */
MarkerPlane leaningBy(const MarkerPlane &plane, const Eigen::Vector2d &lean);

/*!
  Whether the pose may be off by so much that the information on its lean is not the same there.
  \param fit : With the covariance of its normal equations.
*/
bool isNearlyFrontal(const FittedPose &fit);

/*!
  \brief Covariance of (t, w) in the camera frame, about the marker's centre, metres and radians: second moments of the
  likelihood about its maximum.
  \param fit : With the covariance of its normal equations, and FittedPose::leanInformation.
  \param hasTwin : Whether the other pose, which leans to the other side, is reported as well: this one is then that of
  its own side.
*/
Eigen::Matrix<double, 6, 6> nearlyFrontalCovariance(const FittedPose &fit, bool hasTwin);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
