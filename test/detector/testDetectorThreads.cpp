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
 * Threads and timeouts: the same results from any number of threads, and an end in time on images made to be hard.
 */

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "detector_scenes.h"

using namespace detector_test;

namespace {
vpImage<unsigned char> imageOfPixels(const cv::Mat &pixels)
{
  vpImage<unsigned char> I(static_cast<unsigned int>(pixels.rows), static_cast<unsigned int>(pixels.cols));
  pixels.copyTo(cv::Mat(pixels.rows, pixels.cols, CV_8U, I.bitmap));
  return I;
}

//! Markers of any size and tilt on clutter.
vpImage<unsigned char> crowded(Random &random, const vpCircleMarkerFamily &family)
{
  vpMarkerSceneSimulator simulator(straightCamera(), width, height);
  simulator.setBackground(vpSceneBackground::clutter(random(), 40));
  constexpr int columns = 3;
  for (int i = 0; i < 2 * columns; ++i) {
    const double u = width * (i % columns + 0.5) / columns;
    const double v = height * (i / columns + 0.5) / 2.;
    vpSimulatedMarker marker = printed(family, randomId(random, family));
    simulator.addMarker(marker.setPose(randomPose(random, uniform(random, 17., 110.), uniform(random, 0., 1.2), u, v)));
  }
  vpImage<unsigned char> I;
  simulator.render(I, random());
  return I;
}

void expectSame(const vpDetectorCircleMarker &one, const vpDetectorCircleMarker &other)
{
  ASSERT_EQ(one.getDetections().size(), other.getDetections().size());
  EXPECT_EQ(one.getNbOutlines(), other.getNbOutlines());
  for (std::size_t i = 0; i < one.getDetections().size(); ++i) {
    const vpCircleMarkerDetection &p = one.getDetections()[i];
    const vpCircleMarkerDetection &q = other.getDetections()[i];
    EXPECT_EQ(p.family.getType(), q.family.getType());
    EXPECT_EQ(p.id, q.id);
    EXPECT_EQ(p.hamming, q.hamming);
    // Not nearly: bit by bit.
    EXPECT_EQ(p.margin, q.margin);
    EXPECT_EQ(p.visible, q.visible);
    EXPECT_EQ(p.cost, q.cost);
    EXPECT_EQ(p.logOdds, q.logOdds);
    for (unsigned int row = 0; row < 4; ++row) {
      for (unsigned int column = 0; column < 4; ++column) {
        EXPECT_EQ(p.cMo[row][column], q.cMo[row][column]);
        EXPECT_EQ(p.cMo2[row][column], q.cMo2[row][column]);
      }
    }
    for (unsigned int k = 0; k < 36; ++k) {
      EXPECT_EQ(p.covariance.data[k], q.covariance.data[k]);
      EXPECT_EQ(p.covariance2.data[k], q.covariance2.data[k]);
    }
  }
}

//! Images on which a search may take long, from a name.
cv::Mat hardImage(const std::string &name, Random &random)
{
  cv::Mat pixels(480, 640, CV_8U, cv::Scalar(220));
  if (name == "noise" || name == "blobs") {
    std::uniform_int_distribution<int> grey(0, 255);
    for (auto pixel = pixels.begin<unsigned char>(); pixel != pixels.end<unsigned char>(); ++pixel) {
      *pixel = static_cast<unsigned char>(grey(random));
    }
    if (name == "blobs") {
      cv::GaussianBlur(pixels, pixels, cv::Size(), 3.);
      cv::normalize(pixels, pixels, 0, 255, cv::NORM_MINMAX);
    }
  }
  else if (name == "checkerboard") {
    for (int y = 0; y < pixels.rows; ++y) {
      for (int x = 0; x < pixels.cols; ++x) {
        pixels.at<unsigned char>(y, x) = ((x / 8 + y / 8) & 1) != 0 ? 30 : 220;
      }
    }
  }
  else if (name == "nested rings") {
    for (int radius = 390; radius > 4; radius -= 5) {
      cv::circle(pixels, cv::Point(320, 240), radius, cv::Scalar(30), 2, cv::LINE_AA);
    }
  }
  else if (name == "targets") {
    for (int y = 14; y + 14 <= pixels.rows; y += 28) {
      for (int x = 14; x + 14 <= pixels.cols; x += 28) {
        for (const int radius : {12, 8, 4}) {
          cv::circle(pixels, cv::Point(x, y), radius, cv::Scalar(30), 2, cv::LINE_AA);
        }
      }
    }
  }
  else { // a spiral: one chain through the whole image
    cv::Point before(320, 240);
    for (double angle = 0.; angle < 200.; angle += 0.02) {
      const double radius = 1.1 * angle;
      const cv::Point here(static_cast<int>(320 + radius * std::cos(angle)),
                           static_cast<int>(240 + radius * std::sin(angle)));
      cv::line(pixels, before, here, cv::Scalar(30), 3, cv::LINE_AA);
      before = here;
    }
  }
  return pixels;
}
} // namespace

TEST(DetectorThreads, AnyNumberGivesTheSame)
{
  Random random = randomOfTest();
  vpDetectorCircleMarker detectors[3];
  std::size_t found = 0;
  for (int i = 0; i < 12; ++i) {
    const vpCircleMarkerFamily family = i % 3 == 2   ? vpCircleMarkerFamily::RING
                                        : i % 3 == 1 ? vpCircleMarkerFamily::BCH31R
                                                     : vpCircleMarkerFamily::GOLAY23;
    const vpImage<unsigned char> I = crowded(random, family);
    for (unsigned int k = 0; k < 3; ++k) {
      detectors[k].setFamily(family);
      detectors[k].setNbThreads(k + 1);
      std::vector<vpHomogeneousMatrix> poses;
      detectors[k].detect(I, size, straightCamera(), poses);
    }
    found += detectors[0].getNbObjects();
    expectSame(detectors[0], detectors[1]);
    expectSame(detectors[0], detectors[2]);
  }
  EXPECT_GT(found, 40u); // or there would be nothing to compare
}

TEST(DetectorThreads, CopiesWorkOnTheirOwn)
{
  Random random = randomOfTest();
  const vpImage<unsigned char> I = crowded(random, vpCircleMarkerFamily::GOLAY23);
  vpDetectorCircleMarker first;
  first.setNbThreads(2);
  std::vector<vpHomogeneousMatrix> poses;
  first.detect(I, size, straightCamera(), poses);
  vpDetectorCircleMarker second(first);
  expectSame(first, second);
  second.detect(vpImage<unsigned char>(height, width, 100), size, straightCamera(), poses);
  EXPECT_EQ(second.getNbObjects(), 0u);
  second.detect(I, size, straightCamera(), poses);
  expectSame(first, second);
}

TEST(DetectorThreads, HardImagesGiveTheSameAndNoCode)
{
  Random random = randomOfTest();
  vpDetectorCircleMarker one;
  vpDetectorCircleMarker two;
  two.setNbThreads(2);
  for (const std::string name : {"noise", "blobs", "checkerboard", "nested rings", "targets", "spiral"}) {
    const vpImage<unsigned char> I = imageOfPixels(hardImage(name, random));
    EXPECT_FALSE(one.detect(I)) << name;
    EXPECT_FALSE(two.detect(I)) << name;
    EXPECT_EQ(one.getNbOutlines(), two.getNbOutlines()) << name;
  }
}

// How soon it ends is measured by bench-circle-marker; here, that what it leaves is sound.
TEST(DetectorTimeout, LeavesAPartOfTheMarkers)
{
  Random random = randomOfTest();
  const vpImage<unsigned char> I = crowded(random, vpCircleMarkerFamily::GOLAY23);
  vpDetectorCircleMarker patient;
  patient.detect(I);
  ASSERT_GT(patient.getNbObjects(), 3u);
  for (const unsigned int threads : {1U, 2U}) {
    vpDetectorCircleMarker hasty;
    hasty.setNbThreads(threads);
    for (const unsigned long timeout : {1UL, 2UL, 3UL, 5UL, 8UL, 1000000UL}) {
      hasty.setTimeout(timeout);
      hasty.detect(I);
      ASSERT_LE(hasty.getNbObjects(), patient.getNbObjects());
      for (const vpCircleMarkerDetection &found : hasty.getDetections()) {
        EXPECT_TRUE(std::any_of(
            patient.getDetections().begin(), patient.getDetections().end(), [&](const vpCircleMarkerDetection &known) {
              return known.id == found.id && vpImagePoint::distance(known.center, found.center) < 0.5;
            }));
      }
    }
    // Enough time, after too little: nothing is left over from the hasty calls.
    EXPECT_EQ(hasty.getNbObjects(), patient.getNbObjects());
  }
}
