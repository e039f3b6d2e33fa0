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
 * Unit tests of the places of the markers of an image.
 */

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "decode/marker_places.h"
#include "testRoomTools.h"

using namespace circle_marker;
using namespace room_test;

namespace {
// Focal length 1000 pixels: a circle of 0.1 at 1 m that faces the camera has a radius of 100 pixels.
constexpr double focal = 1000.;
constexpr double u0 = 400.;
constexpr double v0 = 300.;

CameraModel camera()
{
  return CameraModel(vpCameraParameters(focal, focal, u0, v0));
}

// Tilted about x, with its normal away from the camera.
MarkerPlane planeAt(double tilt)
{
  MarkerPlane plane;
  plane.center = Eigen::Vector3d(0., 0., 1.);
  plane.rotation = Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitX()).toRotationMatrix();
  plane.radius = 0.1;
  return plane;
}

Recognition markerOf(const vpCircleMarkerFamily &family, const MarkerPlane &plane)
{
  Recognition marker;
  marker.family = family;
  marker.poses = {plane, plane};
  return marker;
}

EllipseCandidate outlineOf(const EllipseParameters &ellipse)
{
  EllipseCandidate outline;
  outline.ellipse = ellipse;
  return outline;
}

// The ellipse on which a circle about the marker's centre is seen; its axes are those of the image, as it is tilted
// about x: from its ends along them.
EllipseCandidate imageOf(const MarkerPlane &plane, double radius)
{
  const CameraModel model = camera();
  const double top = model.toPixel(plane.project(Eigen::Vector2d(0., -radius))).y();
  const double bottom = model.toPixel(plane.project(Eigen::Vector2d(0., radius))).y();
  EllipseParameters ellipse;
  ellipse.center = Eigen::Vector2d(u0, 0.5 * (top + bottom));
  ellipse.b = 0.5 * (bottom - top);
  // Widest where a ray through the ellipse's centre meets the plane, and beyond: the chord there.
  const double y = plane.intersect(model.toMeter(ellipse.center)).y();
  const double x = std::sqrt(radius * radius - y * y);
  ellipse.a = model.toPixel(plane.project(Eigen::Vector2d(x, y))).x() - u0;
  return outlineOf(ellipse);
}

EllipseCandidate circleAt(double u, double v, double radius)
{
  EllipseParameters circle;
  circle.center = Eigen::Vector2d(u, v);
  circle.a = circle.b = radius;
  return outlineOf(circle);
}
} // namespace

TEST(MarkerPlaces, RoomIsInTheWhite)
{
  // Radii in the image of a marker of 100 pixels: of the white in golay23's code 40, in a ring of 0.8 95 % of 80.
  MarkerPlaces places;
  places.reset(800, 600);
  const EllipseCandidate outline = circleAt(u0, v0, 100.);
  places.add(outline, markerOf(vpCircleMarkerFamily::GOLAY23, planeAt(0.)));
  EXPECT_FALSE(places.hold(circleAt(u0, v0, 39.9), camera()));
  EXPECT_TRUE(places.hold(circleAt(u0, v0, 40.1), camera()));
  EXPECT_FALSE(places.hold(circleAt(u0 + 20., v0, 19.9), camera()));
  EXPECT_TRUE(places.hold(circleAt(u0 + 20., v0, 20.1), camera()));
  EXPECT_TRUE(places.hold(circleAt(u0 + 55., v0, 4.), camera())) << "a sector of its code";
  EXPECT_TRUE(places.hold(outline, camera())) << "itself again";
  EXPECT_FALSE(places.hold(circleAt(u0 + 110., v0, 4.), camera())) << "beside it";
  EXPECT_FALSE(places.hold(circleAt(u0, v0, 101.), camera())) << "around it";
  EllipseCandidate arc = circleAt(u0, v0, 101.);
  arc.behind = 100.;
  EXPECT_TRUE(places.hold(arc, camera())) << "an arc of its edge";
  places.reset(800, 600);
  EXPECT_FALSE(places.hold(circleAt(u0, v0, 50.), camera()));
  places.add(outline, markerOf(vpCircleMarkerFamily::ring(0.8), planeAt(0.)));
  EXPECT_FALSE(places.hold(circleAt(u0, v0, 75.9), camera()));
  EXPECT_TRUE(places.hold(circleAt(u0, v0, 76.1), camera()));
  places.reset(800, 600);
  places.add(outline, markerOf(vpCircleMarkerFamily::DISC, planeAt(0.)));
  EXPECT_TRUE(places.hold(circleAt(u0, v0, 5.), camera()));
  places.reset(800, 600);
  places.add(outline);
  EXPECT_TRUE(places.hold(circleAt(u0, v0, 5.), camera()));
}

TEST(MarkerPlaces, RoomIsOnTheMarkersPlane)
{
  // In perspective circles of one centre are seen as ellipses of different centres.
  for (const double tilt : {0.3, 0.9, 1.2}) {
    const MarkerPlane plane = planeAt(tilt);
    const EllipseCandidate outline = imageOf(plane, 1.);
    MarkerPlaces places;
    places.reset(800, 600);
    places.add(outline, markerOf(vpCircleMarkerFamily::GOLAY23, plane));
    EXPECT_FALSE(places.hold(imageOf(plane, 0.39), camera())) << tilt;
    EXPECT_TRUE(places.hold(imageOf(plane, 0.41), camera())) << tilt;
  }
}
