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
 * Error of a pose in the terms of its covariance.
 */

#ifndef VP_ACCURACY_POSE_CHECK_H
#define VP_ACCURACY_POSE_CHECK_H

#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/core/vpMatrix.h>

#include "common/visp_names.h"

namespace accuracy {
/*! What a covariance says of a pose, and whether the error agrees. */
struct PoseCheck
{
  double x, y, z;     //!< Reported standard deviations of the centre, camera frame, metres.
  double normal;      //!< Reported root mean square angle of the normal, radians.
  double mahalanobis; //!< Squared error by the covariance; its mean should be the number of degrees of freedom.
};

/*!
  \param measured, truth : Poses, z into the marker, metres.
  \param covariance : Of delta = (upsilon, omega) with truth = exp(delta) measured, camera frame.
  \param dof : 5: the spin about the normal is left out of it.
*/
PoseCheck check(const vpHomogeneousMatrix &measured, const vpHomogeneousMatrix &truth, const vpMatrix &covariance,
                unsigned int dof);
} // namespace accuracy

#endif
