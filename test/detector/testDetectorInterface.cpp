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
 * The interface of vpDetectorCircleMarker: messages, frames, centres and ellipses.
 */

#include "detector_scenes.h"

#include <visp3/core/vpMeterPixelConversion.h>

using namespace detector_test;

TEST(DetectorInterface, MessagesAndLists)
{
  TwoMarkers scene;
  vpDetectorCircleMarker detector;
  std::vector<vpHomogeneousMatrix> cMo, cMo2;
  std::vector<double> errors, errors2;
  ASSERT_TRUE(detector.detect(scene.I, size, straightCamera(), cMo, &cMo2, &errors, &errors2));
  ASSERT_EQ(detector.getNbObjects(), 2u);
  // Largest outline first.
  EXPECT_EQ(detector.getMessage(0), "golay23 id: 5");
  EXPECT_EQ(detector.getMessage(1), "golay23 id: 9");
  EXPECT_EQ(detector.getTagsId(), std::vector<int>({5, 9}));
  EXPECT_EQ(detector.getTagsHammingDistance(), std::vector<int>({0, 0}));
  ASSERT_EQ(detector.getTagsDecisionMargin().size(), 2u);
  ASSERT_EQ(detector.getTagsCorners().size(), 2u);
  ASSERT_EQ(cMo.size(), 2u);
  ASSERT_EQ(cMo2.size(), 2u);
  ASSERT_EQ(errors.size(), 2u);
  ASSERT_EQ(errors2.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const vpCircleMarkerDetection &found = detector.getDetections()[i];
    EXPECT_FLOAT_EQ(detector.getTagsDecisionMargin()[i], static_cast<float>(detector.getMargin(i)));
    EXPECT_GT(detector.getMargin(i), 0.6);
    EXPECT_LE(detector.getMargin(i), 1.);
    EXPECT_EQ(detector.getHammingDistance(i), 0u);
    EXPECT_EQ(errors[i], found.cost);
    EXPECT_EQ(errors2[i], found.cost2);
    EXPECT_LE(errors[i], errors2[i]);
    EXPECT_EQ(detector.getLogOdds(i), found.hasSecondPose ? errors2[i] - errors[i] : HUGE_VAL);
    EXPECT_LT(differenceOf(cMo2[i], found.hasSecondPose ? found.cMo2 : found.cMo), 1e-15);
    EXPECT_EQ(detector.getPolygon(i).size(), detector.getTagsCorners()[i].size());
  }
}

// Of a ring that faces the camera both poses are one.
TEST(DetectorInterface, WhereThereIsNoSecondPoseItIsTheFirst)
{
  constexpr int images = 12;
  Random random = randomOfTest();
  int without = 0;
  for (int i = 0; i < images; ++i) {
    const vpHomogeneousMatrix truth = randomPose(random, uniform(random, 20., 200.), uniform(random, 0., 0.1));
    const vpImage<unsigned char> I = imageOf(printed(vpCircleMarkerFamily::RING, -1).setPose(truth), random);
    vpDetectorCircleMarker detector(vpCircleMarkerFamily::RING);
    std::vector<vpHomogeneousMatrix> cMo, cMo2;
    ASSERT_TRUE(detector.detect(I, size, straightCamera(), cMo, &cMo2));
    if (!detector.getDetections()[0].hasSecondPose) {
      ++without;
      EXPECT_EQ(differenceOf(cMo[0], cMo2[0]), 0.);
    }
  }
  EXPECT_GT(without, 0);
}

TEST(DetectorInterface, SimulatedRingIsPrintedAsTheFamilySays)
{
  const double ratio = vpCircleMarkerFamily(vpCircleMarkerFamily::RING).getLayout().ringInner;
  EXPECT_EQ(vpSimulatedMarker::circle("ring", -1, size).getRingRatio(), ratio);
  EXPECT_EQ(vpSimulatedMarker::circle("golay23", 0, size).getRingRatio(), ratio);
}

TEST(DetectorInterface, MessageWithoutACode)
{
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::RING, vpCircleMarkerFamily::DISC}) {
    vpDetectorCircleMarker detector(type);
    ASSERT_TRUE(detector.detect(imageOf(printed(type, -1).setPose(randomPose(random, 90., 0.5)), random)));
    EXPECT_EQ(detector.getMessage(0), vpCircleMarkerFamily(type).getName());
    EXPECT_EQ(detector.getTagsId(), std::vector<int>({-1}));
  }
}

TEST(DetectorInterface, FramesDifferByAHalfTurnAboutX)
{
  TwoMarkers scene;
  vpDetectorCircleMarker detector;
  std::vector<vpHomogeneousMatrix> toward, aligned, toward2, aligned2;
  ASSERT_TRUE(detector.detect(scene.I, size, straightCamera(), toward, &toward2));
  const vpMatrix covariance = detector.getCovariance(0);
  detector.setZAlignedWithCameraAxis(true);
  ASSERT_TRUE(detector.detect(scene.I, size, straightCamera(), aligned, &aligned2));
  const Eigen::Matrix3d halfTurn = Eigen::Vector3d(1., -1., -1.).asDiagonal();
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LT((rotationOf(aligned[i]) * halfTurn - rotationOf(toward[i])).norm(), 1e-12);
    EXPECT_LT((rotationOf(aligned2[i]) * halfTurn - rotationOf(toward2[i])).norm(), 1e-12);
    EXPECT_EQ(translationOf(aligned[i]), translationOf(toward[i]));
    // Away from the camera, and the truth.
    EXPECT_GT(aligned[i][2][2], 0.);
    EXPECT_LT(toward[i][2][2], 0.);
    EXPECT_LT(differenceOf(aligned[i], scene.poses[i]), 0.03);
  }
  for (unsigned int row = 0; row < 6; ++row) {
    for (unsigned int column = 0; column < 6; ++column) {
      EXPECT_EQ(detector.getCovariance(0)[row][column], covariance[row][column]);
    }
  }
}

TEST(DetectorInterface, CenterIsTheProjectionOfTheOrigin)
{
  TwoMarkers scene;
  vpDetectorCircleMarker detector;
  std::vector<vpHomogeneousMatrix> cMo;
  ASSERT_TRUE(detector.detect(scene.I, size, straightCamera(), cMo));
  for (std::size_t i = 0; i < 2; ++i) {
    double u = 0., v = 0.;
    vpMeterPixelConversion::convertPoint(straightCamera(), cMo[i][0][3] / cMo[i][2][3], cMo[i][1][3] / cMo[i][2][3], u,
                                         v);
    EXPECT_NEAR(detector.getCenter(i).get_u(), u, 1e-9);
    EXPECT_NEAR(detector.getCenter(i).get_v(), v, 1e-9);
    // And the true one, which the centre of the ellipse is not.
    const Eigen::Vector3d t = translationOf(scene.poses[i]);
    EXPECT_NEAR(detector.getCenter(i).get_u(), 319.5 + focal * t.x() / t.z(), 0.05);
    EXPECT_NEAR(detector.getCenter(i).get_v(), 239.5 + focal * t.y() / t.z(), 0.05);
    EXPECT_GT(vpImagePoint::distance(detector.getCenter(i), detector.getDetections()[i].ellipse.center), 0.2);
  }
}

TEST(DetectorInterface, CenterOfABentSheetIsThatOfThePose)
{
  // The middle of the print stands out of the plane in which the ring lies in the mean, and the pose is of that plane.
  Random random = randomOfTest();
  const vpHomogeneousMatrix truth = randomPose(random, 150., 0.8, 320., 240.);
  vpSimulatedMarker marker = printed(vpCircleMarkerFamily::GOLAY23, 5).setPose(truth);
  const vpImage<unsigned char> I = imageOf(marker.setBow(0.008), random);
  vpDetectorCircleMarker detector;
  std::vector<vpHomogeneousMatrix> cMo;
  ASSERT_TRUE(detector.detect(I, size, straightCamera(), cMo));
  double u = 0., v = 0.;
  vpMeterPixelConversion::convertPoint(straightCamera(), cMo[0][0][3] / cMo[0][2][3], cMo[0][1][3] / cMo[0][2][3], u,
                                       v);
  EXPECT_NEAR(detector.getCenter(0).get_u(), u, 1e-9);
  EXPECT_NEAR(detector.getCenter(0).get_v(), v, 1e-9);
}

TEST(DetectorInterface, EllipseIsThatOfTheRing)
{
  Random random = randomOfTest();
  for (int i = 0; i < 5; ++i) {
    vpMarkerSceneSimulator simulator(straightCamera(), width, height);
    simulator.addMarker(printed(vpCircleMarkerFamily::GOLAY23, i).setPose(randomPose(random, 90., 0.7)));
    vpImage<unsigned char> I;
    const vpEllipseTruth truth = *simulator.render(I, random())[0].ellipse;
    vpDetectorCircleMarker detector;
    std::vector<vpHomogeneousMatrix> cMo;
    ASSERT_TRUE(detector.detect(I, size, straightCamera(), cMo));
    const vpImageEllipse &found = detector.getDetections()[0].ellipse;
    EXPECT_LT(vpImagePoint::distance(found.center, truth.center), 0.05);
    EXPECT_NEAR(found.a, truth.semiAxisA, 0.05);
    EXPECT_NEAR(found.b, truth.semiAxisB, 0.05);
    EXPECT_NEAR(std::remainder(found.angle - truth.angle, M_PI), 0., 0.005);
  }
}
