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
 * From the sectors of a drawn marker to its id and spin.
 */

#include "testRoomTools.h"

#include "decode/identify.h"

using namespace circle_marker;
using namespace room_test;

namespace {
const vpCircleMarkerFamily::vpType codedFamilies[] = {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31,
                                                      vpCircleMarkerFamily::BCH31R};

Judged<CodeReading> readMarker(const vpImage<unsigned char> &I, const MarkerScene &scene, double spin,
                               const DecodeSettings &settings = DecodeSettings())
{
  MarkerPlane plane = scene.plane();
  plane.spin(-spin); // its x axis lies `spin` before the marker's own
  const auto sectors = readSectors(I, CameraModel(scene.camera()), plane, scene.family);
  return sectors ? identify(*sectors, scene.family, settings) : Judged<CodeReading>(sectors.reason());
}

//! A reading of a word with all sectors clear, as if the phase were known.
SectorReading clearReading(std::uint32_t word, unsigned int sectors)
{
  SectorReading reading;
  reading.sectors = sectors;
  for (unsigned int k = 0; k < sectors; ++k) {
    reading.soft[k] = isSectorBlack(word, k, sectors) ? 1. : -1.;
  }
  reading.contrast = 1.;
  return reading;
}

//! Some distinct sectors.
std::uint32_t randomErrors(Random &random, unsigned int count, unsigned int sectors)
{
  std::uint32_t errors = 0;
  while (count > 0) {
    const std::uint32_t bit = 1U << (random() % sectors);
    if (!(errors & bit)) {
      errors |= bit;
      --count;
    }
  }
  return errors;
}
} // namespace

TEST(Identify, IdAndSpinOfDrawnMarkers)
{
  Random random = randomOfTest();
  for (const vpCircleMarkerFamily::vpType type : codedFamilies) {
    const vpCircleMarkerFamily family(type);
    for (int i = 0; i < 60; ++i) {
      const int id = static_cast<int>(random() % family.getNbIds());
      const MarkerScene scene =
          markerScene(random, family, id, uniform(random, 45., 110.), uniform(random, 0., 0.9), 150);
      const double spin = uniform(random, -M_PI, M_PI);
      const auto code = readMarker(digitise(expose(150, 150, 0.7, scene), 2., random), scene, spin);
      ASSERT_TRUE(code) << family.getName() << " " << id;
      EXPECT_EQ(code->id, id) << family.getName();
      EXPECT_EQ(code->hamming, 0u);
      EXPECT_GT(code->margin, 0.6);
      EXPECT_LT(std::fabs(wrapped(code->spin - spin)), 0.25 * 2. * M_PI / family.getNbSectors())
          << family.getName() << " spin " << spin << " read " << code->spin;
    }
  }
}

TEST(Identify, ErrorsAreCorrectedUpToTheSetting)
{
  Random random = randomOfTest();
  for (const vpCircleMarkerFamily::vpType type : codedFamilies) {
    const vpCircleMarkerFamily family(type);
    const unsigned int n = family.getNbSectors();
    const unsigned int capacity = (family.getMinimumDistance() - 1) / 2;
    for (int i = 0; i < 200; ++i) {
      const int id = static_cast<int>(random() % family.getNbIds());
      const unsigned int errors = static_cast<unsigned int>(random() % (capacity + 1));
      const SectorReading reading = clearReading(family.getCodeword(id) ^ randomErrors(random, errors, n), n);
      for (unsigned int allowed = 0; allowed <= capacity; ++allowed) {
        DecodeSettings settings;
        settings.maximumHamming = allowed;
        settings.minimumMargin = 0.;
        const auto code = identify(reading, family, settings);
        ASSERT_EQ(static_cast<bool>(code), errors <= allowed) << family.getName() << " " << errors << " of " << allowed;
        if (code) {
          EXPECT_EQ(code->id, id);
          EXPECT_EQ(code->hamming, errors);
          EXPECT_NEAR(code->margin, 1. - 2. * errors / n, 1e-12);
          EXPECT_NEAR(wrapped(code->spin), 0., 1e-12);
        }
      }
    }
  }
}

TEST(Identify, SpinFollowsTheRotationAndThePhase)
{
  Random random = randomOfTest();
  for (const vpCircleMarkerFamily::vpType type : codedFamilies) {
    const vpCircleMarkerFamily family(type);
    const unsigned int n = family.getNbSectors();
    const std::uint32_t mask = (n == 32 ? 0U : (1U << n)) - 1U;
    for (int i = 0; i < 100; ++i) {
      const int id = static_cast<int>(random() % family.getNbIds());
      const unsigned int turned = static_cast<unsigned int>(random() % n);
      // Sector k of the word stands at k + turned: a turn to the right.
      const std::uint32_t word = family.getCodeword(id);
      SectorReading reading = clearReading(((word >> turned) | (word << (n - turned))) & mask, n);
      reading.phase = uniform(random, 0., 2. * M_PI / n);
      const auto code = identify(reading, family, DecodeSettings());
      ASSERT_TRUE(code);
      EXPECT_EQ(code->id, id);
      EXPECT_NEAR(wrapped(code->spin - (reading.phase + 2. * M_PI * turned / n)), 0., 1e-12);
    }
  }
}

TEST(Identify, WrongSectorsOnTheImage)
{
  // Sectors painted over: one is corrected by default, and with a setting of 0 the marker is not known.
  Random random = randomOfTest();
  for (int i = 0; i < 30; ++i) {
    const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
    const int id = static_cast<int>(random() % family.getNbIds());
    MarkerScene scene = markerScene(random, family, id, 90., uniform(random, 0., 0.7), 150);
    scene.word ^= randomErrors(random, 1, 23);
    const vpImage<unsigned char> I = photograph(150, 150, 0.7, scene);
    const double spin = uniform(random, -M_PI, M_PI);
    const auto code = readMarker(I, scene, spin);
    ASSERT_TRUE(code);
    EXPECT_EQ(code->id, id);
    EXPECT_EQ(code->hamming, 1u);
    EXPECT_LT(std::fabs(wrapped(code->spin - spin)), 0.25 * 2. * M_PI / 23.);
    DecodeSettings strict;
    strict.maximumHamming = 0;
    EXPECT_FALSE(readMarker(I, scene, spin, strict));
  }
}

// A word in the other direction is near enough to a codeword of golay23 once in seven: all of them are refused, but the
// few that are another codeword then, or their own. From the front each is itself, with an error as well.
TEST(Identify, MarkersInAMirrorAreNone)
{
  Random random = randomOfTest();
  for (const vpCircleMarkerFamily::vpType type : codedFamilies) {
    const vpCircleMarkerFamily family(type);
    const unsigned int n = family.getNbSectors();
    unsigned int symmetric = 0;
    for (int i = 0; i < 200; ++i) {
      const int id =
          i < 178 && type == vpCircleMarkerFamily::GOLAY23 ? i : static_cast<int>(random() % family.getNbIds());
      const std::uint32_t word = family.getCodeword(id);
      std::uint32_t mirrored = 0;
      for (unsigned int k = 0; k < n; ++k) {
        mirrored |= ((word >> k) & 1U) << (n - 1 - k);
      }
      const auto behind = identify(clearReading(mirrored, n), family, DecodeSettings());
      if (behind) {
        EXPECT_EQ(behind->hamming, 0u) << family.getName() << " " << id;
        ++symmetric;
      }
      else {
        EXPECT_EQ(behind.reason(), vpCircleMarkerReject::MIRRORED) << family.getName() << " " << id;
      }
      EXPECT_TRUE(identify(clearReading(word, n), family, DecodeSettings())) << family.getName() << " " << id;
    }
    EXPECT_LE(symmetric, 4u) << family.getName();
  }
}

// Sectors that are misread are hardly ever taken for a mirror.
TEST(Identify, MisreadMarkersAreSeldomMirrored)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  int lost = 0;
  for (int i = 0; i < 2000; ++i) {
    const int id = static_cast<int>(random() % family.getNbIds());
    const auto code =
        identify(clearReading(family.getCodeword(id) ^ randomErrors(random, 2, 23), 23), family, DecodeSettings());
    lost += code ? 0 : 1;
  }
  EXPECT_LT(lost, 6);
}

TEST(Identify, BlankBlackAndInvertedTracksAreNoCode)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  for (int i = 0; i < 30; ++i) {
    MarkerScene scene = markerScene(random, family, 5, uniform(random, 40., 110.), uniform(random, 0., 0.8), 150);
    for (const std::uint32_t word : {0U, (1U << 23) - 1U}) {
      scene.word = word;
      EXPECT_FALSE(readMarker(digitise(expose(150, 150, 0.7, scene), 2., random), scene, 0.3)) << word;
    }
    scene.word = family.getCodeword(5);
    scene.white = ink;
    scene.black = paper;
    EXPECT_FALSE(readMarker(photograph(150, 150, 0.7, scene), scene, 0.3));
  }
}

TEST(Identify, ConstantWordsAreNoMarkers)
{
  for (const vpCircleMarkerFamily::vpType type : codedFamilies) {
    const vpCircleMarkerFamily family(type);
    const unsigned int n = family.getNbSectors();
    DecodeSettings settings;
    settings.minimumMargin = 0.;
    settings.maximumHamming = 3;
    for (const std::uint32_t word : {0U, (1U << n) - 1U}) {
      for (unsigned int k = 0; k <= n; ++k) {
        const std::uint32_t flipped = k < n ? word ^ (1U << k) : word;
        EXPECT_FALSE(identify(clearReading(flipped, n), family, settings)) << family.getName();
      }
    }
  }
}

TEST(Identify, MarginContrastAndResidualAreDemanded)
{
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  const SectorReading clear = clearReading(family.getCodeword(7), 23);
  ASSERT_TRUE(identify(clear, family, DecodeSettings()));
  SectorReading dim = clear;
  for (double &soft : dim.soft) {
    soft *= 0.5;
  }
  DecodeSettings settings;
  settings.minimumMargin = 0.49;
  ASSERT_TRUE(identify(dim, family, settings));
  EXPECT_NEAR(identify(dim, family, settings)->margin, 0.5, 1e-12);
  settings.minimumMargin = 0.51;
  EXPECT_FALSE(identify(dim, family, settings));
  SectorReading pale = clear;
  pale.contrast = 0.05;
  EXPECT_FALSE(identify(pale, family, DecodeSettings()));
  SectorReading unexplained = clear;
  unexplained.residual = 0.5;
  EXPECT_FALSE(identify(unexplained, family, DecodeSettings()));
  SectorReading spot = clear; // of light: far whiter than the paper around
  spot.middle = 2.5;
  EXPECT_EQ(identify(spot, family, DecodeSettings()).reason(), vpCircleMarkerReject::NO_SECTORS);
  spot.middle = 1.; // a quiet zone that looks grey, of a small marker on black ground
  EXPECT_TRUE(identify(spot, family, DecodeSettings()));
}

// In the blur of dark ground the quiet zone is no white: the track is brighter.
TEST(Identify, TheClosestCodeMayBeBrighterThanADimZone)
{
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  SectorReading reading = clearReading(family.getCodeword(7), 23);
  for (const bool mayZoneBeDim : {false, true}) {
    const auto code = closestCode(reading, family, mayZoneBeDim);
    ASSERT_TRUE(code);
    EXPECT_EQ(code->id, 7);
  }
  reading.contrast = 3.;
  reading.middle = 2.;
  EXPECT_FALSE(closestCode(reading, family, false));
  const auto code = closestCode(reading, family, true);
  ASSERT_TRUE(code);
  EXPECT_EQ(code->id, 7);
  reading.middle = 5.;
  EXPECT_FALSE(closestCode(reading, family, true));
  reading.middle = -0.5;
  EXPECT_FALSE(closestCode(reading, family, true));
}

TEST(Identify, MarkersOfOtherFamiliesAreNotMistaken)
{
  Random random = randomOfTest();
  for (int i = 0; i < 30; ++i) {
    const vpCircleMarkerFamily printed(i % 2 ? vpCircleMarkerFamily::BCH31 : vpCircleMarkerFamily::GOLAY23);
    const vpCircleMarkerFamily sought(i % 2 ? vpCircleMarkerFamily::GOLAY23 : vpCircleMarkerFamily::BCH31);
    MarkerScene scene = markerScene(random, printed, static_cast<int>(random() % printed.getNbIds()),
                                    uniform(random, 50., 110.), uniform(random, 0., 0.7), 150);
    const vpImage<unsigned char> I = photograph(150, 150, 0.7, scene);
    scene.family = sought;
    EXPECT_FALSE(readMarker(I, scene, uniform(random, -M_PI, M_PI)));
  }
}
