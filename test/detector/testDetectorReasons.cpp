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
 * Tests of the reasons why candidates are no markers.
 */

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "detector_scenes.h"

using namespace detector_test;
using Reject = vpCircleMarkerReject;

namespace {
vpImage<unsigned char> sheet(unsigned char grey = 220)
{
  return vpImage<unsigned char>(height, width, grey);
}

cv::Mat pixelsOf(vpImage<unsigned char> &I)
{
  return cv::Mat(static_cast<int>(I.getHeight()), static_cast<int>(I.getWidth()), CV_8U, I.bitmap);
}

//! Reasons of the outlines around a point, latest last; of chains there, if there is no outline.
std::set<Reject> reasonsAt(const vpDetectorCircleMarker &detector, double u, double v)
{
  std::set<Reject> outlines, chains;
  for (const vpCircleMarkerCandidate &candidate : detector.getRejectedCandidates()) {
    const vpImagePoint place = candidate.ellipse.a > 0. ? candidate.ellipse.center : candidate.points.front();
    const double reach = candidate.ellipse.a > 0. ? 5. : 120.;
    if (vpImagePoint::distance(place, vpImagePoint(v, u)) < reach) {
      (candidate.isOutline ? outlines : chains).insert(candidate.reason);
    }
  }
  return outlines.empty() ? chains : outlines;
}

constexpr double middleU = 320.;
constexpr double middleV = 240.;

//! Reasons for what is drawn in the middle of a white sheet.
template <class Draw> std::set<Reject> reasonsFor(vpDetectorCircleMarker &detector, const Draw &draw)
{
  vpImage<unsigned char> I = sheet();
  cv::Mat pixels = pixelsOf(I);
  draw(pixels);
  cv::GaussianBlur(pixels, pixels, cv::Size(), 0.7);
  detector.setDebug(true);
  detector.detect(I);
  return reasonsAt(detector, middleU, middleV);
}

const cv::Point middle(320, 240);

void drawRing(cv::Mat &pixels, int outer, int inner, int ink = 30, int inside = 220)
{
  cv::circle(pixels, middle, outer, cv::Scalar(ink), cv::FILLED, cv::LINE_AA);
  cv::circle(pixels, middle, inner, cv::Scalar(inside), cv::FILLED, cv::LINE_AA);
}
} // namespace

TEST(DetectorReasons, OfThingsThatAreNoMarkers)
{
  vpDetectorCircleMarker coded;
  vpDetectorCircleMarker ring(vpCircleMarkerFamily::RING);
  vpDetectorCircleMarker disc(vpCircleMarkerFamily::DISC);
  const auto square = [](cv::Mat &pixels) {
    cv::rectangle(pixels, middle - cv::Point(40, 40), middle + cv::Point(40, 40), cv::Scalar(30), 8);
  };
  for (const Reject reason : reasonsFor(coded, square)) {
    EXPECT_TRUE(reason == Reject::BAD_FIT || reason == Reject::LITTLE_BEND || reason == Reject::NOT_AN_ELLIPSE ||
                reason == Reject::BRIGHT_INSIDE || reason == Reject::LITTLE_SUPPORT)
        << vpCircleMarkerRejectName(reason);
  }
  EXPECT_FALSE(reasonsFor(coded, square).empty());
  const auto bright = [](cv::Mat &pixels) {
    pixels = 30;
    cv::circle(pixels, middle, 40, cv::Scalar(220), cv::FILLED, cv::LINE_AA);
  };
  EXPECT_EQ(reasonsFor(coded, bright).count(Reject::BRIGHT_INSIDE), 1u);
  const auto blackDisc = [](cv::Mat &pixels) { drawRing(pixels, 40, 0, 30, 30); };
  EXPECT_EQ(reasonsFor(coded, blackDisc).count(Reject::OTHER_CENTER), 1u);
  const auto plainRing = [](cv::Mat &pixels) { drawRing(pixels, 40, 32); };
  EXPECT_EQ(reasonsFor(coded, plainRing), std::set<Reject>({Reject::NO_SECTORS}));
  const auto ofRing = [](int outer, int inner) {
    return [outer, inner](cv::Mat &pixels) { drawRing(pixels, outer, inner); };
  };
  EXPECT_EQ(reasonsFor(ring, ofRing(3, 1)), std::set<Reject>({Reject::TOO_SMALL}));
  EXPECT_EQ(reasonsFor(coded, ofRing(3, 2)), std::set<Reject>({Reject::TOO_SMALL}));
  EXPECT_EQ(reasonsFor(ring, ofRing(5, 2)), std::set<Reject>({Reject::UNLIKE_THE_MODEL}));
  EXPECT_EQ(reasonsFor(ring, ofRing(6, 3)).count(Reject::NO_RING), 1u) << "twice as thick as the family's";
  EXPECT_EQ(reasonsFor(ring, ofRing(6, 4)), std::set<Reject>({Reject::KNOWN_OUTLINE})) << "found, and at half size";
  disc.setFamilies({vpCircleMarkerFamily::DISC, vpCircleMarkerFamily::GOLAY23}); // both centres are looked at
  const std::set<Reject> asDisc = reasonsFor(disc, plainRing);
  EXPECT_EQ(asDisc.count(Reject::OTHER_SHAPE), 1u);
  EXPECT_EQ(asDisc.count(Reject::NO_SECTORS), 1u);
  const auto dented = [](cv::Mat &pixels) {
    drawRing(pixels, 40, 32);
    cv::circle(pixels, middle + cv::Point(-35, 0), 12, cv::Scalar(30), cv::FILLED, cv::LINE_AA);
    cv::circle(pixels, middle + cv::Point(25, 15), 15, cv::Scalar(30), cv::FILLED, cv::LINE_AA);
  };
  EXPECT_EQ(reasonsFor(ring, dented).count(Reject::NOT_ALL_AROUND), 1u);
  // A quarter of a ring lies beyond the image.
  vpImage<unsigned char> I = sheet();
  cv::Mat pixels = pixelsOf(I);
  cv::circle(pixels, cv::Point(20, 240), 36, cv::Scalar(30), 8, cv::LINE_AA);
  coded.detect(I);
  EXPECT_EQ(reasonsAt(coded, 20., 240.), std::set<Reject>({Reject::OUT_OF_IMAGE}));
}

// Rings of several ratios have one name. Why one behind a bar is not of the one ratio is known whatever it is of the
// other.
TEST(DetectorReasons, RingsOfSeveralRatiosHaveEachTheirOwn)
{
  const vpCircleMarkerFamily thin = vpCircleMarkerFamily::ring(0.8);
  vpDetectorCircleMarker detector;
  detector.setFamilies({thin, vpCircleMarkerFamily::ring(0.6)});
  const auto behindABar = [](cv::Mat &pixels) {
    drawRing(pixels, 80, 48);
    cv::line(pixels, middle + cv::Point(25, -120), middle + cv::Point(35, 120), cv::Scalar(150), 25);
  };
  reasonsFor(detector, behindABar);
  const auto &rejected = detector.getRejectedCandidates();
  const auto isThin = [&](const vpCircleMarkerCandidate &candidate) {
    return candidate.isOutline && candidate.family.getLayout().ringInner == thin.getLayout().ringInner;
  };
  EXPECT_TRUE(std::any_of(rejected.begin(), rejected.end(), isThin));
}

TEST(DetectorReasons, ACodeThatIsHalfCoveredHasALowMarginOrNoCodeword)
{
  Random random = randomOfTest();
  vpImage<unsigned char> I = imageOf(
      printed(vpCircleMarkerFamily::GOLAY23, 5).setPose(randomPose(random, 120., 0.1, middleU, middleV)), random);
  vpDetectorCircleMarker detector;
  ASSERT_TRUE(detector.detect(I));
  detector.setMinimumMargin(1.);
  detector.setDebug(true);
  EXPECT_FALSE(detector.detect(I));
  const std::vector<vpCircleMarkerCandidate> rejected = detector.getRejectedCandidates();
  const auto low = std::find_if(rejected.begin(), rejected.end(), [](const vpCircleMarkerCandidate &candidate) {
    return candidate.reason == Reject::LOW_MARGIN && candidate.id == 5;
  });
  ASSERT_NE(low, rejected.end());
  EXPECT_NE(low->getText().find("low margin"), std::string::npos);
  // White over the code of one half: the ring stays.
  cv::Mat pixels = pixelsOf(I);
  cv::ellipse(pixels, middle, cv::Size(39, 39), 0., 0., 180., cv::Scalar(225), cv::FILLED);
  detector.setMinimumMargin(0.6);
  EXPECT_FALSE(detector.detect(I));
  const std::set<Reject> reasons = reasonsAt(detector, middleU, middleV);
  EXPECT_TRUE(
      reasons.count(Reject::NO_CODEWORD) + reasons.count(Reject::LOW_MARGIN) + reasons.count(Reject::NO_SECTORS) > 0u);
}

TEST(DetectorReasons, WithoutTimeTheReasonIsThat)
{
  vpImage<unsigned char> I = sheet();
  cv::Mat pixels = pixelsOf(I);
  for (int y = 14; y + 14 <= pixels.rows; y += 28) {
    for (int x = 14; x + 14 <= pixels.cols; x += 28) {
      cv::circle(pixels, cv::Point(x, y), 12, cv::Scalar(30), 2, cv::LINE_AA);
    }
  }
  vpDetectorCircleMarker detector;
  detector.setDebug(true);
  detector.setTimeout(1);
  bool isHasty = false;
  for (int i = 0; i < 20 && !isHasty; ++i) { // a millisecond is enough on no machine, but the clock decides
    detector.detect(I);
    const std::vector<vpCircleMarkerCandidate> rejected = detector.getRejectedCandidates();
    isHasty = rejected.empty() || std::any_of(rejected.begin(), rejected.end(), [](const vpCircleMarkerCandidate &c) {
                return c.reason == Reject::TIMEOUT;
              });
    EXPECT_TRUE(detector.hasTimedOut() || !isHasty);
  }
  EXPECT_TRUE(isHasty);
  detector.setTimeout(0); // for ever
  detector.detect(I);
  EXPECT_FALSE(detector.hasTimedOut());
}

// As cameras of notebooks show their users. Of these ids some are near to another marker, or to themselves, in a
// mirror.
TEST(DetectorReasons, MarkersInAMirrorAreSaidToBe)
{
  Random random = randomOfTest();
  vpMarkerSceneSimulator simulator(straightCamera(), width, height);
  const int ids[] = {0, 7, 15, 25, 38, 39, 43, 65, 73, 77, 100, 177};
  for (int i = 0; i < 12; ++i) {
    const vpHomogeneousMatrix cMo =
        randomPose(random, 100., 0.6, 80. + 160. * (i % 4), 80. + 160. * (i / 4)); // the centre, pixels
    simulator.addMarker(printed(vpCircleMarkerFamily::GOLAY23, ids[i]).setPose(cMo));
  }
  vpImage<unsigned char> I;
  simulator.render(I, random());
  vpDetectorCircleMarker detector;
  detector.detect(I);
  EXPECT_EQ(detector.getNbObjects(), 12u);
  cv::Mat pixels = pixelsOf(I);
  cv::flip(pixels.clone(), pixels, 1);
  detector.setDebug(true);
  EXPECT_FALSE(detector.detect(I)) << detector.getMessage(0);
  const std::vector<vpCircleMarkerCandidate> rejected = detector.getRejectedCandidates();
  EXPECT_GE(std::count_if(rejected.begin(), rejected.end(),
                          [](const vpCircleMarkerCandidate &c) { return c.reason == Reject::MIRRORED; }),
            12);
}

// Whenever the time is over, nothing is said to lie inside of a marker that was not found.
TEST(DetectorReasons, WithoutTimeNothingIsInsideOfWhatWasNotFound)
{
  Random random = randomOfTest();
  vpMarkerSceneSimulator simulator(straightCamera(), width, height);
  for (int i = 0; i < 12; ++i) {
    const vpHomogeneousMatrix cMo =
        randomPose(random, 100., 0.3, 80. + 160. * (i % 4), 80. + 160. * (i / 4)); // the centre, pixels
    simulator.addMarker(printed(vpCircleMarkerFamily::GOLAY23, i).setPose(cMo));
  }
  vpImage<unsigned char> I;
  simulator.render(I, random());
  vpDetectorCircleMarker detector;
  detector.setDebug(true);
  for (int timeout = 1; timeout <= 12; ++timeout) { // milliseconds: the clock decides what is measured
    detector.setTimeout(timeout);
    detector.detect(I);
    for (const vpCircleMarkerCandidate &candidate : detector.getRejectedCandidates()) {
      if (candidate.reason == Reject::INSIDE_OF_A_MARKER) {
        const auto &found = detector.getDetections();
        EXPECT_TRUE(std::any_of(found.begin(), found.end(),
                                [&](const vpCircleMarkerDetection &marker) {
                                  return vpImagePoint::distance(marker.center, candidate.ellipse.center) < 60.;
                                }))
            << timeout << " ms";
      }
    }
  }
}

TEST(DetectorReasons, EveryReasonHasAName)
{
  std::set<std::string> names;
  for (int reason = 0; reason <= static_cast<int>(Reject::TIMEOUT); ++reason) {
    const std::string name = vpCircleMarkerRejectName(static_cast<Reject>(reason));
    EXPECT_NE(name, "unknown");
    EXPECT_TRUE(names.insert(name).second) << name;
  }
}
