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
 * Test that getPose() has what detect() has found.
 */

#include "detector_scenes.h"

#include <algorithm>

using namespace detector_test;

namespace {
// Markers of some size in the image, each in a scene of its own.
struct Scenes
{
  double diameter;        // pixels
  double contrast = 190.; // grey levels
  double noise = 2.;      // grey levels
  bool isInverse = false;

  vpImage<unsigned char> next(Random &random) const
  {
    const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
    vpScenePhotometry photometry;
    photometry.ink = 30.;
    photometry.paper = photometry.ink + contrast;
    photometry.noiseSigma = noise;
    vpMarkerSceneSimulator simulator(straightCamera(), width, height);
    simulator.setPhotometry(photometry);
    simulator.setBackground(vpSceneBackground::plain(photometry.paper));
    simulator.addMarker(
        printed(family, randomId(random, family)).setPose(randomPose(random, diameter, uniform(random, 0.1, 0.8))));
    vpImage<unsigned char> I;
    simulator.render(I, random());
    if (isInverse) {
      std::transform(I.bitmap, I.bitmap + I.getSize(), I.bitmap,
                     [](unsigned char grey) { return static_cast<unsigned char>(255 - grey); });
    }
    return I;
  }
};

// How many markers are found in some scenes, and of how many getPose() has the pose that detect() had.
struct Counts
{
  unsigned int found = 0;
  unsigned int again = 0;
};

Counts countSame(vpDetectorCircleMarker &detector, const Scenes &scenes, Random &random)
{
  constexpr int images = 25;
  Counts counts;
  std::vector<vpHomogeneousMatrix> cMo;
  for (int i = 0; i < images; ++i) {
    detector.detect(scenes.next(random), size, straightCamera(), cMo);
    for (std::size_t k = 0; k < cMo.size(); ++k) {
      vpHomogeneousMatrix again;
      ++counts.found;
      counts.again += detector.getPose(k, size, straightCamera(), again) && differenceOf(cMo[k], again) < 1e-9 ? 1 : 0;
    }
  }
  return counts;
}
} // namespace

TEST(DetectorGetPose, SmallMarkersToo)
{
  // Their codes are proven when they are measured: the sectors alone do not tell them.
  Random random = randomOfTest();
  vpDetectorCircleMarker detector;
  for (const double diameter : {12., 14., 18., 24., 40.}) {
    const Counts counts = countSame(detector, {diameter}, random);
    EXPECT_GT(counts.found, diameter < 13. ? 3u : 15u) << diameter;
    EXPECT_EQ(counts.again, counts.found) << diameter;
  }
}

TEST(DetectorGetPose, WideQuietZonesAreKept)
{
  // What surrounds a marker is looked at as far as its quiet zone goes; around the marker the last image is dark.
  Random random = randomOfTest();
  vpCircleMarkerLayout layout = vpCircleMarkerFamily::ring(0.8).getLayout();
  layout.quietZone = 1.2;
  vpDetectorCircleMarker detector(vpCircleMarkerFamily(vpCircleMarkerFamily::RING).withLayout(layout));
  std::vector<vpHomogeneousMatrix> cMo;
  for (int i = 0; i < 5; ++i) {
    detector.detect(vpImage<unsigned char>(height, width, 0));
    const vpHomogeneousMatrix truth = randomPose(random, 150., uniform(random, 0.1, 0.8), 320., 240.);
    vpSimulatedMarker marker = vpSimulatedMarker::ring(size, 0.8).setPose(truth);
    vpMarkerSceneSimulator simulator(straightCamera(), width, height);
    simulator.setBackground(vpSceneBackground::plain(200.));
    simulator.addMarker(marker);
    vpImage<unsigned char> I;
    simulator.render(I, random());
    ASSERT_TRUE(detector.detect(I, size, straightCamera(), cMo)) << i;
    vpHomogeneousMatrix again;
    ASSERT_TRUE(detector.getPose(0, size, straightCamera(), again)) << i;
    EXPECT_LT(differenceOf(cMo[0], again), 1e-9) << i;
  }
}

// Half of the outline is not there: the pose is that of what is seen, whatever the size.
TEST(DetectorGetPose, RingsThatReachOutOfTheImage)
{
  Random random = randomOfTest();
  vpDetectorCircleMarker detector(vpCircleMarkerFamily::RING);
  detector.setZAlignedWithCameraAxis(true);
  const vpCircleMarkerFamily ring(vpCircleMarkerFamily::RING);
  unsigned int found = 0;
  constexpr unsigned int images = 25;
  for (unsigned int i = 0; i < images; ++i) {
    // Its centre is a fifth of its diameter inside of the left border.
    const double diameter = uniform(random, 60., 120.);
    const vpHomogeneousMatrix truth = randomPose(random, diameter, uniform(random, 0.1, 0.8), 0.2 * diameter, 240.);
    std::vector<vpHomogeneousMatrix> cMo;
    detector.detect(imageOf(printed(ring, -1).setPose(truth), random), size, straightCamera(), cMo);
    for (std::size_t k = 0; k < cMo.size(); ++k) {
      vpHomogeneousMatrix again;
      ASSERT_TRUE(detector.getPose(k, size, straightCamera(), again)) << i;
      EXPECT_LT(differenceOf(cMo[k], again), 1e-9) << i;
      ASSERT_TRUE(detector.getPose(k, 2. * size, straightCamera(), again)) << i;
      EXPECT_NEAR(again[2][3], 2. * cMo[k][2][3], 1e-6 * cMo[k][2][3]) << i;
      const vpCircleMarkerDetection &detection = detector.getDetections()[k];
      EXPECT_LT(detection.visible, 0.8);
      EXPECT_LT(mahalanobis(truth, detection.cMo, detection.covariance, detection.dof), fiveSigma(detection.dof)) << i;
      ++found;
    }
  }
  EXPECT_GE(found, images - 2);
}

TEST(DetectorGetPose, WithoutACameraAndThenWithOne)
{
  Random random = randomOfTest();
  vpDetectorCircleMarker detector;
  for (const double diameter : {14., 18., 24.}) {
    unsigned int found = 0;
    unsigned int again = 0;
    for (int i = 0; i < 25; ++i) {
      vpHomogeneousMatrix cMo;
      found += detector.detect(Scenes{diameter}.next(random)) ? 1 : 0;
      again += detector.getNbObjects() > 0 && detector.getPose(0, size, straightCamera(), cMo) ? 1 : 0;
    }
    // The nominal camera's perspective is another one: in doubt, that decides.
    EXPECT_GE(again + 2, found) << diameter;
    EXPECT_GT(found, 15u) << diameter;
  }
}

TEST(DetectorGetPose, TheSizeThatIsAskedForCounts)
{
  Random random = randomOfTest();
  std::map<int, double> sizes;
  for (int id = 0; id < 178; ++id) {
    sizes[id] = 0.5 * size;
  }
  vpDetectorCircleMarker detector;
  detector.setMarkerSizes(sizes);
  for (const double diameter : {14., 24., 32., 48.}) {
    unsigned int compared = 0;
    for (int i = 0; i < 15; ++i) {
      std::vector<vpHomogeneousMatrix> cMo;
      detector.detect(Scenes{diameter}.next(random), size, straightCamera(), cMo);
      vpHomogeneousMatrix asked, asked2;
      vpMatrix covariance, covariance2;
      if (!cMo.empty() &&
          detector.getPose(0, size, straightCamera(), asked, &asked2, nullptr, nullptr, &covariance, &covariance2)) {
        ++compared;
        const vpCircleMarkerDetection &found = detector.getDetections()[0];
        const double turned = found.covariance[3][3]; // rad^2
        const double turned2 = found.covariance2[3][3];
        EXPECT_NEAR(covariance[3][3], turned, 1e-3 * turned) << diameter;
        EXPECT_NEAR(covariance2[3][3], turned2, 1e-3 * turned2) << diameter;
        EXPECT_EQ(turned2 > 0., found.hasSecondPose);
        EXPECT_NEAR(cMo[0][2][3], 0.5 * focal * size / diameter, 0.1 * cMo[0][2][3]);
        EXPECT_NEAR(asked[2][3], 2. * cMo[0][2][3], 1e-6) << diameter;
      }
    }
    EXPECT_GE(compared, 10u) << diameter;
  }
}

TEST(DetectorGetPose, WhiteOnBlackInNoise)
{
  Random random = randomOfTest();
  vpDetectorCircleMarker detector;
  detector.setPolarity(vpCircleMarkerPolarity::WHITE_ON_BLACK);
  for (const double diameter : {40., 60., 90.}) {
    const Counts counts = countSame(detector, {diameter, 80., 10., true}, random);
    EXPECT_GT(counts.found, 15u) << diameter;
    EXPECT_EQ(counts.again, counts.found) << diameter;
  }
}
