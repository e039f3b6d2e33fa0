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
 * Measures a marker and reads its code again where it is.
 */

#ifndef VP_CIRCLE_MARKER_MEASURE_PROVEN_H
#define VP_CIRCLE_MARKER_MEASURE_PROVEN_H

#include <optional>

#include "decode/recognise.h"
#include "refine/measure.h"
#include "segment/image_noise.h"
#include "support/deadline.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Whether the sectors of a marker are so small that even a certain reading of them one by one wants a proof.
  \param outline : Its outline.
  \param family : Its family.
*/
bool wantsProof(const EllipseParameters &outline, const vpCircleMarkerFamily &family);

/*! Whether they are so small that blur and noise may keep them from being read for certain, though a proof may succeed.
 */
bool mayBeUncertain(const EllipseParameters &outline, const vpCircleMarkerFamily &family);

/*!
  Whether another code of the family is nearly as likely as the marker's own, because paper is brighter than the sensor
  can tell and hides sectors; false elsewhere, and of what was read beside a cover or through a blur, where that is
  counted already.
*/
bool mayBeOtherCode(const vpImage<unsigned char> &I, const CameraModel &camera, const Recognition &marker,
                    const Measurement &measurement, MeasureMemory &memory);

/*!
  Measures a marker whose sectors are small. Of all codewords the one that was read must explain the image best at the
  measured pose, by far; if another one does, that one is measured and must.
  \param I : The image.
  \param camera : Its camera.
  \param noise : Noise of the image.
  \param marker : The marker; its code may be another one afterwards.
  \param memory : Working memory.
  \param deadline : When to stop: nothing is proven then.
  \return Nothing if no codeword explains the image, or two of them do.
*/
std::optional<Measurement> measureProven(const vpImage<unsigned char> &I, const CameraModel &camera,
                                         const ImageNoise &noise, Recognition &marker, MeasureMemory &memory,
                                         const Deadline &deadline = Deadline());
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
