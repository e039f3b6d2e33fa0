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
 * Tests that no marker is found twice, and that nothing of other systems is taken for one.
 */

#include <gtest/gtest.h>

#include <bitset>
#include <cstdint>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "detector_scenes.h"

using namespace detector_test;

namespace {
//! Pairs of detections that are the same thing in the image: nearer to each other than half of their size.
std::size_t duplicates(const std::vector<vpCircleMarkerDetection> &found)
{
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const double distance = vpImagePoint::distance(found[i].center, found[k].center);
      pairs += distance < 0.5 * std::max(found[i].ellipse.a, found[k].ellipse.a) ? 1 : 0;
    }
  }
  return pairs;
}

//! How many of 240 clean prints, of diameters in pixels, of words so many sectors from the nearest codeword are read.
std::size_t readOfOtherWords(Random &random, const vpCircleMarkerFamily &family, unsigned int distance,
                             double smallest = 60., double largest = 130.)
{
  const unsigned int sectors = family.getNbSectors();
  const vpCircleMarkerLayout &layout = family.getLayout();
  const std::vector<std::uint32_t> codewords = vpSimulatedMarker::codewords(family.getName());
  const auto distanceToCode = [&](std::uint32_t word) {
    unsigned int least = sectors;
    for (const std::uint32_t codeword : codewords) {
      for (unsigned int turn = 0; turn < sectors; ++turn) {
        const std::uint64_t turned =
            (static_cast<std::uint64_t>(codeword) << turn) | (static_cast<std::uint64_t>(codeword) >> (sectors - turn));
        const std::uint64_t differing = (turned ^ word) & ((1ULL << sectors) - 1);
        least = std::min(least, static_cast<unsigned int>(std::bitset<64>(differing).count()));
      }
    }
    return least;
  };
  vpDetectorCircleMarker detector(family);
  std::size_t found = 0;
  for (int image = 0; image < 20; ++image) {
    vpMarkerSceneSimulator simulator(straightCamera(), width, height);
    constexpr int columns = 4;
    for (int i = 0; i < 3 * columns; ++i) {
      std::uint32_t word = 0;
      while (distanceToCode(word) != distance) {
        word = static_cast<std::uint32_t>(random() & ((1ULL << sectors) - 1));
      }
      vpSimulatedMarker marker = vpSimulatedMarker::rings({{{layout.ringInner, 1.}}}, size);
      marker.setTrack(layout.codeInner, layout.codeOuter, sectors, word);
      simulator.addMarker(
          marker.setPose(randomPose(random, uniform(random, smallest, largest), uniform(random, 0., 0.9),
                                    width * (i % columns + 0.5) / columns, height * (i / columns + 0.5) / 3.)));
    }
    vpImage<unsigned char> I;
    simulator.render(I, random());
    detector.detect(I);
    found += detector.getNbObjects();
  }
  return found;
}
} // namespace

TEST(DetectorDuplicates, NoMarkerIsFoundTwice)
{
  Random random = randomOfTest();
  const std::vector<vpCircleMarkerFamily> families = {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31R,
                                                      vpCircleMarkerFamily::BCH31, vpCircleMarkerFamily::RING};
  vpDetectorCircleMarker all;
  all.setFamilies(families);
  std::size_t found = 0;
  for (int image = 0; image < 20; ++image) {
    vpMarkerSceneSimulator simulator(straightCamera(), width, height);
    vpScenePhotometry photometry;
    // Sharp, for the image itself, to blurred, for its half: both see many outlines.
    photometry.blurSigma = uniform(random, 0.4, 2.5);
    photometry.noiseSigma = uniform(random, 0., 6.);
    simulator.setPhotometry(photometry);
    simulator.setBackground(vpSceneBackground::clutter(random(), 20));
    constexpr int columns = 4;
    for (int i = 0; i < 3 * columns; ++i) {
      const vpCircleMarkerFamily &family = families[random() % families.size()];
      vpSimulatedMarker marker = printed(family, randomId(random, family));
      simulator.addMarker(
          marker.setPose(randomPose(random, uniform(random, 20., 110.), uniform(random, 0., 1.1),
                                    width * (i % columns + 0.5) / columns, height * (i / columns + 0.5) / 3.)));
    }
    vpImage<unsigned char> I;
    simulator.render(I, random());
    all.detect(I);
    EXPECT_EQ(duplicates(all.getDetections()), 0u) << "image " << image;
    found += all.getNbObjects();
  }
  EXPECT_GT(found, 150u);
}

// Seen among simulated clutter: the slope around the spot read as a code of black and white sectors.
TEST(DetectorPhantoms, BrightSpotsWithADarkRimHaveNoCode)
{
  Random random = randomOfTest();
  vpDetectorCircleMarker detector;
  detector.setFamilies({vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31R, vpCircleMarkerFamily::BCH31});
  for (int image = 0; image < 60; ++image) {
    cv::Mat large(2 * height, 2 * width, CV_8U, cv::Scalar(uniform(random, 40., 150.)));
    for (int i = 0; i < 80; ++i) {
      const double ground = large.at<unsigned char>(0, 0);
      const cv::Point center(static_cast<int>(uniform(random, 40., 2. * width - 40.)),
                             static_cast<int>(uniform(random, 40., 2. * height - 40.)));
      const double a = uniform(random, 8., 40.);
      const double b = a * uniform(random, 0.4, 1.);
      const double spot = uniform(random, 0.35, 0.75);
      const double angle = uniform(random, 0., 180.);
      const auto fill = [&](double share, double grey) {
        cv::ellipse(large, center, cv::Size(static_cast<int>(share * a), static_cast<int>(share * b)), angle, 0., 360.,
                    cv::Scalar(grey), cv::FILLED, cv::LINE_AA);
      };
      fill(1., ground - uniform(random, 15., 40.));
      fill(spot, uniform(random, 180., 250.));
    }
    vpImage<unsigned char> I(height, width);
    cv::Mat pixels(height, width, CV_8U, I.bitmap);
    cv::resize(large, pixels, pixels.size(), 0., 0., cv::INTER_AREA);
    cv::GaussianBlur(pixels, pixels, cv::Size(), 0.7);
    std::normal_distribution<double> normal(0., 2.);
    for (unsigned int i = 0; i < I.getSize(); ++i) {
      I.bitmap[i] = cv::saturate_cast<unsigned char>(I.bitmap[i] + normal(random));
    }
    EXPECT_FALSE(detector.detect(I)) << "image " << image << ": " << detector.getMessage(0);
  }
}

// A code of another number of sectors may be like one of ours but for some of them, which were taken for covered: of
// these 600 eight were found as one, with all of the ring in sight, and five still are.
TEST(DetectorPhantoms, MarkersOfAnotherFamilyHaveNoCode)
{
  constexpr std::size_t most = 5;
  Random random = randomOfTest();
  std::size_t found = 0;
  for (const auto &[printedType, soughtType] :
       {std::pair(vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31),
        std::pair(vpCircleMarkerFamily::BCH31, vpCircleMarkerFamily::GOLAY23)}) {
    const vpCircleMarkerFamily family(printedType);
    vpDetectorCircleMarker detector{vpCircleMarkerFamily(soughtType)};
    for (int image = 0; image < 25; ++image) {
      vpMarkerSceneSimulator simulator(straightCamera(), width, height);
      vpScenePhotometry photometry;
      photometry.blurSigma = uniform(random, 0.5, 1.);
      photometry.noiseSigma = uniform(random, 1., 5.);
      simulator.setPhotometry(photometry);
      constexpr int columns = 4;
      for (int i = 0; i < 3 * columns; ++i) {
        vpSimulatedMarker marker = printed(family, randomId(random, family));
        simulator.addMarker(
            marker.setPose(randomPose(random, uniform(random, 40., 130.), uniform(random, 0., 1.),
                                      width * (i % columns + 0.5) / columns, height * (i / columns + 0.5) / 3.)));
      }
      vpImage<unsigned char> I;
      simulator.render(I, random());
      detector.detect(I);
      found += detector.getNbObjects();
    }
  }
  EXPECT_LE(found, most);
}

// A clean print of a word that is no code's: three sectors from the nearest codeword, one more than are corrected.
// Those that are white and should be black were taken for covered by something like paper: 28 of these 480 were read.
TEST(DetectorPhantoms, PrintsOfOtherWordsHaveNoCode)
{
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31}) {
    EXPECT_EQ(readOfOtherWords(random, type, 3), 0u);
  }
}

// Where few pixels show a sector alone the likeliest of all words tells what is printed: 11 and 22 of these 240 each
// were read, their sectors taken for covered one by one, and none and six still are (one and five before the paper's
// end moved with the pose).
TEST(DetectorPhantoms, SmallPrintsOfOtherWordsHaveNoCode)
{
  Random random = randomOfTest();
  EXPECT_EQ(readOfOtherWords(random, vpCircleMarkerFamily::GOLAY23, 3, 25., 50.), 0u);
  EXPECT_LE(readOfOtherWords(random, vpCircleMarkerFamily::BCH31, 3, 30., 60.), 6u);
}

// Of bch31r, whose codewords few words are near to, up to four black sectors that look like paper may be covered; none
// of 240 words each that are farther is read.
TEST(DetectorPhantoms, PrintsOfFartherWordsAreNotOfTheRobustCode)
{
  Random random = randomOfTest();
  EXPECT_EQ(readOfOtherWords(random, vpCircleMarkerFamily::BCH31R, 5), 0u);
  EXPECT_EQ(readOfOtherWords(random, vpCircleMarkerFamily::BCH31R, 6), 0u);
}

// Targets of rings, seen at an angle: the track is even and grey, or the fit explains it by paper that is whiter and
// ink that is blacker than anything in the image. Where codewords could not be compared the first reading decided.
TEST(DetectorPhantoms, RingsInRingsHaveNoCode)
{
  constexpr int cell = 28; // pixels of the drawing
  cv::Mat drawing(2 * height, 2 * width, CV_8U, cv::Scalar(220));
  for (int y = cell / 2; y + cell / 2 <= drawing.rows; y += cell) {
    for (int x = cell / 2; x + cell / 2 <= drawing.cols; x += cell) {
      for (const int radius : {12, 8, 4}) {
        cv::circle(drawing, cv::Point(x, y), radius, cv::Scalar(30), 2, cv::LINE_AA);
      }
    }
  }
  Random random = randomOfTest();
  vpDetectorCircleMarker detector;
  detector.setFamilies({vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31});
  for (int image = 0; image < 8; ++image) {
    // A part of the drawing, somewhat askew, fills the image: targets of 14 to 24 pixels.
    const float share = static_cast<float>(uniform(random, 0.6, 1.));
    std::vector<cv::Point2f> from;
    for (const cv::Point2f &corner :
         {cv::Point2f(-1.F, -1.F), cv::Point2f(1.F, -1.F), cv::Point2f(1.F, 1.F), cv::Point2f(-1.F, 1.F)}) {
      from.emplace_back(width * (1.F + share * corner.x * static_cast<float>(uniform(random, 0.7, 1.))),
                        height * (1.F + share * corner.y * static_cast<float>(uniform(random, 0.7, 1.))));
    }
    const std::vector<cv::Point2f> to = {{0.F, 0.F}, {width, 0.F}, {width, height}, {0.F, height}};
    vpImage<unsigned char> I(height, width);
    cv::Mat pixels(height, width, CV_8U, I.bitmap);
    cv::warpPerspective(drawing, pixels, cv::getPerspectiveTransform(from, to), pixels.size());
    cv::GaussianBlur(pixels, pixels, cv::Size(), uniform(random, 0.4, 1.5));
    std::normal_distribution<double> normal(0., uniform(random, 0., 6.));
    for (unsigned int i = 0; i < I.getSize(); ++i) {
      I.bitmap[i] = cv::saturate_cast<unsigned char>(I.bitmap[i] + normal(random));
    }
    EXPECT_FALSE(detector.detect(I)) << "image " << image << ": " << detector.getMessage(0);
  }
}
