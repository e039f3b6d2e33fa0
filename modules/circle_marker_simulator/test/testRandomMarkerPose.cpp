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
 * Random poses: ranges, distributions, and the whole marker in the image.
 */

#include <algorithm>

#include <visp3/circle_marker_simulator/vpRandomMarkerPose.h>

#include "test_support.h"

using namespace simulator_test;

namespace {

// Largest distance between the distribution of a sample and that of an even spread over [low, high] (Kolmogorov).
double kolmogorovDistance(std::vector<double> sample, double low, double high)
{
  std::sort(sample.begin(), sample.end());
  double distance = 0.;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const double expected = (sample[i] - low) / (high - low);
    const double before = static_cast<double>(i) / sample.size();
    distance = std::max({distance, std::fabs(expected - before), std::fabs(expected - before - 1. / sample.size())});
  }
  return distance;
}

} // namespace

TEST(RandomMarkerPose, RangesAndDistributions)
{
  const vpCameraParameters cam = pinhole(1280, 960);
  const vpSimulatedMarker marker = vpSimulatedMarker::circle("golay23", 5, 0.18);
  vpRandomPoseRange range;
  range.maxTilt = vpMath::rad(60.);
  vpMarkerSceneSimulator simulator(cam, 1280, 960);
  simulator.addMarker(marker);
  std::vector<double> depths, tilts, spins;
  const int n = 4000;
  for (int seed = 0; seed < n; ++seed) {
    const vpHomogeneousMatrix cMo = vpRandomMarkerPose(marker, cam, 1280, 960, range, seed);
    depths.push_back(cMo[2][3]);
    simulator.setMarkerPose(0, cMo);
    if (seed % 20 == 0) {
      const vpMarkerTruth truth = simulator.getTruth()[0];
      EXPECT_EQ(truth.visibleEdge, 1.);
    }
    const vpTranslationVector t = cMo.getTranslationVector();
    tilts.push_back(std::acos((cMo[0][2] * t[0] + cMo[1][2] * t[1] + cMo[2][2] * t[2]) / t.frobeniusNorm()));
    spins.push_back(std::atan2(cMo[1][0], cMo[0][0]));
    for (const double x : {-0.105, 0.105}) {
      for (const double y : {-0.105, 0.105}) { // the sheet's corners
        const vpImagePoint p =
            simulator.project(cMo[0][0] * x + cMo[0][1] * y + t[0], cMo[1][0] * x + cMo[1][1] * y + t[1],
                              cMo[2][0] * x + cMo[2][1] * y + t[2]);
        EXPECT_GE(std::min(p.get_u(), p.get_v()), 1.5);
        EXPECT_LE(p.get_u(), 1277.5);
        EXPECT_LE(p.get_v(), 957.5);
      }
    }
  }
  // 1.95 / sqrt(n): exceeded by chance once in a thousand times.
  EXPECT_LT(kolmogorovDistance(depths, 0.36, 10.36), 1.95 / std::sqrt(n));
  EXPECT_LT(kolmogorovDistance(tilts, 0., range.maxTilt), 1.95 / std::sqrt(n));
  EXPECT_LT(kolmogorovDistance(spins, -M_PI, M_PI), 1.95 / std::sqrt(n));
}

TEST(RandomMarkerPose, SameSeedSamePose)
{
  const vpCameraParameters cam = pinhole(1280, 960);
  const vpSimulatedMarker marker = vpSimulatedMarker::disc(0.18);
  const vpHomogeneousMatrix a = vpRandomMarkerPose(marker, cam, 1280, 960, vpRandomPoseRange(), 3);
  const vpHomogeneousMatrix b = vpRandomMarkerPose(marker, cam, 1280, 960, vpRandomPoseRange(), 3);
  const vpHomogeneousMatrix c = vpRandomMarkerPose(marker, cam, 1280, 960, vpRandomPoseRange(), 4);
  EXPECT_EQ(a[0][3], b[0][3]);
  EXPECT_NE(a[0][3], c[0][3]);
}

TEST(RandomMarkerPose, EveryLensModel)
{
  vpCameraParameters barrel, fisheye;
  barrel.initPersProjWithDistortion(1600., 1600., 639.5, 479.5, -0.25, 0.3);
  fisheye.initProjWithKannalaBrandtDistortion(500., 500., 639.5, 479.5, {-0.03, 0.01, -0.004, 0.0005});
  const vpSimulatedMarker marker = vpSimulatedMarker::circle("golay23", 5, 0.18);
  for (const vpCameraParameters &cam : {barrel, fisheye}) {
    vpMarkerSceneSimulator simulator(cam, 1280, 960);
    simulator.addMarker(marker);
    for (int seed = 0; seed < 50; ++seed) {
      simulator.setMarkerPose(0, vpRandomMarkerPose(marker, cam, 1280, 960, vpRandomPoseRange(), seed));
      EXPECT_EQ(simulator.getTruth()[0].coveredArea, 0.);
    }
  }
}

TEST(RandomMarkerPose, AnImpossibleRangeThrows)
{
  const vpCameraParameters cam = pinhole(1280, 960);
  vpRandomPoseRange range;
  range.maxDepth = 0.1;
  EXPECT_THROW(vpRandomMarkerPose(vpSimulatedMarker::disc(0.18), cam, 1280, 960, range, 0), vpException);
  vpRandomPoseRange fromBehind;
  fromBehind.maxTilt = 1.6;
  EXPECT_THROW(vpRandomMarkerPose(vpSimulatedMarker::disc(0.18), cam, 1280, 960, fromBehind, 0), vpException);
  range.minDepth = 0.09; // the sheet is wider than the image at every depth
  EXPECT_THROW(vpRandomMarkerPose(vpSimulatedMarker::disc(0.18), cam, 1280, 960, range, 0), vpException);
}
