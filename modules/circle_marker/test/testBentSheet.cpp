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
 * Markers on sheets that are bent, and on those that are not.
 */

#include "testMeasureTools.h"
#include "testScriptedFitter.h"

#include <Eigen/Geometry>

#include "refine/bent_sheet.h"
#include "refine/fit_starts.h"
#include "refine/measure.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr unsigned int side = 150;

//! A scene on paper that is bent about an axis through the marker's centre: seen by rays that meet a cylinder.
struct BentScene
{
  MarkerScene flat;
  double curvature = 0.; // 1 / radius of the cylinder, by the marker's; positive: its edges lie away from the camera
  double across = 0.;    // direction across the axis on the marker, rad

  double operator()(double u, double v) const
  {
    const Eigen::Vector3d ray((u - flat.principal.x()) / flat.focal, (v - flat.principal.y()) / flat.focal, 1.);
    const Eigen::Vector3d camera = -flat.rotation.transpose() * flat.center / flat.radius;
    const Eigen::Vector3d way = flat.rotation.transpose() * ray;
    const Eigen::Vector2d n(std::cos(across), std::sin(across));
    // By Newton's method from where the plane is: the height of the paper over the place that is reached.
    double depth = -camera.z() / way.z();
    for (int i = 0; i < 6; ++i) {
      const Eigen::Vector3d p = camera + depth * way;
      const double s = n.dot(p.head<2>());
      const double root = std::sqrt(1. - std::pow(curvature * s, 2.));
      const double height = (1. - root) / curvature - 0.25 * curvature;
      depth -= (p.z() - height) / (way.z() - curvature * s / root * n.dot(way.head<2>()));
    }
    const Eigen::Vector2d p = (camera + depth * way).head<2>();
    const double s = n.dot(p);
    const Eigen::Vector2d q = p + (std::asin(curvature * s) / curvature - s) * n; // along the paper
    if (q.cwiseAbs().maxCoeff() > flat.sheet) {
      return flat.surround;
    }
    return flat.isBlack(q) ? flat.black : flat.white;
  }
};

//! Squared Mahalanobis distance of the true pose, (t, w) about the marker's centre in the camera frame.
double squaredDistance(const FittedPose &fit, const MarkerScene &scene)
{
  Eigen::Matrix<double, 6, 1> error;
  const Eigen::AngleAxisd turn(scene.rotation * fit.plane.rotation.transpose());
  error << scene.center - fit.plane.center, turn.angle() * turn.axis();
  return error.dot(fit.covariance.ldlt().solve(error));
}
} // namespace

// Of 60 to 90 pixels a marker that is bowed by a 60th to a 25th of its radius is read to its noise: the pose has the
// covariance reported, and the bend is found.
TEST(BentSheet, PoseAndBendAreFound)
{
  Random random = randomOfTest();
  constexpr int count = 60;
  double squares = 0.;
  int bent = 0;
  for (int i = 0; i < count; ++i) {
    const vpCircleMarkerFamily family(i % 2 == 0 ? vpCircleMarkerFamily::GOLAY23 : vpCircleMarkerFamily::BCH31R);
    const int id = static_cast<int>(random() % family.getNbIds());
    BentScene scene;
    scene.flat = markerScene(random, family, id, uniform(random, 60., 90.), uniform(random, 0.5, 1.), side);
    scene.curvature = (i % 4 < 2 ? 1. : -1.) * uniform(random, 0.03, 0.08);
    scene.across = uniform(random, 0., M_PI);
    const vpImage<unsigned char> I = digitise(expose(side, side, 0.7, scene), 2., random);
    MeasureMemory memory;
    const auto result =
        measure(I, CameraModel(scene.flat.camera()), recognised(scene.flat, id, i % 3 == 0), true, memory);
    ASSERT_TRUE(result) << i;
    const FittedPose &fit = result->first;
    EXPECT_LT((fit.plane.center - scene.flat.center).norm(), 0.004 * scene.flat.center.z()) << i;
    squares += squaredDistance(fit, scene.flat) / count;
    bent += fit.plane.bend.isAny() ? 1 : 0;
    if (fit.plane.bend.isAny()) {
      const Eigen::Vector2d saddle =
          0.5 * scene.curvature * Eigen::Vector2d(std::cos(2. * scene.across), std::sin(2. * scene.across));
      EXPECT_LT((fit.plane.bend.saddle - saddle).norm(), 0.015) << i << ", curvature " << scene.curvature;
      EXPECT_NEAR(fit.plane.bend.bow, 0.5 * scene.curvature, 0.02) << i;
    }
  }
  EXPECT_GT(bent, 0.9 * count);
  EXPECT_LT(squares, 6. * 1.3);
}

// A flat sheet stays flat: its pose would be known less well with a bend.
TEST(BentSheet, FlatSheetsStayFlat)
{
  Random random = randomOfTest();
  int bent = 0;
  for (int i = 0; i < 60; ++i) {
    const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
    const MarkerScene scene = markerScene(random, family, i, uniform(random, 50., 100.), uniform(random, 0., 1.), side);
    MeasureMemory memory;
    const auto result = measure(digitise(expose(side, side, 0.7, scene), uniform(random, 1., 5.), random),
                                CameraModel(scene.camera()), recognised(scene, i, i % 2 == 0), true, memory);
    ASSERT_TRUE(result) << i;
    bent += result->first.plane.bend.isAny() ? 1 : 0;
  }
  EXPECT_LE(bent, 1);
}

namespace {
//! Fits of a sheet that is bent, or not, as they are asked for.
struct BentFits
{
  double gain = 20.;         // log-odds for the bent sheet
  double flatCoherence = 4.; // how the parts of the print pull a flat sheet apart
  double bentCoherence = 1.; // and a bent one
  SheetBend bend = {0.02, Eigen::Vector2d(0.02, 0.)};
  std::size_t flatFits = 2; // that are there from before

  std::vector<ScriptedFitter::Asked> asked; // of the last time

  RankedFits fit()
  {
    Random random = randomOfTest();
    constexpr double noise = 2.;
    const MarkerScene scene =
        markerScene(random, vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23), 8, 80., 0.5, side);
    RankedFits flat;
    flat.noise = noise;
    const std::array<MarkerPlane, 2> planes = {scene.plane(), twinOf(scene.plane())};
    for (std::size_t i = 0; i < flatFits; ++i) {
      FittedPose fit = fitAt({planes[i], std::nullopt, std::nullopt});
      fit.squares += 100. * static_cast<double>(i);
      fit.coherence = flatCoherence;
      flat.fits.push_back(fit);
    }
    ScriptedFitter fitter([&](const ScriptedFitter::Asked &once) {
      FittedPose fit = fitAt(once.start);
      const bool isTwin = (fit.plane.rotation - planes[0].rotation).norm() > 0.1;
      fit.squares += isTwin ? 100. : 0.;
      fit.coherence = once.settings.bend ? bentCoherence : flatCoherence;
      if (once.settings.bend) {
        fit.plane.bend = bend;
        fit.squares -= 2. * noise * noise * gain;
      }
      return std::optional<FittedPose>(fit);
    });
    const RankedFits ranked = fitBent({}, flat, patternOf(scene.family, 8), FitSettings(), fitter);
    asked = fitter.asked;
    return ranked;
  }

  //! Whether both poses, or neither of them, are of a bent sheet.
  bool isBent()
  {
    const RankedFits ranked = fit();
    EXPECT_EQ(ranked.fits.size(), 2u);
    const bool bent = ranked.fits[0].plane.bend.isAny();
    EXPECT_EQ(ranked.fits[ranked.fits.size() - 1].plane.bend.isAny(), bent);
    return bent;
  }
};
} // namespace

// Three more numbers gain log-odds of 8 of their own accord once in 1000 markers.
TEST(BentSheet, BendsHaveToPay)
{
  BentFits fits;
  for (const double gain : {-1., 0.5, 7.9}) {
    fits.gain = gain;
    EXPECT_FALSE(fits.isBent()) << gain;
  }
  for (const double gain : {8.1, 100.}) {
    fits.gain = gain;
    EXPECT_TRUE(fits.isBent()) << gain;
  }
}

// What covers a marker is explained a little by a bend, too, but pulls the pose apart as before.
TEST(BentSheet, BendsHaveToExplainWhatPullsThePoseApart)
{
  struct Case
  {
    double flat, bent;
    bool isBent;
  };
  for (const Case &now : {Case{4., 1.9, true}, Case{4., 2.1, false}, Case{1.5, 1., true}, Case{1.5, 1.1, false}}) {
    BentFits fits;
    fits.flatCoherence = now.flat;
    fits.bentCoherence = now.bent;
    EXPECT_EQ(fits.isBent(), now.isBent) << now.flat << " " << now.bent;
  }
  BentFits whole;
  whole.flatCoherence = 1.;
  EXPECT_FALSE(whole.isBent());
  EXPECT_TRUE(whole.asked.empty()); // not even tried
}

// Paper bends about one axis: bow and saddle are of one size.
TEST(BentSheet, BendsAreThoseOfPaper)
{
  const auto isBentBy = [](double bow, double saddle) {
    BentFits fits;
    fits.bend = {bow, saddle * Eigen::Vector2d(0.6, -0.8)};
    return fits.isBent();
  };
  EXPECT_TRUE(isBentBy(0.02, 0.02));
  EXPECT_TRUE(isBentBy(-0.02, 0.02));
  EXPECT_TRUE(isBentBy(0.02, 0.0445));
  EXPECT_FALSE(isBentBy(0.02, 0.0455));
  EXPECT_FALSE(isBentBy(-0.02, 0.0455));
  EXPECT_TRUE(isBentBy(1e-4, 0.0045));
  EXPECT_FALSE(isBentBy(1e-4, 0.0055));
}

// The other pose may have looked hopeless because the sheet is not flat.
TEST(BentSheet, ThePoseThatWasGivenUpIsFittedToo)
{
  BentFits fits;
  fits.flatFits = 1;
  EXPECT_TRUE(fits.isBent());
  ASSERT_EQ(fits.asked.size(), 3u);
  EXPECT_FALSE(fits.asked[0].settings.bend);
  EXPECT_TRUE(fits.asked[1].settings.bend && fits.asked[2].settings.bend);
  const MarkerPlane mirror = mirrored(fits.asked[1].start.plane);
  EXPECT_LT((fits.asked[0].start.plane.rotation - mirror.rotation).norm(), 1e-9);
}
