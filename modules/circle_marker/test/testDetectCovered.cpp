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
 * Tests of what is said of a marker that was read as a whole one.
 */

#include "detect_covered.h"
#include "ellipse/conic.h"
#include "ellipse/fit_conic.h"
#include "outer_edge.h"

#include <gtest/gtest.h>

#include "testMeasureTools.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr unsigned int side = 120;
constexpr double blur = 0.7;
constexpr double noise = 2.;
const vpCircleMarkerFamily golay23(vpCircleMarkerFamily::GOLAY23);

Recognition recognisedAs(const MarkerScene &scene, int id, unsigned int hamming)
{
  Recognition marker = recognised(scene, id, false);
  marker.code.hamming = hamming;
  return marker;
}

vpImage<unsigned char> pictureOf(const MarkerScene &scene, Random &random)
{
  return digitise(expose(side, side, blur, scene), noise, random);
}

// A marker that was read without a correction and measured at the pose it has.
struct MeasuredMarker
{
  MeasuredMarker(const MarkerScene &scene, int id, Random &random)
      : camera(scene.camera()), I(pictureOf(scene, random)), marker(recognisedAs(scene, id, 0)),
        measurement(measure(I, camera, marker, true, memory))
  {
  }

  // What is said of it, measured so, if it was read as something.
  WholeVerdict verdict(const Recognition &readAs, const Measurement &measured)
  {
    return judgeWhole(I, camera, noise, 1., readAs, measured, memory);
  }

  MeasureMemory memory;
  CameraModel camera;
  vpImage<unsigned char> I;
  Recognition marker;
  std::optional<Measurement> measurement;
};

// What is said of a marker that was read with some corrections, and whose outline is found but for a part.
WholeVerdict verdictOn(const vpImage<unsigned char> &I, const MarkerScene &scene, const Recognition &marker,
                       double support = 1.)
{
  MeasureMemory memory;
  const CameraModel camera(scene.camera());
  const auto measurement = measure(I, camera, marker, true, memory);
  EXPECT_TRUE(measurement);
  return measurement ? judgeWhole(I, camera, noise, support, marker, *measurement, memory) : WholeVerdict::WRONG;
}

// A marker with something grey in front of it, between two vertical edges.
struct CoveredScene
{
  MarkerScene marker;
  double from; // pixels
  double to;
  double operator()(double u, double v) const { return u >= from && u < to ? 90. : marker(u, v); }
};
} // namespace

TEST(DetectCovered, WhatShowsItsCodewordIsRight)
{
  Random random = randomOfTest();
  for (int i = 0; i < 10; ++i) {
    const MarkerScene scene = markerScene(random, golay23, i, uniform(random, 50., 80.), uniform(random, 0., 1.), side);
    const vpImage<unsigned char> I = pictureOf(scene, random);
    EXPECT_EQ(verdictOn(I, scene, recognisedAs(scene, i, 0)), WholeVerdict::RIGHT) << i;
    EXPECT_EQ(verdictOn(I, scene, recognisedAs(scene, i, 1), 0.5), WholeVerdict::RIGHT) << i << " with a doubt";
  }
}

TEST(DetectCovered, AnotherCodewordIsNotRight)
{
  Random random = randomOfTest();
  for (int i = 0; i < 10; ++i) {
    const MarkerScene scene = markerScene(random, golay23, i, uniform(random, 50., 80.), uniform(random, 0., 1.), side);
    // At the true pose: with another codeword the measurement would not end there.
    MeasuredMarker measured(scene, i, random);
    ASSERT_TRUE(measured.measurement);
    EXPECT_NE(measured.verdict(recognisedAs(scene, i + 20, 3), *measured.measurement), WholeVerdict::RIGHT) << i;
  }
}

// A perfect fit, but of too few of the pixels: those that were left out are the code's.
TEST(DetectCovered, AnotherCodewordThatWasLeftOutIsNotRight)
{
  Random random = randomOfTest();
  for (int i = 0; i < 10; ++i) {
    const MarkerScene scene = markerScene(random, golay23, i, uniform(random, 50., 80.), uniform(random, 0., 1.), side);
    MeasuredMarker measured(scene, i, random);
    ASSERT_TRUE(measured.measurement);
    Measurement measurement = *measured.measurement;
    const Recognition other = recognisedAs(scene, i + 20, 0);
    EXPECT_EQ(measured.verdict(other, measurement), WholeVerdict::RIGHT) << "not asked";
    measurement.first.inliers = 0.7;
    EXPECT_NE(measured.verdict(other, measurement), WholeVerdict::RIGHT) << i;
    EXPECT_EQ(measured.verdict(measured.marker, measurement), WholeVerdict::RIGHT);
  }
}

TEST(DetectCovered, WhatIsInFrontOfItIsSeen)
{
  Random random = randomOfTest();
  for (int i = 0; i < 10; ++i) {
    const MarkerScene scene =
        markerScene(random, golay23, i, uniform(random, 60., 80.), uniform(random, 0., 0.5), side);
    const CoveredScene covered{scene, 0.5 * side - 22., 0.5 * side - 6.};
    const vpImage<unsigned char> I = digitise(expose(side, side, blur, covered), noise, random);
    EXPECT_NE(verdictOn(I, scene, recognisedAs(scene, i, 0), 0.7), WholeVerdict::RIGHT) << i;
  }
}

// A marker of the contrast of a shadow's penumbra is one as long as the noise is all that is left; where something else
// has ripples of about the noise, it is not what was printed.
TEST(DetectCovered, FaintOnesLeaveNoMoreThanNoise)
{
  Random random = randomOfTest();
  for (int i = 0; i < 10; ++i) {
    MarkerScene scene = markerScene(random, golay23, i, uniform(random, 50., 80.), uniform(random, 0., 0.7), side);
    scene.white = 70.;
    scene.black = 58.;
    const vpImage<double> exposed = expose(side, side, blur, scene);
    EXPECT_EQ(verdictOn(digitise(exposed, noise, random), scene, recognisedAs(scene, i, 0)), WholeVerdict::RIGHT) << i;

    vpImage<double> rippled = exposed;
    for (unsigned int v = 0; v < side; ++v) {
      for (unsigned int u = 0; u < side; ++u) {
        rippled[v][u] += 2.2 * std::sin(1.9 * u) * std::sin(2.1 * v) * M_SQRT2;
      }
    }
    EXPECT_EQ(verdictOn(digitise(rippled, noise, random), scene, recognisedAs(scene, i, 0)), WholeVerdict::WRONG) << i;
  }
}

// What was read without a correction, of a fit that leaves much: where its blur leaves no pixel of one sector alone, no
// more than a share of the contrast may be left; and where there are such pixels, not nearly all may be against it.
TEST(DetectCovered, WhatNothingConfirmsIsWrong)
{
  Random random = randomOfTest();
  for (int i = 0; i < 10; ++i) {
    MarkerScene scene = markerScene(random, golay23, i, uniform(random, 50., 80.), uniform(random, 0., 0.7), side);
    MeasuredMarker measured(scene, i, random);
    ASSERT_TRUE(measured.measurement);
    const Photometry &photometry = measured.measurement->first.photometry;
    const double contrast = photometry.white * photometry.contrast();
    const auto verdictIf = [&](double sigma, double left) {
      Measurement changed = *measured.measurement;
      changed.first.photometry.blur.sigma = sigma;
      changed.first.noise = std::hypot(noise, left * contrast);
      return measured.verdict(measured.marker, changed);
    };
    EXPECT_EQ(verdictIf(10., 0.1), WholeVerdict::WRONG) << i;
    EXPECT_NE(verdictIf(10., 0.06), WholeVerdict::WRONG) << i;
    EXPECT_EQ(verdictIf(blur, 0.1), WholeVerdict::RIGHT) << i;
    scene.word = ~scene.word;
    measured.I = pictureOf(scene, random);
    EXPECT_EQ(verdictIf(blur, 0.1), WholeVerdict::WRONG) << i;
  }
}

// What something seems to cover is kept if what is seen tells its codeword from all others; and what is only doubtful
// if the image is like it, too.
TEST(DetectCovered, KeptThoughCoveredIfItsCodewordIsTold)
{
  Random random = randomOfTest();
  const MarkerScene scene = markerScene(random, golay23, 7, 70., 0.3, side);
  MeasuredMarker measured(scene, 7, random);
  ASSERT_TRUE(measured.measurement);
  const Recognition wrong = recognisedAs(scene, 27, 0);
  const auto isKept = [&](const Recognition &readAs, WholeVerdict verdict) {
    return isRightThoughCovered(measured.I, measured.camera, readAs, *measured.measurement, verdict, measured.memory);
  };
  EXPECT_TRUE(isKept(measured.marker, WholeVerdict::COVERED)) << "by its pixels";
  EXPECT_FALSE(isKept(wrong, WholeVerdict::COVERED)) << "though no sector was corrected";
  EXPECT_TRUE(isKept(wrong, WholeVerdict::DOUBTFUL));
  measured.measurement->first.correlation = 0.9;
  EXPECT_TRUE(isKept(measured.marker, WholeVerdict::DOUBTFUL)) << "by its pixels";
  EXPECT_FALSE(isKept(wrong, WholeVerdict::DOUBTFUL));
}

// What is measured again without what covers it starts from a flat sheet, whatever the first fit made of the cover.
TEST(DetectCovered, WhatIsMeasuredAgainStartsFlat)
{
  Random random = randomOfTest();
  int covered = 0;
  for (int i = 0; i < 8; ++i) {
    const MarkerScene scene = markerScene(random, golay23, i, 90., 0.3, side);
    MeasuredMarker measured(scene, i, random);
    ASSERT_TRUE(measured.measurement);
    measured.measurement->first.plane.bend.bow = 0.02;
    measured.measurement->first.plane.bend.saddle = Eigen::Vector2d(0.01, 0.);
    measured.I = digitise(expose(side, side, blur, CoveredScene{scene, 0., 0.5 * side - 30.}), noise, random);
    const auto part =
        withoutWhatCovers(measured.I, measured.camera, measured.marker, *measured.measurement, measured.memory);
    if (!part) {
      continue;
    }
    ++covered;
    for (const MarkerPlane &pose : part->poses) {
      EXPECT_FALSE(pose.bend.isAny()) << i;
    }
  }
  EXPECT_GT(covered, 4);
}

// Of an outer edge that is seen in all directions all is visible; of one behind a half plane the angle in front of it.
TEST(DetectCovered, VisibleEdgeIsTheShareOfItsDirections)
{
  Random random = randomOfTest();
  const double diameter = 70.;
  for (const double distance : {-40., 0., 20.}) { // of the edge from the centre, pixels
    const MarkerScene scene = markerScene(random, golay23, 7, diameter, 0., side);
    const CoveredScene covered{scene, 0. - side, 0.5 * side + distance};
    const vpImage<unsigned char> I = digitise(expose(side, side, blur, covered), noise, random);
    const MeasuredMarker whole(scene, 7, random);
    ASSERT_TRUE(whole.measurement);
    const double hidden = distance < -0.5 * diameter ? 0. : 1. - std::acos(distance / (0.5 * diameter)) / M_PI;
    EXPECT_NEAR(visibleEdgeOf(I, whole.camera, whole.marker, *whole.measurement), 1. - hidden, 0.04) << distance;
  }
}

// A covered ring has the other pose of its circle, too: what is seen of its outline does not tell them apart.
TEST(DetectCovered, ACoveredMarkerHasItsTwin)
{
  constexpr unsigned int wide = 160; // pixels
  constexpr double diameter = 90.;
  constexpr double hidden = 22.; // pixels of the centre that are left beside what covers the marker
  constexpr double tilt = 0.7;   // rad: the twin's normal is twice that away
  constexpr double support = 0.7;
  constexpr int scenes = 12;
  constexpr int pointsOfOutline = 128;
  Random random = randomOfTest();
  int found = 0;
  for (int i = 0; i < scenes; ++i) {
    const MarkerScene scene = markerScene(random, golay23, i, diameter, tilt, wide);
    const CoveredScene covered{scene, 0., 0.5 * wide - hidden};
    const vpImage<unsigned char> I = digitise(expose(wide, wide, blur, covered), noise, random);
    const CameraModel camera(scene.camera());
    std::vector<Eigen::Vector2d> along;
    for (int k = 0; k < pointsOfOutline; ++k) {
      const double angle = 2. * M_PI * k / pointsOfOutline;
      along.push_back(camera.toPixel(scene.plane().project(Eigen::Vector2d(std::cos(angle), std::sin(angle)))));
    }
    const auto conic = fitEllipse(along.data(), along.size());
    ASSERT_TRUE(conic);
    EllipseCandidate outline;
    outline.conic = *conic;
    outline.ellipse = *ellipseFromConic(*conic);
    outline.support = support;
    outline.contrast = paper - ink;
    MeasureMemory memory;
    const auto ring = recogniseCoveredRing(I, camera, {scene.plane(), twinOf(scene.plane())}, outline, golay23);
    const auto marker =
        ring ? recogniseByMeasuredRing(I, camera, *ring, golay23, DecodeSettings(), memory) : std::nullopt;
    if (!marker) {
      continue;
    }
    ++found;
    EXPECT_EQ(marker->code.id, i);
    EXPECT_NEAR(std::acos(marker->poses[0].rotation.col(2).dot(marker->poses[1].rotation.col(2))), 2. * tilt, 0.3) << i;
  }
  EXPECT_GT(found, scenes / 2);
}
