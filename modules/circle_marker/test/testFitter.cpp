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
 * The same fit with the instructions of any processor and with the widest.
 */

#include "testRoomTools.h"

#include <typeinfo>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "refine/fitter.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr unsigned int side = 120;

//! What a fit says of the pixels that it chooses itself.
struct Outcome
{
  std::vector<FitPixel> pixels;
  FittedPose fit;
  double squares = 0.;
};

Outcome outcomeOf(Fitter &fitter, const vpImage<unsigned char> &I, const MarkerScene &scene, int id, bool exactBends)
{
  Outcome outcome;
  const MarkerPattern pattern = patternOf(scene.family, id);
  const MarkerPlane plane = scene.plane();
  fitter.selectPixels(I, CameraModel(scene.camera()), scene.frame(), &plane, 1, pattern, PixelChoice(), outcome.pixels);
  FitSettings settings;
  settings.spinIsKnown = scene.family.isCoded();
  settings.exactBends = exactBends;
  settings.gammaAndSpread = scene.family.getType() != vpCircleMarkerFamily::DISC;
  // One step: what is decided on the way to the end, as when to judge the surround again, may hang on rounding.
  settings.mostIterations = 1;
  MarkerPlane start = plane;
  start.center.z() *= 1.003;
  const auto fit = fitter.fitPose(outcome.pixels, {start, std::nullopt, 2.}, pattern, settings); // noise as digitised
  if (!fit) {
    throw vpException(vpException::fatalError, "no fit to %s", scene.family.getName().c_str());
  }
  outcome.fit = *fit;
  outcome.squares = fitter.robustSquares(outcome.pixels, *fit, pattern, fit->photometry, fit->noise, exactBends);
  return outcome;
}

// Between the poses of two fits, in standard deviations of the first.
double distanceOf(const FittedPose &one, const FittedPose &other, bool isCoded)
{
  Eigen::Matrix<double, 6, 6> covariance = one.covariance;
  if (!isCoded) {
    // The held spin leaves it singular; the spin is the same in both.
    covariance.bottomRightCorner<3, 3>() += 1e-9 * Eigen::Matrix3d::Identity();
  }
  const Eigen::AngleAxisd turned(Eigen::Matrix3d(other.plane.rotation * one.plane.rotation.transpose()));
  Eigen::Matrix<double, 6, 1> difference;
  difference << other.plane.center - one.plane.center, turned.angle() * turned.axis();
  return std::sqrt(difference.dot(covariance.inverse() * difference));
}
} // namespace

class FitterWith : public testing::TestWithParam<Instructions>
{
};

TEST_P(FitterWith, OtherInstructionsFitsTheSame)
{
  const std::unique_ptr<Fitter> plain = makeFitter(Instructions::PLAIN);
  const std::unique_ptr<Fitter> wide = makeFitter(GetParam());
  ASSERT_TRUE(plain);
  if (!wide) {
    GTEST_SKIP() << "this processor, or this compiler, does not have them";
  }
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31, vpCircleMarkerFamily::RING,
                          vpCircleMarkerFamily::DISC}) {
    const vpCircleMarkerFamily family(type);
    for (int i = 0; i < 12; ++i) {
      const int id = family.isCoded() ? static_cast<int>(random() % family.getNbIds()) : -1;
      const MarkerScene scene =
          markerScene(random, family, id, uniform(random, 16., 100.), uniform(random, 0.35, 0.95), side);
      const vpImage<unsigned char> I = digitise(expose(side, side, 0.7, scene), 2., random);
      for (const bool exactBends : {false, true}) {
        const Outcome one = outcomeOf(*plain, I, scene, id, exactBends);
        const Outcome other = outcomeOf(*wide, I, scene, id, exactBends);
        // A pixel at the very end of the band may be in or out by rounding.
        EXPECT_NEAR(static_cast<double>(one.pixels.size()), static_cast<double>(other.pixels.size()), 2.);
        if (one.pixels.size() != other.pixels.size()) {
          continue;
        }
        // Blocks of pixels are corrected where one of them sees a strong bend: of sixteen more are than of eight, by
        // what makes a tenth of a standard deviation. All else is rounding; where the paper's end is seen, which moves
        // against the ring's edge, steps are small differences: those of a disc of 20 pixels by 0.02 of their doubt.
        const bool hasOtherBlocks = exactBends && GetParam() == Instructions::WIDEST;
        const double rounding = hasOtherBlocks ? 0.01 : 2e-4;
        EXPECT_NEAR(other.fit.noise, one.fit.noise, rounding * one.fit.noise);
        // A hundredth of a standard deviation, as below, where the cost still falls by about one a standard deviation.
        EXPECT_NEAR(other.squares, one.squares, rounding * one.squares + 0.02 * one.fit.noise * one.fit.noise);
        // What makes a tenth of a standard deviation changes a chi^2 of 9 by 0.6.
        const double ofBend = hasOtherBlocks ? 1. : 0.2;
        EXPECT_NEAR(other.fit.bendOfLight, one.fit.bendOfLight,
                    0.02 * one.fit.bendOfLight + ofBend * one.fit.noise * one.fit.noise);
        EXPECT_LT(distanceOf(one.fit, other.fit, family.isCoded()), hasOtherBlocks ? 0.2 : 0.03)
            << family.getName() << " " << i;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, FitterWith, testing::Values(Instructions::WIDE, Instructions::WIDEST),
                         [](const testing::TestParamInfo<Instructions> &info) {
                           return info.param == Instructions::WIDE ? "Avx2" : "Avx512";
                         });

// What a fit makes of each pixel is what an image without noise shows.
TEST(Fitter, ExplainsThePixels)
{
  for (const Instructions instructions : {Instructions::PLAIN, Instructions::WIDE, Instructions::WIDEST}) {
    const std::unique_ptr<Fitter> fitter = makeFitter(instructions);
    if (!fitter) {
      continue;
    }
    Random random = randomOfTest();
    const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
    const MarkerScene scene = markerScene(random, family, 5, 60., 0.6, side);
    const vpImage<double> exact = expose(side, side, 0.7, scene);
    const vpImage<unsigned char> I = digitise(exact, 2., random);
    const MarkerPattern pattern = patternOf(family, 5);
    const MarkerPlane plane = scene.plane();
    std::vector<FitPixel> pixels;
    fitter->selectPixels(I, CameraModel(scene.camera()), scene.frame(), &plane, 1, pattern, PixelChoice(), pixels);
    const auto fit = fitter->fitPose(pixels, {plane, std::nullopt, std::nullopt}, pattern, FitSettings());
    ASSERT_TRUE(fit);
    std::vector<ExplainedPixel> explained;
    fitter->explainPixels(pixels, *fit, pattern, explained);
    double counted = 0.;
    double full = 0.;
    double squares = 0.;
    for (const ExplainedPixel &pixel : explained) {
      if (pixel.weight <= 0.f) { // fills a block of lanes
        continue;
      }
      ++counted;
      const Eigen::Vector2d place = scene.frame().center + scene.frame().size * pixel.offset.cast<double>();
      const auto u = static_cast<unsigned int>(std::lround(place.x()));
      const auto v = static_cast<unsigned int>(std::lround(place.y()));
      EXPECT_EQ(pixel.grey, I[v][u]);
      EXPECT_GT(pixel.darkness, -0.05);
      EXPECT_LT(pixel.darkness, 1.05);
      if (pixel.weight > 0.99f) {
        ++full;
        squares += std::pow(pixel.fitted - exact[v][u], 2.);
        EXPECT_NEAR(pixel.darkness, (scene.white - exact[v][u]) / (scene.white - scene.black), 0.1);
      }
    }
    EXPECT_EQ(counted, static_cast<double>(pixels.size()));
    EXPECT_GT(full, 0.5 * counted);
    EXPECT_LT(std::sqrt(squares / full), 1.) << "grey levels: half of the noise";
  }
}

TEST(Fitter, TakesTheWidestInstructions)
{
  const std::unique_ptr<Fitter> fitter = makeFitter();
  ASSERT_TRUE(fitter);
  const Fitter &taken = *fitter;
  for (const Instructions instructions : {Instructions::WIDEST, Instructions::WIDE, Instructions::PLAIN}) {
    if (const std::unique_ptr<Fitter> widest = makeFitter(instructions)) {
      const Fitter &expected = *widest;
      EXPECT_EQ(typeid(taken).hash_code(), typeid(expected).hash_code());
      break;
    }
  }
}
