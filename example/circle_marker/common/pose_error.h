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
 * Errors of a pose against the truth.
 */

#ifndef VP_COMMON_POSE_ERROR_H
#define VP_COMMON_POSE_ERROR_H

#include <visp3/core/vpHomogeneousMatrix.h>

#include "visp_names.h"

namespace common {
/*! Errors of a pose; the marker's normal is its z axis, its centre the origin of its frame. */
struct PoseError
{
  double x, y, z;     //!< Measured minus true centre, camera frame, metres.
  double position;    //!< Length of (x, y, z), metres.
  double normal;      //!< Angle between the measured and the true normal, radians.
  double rotation;    //!< Angle of the rotation between the measured and the true pose, radians.
  bool wrongSolution; //!< The measured normal is nearer to the true one reflected about the line of sight.
};

PoseError errorOf(const vpHomogeneousMatrix &measured, const vpHomogeneousMatrix &truth);

/*! Distance of the marker's centre from the camera, metres. */
double distanceOf(const vpHomogeneousMatrix &cMo);

/*! Angle between the marker's normal and the line of sight to its centre, radians. */
double tiltOf(const vpHomogeneousMatrix &cMo);
} // namespace common

#endif
