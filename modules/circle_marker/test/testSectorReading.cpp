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
 * Reading the sectors of a code track in drawn images.
 */

#include "testRoomTools.h"

#include "decode/sector_reading.h"

using namespace circle_marker;
using namespace room_test;

namespace {
const vpCircleMarkerFamily::vpType codedFamilies[] = {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31,
                                                      vpCircleMarkerFamily::BCH31R};

//! The plane as a detector would know it: the right pose with any spin.
MarkerPlane withUnknownSpin(const MarkerScene &scene, double spin)
{
  MarkerPlane plane = scene.plane();
  plane.spin(spin);
  return plane;
}

int randomId(Random &random, const vpCircleMarkerFamily &family)
{
  return static_cast<int>(random() % family.getNbIds());
}
} // namespace

TEST(SectorReading, SoftValuesAndPhaseAreRight)
{
  Random random = randomOfTest();
  for (const vpCircleMarkerFamily::vpType type : codedFamilies) {
    const vpCircleMarkerFamily family(type);
    for (int i = 0; i < 25; ++i) {
      const MarkerScene scene = markerScene(random, family, randomId(random, family), uniform(random, 60., 110.),
                                            uniform(random, 0., 0.8), 150);
      const double spin = uniform(random, -M_PI, M_PI);
      const auto reading = readSectors(photograph(150, 150, 0.7, scene), CameraModel(scene.camera()),
                                       withUnknownSpin(scene, spin), family);
      ASSERT_TRUE(reading);
      ASSERT_EQ(reading->sectors, family.getNbSectors());
      const double sector = 2. * M_PI / family.getNbSectors();
      EXPECT_GE(reading->phase, 0.);
      EXPECT_LT(reading->phase, sector);
      // Angles of the plane are those of the marker less the spin: its borders lie at k sector - spin.
      const double off = std::remainder(reading->phase + spin, sector);
      EXPECT_LT(std::fabs(off), 0.25 * sector) << family.getName() << " spin " << spin;
      for (unsigned int k = 0; k < reading->sectors; ++k) {
        const double middle = reading->phase + (k + 0.5) * sector + spin;
        const double turns = middle / (2. * M_PI);
        const auto printed = static_cast<unsigned int>((turns - std::floor(turns)) * family.getNbSectors());
        const bool black = isSectorBlack(scene.word, printed, family.getNbSectors());
        EXPECT_GE(reading->soft[k], -1.);
        EXPECT_LE(reading->soft[k], 1.);
        EXPECT_GT(black ? reading->soft[k] : -reading->soft[k], 0.5) << family.getName() << " sector " << k;
      }
      EXPECT_NEAR(reading->contrast, 1., 0.15);
      EXPECT_LT(reading->residual, 0.1);
    }
  }
}

TEST(SectorReading, BlankTrackHasNoContrast)
{
  Random random = randomOfTest();
  for (int i = 0; i < 20; ++i) {
    const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
    MarkerScene scene = markerScene(random, family, 0, uniform(random, 40., 110.), uniform(random, 0., 0.8), 150);
    scene.word = 0;
    const auto reading = readSectors(digitise(expose(150, 150, 0.7, scene), 2., random), CameraModel(scene.camera()),
                                     scene.plane(), family);
    if (reading) {
      EXPECT_LT(reading->contrast, 0.15);
    }
  }
}

TEST(SectorReading, InvertedPrintIsRefused)
{
  // A white ring on black: not a dim reading, none.
  Random random = randomOfTest();
  for (int i = 0; i < 20; ++i) {
    const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
    MarkerScene scene = markerScene(random, family, 5, uniform(random, 40., 110.), uniform(random, 0., 0.8), 150);
    scene.white = ink;
    scene.black = paper;
    scene.surround = ink;
    EXPECT_FALSE(readSectors(photograph(150, 150, 0.7, scene), CameraModel(scene.camera()), scene.plane(), family));
  }
}

TEST(SectorReading, OutsideOfTheImageIsRefused)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  const MarkerScene scene = markerScene(random, family, 5, 100., 0.2, 150);
  const vpImage<unsigned char> I = photograph(150, 150, 0.7, scene);
  const CameraModel camera(scene.camera());
  ASSERT_TRUE(readSectors(I, camera, scene.plane(), family));
  for (int k = 0; k < 8; ++k) {
    MarkerPlane plane = scene.plane();
    const double angle = 2. * M_PI * k / 8.;
    plane.center += 0.8 * scene.radius * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.);
    EXPECT_FALSE(readSectors(I, camera, plane, family)) << k;
    plane.center += 10. * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.);
    EXPECT_FALSE(readSectors(I, camera, plane, family)) << k;
  }
}

TEST(SectorReading, UnevenLightDoesNotTurnSectors)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  for (int i = 0; i < 20; ++i) {
    const MarkerScene scene = markerScene(random, family, randomId(random, family), 90., uniform(random, 0., 0.7), 150);
    const double angle = uniform(random, 0., 2. * M_PI);
    // The light falls to a third from one side of the marker to the other.
    const auto lit = [&](double u, double v) {
      const double along = (std::cos(angle) * (u - 75.) + std::sin(angle) * (v - 75.)) / 45.;
      return scene(u, v) * (0.65 + 0.32 * std::min(std::max(along, -1.), 1.));
    };
    const auto reading =
        readSectors(photograph(150, 150, 0.7, lit), CameraModel(scene.camera()), scene.plane(), family);
    ASSERT_TRUE(reading);
    // The plane has the marker's own spin: a phase of almost a sector is one of almost zero, a sector earlier.
    const double sector = 2. * M_PI / family.getNbSectors();
    const unsigned int shift = reading->phase > 0.5 * sector ? 1 : 0;
    for (unsigned int k = 0; k < reading->sectors; ++k) {
      const unsigned int printed = (k + shift) % family.getNbSectors();
      const bool black = isSectorBlack(scene.word, printed, family.getNbSectors());
      EXPECT_GT(black ? reading->soft[k] : -reading->soft[k], 0.3) << "sector " << k;
    }
  }
}
