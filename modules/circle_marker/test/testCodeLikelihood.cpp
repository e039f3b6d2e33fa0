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
 * Tests of the likelihood of all codewords at a measured pose.
 */

#include "refine/code_likelihood.h"

#include <gtest/gtest.h>

#include "testRoomTools.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr unsigned int side = 160;
constexpr double blur = 0.7;
constexpr double noise = 2.;

// The true pose, light and blur; its x axis is turned away from the marker's.
FittedPose fitOf(const MarkerScene &scene, double spin)
{
  FittedPose fit;
  fit.plane = scene.plane();
  fit.plane.spin(-spin);
  fit.photometry.white = scene.white;
  fit.photometry.absorption = 1. - scene.black / scene.white;
  fit.photometry.blur.sigma = std::sqrt(blur * blur + 1. / 12.);
  fit.noise = noise;
  return fit;
}

vpImage<unsigned char> imageOf(const MarkerScene &scene, Random &random)
{
  return digitise(expose(side, side, blur, scene), noise, random);
}

std::optional<LikelyCode> read(const vpImage<unsigned char> &I, const MarkerScene &scene, double spin)
{
  CodeImage track;
  return mostLikelyCode({I, CameraModel(scene.camera()), fitOf(scene, spin), scene.frame()}, scene.family, track);
}
} // namespace

TEST(CodeLikelihood, SmallCodesAreReadWithTheirSpin)
{
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31, vpCircleMarkerFamily::BCH31R}) {
    const vpCircleMarkerFamily family(type);
    const double pitch = 2. * M_PI / family.getNbSectors();
    for (int i = 0; i < 20; ++i) {
      const int id = static_cast<int>(random() % family.getNbIds());
      const double tilt = uniform(random, 0., 1.);
      const double minor = uniform(random, 11., 40.);
      const MarkerScene scene = markerScene(random, family, id, minor / std::cos(tilt), tilt, side);
      const double spin = uniform(random, -M_PI, M_PI);
      const auto code = read(imageOf(scene, random), scene, spin);
      ASSERT_TRUE(code);
      EXPECT_EQ(code->best.id, id) << family.getName() << " minor axis " << minor << " tilt " << tilt;
      EXPECT_LT(std::abs(std::remainder(code->best.spin - spin, 2. * M_PI)), 0.25 * pitch);
      EXPECT_GT(code->odds, 15.) << family.getName() << " minor axis " << minor << " tilt " << tilt;
      EXPECT_LT(code->unexplained, 1.2) << family.getName() << " minor axis " << minor << " tilt " << tilt;
    }
  }
}

// A pixel sees the sectors of both sides of so narrow a marker.
TEST(CodeLikelihood, CodesAtGrazingAnglesAreReadWithTheirSpin)
{
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31R}) {
    const vpCircleMarkerFamily family(type);
    const double pitch = 2. * M_PI / family.getNbSectors();
    for (int i = 0; i < 20; ++i) {
      const int id = static_cast<int>(random() % family.getNbIds());
      const double minor = uniform(random, 4.5, 8.);
      const double tilt = std::acos(minor / uniform(random, 24., 40.));
      MarkerScene scene = markerScene(random, family, id, minor / std::cos(tilt), tilt, side);
      scene.sheet = 1e9;                                                    // what lies beyond it would be seen
      const double spin = pitch / 8. * static_cast<double>(random() % 100); // one of those that are tried
      const auto code = read(imageOf(scene, random), scene, spin);
      ASSERT_TRUE(code);
      EXPECT_EQ(code->best.id, id) << family.getName() << " minor axis " << minor << " tilt " << tilt;
      EXPECT_LT(std::abs(std::remainder(code->best.spin - spin, 2. * M_PI)), 0.15 * pitch);
      EXPECT_GT(code->odds, 25.) << family.getName() << " minor axis " << minor << " tilt " << tilt;
      EXPECT_LT(code->unexplained, 1.) << family.getName() << " minor axis " << minor << " tilt " << tilt;
      EXPECT_GT(code->unexplained, 0.1) << "squares of residuals that are not all of them";
    }
  }
}

// And the ground beyond the sheet, which is as near as the other side's sectors.
TEST(CodeLikelihood, TheGroundIsSeenFromANarrowTrack)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  double left = 0.; // of all
  double leftAsIfPaperWentOn = 0.;
  for (int i = 0; i < 20; ++i) {
    const int id = static_cast<int>(random() % family.getNbIds());
    const double minor = uniform(random, 4., 5.);
    const double tilt = std::acos(minor / uniform(random, 24., 40.));
    MarkerScene scene = markerScene(random, family, id, minor / std::cos(tilt), tilt, side);
    scene.surround = 20.;
    const vpImage<unsigned char> I = imageOf(scene, random);
    FittedPose fit = fitOf(scene, 0.);
    CodeImage track;
    const CameraModel camera(scene.camera());
    fit.photometry.surround = {{0., 1.}}; // the sheet is square
    const auto code = mostLikelyCode({I, camera, fit, scene.frame()}, family, track);
    fit.photometry.surround = {{0., 0.}};
    const auto asIfPaperWentOn = mostLikelyCode({I, camera, fit, scene.frame()}, family, track);
    ASSERT_TRUE(code && asIfPaperWentOn);
    EXPECT_EQ(code->best.id, id) << "minor axis " << minor << " tilt " << tilt;
    EXPECT_GT(code->odds, 25.) << "minor axis " << minor << " tilt " << tilt;
    EXPECT_LT(code->unexplained, 1.) << "minor axis " << minor << " tilt " << tilt;
    left += code->unexplained;
    leftAsIfPaperWentOn += asIfPaperWentOn->unexplained;
  }
  EXPECT_GT(leftAsIfPaperWentOn, 2. * left);
}

// A word that is no codeword, nor near one, is not explained by any.
TEST(CodeLikelihood, WhatIsNoCodewordIsNotExplained)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::BCH31R);
  for (int i = 0; i < 20; ++i) {
    MarkerScene scene = markerScene(random, family, 0, uniform(random, 30., 60.), uniform(random, 0., 0.8), side);
    scene.word ^= 0x1f0f0000; // of 31 sectors nine others: codewords differ in eleven at least
    const auto code = read(imageOf(scene, random), scene, 0.);
    ASSERT_TRUE(code);
    EXPECT_GT(code->unexplained, 2.);
  }
}

// A ring around a grey spot, or with another one inside, is no marker, and not the one that is least unlike it either.
TEST(CodeLikelihood, AnEvenTrackIsNoCode)
{
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31}) {
    const vpCircleMarkerFamily family(type);
    for (const bool isBlack : {false, true}) {
      MarkerScene scene = markerScene(random, family, 0, uniform(random, 15., 40.), uniform(random, 0., 0.8), side);
      scene.word = isBlack ? (1U << family.getNbSectors()) - 1 : 0;
      const auto code = read(imageOf(scene, random), scene, 0.);
      ASSERT_TRUE(code);
      EXPECT_EQ(code->best.id, -1) << family.getName() << (isBlack ? ", black" : ", white");
    }
  }
}

// Over the variance of the noise.
TEST(CodeLikelihood, OddsFallWithTheNoise)
{
  Random random = randomOfTest();
  const MarkerScene scene = markerScene(random, vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23), 5, 20., 0.3, side);
  const vpImage<unsigned char> I = imageOf(scene, random);
  FittedPose fit = fitOf(scene, 0.);
  CodeImage track;
  double last = HUGE_VAL;
  for (const double believed : {2., 20., 40., 80.}) {
    fit.noise = believed;
    const auto code = mostLikelyCode({I, CameraModel(scene.camera()), fit, scene.frame()}, scene.family, track);
    ASSERT_TRUE(code);
    EXPECT_LT(code->odds, last);
    last = code->odds;
  }
}

// Over the number of pixels that share it.
TEST(CodeLikelihood, SharedNoiseLowersTheOdds)
{
  Random random = randomOfTest();
  const MarkerScene scene = markerScene(random, vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23), 5, 20., 0.3, side);
  const vpImage<unsigned char> I = imageOf(scene, random);
  FittedPose fit = fitOf(scene, 2.);
  CodeImage track;
  const auto oddsIfShared = [&](double sharing) {
    fit.sharing = sharing;
    const auto code = mostLikelyCode({I, CameraModel(scene.camera()), fit, scene.frame()}, scene.family, track);
    return code ? code->odds : 0.;
  };
  const double independent = oddsIfShared(1.);
  ASSERT_GT(independent, 10.);
  EXPECT_NEAR(oddsIfShared(4.), independent / 4., 1e-9 * independent);
}

// Paper that is a little brighter than the sensor can tell is taken for as bright as it is.
TEST(CodeLikelihood, ALittleOverExposureHidesNothing)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  for (int i = 0; i < 20; ++i) {
    const int id = static_cast<int>(random() % family.getNbIds());
    MarkerScene scene = markerScene(random, family, id, uniform(random, 14., 25.), 0.3, side);
    scene.white = uniform(random, 256., 270.);
    scene.black = 60.;
    const auto code = read(imageOf(scene, random), scene, 0.);
    ASSERT_TRUE(code);
    EXPECT_EQ(code->best.id, id) << "paper " << scene.white;
    EXPECT_GT(code->odds, 15.) << "paper " << scene.white;
    EXPECT_LT(code->unexplained, 1.2) << "paper " << scene.white;
  }
}

// The light that a shadow leaves is known: codes are read across its edge as elsewhere.
TEST(CodeLikelihood, AcrossTheEdgeOfAShadow)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  for (int i = 0; i < 20; ++i) {
    const int id = static_cast<int>(random() % family.getNbIds());
    const MarkerScene scene =
        markerScene(random, family, id, uniform(random, 16., 30.), uniform(random, 0., 0.8), side);
    const ImageFrame frame = scene.frame();
    FittedPose fit = fitOf(scene, 0.);
    Shadow shadow;
    shadow.factor = uniform(random, 0.3, 0.7);
    shadow.direction = uniform(random, -M_PI, M_PI);
    shadow.edge = uniform(random, -0.3, 0.3);
    const double softness = 1. / frame.size;
    shadow.softness = std::hypot(1., blur) / frame.size; // in the picture
    const auto shaded = [&](double u, double v) {
      const double beyond = (u - frame.center.x()) / frame.size * std::cos(shadow.direction) +
                            (v - frame.center.y()) / frame.size * std::sin(shadow.direction) - shadow.edge;
      return scene(u, v) * (1. - (1. - shadow.factor) * 0.5 * std::erfc(-beyond / softness * M_SQRT1_2));
    };
    const vpImage<unsigned char> I = digitise(expose(side, side, blur, shaded), noise, random);
    CodeImage track;
    const CameraModel camera(scene.camera());
    const auto inEvenLight = mostLikelyCode({I, camera, fit, frame}, family, track);
    fit.photometry.shadow = shadow;
    const auto code = mostLikelyCode({I, camera, fit, frame}, family, track);
    ASSERT_TRUE(code && inEvenLight);
    EXPECT_EQ(code->best.id, id) << "factor " << shadow.factor << " edge " << shadow.edge;
    EXPECT_GT(code->odds, 15.) << "factor " << shadow.factor << " edge " << shadow.edge;
    EXPECT_LT(code->unexplained, 1.3) << "factor " << shadow.factor << " edge " << shadow.edge;
    EXPECT_TRUE(inEvenLight->best.id != id || inEvenLight->unexplained > 2. * code->unexplained) << "without it";
  }
}

TEST(CodeLikelihood, ReadUnderAReflection)
{
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31, vpCircleMarkerFamily::BCH31R}) {
    const vpCircleMarkerFamily family(type);
    const int id = static_cast<int>(random() % family.getNbIds());
    const MarkerScene scene =
        markerScene(random, family, id, uniform(random, 16., 30.), uniform(random, 0., 0.8), side);
    const ImageFrame frame = scene.frame();
    const double added = uniform(random, 0.5, 0.7) * (scene.white - scene.black);
    const auto glossy = [&](double u, double v) { // a spot at (0.55, -0.55) radii, as wide as that is far from the axes
      const Eigen::Vector2d q = (Eigen::Vector2d(u, v) - frame.center) / frame.size;
      return 0.6 * scene(u, v) + added * std::exp(-0.5 * (q / 0.55 - Eigen::Vector2d(1., -1.)).squaredNorm());
    };
    const vpImage<unsigned char> I = digitise(expose(side, side, blur, glossy), noise, random);
    FittedPose fit = fitOf(scene, 0.);
    fit.photometry.white = 0.6 * scene.white;
    UnevenLight light;
    light.center = frame.center;
    light.toSheet = Eigen::Matrix2d::Identity() / frame.size;
    light.white[0] = light.meanWhite = fit.photometry.white;
    light.step[0] = light.meanStep = 0.6 * (scene.white - scene.black);
    light.white[1 + 3 + UnevenLight::inRow] = added; // row 1 and column 3 of the grid, by 0.55 from -1.1 on
    CodeImage track;
    const CameraModel camera(scene.camera());
    const auto asIfEven = mostLikelyCode({I, camera, fit, frame}, family, track);
    const auto code = mostLikelyCode({I, camera, fit, frame, &light}, family, track);
    ASSERT_TRUE(code);
    EXPECT_EQ(code->best.id, id);
    EXPECT_GT(code->odds, 15.);
    EXPECT_LT(code->unexplained, 1.3);
    EXPECT_TRUE(!asIfEven || asIfEven->best.id != id || asIfEven->unexplained > 3. * code->unexplained) << "without it";
  }
}

TEST(CodeLikelihood, NoneWhereTheModelDoesNotHold)
{
  Random random = randomOfTest();
  const MarkerScene scene = markerScene(random, vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23), 5, 30., 0.3, side);
  const vpImage<unsigned char> I = imageOf(scene, random);
  const CameraModel camera(scene.camera());
  CodeImage track;
  FittedPose fit = fitOf(scene, 0.);
  ASSERT_TRUE(mostLikelyCode({I, camera, fit, scene.frame()}, scene.family, track));
  fit.photometry.white = 400.;
  EXPECT_TRUE(mostLikelyCode({I, camera, fit, scene.frame()}, scene.family, track)) << "no pixel is as bright as that";
  vpImage<unsigned char> tooBright = I;
  for (unsigned int i = 0; i < tooBright.getSize(); ++i) {
    tooBright.bitmap[i] = static_cast<unsigned char>(std::min(2. * I.bitmap[i], 255.));
  }
  EXPECT_FALSE(mostLikelyCode({tooBright, camera, fit, scene.frame()}, scene.family, track)) << "over-exposed";
  fit = fitOf(scene, 0.);
  fit.plane.center.x() += 0.55 * side / scene.focal * fit.plane.center.z();
  EXPECT_FALSE(mostLikelyCode({I, camera, fit, scene.frame()}, scene.family, track)) << "at the image's border";
}
