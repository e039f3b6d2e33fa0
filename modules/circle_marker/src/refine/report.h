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
 * From the refined planes of a marker to the detection a user sees.
 */

#ifndef VP_CIRCLE_MARKER_REPORT_H
#define VP_CIRCLE_MARKER_REPORT_H

#include "refine/measure.h"

#include <visp3/circle_marker/vpCircleMarkerDetection.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Puts a measurement into the user's conventions: frames, covariance in the camera frame, image of the marker.
  \param marker, measurement : What was recognised and measured.
  \param camera : The camera.
  \param visible : Share of the outer edge that was seen.
  \param zAligned : Whether the marker's z axis points away from the camera.
  \param detection : The result; its memory is used again.
*/
void putReport(const Recognition &marker, const Measurement &measurement, const CameraModel &camera, double visible,
               bool zAligned, vpCircleMarkerDetection &detection);

/*!
  Points along the image of the ring's outer edge, pixels: point i is at the angle 2 pi i / count from the x axis of the
  reported marker frame toward the y axis of the one whose z axis points into the marker.
  \param marker, plane, camera : The marker, its pose and the camera.
  \param count : Number of points.
  \param outline : The result; its memory is used again.
*/
void putOutline(const Recognition &marker, const MarkerPlane &plane, const CameraModel &camera, unsigned int count,
                std::vector<vpImagePoint> &outline);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
