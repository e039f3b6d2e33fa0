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
 * What the tests of code tracks whose ring is measured share.
 */

#ifndef VP_TEST_TRACK_TOOLS_H
#define VP_TEST_TRACK_TOOLS_H

#include "testRoomTools.h"

#include "decode/measured_ring.h"

namespace track_test {
using namespace circle_marker;
using namespace room_test;

constexpr double lens = 0.7; // blur, pixels

inline int randomId(Random &random, const vpCircleMarkerFamily &family)
{
  return static_cast<int>(random() % family.getNbIds());
}

//! The ring of a scene as if it were measured exactly.
inline MeasuredRing measuredRing(const MarkerScene &scene)
{
  MeasuredRing ring;
  ring.plane = scene.plane();
  ring.photometry.white = scene.white;
  ring.photometry.absorption = 1. - scene.black / scene.white;
  ring.photometry.blur.sigma = std::sqrt(lens * lens + 1. / 12.); // with that of the pixel
  ring.noise = 1.;
  return ring;
}

//! A grey level in the directions from 0 to a number of sectors, all of the way from the centre.
inline vpImage<unsigned char> covered(const MarkerScene &scene, unsigned int sectors, double grey)
{
  const double end = 2. * M_PI * sectors / scene.family.getNbSectors();
  const auto picture = [&](double u, double v) {
    const Eigen::Vector2d q = scene.onMarker(u, v);
    const double angle = std::atan2(q.y(), q.x());
    const bool isCovered = (angle < 0. ? angle + 2. * M_PI : angle) < end;
    return isCovered ? grey : scene(u, v);
  };
  return photograph(150, 150, lens, picture);
}

//! A marker of a family, of 70 to 110 pixels.
inline MarkerScene scene(Random &random, const vpCircleMarkerFamily &family)
{
  return markerScene(random, family, randomId(random, family), uniform(random, 70., 110.), uniform(random, 0., 0.8),
                     150);
}
} // namespace track_test

#endif
