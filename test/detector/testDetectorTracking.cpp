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
 * Tests of the detector that follows markers: what it finds is what a search of the whole image finds.
 */

#include <gtest/gtest.h>

#include <algorithm>

#include <visp3/core/vpException.h>

#include "detector_scenes.h"

using namespace detector_test;

namespace {
//! A marker on its way through the image: a drift, a turn, and an approach.
struct Flight
{
  vpCircleMarkerFamily family;
  int id = -1;
  Eigen::Vector3d start; // of its centre, metres
  Eigen::Vector3d speed; // metres an image
  double tilt = 0.4;     // rad
  double turn = 0.02;    // about the line of sight, rad an image
  Eigen::Vector3d axis{1., 0.5, 0.};

  vpHomogeneousMatrix poseAt(int image) const
  {
    return poseOf(detector_test::turn(tilt, axis) * detector_test::turn(turn * image, Eigen::Vector3d::UnitZ()),
                  start + image * speed);
  }
};

vpImage<unsigned char> imageAt(const std::vector<Flight> &flights, int image, std::uint64_t background, Random &random)
{
  vpMarkerSceneSimulator simulator(straightCamera(), width, height);
  simulator.setBackground(
      vpSceneBackground::clutter(background, 30)); // which has discs of its own: none are looked for
  for (const Flight &flight : flights) {
    vpSimulatedMarker marker = printed(flight.family, flight.id);
    simulator.addMarker(marker.setPose(flight.poseAt(image)));
  }
  vpImage<unsigned char> I;
  simulator.render(I, random());
  return I;
}

//! Whether the other pose was not measured on all pixels: log-odds of 30 on the few are more on all.
bool isGivenUp(const vpCircleMarkerDetection &detection)
{
  return detection.logOdds > 30.;
}

//! The detections nearest to each other are the same markers at the same poses.
void expectSameMarkers(vpDetectorCircleMarker &followed, vpDetectorCircleMarker &whole)
{
  ASSERT_EQ(followed.getDetections().size(), whole.getDetections().size());
  for (std::size_t i = 0; i < whole.getDetections().size(); ++i) {
    const vpCircleMarkerDetection &p = followed.getDetections()[i];
    const vpCircleMarkerDetection &q = whole.getDetections()[i];
    EXPECT_EQ(followed.getMessage(i), whole.getMessage(i));
    EXPECT_EQ(p.hamming, q.hamming);
    EXPECT_NEAR(p.visible, q.visible, 0.03); // two points of a hundred
    // Where the outline's edge points round to another pixel the refinement starts elsewhere and ends within its last
    // step: a thousandth of a standard deviation, which is a few thousandths of a pixel.
    EXPECT_LT(vpImagePoint::distance(p.center, q.center), 1e-3);
    EXPECT_LT(differenceOf(p.cMo, q.cMo), 1e-4);
    // Infinite if both starts lead to one pose, which then is the only one.
    EXPECT_EQ(std::isinf(p.logOdds), std::isinf(q.logOdds));
    // A pose that is given up early is judged by a few hundred pixels, in rows that begin at the outline, and where its
    // steps were cut off, on its way from there: its log-odds of hundreds are others where the outline is.
    if (!std::isinf(q.logOdds)) {
      EXPECT_NEAR(p.logOdds, q.logOdds, (isGivenUp(q) ? 0.3 : 0.01) * q.logOdds + 0.1);
      EXPECT_EQ(isGivenUp(p), isGivenUp(q));
    }
  }
}

bool searchedAll(const vpDetectorCircleMarker &detector)
{
  return detector.getSearchedRegions().size() == 1 && detector.getSearchedRegions()[0].getWidth() == width &&
         detector.getSearchedRegions()[0].getHeight() == height;
}
} // namespace

class TrackedFamily : public testing::TestWithParam<vpCircleMarkerFamily::vpType>
{
};

TEST_P(TrackedFamily, MovingMarkersAreFoundAsInTheWholeImage)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(GetParam());
  const std::vector<Flight> flights = {
      {family, randomId(random, family), {-0.35, -0.1, 1.3}, {0.006, 0.002, -0.01}},
      {family, randomId(random, family), {0.4, 0.2, 2.}, {-0.004, -0.003, 0.005}, 0.7, -0.01, {0.2, 1., 0.}}};
  const std::uint64_t background = random();
  vpDetectorCircleMarker followed(family);
  vpDetectorCircleMarker whole(family);
  constexpr unsigned int period = 8;
  followed.setTracking(true, period);
  std::vector<vpHomogeneousMatrix> poses;
  int inRegions = 0;
  constexpr int images = 25;
  for (int k = 0; k < images; ++k) {
    const vpImage<unsigned char> I = imageAt(flights, k, background, random);
    followed.detect(I, size, straightCamera(), poses);
    whole.detect(I, size, straightCamera(), poses);
    ASSERT_EQ(whole.getNbObjects(), 2u) << "image " << k;
    ASSERT_NO_FATAL_FAILURE(expectSameMarkers(followed, whole)) << "image " << k;
    EXPECT_EQ(searchedAll(followed), k % period == 0) << "image " << k;
    inRegions += searchedAll(followed) ? 0 : 1;
    double area = 0.;
    for (const vpRect &region : followed.getSearchedRegions()) {
      area += region.getWidth() * region.getHeight();
    }
    EXPECT_TRUE(searchedAll(followed) || area < 0.35 * width * height) << area;
  }
  EXPECT_GE(inRegions, images * 3 / 4);
}

INSTANTIATE_TEST_SUITE_P(Families, TrackedFamily,
                         testing::Values(vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31R,
                                         vpCircleMarkerFamily::RING));

TEST(DetectorTracking, ALostMarkerIsFoundAgain)
{
  Random random = randomOfTest();
  const Flight flight = {vpCircleMarkerFamily::GOLAY23, 17, {-0.3, 0., 1.5}, {0.004, 0., 0.}};
  const std::uint64_t background = random();
  vpDetectorCircleMarker detector;
  detector.setTracking(true, 100);
  std::vector<vpHomogeneousMatrix> poses;
  const auto look = [&](const std::vector<Flight> &flights, int image) {
    detector.detect(imageAt(flights, image, background, random), size, straightCamera(), poses);
    return detector.getNbObjects();
  };
  for (int k = 0; k < 4; ++k) {
    ASSERT_EQ(look({flight}, k), 1u);
    EXPECT_EQ(searchedAll(detector), k == 0);
  }
  // It jumps: its region is empty, and the whole image is searched at once.
  Flight elsewhere = flight;
  elsewhere.start.x() += 0.5;
  ASSERT_EQ(look({elsewhere}, 4), 1u);
  EXPECT_TRUE(searchedAll(detector));
  EXPECT_EQ(detector.getTagsId(), std::vector<int>({17}));
  ASSERT_EQ(look({elsewhere}, 5), 1u);
  EXPECT_FALSE(searchedAll(detector));
  // It is gone: whole images until it is there again.
  for (int k = 6; k < 9; ++k) {
    EXPECT_EQ(look({}, k), 0u);
    EXPECT_TRUE(searchedAll(detector));
  }
  ASSERT_EQ(look({flight}, 9), 1u);
  ASSERT_EQ(look({flight}, 10), 1u);
  EXPECT_FALSE(searchedAll(detector));
}

TEST(DetectorTracking, AMarkerThatIsGoneForAWhileIsFoundWhereItWas)
{
  Random random = randomOfTest();
  const Flight stays = {vpCircleMarkerFamily::GOLAY23, 3, {-0.4, 0.1, 1.6}, {0.003, 0., 0.}};
  const Flight goes = {vpCircleMarkerFamily::GOLAY23, 4, {0.4, -0.1, 1.6}, {0., 0.002, 0.}};
  const std::uint64_t background = random();
  vpDetectorCircleMarker detector;
  detector.setTracking(true, 1000);
  std::vector<vpHomogeneousMatrix> poses;
  for (int k = 0; k < 12; ++k) {
    const bool isThere = k < 3 || k >= 8;
    const std::vector<Flight> flights = isThere ? std::vector<Flight>{stays, goes} : std::vector<Flight>{stays};
    detector.detect(imageAt(flights, k, background, random), size, straightCamera(), poses);
    EXPECT_EQ(detector.getNbObjects(), flights.size()) << k;
    EXPECT_EQ(searchedAll(detector), k == 0 || k == 3) << k;
  }
}

// The outline of the image before then lies on the outer edge of the track, where black sectors have white around them.
TEST(DetectorTracking, ASizeThatJumpsIsNotTakenForACoveredMarker)
{
  constexpr double outerEdgeOfTrack = 0.68;
  Random random = randomOfTest();
  for (int i = 0; i < 12; ++i) {
    const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
    const int id = randomId(random, family);
    const double tilt = uniform(random, 0.1, 0.9);
    const Eigen::Vector3d start(uniform(random, -0.15, 0.15), uniform(random, -0.15, 0.15), uniform(random, 1.2, 2.4));
    const std::uint64_t background = random();
    vpDetectorCircleMarker followed;
    vpDetectorCircleMarker whole;
    followed.setTracking(true, 1000);
    std::vector<vpHomogeneousMatrix> poses;
    for (int k = 0; k < 3; ++k) {
      const double nearer = k < 2 ? 1. : outerEdgeOfTrack;
      const Flight flight = {family, id, nearer * start, Eigen::Vector3d::Zero(), tilt, 0.};
      const vpImage<unsigned char> I = imageAt({flight}, k, background, random);
      followed.detect(I, size, straightCamera(), poses);
      whole.detect(I, size, straightCamera(), poses);
      ASSERT_EQ(whole.getNbObjects(), 1u);
      EXPECT_NO_FATAL_FAILURE(expectSameMarkers(followed, whole)) << i << ", image " << k;
    }
  }
}

TEST(DetectorTracking, ANewMarkerAppearsAtTheNextWholeSearch)
{
  Random random = randomOfTest();
  const Flight first = {vpCircleMarkerFamily::GOLAY23, 3, {-0.4, 0.1, 1.6}, {0.003, 0., 0.}};
  const Flight second = {vpCircleMarkerFamily::GOLAY23, 4, {0.4, -0.1, 1.6}, {0., 0.002, 0.}};
  const std::uint64_t background = random();
  vpDetectorCircleMarker detector;
  constexpr int period = 6;
  detector.setTracking(true, period);
  std::vector<vpHomogeneousMatrix> poses;
  for (int k = 0; k < 2 * period; ++k) {
    const std::vector<Flight> flights = k < 2 ? std::vector<Flight>{first} : std::vector<Flight>{first, second};
    detector.detect(imageAt(flights, k, background, random), size, straightCamera(), poses);
    EXPECT_EQ(searchedAll(detector), k % period == 0) << k;
    EXPECT_EQ(detector.getNbObjects(), k < period ? 1u : 2u) << k;
  }
}

TEST(DetectorTracking, MarkersThatLeaveTheImageAndGrow)
{
  Random random = randomOfTest();
  // Out of the image to the left, and toward the camera until it does not fit any more.
  const Flight leaving = {vpCircleMarkerFamily::GOLAY23, 8, {-0.3, 0., 1.5}, {-0.03, 0., 0.}};
  const Flight nearing = {vpCircleMarkerFamily::GOLAY23, 9, {0.1, 0., 1.5}, {-0.003, 0., -0.06}};
  for (const Flight &flight : {leaving, nearing}) {
    const std::uint64_t background = random();
    vpDetectorCircleMarker followed;
    vpDetectorCircleMarker whole;
    followed.setTracking(true, 1000);
    std::vector<vpHomogeneousMatrix> poses;
    std::size_t found = 0;
    for (int k = 0; k < 20; ++k) {
      const vpImage<unsigned char> I = imageAt({flight}, k, background, random);
      followed.detect(I, size, straightCamera(), poses);
      whole.detect(I, size, straightCamera(), poses);
      ASSERT_NO_FATAL_FAILURE(expectSameMarkers(followed, whole)) << "image " << k;
      found += whole.getNbObjects();
    }
    EXPECT_GT(found, 5u);
  }
}

TEST(DetectorTracking, ASearchWithoutTimeForAllDoesNotCount)
{
  // Whatever the timeout leaves of the first search, from nothing to all of it: two images later all are there.
  Random random = randomOfTest();
  std::vector<Flight> flights;
  for (int k = 0; k < 24; ++k) {
    const Eigen::Vector3d center(-0.8 + 0.32 * (k % 6), -0.45 + 0.3 * (k / 6), 2.2);
    flights.push_back({vpCircleMarkerFamily::GOLAY23, k, center, {0., 0., 0.}});
  }
  const vpImage<unsigned char> I = imageAt(flights, 0, 7, random);
  std::vector<vpHomogeneousMatrix> poses;
  for (const unsigned int milliseconds : {1U, 2U, 4U, 8U, 16U}) {
    vpDetectorCircleMarker detector;
    detector.setTracking(true, 1000);
    detector.setTimeout(milliseconds);
    detector.detect(I, size, straightCamera(), poses);
    detector.setTimeout(0);
    detector.detect(I, size, straightCamera(), poses);
    detector.detect(I, size, straightCamera(), poses);
    EXPECT_EQ(detector.getNbObjects(), flights.size()) << milliseconds << " ms";
  }
}

TEST(DetectorTracking, PosesCanBeHadForAnotherSize)
{
  Random random = randomOfTest();
  const Flight flight = {vpCircleMarkerFamily::GOLAY23, 17, {-0.1, 0., 1.2}, {0.01, 0.005, 0.}};
  vpDetectorCircleMarker detector;
  detector.setTracking(true, 100);
  std::vector<vpHomogeneousMatrix> poses;
  for (int k = 0; k < 5; ++k) {
    detector.detect(imageAt({flight}, k, 7, random), size, straightCamera(), poses);
    ASSERT_EQ(poses.size(), 1u);
    vpHomogeneousMatrix other;
    ASSERT_TRUE(detector.getPose(0, 2. * size, straightCamera(), other));
    EXPECT_LT((translationOf(other) - 2. * translationOf(poses[0])).norm(), 1e-3);
  }
}

TEST(DetectorTracking, AnythingElseThanTheNextImageStartsAnew)
{
  Random random = randomOfTest();
  const Flight flight = {vpCircleMarkerFamily::GOLAY23, 17, {-0.1, 0., 1.2}, {0.01, 0., 0.}};
  const vpImage<unsigned char> I = imageAt({flight}, 0, 7, random);
  vpDetectorCircleMarker detector;
  detector.setTracking(true, 100);
  detector.detect(I);
  EXPECT_TRUE(searchedAll(detector));
  detector.detect(I);
  EXPECT_FALSE(searchedAll(detector));
  // Another family: the markers that were followed are none of it.
  detector.setFamily(vpCircleMarkerFamily::BCH31);
  EXPECT_FALSE(detector.detect(I));
  EXPECT_TRUE(searchedAll(detector));
  detector.setFamily(vpCircleMarkerFamily::GOLAY23);
  EXPECT_TRUE(detector.detect(I));
  EXPECT_TRUE(searchedAll(detector));
  EXPECT_TRUE(detector.detect(I));
  EXPECT_FALSE(searchedAll(detector));
  // Another size of images.
  detector.detect(vpImage<unsigned char>(100, 100, 90));
  EXPECT_EQ(detector.getSearchedRegions()[0].getWidth(), 100.);
  detector.setTracking(false);
  for (int k = 0; k < 3; ++k) {
    EXPECT_TRUE(detector.detect(I));
    EXPECT_TRUE(searchedAll(detector));
  }
  EXPECT_THROW(detector.setTracking(true, 0), vpException);
}
