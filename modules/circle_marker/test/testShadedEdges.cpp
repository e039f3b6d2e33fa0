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
 * Test of the print's edges under the edge of a shadow.
 */

#include "refine/shaded_edges.h"

#include "refine/line_model.h"
#include "testPixelTools.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr unsigned int side = 70;
constexpr double absorption = 0.8;

//! All pixels of an image in which a shadow falls on a marker, on paper without end, before the lens blurs both.
struct Case
{
  Case(const MarkerScene &scene, double blur, double penumbra, double direction, double edge)
      : plane(scene.plane()), pattern(patternOf(scene.family, 0))
  {
    pattern.setWord(scene.word);
    photometry.blur.sigma = std::sqrt(blur * blur + 1. / 12.);
    photometry.absorption = absorption;
    const ImageFrame frame = scene.frame();
    Shadow shadow;
    shadow.factor = 0.4;
    shadow.direction = direction;
    shadow.edge = edge;
    shadow.softness = std::hypot(penumbra, photometry.blur.sigma) / frame.size;
    shadow.frameSize = frame.size;
    photometry.shadow = shadow;
    const auto lit = [&](double u, double v) {
      const double beyond = (u - frame.center.x()) * std::cos(direction) +
                            (v - frame.center.y()) * std::sin(direction) - edge * frame.size;
      const double dark = penumbra > 0. ? 0.5 * std::erfc(-beyond / (penumbra * M_SQRT2)) : beyond > 0. ? 1. : 0.;
      return (1. - (1. - shadow.factor) * dark) * (scene.isBlack(scene.onMarker(u, v)) ? 1. - absorption : 1.);
    };
    pixels = allPixels(expose(side, side, blur, lit, 8), scene);
    packPixels(pixels, plane, pattern, photometry, 0., 1., mostBorders, blocks);
    correctBends(plane, pattern, photometry.blur, blocks);
  }

  //! Greatest deviation of the light that pixels see, in units of the light on white.
  double error() const
  {
    const ImageModel model(plane, pattern, photometry.blur, blocks);
    double worst = 0.;
    for (std::size_t kind = 0; kind < pixelSights; ++kind) {
      std::size_t left = blocks.count[kind];
      for (const PixelBlock &block : blocks.bySight[kind]) {
        Lanes darkness;
        model.evaluate(block, static_cast<PixelSight>(kind), darkness);
        for (int lane = 0; lane < laneCount && left > 0; ++lane, --left) {
          const double light = photometry.shadow->leavesAt(Eigen::Vector2d(block.offsetU[lane], block.offsetV[lane]));
          worst = std::max(worst, std::fabs(light * (1. - absorption * static_cast<double>(darkness[lane])) -
                                            static_cast<double>(block.grey[lane])));
        }
      }
    }
    return worst;
  }

  bool correct() { return correctShadedEdges(plane, pattern, photometry, blocks); }

  MarkerPlane plane;
  MarkerPattern pattern;
  Photometry photometry;
  std::vector<FitPixel> pixels;
  PixelBlocks blocks;
};

Case randomCase(Random &random, double penumbra)
{
  const vpCircleMarkerFamily golay(vpCircleMarkerFamily::GOLAY23);
  const MarkerScene scene = markerScene(random, golay, static_cast<int>(random() % golay.getNbIds()),
                                        uniform(random, 36., 48.), uniform(random, 0., 1.1), side);
  return Case(scene, uniform(random, 0.5, 1.), penumbra, uniform(random, -M_PI, M_PI), uniform(random, -0.5, 0.5));
}
} // namespace

// The product of the blurred light and the blurred print is off by up to 8 % of the light on white.
TEST(ShadedEdges, LightAndPrintAreBlurredTogether)
{
  Random random = randomOfTest();
  for (const double penumbra : {0.5, 1., 2.}) {
    double before = 0.;
    double after = 0.;
    for (int i = 0; i < 15; ++i) {
      Case made = randomCase(random, penumbra);
      before = std::max(before, made.error());
      EXPECT_TRUE(made.correct());
      after = std::max(after, made.error());
    }
    RecordProperty("penumbra " + std::to_string(penumbra), std::to_string(before) + " " + std::to_string(after));
    EXPECT_GT(before, 0.02) << "penumbra " << penumbra;
    EXPECT_LT(after, 0.3 * before) << "penumbra " << penumbra;
  }
}

// A sharp shadow is an edge like those of the print: two terms of the series leave more of it.
TEST(ShadedEdges, SharpShadowsAreCorrectedForTheMost)
{
  Random random = randomOfTest();
  double before = 0.;
  double after = 0.;
  for (int i = 0; i < 15; ++i) {
    Case made = randomCase(random, 0.);
    before = std::max(before, made.error());
    EXPECT_TRUE(made.correct());
    after = std::max(after, made.error());
  }
  EXPECT_LT(after, 0.5 * before);
}

TEST(ShadedEdges, NothingWithoutAShadowOrItsFrame)
{
  Random random = randomOfTest();
  Case made = randomCase(random, 1.);
  const double before = made.error();
  made.photometry.shadow->frameSize = 0.;
  EXPECT_FALSE(made.correct());
  EXPECT_EQ(made.error(), before);
  made.photometry.shadow->frameSize = 20.;
  made.photometry.shadow->edge = 50.;
  EXPECT_FALSE(made.correct()) << "beside the marker";
  made.photometry.shadow.reset();
  EXPECT_FALSE(made.correct());
}
