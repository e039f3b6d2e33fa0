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
 * Something opaque in front of a part of a marker.
 */

#ifndef VP_EXPERIMENTS_COVER_H
#define VP_EXPERIMENTS_COVER_H

#include <visp3/circle_marker_simulator/vpMarkerSceneSimulator.h>

#include "experiment.h"

namespace experiments {
/*!
  Distance from a unit circle's centre of the line that cuts off a share of its disc.
  \param share : 0 to 1; 0.5 gives 0, less a positive distance.
*/
double chordDistance(double share);

/*!
  The occluder that covers a share of a disc around the marker's centre, and all of the sheet beyond.
  \e radius: Of the disc, metres.
*/
vpSceneOccluder occluderOf(const Cover &cover, const vpMarkerSceneSimulator &camera, const vpHomogeneousMatrix &cMo,
                           double radius);
} // namespace experiments

#endif
