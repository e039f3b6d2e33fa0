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
 * What was found, drawn over the image.
 */

#ifndef VP_TUTORIAL_MARKER_OVERLAY_H
#define VP_TUTORIAL_MARKER_OVERLAY_H

#include <vector>

#include <visp3/circle_marker/vpCircleMarkerDetection.h>
#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpImage.h>
#include <visp3/core/vpRGBa.h>

#include "../visp_names.h"

namespace tutorial {
/*! What is drawn beside outline, frame, identity and distance. */
struct OverlayDetails
{
  bool secondPose = false;  //!< The frame of the second pose, and by how much the first is more likely.
  bool uncertainty = false; //!< Standard deviations.
};

/*! Standard deviations of a pose that a person can use. */
struct PoseDeviation
{
  double lateral = 0.; //!< Of the place across the line of sight, the greater of two directions, metres.
  double depth = 0.;   //!< Of the distance along the line of sight, metres.
  double normal = 0.;  //!< Of the marker's normal, the greater of two directions, radians.
};

/*!
  \return Standard deviations of the marker's place and normal. The covariance is of \f$(\upsilon, \omega)\f$ in the
  camera frame; the marker's origin t moves by \f$\upsilon + \omega \times t\f$, its normal n by \f$\omega \times n\f$.
*/
PoseDeviation poseDeviation(const vpCircleMarkerDetection &detection);

/*!
  \return The image with what was found: outline, axes, centre, identity, distance and the details asked for.
*/
vpImage<vpRGBa> markerOverlay(const vpImage<unsigned char> &I, const std::vector<vpCircleMarkerDetection> &detections,
                              const vpCameraParameters &cam, const OverlayDetails &details = OverlayDetails());
} // namespace tutorial

#endif
