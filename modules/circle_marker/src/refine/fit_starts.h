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
 * Where the fits of a marker start from.
 */

#ifndef VP_CIRCLE_MARKER_FIT_STARTS_H
#define VP_CIRCLE_MARKER_FIT_STARTS_H

#include "pose/hypotheses.h"
#include "refine/fitted_pose.h"
#include "support/camera_model.h"
#include "support/few.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Where to start from: the two poses of the outline; or, if it is too round to show its tilt and fits may move, four
  directions of tilt. Facing the camera is a saddle of the likelihood, from which no descent leads away.
  \param poses : Of the outline.
  \param camera : That sees it.
  \param spinIsKnown : Whether a code has fixed the spin: else all starts have that of the first.
  \param mayMove : Whether fits leave their starts: else these are the poses to choose from.
*/
Few<FitStart> startsOf(const PosePair &poses, const CameraModel &camera, bool spinIsKnown, bool mayMove);

/*! The pose that looks nearly the same: its normal on the other side of the line of sight. */
MarkerPlane mirrored(const MarkerPlane &plane);

/*! Size of a pixel at the marker's centre, normalised coordinates: the side of a square of its area. */
double meterPerPixelAt(const MarkerPlane &plane, const CameraModel &camera);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
