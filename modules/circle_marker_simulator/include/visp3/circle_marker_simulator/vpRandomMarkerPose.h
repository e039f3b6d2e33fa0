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
 * Random poses of a marker, as drawn for the experiments.
 */

/*!
  \file vpRandomMarkerPose.h
  \brief Random poses of a marker, as drawn for the experiments.
*/

#ifndef VP_RANDOM_MARKER_POSE_H
#define VP_RANDOM_MARKER_POSE_H

#include <cstdint>

#include <visp3/core/vpHomogeneousMatrix.h>

#include <visp3/circle_marker_simulator/vpConfigCircleMarkerSimulator.h>
#include <visp3/circle_marker_simulator/vpMarkerSceneSimulator.h>

BEGIN_VISP_NAMESPACE

/*!
  \struct vpRandomPoseRange
  \ingroup group_circle_marker_simulator
  \brief Range from which poses are drawn.
*/
struct vpRandomPoseRange
{
  double minDepth = 0.36;  //!< Least depth z of the marker's centre, in metres.
  double maxDepth = 10.36; //!< Greatest depth z of the marker's centre, in metres.
  double maxTilt = 0.5236; //!< Greatest angle between normal and line of sight, in radians (30 degrees).
  double margin = 2.;      //!< Least distance of the marker from the image's border, in pixels.
};

VISP_EXPORT vpHomogeneousMatrix vpRandomMarkerPose(const vpSimulatedMarker &marker, const vpCameraParameters &cam,
                                                   unsigned int width, unsigned int height,
                                                   const vpRandomPoseRange &range, std::uint64_t seed);

END_VISP_NAMESPACE

#endif
