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
 * Which fits a measurement makes, and what it says of their odds.
 */

#include "testScriptedMeasure.h"

#include "refine/fit_starts.h"

using namespace scripted_test;

namespace {
// How far on either side of the limit of gamma is looked: a limit that has moved by more is another one.
constexpr double within = 0.97;
constexpr double beyond = 1.03;

// Of a covered marker of which all is seen.
SeenParts allParts(const MarkerScene &scene)
{
  SeenParts seen;
  seen.plane = scene.plane();
  seen.directions = mostSamples;
  seen.ring.set();
  seen.track.set();
  seen.center.set();
  return seen;
}
} // namespace

TEST(MeasureFits, ADiscHasNoGammaOfItsOwn)
{
  for (const auto type : {vpCircleMarkerFamily::DISC, vpCircleMarkerFamily::RING, vpCircleMarkerFamily::GOLAY23}) {
    const vpCircleMarkerFamily family(type);
    const MarkerScene scene = tilted(family, 0.5);
    const Recognition marker = recognised(scene, family.isCoded() ? 8 : -1, false);
    const Outcome outcome = outcomeOf(scene, marker, true, [](FittedPose &, const ScriptedFitter::Asked &) {});
    for (const ScriptedFitter::Asked &fit : outcome.asked) {
      EXPECT_EQ(fit.settings.gammaAndSpread, type != vpCircleMarkerFamily::DISC) << family.getName();
      EXPECT_EQ(fit.settings.spinIsKnown, family.isCoded()) << family.getName();
    }
  }
}

// What few pixels say against a pose is enough for large markers, and is reported; of small ones all pixels are asked.
TEST(MeasureFits, HopelessPosesOfLargeMarkersAreNotRefined)
{
  constexpr double hopeless = 100.; // log-odds
  for (const double diameter : {39., 41.}) {
    const MarkerScene scene = tilted(coded, 0.5, diameter);
    const Outcome outcome =
        outcomeOf(scene, recognised(scene, 8, false), true, [&](FittedPose &fit, const ScriptedFitter::Asked &asked) {
          if (isTwinOf(fit.plane, scene) && !asked.settings.exactBends) {
            fit.squares += squaresOf(hopeless - oddsOfTwin);
          }
        });
    const bool isLarge = diameter > 40.;
    EXPECT_EQ(outcome.onAllPixels(), isLarge ? 1 : 2) << diameter;
    ASSERT_TRUE(outcome.measurement && outcome.measurement->second);
    EXPECT_NEAR(outcome.measurement->cost2 - outcome.measurement->cost, isLarge ? hopeless : oddsOfTwin, 1e-9);
  }
}

// Two poses of one marker stand in one light: where a fit says otherwise it was stuck, and starts again from the other.
TEST(MeasureFits, AStuckPoseIsFittedAgain)
{
  const MarkerScene scene = tilted(coded, 0.5);
  constexpr double oddsOfStuck = 25.;
  int fitsOfTwin = 0; // on all pixels
  const Outcome outcome =
      outcomeOf(scene, recognised(scene, 8, false), true, [&](FittedPose &fit, const ScriptedFitter::Asked &asked) {
        fit.photometry.gamma = 1.3;
        if (asked.settings.exactBends && isTwinOf(fit.plane, scene) && ++fitsOfTwin == 1) {
          fit.photometry.gamma = 0.8;
          fit.squares += squaresOf(oddsOfStuck - oddsOfTwin);
        }
      });
  EXPECT_EQ(fitsOfTwin, 2);
  ASSERT_TRUE(outcome.measurement && outcome.measurement->second);
  EXPECT_NEAR(outcome.measurement->cost2 - outcome.measurement->cost, oddsOfTwin, 1e-9);
  EXPECT_EQ(outcome.measurement->second->photometry.gamma, 1.3);
  const MarkerPlane mirror = mirrored(scene.plane());
  EXPECT_LT((outcome.asked.back().start.plane.rotation - mirror.rotation).norm(), 1e-9);
}

// By what a fit leaves; but not of small markers, nor of what was corrected or is covered in part.
TEST(MeasureFits, LightThatBendsIsFittedWhereThePixelsAskForIt)
{
  constexpr double much = 1e9; // grey levels^2
  const auto curved = [](double diameter, int hamming, bool isCovered, double bend) {
    const MarkerScene scene = tilted(coded, 0.5, diameter);
    Recognition marker = recognised(scene, 8, false);
    marker.code.hamming = hamming;
    if (isCovered) {
      marker.seen = allParts(scene);
    }
    const Outcome outcome =
        outcomeOf(scene, marker, true, [&](FittedPose &fit, const ScriptedFitter::Asked &) { fit.bendOfLight = bend; });
    return std::count_if(outcome.asked.begin(), outcome.asked.end(),
                         [](const auto &fit) { return fit.start.photometry && fit.start.photometry->lightCurvature; });
  };
  EXPECT_GT(curved(80., 0, false, much), 0);
  EXPECT_EQ(curved(80., 0, false, 0.), 0);
  EXPECT_EQ(curved(55., 0, false, much), 0);
  EXPECT_GT(curved(65., 0, false, much), 0);
  EXPECT_EQ(curved(80., 1, false, much), 0);
  EXPECT_EQ(curved(80., 0, true, much), 0);
}

// Without a second pose the first would be certain, whichever of the two it is.
TEST(MeasureFits, ThePoseThatNoFitCameToIsFitted)
{
  for (const double diameter : {30., 80.}) {
    const MarkerScene scene = tilted(coded, 0.5, diameter);
    int fitsOfTwin = 0; // on all pixels
    const Outcome outcome =
        outcomeOf(scene, recognised(scene, 8, false), true, [&](FittedPose &fit, const ScriptedFitter::Asked &asked) {
          if (asked.settings.exactBends && isTwinOf(fit.plane, scene) && ++fitsOfTwin == 1) {
            fit.plane = scene.plane();
          }
        });
    EXPECT_EQ(fitsOfTwin, 2) << diameter;
    ASSERT_TRUE(outcome.measurement && outcome.measurement->second) << diameter;
    EXPECT_TRUE(isTwinOf(outcome.measurement->second->plane, scene));
    EXPECT_NEAR(outcome.measurement->cost2 - outcome.measurement->cost, oddsOfTwin, 1e-9);
  }
}

// On paper that nearly faces the camera fits from both poses end in one. Where few pixels have said so of a clear
// marker, or the mirrored pose is far behind before any step, another fit would take its time for nothing.
TEST(MeasureFits, APoseThatIsTheOnlyOneIsNotFittedAgain)
{
  constexpr double hopeless = 61.; // log-odds: of which a step may take half
  for (const bool isCovered : {false, true}) {
    for (const double oddsAtStart : {0., hopeless}) {
      for (const double diameter : {39., 80.}) {
        const MarkerScene scene = tilted(coded, 0.5, diameter);
        Recognition marker = recognised(scene, 8, false);
        if (isCovered) {
          marker.seen = allParts(scene);
        }
        const Outcome outcome = outcomeOf(
            scene, marker, true, [&](FittedPose &fit, const ScriptedFitter::Asked &) { fit.plane = scene.plane(); },
            Deadline(), {}, [&](const FittedPose &fit) { return isTwinOf(fit.plane, scene) ? oddsAtStart : 0.; });
        // From both coarse poses, if they have not merged, and from the mirror image of what they led to.
        const bool isAsked = diameter < 40. || (isCovered && oddsAtStart < hopeless);
        EXPECT_EQ(outcome.onAllPixels(), isAsked ? 2 : 1) << isCovered << " " << oddsAtStart << " " << diameter;
        EXPECT_TRUE(outcome.measurement && !outcome.measurement->second);
      }
    }
  }
}

// Of a small marker a pose that was given up on its way may be the right one: it is fitted from the other's mirror
// image, and if that is better, the other one from its.
TEST(MeasureFits, GivenUpPosesOfSmallMarkersAreFittedAgain)
{
  for (const double diameter : {39., 41.}) {
    const MarkerScene scene = tilted(coded, 0.5, diameter);
    int fits = 0; // on all pixels
    const Outcome outcome =
        outcomeOf(scene, recognised(scene, 8, false), true, [&](FittedPose &fit, const ScriptedFitter::Asked &asked) {
          fits += asked.settings.exactBends ? 1 : 0;
          if (asked.settings.exactBends && fits <= 2 && isTwinOf(fit.plane, scene)) {
            fit.isSettled = false;
            fit.squares += squaresOf(50.);
          }
        });
    const bool isSmall = diameter < 40.;
    EXPECT_EQ(fits, isSmall ? 3 : 2) << diameter;
    ASSERT_TRUE(outcome.measurement && outcome.measurement->second) << diameter;
    EXPECT_NEAR(outcome.measurement->cost2 - outcome.measurement->cost, oddsOfTwin + (isSmall ? 0. : 50.), 1e-9);
  }
}

TEST(MeasureFits, ThePoseThatDoesNotComeToItsEndIsFittedAgainOnce)
{
  const MarkerScene scene = tilted(coded, 0.5, 30.);
  const Outcome outcome =
      outcomeOf(scene, recognised(scene, 8, false), true,
                [&](FittedPose &fit, const ScriptedFitter::Asked &) { fit.isSettled = !isTwinOf(fit.plane, scene); });
  EXPECT_EQ(outcome.onAllPixels(), 3);
}

TEST(MeasureFits, WhatBecomesTheBestHasItsMirrorImageFittedToo)
{
  const MarkerScene scene = tilted(coded, 0.5, 30.);
  int fits = 0; // on all pixels: at first both poses are stuck, the right one behind
  const Outcome outcome =
      outcomeOf(scene, recognised(scene, 8, false), true, [&](FittedPose &fit, const ScriptedFitter::Asked &asked) {
        fits += asked.settings.exactBends ? 1 : 0;
        if (asked.settings.exactBends && fits <= 2) {
          fit.isSettled = false;
          fit.squares += squaresOf(isTwinOf(fit.plane, scene) ? 50. : 80.);
        }
      });
  EXPECT_EQ(fits, 4);
  ASSERT_TRUE(outcome.measurement && outcome.measurement->second);
  EXPECT_FALSE(isTwinOf(outcome.measurement->first.plane, scene));
  EXPECT_NEAR(outcome.measurement->cost2 - outcome.measurement->cost, oddsOfTwin, 1e-9);
}

// The poses of an outline of which a part is missing may lead anywhere: one of a ring was 0.4 m nearer and hopeless,
// and the mirrored one came first with odds of e^187.
TEST(MeasureFits, TheOtherPoseOfACoveredRingIsTheMirrorImage)
{
  constexpr double oddsOfAstray = 100.;
  for (const double diameter : {30., 80.}) {
    const MarkerScene scene = tilted(ring, 0.5, diameter);
    Recognition marker = recognised(scene, -1, false);
    marker.seen = allParts(scene);
    MarkerPlane &astray = marker.poses[1];
    astray.rotation = turn(1., Eigen::Vector3d::UnitX());
    astray.center *= 0.8;
    const double nearer = astray.center.z();
    const Outcome outcome = outcomeOf(scene, marker, true, [&](FittedPose &fit, const ScriptedFitter::Asked &) {
      fit.noise = 0.5;
      fit.squares += fit.plane.center.z() < 1.1 * nearer ? squaresOf(oddsOfAstray) : 0.;
    });
    ASSERT_TRUE(outcome.measurement && outcome.measurement->second) << diameter;
    EXPECT_FALSE(isTwinOf(outcome.measurement->first.plane, scene)) << diameter;
    EXPECT_LT((outcome.measurement->second->plane.rotation - mirrored(scene.plane()).rotation).norm(), 1e-9)
        << diameter;
  }
}

// What is seen of it leaves noise, or it is none; of a marker with all of its outline more may be left.
TEST(MeasureFits, ACoveredRingLeavesNoiseAlone)
{
  const MarkerScene scene = tilted(ring, 0.5);
  for (const bool isCovered : {true, false}) {
    Recognition marker = recognised(scene, -1, false);
    if (isCovered) {
      marker.seen = allParts(scene);
    }
    const auto isMeasured = [&](double left, double blur) {
      const Alter alter = [&](FittedPose &fit, const ScriptedFitter::Asked &) {
        fit.noise = left * fit.photometry.tellableContrast();
        fit.photometry.blur.sigma = blur * 40.; // of the radius
      };
      return outcomeOf(scene, marker, true, alter).measurement.has_value();
    };
    EXPECT_TRUE(isMeasured(0.015, 0.05));
    EXPECT_EQ(isMeasured(0.03, 0.05), !isCovered);
    EXPECT_EQ(isMeasured(0.015, 0.09), !isCovered);
  }
}

// Bends cost precision: they are fitted where parts of the print pull the pose apart, and not where something covers
// it.
TEST(MeasureFits, BendsAreFittedWhereThePrintIsPulledApart)
{
  const MarkerScene scene = tilted(coded, 0.5);
  const auto isBent = [&](const Recognition &marker, double coherence) {
    const Outcome outcome = outcomeOf(scene, marker, true, [&](FittedPose &fit, const ScriptedFitter::Asked &asked) {
      fit.coherence = asked.settings.exactBends ? coherence : 1.;
    });
    return std::any_of(outcome.asked.begin(), outcome.asked.end(),
                       [](const ScriptedFitter::Asked &fit) { return fit.settings.bend; });
  };
  Recognition marker = recognised(scene, 8, false);
  EXPECT_FALSE(isBent(marker, 1.));
  EXPECT_TRUE(isBent(marker, 1.5));
  // A piece of the quiet zone is out of the image, or a quarter of the ring is covered and more.
  for (const bool isMostlySeen : {true, false}) {
    SeenParts seen = allParts(scene);
    for (std::size_t k = 0; k < mostSamples * (isMostlySeen ? 0.24 : 0.26); ++k) {
      seen.ring.reset(k);
    }
    marker.seen = seen;
    EXPECT_EQ(isBent(marker, 1.5), isMostlySeen);
  }
}

TEST(MeasureFits, LogOddsAreThoseOfTheNoise)
{
  const MarkerScene scene = tilted(coded, 0.5);
  for (const bool twinFirst : {false, true}) {
    const Outcome outcome =
        outcomeOf(scene, recognised(scene, 8, twinFirst), true, [](FittedPose &, const ScriptedFitter::Asked &) {});
    ASSERT_TRUE(outcome.measurement && outcome.measurement->second);
    EXPECT_FALSE(isTwinOf(outcome.measurement->first.plane, scene));
    EXPECT_NEAR(outcome.measurement->cost2 - outcome.measurement->cost, oddsOfTwin, 1e-9);
  }
}

// What is left beside a minimum varies by k = decrement / (2 noise^2), besides the log-odds' own variance 2 D: of the
// odds D as much counts as leaves a normal distribution its form, 2 D^2 / (2 D + k^2).
TEST(MeasureFits, UnrefinedLogOddsKnowHowFarThePosesAreFromTheirMinima)
{
  const MarkerScene scene = tilted(coded, 0.5);
  for (const double k : {0., 1., 5.}) {
    const Outcome outcome =
        outcomeOf(scene, recognised(scene, 8, false), false,
                  [&](FittedPose &fit, const ScriptedFitter::Asked &) { fit.decrement = squaresOf(k); });
    ASSERT_TRUE(outcome.measurement && outcome.measurement->second);
    const double expected = 2. * oddsOfTwin * oddsOfTwin / (2. * oddsOfTwin + k * k);
    EXPECT_NEAR(outcome.measurement->cost2 - outcome.measurement->cost, expected, 1e-9) << k;
  }
}
