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
 * The interface of vpDetectorCircleMarker: messages, frames, sizes, copies.
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
    ASSERT_TRUE(detector.getPose(i, 3. * size, straightCamera(), pose));
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

TEST(DetectorInterface, TwoFamiliesInOneImage)
{
  Random random = randomOfTest();
  const vpImage<unsigned char> I =
      imageOf(straightCamera(),
              {printed(vpCircleMarkerFamily::BCH31, 1234).setPose(randomPose(random, 120., 0.4, 170., 240.)),
               printed(vpCircleMarkerFamily::GOLAY23, 3).setPose(randomPose(random, 90., 0.4, 460., 240.))},
              random);
  vpDetectorCircleMarker detector(vpCircleMarkerFamily::GOLAY23);
  ASSERT_TRUE(detector.detect(I));
  ASSERT_EQ(detector.getNbObjects(), 1u);
  EXPECT_EQ(detector.getMessage(0), "golay23 id: 3");
  detector.setFamilies({vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31});
  ASSERT_TRUE(detector.detect(I));
  ASSERT_EQ(detector.getNbObjects(), 2u);
  EXPECT_EQ(detector.getMessage(0), "bch31 id: 1234");
  EXPECT_EQ(detector.getMessage(1), "golay23 id: 3");
  detector.setFamily(vpCircleMarkerFamily::BCH31);
  ASSERT_TRUE(detector.detect(I));
  EXPECT_EQ(detector.getTagsId(), std::vector<int>({1234}));
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

TEST(DetectorInterface, MarginCanBeDemanded)
{
  TwoMarkers scene;
  vpDetectorCircleMarker detector;
  detector.setMinimumMargin(1.);
  EXPECT_FALSE(detector.detect(scene.I));
  detector.setMinimumMargin(0.);
  detector.setMaximumHammingDistance(0);
  ASSERT_TRUE(detector.detect(scene.I));
  EXPECT_EQ(detector.getNbObjects(), 2u);
}

TEST(DetectorInterface, CorrectionCanBeForbidden)
{
  // Markers whose print has one wrong sector, or two.
  constexpr int count = 20;
  const vpCircleMarkerFamily golay(vpCircleMarkerFamily::GOLAY23);
  const vpCircleMarkerLayout &layout = golay.getLayout();
  Random random = randomOfTest();
  for (const unsigned int wrong : {1u, 2u}) {
    int corrected = 0;
    int forbidden = 0;
    for (int i = 0; i < count; ++i) {
      const int id = randomId(random, golay);
      std::uint32_t word = vpSimulatedMarker::codewords("golay23")[static_cast<std::size_t>(id)];
      const unsigned int first = static_cast<unsigned int>(random() % 23);
      word ^= 1U << first;
      word ^= wrong == 2 ? 1U << ((first + 1 + random() % 22) % 23) : 0U;
      vpSimulatedMarker marker = vpSimulatedMarker::rings({{layout.ringInner, 1.}}, size);
      marker.setTrack(layout.codeInner, layout.codeOuter, 23, word);
      marker.setPose(randomPose(random, 90., uniform(random, 0.1, 0.8)));
      const vpImage<unsigned char> I = imageOf(straightCamera(), {marker}, random);
      vpDetectorCircleMarker detector;
      if (detector.detect(I)) {
        EXPECT_EQ(detector.getTagsId(), std::vector<int>({id}));
        corrected += detector.getHammingDistance(0) == wrong ? 1 : 0;
      }
      detector.setMaximumHammingDistance(wrong - 1);
      forbidden += detector.detect(I) ? 1 : 0;
    }
    EXPECT_GE(corrected, count - 2) << wrong;
    EXPECT_LE(forbidden, count / 2) << wrong << ": a wrong sector can pass for one that something covers";
  }
}

// Sectors of a pixel or two cannot be read for certain one by one: all together they prove a code, which is as much as
// the usual settings ask for, but not who asks for more.
TEST(DetectorInterface, DoubtfulReadingsAreNoneForWhoAsksForMore)
{
  constexpr int images = 30;
  constexpr double usualMargin = 0.6; // what is asked for unless said otherwise
  constexpr double demanded = 0.9;
  Random random = randomOfTest();
  std::size_t usual = 0;
  std::size_t uncorrected = 0;
  std::size_t clear = 0;
  for (int i = 0; i < images; ++i) {
    const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
    vpMarkerSceneSimulator simulator(straightCamera(), width, height);
    simulator.setBackground(vpSceneBackground::plain(220.));
    vpSimulatedMarker marker = printed(family, randomId(random, family));
    simulator.addMarker(marker.setPose(randomPose(random, uniform(random, 9., 13.), uniform(random, 0., 0.6))));
    vpImage<unsigned char> I;
    simulator.render(I, random());
    vpDetectorCircleMarker detector;
    detector.detect(I);
    usual += detector.getNbObjects();
    vpDetectorCircleMarker withoutCorrection;
    withoutCorrection.setMaximumHammingDistance(0);
    withoutCorrection.detect(I);
    uncorrected += withoutCorrection.getNbObjects();
    for (const vpCircleMarkerDetection &detection : withoutCorrection.getDetections()) {
      EXPECT_GE(detection.margin, usualMargin) << i;
    }
    vpDetectorCircleMarker withMargin;
    withMargin.setMinimumMargin(demanded);
    withMargin.detect(I);
    clear += withMargin.getNbObjects();
    for (const vpCircleMarkerDetection &detection : withMargin.getDetections()) {
      EXPECT_GE(detection.margin, demanded) << i;
    }
  }
  EXPECT_LT(uncorrected, usual);
  EXPECT_LT(clear, usual);
}

// Half of the sectors of another family's marker agree with some codeword, and the others are not what covers it.
// Before that was asked, 22 of these were read.
TEST(DetectorInterface, MarkersOfAnotherFamilyAreNotRead)
{
  constexpr int frames = 30;
  constexpr unsigned int most = 2;
  using Family = vpCircleMarkerFamily;
  Random random = randomOfTest();
  unsigned int wrong = 0;
  for (const auto &[shown, sought] : {std::pair{Family::GOLAY23, Family::BCH31R},
                                      {Family::GOLAY23, Family::BCH31},
                                      {Family::BCH31, Family::GOLAY23},
                                      {Family::BCH31R, Family::GOLAY23}}) {
    vpDetectorCircleMarker detector(sought);
    for (int frame = 0; frame < frames; ++frame) {
      vpMarkerSceneSimulator simulator(straightCamera(), width, height);
      std::vector<vpSimulatedMarker> markers;
      for (const double u : {170., 460.}) {
        const vpHomogeneousMatrix cMo =
            randomPose(random, uniform(random, 40., 160.), uniform(random, 0., 0.8), u, 240.);
        markers.push_back(printed(shown, randomId(random, shown)).setPose(cMo));
        simulator.addMarker(markers.back());
      }
      vpImage<unsigned char> I;
      simulator.render(I, random());
      detector.detect(I);
      wrong += static_cast<unsigned int>(detector.getNbObjects());
    }
  }
  EXPECT_LE(wrong, most) << "of " << 8 * frames;
}
