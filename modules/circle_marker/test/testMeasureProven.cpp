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
 * Tests of the proof that a marker with small sectors has to give.
 */

#include "measure_proven.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "testRoomTools.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr unsigned int side = 120;
constexpr double blur = 0.7;
constexpr double noise = 2.;

// Of a family with small codes, as oblique as is read.
MarkerScene smallScene(Random &random, const vpCircleMarkerFamily &family, int id)
{
  const double tilt = uniform(random, 0.3, 0.9);
  return markerScene(random, family, id, uniform(random, 13., 22.) / std::cos(tilt), tilt, side);
}

// The marker at its true pose, turned by some sectors, and the mirrored one.
Recognition recognisedAs(const MarkerScene &scene, int id, int sectors, bool isCertain)
{
  Recognition marker;
  marker.family = scene.family;
  marker.code.id = id;
  marker.isCertain = isCertain;
  MarkerPlane plane = scene.plane();
  plane.spin(2. * M_PI * sectors / scene.family.getNbSectors());
  marker.poses = {plane, twinOf(plane)};
  return marker;
}

vpImage<unsigned char> imageOf(const MarkerScene &scene, Random &random)
{
  return digitise(expose(side, side, blur, scene), noise, random);
}

std::optional<Measurement> prove(const vpImage<unsigned char> &I, const MarkerScene &scene, Recognition &marker,
                                 const Deadline &deadline = Deadline())
{
  MeasureMemory memory;
  return measureProven(I, CameraModel(scene.camera()), {noise, 1.}, marker, memory, deadline);
}

// How many sectors of a word are unlike those of another one that is turned by some.
int differentSectors(std::uint32_t word, std::uint32_t other, int turned, int sectors)
{
  int count = 0;
  for (int sector = 0; sector < sectors; ++sector) {
    count += (word >> sector & 1U) != (other >> ((sector + turned) % sectors) & 1U) ? 1 : 0;
  }
  return count;
}

// How far the x axes of two poses are apart.
double turnBetween(const MarkerPlane &measured, const MarkerPlane &truth)
{
  return std::acos(std::min(1., measured.rotation.col(0).dot(truth.rotation.col(0))));
}
} // namespace

TEST(MeasureProven, WhatIsThereIsProven)
{
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31, vpCircleMarkerFamily::BCH31R}) {
    const vpCircleMarkerFamily family(type);
    for (int i = 0; i < 20; ++i) {
      const int id = static_cast<int>(random() % family.getNbIds());
      const MarkerScene scene = smallScene(random, family, id);
      Recognition marker = recognisedAs(scene, id, 0, i % 2 == 0);
      const auto proven = prove(imageOf(scene, random), scene, marker);
      ASSERT_TRUE(proven) << family.getName() << " " << i;
      EXPECT_EQ(marker.code.id, id);
      EXPECT_LT(turnBetween(proven->first.plane, scene.plane()), 0.1);
    }
  }
}

// Seven sectors of 23 were misread, which makes another codeword: the one that the image shows, and its spin, come out.
// More unlike the image than that is no reading, and some of these are taken for none.
TEST(MeasureProven, AnotherReadingIsPutRight)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  const int sectors = static_cast<int>(family.getNbSectors());
  int count = 0;
  for (int i = 0; i < 20; ++i) {
    const int id = static_cast<int>(random() % family.getNbIds());
    const MarkerScene scene = smallScene(random, family, id);
    int other = id;
    int turned = 0;
    do {
      other = static_cast<int>(random() % family.getNbIds());
      turned = static_cast<int>(random() % family.getNbSectors());
    } while (differentSectors(scene.word, family.getCodeword(other), turned, sectors) != 7);
    Recognition marker = recognisedAs(scene, other, turned, false);
    marker.code.hamming = 2; // corrections of the first reading are none of the code that is put in its place
    const auto proven = prove(imageOf(scene, random), scene, marker);
    if (proven) {
      ++count;
      EXPECT_EQ(marker.code.id, id) << i;
      EXPECT_EQ(marker.code.hamming, 0u);
      EXPECT_LT(turnBetween(proven->first.plane, scene.plane()), 0.1);
    }
  }
  EXPECT_GE(count, 16);
}

// A wrong code draws the pose with it, the more so where the start is wrong, too; the sectors as they were read do not.
TEST(MeasureProven, SectorsAsTheyWereReadLeadToTheCode)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  int count = 0;
  int countWithout = 0;
  for (int i = 0; i < 40; ++i) {
    const int id = static_cast<int>(random() % family.getNbIds());
    const MarkerScene scene = smallScene(random, family, id);
    const vpImage<unsigned char> I = imageOf(scene, random);
    Recognition marker = recognisedAs(scene, (id + 1) % static_cast<int>(family.getNbIds()), 0, false);
    for (MarkerPlane &pose : marker.poses) {
      pose.center *= uniform(random, 0.95, 1.05);
      const Eigen::Vector3d axis = pose.rotation.col(0);
      pose.rotation = Eigen::AngleAxisd(uniform(random, -0.1, 0.1), axis).toRotationMatrix() * pose.rotation;
    }
    Recognition without = marker;
    countWithout += prove(I, scene, without) ? 1 : 0;
    marker.darkness.emplace();
    for (unsigned int k = 0; k < family.getNbSectors(); ++k) {
      const bool isBlack = isSectorBlack(scene.word, k, family.getNbSectors());
      (*marker.darkness)[k] = static_cast<float>((isBlack ? 0.7 : 0.3) + uniform(random, -0.3, 0.3));
    }
    if (prove(I, scene, marker)) {
      ++count;
      EXPECT_EQ(marker.code.id, id) << i;
      EXPECT_FALSE(marker.darkness);
    }
  }
  EXPECT_GE(count, 36);
  EXPECT_LT(countWithout, count);
  RecordProperty("without", countWithout);
  RecordProperty("with", count);
}

// A ring around sectors that are no codeword, nor near one; and around none.
TEST(MeasureProven, WhatIsNoCodewordIsNone)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::BCH31R);
  for (int i = 0; i < 20; ++i) {
    MarkerScene scene = smallScene(random, family, 3);
    scene.word ^= 0x1f0f0000; // of 31 sectors nine others: codewords differ in eleven at least
    Recognition marker = recognisedAs(scene, 3, 0, false);
    EXPECT_FALSE(prove(imageOf(scene, random), scene, marker)) << i;
    scene.word = 0;
    marker = recognisedAs(scene, 3, 0, false);
    EXPECT_FALSE(prove(imageOf(scene, random), scene, marker)) << i << ", without sectors";
  }
}

// Stripes across a marker, as lettering that was read for one: its code may stand out, but it is not what is printed.
TEST(MeasureProven, WhatIsUnlikeAPrintIsNone)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  for (int i = 0; i < 10; ++i) {
    const int id = static_cast<int>(random() % family.getNbIds());
    const MarkerScene scene = smallScene(random, family, id);
    vpImage<double> exposed = expose(side, side, blur, scene);
    Recognition marker = recognisedAs(scene, id, 0, true);
    EXPECT_TRUE(prove(digitise(exposed, noise, random), scene, marker)) << i;
    for (unsigned int v = 0; v < side; ++v) {
      for (unsigned int u = 0; u < side; ++u) {
        exposed[v][u] += 0.25 * (paper - ink) * std::sin(2. * M_PI * (u + 0.6 * v) / 7.);
      }
    }
    marker = recognisedAs(scene, id, 0, true);
    EXPECT_FALSE(prove(digitise(exposed, noise, random), scene, marker)) << i;
  }
}

// Over-exposed by a third no codewords are compared: the first reading decides, if it is certain of all sectors.
TEST(MeasureProven, WhereNothingIsComparedACorrectedReadingIsNone)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  for (int i = 0; i < 10; ++i) {
    const int id = static_cast<int>(random() % family.getNbIds());
    const MarkerScene scene = smallScene(random, family, id);
    vpImage<double> exposed = expose(side, side, blur, scene);
    for (unsigned int k = 0; k < exposed.getSize(); ++k) {
      exposed.bitmap[k] *= 4. / 3. * 255. / paper;
    }
    const vpImage<unsigned char> I = digitise(exposed, noise, random);
    Recognition marker = recognisedAs(scene, id, 0, true);
    EXPECT_TRUE(prove(I, scene, marker)) << i;
    marker = recognisedAs(scene, id, 0, true);
    marker.code.hamming = 1;
    EXPECT_FALSE(prove(I, scene, marker)) << i;
  }
}

TEST(MeasureProven, NothingAfterTheDeadline)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  const MarkerScene scene = smallScene(random, family, 5);
  const vpImage<unsigned char> I = imageOf(scene, random);
  const Deadline passed(1e-6);
  while (!passed.hasPassed()) {
  }
  Recognition marker = recognisedAs(scene, 5, 0, true);
  EXPECT_FALSE(prove(I, scene, marker, passed));
  EXPECT_TRUE(prove(I, scene, marker));
}

// On over-exposed paper, at the true pose. What is hidden there proves no code, and what shows does.
TEST(MeasureProven, OverExposedCodesMayBeOthers)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  const auto mayBeAnother = [&](double diameter, double white, bool isCovered) {
    MarkerScene scene = markerScene(random, family, 5, diameter, 0.4, side);
    scene.white = white;
    scene.black = white / 6.;
    const vpImage<unsigned char> I = imageOf(scene, random);
    const CameraModel camera(scene.camera());
    Recognition marker = recognisedAs(scene, 5, 0, true);
    if (isCovered) {
      marker.seen.emplace();
    }
    Measurement measurement; // the true one
    measurement.first.plane = scene.plane();
    measurement.first.photometry.white = scene.white;
    measurement.first.photometry.absorption = 1. - scene.black / scene.white;
    measurement.first.photometry.blur.sigma = blur;
    measurement.first.noise = noise;
    MeasureMemory memory;
    return mayBeOtherCode(I, camera, marker, measurement, memory);
  };
  for (int i = 0; i < 10; ++i) {
    EXPECT_FALSE(mayBeAnother(uniform(random, 20., 40.), 200., false)) << "the sensor can tell";
    EXPECT_FALSE(mayBeAnother(uniform(random, 35., 40.), 350., false)) << "all sectors show";
    EXPECT_TRUE(mayBeAnother(uniform(random, 14., 16.), 1500., false)) << "few sectors show";
    EXPECT_FALSE(mayBeAnother(uniform(random, 14., 16.), 1500., true)) << "read beside a cover, it is counted there";
  }
}

// Lengths of a sector at the middle of the track along the short axis: 2 pi b times its radius, by the sectors.
TEST(MeasureProven, SmallSectorsWantIt)
{
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  const vpCircleMarkerLayout &layout = family.getLayout();
  const double perLength = 23. / (M_PI * (layout.codeInner + layout.codeOuter));
  EllipseParameters outline;
  outline.a = 100.;
  outline.b = 1.59 * perLength;
  EXPECT_TRUE(wantsProof(outline, family));
  EXPECT_FALSE(wantsProof(outline, vpCircleMarkerFamily(vpCircleMarkerFamily::RING))) << "there is nothing to prove";
  outline.b = 1.61 * perLength;
  EXPECT_FALSE(wantsProof(outline, family)) << "if they were read for certain";
  outline.b = 1.89 * perLength;
  EXPECT_TRUE(mayBeUncertain(outline, family));
  outline.b = 1.91 * perLength;
  EXPECT_FALSE(mayBeUncertain(outline, family));
}
