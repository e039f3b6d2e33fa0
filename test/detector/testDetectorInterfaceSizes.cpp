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
 * The interface of vpDetectorCircleMarker: sizes of markers, from a list, a database or afterwards.
 */

#include "detector_scenes.h"

using namespace detector_test;

TEST(DetectorInterface, SizesOfSingleMarkers)
{
  TwoMarkers scene;
  vpDetectorCircleMarker detector;
  std::vector<vpHomogeneousMatrix> before, after;
  ASSERT_TRUE(detector.detect(scene.I, size, straightCamera(), before));
  detector.setMarkerSizes({{9, 0.09}, {77, 3.}});
  ASSERT_TRUE(detector.detect(scene.I, size, straightCamera(), after));
  EXPECT_DOUBLE_EQ(detector.getDetections()[0].size, size);
  EXPECT_DOUBLE_EQ(detector.getDetections()[1].size, 0.09);
  EXPECT_LT(differenceOf(after[0], before[0]), 1e-12);
  EXPECT_LT((translationOf(after[1]) - 0.5 * translationOf(before[1])).norm(), 1e-3 * translationOf(after[1]).z());
  EXPECT_LT((rotationOf(after[1]) - rotationOf(before[1])).norm(), 1e-3);
}

TEST(DetectorInterface, DatabaseGivesSizesNamesAndPayloads)
{
  TwoMarkers scene;
  vpCircleMarkerDatabase database;
  vpCircleMarkerEntry entry;
  entry.id = 9;
  entry.size = 2. * size;
  entry.name = "door";
  entry.payload = "wait";
  database.add(entry);
  entry.family = vpCircleMarkerFamily::BCH31; // another marker 5
  entry.id = 5;
  database.add(entry);
  vpDetectorCircleMarker detector;
  detector.setZAlignedWithCameraAxis(true);
  detector.setMarkerSizes({{9, 3. * size}}); // the database's counts
  detector.setDatabase(database);
  std::vector<vpHomogeneousMatrix> cMo;
  ASSERT_TRUE(detector.detect(scene.I, size, straightCamera(), cMo));
  ASSERT_EQ(cMo.size(), 2u);
  EXPECT_EQ(detector.getMessage(0), "golay23 id: 5");
  EXPECT_EQ(detector.getMessage(1), "golay23 id: 9 name: door payload: wait");
  EXPECT_NEAR(cMo[0][2][3], scene.poses[0][2][3], 0.01 * scene.poses[0][2][3]);
  EXPECT_NEAR(cMo[1][2][3], 2. * scene.poses[1][2][3], 0.02 * scene.poses[1][2][3]);
  EXPECT_EQ(vpDetectorCircleMarker(detector).getDatabase().getEntries().size(), 2u); // copies know it as well
}

TEST(DetectorInterface, PoseForAnotherSize)
{
  TwoMarkers scene;
  vpDetectorCircleMarker detector;
  std::vector<vpHomogeneousMatrix> cMo, cMo2;
  std::vector<double> errors, errors2;
  ASSERT_TRUE(detector.detect(scene.I, size, straightCamera(), cMo, &cMo2, &errors, &errors2));
  for (std::size_t i = 0; i < 2; ++i) {
    vpHomogeneousMatrix pose, pose2;
    double error = 0., error2 = 0.;
    ASSERT_TRUE(detector.getPose(i, size, straightCamera(), pose, &pose2, &error, &error2));
    EXPECT_LT(differenceOf(pose, cMo[i]), 1e-3);
    EXPECT_LT(differenceOf(pose2, cMo2[i]), 1e-3);
    EXPECT_NEAR(error, errors[i], 0.01 * errors[i]);
    EXPECT_NEAR(error2, errors2[i], 0.01 * errors2[i]);
    vpMatrix covariance;
    ASSERT_TRUE(detector.getPose(i, 3. * size, straightCamera(), pose, nullptr, nullptr, nullptr, &covariance));
    const double ratio = covariance[2][2] / detector.getCovariance(i)[2][2]; // of the variances of the depth
    EXPECT_NEAR(ratio, 9., 0.2);
    EXPECT_LT((translationOf(pose) - 3. * translationOf(cMo[i])).norm(), 1e-3 * translationOf(pose).z());
    EXPECT_LT((rotationOf(pose) - rotationOf(cMo[i])).norm(), 1e-3);
  }
}

TEST(DetectorInterface, WithoutACameraAndThenWithOne)
{
  TwoMarkers scene;
  vpDetectorCircleMarker with, without;
  std::vector<vpHomogeneousMatrix> cMo;
  ASSERT_TRUE(with.detect(scene.I, size, straightCamera(), cMo));
  ASSERT_TRUE(without.detect(scene.I));
  ASSERT_EQ(without.getTagsId(), with.getTagsId());
  for (std::size_t i = 0; i < 2; ++i) {
    vpHomogeneousMatrix pose;
    ASSERT_TRUE(without.getPose(i, size, straightCamera(), pose));
    EXPECT_LT(differenceOf(pose, cMo[i]), 1e-3);
  }
}
