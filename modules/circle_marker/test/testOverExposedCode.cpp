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
 * Tests of codes that over-exposed paper hides.
 */

#include "refine/over_exposed_code.h"

#include <gtest/gtest.h>

#include "decode/cyclic_code.h"
#include "testRoomTools.h"

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif
using namespace circle_marker;
using namespace room_test;

namespace {
constexpr unsigned int side = 120;
constexpr double blur = 0.7;
constexpr double noise = 2.;
constexpr double proof = 20.; // odds, ln, that a code needs: measure_proven.cpp

// Paper as bright as that, ink by its reflectance.
MarkerScene litScene(Random &random, const vpCircleMarkerFamily &family, double diameter, double white)
{
  const int id = static_cast<int>(random() % family.getNbIds());
  MarkerScene scene = markerScene(random, family, id, diameter, uniform(random, 0., 0.6), side);
  scene.white = white;
  scene.black = white / 6.;
  return scene;
}

vpImage<unsigned char> imageOf(const MarkerScene &scene, Random &random)
{
  return digitise(expose(side, side, blur, scene), noise, random);
}

std::optional<double> oddsOf(const vpImage<unsigned char> &I, const MarkerScene &scene, std::uint32_t word)
{
  FittedPose fit; // the true one
  fit.plane = scene.plane();
  fit.photometry.white = scene.white;
  fit.photometry.absorption = 1. - scene.black / scene.white;
  fit.photometry.blur.sigma = std::sqrt(blur * blur + 1. / 12.);
  fit.noise = noise;
  CodeImage track;
  return oddsIfOverExposed({I, CameraModel(scene.camera()), fit, scene.frame()}, scene.family, word, track);
}
} // namespace

TEST(OverExposedCode, WhatShowsIsProven)
{
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31, vpCircleMarkerFamily::BCH31R}) {
    const vpCircleMarkerFamily family(type);
    for (int i = 0; i < 10; ++i) {
      const MarkerScene scene = litScene(random, family, uniform(random, 24., 34.), uniform(random, 300., 400.));
      const auto odds = oddsOf(imageOf(scene, random), scene, scene.word);
      ASSERT_TRUE(odds) << family.getName() << " " << i;
      EXPECT_GT(*odds, proof) << family.getName() << " white " << scene.white;
    }
  }
}

// A word that lacks some of the black sectors is not proven: as long as they show it leaves them unexplained, and where
// they do not, and it is read, the true one explains as much.
TEST(OverExposedCode, WordsThatLackBlackSectorsAreNot)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  int words = 0;
  int hidden = 0; // pairs of words of which neither is much likelier
  for (int i = 0; i < 40; ++i) {
    const MarkerScene scene = litScene(random, family, uniform(random, 12., 24.), uniform(random, 400., 1200.));
    const vpImage<unsigned char> I = imageOf(scene, random);
    codeOf(family).forEachCodeword([&](std::uint32_t word) {
      const bool lacksSome = word != scene.word && (word & ~scene.word) == 0;
      if (!lacksSome) {
        return;
      }
      const auto odds = oddsOf(I, scene, word);
      ASSERT_TRUE(odds);
      EXPECT_LT(*odds, proof) << "white " << scene.white << " word " << word << " of " << scene.word;
      ++words;
      hidden += std::abs(*odds) < 1. ? 1 : 0;
    });
  }
  EXPECT_GT(words, 20);
  EXPECT_GT(hidden, 0) << "all sectors show in all light: nothing was tested";
}

TEST(OverExposedCode, WhatIsHiddenProvesNothing)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  for (int i = 0; i < 10; ++i) {
    MarkerScene scene = litScene(random, family, uniform(random, 12., 16.), 2000.);
    const vpImage<unsigned char> I = imageOf(scene, random);
    scene.word = family.getCodeword(static_cast<int>(random() % family.getNbIds()));
    const auto odds = oddsOf(I, scene, scene.word);
    ASSERT_TRUE(odds);
    EXPECT_LT(*odds, proof) << "of any word";
  }
}

// Where the sensor tells how bright paper is, or sectors are long, there is nothing to be asked.
TEST(OverExposedCode, NotAskedWhereNothingIsHidden)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  MarkerScene scene = litScene(random, family, 20., 200.);
  EXPECT_FALSE(oddsOf(imageOf(scene, random), scene, scene.word)) << "not over-exposed";
  scene = litScene(random, family, 20., 400.);
  EXPECT_TRUE(oddsOf(imageOf(scene, random), scene, scene.word));
  scene.principal.x() -= 0.5 * side;
  EXPECT_FALSE(oddsOf(imageOf(scene, random), scene, scene.word)) << "at the image's border";
  scene = litScene(random, family, 105., 400.);
  EXPECT_FALSE(oddsOf(imageOf(scene, random), scene, scene.word)) << "long sectors";
}
