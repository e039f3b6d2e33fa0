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
 * Where the edges of a marker's sheet are in an image.
 */

#ifndef VP_CIRCLE_MARKER_TEST_SHEET_TOOLS_H
#define VP_CIRCLE_MARKER_TEST_SHEET_TOOLS_H

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "edges/edge_points.h"
#include "testRoomTools.h"

namespace room_test {
//! Image of a point of the marker's plane, in units of the radius.
inline Eigen::Vector2d project(const MarkerScene &scene, const Eigen::Vector2d &onPlane)
{
  const Eigen::Vector3d p = scene.center + scene.radius * (scene.rotation.leftCols<2>() * onPlane);
  return scene.focal * p.head<2>() / p.z() + scene.principal;
}

/*!
  A golay23 marker on its sheet, in the middle of a square image.
  \param random : What it is drawn by.
  \param side : Of the image, pixels.
  \param minor, tilt : Least and greatest minor axis, pixels, and angle of view, radians.
  \param ground : Grey level around the sheet.
*/
inline MarkerScene sheetScene(Random &random, unsigned int side, const Eigen::Vector2d &minor,
                              const Eigen::Vector2d &tilt, double ground)
{
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  const double angle = uniform(random, tilt[0], tilt[1]);
  MarkerScene scene = markerScene(random, family, static_cast<int>(random() % family.getNbIds()),
                                  uniform(random, minor[0], minor[1]) / std::cos(angle), angle, side);
  scene.surround = ground;
  return scene;
}

//! The edge of the sheet.
inline std::vector<circle_marker::EdgePoint> sheetOf(const MarkerScene &scene)
{
  std::vector<circle_marker::EdgePoint> points;
  for (int i = 0; i < 60; ++i) {
    const double along = scene.sheet * ((i % 15) / 7.5 - 1.);
    const std::array<Eigen::Vector2d, 4> sides = {
        Eigen::Vector2d(along, -scene.sheet), Eigen::Vector2d(scene.sheet, along), Eigen::Vector2d(-along, scene.sheet),
        Eigen::Vector2d(-scene.sheet, -along)};
    points.push_back({project(scene, sides[static_cast<std::size_t>(i / 15)]), Eigen::Vector2d::Zero()});
  }
  return points;
}

//! The pixels of an edge.
inline std::vector<circle_marker::EdgePixel> pixelsOf(const std::vector<circle_marker::EdgePoint> &edge)
{
  std::vector<circle_marker::EdgePixel> pixels;
  for (const circle_marker::EdgePoint &point : edge) {
    pixels.push_back(
        {static_cast<short>(std::lround(point.position.x())), static_cast<short>(std::lround(point.position.y()))});
  }
  return pixels;
}
} // namespace room_test

#endif
