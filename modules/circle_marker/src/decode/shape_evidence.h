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
 * Whether the image shows a plain ring or disc all around.
 */

#ifndef VP_CIRCLE_MARKER_SHAPE_EVIDENCE_H
#define VP_CIRCLE_MARKER_SHAPE_EVIDENCE_H

#include "pose/marker_plane.h"
#include "support/camera_model.h"

#include <visp3/circle_marker/vpCircleMarkerFamily.h>
#include <visp3/core/vpImage.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Whether there is a dark ring within something brighter in nearly all directions: a first look, before a small outline
  is worth more.
  \param I, camera : The image and its camera.
  \param plane : The marker's pose.
*/
bool hasDarkRing(const vpImage<unsigned char> &I, const CameraModel &camera, const MarkerPlane &plane);

/*!
  Whether a ring or disc without a code looks like one in almost every direction from its centre: white outside, black
  on the ring, and inside as white as outside (or, for a disc, as black as its rim). Letters, eyes, wheels and fingers
  have an elliptic outline and a dark band in most directions; they have not in all, or no uniform inside.
  \param I : The image.
  \param camera : Its camera.
  \param plane : The marker's pose.
  \param layout : Of its family.
  \param ringInner : Its inner radius in units of the outer one, 0 for a disc.
*/
bool hasShapeAllAround(const vpImage<unsigned char> &I, const CameraModel &camera, const MarkerPlane &plane,
                       const vpCircleMarkerLayout &layout, double ringInner);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
