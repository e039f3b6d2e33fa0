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
 * The smallest rings that the detector promises to find.
 */

#include <map>

#include <gtest/gtest.h>

#include "detector_scenes.h"

using namespace detector_test;

namespace {
/*! Markers of a sort, and how many of them are found. */
struct Sort
{
  vpCircleMarkerFamily::vpType family;
  double leastMinor, mostMinor; //!< Minor axis of the outline, pixels.
  double mostTilt;              //!< rad
  double leastGround;           //!< Least and most grey level of what is around their squares.
  double mostGround;
  double floor;          //!< Share that is found at least.
  double blur = 0.7;     //!< Pixels.
  double paper = 220.;   //!< Grey level.
  double leastTilt = 0.; //!< rad
  double ink = 30.;      //!< Grey level.
  double noise = 2.;     //!< Grey levels.
};

// Eight images of 24 markers each.
void expectReach(const Sort &sort)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(sort.family);
  vpDetectorCircleMarker detector(family);
  constexpr int columns = 6;
  constexpr int rows = 4;
  unsigned int markers = 0;
  unsigned int found = 0;
  for (int image = 0; image < 8; ++image) {
    vpMarkerSceneSimulator simulator(straightCamera(), width, height);
    simulator.setBackground(vpSceneBackground::plain(uniform(random, sort.leastGround, sort.mostGround)));
    vpScenePhotometry photometry;
    photometry.blurSigma = sort.blur;
    photometry.paper = sort.paper;
    photometry.ink = sort.ink;
    photometry.noiseSigma = sort.noise;
    simulator.setPhotometry(photometry);
    for (int i = 0; i < columns * rows; ++i) {
      const double u = width * (i % columns + 0.5) / columns + uniform(random, -5., 5.);
      const double v = height * (i / columns + 0.5) / rows + uniform(random, -5., 5.);
      const double tilt = uniform(random, sort.leastTilt, sort.mostTilt);
      const double minor = uniform(random, sort.leastMinor, sort.mostMinor);
      vpSimulatedMarker marker = printed(family, randomId(random, family));
      simulator.addMarker(marker.setPose(randomPose(random, minor / std::cos(tilt), tilt, u, v)));
    }
    vpImage<unsigned char> I;
    const auto truth = simulator.render(I, random());
    detector.detect(I);
    for (const auto &marker : truth) {
      ++markers;
      for (const vpCircleMarkerDetection &detection : detector.getDetections()) {
        if (vpImagePoint::distance(detection.center, marker.center) < 1.) {
          ++found;
          EXPECT_EQ(marker.id, detection.id) << "image " << image;
        }
      }
    }
    EXPECT_LE(detector.getNbObjects(), truth.size());
  }
  ::testing::Test::RecordProperty("found", static_cast<int>(found));
  ::testing::Test::RecordProperty("markers", static_cast<int>(markers));
  EXPECT_GE(found, sort.floor * markers) << "of " << markers;
}
} // namespace

// Their black line and their quiet zone are thinner than a pixel: no outer edge is left of them.
TEST(DetectorReach, RingsFromAMinorAxisOfEightPixels)
{
  expectReach({vpCircleMarkerFamily::RING, 8., 12., 1., 80., 160., 0.97});
}

// On white ground both edges of the line are found too far apart.
TEST(DetectorReach, RingsFromAMinorAxisOfEightPixelsOnWhite)
{
  expectReach({vpCircleMarkerFamily::RING, 8., 12., 1.3, 220., 220., 0.97});
}

// On ground as dark as the ink, a quiet zone that is hardly wider than the blur leaves no outer edge either.
TEST(DetectorReach, RingsInMuchBlurOnDarkGround)
{
  expectReach({vpCircleMarkerFamily::RING, 14., 18., 1., 20., 60., 0.9, 1.1});
}

// The ring is in the image, its quiet zone is not, in up to a third of the directions.
TEST(DetectorReach, RingsAtTheImagesBorder)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::RING);
  vpDetectorCircleMarker detector(family);
  for (int image = 0; image < 12; ++image) {
    vpMarkerSceneSimulator simulator(straightCamera(), width, height);
    const double diameter = uniform(random, 60., 250.);
    const double v = height - 0.5 * diameter - uniform(random, 1.5, 0.07 * diameter); // the quiet zone has a twelfth
    simulator.addMarker(
        printed(family, -1)
            .setPose(randomPose(random, diameter, uniform(random, 0., 0.1), uniform(random, 0.4, 0.6) * width, v)));
    vpImage<unsigned char> I;
    simulator.render(I, random());
    EXPECT_TRUE(detector.detect(I)) << "image " << image << ", diameter " << diameter << " pixels";
  }
}

// A sector is as long as the blur is wide: 1.2 pixels where the ellipse is narrow, or less. None may be read as
// another.
TEST(DetectorReach, CodesWhoseSectorsAreAsSmallAsTheBlur)
{
  expectReach({vpCircleMarkerFamily::GOLAY23, 9., 12., 1.2, 220., 220., 0.93});
}

TEST(DetectorReach, LongCodesWhoseSectorsAreAsSmallAsTheBlur)
{
  expectReach({vpCircleMarkerFamily::BCH31, 11., 15., 1.2, 220., 220., 0.93});
}

TEST(DetectorReach, CodesOnGreyGround)
{
  expectReach({vpCircleMarkerFamily::GOLAY23, 13., 17., 1.1, 80., 160., 0.97});
}

// The quiet zone is as wide as the blur: between the ring and the ground no outer edge is left, and the ring is found
// by its dark line, from the edge of the sheet or from its own inside.
TEST(DetectorReach, CodesOnDarkGround)
{
  expectReach({vpCircleMarkerFamily::GOLAY23, 13., 20., 0.9, 10., 50., 0.92, 0.9});
}

TEST(DetectorReach, LongCodesOnDarkGround)
{
  expectReach({vpCircleMarkerFamily::BCH31, 15., 22., 0.9, 10., 50., 0.97, 0.9});
}

// The ground is brighter than the paper: both edges are one slope.
TEST(DetectorReach, CodesOnBrightGround)
{
  expectReach({vpCircleMarkerFamily::GOLAY23, 13., 20., 0.9, 225., 245., 0.93, 0.9, 140.});
}

// Where the ellipse is narrow its track is less than a pixel wide, and only the sectors at its ends are read one by
// one.
TEST(DetectorReach, CodesAtGrazingAngles)
{
  expectReach({vpCircleMarkerFamily::GOLAY23, 5.5, 8., 1.4, 220., 220., 0.95, 0.7, 220., 1.2});
}

// And the ring has no outer edge but at its ends: it is found by the shape of its sheet.
TEST(DetectorReach, CodesAtGrazingAnglesOnDarkGround)
{
  expectReach({vpCircleMarkerFamily::GOLAY23, 7., 9., 1.4, 10., 160., 0.87, 0.7, 220., 1.2});
}

// Where paper, ring and ground are alike in the blur both edges are in pieces: what shows are the ends of either.
TEST(DetectorReach, CodesAtGrazingAnglesOnGreyGround)
{
  expectReach({vpCircleMarkerFamily::GOLAY23, 6., 9., 1.45, 100., 160., 0.9, 0.7, 220., 1.3});
}

// Narrower again: along the sides nothing is left but lines, and dots where the ends were.
TEST(DetectorReach, CodesLikeTwoDots)
{
  expectReach({vpCircleMarkerFamily::GOLAY23, 5., 7., 1.45, 10., 245., 0.97, 0.7, 220., 1.3});
}

// The noise alone keeps them from correlating with their model.
TEST(DetectorReach, FaintCodes)
{
  expectReach({vpCircleMarkerFamily::GOLAY23, 16., 24., 0.9, 110., 110., 0.95, 0.9, 110., 0., 50., 4.5});
}

namespace {
// Large markers seen nearly from the side: how they are drawn.
struct Grazing
{
  double leastDiameter, mostDiameter; // pixels
  double leastTilt, mostTilt;         // rad
  double leastGround, mostGround;     // grey levels
  vpCircleMarkerFamily::vpType family = vpCircleMarkerFamily::GOLAY23;
};

// How many of so many images have their marker found; none may be read as another.
int foundOf(const Grazing &grazing, int images, Random &random)
{
  const vpCircleMarkerFamily family(grazing.family);
  vpDetectorCircleMarker detector(family);
  int found = 0;
  for (int image = 0; image < images; ++image) {
    const int id = randomId(random, family);
    vpMarkerSceneSimulator simulator(straightCamera(), width, height);
    simulator.setBackground(vpSceneBackground::plain(uniform(random, grazing.leastGround, grazing.mostGround)));
    const double tilt = uniform(random, grazing.leastTilt, grazing.mostTilt);
    const double diameter = uniform(random, grazing.leastDiameter, grazing.mostDiameter);
    simulator.addMarker(printed(family, id).setPose(randomPose(random, diameter, tilt)));
    vpImage<unsigned char> I;
    simulator.render(I, random());
    std::vector<vpHomogeneousMatrix> poses;
    found += detector.detect(I, size, straightCamera(), poses) ? 1 : 0;
    for (const vpCircleMarkerDetection &detection : detector.getDetections()) {
      EXPECT_EQ(id, detection.id) << "image " << image;
    }
  }
  ::testing::Test::RecordProperty("found", found);
  return found;
}
} // namespace

// However narrow, an ellipse of 200 pixels is no line.
TEST(DetectorReach, LargeMarkersAtGrazingAngles)
{
  Random random = randomOfTest();
  EXPECT_EQ(foundOf({180., 220., 1.49, 1.51, 120., 220.}, 20, random), 20);
}

// Thirty to forty times as long as wide.
TEST(DetectorReach, MarkersSeenNearlyFromTheSide)
{
  Random random = randomOfTest();
  EXPECT_GE(foundOf({300., 350., 1.535, 1.545, 220., 220.}, 40, random), 39);
  EXPECT_GE(foundOf({300., 400., 1.53, 1.54, 120., 200.}, 40, random), 38);
}

// As narrow, and shorter or longer; each edge is a chain of up to a thousand pixels, if it is whole.
TEST(DetectorReach, RingsSeenNearlyFromTheSide)
{
  Random random = randomOfTest();
  EXPECT_GE(foundOf({250., 400., 1.53, 1.54, 120., 220., vpCircleMarkerFamily::RING}, 40, random), 39);
}

// The sides of the ring and of its quiet zone are less than a pixel wide, and so is what the outline is off by there.
TEST(DetectorReach, NarrowRingsOnDarkGround)
{
  Random random = randomOfTest();
  EXPECT_GE(foundOf({75., 85., 1.45, 1.47, 10., 80., vpCircleMarkerFamily::RING}, 200, random), 184);
}

// A quiet zone of a pixel beside dark ground: a dark ring does not show all around.
TEST(DetectorReach, LongCodesAtASlantOnDarkGround)
{
  Random random = randomOfTest();
  EXPECT_GE(foundOf({55., 65., 1.36, 1.4, 10., 110., vpCircleMarkerFamily::BCH31}, 200, random), 197);
}

// Sectors are half as long again as pixels, but in such a blur and noise none of them can be told alone.
TEST(DetectorReach, CodesInMuchBlurAndNoise)
{
  expectReach({vpCircleMarkerFamily::GOLAY23, 18., 24., 1., 90., 160., 0.97, 1.16, 125., 0., 30., 5.});
}

// In noise the outline of something narrow is found on the image's half.
TEST(DetectorReach, NarrowLongCodesInNoise)
{
  expectReach({vpCircleMarkerFamily::BCH31, 15., 20., 1.31, 90., 200., 0.94, 0.9, 110., 1.1, 45., 6.});
}

// Noise breaks the sides of the outline, and its ends are not as narrow as those that are sought elsewhere.
TEST(DetectorReach, SmallCodesInStrongNoise)
{
  expectReach({vpCircleMarkerFamily::GOLAY23, 12., 16., 1.15, 90., 130., 0.85, 0.7, 220., 1., 30., 20.});
}

// Each id has a size of its own; a first reading of so small a code is often another's.
TEST(DetectorReach, SmallMarkersHaveTheSizeOfTheirId)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  const auto sizeOfId = [](int id) { return 0.1 + 0.001 * id; };
  std::map<int, double> sizes;
  for (int id = 0; id < static_cast<int>(family.getNbIds()); ++id) {
    sizes[id] = sizeOfId(id);
  }
  vpDetectorCircleMarker detector(family);
  detector.setMarkerSizes(sizes);
  detector.setZAlignedWithCameraAxis(true);
  unsigned int found = 0;
  for (int image = 0; image < 30; ++image) {
    const int id = randomId(random, family);
    const double diameter = uniform(random, 10., 13.) / sizeOfId(id) * size; // randomPose() has the usual size
    const vpHomogeneousMatrix cMo = randomPose(random, diameter, uniform(random, 0., 0.4));
    vpMarkerSceneSimulator simulator(straightCamera(), width, height);
    simulator.setBackground(vpSceneBackground::plain(220.));
    vpSimulatedMarker marker = printed(family, id, sizeOfId(id));
    simulator.addMarker(marker.setPose(cMo));
    vpImage<unsigned char> I;
    simulator.render(I, random());
    std::vector<vpHomogeneousMatrix> poses;
    detector.detect(I, size, straightCamera(), poses);
    for (const vpCircleMarkerDetection &detection : detector.getDetections()) {
      ++found;
      EXPECT_EQ(id, detection.id);
      EXPECT_NEAR(cMo[2][3], detection.cMo[2][3], 0.05 * cMo[2][3]);
    }
  }
  EXPECT_GE(found, 25u);
}
