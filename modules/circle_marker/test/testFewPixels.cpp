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
 * The few pixels of the first steps.
 */

#include "testPatternDistance.h"
#include "testRoomTools.h"

#include "refine/few_pixels.h"

using namespace circle_marker;
using namespace room_test;

namespace {
std::vector<FitPixel> select(const MarkerScene &scene, unsigned int side, int id, std::size_t hypotheses)
{
  const MarkerPlane plane = scene.plane();
  const std::array<MarkerPlane, 2> planes = {plane, plane};
  std::vector<FitPixel> pixels(3); // left over from before
  selectFewPixels(vpImage<unsigned char>(side, side, 100), CameraModel(scene.camera()), scene.frame(), planes.data(),
                  hypotheses, patternOf(scene.family, id), BlurParameters(), pixels);
  return pixels;
}
} // namespace

TEST(FewPixels, AreFewHoweverLargeTheMarker)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  for (const double diameter : {20., 60., 200., 700.}) {
    const MarkerScene scene = markerScene(random, family, 7, diameter, 0.5, 900);
    for (const std::size_t hypotheses : {1u, 2u}) {
      const std::size_t count = select(scene, 900, 7, hypotheses).size();
      EXPECT_GT(count, 200u) << diameter;
      EXPECT_LT(count, 600u) << diameter;
    }
  }
}

TEST(FewPixels, LieAcrossTheEdges)
{
  Random random = randomOfTest();
  constexpr unsigned int side = 200;
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::RING, vpCircleMarkerFamily::DISC}) {
    const vpCircleMarkerFamily family(type);
    const int id = family.isCoded() ? 11 : -1;
    const MarkerScene scene = markerScene(random, family, id, 150., uniform(random, 0., 0.9), side);
    const MarkerPattern pattern = patternOf(family, id);
    int inside = 0, outside = 0;
    for (const FitPixel &pixel : select(scene, side, id, 1)) {
      const PatternDistance distance = distanceToPattern(pixel.model(), scene.plane(), pattern);
      EXPECT_LT(distance.toEdges, 2.6 * 0.8 + 0.75); // the row's end, and the rounding to whole pixels
      EXPECT_LT(pixel.beyond[0].share, 0.05);
      EXPECT_EQ(pixel.grey, 100.);
      inside += distance.radius < 1.;
      outside += distance.radius > 1.;
    }
    EXPECT_GT(inside, 40);
    EXPECT_GT(outside, 40);
  }
}

TEST(FewPixels, OnlyPixelsOfTheImage)
{
  Random random = randomOfTest();
  for (int i = 0; i < 20; ++i) {
    MarkerScene scene =
        markerScene(random, vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23), 3, 80., uniform(random, 0., 0.8), 90);
    scene.center.x() += uniform(random, -3., 3.) * scene.radius;
    for (const FitPixel &pixel : select(scene, 90, 3, 2)) {
      const Eigen::Vector2d where = scene.focal * pixel.meter.cast<double>() + scene.principal;
      EXPECT_GT(where.minCoeff(), -1e-4);
      EXPECT_LT(where.maxCoeff(), 89. + 1e-4);
    }
  }
}
