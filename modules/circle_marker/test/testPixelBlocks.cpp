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
 * Pixels in blocks, sorted by what they see.
 */

#include "testRoomTools.h"

#include "refine/plane_point.h"
#include "refine/fit_pixels.h"
#include "refine/image_model.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr unsigned int side = 150;

struct Packed
{
  MarkerScene scene;
  MarkerPattern pattern;
  std::vector<FitPixel> pixels;
  PixelBlocks blocks;
};

Packed pack(Random &random, const vpCircleMarkerFamily &family, double diameter, const Photometry &photometry)
{
  Packed packed;
  const int id = family.isCoded() ? static_cast<int>(random() % family.getNbIds()) : -1;
  packed.scene = markerScene(random, family, id, diameter, uniform(random, 0., 1.), side);
  packed.pattern = patternOf(family, id);
  const MarkerPlane plane = packed.scene.plane();
  selectPixels(digitise(expose(side, side, 0.7, packed.scene, 2), 2., random), CameraModel(packed.scene.camera()),
               packed.scene.frame(), &plane, 1, packed.pattern, {BlurParameters(), 0.3, 1e6}, packed.pixels);
  packPixels(packed.pixels, plane, packed.pattern, photometry, 2., 1., mostBorders, packed.blocks);
  return packed;
}
} // namespace

TEST(PixelBlocks, HoldEveryPixelOnce)
{
  Random random = randomOfTest();
  for (const double diameter : {18., 40., 110.}) {
    const Packed packed = pack(random, vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23), diameter, Photometry());
    std::size_t count = 0;
    double grey = 0.;
    for (std::size_t kind = 0; kind < pixelSights; ++kind) {
      count += packed.blocks.count[kind];
      std::size_t lanes = 0;
      for (const PixelBlock &block : packed.blocks.bySight[kind]) {
        for (int lane = 0; lane < laneCount; ++lane) {
          const bool holds = block.variance[lane] < noPixel;
          lanes += holds;
          grey += holds ? static_cast<double>(block.grey[lane]) : 0.;
        }
      }
      EXPECT_EQ(lanes, packed.blocks.count[kind]);
      EXPECT_EQ(packed.blocks.bySight[kind].size(), (lanes + laneCount - 1) / laneCount);
    }
    EXPECT_EQ(count, packed.pixels.size());
    double expected = 0.;
    for (const FitPixel &pixel : packed.pixels) {
      expected += pixel.grey;
    }
    EXPECT_NEAR(grey, expected, 1e-6 * expected);
  }
}

TEST(PixelBlocks, WhatAPixelDoesNotSeeMakesNoDifference)
{
  // The model of a kind against the one that looks at everything.
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31R}) {
    for (int i = 0; i < 10; ++i) {
      const Packed packed = pack(random, vpCircleMarkerFamily(type), uniform(random, 60., 120.), Photometry());
      const ImageModel model(packed.scene.plane(), packed.pattern, BlurParameters(), packed.blocks);
      EXPECT_GT(packed.blocks.count[static_cast<std::size_t>(PixelSight::TRACK)], 100u);
      for (const PixelBlock &block : packed.blocks.bySight[static_cast<std::size_t>(PixelSight::TRACK)]) {
        DarknessLanes own, all;
        model.evaluate(block, PixelSight::TRACK, own);
        model.evaluate(block, PixelSight::RING_AND_TRACK, all);
        for (int lane = 0; lane < laneCount; ++lane) {
          if (block.variance[lane] < noPixel) {
            EXPECT_NEAR(own.value[lane], all.value[lane], 1e-5);
            EXPECT_NEAR(own.byTwist[2][lane], all.byTwist[2][lane], 1e-4);
            EXPECT_NEAR(own.bySigma[lane], all.bySigma[lane], 1e-4);
          }
        }
      }
    }
  }
}

// A block may hold pixels that are far apart, some of them far from the edges that others see.
TEST(PixelBlocks, NeighboursInABlockMakeNoDifference)
{
  Random random = randomOfTest();
  constexpr unsigned int wide = 400;
  const vpImage<unsigned char> I(wide, wide, 128); // grey levels do not matter
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::BCH31);
  for (const double diameter : {60., 140., 330.}) {
    for (const double tilt : {0.6, 1.3}) {
      Packed packed;
      packed.scene = markerScene(random, family, 7, diameter, tilt, wide);
      packed.pattern = patternOf(family, 7);
      const MarkerPlane plane = packed.scene.plane();
      selectPixels(I, CameraModel(packed.scene.camera()), packed.scene.frame(), &plane, 1, packed.pattern,
                   {BlurParameters(), 0.3, 1e6}, packed.pixels);
      packPixels(packed.pixels, plane, packed.pattern, Photometry(), 2., 1., mostBorders, packed.blocks);
      BlurParameters blur;
      blur.sigma = 0.6;
      const ImageModel model(plane, packed.pattern, blur, packed.blocks);
      double worst = 0.;
      for (std::size_t kind = 0; kind < pixelSights; ++kind) {
        for (std::size_t k = 0; k < packed.blocks.bySight[kind].size(); ++k) {
          const PixelBlock &block = packed.blocks.bySight[kind][k];
          DarknessLanes together;
          model.evaluate(block, static_cast<PixelSight>(kind), together);
          const auto lanes =
              static_cast<Eigen::Index>(std::min<std::size_t>(packed.blocks.count[kind] - k * laneCount, laneCount));
          for (Eigen::Index lane = 0; lane < lanes; ++lane) {
            // The same block filled with one of its pixels.
            PixelBlock alone = block;
            for (Lanes *all : {&alone.place.x, &alone.place.y, &alone.place.xByU, &alone.place.xByV, &alone.place.yByU,
                               &alone.place.yByV}) {
              all->setConstant((*all)[lane]);
            }
            PixelBlocks own;
            own.reference = packed.blocks.reference;
            own.borders = packed.blocks.borders;
            if (block.sectors != PixelBlock::none) {
              alone.sectors = 0;
              SectorLanes sectors = packed.blocks.sectors[block.sectors];
              sectors.acrossX.setConstant(sectors.acrossX[lane]);
              sectors.acrossY.setConstant(sectors.acrossY[lane]);
              sectors.base.setConstant(sectors.base[lane]);
              for (Lanes &change : sectors.change) {
                change.setConstant(change[lane]);
              }
              own.sectors.push_back(sectors);
            }
            DarknessLanes single;
            ImageModel(plane, packed.pattern, blur, own).evaluate(alone, static_cast<PixelSight>(kind), single);
            ASSERT_TRUE(std::isfinite(single.value[0]));
            worst = std::max(worst, static_cast<double>(std::abs(single.value[0] - together.value[lane])));
          }
        }
      }
      EXPECT_LT(worst, 1e-3) << diameter; // what is passed over because no pixel of a block sees it leaves 4e-4
    }
  }
}

TEST(PixelBlocks, DoubtGrowsWithTheDifferenceOfTheSurround)
{
  Random random = randomOfTest();
  FitPixel pixel;
  const MarkerScene scene = markerScene(random, vpCircleMarkerFamily(vpCircleMarkerFamily::RING), -1, 60., 0., side);
  const CameraModel camera(scene.camera());
  pixel.meter = camera.toMeter(Eigen::Vector2d(75., 75.)).cast<float>();
  pixel.meterPerPixel = camera.meterPerPixel(Eigen::Vector2d(75., 75.)).cast<float>();
  MarkerPattern pattern = patternOf(scene.family, -1);
  const PlanePoint point = planePoint(pixel.model(), scene.plane());
  const double gradient = (point.byPixel.transpose() * point.q.normalized()).norm();
  Photometry photometry;
  photometry.white = 200.;
  photometry.surround = {{1., 0.}};
  const auto varianceOf = [&](double share, double beyond, double spread) {
    pixel.beyond[0] = {static_cast<float>(share), static_cast<float>(beyond), static_cast<float>(spread)};
    // The paper ends where the pixel sees that share of what lies beyond: 0.2533 and 0.8416 are normal quantiles.
    const double quantile = share == 0.5 ? 0. : share == 0.4 ? 0.2533 : 0.8416;
    pattern.paper[0].extent = point.q.norm() + quantile * photometry.blur.sigma * gradient;
    PixelBlocks blocks;
    packPixels({pixel}, scene.plane(), pattern, photometry, 2., 1., mostBorders, blocks);
    return static_cast<double>(blocks.bySight[0][0].variance[0]);
  };
  EXPECT_EQ(varianceOf(0., 50., 1.), 0.);   // sees nothing of it
  EXPECT_EQ(varianceOf(0.5, 200., 2.), 0.); // white paper goes on; the spread is that of the noise
  EXPECT_GT(varianceOf(0.5, 100., 2.), 100.);
  EXPECT_NEAR(varianceOf(0.5, 50., 2.) / varianceOf(0.5, 125., 2.), 4., 1e-3);
  // 0.3 of the share is uncertain, and the paper's end by 0.1 pixels, where the share changes by the density over
  // sigma.
  const auto expected = [&](double share, double density) {
    return std::pow(150. * 0.3 * share, 2.) + std::pow(150. * 0.1 * density / photometry.blur.sigma, 2.);
  };
  EXPECT_NEAR(varianceOf(0.5, 50., 2.) / expected(0.5, 0.3989), 1., 1e-3);
  EXPECT_NEAR(varianceOf(0.4, 50., 2.) / expected(0.4, 0.3863), 1., 1e-3);
  EXPECT_NEAR(varianceOf(0.2, 50., 2.) / expected(0.2, 0.2800), 1., 1e-3);
  EXPECT_GT(varianceOf(0.5, 200., 30.), 100.);                         // texture
  EXPECT_GT(varianceOf(0.5, 0., HUGE_VAL), varianceOf(0.5, 100., 2.)); // the image ends there: anything is possible
}

TEST(PixelBlocks, ServeNearPosesOnly)
{
  Random random = randomOfTest();
  const Packed packed = pack(random, vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23), 90., Photometry());
  const MarkerPlane plane = packed.scene.plane(); // sorted for a pose that may be off by a pixel
  const auto serves = [&](const MarkerPlane &other, const BlurParameters &blur, double poseError) {
    return serve(packed.blocks, other, packed.pattern, blur, poseError, mostBorders);
  };
  BlurParameters wide;
  wide.sigma = 2. * BlurParameters().sigma;
  EXPECT_TRUE(serves(plane, BlurParameters(), 1.));
  EXPECT_FALSE(serves(plane, BlurParameters(), 1.1));
  EXPECT_FALSE(serves(plane, wide, 1.));
  MarkerPlane moved = plane;
  moved.center.x() += 0.6 * plane.center.z() * packed.blocks.reference.unit; // 0.6 pixels
  EXPECT_TRUE(serves(moved, BlurParameters(), 0.3));
  EXPECT_FALSE(serves(moved, BlurParameters(), 0.5));
  MarkerPlane spun = plane; // the outline stays where it is, the sectors do not
  spun.spin(0.2);
  EXPECT_FALSE(serves(spun, BlurParameters(), 0.5));
  EXPECT_FALSE(serve(PixelBlocks(), plane, packed.pattern, BlurParameters(), 0., mostBorders));
  // Of a small marker's borders some were left out.
  Packed small = pack(random, vpCircleMarkerFamily(vpCircleMarkerFamily::BCH31), 22., Photometry());
  packPixels(small.pixels, small.scene.plane(), small.pattern, Photometry(), 2., 1., 3, small.blocks);
  EXPECT_TRUE(serve(small.blocks, small.scene.plane(), small.pattern, BlurParameters(), 0.5, 3));
  EXPECT_FALSE(serve(small.blocks, small.scene.plane(), small.pattern, BlurParameters(), 0.5, mostBorders));
}

TEST(PixelBlocks, TheSurroundIsJudgedAgainAsAtFirst)
{
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::RING}) {
    const vpCircleMarkerFamily family(type);
    Photometry first;
    first.white = 150.;
    Packed packed = pack(random, family, 30., first);
    ASSERT_FALSE(packed.blocks.surrounds.empty());
    Photometry other = first;
    other.white = 230.;
    other.surround = {{0.8, 0.1}};
    const MarkerPlane plane = packed.scene.plane();
    const PixelBlocks before = packed.blocks;
    judgeSurround(packed.pixels, plane, packed.pattern, other, 3., packed.blocks);
    PixelBlocks anew;
    packPixels(packed.pixels, plane, packed.pattern, other, 3., 1., mostBorders, anew);
    bool isChanged = false;
    for (std::size_t kind = 0; kind < pixelSights; ++kind) {
      ASSERT_EQ(packed.blocks.bySight[kind].size(), anew.bySight[kind].size());
      for (std::size_t k = 0; k < anew.bySight[kind].size(); ++k) {
        const PixelBlock &p = packed.blocks.bySight[kind][k];
        const PixelBlock &q = anew.bySight[kind][k];
        EXPECT_TRUE((p.variance == q.variance).all());
        isChanged = isChanged || !(p.variance == before.bySight[kind][k].variance).all();
        ASSERT_EQ(p.surround == PixelBlock::none, q.surround == PixelBlock::none);
        if (p.surround != PixelBlock::none) {
          const SurroundLanes &a = packed.blocks.surrounds[p.surround];
          const SurroundLanes &b = anew.surrounds[q.surround];
          EXPECT_TRUE((a.spread == b.spread).all() && (a.share[0] == b.share[0]).all() &&
                      (a.share[1] == b.share[1]).all() && (a.beyond[0] == b.beyond[0]).all());
        }
      }
    }
    EXPECT_TRUE(isChanged);
  }
}
