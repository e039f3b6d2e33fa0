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
 * What the tests of measured markers share.
 */

#ifndef TEST_MEASURE_TOOLS_H
#define TEST_MEASURE_TOOLS_H

#include "testRoomTools.h"

#include "refine/measure.h"

namespace room_test {
//! A marker recognised at its true pose, or at the other one of its circle first.
inline circle_marker::Recognition recognised(const MarkerScene &scene, int id, bool twinFirst)
{
  circle_marker::Recognition marker;
  marker.family = scene.family;
  marker.code.id = id;
  const circle_marker::MarkerPlane truth = scene.plane();
  marker.poses = {twinFirst ? twinOf(truth) : truth, twinFirst ? truth : twinOf(truth)};
  return marker;
}
} // namespace room_test

#endif
