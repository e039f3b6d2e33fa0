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
 * The choice of the pixels that a pose is fitted to.
 */

#include "testPatternDistance.h"
#include "testRoomTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>

#include "refine/fit_pixels.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr unsigned int side = 150;
constexpr double commonBlur = 0.8; // pixels

std::vector<FitPixel> select(const vpImage<unsigned char> &I, const MarkerScene &scene, int id)
{
  std::vector<FitPixel> pixels(5); // left over from before
  const MarkerPlane plane = scene.plane();
  selectPixels(I, CameraModel(scene.camera()), scene.frame(), &plane, 1, patternOf(scene.family, id),
               {BlurParameters(), 0.3, 3000.}, pixels);
  return pixels;
}

Eigen::Vector2d pixelOf(const FitPixel &pixel, const MarkerScene &scene)
{
  return scene.focal * pixel.meter.cast<double>() + scene.principal;
}

//! An image whose grey levels tell where they come from.
vpImage<unsigned char> numbered(unsigned int width, unsigned int height)
{
  vpImage<unsigned char> I(height, width);
  for (unsigned int v = 0; v < height; ++v) {
    for (unsigned int u = 0; u < width; ++u) {
      I[v][u] = static_cast<unsigned char>((7 * u + 31 * v) % 256);
    }
  }
  return I;
}
} // namespace

TEST(FitPixels, EveryPixelNearAnEdgeOnce)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  const vpImage<unsigned char> I = numbered(side, side);
  for (int i = 0; i < 10; ++i) {
    // Small enough not to be thinned.
    const MarkerScene scene =
        markerScene(random, family, 11, uniform(random, 20., 45.), uniform(random, 0., 0.8), side);
    const MarkerPattern pattern = patternOf(family, 11);
    const CameraModel camera(scene.camera());
    std::set<std::pair<int, int>> chosen;
    for (const FitPixel &pixel : select(I, scene, 11)) {
      const Eigen::Vector2d where = pixelOf(pixel, scene);
      const int u = static_cast<int>(std::lround(where.x()));
      const int v = static_cast<int>(std::lround(where.y()));
      EXPECT_LT((where - Eigen::Vector2d(u, v)).norm(), 2e-5);
      EXPECT_EQ(pixel.grey, I[static_cast<unsigned int>(v)][u]);
      EXPECT_TRUE(chosen.insert({u, v}).second);
      // On the print, or on its quiet zone; or near its end, and then that is said.
      if (scene.onMarker(u, v).norm() > 1. + family.getLayout().quietZone) {
        EXPECT_GT(pixel.beyond[0].share, 0.45);
      }
    }
    for (unsigned int v = 0; v < side; ++v) {
      for (unsigned int u = 0; u < side; ++u) {
        const Eigen::Vector2d where(u, v);
        const ModelPixel pixel = {camera.toMeter(where), camera.meterPerPixel(where)};
        if (distanceToPattern(pixel, scene.plane(), pattern).toEdges < 1.5 && scene.onMarker(u, v).norm() < 1.05) {
          EXPECT_EQ(chosen.count({u, v}), 1u) << u << ", " << v;
        }
      }
    }
  }
}

TEST(FitPixels, BandIsAsWideAsTheBlurAndWhatThePoseMayBeOff)
{
  Random random = randomOfTest();
  const MarkerScene scene = markerScene(random, vpCircleMarkerFamily(vpCircleMarkerFamily::RING), -1, 60., 0., side);
  const MarkerPlane plane = scene.plane();
  const double pixelsPerRadius = scene.focal * scene.radius / scene.center.z();
  const MarkerPattern pattern = patternOf(scene.family, -1);
  for (const double poseError : {0.1, 0.3, 1.}) {
    PixelChoice choice;
    choice.poseError = poseError;
    std::vector<FitPixel> pixels;
    selectPixels(numbered(side, side), CameraModel(scene.camera()), scene.frame(), &plane, 1, pattern, choice, pixels);
    double farthest = 0.;
    for (const FitPixel &pixel : pixels) {
      const Eigen::Vector2d where = pixelOf(pixel, scene);
      const double radius = scene.onMarker(where.x(), where.y()).norm();
      const double toEdge = std::min(std::abs(radius - 1.), std::abs(radius - pattern.ring[1].radius));
      farthest = std::max(farthest, pixelsPerRadius * toEdge);
    }
    // Two standard deviations of the blur; of some hundred pixels along the edges one is near the band's end.
    EXPECT_NEAR(farthest, 2. * choice.blur.sigma + poseError, 0.05) << poseError;
  }
}

TEST(FitPixels, SurroundIsWhatMayBeSeenBeyondTheQuietZone)
{
  // Frontal: the share of a blurred pixel beyond a circle is that beyond its tangent, but for its curvature.
  Random random = randomOfTest();
  const MarkerScene scene = markerScene(random, vpCircleMarkerFamily(vpCircleMarkerFamily::RING), -1, 30., 0., side);
  const double quietZone = scene.family.getLayout().quietZone;
  const double radiusPerPixel = scene.center.z() / (scene.focal * scene.radius);
  int seeing = 0;
  for (const FitPixel &pixel : select(numbered(side, side), scene, -1)) {
    const Eigen::Vector2d where = pixelOf(pixel, scene);
    const double inside = (1. + quietZone - scene.onMarker(where.x(), where.y()).norm()) / radiusPerPixel;
    const double share = pixel.beyond[0].share;
    EXPECT_NEAR(share, 0.5 * std::erfc(inside / commonBlur * M_SQRT1_2), 0.02) << inside << " pixels inside";
    EXPECT_LE(share, 0.9);
    seeing += share > 0.05;
    // A square holds the circle.
    EXPECT_LE(pixel.beyond[1].share, share + 0.02);
  }
  EXPECT_GT(seeing, 20);
}

// Where the paper ends is fitted for the pixels that see it together with an edge of the print. Those of a large
// marker's quiet zone alone would have six parameters fitted that the pose has nothing to do with.
TEST(FitPixels, ThePapersEndIsOfInterestBesideEdgesOnly)
{
  Random random = randomOfTest();
  const vpImage<unsigned char> I = numbered(side, side);
  const auto count = [&](double diameter) {
    std::size_t seen = 0;
    const MarkerScene scene = markerScene(random, vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23), 11, diameter,
                                          uniform(random, 0.1, 0.4), side);
    const MarkerPlane plane = scene.plane();
    std::vector<FitPixel> pixels;
    selectPixels(I, CameraModel(scene.camera()), scene.frame(), &plane, 1, patternOf(scene.family, 11), PixelChoice(),
                 pixels); // none is thinned: all have flat areas
    for (const FitPixel &pixel : pixels) {
      seen += pixel.seesSurround() ? 1 : 0;
    }
    return seen;
  };
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(count(uniform(random, 90., 110.)), 0u);
    EXPECT_GT(count(uniform(random, 20., 30.)), 20u);
  }
}

TEST(FitPixels, OffsetsAreFromTheCentreInUnitsOfItsImage)
{
  Random random = randomOfTest();
  const MarkerScene scene = markerScene(random, vpCircleMarkerFamily(vpCircleMarkerFamily::RING), -1, 60., 0., side);
  const auto pixels = select(numbered(side, side), scene, -1);
  ASSERT_GT(pixels.size(), 100u);
  const Eigen::Vector2d center = scene.principal + scene.focal * scene.center.head<2>() / scene.center.z();
  for (const FitPixel &pixel : pixels) {
    const Eigen::Vector2d offset = 30. * pixel.offset.cast<double>();
    EXPECT_LT((offset - (pixelOf(pixel, scene) - center)).norm(), 0.15 * 30.);
    EXPECT_LT(pixel.offset.norm(), 1.5);
  }
}

TEST(FitPixels, InsideAPlainRingNothingIsUsed)
{
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::RING, vpCircleMarkerFamily::DISC}) {
    const MarkerScene scene = markerScene(random, vpCircleMarkerFamily(type), -1, 60., 0.3, side);
    const auto pixels = select(numbered(side, side), scene, -1);
    ASSERT_GT(pixels.size(), 100u);
    for (const FitPixel &pixel : pixels) {
      const Eigen::Vector2d where = pixelOf(pixel, scene);
      EXPECT_GT(scene.onMarker(where.x(), where.y()).norm(), 0.6);
    }
  }
}

TEST(FitPixels, LargeMarkersAreThinnedEvenly)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  const vpImage<unsigned char> I = numbered(1000, 1000);
  for (const double diameter : {150., 300., 500., 700.}) {
    const MarkerScene scene = markerScene(random, family, 3, diameter, 0.4, 1000);
    const auto pixels = select(I, scene, 3);
    EXPECT_GT(pixels.size(), 1000u) << diameter;
    EXPECT_LT(pixels.size(), 6000u) << diameter;
    std::array<int, 8> octants{};
    for (const FitPixel &pixel : pixels) {
      const Eigen::Vector2d where = pixelOf(pixel, scene);
      const Eigen::Vector2d q = scene.onMarker(where.x(), where.y());
      if (q.norm() > 0.75) { // the ring's edges are alike in all directions
        const double turns = std::atan2(q.y(), q.x()) / (2. * M_PI);
        ++octants[static_cast<std::size_t>(8. * (turns - std::floor(turns))) % 8];
      }
    }
    const auto [least, most] = std::minmax_element(octants.begin(), octants.end());
    EXPECT_LT(*most, 1.5 * *least) << diameter;
  }
}

// Flat areas grow as the square of the diameter, what they tell of white, black and light does not.
TEST(FitPixels, FlatAreasGiveNoMoreThanSoManyPixels)
{
  using Quadrants = std::array<std::size_t, 4>;
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  const MarkerPattern pattern = patternOf(family, 3);
  const vpImage<unsigned char> I = numbered(600, 600);
  for (const double diameter : {200., 430.}) {
    const MarkerScene scene = markerScene(random, family, 3, diameter, 0.3, 600);
    const MarkerPlane plane = scene.plane();
    const auto flatOf = [&](const PixelChoice &choice) {
      Quadrants flat{};
      std::vector<FitPixel> pixels;
      selectPixels(I, CameraModel(scene.camera()), scene.frame(), &plane, 1, pattern, choice, pixels);
      for (const FitPixel &pixel : pixels) {
        if (distanceToPattern(pixel.model(), plane, pattern).toEdges > 6.) {
          const Eigen::Vector2d where = pixelOf(pixel, scene);
          const Eigen::Vector2d q = scene.onMarker(where.x(), where.y());
          ++flat[(q.x() > 0. ? 1 : 0) + (q.y() > 0. ? 2 : 0)];
        }
      }
      return flat;
    };
    PixelChoice all;
    all.manyFlat = HUGE_VAL;
    const Quadrants whole = flatOf(all);
    const Quadrants kept = flatOf(PixelChoice());
    if (diameter < 300.) { // they are not so many
      EXPECT_EQ(kept, whole);
      continue;
    }
    EXPECT_GT(std::accumulate(whole.begin(), whole.end(), std::size_t(0)), PixelChoice().manyFlat);
    EXPECT_LT(std::accumulate(kept.begin(), kept.end(), std::size_t(0)), PixelChoice().manyFlat);
    for (std::size_t k = 0; k < kept.size(); ++k) {
      EXPECT_NEAR(static_cast<double>(kept[k]) / static_cast<double>(whole[k]), 0.25, 0.05);
    }
  }
}

TEST(FitPixels, OnlyPixelsOfTheImage)
{
  // A marker half outside, and one that is not in the image at all.
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  const vpImage<unsigned char> I = numbered(90, 70);
  for (int i = 0; i < 40; ++i) {
    MarkerScene scene = markerScene(random, family, 3, 80., uniform(random, 0., 0.8), 80);
    const double angle = uniform(random, 0., 2. * M_PI);
    scene.center += uniform(random, 0., 4.) * scene.radius * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.);
    for (const FitPixel &pixel : select(I, scene, 3)) {
      const Eigen::Vector2d where = pixelOf(pixel, scene);
      EXPECT_GE(where.minCoeff(), -2e-5);
      EXPECT_LE(where.x(), 89. + 2e-5);
      EXPECT_LE(where.y(), 69. + 2e-5);
    }
  }
}

TEST(FitPixels, BothHypothesesAreServed)
{
  // Two poses apart by three pixels: the edges of either are covered, where both agree it is the marker.
  Random random = randomOfTest();
  const MarkerScene scene = markerScene(random, vpCircleMarkerFamily(vpCircleMarkerFamily::RING), -1, 60., 0., side);
  MarkerScene moved = scene;
  moved.center.x() += 3. * scene.center.z() / scene.focal;
  const MarkerPlane planes[] = {scene.plane(), moved.plane()};
  const vpImage<unsigned char> I = numbered(side, side);
  const MarkerPattern pattern = patternOf(scene.family, -1);
  const CameraModel camera(scene.camera());
  std::vector<FitPixel> pixels;
  selectPixels(I, camera, scene.frame(), planes, 2, pattern, {BlurParameters(), 0.3, 3000.}, pixels);
  std::set<std::pair<int, int>> chosen;
  for (const FitPixel &pixel : pixels) {
    const Eigen::Vector2d where = pixelOf(pixel, scene);
    chosen.insert({static_cast<int>(std::lround(where.x())), static_cast<int>(std::lround(where.y()))});
  }
  for (unsigned int v = 0; v < side; ++v) {
    for (unsigned int u = 0; u < side; ++u) {
      const Eigen::Vector2d where(u, v);
      const ModelPixel pixel = {camera.toMeter(where), camera.meterPerPixel(where)};
      const bool near = std::min(distanceToPattern(pixel, planes[0], pattern).toEdges,
                                 distanceToPattern(pixel, planes[1], pattern).toEdges) < 2. * commonBlur + 0.25;
      if (near && scene.onMarker(u, v).norm() < 1.1 && moved.onMarker(u, v).norm() < 1.1) {
        EXPECT_EQ(chosen.count({u, v}), 1u);
      }
    }
  }
}
