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
 * A marker of an outline, whole or with something in front of a part of it.
 */

#ifndef VP_CIRCLE_MARKER_DETECT_COVERED_H
#define VP_CIRCLE_MARKER_DETECT_COVERED_H

#include "decode/recognise.h"
#include "refine/measure.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Recognises a marker; if nothing is recognised, as one that something covers in part: with a part of its outline
  missing the poses are not good enough for its code, so its ring is measured before. \param I : The image. \param
  camera : Its camera. \param outline : The outline, as found. \param poses : Both poses of the outline. \param family :
  What to recognise it as. \param settings : How strictly a code is read. \param memory : Working memory of the
  measurement. \param trace : If not null, what was seen of the marker as a whole one. \return The marker, or why it is
  none: the reason that was found for it as a whole one.
*/
Judged<Recognition> recogniseWholeOrCovered(const vpImage<unsigned char> &I, const CameraModel &camera,
                                            const EllipseCandidate &outline, const PosePair &poses,
                                            const vpCircleMarkerFamily &family, const DecodeSettings &settings,
                                            MeasureMemory &memory, ReadingTrace *trace = nullptr);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
