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
 * Tests of the search for a camera's unsharp mask.
 */

#include "refine/mask_search.h"

#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include "testFitTools.h"
#include "testMeasureTools.h"
#include "testSharpening.h"

using namespace circle_marker;
using namespace room_test;
using sharpening_test::sharpened;

namespace {
constexpr unsigned int side = 160;

//! White and ink that leave room for a halo.
MarkerScene sceneOf(Random &random, vpCircleMarkerFamily::vpType type, double diameter)
{
  const vpCircleMarkerFamily family(type);
  MarkerScene scene = markerScene(random, family, family.isCoded() ? 5 : -1, diameter, uniform(random, 0.2, 0.9), side);
  scene.white = 200.;
  scene.black = 60.;
  scene.sheet = 1.4;
  return scene;
}

//! What a search finds in an image.
struct Searched
{
  std::optional<SearchedMask> found;
  std::optional<FittedPose> behind; //!< The marker measured behind it.
};

Searched searchedIn(const vpImage<unsigned char> &I, const MarkerScene &scene, double noise)
{
  Searched searched;
  const CameraModel camera(scene.camera());
  Recognition marker = recognised(scene, scene.family.isCoded() ? 5 : -1, false);
  MeasureMemory memory;
  const auto asSeen = measure(I, camera, marker, true, memory, Deadline(), ImageNoise{noise, 1., false});
  marker.asSeen = &I;
  vpImage<unsigned char> restored;
  const FittedPose *around = asSeen ? &asSeen->first : nullptr;
  const auto behind = [&](const UnsharpMask &mask, const FittedPose *nearest) -> std::optional<FitBehind> {
    undo(mask, I, cv::Rect(0, 0, side, side), Deadline(), restored);
    const ImageNoise white = {noise / (1. + mask.amount), 1., false};
    const auto fit = around != nullptr && nearest != nullptr
                         ? measureNearby(restored, camera, marker, *around, *nearest, memory, Deadline(), white)
                         : measureInOneLook(restored, camera, marker, memory, Deadline(), white);
    return fit ? std::make_optional(FitBehind{*fit, memory.pixels.size()}) : std::nullopt;
  };
  FittedPose start;
  start.plane = scene.plane();
  MaskSearch search(asSeen ? asSeen->first : start, asSeen ? MaskSearch::Known::POSE : MaskSearch::Known::NOTHING,
                    noise, behind);
  searched.found = search.run();
  if (searched.found) {
    const auto again = behind(searched.found->mask, nullptr);
    searched.behind = again ? std::make_optional(again->fit) : std::nullopt;
  }
  return searched;
}

//! Mean of the logarithm of a mask's gain over all frequencies.
double lnGain(double amount, double sigma)
{
  constexpr int steps = 100;
  double sum = 0.;
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; j < steps; ++j) {
      const double squares = std::pow(M_PI * (i + 0.5) / steps, 2.) + std::pow(M_PI * (j + 0.5) / steps, 2.);
      sum += std::log(1. + amount * (1. - std::exp(-0.5 * sigma * sigma * squares)));
    }
  }
  return sum / (steps * steps);
}
} // namespace

// A likelihood that is known: what is left, times the gain, is a parabola in strength, a (1 - exp(-0.3 s^2)), and ln s,
// and the depth changes with both.
TEST(MaskSearch, FindsWhereLeastIsLeftAndHowWellThatIsKnown)
{
  constexpr std::size_t pixels = 900;
  const Eigen::Vector2d truth(0.4, std::log(1.5));
  Eigen::Matrix2d curvature; // of the variance, grey levels^2
  curvature << 300., 6., 6., 8.;
  const Eigen::Vector2d depthBy(-0.02, 0.004); // m
  const MarkerScene scene;
  const auto behind = [&](const UnsharpMask &mask, const FittedPose *) {
    const Eigen::Vector2d place(mask.amount * (1. - std::exp(-0.3 * mask.sigma * mask.sigma)), std::log(mask.sigma));
    const Eigen::Vector2d off = place - truth;
    FitBehind result;
    result.pixels = pixels;
    FittedPose &fit = result.fit;
    fit.plane = scene.plane();
    fit.plane.center.z() += depthBy.dot(off);
    fit.inliers = 1.;
    fit.noise = std::sqrt(1. + 0.5 * off.dot(curvature * off)) / std::exp(lnGain(mask.amount, mask.sigma));
    return std::make_optional(result);
  };
  FittedPose start;
  start.plane = scene.plane();
  MaskSearch search(start, MaskSearch::Known::POSE, 1., behind);
  const auto found = search.run();
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->mask.sigma, 1.5, 0.05);
  EXPECT_NEAR(found->mask.amount * (1. - std::exp(-0.3 * std::pow(found->mask.sigma, 2.))), 0.4, 0.01);
  const double none = 1. + 0.5 * truth[0] * truth[0] * curvature(0, 0); // at the width of the mask, about
  EXPECT_NEAR(found->gain, 0.5 * pixels * std::log(none), 0.1 * found->gain);
  const double variance = depthBy.dot((0.5 * pixels * curvature).inverse() * depthBy);
  EXPECT_NEAR(std::sqrt(found->doubt(2, 2)), std::sqrt(variance), 0.15 * std::sqrt(variance));
}

// A pose and its other one, which leans as far to the other side: where one is 0.01 rad rounder, at 3 mm more, so is
// the other, though its normal turns the other way.
TEST(MaskSearch, TheDoubtOfTheOtherPoseIsThatOfTheSameImage)
{
  SearchedMask searched;
  searched.pose.center = Eigen::Vector3d(0., 0., 1.);
  searched.pose.radius = 0.1;
  searched.pose.rotation = Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitX()).toRotationMatrix();
  Eigen::Matrix<double, 6, 1> change;
  change << 0., 0., 0.003, -0.01, 0., 0.; // against the lean
  searched.doubt = change * change.transpose();
  EXPECT_NEAR((searched.doubtOf(searched.pose) - searched.doubt).norm(), 0., 1e-12);
  MarkerPlane other = searched.pose;
  other.rotation = Eigen::AngleAxisd(-0.5, Eigen::Vector3d::UnitX()).toRotationMatrix();
  Eigen::Matrix<double, 6, 1> ofOther;
  ofOther << 0., 0., 0.003, 0.01, 0., 0.;
  EXPECT_NEAR((searched.doubtOf(other) - ofOther * ofOther.transpose()).norm(), 0., 1e-12);
  // In another unit of length.
  other.center *= 2.;
  other.radius *= 2.;
  ofOther[2] = 0.006;
  EXPECT_NEAR((searched.doubtOf(other) - ofOther * ofOther.transpose()).norm(), 0., 1e-12);
}

TEST(MaskSearch, WhereNothingIsMeasuredThereIsNoMask)
{
  using Known = MaskSearch::Known;
  for (const auto &[known, most] :
       {std::pair<Known, unsigned int>(Known::NOTHING, 9), {Known::POSE, 1}, {Known::HALO, 1}}) {
    unsigned int trials = 0;
    FittedPose start;
    start.plane = MarkerScene().plane();
    MaskSearch search(start, known, 1., [&](const UnsharpMask &, const FittedPose *) {
      ++trials;
      return std::optional<FitBehind>();
    });
    EXPECT_FALSE(search.run());
    EXPECT_EQ(trials, most) << "no mask, and each start and a third of it";
  }
}

// Small markers, whose ring has no room for a halo, are told by all of their pixels; and behind the mask the pose is
// what its covariance says.
TEST(MaskSearch, MasksOfCamerasAreTold)
{
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::RING}) {
    for (const double amount : {0.5, 1., 2.}) {
      for (const double sigma : {1., 2.}) {
        // A plain ring takes the halo of a weak or wide mask for light and gamma, and that of a strong wide one is cut
        // off: what is left of it widens the covariance, which testDetectorHalo looks at.
        const bool isRing = type == vpCircleMarkerFamily::RING;
        if ((sigma > 1. && (isRing || amount > 1.)) || (isRing && amount < 1.)) {
          continue;
        }
        constexpr int count = 12;
        double squared = 0.;
        double lnStrength = 0.;
        int found = 0;
        for (int i = 0; i < count; ++i) {
          const MarkerScene scene = sceneOf(random, type, uniform(random, 30., 100.));
          const auto I = sharpened(digitise(expose(side, side, 0.7, scene), 1., random), amount, sigma);
          const Searched searched = searchedIn(I, scene, std::exp(lnGain(amount, sigma)));
          if (!searched.found || !searched.behind) {
            continue;
          }
          ++found;
          EXPECT_GT(searched.found->gain, 10.);
          const UnsharpMask &mask = searched.found->mask;
          lnStrength += std::log(mask.amount * (1. - std::exp(-0.3 * mask.sigma * mask.sigma)) /
                                 (amount * (1. - std::exp(-0.3 * sigma * sigma))));
          FittedPose fit = *searched.behind;
          fit.covariance += searched.found->doubt;
          squared +=
              fit_test::mahalanobis(fit, scene.plane(), scene.family.isCoded()) / (scene.family.isCoded() ? 6. : 5.);
        }
        squared /= found;
        lnStrength /= found;
        const std::string what = vpCircleMarkerFamily(type).getName() + " of " + std::to_string(amount) + " times, " +
                                 std::to_string(sigma) + " pixels";
        RecordProperty(what, std::to_string(squared) + ", strength " + std::to_string(std::exp(lnStrength)));
        EXPECT_GE(found, isRing ? count / 2 : count - 1) << what;
        EXPECT_NEAR(lnStrength, 0., isRing ? 0.2 : 0.05) << what;
        EXPECT_LT(squared, 1.6) << what;
      }
    }
  }
}

TEST(MaskSearch, AnImageThatIsNotSharpenedIsAsLikelyWithoutAMask)
{
  Random random = randomOfTest();
  int found = 0;
  for (int i = 0; i < 30; ++i) {
    const MarkerScene scene =
        sceneOf(random, i % 2 ? vpCircleMarkerFamily::GOLAY23 : vpCircleMarkerFamily::RING, uniform(random, 30., 100.));
    const Searched searched =
        searchedIn(digitise(expose(side, side, uniform(random, 0.5, 1.), scene), 1., random), scene, 1.);
    found += searched.found && searched.found->gain > 10. ? 1 : 0;
  }
  EXPECT_LE(found, 1) << "by chance";
}

// Halos that reach beyond black and white are cut off: pixels that tell nothing are left out.
TEST(MaskSearch, IsToldThoughHalosAreCutOff)
{
  Random random = randomOfTest();
  int told = 0;
  for (int i = 0; i < 10; ++i) {
    MarkerScene scene = sceneOf(random, vpCircleMarkerFamily::GOLAY23, uniform(random, 40., 100.));
    scene.white = 240.;
    scene.black = 15.;
    const Searched searched =
        searchedIn(sharpened(digitise(expose(side, side, 0.7, scene), 1., random), 1., 2.), scene, 2.);
    told += searched.found && std::abs(searched.found->mask.amount - 1.) < 0.25 &&
            std::abs(searched.found->mask.sigma - 2.) < 0.5;
  }
  EXPECT_GE(told, 7);
}
