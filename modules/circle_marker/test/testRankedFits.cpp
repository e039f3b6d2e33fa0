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
 * The fits of one marker: from where they start, and which of them is the likeliest.
 */

#include "testRoomTools.h"
#include "testScriptedFitter.h"

#include <visp3/core/vpMath.h>

#include <Eigen/Geometry>

#include "refine/fit_starts.h"
#include "refine/ranked_fits.h"

using namespace circle_marker;
using namespace room_test;

namespace {
//! A marker at 1 m on the optical axis that leans by a tilt in a direction of the image.
MarkerPlane leaning(double tilt, double azimuth)
{
  MarkerPlane plane;
  plane.center = Eigen::Vector3d::UnitZ();
  plane.rotation = turn(tilt, Eigen::Vector3d(-std::sin(azimuth), std::cos(azimuth), 0.));
  plane.radius = 0.1;
  return plane;
}

FittedPose fitOf(const MarkerPlane &plane)
{
  return fitAt({plane, std::nullopt, std::nullopt});
}

//! A fit whose rotation is known to a standard deviation, rad.
FittedPose fitOf(const MarkerPlane &plane, double deviation)
{
  FittedPose fit = fitOf(plane);
  fit.covariance = deviation * deviation * Eigen::Matrix<double, 6, 6>::Identity();
  return fit;
}

const MarkerPattern withCode = patternOf(vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23), 3);
const MarkerPattern withoutCode = patternOf(vpCircleMarkerFamily(vpCircleMarkerFamily::RING), -1);

//! Starts that lean to different sides, by their number.
Few<FitStart> startsFrom(int count)
{
  Few<FitStart> starts;
  for (int i = 0; i < count; ++i) {
    starts.push_back({leaning(0.4, 0.5 * M_PI * i), std::nullopt, std::nullopt});
  }
  return starts;
}

//! What was asked of the fitter by fitAll(), whose fits have these noises and squares; all are settled.
struct Fits
{
  std::vector<double> noise = {2., 1.5, 3.};
  std::vector<double> squares = {1000., 900., 800.};
  std::vector<bool> isSettled = {true, true, true};

  std::vector<ScriptedFitter::Asked> askedFor(const Few<FitStart> &starts, const MarkerPattern &pattern,
                                              const FitSettings &settings,
                                              const std::optional<FittedPose> &before = std::nullopt)
  {
    std::size_t k = 0;
    ScriptedFitter fitter([&](const ScriptedFitter::Asked &asked) {
      FittedPose fit = fitAt(asked.start);
      fit.photometry.gamma = 1.1;
      fit.noise = noise[k];
      fit.scale = 10. * noise[k]; // as a fit may weigh its residuals by another noise than it leaves
      fit.squares = squares[k];
      fit.isSettled = isSettled[k];
      ++k;
      return std::optional<FittedPose>(fit);
    });
    fits = fitAll({}, starts, pattern, settings, fitter, before);
    return fitter.asked;
  }

  Few<FittedPose> fits; // the last ones
};
} // namespace

TEST(RankedFits, EveryStartIsFitted)
{
  const auto asked = Fits().askedFor(startsFrom(3), withCode, FitSettings());
  ASSERT_EQ(asked.size(), 3u);
  for (std::size_t i = 0; i < asked.size(); ++i) {
    EXPECT_EQ(asked[i].start.plane.rotation, startsFrom(3)[i].plane.rotation);
    EXPECT_FALSE(asked[i].start.photometry);
    EXPECT_EQ(asked[i].settings.samePixels, i > 0); // they are sorted once
  }
}

// Who comes later is compared with the best before: the settled one with the least noise.
TEST(RankedFits, EveryFitHasTheBestBeforeAsItsRival)
{
  Fits fits;
  const auto asked = fits.askedFor(startsFrom(3), withCode, FitSettings());
  ASSERT_EQ(asked.size(), 3u);
  EXPECT_FALSE(asked[0].settings.rival);
  ASSERT_TRUE(asked[1].settings.rival);
  EXPECT_EQ(asked[1].settings.rival->squares, 1000.);
  EXPECT_EQ(asked[1].settings.rival->scale, 20.);
  // Three times what makes a pose hopeless on few pixels: it may still catch up.
  EXPECT_EQ(asked[1].settings.rival->odds, 90.);
  EXPECT_EQ(asked[2].settings.rival->scale, 15.);
  fits.noise = {2., 3., 2.5};
  EXPECT_EQ(fits.askedFor(startsFrom(3), withCode, FitSettings())[2].settings.rival->scale, 20.);
  // What has not settled is no measure, nor is anything without a code, where poses differ by little.
  fits.isSettled = {false, true, true};
  EXPECT_FALSE(fits.askedFor(startsFrom(2), withCode, FitSettings())[1].settings.rival);
  EXPECT_FALSE(Fits().askedFor(startsFrom(2), withoutCode, FitSettings())[1].settings.rival);
  FittedPose before = fitOf(leaning(0.3, 0.));
  before.noise = 1.7;
  before.scale = 17.;
  const auto after = Fits().askedFor(startsFrom(2), withCode, FitSettings(), before);
  ASSERT_TRUE(after[0].settings.rival);
  EXPECT_EQ(after[0].settings.rival->scale, 17.);
}

TEST(RankedFits, TheSecondOfAClearMarkerGoesOnWithTheLightOfTheFirst)
{
  FitSettings settings;
  settings.isClear = true;
  const auto two = Fits().askedFor(startsFrom(2), withCode, settings);
  ASSERT_EQ(two.size(), 2u);
  ASSERT_TRUE(two[1].start.photometry && two[1].start.noise);
  EXPECT_EQ(two[1].start.photometry->gamma, 1.1);
  EXPECT_EQ(*two[1].start.noise, 2.);
  EXPECT_EQ(two[1].start.plane.rotation, startsFrom(2)[1].plane.rotation);
  // A marker that faces the camera has four starts: what is left after the first is its mirror image.
  const auto frontal = Fits().askedFor(startsFrom(3), withCode, settings);
  ASSERT_EQ(frontal.size(), 2u);
  EXPECT_LT((frontal[1].start.plane.rotation - mirrored(leaning(0.4, 0.)).rotation).norm(), 1e-12);
  // One that has not settled has said nothing.
  Fits fits;
  fits.isSettled = {false, true, true};
  EXPECT_FALSE(fits.askedFor(startsFrom(3), withCode, settings)[1].start.photometry);
  // A light that is known stays, and every such start is fitted.
  Few<FitStart> known = startsFrom(3);
  for (FitStart &start : known) {
    start.photometry = Photometry();
    start.photometry->gamma = 0.9;
  }
  const auto all = Fits().askedFor(known, withCode, settings);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[1].start.photometry->gamma, 0.9);
}

TEST(RankedFits, WhatLeadsNowhereIsLeftOut)
{
  int k = 0;
  ScriptedFitter fitter([&](const ScriptedFitter::Asked &asked) {
    return k++ == 1 ? std::nullopt : std::optional<FittedPose>(fitAt(asked.start));
  });
  const Few<FittedPose> fits = fitAll({}, startsFrom(3), withCode, FitSettings(), fitter);
  ASSERT_EQ(fits.size(), 2u);
  EXPECT_EQ(fits[1].plane.rotation, startsFrom(3)[2].plane.rotation);
  EXPECT_TRUE(rank({}, withCode, true, {}, fitter).fits.empty());
}

// All are judged by the noise of the least noisy, and in the light of the same surround; but each has the paper end
// where it is.
TEST(RankedFits, TheLeastSquaresAtOneNoiseComeFirst)
{
  ScriptedFitter fitter([](const ScriptedFitter::Asked &) { return std::nullopt; });
  Few<FittedPose> fits;
  const std::vector<double> noises = {3., 1.5, 2.};
  const std::vector<double> squares = {700., 900., 500.};
  for (std::size_t i = 0; i < noises.size(); ++i) {
    FittedPose fit = fitOf(leaning(0.4, static_cast<double>(i)));
    fit.noise = noises[i];
    fit.squares = squares[i];
    fit.photometry.unevenShare = 0.1 * noises[i];
    fit.photometry.endError = 0.2;
    fits.push_back(fit);
  }
  const RankedFits ranked = rank({}, withCode, true, fits, fitter);
  EXPECT_EQ(ranked.noise, 1.5);
  ASSERT_EQ(ranked.fits.size(), 3u);
  EXPECT_EQ(ranked.fits[0].squares, 500.);
  EXPECT_EQ(ranked.fits[1].squares, 700.);
  EXPECT_EQ(ranked.fits[2].squares, 900.);
  ASSERT_EQ(fitter.judged.size(), 3u);
  for (const ScriptedFitter::Judged &judged : fitter.judged) {
    EXPECT_EQ(judged.noise, 1.5);
    EXPECT_DOUBLE_EQ(judged.surround.unevenShare, 0.15);
    EXPECT_EQ(judged.surround.endError, 0.);
  }
}

// Nearly frontal poses that lean to opposite sides, 0.2 rad apart: one within 0.3 standard deviations.
TEST(RankedFits, PosesWithinTheirErrorAreOne)
{
  const MarkerPlane here = leaning(0.1, 0.3);
  const MarkerPlane there = leaning(-0.1, 0.3);
  EXPECT_TRUE(isSamePose(fitOf(here, 0.2 / 0.27), fitOf(there)));
  EXPECT_FALSE(isSamePose(fitOf(here, 0.2 / 0.33), fitOf(there)));
  // A marker that turns its back is not one that is seen, however little is known.
  MarkerPlane back = here;
  back.rotation = turn(M_PI, here.rotation.col(0)) * here.rotation;
  EXPECT_FALSE(isSamePose(fitOf(here, 10.), fitOf(back)));
}

// The likelihood has one maximum on each side of the line of sight: up to 60 degrees apart tilts have the same side.
TEST(RankedFits, PosesThatLeanToOneSideAreOne)
{
  constexpr double sharp = 1e-3; // rad
  for (const double degrees : {-50., 0., 50.}) {
    EXPECT_TRUE(isSamePose(fitOf(leaning(0.5, 1.), sharp), fitOf(leaning(0.3, 1. + vpMath::rad(degrees)))));
  }
  for (const double degrees : {-70., 70., 180.}) {
    EXPECT_FALSE(isSamePose(fitOf(leaning(0.5, 1.), sharp), fitOf(leaning(0.3, 1. + vpMath::rad(degrees)))));
  }
}

TEST(RankedFits, TheBestPoseAndTheBestOtherOneAreKept)
{
  RankedFits ranked;
  for (const double azimuth : {0., 0.1, 2., 3.}) { // the second is the first, the fourth another one but worse
    ranked.fits.push_back(fitOf(leaning(0.5, azimuth)));
  }
  const RankedFits all = ranked;
  keepTwo(ranked);
  ASSERT_EQ(ranked.fits.size(), 2u);
  EXPECT_EQ(ranked.fits[0].plane.rotation, all.fits[0].plane.rotation);
  EXPECT_EQ(ranked.fits[1].plane.rotation, all.fits[2].plane.rotation);
}

TEST(RankedFits, OneLightIsOneBlurAndOneGamma)
{
  Photometry light;
  light.gamma = 2.;
  Photometry other = light;
  other.blur.sigma = light.blur.sigma + 0.029;
  other.gamma = light.gamma * (1. - 0.055);
  EXPECT_TRUE(isSameLight(light, other));
  other.blur.sigma = light.blur.sigma - 0.031;
  EXPECT_FALSE(isSameLight(light, other));
  other.blur.sigma = light.blur.sigma;
  other.gamma = light.gamma * (1. + 0.065);
  EXPECT_FALSE(isSameLight(light, other));
}

// By few pixels: log-odds of 30, half the difference of squares in units of the noise's variance.
TEST(RankedFits, WhoIsFarBehindAndDoesNotCatchUpIsHopeless)
{
  constexpr double noise = 2.;
  const auto isHopelessBehind = [](double logOdds, bool isSettled, double decrementOdds) {
    const FittedPose best = fitOf(leaning(0.4, 0.));
    FittedPose fit = fitOf(leaning(0.4, M_PI));
    fit.squares = best.squares + 2. * noise * noise * logOdds;
    fit.isSettled = isSettled;
    fit.decrement = 2. * noise * noise * decrementOdds;
    return isHopeless(fit, best, noise);
  };
  EXPECT_FALSE(isHopelessBehind(29., true, 0.));
  EXPECT_TRUE(isHopelessBehind(31., true, 0.));
  // A settled fit takes no more steps; one that was cut off would, but what its next step brings is known roughly.
  EXPECT_TRUE(isHopelessBehind(31., true, 10.));
  EXPECT_FALSE(isHopelessBehind(39., false, 10.));
  EXPECT_TRUE(isHopelessBehind(41., false, 10.));
  EXPECT_FALSE(isHopelessBehind(59., false, 1000.));
  EXPECT_TRUE(isHopelessBehind(61., false, 1000.));
}

// Three pixels that share their noise say as much as one.
TEST(RankedFits, SharedNoiseTakesMoreToBeHopeless)
{
  FittedPose best = fitOf(leaning(0.4, 0.));
  best.sharing = 3.;
  FittedPose fit = fitOf(leaning(0.4, M_PI));
  fit.isSettled = true;
  fit.squares = best.squares + 2. * 89.;
  EXPECT_FALSE(isHopeless(fit, best, 1.));
  fit.squares = best.squares + 2. * 91.;
  EXPECT_TRUE(isHopeless(fit, best, 1.));
  FittedPose before = best;
  before.noise = 1.7;
  before.scale = 17.;
  EXPECT_EQ(Fits().askedFor(startsFrom(2), withCode, FitSettings(), before)[0].settings.rival->odds, 3. * 90.);
}
