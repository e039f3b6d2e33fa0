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
 * Markers that were once read as another one: none may be again.
 */

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include <visp3/circle_marker/vpDetectorCircleMarker.h>

#include "hardships.h"
#include "scenes.h"

namespace {
struct Outcome
{
  unsigned int right = 0;
  unsigned int wrong = 0;
};

Outcome outcomeOf(const bench::Scene &scene, vpDetectorCircleMarker &detector)
{
  std::vector<vpHomogeneousMatrix> poses;
  detector.detect(scene.image, bench::markerSize, scene.camera, poses);
  Outcome outcome;
  for (const vpMarkerTruth &truth : scene.truth) {
    for (const vpCircleMarkerDetection &detection : detector.getDetections()) {
      if (vpImagePoint::distance(detection.center, truth.center) < 0.5 * truth.ellipse->semiAxisB) {
        (detection.id == truth.id ? outcome.right : outcome.wrong) += 1;
      }
    }
  }
  return outcome;
}
} // namespace

// Frames as bench-circle-marker --reach has them, in any light, in which a small marker was read as another one: each
// at a wrong pose, in a light and blur that had bent toward the wrong codeword.
TEST(DetectorWrongIds, SmallMarkersInAnyLight)
{
  vpDetectorCircleMarker detector(vpCircleMarkerFamily::GOLAY23);
  for (const std::uint64_t seed : {5180ULL, 5572ULL, 5890ULL, 41000001004ULL}) {
    bench::SceneOptions options;
    options.markers = 20;
    options.leastDiameter = 10.;
    options.greatestDiameter = 45.;
    options.mostTilt = 75. * M_PI / 180.;
    options.anyLight = true;
    options.clutter = seed % 2 == 1;
    options.seed = seed;
    const Outcome outcome = outcomeOf(bench::makeScene(options), detector);
    EXPECT_EQ(outcome.wrong, 0u) << seed;
    EXPECT_GE(outcome.right, 12u) << seed;
  }
}

// Markers whose sectors, read in another family's, are one of its codewords but for what dirt or a cover may be.
TEST(DetectorWrongIds, MarkersOfAnotherFamily)
{
  struct Print
  {
    const char *family;
    int id;
    const char *sought;
  };
  const std::vector<Print> prints = {{"bch31", 226, "golay23"}, {"bch31", 203, "golay23"}, {"bch31r", 42, "golay23"},
                                     {"bch31r", 59, "golay23"}, {"bch31r", 47, "golay23"}, {"golay23", 28, "bch31"},
                                     {"golay23", 115, "bch31"}, {"golay23", 109, "bch31"}};
  std::mt19937_64 random(20261129);
  const vpCameraParameters camera(800., 800., 119.5, 119.5);
  for (const Print &print : prints) {
    vpDetectorCircleMarker own(vpCircleMarkerFamily::fromName(print.family));
    vpDetectorCircleMarker other(vpCircleMarkerFamily::fromName(print.sought));
    unsigned int right = 0;
    unsigned int wrong = 0;
    constexpr unsigned int frames = 25;
    for (unsigned int frame = 0; frame < frames; ++frame) {
      std::uniform_real_distribution<double> share(0., 1.);
      const double diameter = 35. * std::pow(4., share(random)); // pixels
      const double tilt = 1.05 * share(random);
      const double direction = 2. * M_PI * share(random);
      vpHomogeneousMatrix cMo(0., 0., 800. * bench::markerSize / diameter, tilt * std::cos(direction),
                              tilt * std::sin(direction), 0.);
      vpMarkerSceneSimulator simulator(camera, 240, 240);
      vpSimulatedMarker marker = vpSimulatedMarker::circle(print.family, print.id, bench::markerSize);
      simulator.addMarker(marker.setPose(cMo));
      vpImage<unsigned char> I;
      simulator.render(I, random());
      std::vector<vpHomogeneousMatrix> poses;
      own.detect(I, bench::markerSize, camera, poses);
      right += own.getTagsId() == std::vector<int>({print.id}) ? 1 : 0;
      other.detect(I, bench::markerSize, camera, poses);
      wrong += static_cast<unsigned int>(other.getNbObjects());
    }
    EXPECT_EQ(right, frames) << print.family << " " << print.id;
    EXPECT_EQ(wrong, 0u) << print.family << " " << print.id << " as " << print.sought;
  }
}

// The smallest markers that are read, tilted by up to 80 degrees: half of them are found. Each frame had a wrong one:
// in noise, with odds of e^26 to e^32 at a wrong pose, or read sector by sector, where the codeword left three times
// what noise and model do.
TEST(DetectorWrongIds, MarkersOfFewPixelsInAnyLight)
{
  struct Frame
  {
    std::uint64_t seed;
    double greatestDiameter; // pixels
    unsigned int leastRight; // of 150
  };
  vpDetectorCircleMarker detector(vpCircleMarkerFamily::GOLAY23);
  for (const Frame &frame : {Frame{16016, 24., 50}, Frame{21007, 20., 50}, Frame{46022, 22., 50}, Frame{47012, 22., 30},
                             Frame{49021, 22., 35}, Frame{57011, 22., 40}}) {
    bench::SceneOptions options;
    options.markers = 150;
    options.leastDiameter = 8.;
    options.greatestDiameter = frame.greatestDiameter;
    options.mostTilt = 80. * M_PI / 180.;
    options.anyLight = true;
    options.seed = frame.seed;
    const Outcome outcome = outcomeOf(bench::makeScene(options), detector);
    EXPECT_EQ(outcome.wrong, 0u) << frame.seed;
    EXPECT_GE(outcome.right, frame.leastRight) << frame.seed;
  }
}

// What covers a third of the code makes it another codeword. A dark polygon: with odds of e^2585, and of the pixels
// that are not covered the fit leaves noise. A bar like paper: without a correction, and the image is like it but for
// the bar. A half plane: refused in the image, but not in what that was "before the camera sharpened it".
TEST(DetectorWrongIds, CoveredCodesThatLookLikeOthers)
{
  struct Frame
  {
    const char *family;
    const char *name;
    double level;
    std::uint64_t seed;
    unsigned int right;
  };
  for (const Frame &frame :
       {Frame{"bch31r", "polygon", 0.25, 7100021395, 1}, Frame{"golay23", "bar", 0.4, 8101024384, 0},
        Frame{"golay23", "half plane", 0.4, 7400022213, 0}}) {
    vpDetectorCircleMarker detector(vpCircleMarkerFamily::fromName(frame.family));
    const bench::Hardship hardship = {frame.name, frame.level, true};
    const Outcome outcome = outcomeOf(bench::makeHardScene(hardship, frame.family, frame.seed), detector);
    EXPECT_EQ(outcome.wrong, 0u) << frame.name;
    EXPECT_GE(outcome.right, frame.right) << frame.name;
  }
}

// Frames as bench-circle-marker --hardships --small has them: a part of a small code is covered, and it looks like
// another one more than like its own; or it is so far out of focus that nothing speaks against a corrected reading.
TEST(DetectorWrongIds, SmallCodesThatAreCoveredOrOutOfFocus)
{
  vpDetectorCircleMarker detector(vpCircleMarkerFamily::GOLAY23);
  struct Frame
  {
    const char *name;
    double level;
    std::uint64_t seed;
    bool covers;
  };
  for (const Frame &frame : {Frame{"polygon", 0.1, 9701029372, true}, Frame{"half plane", 0.4, 9701029457, true},
                             Frame{"defocus", 0.15, 9700029110, false}}) {
    const bench::Hardship hardship = {frame.name, frame.level, frame.covers};
    const Outcome outcome =
        outcomeOf(bench::makeHardScene(hardship, "golay23", frame.seed, bench::HardMarkers::SMALL), detector);
    EXPECT_EQ(outcome.wrong, 0u) << frame.name;
  }
}

// The same in light 2.5 times too strong: black sectors that the sensor could not tell from paper made it another code,
// all of whose sectors were clear.
TEST(DetectorWrongIds, SmallCodesThatAreOverExposed)
{
  vpDetectorCircleMarker detector(vpCircleMarkerFamily::GOLAY23);
  const bench::Hardship hardship = {"over-exposure", 2.5, false};
  for (const std::uint64_t seed : {5000035, 15000069, 301001631, 301001648, 301001871, 301002621, 301003277}) {
    const Outcome outcome =
        outcomeOf(bench::makeHardScene(hardship, "golay23", seed, bench::HardMarkers::SMALL), detector);
    EXPECT_EQ(outcome.wrong, 0u) << seed;
  }
}
