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
 * What the pixels of a code track say of its sectors and of a codeword.
 */

#include "testTrackTools.h"

#include "decode/track_pixels.h"

using namespace track_test;

TEST(TrackPixels, ConfirmTheCodewordOfAMarkerThatNothingCovers)
{
  TrackMemory memory;
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31R}) {
    const vpCircleMarkerFamily family(type);
    for (int i = 0; i < 10; ++i) {
      const MarkerScene marker = scene(random, family);
      TrackPixels pixels(photograph(150, 150, lens, marker), CameraModel(marker.camera()), measuredRing(marker), family,
                         memory);
      pixels.turnTo(0.);
      EXPECT_FALSE(pixels.hasCoverLikePrint());
      const CodewordVerdict verdict = pixels.judge(marker.word);
      EXPECT_EQ(verdict.contradicted, 0U);
      EXPECT_GE(verdict.confirmed, family.getNbSectors() - 1);
      EXPECT_GT(verdict.explained, 0.95 * verdict.all);
      // Another codeword is contradicted where it differs, in seven sectors and more.
      const std::uint32_t other = codeOf(family).rotate(marker.word, 1);
      EXPECT_GE(pixels.judge(other).contradicted, 6U);
    }
  }
}

TEST(TrackPixels, FindThePhase)
{
  TrackMemory memory;
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  for (int i = 0; i < 10; ++i) {
    const MarkerScene marker = scene(random, family);
    TrackPixels pixels(photograph(150, 150, lens, marker), CameraModel(marker.camera()), measuredRing(marker), family,
                       memory);
    const double sector = 2. * M_PI / family.getNbSectors();
    SectorReading reading;
    reading.sectors = family.getNbSectors();
    reading.phase = uniform(random, -0.1, 0.1) * sector;
    reading.soft.fill(0.);
    reading.seen.fill(0.);
    pixels.improve(reading);
    EXPECT_NEAR(reading.phase, 0., 0.02 * sector);
    for (unsigned int k = 0; k < reading.sectors; ++k) {
      const bool black = isSectorBlack(marker.word, k, reading.sectors);
      EXPECT_TRUE(reading.seen[k] == 0. || reading.soft[k] == (black ? 1. : -1.)) << "sector " << k;
    }
  }
}

TEST(TrackPixels, SayNothingOfSectorsThatSomethingGreyCovers)
{
  TrackMemory memory;
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  constexpr unsigned int hidden = 6;
  for (int i = 0; i < 20; ++i) {
    const MarkerScene marker = scene(random, family);
    const double share = uniform(random, 0.1, 0.9); // between ink and paper
    const double grey = marker.black + share * (marker.white - marker.black);
    TrackPixels pixels(covered(marker, hidden, grey), CameraModel(marker.camera()), measuredRing(marker), family,
                       memory);
    pixels.turnTo(0.);
    const CodewordVerdict verdict = pixels.judge(marker.word);
    EXPECT_EQ(verdict.contradicted, 0U) << "grey " << grey;
    EXPECT_GE(verdict.confirmed, family.getNbSectors() - hidden - 1) << "grey " << grey;
    EXPECT_LE(verdict.confirmed, family.getNbSectors() - hidden) << "grey " << grey;
  }
}

TEST(TrackPixels, DoNotBelieveWhatLooksLikeTheCover)
{
  TrackMemory memory;
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  constexpr unsigned int hidden = 6;
  for (int i = 0; i < 10; ++i) {
    const MarkerScene marker = scene(random, family);
    for (const double grey : {marker.black, marker.white}) {
      TrackPixels pixels(covered(marker, hidden, grey), CameraModel(marker.camera()), measuredRing(marker), family,
                         memory);
      pixels.turnTo(0.);
      EXPECT_TRUE(pixels.hasCoverLikePrint());
      const CodewordVerdict verdict = pixels.judge(marker.word);
      EXPECT_EQ(verdict.contradicted, 0U) << "grey " << grey;
      EXPECT_LE(verdict.confirmed, family.getNbSectors() - hidden) << "grey " << grey;
      EXPECT_GE(verdict.confirmed, family.getNbSectors() - hidden - 3) << "grey " << grey;
    }
  }
}
