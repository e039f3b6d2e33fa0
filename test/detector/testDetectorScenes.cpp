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
 * Test of several families and sizes in one image, nested, touching and inverse markers.
 */

#include <gtest/gtest.h>

#include <map>

#include "detector_scenes.h"

using namespace detector_test;

namespace {
//! The detection of a marker by its image; nullptr without.
const vpCircleMarkerDetection *detectionAt(const vpDetectorCircleMarker &detector, const vpHomogeneousMatrix &cMo,
                                           double diameter)
{
  const double pixels = focal * diameter / cMo[2][3];
  const vpImagePoint center(239.5 + focal * cMo[1][3] / cMo[2][3], 319.5 + focal * cMo[0][3] / cMo[2][3]);
  for (const vpCircleMarkerDetection &detection : detector.getDetections()) {
    if (vpImagePoint::distance(detection.center, center) < 0.1 * pixels &&
        std::abs(2. * detection.ellipse.a - pixels) < 0.15 * pixels) {
      return &detection;
    }
  }
  return nullptr;
}

//! A pose in the plane of another one, moved and turned in it.
vpHomogeneousMatrix beside(const vpHomogeneousMatrix &cMo, double x, double y, double spin = 0.)
{
  return cMo * poseOf(turn(spin, Eigen::Vector3d::UnitZ()), Eigen::Vector3d(x, y, 0.));
}
} // namespace

TEST(DetectorScenes, FamiliesAndSizesInOneImage)
{
  // Each coded marker is read as one of its own family, bch31r too, whose words are words of bch31 as well.
  Random random = randomOfTest();
  const std::vector<vpCircleMarkerFamily> families = {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31R,
                                                      vpCircleMarkerFamily::BCH31, vpCircleMarkerFamily::RING};
  const double diameters[] = {0.18, 0.12, 0.24, 0.06};
  unsigned int found = 0;
  unsigned int all = 0;
  for (int i = 0; i < 15; ++i) {
    std::vector<vpSimulatedMarker> markers;
    std::vector<vpHomogeneousMatrix> poses;
    std::vector<int> ids;
    std::map<int, double> sizes;
    for (std::size_t k = 0; k < families.size(); ++k) {
      const double pixels = uniform(random, 50., 110.);
      poses.push_back(
          randomPose(random, pixels, uniform(random, 0.1, 0.8), 160. + 320. * (k % 2), 120. + 240. * (k / 2)));
      for (unsigned int row = 0; row < 3; ++row) {
        poses.back()[row][3] *= diameters[k] / size; // as large in the image
      }
      ids.push_back(randomId(random, families[k]));
      markers.push_back(printed(families[k], ids.back(), diameters[k]).setPose(poses.back()));
      sizes[ids.back()] = diameters[k];
    }
    if (sizes.size() < families.size()) {
      continue; // sizes are told by id
    }
    vpDetectorCircleMarker detector;
    detector.setZAlignedWithCameraAxis(true);
    detector.setFamilies(families);
    detector.setMarkerSizes(sizes);
    std::vector<vpHomogeneousMatrix> cMo;
    detector.detect(imageOf(straightCamera(), markers, random), size, straightCamera(), cMo);
    EXPECT_LE(detector.getNbObjects(), families.size());
    for (std::size_t k = 0; k < families.size(); ++k) {
      ++all;
      const vpCircleMarkerDetection *detection = detectionAt(detector, poses[k], diameters[k]);
      if (detection == nullptr) {
        continue;
      }
      ++found;
      EXPECT_EQ(detection->family.getName(), families[k].getName());
      EXPECT_EQ(detection->id, ids[k]);
      EXPECT_EQ(detection->size, diameters[k]);
      EXPECT_LT(mahalanobis(poses[k], detection->cMo, detection->covariance, detection->dof),
                fiveSigma(detection->dof));
    }
  }
  EXPECT_GE(all, 40u);
  EXPECT_EQ(found, all);
}

// Words of 31 sectors that change colour so seldom that 23 sectors show a codeword, too, with up to two corrections.
TEST(DetectorScenes, AMarkerIsOfTheFamilyThatExplainsIt)
{
  Random random = randomOfTest();
  vpDetectorCircleMarker detector;
  detector.setFamilies({vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23),
                        vpCircleMarkerFamily(vpCircleMarkerFamily::BCH31R),
                        vpCircleMarkerFamily(vpCircleMarkerFamily::BCH31)});
  for (const int id : {226, 1207, 943, 1094, 68}) {
    for (int i = 0; i < 6; ++i) {
      const vpHomogeneousMatrix pose = randomPose(random, uniform(random, 50., 110.), uniform(random, 0.1, 0.8));
      const vpImage<unsigned char> I =
          imageOf(printed(vpCircleMarkerFamily(vpCircleMarkerFamily::BCH31), id).setPose(pose), random);
      std::vector<vpHomogeneousMatrix> poses;
      ASSERT_TRUE(detector.detect(I, size, straightCamera(), poses)) << id;
      ASSERT_EQ(detector.getDetections().size(), 1u) << id;
      EXPECT_EQ(detector.getDetections()[0].family.getName(), "bch31") << id;
      EXPECT_EQ(detector.getDetections()[0].id, id);
    }
  }
}

TEST(DetectorScenes, AMarkerInTheCentreOfAnother)
{
  // Its sheet fits the white centre, which has 0.4 of the ring's diameter.
  Random random = randomOfTest();
  for (int i = 0; i < 20; ++i) {
    const vpHomogeneousMatrix cMo = randomPose(random, uniform(random, 200., 330.), uniform(random, 0.1, 0.7));
    const int outer = static_cast<int>(random() % 178);
    const int inner = (outer + 1 + static_cast<int>(random() % 177)) % 178;
    const double innerSize = 0.23 * size;
    const vpHomogeneousMatrix cMi = beside(cMo, 0., 0., uniform(random, -M_PI, M_PI));
    const vpImage<unsigned char> I = imageOf(straightCamera(),
                                             {printed(vpCircleMarkerFamily::GOLAY23, outer).setPose(cMo),
                                              printed(vpCircleMarkerFamily::GOLAY23, inner, innerSize).setPose(cMi)},
                                             random);
    vpDetectorCircleMarker detector;
    detector.setZAlignedWithCameraAxis(true);
    detector.setMarkerSizes({{inner, innerSize}});
    std::vector<vpHomogeneousMatrix> poses;
    detector.detect(I, size, straightCamera(), poses);
    ASSERT_EQ(detector.getNbObjects(), 2u) << i;
    EXPECT_EQ(detector.getTagsId(), std::vector<int>({outer, inner}));
    EXPECT_LT(differenceOf(poses[0], cMo), 0.02);
    EXPECT_LT(differenceOf(poses[1], cMi), 0.05);
  }
}

TEST(DetectorScenes, AMarkerInsideOfARing)
{
  // In the white of a ring of 0.8 of its diameter there is room for a marker of half the ring's, with its sheet.
  Random random = randomOfTest();
  const vpCircleMarkerFamily ring = vpCircleMarkerFamily::ring(0.8);
  for (int i = 0; i < 30; ++i) {
    const vpHomogeneousMatrix cMo = randomPose(random, uniform(random, 200., 330.), uniform(random, 0.1, 0.9));
    const int inner = static_cast<int>(random() % 178);
    const double innerSize = uniform(random, 0.25, 0.5) * size;
    const vpHomogeneousMatrix cMi = beside(cMo, 0., 0., uniform(random, -M_PI, M_PI));
    const vpImage<unsigned char> I =
        imageOf(straightCamera(),
                {printed(ring, -1).setPose(cMo), printed(vpCircleMarkerFamily::GOLAY23, inner, innerSize).setPose(cMi)},
                random);
    vpDetectorCircleMarker detector;
    detector.setFamilies({vpCircleMarkerFamily::GOLAY23, ring});
    detector.setZAlignedWithCameraAxis(true);
    detector.setMarkerSizes({{inner, innerSize}});
    std::vector<vpHomogeneousMatrix> poses;
    detector.detect(I, size, straightCamera(), poses);
    ASSERT_EQ(detector.getNbObjects(), 2u) << i;
    EXPECT_EQ(detector.getTagsId(), std::vector<int>({-1, inner}));
    EXPECT_LT(differenceOf(poses[1], cMi), 0.05);
  }
}

TEST(DetectorScenes, SheetsThatTouch)
{
  // Two by two sheets edge to edge; each quiet zone ends where the next one begins.
  Random random = randomOfTest();
  for (int i = 0; i < 15; ++i) {
    const vpHomogeneousMatrix cMo =
        randomPose(random, uniform(random, 60., 100.), uniform(random, 0.1, 0.8), 320., 240.);
    const double half = 0.5 * size * 7. / 6.;
    std::vector<vpSimulatedMarker> markers;
    std::vector<vpHomogeneousMatrix> poses;
    for (int k = 0; k < 4; ++k) {
      poses.push_back(beside(cMo, half * (k % 2 ? 1. : -1.), half * (k / 2 ? 1. : -1.)));
      markers.push_back(printed(vpCircleMarkerFamily::GOLAY23, 10 * i + k).setPose(poses.back()));
    }
    vpDetectorCircleMarker detector;
    detector.setZAlignedWithCameraAxis(true);
    std::vector<vpHomogeneousMatrix> found;
    detector.detect(imageOf(straightCamera(), markers, random), size, straightCamera(), found);
    std::map<int, unsigned int> times;
    for (const vpCircleMarkerDetection &detection : detector.getDetections()) {
      ++times[detection.id];
      ASSERT_GE(detection.id, 10 * i);
      ASSERT_LT(detection.id, 10 * i + 4);
      EXPECT_LT(differenceOf(detection.cMo, poses[static_cast<std::size_t>(detection.id - 10 * i)]), 0.05);
    }
    EXPECT_EQ(times.size(), 4u) << i;
    EXPECT_EQ(detector.getNbObjects(), 4u) << "each once";
  }
}

TEST(DetectorScenes, PolaritySaysWhichAreFound)
{
  Random random = randomOfTest();
  for (int i = 0; i < 15; ++i) {
    const vpHomogeneousMatrix normal =
        randomPose(random, uniform(random, 50., 120.), uniform(random, 0.1, 0.8), 170., 240.);
    const vpHomogeneousMatrix inverse =
        randomPose(random, uniform(random, 50., 120.), uniform(random, 0.1, 0.8), 470., 240.);
    const vpImage<unsigned char> I =
        imageOf(straightCamera(),
                {printed(vpCircleMarkerFamily::GOLAY23, 5).setPose(normal),
                 printed(vpCircleMarkerFamily::GOLAY23, 9).setInverse(true).setPose(inverse)},
                random);
    vpDetectorCircleMarker detector;
    detector.setZAlignedWithCameraAxis(true);
    std::vector<vpHomogeneousMatrix> cMo;
    EXPECT_EQ(detector.getPolarity(), vpCircleMarkerPolarity::BLACK_ON_WHITE);
    ASSERT_TRUE(detector.detect(I, size, straightCamera(), cMo));
    EXPECT_EQ(detector.getTagsId(), std::vector<int>({5}));
    detector.setPolarity(vpCircleMarkerPolarity::WHITE_ON_BLACK);
    ASSERT_TRUE(detector.detect(I, size, straightCamera(), cMo));
    EXPECT_EQ(detector.getTagsId(), std::vector<int>({9}));
    detector.setPolarity(vpCircleMarkerPolarity::BOTH);
    ASSERT_TRUE(detector.detect(I, size, straightCamera(), cMo));
    ASSERT_EQ(detector.getTagsId(), std::vector<int>({5, 9}));
    const vpHomogeneousMatrix truth[] = {normal, inverse};
    for (std::size_t k = 0; k < 2; ++k) {
      const vpCircleMarkerDetection &detection = detector.getDetections()[k];
      EXPECT_EQ(detection.isInverse, k == 1);
      EXPECT_LT(mahalanobis(truth[k], detection.cMo, detection.covariance, 6), fiveSigma(6));
      vpHomogeneousMatrix again;
      ASSERT_TRUE(detector.getPose(k, size, straightCamera(), again));
      EXPECT_LT(differenceOf(again, detection.cMo), 1e-3);
    }
    const vpDetectorCircleMarker copy = detector;
    EXPECT_EQ(copy.getTagsId(), std::vector<int>({5, 9}));
  }
}

// The black inside of a white ring was taken for a disc, a quarter farther away than the ring.
TEST(DetectorScenes, AWhiteRingIsNoBlackDisc)
{
  Random random = randomOfTest();
  vpDetectorCircleMarker detector;
  detector.setPolarity(vpCircleMarkerPolarity::BOTH);
  detector.setFamilies({vpCircleMarkerFamily::RING, vpCircleMarkerFamily::DISC});
  for (int i = 0; i < 10; ++i) {
    const vpHomogeneousMatrix ring =
        randomPose(random, uniform(random, 60., 120.), uniform(random, 0.2, 0.8), 170., 240.);
    const vpHomogeneousMatrix disc =
        randomPose(random, uniform(random, 60., 120.), uniform(random, 0.2, 0.8), 470., 240.);
    const vpImage<unsigned char> I = imageOf(straightCamera(),
                                             {printed(vpCircleMarkerFamily::DISC, -1).setPose(disc),
                                              printed(vpCircleMarkerFamily::RING, -1).setInverse(true).setPose(ring)},
                                             random);
    std::vector<vpHomogeneousMatrix> cMo;
    detector.detect(I, size, straightCamera(), cMo);
    ASSERT_EQ(detector.getNbObjects(), 2u) << i;
    EXPECT_EQ(detector.getDetections()[0].family.getType(), vpCircleMarkerFamily::DISC);
    EXPECT_EQ(detector.getDetections()[1].family.getType(), vpCircleMarkerFamily::RING);
    EXPECT_TRUE(detector.getDetections()[1].isInverse);
    EXPECT_NEAR(cMo[1][2][3], ring[2][3], 0.01 * ring[2][3]);
  }
}

// What is black between the white ring of a marker and its code was taken for a plain ring, in 17 of the 60.
TEST(DetectorScenes, AWhiteCodedMarkerIsNoBlackRing)
{
  Random random = randomOfTest();
  vpDetectorCircleMarker detector;
  detector.setPolarity(vpCircleMarkerPolarity::BOTH);
  detector.setFamilies({vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::RING});
  for (int i = 0; i < 60; ++i) {
    const int id = randomId(random, vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23));
    const vpHomogeneousMatrix cMo = randomPose(random, uniform(random, 45., 140.), uniform(random, 0.1, 1.));
    const vpImage<unsigned char> I =
        imageOf(straightCamera(), {printed(vpCircleMarkerFamily::GOLAY23, id).setInverse(true).setPose(cMo)}, random);
    detector.detect(I);
    EXPECT_EQ(detector.getTagsId(), std::vector<int>({id})) << i;
  }
}

TEST(DetectorScenes, InverseMarkersAreTracked)
{
  Random random = randomOfTest();
  vpDetectorCircleMarker detector;
  detector.setPolarity(vpCircleMarkerPolarity::BOTH);
  detector.setTracking(true, 5);
  for (int i = 0; i < 12; ++i) {
    const double u = 200. + 4. * i;
    const vpImage<unsigned char> I = imageOf(
        straightCamera(),
        {printed(vpCircleMarkerFamily::GOLAY23, 5)
             .setPose(poseOf(turn(0.4, Eigen::Vector3d::UnitX()), Eigen::Vector3d((u - 319.5) / focal, 0.15, 1.5))),
         printed(vpCircleMarkerFamily::GOLAY23, 9)
             .setInverse(true)
             .setPose(poseOf(turn(0.5, Eigen::Vector3d::UnitY()), Eigen::Vector3d(0.2, (u - 300.) / focal, 1.4)))},
        random);
    std::vector<vpHomogeneousMatrix> cMo;
    detector.detect(I, size, straightCamera(), cMo);
    EXPECT_EQ(detector.getTagsId(), std::vector<int>({5, 9})) << i;
    for (const vpRect &region : detector.getSearchedRegions()) {
      EXPECT_EQ(region.getWidth() < width, i % 5 != 0) << i; // every fifth image is searched as a whole
    }
    EXPECT_EQ(detector.getSearchedRegions().size(), 2u) << i;
  }
}

TEST(DetectorScenes, InverseMarkersHaveTheSizesOfTheDatabase)
{
  Random random = randomOfTest();
  const vpHomogeneousMatrix truth = randomPose(random, 100., 0.4);
  const vpImage<unsigned char> I =
      imageOf(printed(vpCircleMarkerFamily::GOLAY23, 9).setInverse(true).setPose(truth), random);
  vpCircleMarkerEntry entry;
  entry.id = 9;
  entry.size = 2. * size;
  vpCircleMarkerDatabase database;
  database.add(entry);
  for (const vpCircleMarkerPolarity polarity : {vpCircleMarkerPolarity::WHITE_ON_BLACK, vpCircleMarkerPolarity::BOTH}) {
    vpDetectorCircleMarker detector;
    detector.setPolarity(polarity);
    detector.setDatabase(database);
    std::vector<vpHomogeneousMatrix> cMo;
    ASSERT_TRUE(detector.detect(I, size, straightCamera(), cMo));
    EXPECT_EQ(detector.getDetections()[0].size, 2. * size);
    EXPECT_NEAR(cMo[0][2][3], 2. * truth[2][3], 0.02 * truth[2][3]);
  }
}

// Else only the regions of those that were followed would be searched.
TEST(DetectorScenes, WithOtherFamiliesInverseMarkersAreLookedForAnew)
{
  Random random = randomOfTest();
  const vpImage<unsigned char> I = imageOf(
      straightCamera(),
      {printed(vpCircleMarkerFamily::GOLAY23, 9).setInverse(true).setPose(randomPose(random, 100., 0.4, 180., 180.)),
       printed(vpCircleMarkerFamily::RING, -1).setInverse(true).setPose(randomPose(random, 100., 0.4, 450., 300.))},
      random);
  vpDetectorCircleMarker detector;
  detector.setPolarity(vpCircleMarkerPolarity::WHITE_ON_BLACK);
  detector.setTracking(true, 100);
  for (int i = 0; i < 2; ++i) {
    detector.detect(I);
    ASSERT_EQ(detector.getTagsId(), std::vector<int>({9}));
  }
  detector.setFamilies({vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::RING});
  detector.detect(I);
  EXPECT_EQ(detector.getNbObjects(), 2u);
}
