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
 * What is taken for a measurement: every limit, from both sides.
 */

#include "testScriptedMeasure.h"

using namespace scripted_test;

namespace {
// How far on either side of a limit is looked: a limit that has moved by more is another one.
constexpr double within = 0.97;
constexpr double beyond = 1.03;

//! Whether a marker is measured whose fits on all pixels, or on few ones without refinement, are altered.
bool isMeasured(const MarkerScene &scene, const std::function<void(FittedPose &)> &alter, bool refine = true)
{
  const Recognition marker = recognised(scene, scene.family.isCoded() ? 8 : -1, false);
  const Outcome outcome = outcomeOf(scene, marker, refine, [&](FittedPose &fit, const ScriptedFitter::Asked &asked) {
    if (asked.settings.exactBends == refine) {
      alter(fit);
    }
  });
  return outcome.measurement.has_value();
}

//! A limit of what a fit may say, and how a fit says as much.
struct Limit
{
  const char *name;
  double most;
  std::function<void(FittedPose &, double)> set;
};

// The limits of what light, ink and paper may be: teeth on a ring, stripes and the like are explained beyond them only.
const std::vector<Limit> limits = {
    {"ink spread outward, radii", 0.03, [](FittedPose &fit, double x) { fit.photometry.blur.spread = x; }},
    {"ink spread inward, radii", 0.03, [](FittedPose &fit, double x) { fit.photometry.blur.spread = -x; }},
    {"bow", 0.12, [](FittedPose &fit, double x) { fit.plane.bend.bow = -x; }},
    {"saddle", 0.12, [](FittedPose &fit, double x) { fit.plane.bend.saddle = Eigen::Vector2d(0.6 * x, 0.8 * x); }},
    {"bow and saddle", 0.12,
     [](FittedPose &fit, double x) {
       fit.plane.bend.bow = 0.6 * x;
       fit.plane.bend.saddle.x() = 0.8 * x;
     }},
    {"blur, of a radius of 40 pixels", 0.43 * 40., [](FittedPose &fit, double x) { fit.photometry.blur.sigma = x; }},
    {"blur along a motion, of a radius of 40 pixels", 0.43 * 40.,
     [](FittedPose &fit, double x) {
       fit.photometry.blur.elongation = Eigen::Vector2d(0.5, 0.);
       fit.photometry.blur.sigma = x / std::exp(0.5);
     }},
    {"nearer than was seen", 1.5, [](FittedPose &fit, double x) { fit.plane.center /= x; }},
    {"farther than was seen", 1.5, [](FittedPose &fit, double x) { fit.plane.center *= x; }},
    {"gradient of the light", 1.,
     [](FittedPose &fit, double x) { fit.photometry.lightGradient = x * Eigen::Vector2d(0., -1.); }},
};
} // namespace

TEST(MeasureLimits, LightInkAndPaperAreWhatTheyCanBe)
{
  for (const vpCircleMarkerFamily &family : {coded, ring}) {
    const MarkerScene scene = tilted(family, 0.5);
    for (const Limit &limit : limits) {
      EXPECT_TRUE(isMeasured(scene, [&](FittedPose &fit) { limit.set(fit, within * limit.most); })) << limit.name;
      EXPECT_FALSE(isMeasured(scene, [&](FittedPose &fit) { limit.set(fit, beyond * limit.most); })) << limit.name;
    }
  }
}

// A plain ring whose ink would have spread by more is another ring; in a blur edges are not known as well.
TEST(MeasureLimits, RingsOfAnotherRatioAreToldByTheirInk)
{
  constexpr double wide = 3.; // pixels, of a radius of 40
  struct Case
  {
    double blur;
    double most; // outer radii
  };
  const MarkerScene scene = tilted(ring, 0.5);
  const CameraModel camera(scene.camera());
  for (const Case &limit : {Case{0.7, 0.01}, Case{wide, 0.3 * wide / 40.}}) {
    FittedPose fit;
    fit.plane = scene.plane();
    fit.photometry.blur.sigma = limit.blur;
    for (const double spread : {limit.most, -limit.most}) {
      fit.photometry.blur.spread = 0.98 * spread;
      EXPECT_FALSE(isOtherRing(recognised(scene, -1, false), fit, camera)) << spread;
      fit.photometry.blur.spread = 1.02 * spread;
      EXPECT_TRUE(isOtherRing(recognised(scene, -1, false), fit, camera)) << spread;
      EXPECT_FALSE(isOtherRing(recognised(tilted(coded, 0.5), 8, false), fit, camera)) << spread;
    }
  }
}

// A tilted marker's image is narrow, and the light changes across it by less than along it.
TEST(MeasureLimits, LightIsJudgedOnTheMarkerAsItIsSeen)
{
  const MarkerScene scene = tilted(coded, 1.05);
  const auto isMeasuredWith = [&](const Eigen::Vector2d &gradient) {
    return isMeasured(scene, [&](FittedPose &fit) { fit.photometry.lightGradient = gradient; });
  };
  EXPECT_TRUE(isMeasuredWith(Eigen::Vector2d(1.5, 0.)));
  EXPECT_FALSE(isMeasuredWith(Eigen::Vector2d(0., 1.5)));
  EXPECT_FALSE(isMeasuredWith(Eigen::Vector2d(2.5, 0.)));
}

TEST(MeasureLimits, TheImageIsExplained)
{
  struct Case
  {
    const vpCircleMarkerFamily &family;
    bool refine;
    double leastCorrelation;
  };
  for (const Case &least : {Case{coded, true, 0.85}, Case{ring, true, 0.94}, Case{coded, false, 0.6}}) {
    const MarkerScene scene = tilted(least.family, 0.5);
    const auto isMeasuredWith = [&](double correlation, double inliers) {
      return isMeasured(
          scene,
          [&](FittedPose &fit) {
            fit.correlation = correlation;
            fit.inliers = inliers;
          },
          least.refine);
    };
    EXPECT_TRUE(isMeasuredWith(least.leastCorrelation + 0.01, 0.51)) << least.leastCorrelation;
    EXPECT_FALSE(isMeasuredWith(least.leastCorrelation - 0.01, 0.51)) << least.leastCorrelation;
    EXPECT_FALSE(isMeasuredWith(least.leastCorrelation + 0.01, 0.49)) << least.leastCorrelation;
  }
}

// A ring in the sheet around it is explained by a gamma that no camera has; of a code the gamma is hardly known.
TEST(MeasureLimits, RingsAreSeenByCameras)
{
  const auto isMeasuredWith = [](const vpCircleMarkerFamily &family, double logGamma, double correlation) {
    return isMeasured(tilted(family, 0.5), [&](FittedPose &fit) {
      fit.photometry.gamma = std::exp(logGamma);
      fit.correlation = correlation;
    });
  };
  for (const double sign : {-1., 1.}) {
    EXPECT_TRUE(isMeasuredWith(ring, sign * within, 0.985));
    EXPECT_FALSE(isMeasuredWith(ring, sign * beyond, 0.985));
    EXPECT_TRUE(isMeasuredWith(ring, sign * beyond, 0.995));
    EXPECT_TRUE(isMeasuredWith(coded, sign * beyond, 0.985));
  }
}

TEST(MeasureLimits, CodesInDoubtAreNotFollowedFar)
{
  const MarkerScene scene = tilted(coded, 0.5);
  Recognition marker = recognised(scene, 8, false);
  for (const bool isCertain : {true, false}) {
    marker.isCertain = isCertain;
    for (const double correlation : {0.74, 0.76}) {
      const Outcome outcome = outcomeOf(scene, marker, true, [&](FittedPose &fit, const ScriptedFitter::Asked &asked) {
        fit.correlation = asked.settings.exactBends ? 0.98 : correlation;
      });
      EXPECT_EQ(outcome.measurement.has_value(), isCertain || correlation > 0.75);
    }
  }
}

// The pose that the deadline cut off may have been the better one.
TEST(MeasureLimits, WhatTheDeadlineStoppedIsNotReported)
{
  const MarkerScene scene = tilted(coded, 0.5);
  const Recognition marker = recognised(scene, 8, false);
  const auto nothing = [](FittedPose &, const ScriptedFitter::Asked &) {};
  for (const bool refine : {true, false}) {
    EXPECT_TRUE(outcomeOf(scene, marker, refine, nothing, Deadline(1e6)).measurement);
    EXPECT_FALSE(outcomeOf(scene, marker, refine, nothing, Deadline(1e-6)).measurement);
  }
}
