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
 * The interface of vpDetectorCircleMarker: what is left of an image for the next, copies, and poses without refinement.
 */

#include "detector_scenes.h"

using namespace detector_test;

TEST(DetectorInterface, ImagesWithoutMarkers)
{
  TwoMarkers scene;
  vpDetectorCircleMarker detector;
  std::vector<vpHomogeneousMatrix> cMo, cMo2;
  std::vector<double> errors, errors2;
  ASSERT_TRUE(detector.detect(scene.I, size, straightCamera(), cMo, &cMo2, &errors, &errors2));
  // Nothing of the last image is left.
  for (const unsigned char grey : {0, 128, 255}) {
    const vpImage<unsigned char> blank(height, width, grey);
    EXPECT_FALSE(detector.detect(blank, size, straightCamera(), cMo, &cMo2, &errors, &errors2));
    EXPECT_TRUE(cMo.empty() && cMo2.empty() && errors.empty() && errors2.empty());
    EXPECT_EQ(detector.getNbObjects(), 0u);
    EXPECT_TRUE(detector.getMessage().empty());
    EXPECT_TRUE(detector.getPolygon().empty());
    EXPECT_TRUE(detector.getDetections().empty());
    EXPECT_TRUE(detector.getTagsId().empty());
    EXPECT_TRUE(detector.getTagsCorners().empty());
  }
  EXPECT_FALSE(detector.detect(vpImage<unsigned char>(16, 16, 100)));
  EXPECT_FALSE(detector.detect(vpImage<unsigned char>(16, 2000, 100)));
}

TEST(DetectorInterface, CopiesAreIndependent)
{
  TwoMarkers scene;
  vpDetectorCircleMarker original;
  ASSERT_TRUE(original.detect(scene.I));
  vpDetectorCircleMarker copy(original);
  vpDetectorCircleMarker assigned(vpCircleMarkerFamily::DISC);
  assigned = original;
  // The copies hold the results, and can still measure.
  vpHomogeneousMatrix pose, poseOfCopy;
  ASSERT_TRUE(original.getPose(0, size, straightCamera(), pose));
  for (vpDetectorCircleMarker *one : {&copy, &assigned}) {
    ASSERT_EQ(one->getNbObjects(), 2u);
    EXPECT_EQ(one->getMessage(1), "golay23 id: 9");
    ASSERT_TRUE(one->getPose(0, size, straightCamera(), poseOfCopy));
    EXPECT_LT(differenceOf(pose, poseOfCopy), 1e-12);
  }
  // What becomes of one does not touch the others.
  copy.setFamily(vpCircleMarkerFamily::BCH31);
  copy.setZAlignedWithCameraAxis(true);
  EXPECT_FALSE(copy.detect(vpImage<unsigned char>(100, 100, 0)));
  EXPECT_EQ(original.getNbObjects(), 2u);
  EXPECT_EQ(original.getFamilies()[0].getType(), vpCircleMarkerFamily::GOLAY23);
  ASSERT_TRUE(original.getPose(0, size, straightCamera(), poseOfCopy));
  EXPECT_LT(differenceOf(pose, poseOfCopy), 1e-12);
  const vpDetectorCircleMarker &self = assigned;
  assigned = self;
  EXPECT_EQ(assigned.getNbObjects(), 2u);
  EXPECT_EQ(assigned.getTagsId(), std::vector<int>({5, 9}));
}

TEST(DetectorInterface, TheSameImageTheSameResult)
{
  TwoMarkers scene;
  vpDetectorCircleMarker used, fresh, threaded;
  threaded.setNbThreads(3);
  std::vector<vpHomogeneousMatrix> first, again, other;
  ASSERT_TRUE(used.detect(scene.I, size, straightCamera(), first));
  used.detect(vpImage<unsigned char>(333, 444, 50));
  ASSERT_TRUE(used.detect(scene.I, size, straightCamera(), again));
  ASSERT_TRUE(threaded.detect(scene.I, size, straightCamera(), other));
  ASSERT_TRUE(fresh.detect(scene.I));
  ASSERT_EQ(first.size(), again.size());
  ASSERT_EQ(first.size(), other.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(differenceOf(first[i], again[i]), 0.);
    EXPECT_EQ(differenceOf(first[i], other[i]), 0.);
  }
}

TEST(DetectorInterface, WithoutRefinement)
{
  TwoMarkers scene;
  vpDetectorCircleMarker detector;
  detector.setZAlignedWithCameraAxis(true);
  std::vector<vpHomogeneousMatrix> refined, coarse;
  ASSERT_TRUE(detector.detect(scene.I, size, straightCamera(), refined));
  detector.setRefinePose(false);
  ASSERT_TRUE(detector.detect(scene.I, size, straightCamera(), coarse));
  EXPECT_EQ(detector.getTagsId(), std::vector<int>({5, 9}));
  for (std::size_t i = 0; i < 2; ++i) {
    // The closed form is near, but it is not the refined pose.
    EXPECT_LT((translationOf(coarse[i]) - translationOf(scene.poses[i])).norm(), 0.02 * translationOf(coarse[i]).z());
    EXPECT_GT((translationOf(coarse[i]) - translationOf(refined[i])).norm(), 1e-6);
    EXPECT_GT(rotationOf(coarse[i]).col(2).dot(rotationOf(scene.poses[i]).col(2)), std::cos(0.1));
    EXPECT_GT(rotationOf(coarse[i]).col(0).dot(rotationOf(scene.poses[i]).col(0)), std::cos(0.15));
  }
}
