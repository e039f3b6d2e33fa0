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
 * From pixels to the marker's plane, eight at a time.
 */

#include "testRoomTools.h"

#include "refine/plane_point.h"
#include "refine/plane_lanes.h"
#include "support/camera_model.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr unsigned int side = 130;

MarkerScene randomScene(Random &random)
{
  return markerScene(random, vpCircleMarkerFamily(vpCircleMarkerFamily::RING), -1, uniform(random, 20., 110.),
                     uniform(random, 0., 1.2), side);
}

SheetBend randomBend(Random &random)
{
  const double bow = uniform(random, -0.02, 0.02);
  return {bow, Eigen::Vector2d(uniform(random, -0.02, 0.02), uniform(random, -0.02, 0.02))};
}
} // namespace

TEST(PlaneLanes, AgreesWithTheRay)
{
  Random random = randomOfTest();
  for (int i = 0; i < 100; ++i) {
    const MarkerScene scene = randomScene(random);
    MarkerPlane plane = scene.plane();
    if (i % 2 == 1) {
      plane.bend = randomBend(random);
    }
    const CameraModel camera(scene.camera());
    const ImageReference reference = {camera.toMeter(Eigen::Vector2d(60., 70.)), 1. / scene.focal};
    const PlaneHomography homography(plane, reference, Eigen::Matrix2d::Identity());
    PlaceLanes place;
    std::array<ModelPixel, laneCount> pixels;
    for (int lane = 0; lane < laneCount; ++lane) {
      const Eigen::Vector2d where(uniform(random, 10., 120.), uniform(random, 10., 120.));
      ModelPixel &pixel = pixels[static_cast<std::size_t>(lane)];
      pixel = {camera.toMeter(where), camera.meterPerPixel(where)};
      place.x[lane] = static_cast<float>((pixel.meter.x() - reference.meter.x()) / reference.unit);
      place.y[lane] = static_cast<float>((pixel.meter.y() - reference.meter.y()) / reference.unit);
      place.xByU[lane] = static_cast<float>(pixel.meterPerPixel(0, 0) / reference.unit);
      place.xByV[lane] = static_cast<float>(pixel.meterPerPixel(0, 1) / reference.unit);
      place.yByU[lane] = static_cast<float>(pixel.meterPerPixel(1, 0) / reference.unit);
      place.yByV[lane] = static_cast<float>(pixel.meterPerPixel(1, 1) / reference.unit);
    }
    PlaneLanes point;
    homography.apply(place, point);
    for (int lane = 0; lane < laneCount; ++lane) {
      // A thousandth of a pixel, where a pixel is a 10th to a 55th of the radius, and more at the far side of a tilt.
      const PlanePoint truth = planePoint(pixels[static_cast<std::size_t>(lane)], plane);
      const double perPixel = truth.byPixel.norm();
      EXPECT_NEAR(point.qx[lane], truth.q.x(), 1e-3 * perPixel);
      EXPECT_NEAR(point.qy[lane], truth.q.y(), 1e-3 * perPixel);
      EXPECT_NEAR(point.qxByU[lane], truth.byPixel(0, 0), 1e-4 * perPixel);
      EXPECT_NEAR(point.qxByV[lane], truth.byPixel(0, 1), 1e-4 * perPixel);
      EXPECT_NEAR(point.qyByU[lane], truth.byPixel(1, 0), 1e-4 * perPixel);
      EXPECT_NEAR(point.qyByV[lane], truth.byPixel(1, 1), 1e-4 * perPixel);
      EXPECT_NEAR(point.radius[lane], truth.q.norm(), 1e-3 * perPixel);
      const double gradient = (truth.byPixel.transpose() * truth.q.normalized()).norm();
      EXPECT_NEAR(point.gradient[lane], gradient, 1e-3 * perPixel);
    }
  }
}

// The derivative of what the ray through a pixel meets, by differences over a hundredth of a pixel.
TEST(PlaneLanes, DerivativeOnABentSheetAgreesWithDifferences)
{
  Random random = randomOfTest();
  for (int i = 0; i < 100; ++i) {
    const MarkerScene scene = randomScene(random);
    MarkerPlane plane = scene.plane();
    plane.bend = randomBend(random);
    const CameraModel camera(scene.camera());
    const Eigen::Vector2d where = camera.toPixel(plane.project(Eigen::Vector2d(uniform(random, -1., 1.), 0.5)));
    const PlanePoint point = planePoint({camera.toMeter(where), camera.meterPerPixel(where)}, plane);
    EXPECT_LT((point.q - plane.intersect(camera.toMeter(where))).norm(), 1e-12);
    for (int axis = 0; axis < 2; ++axis) {
      const Eigen::Vector2d step = 0.005 * Eigen::Vector2d::Unit(axis);
      const Eigen::Vector2d difference =
          (plane.intersect(camera.toMeter(where + step)) - plane.intersect(camera.toMeter(where - step))) / 0.01;
      // The shift along the plane is not in it: some ten thousandths.
      EXPECT_LT((difference - point.byPixel.col(axis)).norm(), 2e-3 * point.byPixel.norm());
    }
  }
}
