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
 * Identity and spin of a marker from its code track.
 */

#include "decode/identify.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "decode/cyclic_code.h"
#include "decode/word_evidence.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Black and white sectors differ by this share of the ring's contrast at least: a golay23 track of 20 pixels outer
// diameter at 45 degrees keeps about a fifth after the blur between sectors is undone.
constexpr double leastContrast = 0.2;
// As far as a reading that has to be proven is concerned, by this: less is noise.
constexpr double leastUncertainContrast = 0.1;
// The middle between black and white sectors is that between ink and paper, and higher where the surround is black and
// dims a narrow quiet zone, but within the ring's contrast. Bright spots with a dark rim, whose slope around the spot
// was taken for sectors, have it outside.
constexpr double mostOffMiddle = 0.7;
// A quiet zone thinner than the blur on dark ground may have lost three quarters of its brightness, and the track seems
// brighter than white: the middle is at most this.
constexpr double mostMiddleInDimZone = 4.;
// A track that is not made of sectors leaves more than this share of its own contrast unexplained.
constexpr double mostResidual = 0.25;

// Each corrected sector asks for more agreement of the others: the whole capacity of the code used costs this much.
// (Of the readings of 1025 photographs without a marker, none of 25 phantoms with two corrections passes 0.75; markers
// of 20 pixels and more are read without correction at 0.77 and better.)
constexpr double marginOfCapacity = 0.3;

// Odds of the codeword of a covered marker, ln, against all others and what speaks against it: one in a thousand.
constexpr double leastOddsOfCovered = 7.;
// Where a sector has fewer pixels than this most of them lie at its borders, which phase and pose move: more is asked
// then. (Of 8400 covered golay23 of 12 to 45 pixels in any light one was read as another, with odds of e^8.6.)
constexpr double fewPixelsOfSector = 16.;
// So it is where no more sectors than one are told beyond the message's bits: there any word is a codeword, and a
// single sector that the cover makes another one is a wrong id. (One of 3000 golay23 behind paper that leaves another
// codeword was read as that, with 12.0 sectors and odds of e^7.2.)
constexpr double checkingSectors = 1.;
constexpr double leastOddsUnlessClear = 10.;
// And where the codeword was read sector by sector, with what covers the marker among the sectors: then it is one that
// is near to what is seen, and looked for in more than one image, as it is and as it was before a camera sharpened it.
// (Of 8400 covered golay23 six are read that way, two of them with less. One of 700 others was read as another, with
// odds of e^8.0.)
constexpr double leastOddsIfReadWhole = leastOddsUnlessClear;
// And so many of the sectors that are told are black: a ring with nothing inside but a few lines across it is white all
// around, and what is not is covered. (Such phantoms had 1.5 to 2.4. With 3, two of 280 golay23 of which 0.4 is covered
// less were found, with this none.)
constexpr double fewestBlack = 2.5;

/*! Sums of the soft values with the signs of a word's bits, byte by byte: four look-ups for a word. */
class Scores
{
public:
  Scores(const std::array<double, mostSectors> &soft, unsigned int sectors)
  {
    for (unsigned int byte = 0; byte < m_sums.size(); ++byte) {
      for (unsigned int value = 0; value < 256; ++value) {
        double sum = 0.;
        for (unsigned int bit = 0; bit < 8 && 8 * byte + bit < sectors; ++bit) {
          const double here = soft[sectors - 1 - 8 * byte - bit];
          sum += (value >> bit) & 1U ? here : -here;
        }
        m_sums[byte][value] = static_cast<float>(sum);
      }
    }
  }

  float of(CyclicCode::Word word) const
  {
    return m_sums[0][word & 0xff] + m_sums[1][(word >> 8) & 0xff] + m_sums[2][(word >> 16) & 0xff] +
           m_sums[3][word >> 24];
  }

private:
  std::array<std::array<float, 256>, 4> m_sums;
};

double agreement(const SectorReading &reading, CyclicCode::Word codeword)
{
  double sum = 0.;
  for (unsigned int k = 0; k < reading.sectors; ++k) {
    sum += isSectorBlack(codeword, k, reading.sectors) ? reading.soft[k] : -reading.soft[k];
  }
  return sum / reading.sectors;
}

// What is left unsaid by sectors of which so many may be wrong, bits: the logarithm of the number of such errors.
double bitsOfErrors(unsigned int sectors, unsigned int errors)
{
  double ways = 1.;
  double patterns = 1.;
  for (unsigned int i = 1; i <= errors; ++i) {
    ways *= static_cast<double>(sectors + 1 - i) / i;
    patterns += ways;
  }
  return std::log2(patterns);
}

// The sectors in the other direction, as a mirror shows them.
CyclicCode::Word backwards(CyclicCode::Word word, unsigned int sectors)
{
  CyclicCode::Word mirrored = 0;
  for (unsigned int k = 0; k < sectors; ++k) {
    mirrored = (mirrored << 1) | ((word >> k) & 1U);
  }
  return mirrored;
}

// Whether a word is a marker's in a mirror, without a correction.
bool isMirroredMarker(CyclicCode::Word word, const CyclicCode &code)
{
  return code.identify(backwards(word, code.getLength())).has_value();
}
} // namespace

Judged<CodeReading> identify(const SectorReading &reading, const vpCircleMarkerFamily &family,
                             const DecodeSettings &settings)
{
  if (reading.contrast < leastContrast || std::abs(reading.middle - 0.5) > mostOffMiddle ||
      reading.residual > mostResidual * reading.contrast) {
    return vpCircleMarkerReject::NO_SECTORS;
  }
  CyclicCode::Word word = 0;
  for (unsigned int k = 0; k < reading.sectors; ++k) {
    word = (word << 1) | (reading.soft[k] > 0. ? 1U : 0U);
  }
  const CyclicCode &code = codeOf(family);
  const auto codeword = code.correct(word, settings.maximumHamming);
  const auto identity = codeword ? code.identify(*codeword) : std::nullopt;
  // Of all words one of seven is near enough to a codeword of golay23, so of those in a mirror, too: they are not
  // sectors that were misread. Of markers with such sectors one of 2000 is refused by this.
  if (!(identity && word == *codeword) && isMirroredMarker(word, code)) {
    return vpCircleMarkerReject::MIRRORED;
  }
  if (!identity) {
    return vpCircleMarkerReject::NO_CODEWORD;
  }
  CodeReading result;
  result.id = identity->id;
  result.hamming = hammingDistance(word, *codeword);
  result.margin = agreement(reading, *codeword);
  result.spin = reading.phase + 2. * M_PI * identity->rotation / reading.sectors;
  const double corrected = static_cast<double>(result.hamming) / code.getCapacity();
  if (result.margin < settings.minimumMargin + marginOfCapacity * corrected) {
    return {vpCircleMarkerReject::LOW_MARGIN, result};
  }
  return result;
}

std::optional<CodeReading> closestCode(const SectorReading &reading, const vpCircleMarkerFamily &family,
                                       bool mayZoneBeDim)
{
  const double mostMiddle = mayZoneBeDim ? mostMiddleInDimZone : 0.5 + mostOffMiddle;
  if (reading.contrast < leastUncertainContrast || reading.middle < 0.5 - mostOffMiddle ||
      reading.middle > mostMiddle) {
    return std::nullopt;
  }
  const CyclicCode &code = codeOf(family);
  const Scores scores(reading.soft, reading.sectors);
  CyclicCode::Word best = 0;
  float bestScore = -HUGE_VALF;
  code.forEachCodeword([&](CyclicCode::Word codeword) {
    const float score = scores.of(codeword);
    if (score > bestScore) {
      bestScore = score;
      best = codeword;
    }
  });
  const auto identity = code.identify(best);
  if (!identity) {
    return std::nullopt;
  }
  CodeReading result;
  result.id = identity->id;
  result.margin = static_cast<double>(bestScore) / reading.sectors;
  result.spin = reading.phase + 2. * M_PI * identity->rotation / reading.sectors;
  return result;
}

Judged<CodeReading> identifyCovered(const SectorReading &reading, const TrackPixels &pixels,
                                    const vpCircleMarkerFamily &family, const DecodeSettings &settings, SeenParts &seen)
{
  const CyclicCode &code = codeOf(family);
  WordEvidence evidence(pixels);
  evidence.turnTo(reading.phase);
  LikeliestWord best = evidence.likeliest(code);
  const double phase = evidence.improvePhase(best.word);
  const CyclicCode::Word turnedTo = best.word;
  best = evidence.likeliest(code);
  evidence.findCoverBeside(best.word);
  best = evidence.likeliest(code);
  if (best.word != turnedTo) { // the phase is another word's
    return vpCircleMarkerReject::NO_CODEWORD;
  }
  const auto identity = code.identify(best.word);
  if (!identity) {
    return vpCircleMarkerReject::NO_CODEWORD;
  }
  evidence.leaveOutUnexplained(best.word, seen);
  CodeReading result;
  result.id = identity->id;
  result.hamming = static_cast<unsigned int>(std::lround(best.contradicted));
  // By Laplace's rule of succession: a few sectors are not certainty.
  result.margin = (best.confirmed - best.contradicted) / (best.confirmed + best.contradicted + 2.);
  result.spin = phase + 2. * M_PI * identity->rotation / reading.sectors;
  // As many bits as the message has leave one codeword; each sector more halves the chance that what is none fits.
  const auto told = static_cast<unsigned int>(std::lround(best.confirmed + best.contradicted));
  const double checks = best.confirmed - bitsOfErrors(told, result.hamming) - code.getDimension();
  if (best.confirmedBlack < fewestBlack || checks < 0.) {
    return {vpCircleMarkerReject::NO_SECTORS, result};
  }
  const double corrected = static_cast<double>(result.hamming) / code.getCapacity();
  const bool isClear = evidence.pixelsPerSector() >= fewPixelsOfSector && checks >= checkingSectors;
  const double leastOdds = isClear ? leastOddsOfCovered : leastOddsUnlessClear;
  if (result.hamming > settings.maximumHamming || best.odds < leastOdds ||
      result.margin < settings.minimumMargin + marginOfCapacity * corrected) {
    return {vpCircleMarkerReject::LOW_MARGIN, result};
  }
  if (evidence.isOtherPrint(best.word, seen)) {
    return {vpCircleMarkerReject::NO_CODEWORD, result};
  }
  return result;
}

bool isLikeliest(const TrackPixels &pixels, CyclicCode::Word word, const vpCircleMarkerFamily &family)
{
  WordEvidence evidence(pixels);
  evidence.turnTo(0.);
  evidence.findCoverBeside(word);
  const LikeliestWord best = evidence.likeliest(codeOf(family));
  return best.word == word && best.odds >= leastOddsIfReadWhole;
}
} // namespace circle_marker
END_VISP_NAMESPACE
