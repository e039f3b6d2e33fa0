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
 * Tests of the detector's account of what its rooms see.
 */

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "detector_scenes.h"

using namespace detector_test;
using Reject = vpCircleMarkerReject;

namespace {
cv::Mat pixelsOf(vpImage<unsigned char> &I)
{
  return cv::Mat(static_cast<int>(I.getHeight()), static_cast<int>(I.getWidth()), CV_8U, I.bitmap);
}

//! How many candidates have which reason, where the marker of an id is found and no other, on so many threads.
std::map<Reject, unsigned int> countsOf(const vpImage<unsigned char> &I, int id, unsigned int threads)
{
  vpDetectorCircleMarker detector;
  detector.setNbThreads(threads);
  detector.setDebug(true);
  detector.detect(I);
  EXPECT_EQ(detector.getTagsId(), std::vector<int>({id}));
  std::map<Reject, unsigned int> counts;
  for (const vpCircleMarkerCandidate &candidate : detector.getRejectedCandidates()) {
    ++counts[candidate.reason];
  }
  return counts;
}

constexpr double middleU = 320.;
constexpr double middleV = 240.;
} // namespace

TEST(DetectorDebug, NothingIsKeptUnlessAsked)
{
  Random random = randomOfTest();
  const vpImage<unsigned char> I =
      imageOf(printed(vpCircleMarkerFamily::GOLAY23, 5).setPose(randomPose(random, 100., 0.4)), random);
  vpDetectorCircleMarker detector;
  ASSERT_TRUE(detector.detect(I));
  EXPECT_TRUE(detector.getDebug().candidates.empty());
  EXPECT_TRUE(detector.getDebug().scales.empty());
  EXPECT_TRUE(detector.getRejectedCandidates().empty());
  detector.setDebug(true);
  ASSERT_TRUE(detector.detect(I));
  EXPECT_FALSE(detector.getDebug().candidates.empty());
  detector.setDebug(false);
  EXPECT_TRUE(detector.getDebug().candidates.empty());
}

TEST(DetectorDebug, AMarkerIsACandidateWithoutAReason)
{
  Random random = randomOfTest();
  const vpImage<unsigned char> I =
      imageOf(printed(vpCircleMarkerFamily::GOLAY23, 5).setPose(randomPose(random, 100., 0.4)), random);
  vpDetectorCircleMarker detector;
  detector.setDebug(true);
  ASSERT_TRUE(detector.detect(I));
  const vpCircleMarkerDebug &debug = detector.getDebug();
  ASSERT_EQ(debug.scales.size(), 3u);
  EXPECT_NEAR(debug.scales[0].noise, 2., 0.5); // the simulator's usual noise
  EXPECT_EQ(debug.scales[0].edges.getWidth(), width);
  EXPECT_EQ(debug.scales[1].edges.getWidth(), width / 2);
  EXPECT_EQ(debug.scales[2].edges.getWidth(), width / 4);
  EXPECT_FALSE(debug.scales[0].chains.empty());
  unsigned int taken = 0;
  unsigned int pieces = 0;
  for (const vpCircleMarkerCandidate &candidate : debug.candidates) {
    pieces += candidate.reason == Reject::INSIDE_OF_A_MARKER ? 1 : 0;
    if (candidate.reason != Reject::NONE) {
      continue;
    }
    ++taken;
    EXPECT_TRUE(candidate.isOutline);
    EXPECT_EQ(candidate.id, 5);
    EXPECT_EQ(candidate.margin, detector.getMargin(0));
    EXPECT_EQ(candidate.sectors.size(), 23u);
    EXPECT_NEAR(candidate.ellipse.a, detector.getDetections()[0].ellipse.a, 0.5);
    EXPECT_NE(candidate.getText().find("golay23 id: 5"), std::string::npos) << candidate.getText();
    // The sectors lie where the image is as black as they were read.
    for (const vpCircleMarkerCandidate::Sector &sector : candidate.sectors) {
      const int grey = I[static_cast<unsigned int>(sector.center.get_v() + 0.5)]
                        [static_cast<unsigned int>(sector.center.get_u() + 0.5)];
      EXPECT_EQ(grey<120, sector.black> 0.) << grey;
    }
  }
  EXPECT_EQ(taken, 1u);
  EXPECT_GT(pieces, 0u) << "sectors of its code";
}

// As a whole one it was none: what it was found as counts.
TEST(DetectorDebug, ARingThatReachesOutOfTheImageHasNoReasonEither)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily ring(vpCircleMarkerFamily::RING);
  vpDetectorCircleMarker detector(ring);
  detector.setDebug(true);
  ASSERT_TRUE(detector.detect(imageOf(printed(ring, -1).setPose(randomPose(random, 100., 0.4, 20., 240.)), random)));
  const std::vector<vpCircleMarkerCandidate> &candidates = detector.getDebug().candidates;
  EXPECT_EQ(std::count_if(candidates.begin(), candidates.end(),
                          [](const auto &candidate) { return candidate.reason == Reject::NONE; }),
            1);
}

TEST(DetectorDebug, WhatWasSeenInTheNegativeSaysSo)
{
  Random random = randomOfTest();
  vpImage<unsigned char> I =
      imageOf(printed(vpCircleMarkerFamily::GOLAY23, 5).setPose(randomPose(random, 100., 0.4)), random);
  std::transform(I.bitmap, I.bitmap + I.getSize(), I.bitmap,
                 [](unsigned char grey) { return static_cast<unsigned char>(255 - grey); });
  for (const vpCircleMarkerPolarity polarity : {vpCircleMarkerPolarity::WHITE_ON_BLACK, vpCircleMarkerPolarity::BOTH}) {
    const bool both = polarity == vpCircleMarkerPolarity::BOTH;
    vpDetectorCircleMarker detector;
    detector.setPolarity(polarity);
    detector.setDebug(true);
    ASSERT_TRUE(detector.detect(I));
    const vpCircleMarkerDebug &debug = detector.getDebug();
    ASSERT_EQ(debug.scales.size(), both ? 6u : 3u);
    EXPECT_EQ(debug.scales.front().isInverse, !both);
    EXPECT_TRUE(debug.scales.back().isInverse);
    EXPECT_FALSE(debug.scales.back().chains.empty());
    unsigned int taken = 0;
    for (const vpCircleMarkerCandidate &candidate : debug.candidates) {
      taken += candidate.reason == Reject::NONE && candidate.isInverse ? 1 : 0;
    }
    EXPECT_EQ(taken, 1u);
  }
}

TEST(DetectorDebug, TheResultIsTheSame)
{
  Random random = randomOfTest();
  const vpImage<unsigned char> I =
      imageOf(printed(vpCircleMarkerFamily::GOLAY23, 5).setPose(randomPose(random, 100., 0.4)), random);
  vpDetectorCircleMarker with, without;
  with.setDebug(true);
  ASSERT_TRUE(with.detect(I));
  ASSERT_TRUE(without.detect(I));
  EXPECT_EQ(with.getNbOutlines(), without.getNbOutlines());
  EXPECT_EQ(differenceOf(with.getDetections()[0].cMo, without.getDetections()[0].cMo), 0.);
}

// An outline that is followed is not searched for, and what is not searched for leaves no record.
TEST(DetectorDebug, MarkersThatAreFollowedAreSearchedForAsWell)
{
  Random random = randomOfTest();
  vpDetectorCircleMarker detector;
  detector.setTracking(true, 100);
  detector.setDebug(true);
  for (int i = 0; i < 3; ++i) {
    const vpHomogeneousMatrix cMo = randomPose(random, 100., 0.4, 300. + 3. * i, 240.);
    detector.detect(imageOf(printed(vpCircleMarkerFamily::GOLAY23, 5).setPose(cMo), random));
    EXPECT_EQ(detector.getTagsId(), std::vector<int>({5})) << i;
    EXPECT_FALSE(detector.getDebug().scales.empty()) << i;
    EXPECT_FALSE(detector.getDebug().candidates.empty()) << i;
  }
}

TEST(DetectorDebug, AnyNumberOfThreadsGivesTheSame)
{
  Random random = randomOfTest();
  vpMarkerSceneSimulator simulator(straightCamera(), width, height);
  simulator.setBackground(vpSceneBackground::clutter(random(), 40));
  vpSimulatedMarker marker = printed(vpCircleMarkerFamily::GOLAY23, 5);
  simulator.addMarker(marker.setPose(randomPose(random, 100., 0.4)));
  vpImage<unsigned char> I;
  simulator.render(I, random());
  vpDetectorCircleMarker one, two;
  two.setNbThreads(2);
  one.setDebug(true);
  two.setDebug(true);
  one.detect(I);
  two.detect(I);
  ASSERT_EQ(one.getDebug().candidates.size(), two.getDebug().candidates.size());
  for (std::size_t i = 0; i < one.getDebug().candidates.size(); ++i) {
    const vpCircleMarkerCandidate &p = one.getDebug().candidates[i];
    const vpCircleMarkerCandidate &q = two.getDebug().candidates[i];
    EXPECT_EQ(p.reason, q.reason);
    EXPECT_EQ(p.points.size(), q.points.size());
    EXPECT_EQ(p.ellipse.a, q.ellipse.a);
    EXPECT_EQ(p.margin, q.margin);
  }
}

// To measure a letter that looks like a marker takes milliseconds, and there are hundreds.
TEST(DetectorDebug, APageOfTextIsNotMeasuredLetterByLetter)
{
  Random random = randomOfTest();
  const vpHomogeneousMatrix truth = randomPose(random, 110., 0.5, middleU, middleV);
  vpImage<unsigned char> I = imageOf(printed(vpCircleMarkerFamily::GOLAY23, 5).setPose(truth), random);
  cv::Mat pixels = pixelsOf(I);
  for (int y = 20; y < 480; y += 20) {
    for (int x = 5; x < 640; x += 13) {
      if (std::abs(x + 6 - middleU) > 90. || std::abs(y - 6 - middleV) > 90.) { // not on its sheet
        const std::string letter(1, "abdegopqes"[random() % 10]);
        cv::putText(pixels, letter, cv::Point(x, y), cv::FONT_HERSHEY_COMPLEX, 0.6, cv::Scalar(30), 1, cv::LINE_AA);
      }
    }
  }
  std::map<Reject, unsigned int> counts = countsOf(I, 5, 1);
  EXPECT_EQ(counts, countsOf(I, 5, 2));
  EXPECT_GT(counts[Reject::TOO_MANY], 50u);
  EXPECT_LE(counts[Reject::UNLIKE_THE_MODEL], 30u);
}

// Nor are rings with something inside, each of which may be a marker that something covers.
TEST(DetectorDebug, APageOfRingsIsNotMeasuredRingByRing)
{
  Random random = randomOfTest();
  const vpHomogeneousMatrix truth = randomPose(random, 110., 0.5, middleU, middleV);
  vpImage<unsigned char> I = imageOf(printed(vpCircleMarkerFamily::GOLAY23, 5).setPose(truth), random);
  cv::Mat pixels = pixelsOf(I);
  cv::Mat drawn(pixels.size(), CV_8U, cv::Scalar(255));
  cv::rectangle(drawn, cv::Point(335, 100), cv::Point(380, 380), cv::Scalar(30), cv::FILLED); // over a part of it
  const int shift = 4;
  const int unit = 1 << shift;
  const auto drawArc = [&](double u, double v, double radius, double width, double from, double angle) {
    const cv::Point center(cvRound(u * unit), cvRound(v * unit));
    const int r = cvRound(radius * unit);
    cv::ellipse(drawn, center, cv::Size(r, r), from, 0., angle, cv::Scalar(30), cvRound(width), cv::LINE_AA, shift);
  };
  int things = 0;
  for (double v = 30.; v < height - 25.; v += 45.) {
    for (double u = 30.; u < width - 25.; u += 45.) {
      if (std::abs(u - middleU) > 110. || std::abs(v - middleV) > 170.) { // neither on its sheet nor on what covers it
        const double turn = uniform(random, 0., 360.);
        drawArc(u, v, 16., 4., 0., 360.);
        drawArc(u, v, 9.5, 5., turn, 75.); // a word of four runs, which no codeword is
        drawArc(u, v, 9.5, 5., turn + 160., 95.);
        ++things;
      }
    }
  }
  cv::GaussianBlur(drawn, drawn, cv::Size(), 0.7);
  cv::min(pixels, drawn, pixels);
  ASSERT_GT(things, 80);
  std::map<Reject, unsigned int> counts = countsOf(I, 5, 1);
  EXPECT_EQ(counts, countsOf(I, 5, 2));
  EXPECT_GT(counts[Reject::TOO_MANY], 5u); // not all things are read as rings that something covers
}
