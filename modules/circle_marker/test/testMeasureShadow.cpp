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
 * Test of the measurement of markers with a shadow that their quiet zone does not show.
 */

#include "testScriptedMeasure.h"

#include <Eigen/Cholesky>

using namespace scripted_test;

namespace {
// Of the scripted fits: grey levels of white, 0.8 of which the ink takes.
constexpr double contrast = 160.;

// Pixels that show a shadow to the right of the marker's middle, where a fit without one has the mean of the light.
std::vector<ExplainedPixel> shaded(Random &random)
{
  std::vector<ExplainedPixel> pixels;
  for (int i = 0; i < 400; ++i) {
    ExplainedPixel pixel;
    pixel.offset = Eigen::Vector2f(static_cast<float>(uniform(random, -1., 1.)), static_cast<float>(i % 20) / 10 - 1.f);
    pixel.darkness = static_cast<float>(i % 2);
    const float print = 200.f - 160.f * pixel.darkness;
    pixel.fitted = 0.75f * print;
    pixel.grey = pixel.offset.x() > 0.f ? 0.5f * print : print;
    pixel.weight = 1.f;
    pixels.push_back(pixel);
  }
  return pixels;
}

// What fits leave without a shadow and with it, and the share of the pixels that they count.
struct Fits
{
  double plain = 10.;
  double withShadow = 2.;
  double inliers = 1.;
  double correlation = 0.99; // without the shadow
};

// Whether the fits on all pixels have the shadow.
bool isMeasuredWithShadow(const Recognition &marker, const MarkerScene &scene, const Fits &fits, Random &random,
                          bool refine = true)
{
  const auto alter = [&](FittedPose &fit, const ScriptedFitter::Asked &asked) {
    fit.photometry = Photometry();
    fit.photometry.shadow = asked.start.photometry ? asked.start.photometry->shadow : asked.settings.shadow;
    fit.noise = fit.photometry.shadow ? fits.withShadow : fits.plain;
    fit.inliers = fit.photometry.shadow ? 1. : fits.inliers;
    fit.correlation = fit.photometry.shadow ? 0.99 : fits.correlation;
  };
  const Outcome outcome = outcomeOf(scene, marker, refine, alter, Deadline(), shaded(random));
  return !outcome.asked.empty() && outcome.asked.back().settings.shadow.has_value();
}
} // namespace

TEST(MeasureShadow, IsInTheFitIfThatExplainsMore)
{
  Random random = randomOfTest();
  const MarkerScene scene = tilted(coded, 0.5);
  const Recognition marker = recognised(scene, 8, false);
  EXPECT_TRUE(isMeasuredWithShadow(marker, scene, {10., 2., 1.}, random));
  EXPECT_TRUE(isMeasuredWithShadow(marker, scene, {10., 7.9, 1.}, random));
  EXPECT_FALSE(isMeasuredWithShadow(marker, scene, {10., 8.1, 1.}, random));
  // Half of the pixels that a fit takes for outliers are what it does not explain.
  EXPECT_TRUE(isMeasuredWithShadow(marker, scene, {2., 2., 0.5}, random));
}

TEST(MeasureShadow, IsNotSoughtWhereTheFitExplainsTheImage)
{
  Random random = randomOfTest();
  const MarkerScene scene = tilted(coded, 0.5);
  const Recognition marker = recognised(scene, 8, false);
  EXPECT_FALSE(isMeasuredWithShadow(marker, scene, {0.019 * contrast, 0.1, 1.}, random));
  EXPECT_TRUE(isMeasuredWithShadow(marker, scene, {0.021 * contrast, 0.1, 1.}, random));
}

// Letters are fitted by markers, too, but less well than markers under a shadow.
TEST(MeasureShadow, IsNotSoughtOnWhatIsHardlyLikeTheMarker)
{
  Random random = randomOfTest();
  const MarkerScene scene = tilted(coded, 0.5);
  const Recognition marker = recognised(scene, 8, false);
  EXPECT_TRUE(isMeasuredWithShadow(marker, scene, {10., 2., 1., 0.945}, random));
  EXPECT_FALSE(isMeasuredWithShadow(marker, scene, {10., 2., 1., 0.935}, random));
}

// What covers a marker looks like one; a ring without a code has its shape alone to prove itself; and poses that are
// not refined are not worth it.
TEST(MeasureShadow, IsSoughtOnWholeCodedMarkersOnly)
{
  Random random = randomOfTest();
  const Fits fits;
  EXPECT_TRUE(isMeasuredWithShadow(recognised(tilted(coded, 0.5), 8, false), tilted(coded, 0.5), fits, random));
  EXPECT_FALSE(isMeasuredWithShadow(recognised(tilted(coded, 0.5), 8, false), tilted(coded, 0.5), fits, random, false));
  EXPECT_FALSE(isMeasuredWithShadow(recognised(tilted(ring, 0.5), -1, false), tilted(ring, 0.5), fits, random));
  Recognition covered = recognised(tilted(coded, 0.5), 8, false);
  SeenParts seen;
  seen.plane = tilted(coded, 0.5).plane();
  seen.directions = mostSamples;
  seen.ring.set();
  seen.track.set();
  seen.center.set();
  covered.seen = seen;
  EXPECT_FALSE(isMeasuredWithShadow(covered, tilted(coded, 0.5), fits, random));
}

// Their quiet zone is narrower than the blur: on it no shadow is seen, and a fit without one is off by eight standard
// deviations or ends at the mirrored pose.
TEST(MeasureShadow, SmallObliqueMarkersAreWhereTheyAre)
{
  Random random = randomOfTest();
  constexpr unsigned int window = 64;
  constexpr int count = 100;
  constexpr double softness = 1.; // pixels
  int withShadow = 0;
  double squared = 0.;
  for (int i = 0; i < count; ++i) {
    const int id = static_cast<int>(random() % coded.getNbIds());
    const MarkerScene scene =
        markerScene(random, coded, id, uniform(random, 34., 46.), uniform(random, 1.1, 1.25), window);
    const ImageFrame frame = scene.frame();
    const double direction = uniform(random, -M_PI, M_PI);
    const double edge = uniform(random, -0.2, 0.2);
    const auto lit = [&](double u, double v) {
      const double beyond = (u - frame.center.x()) * std::cos(direction) + (v - frame.center.y()) * std::sin(direction);
      return scene(u, v) * (1. - 0.25 * std::erfc((edge * frame.size - beyond) / softness * M_SQRT1_2));
    };
    const vpImage<unsigned char> I = digitise(expose(window, window, 0.7, lit), 2., random);
    MeasureMemory memory;
    const auto result = measure(I, CameraModel(scene.camera()), recognised(scene, id, i % 2), true, memory);
    ASSERT_TRUE(result);
    const Eigen::Vector3d off = result->first.plane.center - scene.center;
    const Eigen::Matrix3d covariance = result->first.covariance.topLeftCorner<3, 3>();
    squared += off.dot(covariance.ldlt().solve(off)) / 3. / count;
    withShadow += result->first.photometry.shadow ? 1 : 0;
    EXPECT_GT(result->first.plane.rotation.col(2).dot(scene.rotation.col(2)), std::cos(0.1)) << i;
  }
  EXPECT_GT(withShadow, 95);
  EXPECT_LT(squared, 1.4);
}
