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

Outcome outcomeOf(Fitter &fitter, const vpImage<unsigned char> &I, const MarkerScene &scene, int id)
{
  Outcome outcome;
  const MarkerPattern pattern = patternOf(scene.family, id, scene.family.getLayout().ringInner);
  const MarkerPlane plane = scene.plane();
  fitter.selectPixels(I, CameraModel(scene.camera()), scene.frame(), &plane, 1, pattern, BlurParameters(), 20000.,
                      outcome.pixels);
  FitSettings settings;
  settings.spinIsKnown = scene.family.isCoded();
  settings.growth = scene.family.getType() != vpCircleMarkerFamily::DISC;
  // One step: what is decided on the way to the end, as when to judge the surround again, may hang on rounding.
  settings.mostIterations = 1;
  MarkerPlane start = plane;
  start.center.z() *= 1.003;
  const auto fit = fitter.fitPose(outcome.pixels, {start, std::nullopt, 2.}, pattern, settings); // noise as digitised
  if (!fit) {
    throw vpException(vpException::fatalError, "no fit to %s", scene.family.getName().c_str());
  }
  outcome.fit = *fit;
  outcome.squares = fitter.robustSquares(outcome.pixels, *fit, pattern, fit->photometry, fit->noise, true);
  return outcome;
}
} // namespace

TEST(Fitter, InstructionsDoNotMatter)
{
  const std::unique_ptr<Fitter> plain = makeFitter(Instructions::PLAIN);
  const std::unique_ptr<Fitter> wide = makeFitter(Instructions::WIDE);
  ASSERT_TRUE(plain);
  if (!wide) {
    GTEST_SKIP() << "this processor, or this compiler, has no AVX2 and FMA";
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
      const Outcome one = outcomeOf(*plain, I, scene, id);
      const Outcome other = outcomeOf(*wide, I, scene, id);
      // A pixel at the very end of the band may be in or out by rounding.
      EXPECT_NEAR(static_cast<double>(one.pixels.size()), static_cast<double>(other.pixels.size()), 2.);
      if (one.pixels.size() != other.pixels.size()) {
        continue;
      }
      EXPECT_NEAR(other.fit.noise, one.fit.noise, 1e-4 * one.fit.noise);
      // A hundredth of a standard deviation, as below, where the cost still falls by about one a standard deviation.
      EXPECT_NEAR(other.squares, one.squares, 1e-4 * one.squares + 0.02 * one.fit.noise * one.fit.noise);
      Eigen::Matrix<double, 6, 6> covariance = one.fit.covariance;
      if (!family.isCoded()) {
        // The held spin leaves it singular; the spin is the same in both.
        covariance.bottomRightCorner<3, 3>() += 1e-9 * Eigen::Matrix3d::Identity();
      }
      const Eigen::AngleAxisd turned(Eigen::Matrix3d(other.fit.plane.rotation * one.fit.plane.rotation.transpose()));
      Eigen::Matrix<double, 6, 1> difference;
      difference << other.fit.plane.center - one.fit.plane.center, turned.angle() * turned.axis();
      EXPECT_LT(std::sqrt(difference.dot(covariance.inverse() * difference)), 0.01) << family.getName() << " " << i;
    }
  }
}
