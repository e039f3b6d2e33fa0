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
 * Ground truth of a marker from its exact projection.
 */

#ifndef VP_SIMULATOR_TRUTH_H
#define VP_SIMULATOR_TRUTH_H

#include <vector>

#include <visp3/circle_marker_simulator/vpMarkerTruth.h>
#include <visp3/circle_marker_simulator/vpSimulatedMarker.h>

#include "lens.h"
#include "outline.h"
#include "paper.h"

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

//! Image of a circle of the given radius, in metres, around the marker's origin (see vpEllipseTruth).
vpEllipseTruth ellipseOf(double radius, const Paper &paper, const Lens &lens);

//! Truth of a marker of which the regions `covers` hide parts, in an image whose pixels fill `frame`.
vpMarkerTruth truthOf(const vpSimulatedMarker &marker, const Lens &lens, const std::vector<Outline> &covers,
                      const Box &frame);

} // namespace marker_simulator
END_VISP_NAMESPACE

#endif
