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
 * Tests of the model of a marker through a blur.
 */

#include "testRoomTools.h"

#include "decode/blurred_marker.h"

#include <gtest/gtest.h>

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr unsigned int side = 200; // pixels
constexpr double lens = 0.7;       // blur, pixels

constexpr int way = 15;              // pixels
constexpr std::size_t samples = 500; // of the fit
constexpr double contrast = paper - ink;

MarkerScene sceneOf(Random &random)
{
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  MarkerScene scene = markerScene(random, family, static_cast<int>(random() % family.getNbIds()),
                                  uniform(random, 70., 90.), uniform(random, 0., 0.6), side);
  scene.sheet = 2.;
  return scene;
}

vpImage<unsigned char> imageOf(const MarkerScene &scene, Random &random)
{
  return digitise(moved(expose(side, side, lens, scene), way), 1., random);
}

BlurredFit fitOf(const MarkerScene &scene)
{
  BlurredFit fit;
  fit.plane = scene.plane();
  fit.blur.motion = Eigen::Vector2d(way, 0.);
  return fit;
}
} // namespace

TEST(BlurredMarker, AtThePoseAndBlurTheSectorsAreWhatTheyAre)
{
  Random random = randomOfTest();
  for (int i = 0; i < 5; ++i) {
    const MarkerScene scene = sceneOf(random);
    const vpImage<unsigned char> I = imageOf(scene, random);
    const CameraModel camera(scene.camera());
    BlurredMarker marker(I, camera, scene.family);
    BlurredFit fit = fitOf(scene);
    marker.select(fit.plane, fit.blur, samples);
    EXPECT_GT(marker.size(), samples / 4);
    EXPECT_LT(marker.size(), 2 * samples);
    marker.solve(fit);
    EXPECT_LT(fit.unexplained(), 0.01);
    EXPECT_NEAR(fit.linear[0], paper, 0.05 * contrast);
    EXPECT_NEAR(fit.linear[BlurredFit::ringAt], contrast, 0.1 * contrast);
    for (int k = 0; k < 23; ++k) {
      EXPECT_EQ(fit.linear[BlurredFit::firstSector + k] > 0.5 * contrast, isSectorBlack(scene.word, k, 23))
          << "sector " << k;
    }
  }
}

TEST(BlurredMarker, PoseAndBlurAreFoundFromNearby)
{
  Random random = randomOfTest();
  for (int i = 0; i < 5; ++i) {
    const MarkerScene scene = sceneOf(random);
    const vpImage<unsigned char> I = imageOf(scene, random);
    const CameraModel camera(scene.camera());
    BlurredMarker marker(I, camera, scene.family);
    BlurredFit fit = fitOf(scene);
    fit.plane.center.x() += 0.03 * fit.plane.radius;
    fit.plane.center.z() *= 1.02;
    fit.blur.motion.x() = 0.8 * way;
    marker.select(fit.plane, fit.blur, samples);
    marker.solve(fit);
    const double before = fit.unexplained();
    marker.improve(fit, 20, true);
    EXPECT_LT(fit.unexplained(), 0.01);
    EXPECT_LT(fit.unexplained(), 0.5 * before);
    EXPECT_NEAR(fit.blur.motion.x(), way, 0.07 * way);
    EXPECT_LT((fit.plane.center - scene.center).head<2>().norm(), 0.005 * scene.radius);
    EXPECT_LT(std::abs(fit.plane.center.z() / scene.center.z() - 1.), 0.005);
    const Eigen::Matrix<double, 6, 6> covariance = marker.covariance(fit);
    EXPECT_TRUE(covariance.allFinite());
    EXPECT_GT(covariance.diagonal().minCoeff(), 0.);
  }
}

// Depth and tilt trade for each other: from either side of the pose the fit ends at the same one, by what it is said to
// be known to.
TEST(BlurredMarker, ThePoseDoesNotDependOnTheStart)
{
  Random random = randomOfTest();
  for (int i = 0; i < 5; ++i) {
    const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
    MarkerScene scene = markerScene(random, family, static_cast<int>(random() % family.getNbIds()),
                                    uniform(random, 26., 34.), uniform(random, 0.5, 0.8), side);
    scene.sheet = 2.;
    const vpImage<unsigned char> I = imageOf(scene, random);
    const CameraModel camera(scene.camera());
    BlurredMarker marker(I, camera, scene.family);
    std::array<BlurredFit, 2> fits;
    for (std::size_t k = 0; k < fits.size(); ++k) {
      fits[k] = fitOf(scene);
      marker.select(scene.plane(), fits[k].blur, samples);
      fits[k].plane.center.z() *= k == 0 ? 0.985 : 1.015;
      marker.solve(fits[k]);
      marker.improve(fits[k], 20, true);
    }
    const Eigen::Vector3d depth = fits[0].plane.rotation.row(2).transpose() * fits[0].plane.radius;
    const double variance = depth.dot(marker.covariance(fits[0]).topLeftCorner<3, 3>() * depth);
    EXPECT_LT(std::abs(fits[0].plane.center.z() - fits[1].plane.center.z()), std::sqrt(variance));
  }
}

TEST(BlurredMarker, NothingFitsAfterTheDeadline)
{
  Random random = randomOfTest();
  const MarkerScene scene = sceneOf(random);
  const vpImage<unsigned char> I = imageOf(scene, random);
  const CameraModel camera(scene.camera());
  const Deadline deadline(1e-6); // a nanosecond
  while (!deadline.hasPassed()) {
  }
  BlurredMarker marker(I, camera, scene.family, deadline);
  BlurredFit fit = fitOf(scene);
  marker.select(fit.plane, fit.blur, samples);
  EXPECT_EQ(marker.size(), 0u);
  BlurredMarker inTime(I, camera, scene.family);
  inTime.select(fit.plane, fit.blur, samples);
  inTime.solve(fit);
  EXPECT_LT(fit.squares, HUGE_VAL);
}
