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
 * Test of how covered codes are told.
 */

#include "testTrackTools.h"

#include "decode/identify.h"
#include "decode/word_evidence.h"

using namespace track_test;

namespace {
//! What the pixels say of the likeliest codeword, in the order in which identifyCovered() asks them.
LikeliestWord likeliestOf(const TrackPixels &pixels, const CyclicCode &code)
{
  WordEvidence evidence(pixels);
  evidence.turnTo(0.);
  evidence.improvePhase(evidence.likeliest(code).word);
  evidence.findCoverBeside(evidence.likeliest(code).word);
  return evidence.likeliest(code);
}
} // namespace

// Where any word is a codeword nothing checks it; where a sector does, the same odds are enough.
TEST(IdentifyCovered, WhatLeavesNoSectorToCheckItNeedsMoreOdds)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  const CyclicCode &code = codeOf(family);
  TrackMemory memory;
  int unchecked = 0;
  int checked = 0;
  for (int i = 0; i < 300; ++i) {
    const MarkerScene marker = scene(random, family);
    const double grey = i % 2 == 0 ? marker.white : uniform(random, marker.black, marker.white);
    const auto hidden = static_cast<unsigned int>(9 + i / 2 % 2); // of 23 sectors; the message has 12 bits
    const TrackPixels pixels(covered(marker, hidden, grey), CameraModel(marker.camera()), measuredRing(marker), family,
                             memory);
    const LikeliestWord best = likeliestOf(pixels, code);
    const double checks = best.confirmed - code.getDimension();
    if (best.odds < 7. || best.odds >= 10. || best.contradicted > 0.4 || checks < 0. || best.confirmedBlack < 2.6) {
      continue;
    }
    SectorReading reading;
    reading.sectors = family.getNbSectors();
    SeenParts seen;
    seen.directions = coveredSamplesPerSector * family.getNbSectors();
    const Judged<CodeReading> result = identifyCovered(reading, pixels, family, DecodeSettings(), seen);
    if (checks < 1.) {
      ++unchecked;
      EXPECT_FALSE(result) << "odds " << best.odds;
      EXPECT_EQ(result.reason(), vpCircleMarkerReject::LOW_MARGIN);
    }
    else {
      checked += result ? 1 : 0;
    }
  }
  EXPECT_GE(unchecked, 10);
  EXPECT_GE(checked, 20);
}
