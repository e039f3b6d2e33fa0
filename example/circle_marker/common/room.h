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
 * A room with markers on its walls.
 */

#ifndef VP_COMMON_ROOM_H
#define VP_COMMON_ROOM_H

#include <array>
#include <string>
#include <vector>

#include <visp3/circle_marker/vpCircleMarkerDatabase.h>
#include <visp3/circle_marker_simulator/vpMarkerSceneSimulator.h>
#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpHomogeneousMatrix.h>

#include "visp_names.h"

namespace common {
/*!
  A room. In its frame, the world, x is to the right of someone who looks along z, y down; the origin lies in the middle
  of the wall behind him, at the height of his eyes. Metres.
*/
struct Room
{
  double halfWidth = 3.; //!< The side walls are at x = -halfWidth and halfWidth.
  double depth = 5.;     //!< The walls before and behind are at z = depth and 0.
  double floor = 1.2;    //!< The floor is at y = floor.
  double ceiling = -1.3; //!< And the ceiling at y = ceiling.
  vpCircleMarkerDatabase markers;
};

/*!
  A room of 6 m by 5 m with ten markers of 180 mm on its walls. Each carries a task for a robot: where to go next, to
  the place in front of another marker; the last one says to stop.
*/
Room makeRoom();

/*!
  A room as large as makeRoom() with the markers of a file.
  \exception vpException : If the file cannot be used, or no marker in it has a pose.
*/
Room readRoom(const std::string &file);

/*! \return All families of a room's markers, those that others contain first. */
std::vector<vpCircleMarkerFamily> familiesOf(const Room &room);

/*! \return Pose wMx of something that looks in a direction: 0 along z, pi/2 along x; radians. */
vpHomogeneousMatrix lookingAlong(double x, double y, double z, double direction);

/*! Adds the markers that are wholly in front of a camera at wMc to a scene. */
void addMarkers(const Room &room, const vpHomogeneousMatrix &wMc, vpMarkerSceneSimulator &scene);

/*! Ends of the room's edges, world frame. */
std::vector<std::array<std::array<double, 3>, 2>> edgesOf(const Room &room);
} // namespace common

#endif
