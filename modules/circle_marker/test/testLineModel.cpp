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
 * Test of the model that integrates along lines.
 */

#include "testPixelTools.h"

#include "support/camera_model.h"
#include "refine/image_model.h"
#include "refine/line_model.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr unsigned int side = 80;

//! The scene as share of black, on paper without end.
MarkerScene asDarkness(MarkerScene scene)
{
  scene.white = 0.;
  scene.black = 1.;
  scene.sheet = 1e9;
  return scene;
}

//! All pixels of the image, in blocks, with what the model is made of.
struct Case
{
  Case(const MarkerScene &scene, double blur)
      : plane(scene.plane()), pattern(patternOf(scene.family, scene.family.isCoded() ? 0 : -1)),
        truth(expose(side, side, blur, asDarkness(scene), 8))
  {
    pattern.setWord(scene.word);
    photometry.blur.sigma = std::sqrt(blur * blur + 1. / 12.);
    pixels = allPixels(truth, scene);
    packPixels(pixels, plane, pattern, photometry, 0., 1., mostBorders, blocks);
  }

  //! Calls use(sight, block, lanes with a pixel).
  template <class Use> void forEachBlock(const Use &use) const
  {
    for (std::size_t kind = 0; kind < pixelSights; ++kind) {
      std::size_t left = blocks.count[kind];
      for (const PixelBlock &block : blocks.bySight[kind]) {
        use(static_cast<PixelSight>(kind), block, static_cast<int>(std::min<std::size_t>(left, laneCount)));
        left -= std::min<std::size_t>(left, laneCount);
      }
    }
  }

  MarkerPlane plane;
  MarkerPattern pattern;
  vpImage<double> truth;
  Photometry photometry;
  std::vector<FitPixel> pixels;
  PixelBlocks blocks;
};

//! Deviation from the truth at pixels that see an edge.
struct Error
{
  void add(double value, double truth)
  {
    const double difference = std::fabs(value - truth);
    worst = std::max(worst, difference);
    if (truth > 0.001 && truth < 0.999) {
      squares += difference * difference;
      ++pixels;
    }
  }

  double rootMeanSquare() const { return std::sqrt(squares / pixels); }

  double worst = 0.;
  double squares = 0.;
  int pixels = 0;
};

const vpCircleMarkerFamily::vpType families[] = {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31,
                                                 vpCircleMarkerFamily::RING, vpCircleMarkerFamily::DISC};

MarkerScene smallScene(Random &random, const vpCircleMarkerFamily &family, double minorAxis)
{
  const double tilt = uniform(random, 1.0, 1.25);
  const int id = family.isCoded() ? static_cast<int>(random() % family.getNbIds()) : -1;
  return markerScene(random, family, id, minorAxis / std::cos(tilt), tilt, side);
}
} // namespace

TEST(LineModel, AgreesWithIntegrationFromTenPixelsMinorAxis)
{
  Random random = randomOfTest();
  for (const vpCircleMarkerFamily::vpType type : families) {
    const vpCircleMarkerFamily family(type);
    for (int i = 0; i < 10; ++i) {
      const double minorAxis = uniform(random, 10., 16.);
      const Case made(smallScene(random, family, minorAxis), 0.7);
      const LineModel model(made.plane, made.pattern, made.photometry.blur, made.blocks.reference);
      Error error;
      made.forEachBlock([&](PixelSight sight, const PixelBlock &block, int count) {
        const Lanes darkness = model.darkness(block, sight);
        for (int lane = 0; lane < count; ++lane) {
          error.add(static_cast<double>(darkness[lane]), static_cast<double>(block.grey[lane]));
        }
      });
      // A dozen lines leave some percent where borders between sectors meet rims.
      EXPECT_LT(error.worst, 0.04) << family.getName() << " minor axis " << minorAxis;
      EXPECT_LT(error.rootMeanSquare(), 0.005) << family.getName() << " minor axis " << minorAxis;
    }
  }
}

TEST(LineModel, CorrectionTakesMostOfTheParabolasErrorAway)
{
  Random random = randomOfTest();
  for (const vpCircleMarkerFamily::vpType type : families) {
    const vpCircleMarkerFamily family(type);
    for (int i = 0; i < 5; ++i) {
      Case made(smallScene(random, family, uniform(random, 5., 8.)), 0.7);
      EXPECT_TRUE(correctBends(made.plane, made.pattern, made.photometry.blur, made.blocks));
      const ImageModel model(made.plane, made.pattern, made.photometry.blur, made.blocks);
      Error before, after;
      made.forEachBlock([&](PixelSight sight, const PixelBlock &block, int count) {
        if (block.correction.abs().maxCoeff() > 0.f) {
          DarknessLanes darkness;
          model.evaluate(block, sight, darkness);
          for (int lane = 0; lane < count; ++lane) {
            before.add(static_cast<double>(darkness.value[lane] - block.correction[lane]), block.grey[lane]);
            after.add(static_cast<double>(darkness.value[lane]), block.grey[lane]);
          }
        }
      });
      ASSERT_GT(after.pixels, 20);
      // Where parabolas do well there is little to take away.
      EXPECT_LT(after.rootMeanSquare(), std::max(0.5 * before.rootMeanSquare(), 0.0015)) << family.getName();
      // Once more changes nothing.
      const PixelBlocks once = made.blocks;
      correctBends(made.plane, made.pattern, made.photometry.blur, made.blocks);
      for (std::size_t kind = 0; kind < pixelSights; ++kind) {
        for (std::size_t k = 0; k < once.bySight[kind].size(); ++k) {
          EXPECT_LT((made.blocks.bySight[kind][k].correction - once.bySight[kind][k].correction).abs().maxCoeff(),
                    1e-5f);
        }
      }
    }
  }
}

// Down to a minor axis of four pixels, where both sides of a circle and many sectors lie within the blur.
TEST(LineModel, CorrectedMarkersAgreeWithIntegrationFromFourPixelsMinorAxis)
{
  Random random = randomOfTest();
  for (const vpCircleMarkerFamily::vpType type : families) {
    const vpCircleMarkerFamily family(type);
    for (int i = 0; i < 8; ++i) {
      const double minorAxis = uniform(random, 4., 9.);
      const double tilt = std::acos(minorAxis / uniform(random, 18., 40.));
      const int id = family.isCoded() ? static_cast<int>(random() % family.getNbIds()) : -1;
      Case made(markerScene(random, family, id, minorAxis / std::cos(tilt), tilt, side), uniform(random, 0.5, 0.9));
      correctBends(made.plane, made.pattern, made.photometry.blur, made.blocks);
      const ImageModel model(made.plane, made.pattern, made.photometry.blur, made.blocks);
      Error error;
      made.forEachBlock([&](PixelSight sight, const PixelBlock &block, int count) {
        Lanes darkness;
        model.evaluate(block, sight, darkness);
        for (int lane = 0; lane < count; ++lane) {
          error.add(static_cast<double>(darkness[lane]), static_cast<double>(block.grey[lane]));
        }
      });
      EXPECT_LT(error.worst, 0.05) << family.getName() << " minor axis " << minorAxis << " tilt " << tilt;
      EXPECT_LT(error.rootMeanSquare(), 0.006) << family.getName() << " minor axis " << minorAxis << " tilt " << tilt;
    }
  }
}

TEST(LineModel, LargeMarkersAreNotCorrected)
{
  Random random = randomOfTest();
  const MarkerScene scene = markerScene(random, vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23), 5, 70., 0.4, side);
  Case made(scene, 0.7);
  EXPECT_FALSE(correctBends(made.plane, made.pattern, made.photometry.blur, made.blocks));
  made.forEachBlock(
      [](PixelSight, const PixelBlock &block, int) { EXPECT_EQ(block.correction.abs().maxCoeff(), 0.f); });
}

TEST(LineModel, InkSpreadsAsThatOfTheParabolas)
{
  Random random = randomOfTest();
  const MarkerScene scene = markerScene(random, vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23), 5, 70., 0.5, side);
  Case made(scene, 0.7);
  const double perPixel = scene.center.z() / (scene.focal * scene.radius);
  for (const double pixels : {-0.2, 0.2}) {
    BlurParameters blur = made.photometry.blur;
    blur.spread = pixels * perPixel;
    const LineModel lines(made.plane, made.pattern, blur, made.blocks.reference);
    const ImageModel parabolas(made.plane, made.pattern, blur, made.blocks);
    made.forEachBlock([&](PixelSight sight, const PixelBlock &block, int count) {
      const Lanes darkness = lines.darkness(block, sight);
      DarknessLanes expected;
      parabolas.evaluate(block, sight, expected);
      for (int lane = 0; lane < count; ++lane) {
        EXPECT_NEAR(darkness[lane], expected.value[lane], 0.02);
      }
    });
  }
}
