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
 * Sectors of a code track of which something covers a part.
 */

#ifndef VP_CIRCLE_MARKER_COVERED_READING_H
#define VP_CIRCLE_MARKER_COVERED_READING_H

#include <optional>

#include "decode/code_track.h"
#include "decode/seen_parts.h"
#include "pose/marker_plane.h"
#include "support/camera_model.h"

#include <visp3/circle_marker/vpCircleMarkerFamily.h>
#include <visp3/core/vpImage.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! A code track of which a part is seen, and what is seen of the marker. */
struct CoveredReading
{
  SectorReading sectors;
  SeenParts seen;
};

/*!
  Reads the code track of a marker at a hypothetical pose though something covers a part of the marker, or it reaches
  out of the image.

  In each direction from the centre the ring tells whether it is seen, by the ratio of its black to the white beside it:
  where most directions that show a ring agree on it, that is the ink. The light is a plane through the white of these
  directions; a piece of the track is seen where the white beside it is as bright as that, and only what is seen counts.
  \return Nothing if less than a third of the ring is seen.
*/
std::optional<CoveredReading> readCoveredSectors(const vpImage<unsigned char> &I, const CameraModel &camera,
                                                 const MarkerPlane &plane, const vpCircleMarkerFamily &family);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
