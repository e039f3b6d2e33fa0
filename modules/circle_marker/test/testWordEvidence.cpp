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
 * What all pixels of a covered code track say of all codewords.
 */

#include "testTrackTools.h"

#include <bitset>

#include "decode/word_evidence.h"

using namespace track_test;

TEST(WordEvidence, TellsTheCodewordThoughARunOfSectorsIsCovered)
{
  TrackMemory memory;
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31R}) {
    const vpCircleMarkerFamily family(type);
    const CyclicCode &code = codeOf(family);
    for (int i = 0; i < 10; ++i) {
      const MarkerScene marker = scene(random, family);
      const double share = uniform(random, 0.2, 0.8); // between ink and paper
      const double grey = marker.black + share * (marker.white - marker.black);
      constexpr unsigned int hidden = 7;
      const TrackPixels pixels(covered(marker, hidden, grey), CameraModel(marker.camera()), measuredRing(marker),
                               family, memory);
      WordEvidence evidence(pixels);
      evidence.turnTo(0.);
      evidence.findCoverBeside(marker.word);
      const LikeliestWord best = evidence.likeliest(code);
      EXPECT_EQ(best.word, marker.word) << "grey " << grey;
      EXPECT_GT(best.odds, 7.) << "grey " << grey;
      EXPECT_GT(best.confirmed, family.getNbSectors() - hidden - 2.);
      EXPECT_LT(best.confirmed, family.getNbSectors() - hidden + 1.);
      const CyclicCode::Word seen =
          marker.word & ((1U << (family.getNbSectors() - hidden)) - 1); // the first are hidden
      const auto black = static_cast<double>(std::bitset<32>(seen).count());
      EXPECT_GT(best.confirmedBlack, black - 2.);
      EXPECT_LT(best.confirmedBlack, black + 1.);
      EXPECT_LT(best.contradicted, 0.5);
    }
  }
}

TEST(WordEvidence, LeavesTwoCodewordsWhereTooMuchIsCovered)
{
  TrackMemory memory;
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  constexpr unsigned int hidden = 13; // of a code with 12 bits of message and 23 sectors
  for (int i = 0; i < 10; ++i) {
    const MarkerScene marker = scene(random, family);
    const TrackPixels pixels(covered(marker, hidden, 0.5 * (marker.black + marker.white)), CameraModel(marker.camera()),
                             measuredRing(marker), family, memory);
    WordEvidence evidence(pixels);
    evidence.turnTo(0.);
    EXPECT_LT(evidence.likeliest(codeOf(family)).odds, 7.);
  }
}

TEST(WordEvidence, DoubtsWhatLooksLikeTheCover)
{
  TrackMemory memory;
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  constexpr unsigned int hidden = 7;
  for (int i = 0; i < 10; ++i) {
    const MarkerScene marker = scene(random, family);
    for (const double grey : {marker.black, marker.white}) {
      const TrackPixels pixels(covered(marker, hidden, grey), CameraModel(marker.camera()), measuredRing(marker),
                               family, memory);
      WordEvidence evidence(pixels);
      evidence.turnTo(0.);
      evidence.findCoverBeside(marker.word);
      const LikeliestWord best = evidence.likeliest(codeOf(family));
      // Another one may be believed in no case, and what is covered is not told.
      EXPECT_TRUE(best.word == marker.word || best.odds < 7.) << "grey " << grey;
      EXPECT_LT(best.confirmed, family.getNbSectors() - hidden + 1.) << "grey " << grey;
    }
  }
}

TEST(WordEvidence, TurnsTheSectorsToWhereTheWordExplainsThem)
{
  TrackMemory memory;
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31R}) {
    const vpCircleMarkerFamily family(type);
    const double sector = 2. * M_PI / family.getNbSectors();
    for (int i = 0; i < 10; ++i) {
      const MarkerScene marker = scene(random, family);
      constexpr unsigned int hidden = 5;
      const TrackPixels pixels(covered(marker, hidden, marker.white), CameraModel(marker.camera()),
                               measuredRing(marker), family, memory);
      WordEvidence evidence(pixels);
      evidence.turnTo(uniform(random, -0.25, 0.25) * sector);
      EXPECT_NEAR(evidence.improvePhase(marker.word), 0., 0.02 * sector);
    }
  }
}

TEST(WordEvidence, LeavesOutWhatTheWordDoesNotExplain)
{
  TrackMemory memory;
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  const unsigned int sectors = family.getNbSectors();
  for (int i = 0; i < 10; ++i) {
    const MarkerScene marker = scene(random, family);
    constexpr unsigned int hidden = 6;
    // As bright as paper: where sectors are white nothing tells it from them, where they are black the word does.
    const TrackPixels pixels(covered(marker, hidden, marker.white), CameraModel(marker.camera()), measuredRing(marker),
                             family, memory);
    WordEvidence evidence(pixels);
    evidence.turnTo(0.);
    SeenParts seen;
    seen.directions = coveredSamplesPerSector * sectors;
    for (unsigned int k = 0; k < seen.directions; ++k) {
      seen.ring[k] = seen.track[k] = true;
      seen.center[k] = (k / coveredSamplesPerSector) % 2 == 0;
    }
    evidence.leaveOutUnexplained(marker.word, seen);
    for (unsigned int k = 0; k < sectors; ++k) {
      const unsigned int middle = coveredSamplesPerSector * k + coveredSamplesPerSector / 2;
      const auto isBlack = [&](unsigned int sector) { return isSectorBlack(marker.word, sector % sectors, sectors); };
      EXPECT_EQ(seen.ring[middle], k >= hidden) << k;
      EXPECT_EQ(seen.center[middle], seen.track[middle] && k % 2 == 0) << k;
      // White ones beside black ones are narrow enough to feel the blur of what is missing there.
      if (k >= hidden || isBlack(k) || (!isBlack(k + 1) && !isBlack(k + sectors - 1))) {
        EXPECT_EQ(seen.track[middle], k >= hidden || !isBlack(k)) << k;
      }
    }
  }
}

TEST(WordEvidence, AnotherPrintIsNoCoverUnlessTheRingIsHiddenWithIt)
{
  TrackMemory memory;
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  const vpCircleMarkerFamily other(vpCircleMarkerFamily::BCH31);
  for (int i = 0; i < 10; ++i) {
    const MarkerScene marker = scene(random, other);
    const auto picture = [&](double u, double v) { return marker(u, v); };
    const TrackPixels pixels(photograph(150, 150, lens, picture), CameraModel(marker.camera()), measuredRing(marker),
                             family, memory);
    WordEvidence evidence(pixels);
    evidence.turnTo(0.);
    const CyclicCode::Word likeliest = evidence.likeliest(codeOf(family)).word;
    SeenParts seen;
    seen.directions = coveredSamplesPerSector * family.getNbSectors();
    for (unsigned int k = 0; k < seen.directions; ++k) {
      seen.ring[k] = seen.track[k] = true;
    }
    EXPECT_FALSE(evidence.isOtherPrint(likeliest, seen)) << "in one place at most";
    evidence.leaveOutUnexplained(likeliest, seen);
    EXPECT_TRUE(evidence.isOtherPrint(likeliest, seen));
    seen.ring = seen.track; // what hides one hides the other: bars
    EXPECT_FALSE(evidence.isOtherPrint(likeliest, seen));
  }
}

TEST(WordEvidence, AnotherCodeShowsInPlainSightAndACoverDoesNot)
{
  TrackMemory memory;
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::BCH31R);
  constexpr double sectors = 31.;
  for (int i = 0; i < 10; ++i) {
    const MarkerScene marker = scene(random, family);
    CyclicCode::Word other = family.getCodeword(0);
    if (other == marker.word) {
      other = family.getCodeword(1);
    }
    const auto otherColours = [&](const vpImage<unsigned char> &I, CyclicCode::Word word) {
      const TrackPixels pixels(I, CameraModel(marker.camera()), measuredRing(marker), family, memory);
      WordEvidence evidence(pixels);
      evidence.turnTo(0.);
      return evidence.otherColours(word);
    };
    const auto count = [](CyclicCode::Word word) { return static_cast<double>(std::bitset<32>(word).count()); };
    // Sectors that are another one count, but for those of their pixels that are at rims and borders, which are many on
    // the narrow side of a tilted marker.
    const OtherColours plain = otherColours(covered(marker, 0, 0.), other);
    const double white = count(marker.word & ~other) / sectors; // by the other word
    const double black = count(other & ~marker.word) / sectors;
    EXPECT_GT(plain.ink + plain.paper, 0.1 * (white + black));
    EXPECT_LT(plain.ink, 1.2 * white);
    EXPECT_LT(plain.paper, 1.2 * black);
    EXPECT_GT(plain.sectors, 0.7 * sectors * (white + black));
    // Of its own word nothing is left; and a cover like ink hides gap and centre as well, one like paper the ring.
    for (const double grey : {marker.black, marker.white}) {
      for (const unsigned int hidden : {0U, 9U}) {
        const OtherColours own = otherColours(covered(marker, hidden, grey), marker.word);
        EXPECT_LT(own.ink + own.paper, 0.01) << hidden << " sectors are hidden";
        EXPECT_EQ(own.sectors, 0u) << hidden << " sectors are hidden";
      }
    }
  }
}

// Of any print, a codeword's or not. What a cover of another grey level hides is not told.
TEST(WordEvidence, TellsWhichSectorsArePrinted)
{
  TrackMemory memory;
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31}) {
    const vpCircleMarkerFamily family(type);
    const unsigned int sectors = family.getNbSectors();
    const CyclicCode::Word all = (CyclicCode::Word(1) << sectors) - 1;
    for (int i = 0; i < 10; ++i) {
      MarkerScene marker = scene(random, family);
      marker.word = static_cast<CyclicCode::Word>(random()) & all;
      for (const unsigned int hidden : {0U, 6U}) {
        const double grey = marker.black + 0.4 * (marker.white - marker.black);
        const TrackPixels pixels(covered(marker, hidden, grey), CameraModel(marker.camera()), measuredRing(marker),
                                 family, memory);
        WordEvidence evidence(pixels);
        evidence.turnTo(0.);
        const PrintedSectors printed = evidence.printedSectors();
        const CyclicCode::Word seen = all >> hidden; // the first sectors are hidden
        const auto count = [](CyclicCode::Word word) { return std::bitset<32>(word).count(); };
        EXPECT_EQ(printed.black & seen & ~marker.word, 0u);
        EXPECT_EQ(printed.white & seen & marker.word, 0u);
        // But for those beside the cover.
        EXPECT_GE(count((printed.black | printed.white) & seen), sectors - hidden - (hidden > 0 ? 2 : 0));
        EXPECT_LE(count((printed.black | printed.white) & ~seen), 1u);
      }
    }
  }
}

TEST(WordEvidence, WhiteThatIsCutOffIsBelievedLessThanWhatTheSensorTells)
{
  TrackMemory memory;
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::BCH31R);
  const CyclicCode &code = codeOf(family);
  for (int i = 0; i < 10; ++i) {
    const MarkerScene marker = scene(random, family);
    constexpr unsigned int hidden = 7;
    constexpr double cover = 0.3; // between ink and paper
    const vpImage<unsigned char> I = covered(marker, hidden, marker.black + cover * (marker.white - marker.black));
    // As if it were exposed so long that the middle between ink and paper is the brightest that the sensor tells.
    constexpr double brightest = 255.;
    const double exposure = 2. * brightest / (marker.black + marker.white);
    vpImage<unsigned char> over(I.getHeight(), I.getWidth());
    for (unsigned int k = 0; k < I.getSize(); ++k) {
      over.bitmap[k] = static_cast<unsigned char>(std::min(brightest, std::round(exposure * I.bitmap[k])));
    }
    MeasuredRing ring = measuredRing(marker);
    const auto likeliest = [&](const vpImage<unsigned char> &picture) {
      const TrackPixels pixels(picture, CameraModel(marker.camera()), ring, family, memory);
      WordEvidence evidence(pixels);
      evidence.turnTo(0.);
      evidence.findCoverBeside(marker.word);
      return evidence.likeliest(code);
    };
    const LikeliestWord usual = likeliest(I);
    ring.photometry.white *= exposure;
    const LikeliestWord best = likeliest(over);
    EXPECT_EQ(best.word, marker.word);
    EXPECT_GT(best.odds, 7.);
    EXPECT_LT(best.odds, usual.odds);
  }
}

TEST(WordEvidence, KnowsHowMuchLargerBlackIs)
{
  TrackMemory memory;
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::BCH31R);
  for (int i = 0; i < 10; ++i) {
    const MarkerScene marker = scene(random, family);
    const double growth = uniform(random, 0.008, 0.016); // 0.3 to 0.9 pixels
    const auto grown = [&](double u, double v) {
      const Eigen::Vector2d q = marker.onMarker(u, v);
      bool isBlack = marker.isBlack(q);
      constexpr int directions = 16;
      for (int k = 0; k < directions && !isBlack; ++k) {
        const double angle = 2. * M_PI * k / directions;
        isBlack = marker.isBlack(q + growth * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
      }
      return isBlack ? marker.black : marker(u, v);
    };
    const vpImage<unsigned char> I = photograph(150, 150, lens, grown);
    const auto seenWith = [&](double told) {
      MeasuredRing ring = measuredRing(marker);
      ring.photometry.blur.spread = told;
      const TrackPixels pixels(I, CameraModel(marker.camera()), ring, family, memory);
      WordEvidence evidence(pixels);
      evidence.turnTo(0.);
      SeenParts seen;
      seen.directions = coveredSamplesPerSector * family.getNbSectors();
      for (unsigned int k = 0; k < seen.directions; ++k) {
        seen.track[k] = true;
      }
      evidence.leaveOutUnexplained(marker.word, seen);
      return static_cast<double>(seen.track.count()) / seen.directions;
    };
    EXPECT_GT(seenWith(growth), 0.9) << growth;
    EXPECT_LT(seenWith(0.), 0.5) << growth;
  }
}
