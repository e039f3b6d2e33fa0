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
 * Tests of how well the pose of an outline is said to be known that is not refined.
 */

#include "refine/closed_form.h"

#include "ellipse/conic.h"
#include "ellipse/ellipse_walk.h"
#include "testRoomTools.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr unsigned int side = 300; // pixels
constexpr double focal = 800.;     // pixels
constexpr double sharp = 0.6;      // blur, pixels: less than is ever counted on
constexpr double leastBlur = 1.2;  // what is counted on then

// A disc that faces the camera, and what is said of its outline.
struct Facing
{
  double radius = 60.; // pixels
  double blur = sharp; // pixels
  double support = 1.;
  double quietZone = 1. / 6.; // in units of the radius
};

/*!
  Standard deviation of the depth, as the pixels by which all of the outline would have to move outward for it: the
  depth is in inverse proportion to the radius.
*/
double outwardErrorOf(const Facing &facing)
{
  const Eigen::Vector2d middle(0.5 * side, 0.5 * side);
  const EllipseScene disc = {middle, facing.radius, facing.radius, 0.};
  EllipseCandidate outline;
  outline.ellipse.center = middle;
  outline.ellipse.a = facing.radius;
  outline.ellipse.b = facing.radius;
  outline.conic = conicFromEllipse(outline.ellipse);
  outline.support = facing.support;
  outline.contrast = paper - ink;
  constexpr int count = 128;
  EllipseWalk walk(outline.ellipse, count);
  for (int i = 0; i < count; ++i, walk.next()) {
    outline.points.push_back(walk.here());
  }
  MarkerPlane plane;
  plane.radius = 0.09;
  const double depth = plane.radius * focal / facing.radius;
  plane.center = Eigen::Vector3d(0., 0., depth);
  plane.rotation = Eigen::Matrix3d::Identity();
  vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  vpCircleMarkerLayout layout = family.getLayout();
  layout.quietZone = facing.quietZone;
  family = family.withLayout(layout);
  const CameraModel camera(vpCameraParameters(focal, focal, middle.x(), middle.y()));
  std::vector<Eigen::Vector2d> meters;
  const auto covariance =
      closedFormCovariance(photograph(side, side, facing.blur, disc), outline, plane, family, camera, meters);
  return std::sqrt(covariance(2, 2)) / depth * facing.radius;
}

// What b has and a has not, both being sums of squares.
double beyond(double a, double b)
{
  return std::sqrt(b * b - a * a);
}
} // namespace

// 0.03 pixels for light and ink that make black look larger, and half the squared blur over the radius, 0.012: the
// points themselves fit perfectly.
TEST(ClosedForm, APerfectOutlineMayBeTooWideAllTheSame)
{
  EXPECT_NEAR(outwardErrorOf(Facing()), std::hypot(0.03, 0.5 * leastBlur * leastBlur / 60.), 0.003);
}

// Each quarter may be drawn half a pixel outward, which moves the mean of all by an eighth; four of them, by twice
// that.
TEST(ClosedForm, WhatCoversAPartDrawsTheRest)
{
  Facing covered;
  covered.support = 0.8;
  EXPECT_NEAR(beyond(outwardErrorOf(Facing()), outwardErrorOf(covered)), 0.25, 0.01);
  covered.support = 0.95; // nothing covers it
  EXPECT_EQ(outwardErrorOf(covered), outwardErrorOf(Facing()));
}

// The edge of a sheet that ends within the blur is a part of what is seen of the ring's edge.
TEST(ClosedForm, ANarrowQuietZoneMovesTheEdge)
{
  Facing wide;
  wide.radius = 10.;
  wide.quietZone = 0.5; // 5 pixels, four times the blur
  Facing narrow = wide;
  narrow.quietZone = 0.1; // a pixel
  EXPECT_NEAR(beyond(outwardErrorOf(wide), outwardErrorOf(narrow)),
              0.35 * leastBlur * std::exp(-0.5 / (leastBlur * leastBlur)), 0.01);
}

// A tenth of what a blur of 4 pixels, as it is measured with some slack, has beyond the least alone is 0.3 pixels.
TEST(ClosedForm, ABlurredOutlineIsKnownLessWell)
{
  Facing blurred;
  blurred.blur = 4.;
  EXPECT_GT(outwardErrorOf(blurred), 0.3);
  EXPECT_LT(outwardErrorOf(blurred), 1.);
}
