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
 * Poses of a marker that was read through a strong blur.
 */

#ifndef VP_CIRCLE_MARKER_BLURRED_MEASUREMENT_H
#define VP_CIRCLE_MARKER_BLURRED_MEASUREMENT_H

#include "refine/measure.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  The measurement of a marker: measure()'s, if its model explains the image as well as the reading did; else, where the
  marker was read through a blur that this model does not have, the poses of the reading.
  \param marker : The marker.
  \param measured : What measure() has found, or nothing.
*/
std::optional<Measurement> bestMeasurement(const Recognition &marker, std::optional<Measurement> measured);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
