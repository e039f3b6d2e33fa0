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
 * What is seen of a plain ring that something covers in part.
 */

#ifndef VP_CIRCLE_MARKER_COVERED_SHAPE_H
#define VP_CIRCLE_MARKER_COVERED_SHAPE_H

#include <optional>

#include "decode/seen_parts.h"
#include "pose/marker_plane.h"
#include "support/camera_model.h"

#include <visp3/circle_marker/vpCircleMarkerFamily.h>
#include <visp3/core/vpImage.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  What is seen of a plain ring though something covers a part of it, or it reaches out of the image.

  In each direction from the centre the ring is seen if it is as dark beside the white on both of its sides as in most
  other directions.
  \param I : The image.
  \param camera : Its camera.
  \param plane : The marker's pose.
  \param layout : Of its family.
  \return Nothing if less than half of the ring is seen, or black and white alternate inside of it as sectors do.
*/
std::optional<SeenParts> seenPartsOfRing(const vpImage<unsigned char> &I, const CameraModel &camera,
                                         const MarkerPlane &plane, const vpCircleMarkerLayout &layout);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
