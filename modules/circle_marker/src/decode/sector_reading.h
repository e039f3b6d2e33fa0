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
 * Grey levels of the sectors of a marker's code track.
 */

#ifndef VP_CIRCLE_MARKER_SECTOR_READING_H
#define VP_CIRCLE_MARKER_SECTOR_READING_H

#include "decode/code_track.h"
#include "pose/marker_plane.h"
#include "support/camera_model.h"
#include "support/judged.h"

#include <visp3/circle_marker/vpCircleMarkerFamily.h>
#include <visp3/core/vpImage.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Reads the code track of a marker at a hypothetical pose (its spin does not matter).

  The track is sampled along angles; the grey levels of the sectors are the least-squares solution of their mixture
  under the image blur, once for each of several phases of the sectors' grid, and the phase that leaves the least
  residual is kept.
  \return The sectors, or OUT_OF_IMAGE, NO_RING (no contrast, or no white centre), NO_SECTORS (all of them alike).
*/
Judged<SectorReading> readSectors(const vpImage<unsigned char> &I, const CameraModel &camera, const MarkerPlane &plane,
                                  const vpCircleMarkerFamily &family);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
