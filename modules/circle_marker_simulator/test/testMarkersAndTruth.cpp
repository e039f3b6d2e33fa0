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
 * Codes, prints and ground truth of the simulated markers.
 */

#include <algorithm>
#include <array>
#include <bitset>

#include "outline.h"
#include "test_support.h"

using namespace simulator_test;

namespace {

int bitCount(std::uint32_t word)
{
  int count = 0;
  for (; word != 0; word &= word - 1) {
    ++count;
  }
  return count;
}

// Ink of a marker seen from the front, in square metres; the scale is 1 pixel = 0.25 mm.
double inkArea(const vpSimulatedMarker &marker)
{
  vpMarkerSceneSimulator simulator(pinhole(1000, 1000, 4000.), 1000, 1000);
  simulator.setPhotometry(idealSensor());
  simulator.setBackground(vpSceneBackground::plain(220.));
  vpSimulatedMarker frontal = marker;
  simulator.addMarker(frontal.setPose(tiltedPose(0., 0., 1., 0., 0., 0.)));
  vpImage<float> I;
  simulator.renderNoiseFree(I);
  double ink = 0.;
  for (unsigned int k = 0; k < I.getSize(); ++k) {
    ink += (220. - I.bitmap[k]) / 190.;
  }
  return ink / (4000. * 4000.);
}

} // namespace

TEST(Codes, CountsFirstWordsAndDistances)
{
  struct Family
  {
    const char *name;
    unsigned int sectors;
    std::size_t ids;
    std::array<std::uint32_t, 3> first;
    int distance;
  };
  for (const Family &family :
       {Family{"golay23", 23, 178, {{2787, 7973, 8559}}, 7}, Family{"bch31", 31, 2114, {{36783, 102641, 176403}}, 7},
        Family{"bch31r", 31, 66, {{1451733, 3828607, 5160321}}, 11}}) {
    const std::vector<std::uint32_t> words = vpSimulatedMarker::codewords(family.name);
    ASSERT_EQ(vpSimulatedMarker::sectors(family.name), family.sectors);
    ASSERT_EQ(words.size(), family.ids);
    EXPECT_TRUE(std::equal(family.first.begin(), family.first.end(), words.begin()));
    EXPECT_TRUE(std::is_sorted(words.begin(), words.end()));
    // The code is linear: the distance between any two rotations of any two words is the weight of some word, and all
    // words but the constant ones are rotations of these.
    int least = static_cast<int>(family.sectors);
    for (const std::uint32_t word : words) {
      least = std::min(least, bitCount(word));
    }
    EXPECT_EQ(least, family.distance);
  }
  EXPECT_THROW(vpSimulatedMarker::circle("golay23", 178, 0.1), vpException);
  EXPECT_THROW(vpSimulatedMarker::circle("golay24", 0, 0.1), vpException);
  EXPECT_THROW(vpSimulatedMarker::circle("disc", 0, 0.), vpException);
  EXPECT_THROW(vpSimulatedMarker::ring(0.1, 1.), vpException);
}

TEST(Prints, InkSpreadMovesEveryBlackEdge)
{
  const double R = 0.09, e = 0.001;
  for (const double spread : {0., e, -e}) {
    // 1 mm is 4 pixels: an edge wrong by 1e-4 pixels would change these areas by 1e-7 of a square metre's 1e-3.
    const double tolerance = 1e-8;
    EXPECT_NEAR(inkArea(vpSimulatedMarker::disc(2. * R).setInkSpread(spread)), M_PI * std::pow(R + spread, 2),
                tolerance);
    EXPECT_NEAR(inkArea(vpSimulatedMarker::ring(2. * R, 0.7).setInkSpread(spread)),
                M_PI * (std::pow(R + spread, 2) - std::pow(0.7 * R - spread, 2)), tolerance);
    // Code track: each run of black sectors gains a strip at either end, the outer end a little rounder than a strip:
    // between radii a and b the angle asin(e / r) on either side adds up to integral of 2 asin(e / r) r dr.
    const vpSimulatedMarker coded = vpSimulatedMarker::circle("golay23", 5, 2. * R);
    const std::uint32_t word = *coded.getCodeword();
    int black = 0, runs = 0;
    for (unsigned int k = 0; k < 23; ++k) {
      const bool here = (word >> k) & 1, before = (word >> ((k + 1) % 23)) & 1;
      black += here;
      runs += here && !before;
    }
    const double a = 0.40 * R - spread, b = 0.68 * R + spread;
    // A strip's sides are straight and parallel to the radial edge: their area between two circles, numerically.
    double strip = 0.;
    const int n = 10000;
    for (int i = 0; i < n; ++i) {
      const double r = a + (b - a) * (i + 0.5) / n;
      strip += 2. * std::asin(spread / r) * r * (b - a) / n;
    }
    const double track = black * M_PI / 23. * (b * b - a * a) + runs * strip;
    const double ring = M_PI * (std::pow(R + spread, 2) - std::pow(0.8 * R - spread, 2));
    vpSimulatedMarker spreadMarker = coded;
    EXPECT_NEAR(inkArea(spreadMarker.setInkSpread(spread)), ring + track, tolerance);
  }
  EXPECT_THROW(vpSimulatedMarker::disc(0.1).setInkSpread(0.01), vpException);
}

TEST(Prints, LayoutIsAsAskedFor)
{
  constexpr double R = 0.1;
  // Ink of the ring and of the black sectors, by their formulas.
  vpSimulatedMarker marker = vpSimulatedMarker::circle("golay23", 5, 2. * R);
  marker.setLayout(0.7, 0.3, 0.6);
  const double sectors = std::bitset<23>(*marker.getCodeword()).count() / 23.;
  const double expected = M_PI * R * R * ((1. - 0.49) + sectors * (0.36 - 0.09));
  EXPECT_NEAR(inkArea(marker), expected, 1e-3 * expected);
  EXPECT_THROW(marker.setLayout(0.7, 0.6, 0.3), vpException);
  EXPECT_THROW(marker.setLayout(0.7, 0.3, 0.7), vpException);
  EXPECT_THROW(marker.setLayout(1., 0.3, 0.6), vpException);
  EXPECT_THROW(vpSimulatedMarker::ring(2. * R, 0.7).setLayout(0.7, 0.3, 0.6), vpException);
}

TEST(Prints, RingsAndWindowsAreAsAskedFor)
{
  constexpr double R = 0.1;
  constexpr double tolerance = 1e-8;
  const auto area = [](double inner, double outer) { return M_PI * (outer * outer - inner * inner) * R * R; };
  vpSimulatedMarker marker = vpSimulatedMarker::rings({{0.2, 0.4}, {0.5, 1.}}, 2. * R);
  EXPECT_NEAR(inkArea(marker), area(0.2, 0.4) + area(0.5, 1.), tolerance);
  // Three of five ones: white windows in the outer ring, or black sectors between the rings.
  marker.setTrack(0.6, 0.9, 5, 0b11010, true);
  EXPECT_NEAR(inkArea(marker), area(0.2, 0.4) + area(0.5, 1.) - 0.6 * area(0.6, 0.9), tolerance);
  marker.setTrack(0.4, 0.5, 5, 0b11010);
  EXPECT_NEAR(inkArea(marker), area(0.2, 1.) - 0.4 * area(0.4, 0.5), tolerance);
  // Ink that spreads makes windows smaller: by a strip along each of the four arcs and the four radial edges.
  const double e = 1e-4;
  marker.setTrack(0.6, 0.9, 5, 0b11010, true);
  const double before = inkArea(marker);
  const double arcs = 0.6 * 2. * M_PI * (0.6 + 0.9) * R + 2. * M_PI * (0.2 + 0.4 + 0.5 + 1.) * R;
  const double sides = 4. * 0.3 * R;
  marker.setInkSpread(e);
  EXPECT_NEAR(inkArea(marker) - before, e * (arcs + sides), 1e-2 * e * (arcs + sides));
  EXPECT_THROW(vpSimulatedMarker::rings({{0.4, 0.2}}, 2. * R), vpException);
  EXPECT_THROW(marker.setTrack(0.6, 0.9, 5, 0b11111), vpException);
  EXPECT_THROW(marker.setTrack(0.6, 0.9, 5, 0b111010), vpException);
  EXPECT_THROW(vpSimulatedMarker::disc(2. * R).setTrack(0.6, 0.9, 5, 1), vpException);
}

TEST(Prints, InkSpreadOfATag)
{
  // Ink of the tag widened by a square of side 2 e: counted on a grid of 0.1 mm with e = 0.5 mm and cells of 5 mm.
  const vpImage<unsigned char> cells = vpSimulatedMarker::aprilTag36h11(4, 0.04).getPicture();
  const auto black = [&](int row, int column) { // in steps of 0.1 mm
    const int i = static_cast<int>(std::floor(row / 50.)), j = static_cast<int>(std::floor(column / 50.));
    return i >= 0 && j >= 0 && i < 8 && j < 8 && cells[i][j] == 0;
  };
  for (const int spread : {5, -5}) {
    long count = 0;
    for (int i = -10; i < 410; ++i) {
      for (int j = -10; j < 410; ++j) {
        bool any = false, all = true;
        for (const int di : {-5, 0, 5}) {
          for (const int dj : {-5, 0, 5}) {
            any = any || black(i + di, j + dj);
            all = all && black(i + di, j + dj);
          }
        }
        count += spread > 0 ? any : all;
      }
    }
    EXPECT_NEAR(inkArea(vpSimulatedMarker::aprilTag36h11(4, 0.04).setInkSpread(spread * 1e-4)), count * 1e-8, 1e-9);
  }
}

TEST(Truth, SharesOfWhatAnOccluderLeaves)
{
  // A frontal circle of 100 pixels radius around (319.5, 239.5).
  const vpCameraParameters cam = pinhole(640, 480, 1000.);
  vpMarkerSceneSimulator simulator(cam, 640, 480);
  simulator.addMarker(vpSimulatedMarker::circle("golay23", 0, 0.2).setPose(tiltedPose(0., 0., 1., 0., 0., 0.)));
  vpMarkerTruth truth = simulator.getTruth()[0];
  EXPECT_EQ(truth.visibleEdge, 1.);
  EXPECT_NEAR(truth.coveredArea, 0., 1e-12);
  // A bar over everything to the left of u = 319.5 + d covers a segment of the disc.
  for (const double d : {-60., 0., 33.}) {
    simulator.clearOccluders();
    simulator.addOccluder(vpSceneOccluder::bar(vpImagePoint(239.5, 100.), vpImagePoint(239.5, 319.5 + d), 400., 0.));
    truth = simulator.getTruth()[0];
    const double halfAngle = std::acos(d / 100.); // of the part that is left
    EXPECT_NEAR(truth.visibleEdge, halfAngle / M_PI, 1e-3);
    const double left = halfAngle - std::sin(halfAngle) * std::cos(halfAngle);
    EXPECT_NEAR(truth.coveredArea, 1. - left / M_PI, 1e-6);
  }
  // Overlapping occluders count once; half beyond the border of the image counts as covered.
  simulator.addOccluder(vpSceneOccluder::bar(vpImagePoint(239.5, 100.), vpImagePoint(239.5, 319.5), 390., 0.));
  EXPECT_NEAR(simulator.getTruth()[0].coveredArea, truth.coveredArea, 1e-6);
  simulator.clearOccluders();
  simulator.setMarkerPose(0, tiltedPose(-0.32, 0., 1., 0., 0., 0.));
  truth = simulator.getTruth()[0];
  EXPECT_NEAR(truth.visibleEdge, 0.5, 1e-3);
  EXPECT_NEAR(truth.coveredArea, 0.5, 1e-6);
}

TEST(Truth, LaterMarkersCoverEarlierOnes)
{
  vpMarkerSceneSimulator simulator(pinhole(640, 480, 1000.), 640, 480);
  simulator.addMarker(vpSimulatedMarker::disc(0.2).setPose(tiltedPose(0., 0., 1., 0., 0., 0.)));
  simulator.addMarker(vpSimulatedMarker::disc(0.04).setSheetSide(0.05).setPose(tiltedPose(0., 0., 1., 0., 0., 0.)));
  const std::vector<vpMarkerTruth> truth = simulator.getTruth();
  EXPECT_NEAR(truth[0].coveredArea, 50. * 50. / (M_PI * 100. * 100.), 1e-6);
  EXPECT_EQ(truth[0].visibleEdge, 1.);
  EXPECT_NEAR(truth[1].coveredArea, 0., 1e-12);
}

TEST(Outlines, PartsAddUpAndStayClosed)
{
  using namespace marker_simulator;
  std::mt19937_64 random = seededFromTestName();
  const auto star = [&random]() {
    Outline outline;
    std::vector<PlanePoint> corners;
    const double cx = uniform(random, -1., 1.), cy = uniform(random, -1., 1.);
    for (int i = 0; i < 9; ++i) {
      const double r = uniform(random, 0.2, 2.);
      corners.push_back({cx + r * std::cos(2. * M_PI * i / 9.), cy + r * std::sin(2. * M_PI * i / 9.)});
    }
    for (int i = 0; i < 9; ++i) {
      outline.push_back({corners[i], corners[(i + 1) % 9]});
    }
    return outline;
  };
  for (int i = 0; i < 500; ++i) {
    const Outline a = star(), b = star();
    const Outline without = subtract(a, b), within = intersect(a, b);
    ASSERT_NEAR(area(without) + area(within), area(a), 1e-12);
    ASSERT_NEAR(area(within), area(intersect(b, a)), 1e-12);
    double x = 0., y = 0.;
    for (const Segment &s : without) {
      x += s.to.x - s.from.x;
      y += s.to.y - s.from.y;
    }
    ASSERT_NEAR(std::hypot(x, y), 0., 1e-12);
    for (int k = 0; k < 20; ++k) {
      const PlanePoint p = {uniform(random, -3., 3.), uniform(random, -3., 3.)};
      ASSERT_EQ(isInside(without, p), isInside(a, p) && !isInside(b, p));
    }
  }
}
