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
 * Test of fits of a marker in light that bends over it.
 */

#include "refine/curved_light.h"
#include "refine/measure.h"

#include <gtest/gtest.h>

#include "testFitTools.h"

using namespace circle_marker;
using namespace fit_test;
using namespace room_test;

namespace {
//! The marker in light that bends besides.
void bendLight(const Eigen::Vector3d &curvature, Case &made)
{
  for (FitPixel &pixel : made.pixels) {
    const Eigen::Vector2d at = pixel.offset.cast<double>();
    const Eigen::Vector3d terms(at.x() * at.x(), at.x() * at.y(), at.y() * at.y());
    pixel.grey *= static_cast<float>(1. + curvature.dot(terms));
  }
}

//! Whether a marker asks for light that bends, and whether it is then fitted so.
struct Told
{
  int asked = 0;
  int fitted = 0;
};

Told toldIn(const Eigen::Vector3d &curvature, const vpCircleMarkerFamily &family, int count, Random &random)
{
  const vpImage<unsigned char> I(side, side, 0);
  Told told;
  for (int i = 0; i < count; ++i) {
    const int id = randomId(random, family);
    Case made =
        makeCase(markerScene(random, family, id, uniform(random, 60., 90.), uniform(random, 0.2, 0.9), side), id, I);
    fillFromModel(made, Light(), BlurParameters(), 2., random);
    bendLight(curvature, made);
    MeasureMemory memory;
    const FitSettings settings = settingsOf(family);
    const auto fit =
        memory.fitter->fitPose(made.pixels, {made.scene.plane(), Photometry(), std::nullopt}, made.pattern, settings);
    EXPECT_TRUE(fit);
    if (fit && isLightCurved(*fit)) {
      ++told.asked;
      RankedFits ranked;
      ranked.fits.push_back(*fit);
      ranked.noise = fit->noise;
      const RankedFits curved = fitCurvedLight(made.pixels, ranked, made.pattern, settings, *memory.fitter);
      told.fitted += curved.fits[0].photometry.lightCurvature ? 1 : 0;
    }
  }
  return told;
}
} // namespace

TEST(CurvedLight, IsToldWhereItFallsOff)
{
  Random random = randomOfTest();
  constexpr int count = 200;
  for (const vpCircleMarkerFamily::vpType type : families) {
    const vpCircleMarkerFamily family(type);
    const Told plane = toldIn(Eigen::Vector3d::Zero(), family, count, random);
    const Told lens = toldIn(Eigen::Vector3d(-0.03, 0., -0.03), family, count / 5, random); // in the picture's middle
    const Told aside = toldIn(Eigen::Vector3d(0.01, 0., -0.03), family, count / 5, random); // and far from it
    const Told halo = toldIn(Eigen::Vector3d(0.03, 0., 0.03), family, count / 5, random);   // brighter beside black
    RecordProperty(family.getName(), std::to_string(plane.asked) + " by chance, " + std::to_string(lens.fitted) + ", " +
                                         std::to_string(aside.fitted) + ", " + std::to_string(halo.fitted));
    EXPECT_LT(plane.asked, 10) << family.getName(); // 2 expected
    EXPECT_LE(plane.fitted, 2) << family.getName();
    if (family.getType() == vpCircleMarkerFamily::DISC) { // its one edge hardly tells light that bends from its size
      continue;
    }
    EXPECT_EQ(lens.fitted, count / 5) << family.getName();
    EXPECT_GE(aside.fitted, count / 5 - 2) << family.getName();
    EXPECT_EQ(halo.fitted, 0) << family.getName();
  }
}

// What is left tells what a fit with such light gains: no more than that, and about half of it or more. (Of a lone
// edge hardly anything: light that bends looks like another size of it.)
TEST(CurvedLight, WhatIsLeftTellsTheGain)
{
  Random random = randomOfTest();
  const vpImage<unsigned char> I(side, side, 0);
  for (const vpCircleMarkerFamily::vpType type : families) {
    const vpCircleMarkerFamily family(type);
    if (type == vpCircleMarkerFamily::DISC) {
      continue;
    }
    double shares = 0.;
    constexpr int count = 40;
    for (int i = 0; i < count; ++i) {
      const int id = randomId(random, family);
      Case made =
          makeCase(markerScene(random, family, id, uniform(random, 60., 90.), uniform(random, 0.2, 0.9), side), id, I);
      fillFromModel(made, Light(), BlurParameters(), 2., random);
      bendLight(Eigen::Vector3d(-0.02, 0., -0.02), made);
      const std::unique_ptr<Fitter> fitter = makeFitter();
      const FitSettings settings = settingsOf(family);
      FitStart start = {made.scene.plane(), Photometry(), std::nullopt};
      const auto plane = fitter->fitPose(made.pixels, start, made.pattern, settings);
      start.photometry->lightCurvature = Eigen::Vector3d::Zero();
      const auto curved = fitter->fitPose(made.pixels, start, made.pattern, settings);
      ASSERT_TRUE(plane && curved) << family.getName() << " " << i;
      const auto squaresOf = [&](const FittedPose &fit) {
        return fitter->robustSquares(made.pixels, fit, made.pattern, fit.photometry, curved->noise, true);
      };
      const double gain = squaresOf(*plane) - squaresOf(*curved);
      const double chance = 4. * curved->noise * curved->noise; // priors, and steps that end before the maximum
      EXPECT_LT(plane->bendOfLight, 1.1 * gain + chance) << family.getName() << " " << i;
      shares += plane->bendOfLight / gain / count;
    }
    RecordProperty(family.getName(), std::to_string(shares));
    EXPECT_GT(shares, 0.4) << family.getName();
  }
}

TEST(CurvedLight, FallsOffFromSomewhere)
{
  Photometry light;
  EXPECT_FALSE(fallsOff(light));
  light.lightCurvature = Eigen::Vector3d(-0.02, 0., -0.02);
  EXPECT_TRUE(fallsOff(light));
  light.lightCurvature = Eigen::Vector3d(0.02, 0., 0.01);
  EXPECT_FALSE(fallsOff(light));
  light.lightCurvature = Eigen::Vector3d(0., 0.02, 0.); // eigenvalues 0.01 and -0.01
  EXPECT_TRUE(fallsOff(light));
}

TEST(CurvedLight, PosesAreExactInIt)
{
  Random random = randomOfTest();
  const vpImage<unsigned char> I(side, side, 0);
  for (const vpCircleMarkerFamily::vpType type : families) {
    const vpCircleMarkerFamily family(type);
    for (int i = 0; i < 10; ++i) {
      const int id = randomId(random, family);
      Case made =
          makeCase(markerScene(random, family, id, uniform(random, 60., 90.), uniform(random, 0.2, 0.9), side), id, I);
      fillFromModel(made, Light(), BlurParameters(), 0., random);
      const Eigen::Vector3d curvature(uniform(random, -0.05, 0.), uniform(random, -0.03, 0.03),
                                      uniform(random, -0.05, 0.));
      bendLight(curvature, made);
      FitSettings settings = settingsOf(family);
      settings.exactBends = false;
      settings.convergence = 0.0003;
      settings.mostIterations = 300; // a lone edge hardly tells it from gamma
      FitMemory memory;
      FitStart start = {made.scene.plane(), Photometry(), std::nullopt};
      start.photometry->lightCurvature = Eigen::Vector3d::Zero();
      const auto fit = fitPose(made.pixels, start, made.pattern, settings, memory);
      ASSERT_TRUE(fit && fit->photometry.lightCurvature) << family.getName() << " " << i;
      const MarkerPlane truth = made.scene.plane();
      const double disc = type == vpCircleMarkerFamily::DISC ? 20. : 1.; // its one edge tells little of the light
      EXPECT_LT((*fit->photometry.lightCurvature - curvature).norm(), disc * 1e-3) << family.getName() << " " << i;
      EXPECT_LT((fit->plane.center - truth.center).norm() / truth.center.z(), disc * 5e-6) << family.getName() << i;
      EXPECT_LT((fit->plane.rotation.col(2) - truth.rotation.col(2)).norm(), 2e-5) << family.getName() << " " << i;
    }
  }
}
