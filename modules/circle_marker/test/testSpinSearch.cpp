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
 * Tests of the search for the spin of a marker whose code is covered in part.
 */

#include "refine/spin_search.h"

#include <gtest/gtest.h>

#include "refine/fit_starts.h"
#include "testRoomTools.h"
#include "testScriptedFitter.h"
#include "testScriptedMeasure.h"

using namespace scripted_test;

namespace {
//! The turn from one pose to another of the same plane, rad.
double turnBetween(const MarkerPlane &from, const MarkerPlane &to)
{
  const Eigen::Vector3d x = to.rotation.col(0);
  return std::atan2(from.rotation.col(1).dot(x), from.rotation.col(0).dot(x));
}

struct Searched
{
  RankedFits ranked;
  std::vector<ScriptedFitter::Asked> asked;
};

//! A search where pixels are explained best after a turn, and fits end where they start.
Searched searched(const MarkerScene &scene, double turn, const Deadline &deadline = Deadline())
{
  ScriptedFitter fitter(
      [](const ScriptedFitter::Asked &asked) { return std::optional<FittedPose>(fitAt(asked.start)); });
  MarkerPlane truth = scene.plane();
  truth.spin(turn);
  fitter.moreSquares = [&](const FittedPose &fit) {
    return isTwinOf(fit.plane, scene) ? 500. : 1000. * std::abs(turnBetween(truth, fit.plane));
  };
  RankedFits ranked;
  ranked.fits.push_back(fitAt({scene.plane(), std::nullopt, std::nullopt}));
  ranked.noise = noise;
  MarkerPattern pattern = patternOf(scene.family, 8);
  Searched result;
  FitSettings settings;
  settings.deadline = deadline;
  result.ranked = withBetterSpin({}, ranked, pattern, settings, fitter);
  result.asked = fitter.asked;
  return result;
}
} // namespace

TEST(SpinSearch, AFitStartsWhereThePixelsAreExplainedBest)
{
  const MarkerScene scene = tilted(coded, 0.5);
  const double halfSector = M_PI / coded.getNbSectors();
  for (const double turn : {-0.9 * halfSector, -0.3 * halfSector, 0.3 * halfSector, 0.9 * halfSector}) {
    const Searched result = searched(scene, turn);
    ASSERT_EQ(result.asked.size(), 2u);
    EXPECT_NEAR(turnBetween(scene.plane(), result.asked[0].start.plane), turn, 0.05 * halfSector);
    EXPECT_LT((result.asked[1].start.plane.rotation - mirrored(result.asked[0].start.plane).rotation).norm(), 1e-9)
        << "the other pose is turned, too";
    ASSERT_EQ(result.ranked.fits.size(), 2u);
    EXPECT_NEAR(turnBetween(scene.plane(), result.ranked.fits[0].plane), turn, 0.05 * halfSector);
    EXPECT_TRUE(isTwinOf(result.ranked.fits[1].plane, scene));
  }
}

TEST(SpinSearch, NothingIsFittedWhereTheSpinIsRightOrAfterTheDeadline)
{
  const MarkerScene scene = tilted(coded, 0.5);
  for (const bool isLate : {false, true}) {
    const Searched result = searched(scene, isLate ? 0.1 : 0., isLate ? Deadline(1e-6) : Deadline());
    EXPECT_TRUE(result.asked.empty());
    ASSERT_EQ(result.ranked.fits.size(), 1u);
    EXPECT_EQ(turnBetween(scene.plane(), result.ranked.fits[0].plane), 0.);
  }
}

// A cover within the ring, seen in `bench-circle-marker --hardships`: what it left of the sectors was read 1.4 degrees
// aside, where their true borders are outliers, and the fit stayed there, with a covariance of a hundredth of that.
TEST(SpinSearch, ACoverInTheMiddleDoesNotTurnTheMarker)
{
  Random random = randomOfTest();
  constexpr double cover = 88.; // grey level
  constexpr int id = 13;
  // Its corners from the marker's centre in the image, by its radius, in turn.
  const std::vector<Eigen::Vector2d> corners = {{-0.217, -0.593}, {0.289, -0.447}, {0.474, -0.277}, {0.482, 0.316},
                                                {0.296, 0.573},   {-0.138, 0.573}, {-0.375, -0.356}};
  MarkerScene scene = markerScene(random, coded, id, 102., 0.26, side);
  scene.rotation << 0.1921822299, -0.9601398772, -0.2029714432, 0.9744188922, 0.1621425914, 0.1556200584, -0.116506708,
      -0.2276866187, 0.9667393603;
  const ImageFrame frame = scene.frame();
  const auto picture = [&](double u, double v) {
    const Eigen::Vector2d q = (Eigen::Vector2d(u, v) - frame.center) / frame.size;
    bool isInside = true;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Eigen::Vector2d along = corners[(k + 1) % corners.size()] - corners[k];
      const Eigen::Vector2d from = q - corners[k];
      isInside = isInside && along.x() * from.y() - along.y() * from.x() > 0.;
    }
    return isInside ? cover : scene(u, v);
  };
  const vpImage<unsigned char> I = digitise(expose(side, side, 0.7, picture), 2., random);
  MeasureMemory memory;
  const auto right = measure(I, CameraModel(scene.camera()), recognised(scene, id, false), true, memory);
  ASSERT_TRUE(right);
  EXPECT_TRUE(mayBeTurned(right->first)) << right->first.inliers;
  const MarkerPattern pattern = patternOf(coded, id);
  FitSettings settings;
  settings.spinIsKnown = true;
  for (const double aside : {-0.1, -0.035, 0.035, 0.1}) { // rad
    RankedFits stuck = {{}, right->first.noise};
    stuck.fits.push_back(right->first);
    FittedPose &fit = stuck.fits[0];
    fit.plane.spin(aside);
    fit.squares = memory.fitter->robustSquares(memory.pixels, fit, pattern, fit.photometry, stuck.noise, true);
    const RankedFits found = withBetterSpin(memory.pixels, stuck, pattern, settings, *memory.fitter);
    EXPECT_NEAR(turnBetween(scene.plane(), found.fits[0].plane), 0., 0.001) << aside;
    EXPECT_LT((found.fits[0].plane.rotation.col(2) - scene.rotation.col(2)).norm(), 0.005) << aside;
  }
}
