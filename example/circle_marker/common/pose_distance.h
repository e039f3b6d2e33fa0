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
 * Distance of a pose from the true one, by its covariance.
 */

#ifndef VP_COMMON_POSE_DISTANCE_H
#define VP_COMMON_POSE_DISTANCE_H

#include <visp3/circle_marker/vpCircleMarkerDetection.h>

#include "visp_names.h"

namespace common {
/*!
  Squared Mahalanobis distance of the truth from a detection's pose by its covariance; of the degrees of freedom that
  were measured: a marker without a code has no spin of its own.
  \param truth : The true pose cMo, z on the same side.
  \param detection : What was found.
*/
double squaredMahalanobis(const vpHomogeneousMatrix &truth, const vpCircleMarkerDetection &detection);
} // namespace common

#endif
