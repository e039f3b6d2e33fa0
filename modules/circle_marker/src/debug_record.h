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
 * Notes what the rooms of the detector see, to be looked at.
 */

#ifndef VP_CIRCLE_MARKER_DEBUG_RECORD_H
#define VP_CIRCLE_MARKER_DEBUG_RECORD_H

#include <visp3/circle_marker/vpCircleMarkerDebug.h>

#include "decode/recognise.h"
#include "ellipse/outlines.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Adds what the rooms up to the outlines have seen, at all scales.
  \param memory : Their memory, after findOutlines().
  \param origin : Where their image begins in the whole one, pixels.
  \param debug : To this.
*/
void recordOutlines(const OutlineMemory &memory, const vpImagePoint &origin, vpCircleMarkerDebug &debug);

/*! An outline that was tried as a marker of a family. */
vpCircleMarkerCandidate candidateOf(const EllipseCandidate &outline, const vpCircleMarkerFamily &family,
                                    vpCircleMarkerReject reason);

/*! Adds what was read of its code. */
void addReading(const ReadingTrace &trace, const vpCircleMarkerFamily &family, const CameraModel &camera,
                vpCircleMarkerCandidate &candidate);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
