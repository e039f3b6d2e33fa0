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
 * How well a codeword explains the pixels of a covered code track, and where it does not.
 */

#include "decode/word_evidence.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "decode/extended_word.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Step by which the grid of sectors is first turned to a word, of a sector: where a bar lies on a border the reading
// before was off by a tenth, and with its halves it reaches a third.
constexpr double firstStep = 1. / 6.;
// Of the pixels of ring or track in a direction that shows it, this share may be other than the codeword makes them.
constexpr double mostUnexplained = 0.1;
// A pixel beside the track has this share of the ring in it, at least, to tell of that.
constexpr double leastInkOfRing = 0.1;
// Share of the track's pixels that another print leaves as unexplained ink or paper, and that it leaves of either: of
// 28 bch31 that were read as golay23 the least were 0.095 and 0.021.
constexpr double leastOtherPrint = 0.085;
constexpr double leastOfEither = 0.015;
// Where this share of the ring is seen, and so much of the track is not explained, a cover would lie on the track
// alone; if this share of what it shows is like ink or paper, it is another print. Covers of any grey level have less.
constexpr double wholeRing = 0.9;
constexpr double muchOfTrack = 0.2;
constexpr double likePrint = 0.15;
// And it is scattered: in so many places around the marker, where one cover is in one or two.
constexpr int placesOfPrint = 4;
// Share of the pixels beside a part of the track that may be other than they should be and it still be in plain sight.
constexpr double mostUnexplainedBeside = 0.05;
// Share of such a part's own pixels that are of another colour, from rim to rim: along the edge of a cover it is less.
constexpr double leastOfDepth = 0.8;
// A pixel shows a sector alone if this share of it does. A sector is another one if of so many such pixels at least
// this share is, since the wrong codeword may have turned the sectors by some of their length, and of those beside it
// no more than this are other than they should be.
constexpr float leastAlone = 0.85f;
constexpr unsigned int fewestAlone = 2;
constexpr double leastOfSector = 0.45;
constexpr double mostUnexplainedBesideSector = 0.1;

// Runs of directions, most of a sector long, in which the track is not seen though the ring is, to a sector around:
// what crosses a marker hides both.
int placesOfTrackAlone(const SeenParts &seen)
{
  constexpr unsigned int shortest = 3 * coveredSamplesPerSector / 4;
  constexpr unsigned int around = coveredSamplesPerSector;
  const auto isCrossed = [&](unsigned int k) {
    for (unsigned int i = 0; i <= 2 * around; ++i) {
      if (!seen.ring[(k + seen.directions - around + i) % seen.directions]) {
        return true;
      }
    }
    return false;
  };
  unsigned int start = 0; // a direction in which the track is seen, so that no run goes on over the start
  while (start < seen.directions && !seen.track[start]) {
    ++start;
  }
  int places = 0;
  unsigned int length = 0;
  bool isAlone = true;
  for (unsigned int i = 1; i <= seen.directions; ++i) {
    const unsigned int k = (start + i) % seen.directions;
    if (seen.track[k]) {
      places += isAlone && length >= shortest ? 1 : 0;
      length = 0;
      isAlone = true;
    }
    else {
      ++length;
      isAlone = isAlone && !isCrossed(k);
    }
  }
  return places;
}

// Pixels in a direction.
struct Count
{
  void add(bool isUnexplained)
  {
    ++all;
    unexplained += isUnexplained ? 1 : 0;
  }

  unsigned int all = 0;
  unsigned int unexplained = 0;
};

// Pixels of the parts of a track, those that are of another colour, and of what is beside it.
struct PartCounts
{
  std::array<unsigned int, mostParts> all{};   // of the track
  std::array<unsigned int, mostParts> ink{};   // where the word has white
  std::array<unsigned int, mostParts> paper{}; // where it has black
  std::array<Count, mostParts> beside{};       // of ring, gap and centre
};

// Whether ring, gap and centre are what they should be beside a part of so many, to a quarter of a sector.
bool isInPlainSight(const PartCounts &counts, unsigned int part, unsigned int parts)
{
  constexpr unsigned int reach = partsPerSector / 4;
  Count near;
  for (unsigned int k = 0; k <= 2 * reach; ++k) {
    const Count &here = counts.beside[(part + parts + k - reach) % parts];
    near.all += here.all;
    near.unexplained += here.unexplained;
  }
  return near.all > 0 && near.unexplained <= mostUnexplainedBeside * near.all;
}
} // namespace

// What a word leaves of the pixels of the track; of one that something covers no more than what it may be off.
double WordEvidence::misfitAt(double phase, CyclicCode::Word word) const
{
  const std::uint64_t bits = extended(word, m_sectors);
  const float most = m_slack * m_slack;
  double sum = 0.;
  for (const Pixel &pixel : m_pixels.getMemory().pixels) {
    if (pixel.track > 2. * m_slack) {
      const Explained placed = placedAt(pixel, phase);
      const float residual = placed.residualOf(coloursAt(bits, placed.sector, m_sectors));
      sum += std::min(residual * residual, most);
    }
  }
  return sum;
}

double WordEvidence::improvePhase(CyclicCode::Word word)
{
  turnTo(leastPhase(m_phase, m_sectors, firstStep, [&](double phase) { return misfitAt(phase, word); }));
  return m_phase;
}

bool WordEvidence::isOtherPrint(CyclicCode::Word word, const SeenParts &seen) const
{
  const std::vector<Pixel> &pixels = m_pixels.getMemory().pixels;
  const std::uint64_t bits = extended(word, m_sectors);
  double all = 0.;
  double unexplained = 0.;
  double ink = 0.;
  double paper = 0.;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const Explained &placed = m_explained[i];
    if (!placed.isOnTrack) {
      continue;
    }
    all += 1.;
    if ((placed.byColours >> coloursAt(bits, placed.sector, m_sectors)) & 1U) {
      continue;
    }
    unexplained += 1.;
    ink += std::abs(pixels[i].level) < m_slack ? 1. : 0.;
    paper += placed.isCutOff || std::abs(1. - pixels[i].level) < m_slack ? 1. : 0.;
  }
  if (placesOfTrackAlone(seen) < placesOfPrint) {
    return false;
  }
  const bool hasBoth = ink + paper > leastOtherPrint * all && std::min(ink, paper) > leastOfEither * all;
  const bool isInside =
      seen.shareOfRing() > wholeRing && unexplained > muchOfTrack * all && ink + paper > likePrint * unexplained;
  return hasBoth || isInside;
}

OtherColours WordEvidence::otherColours(CyclicCode::Word word) const
{
  const std::vector<Pixel> &pixels = m_pixels.getMemory().pixels;
  const std::uint64_t bits = extended(word, m_sectors);
  const PrintedSectors printed = printedSectors();
  const std::uint64_t printedBits = extended((word & ~printed.white) | printed.black, m_sectors);
  const unsigned int parts = partsPerSector * m_sectors;
  PartCounts counts;
  // Pixels that show a sector alone, with those that are of another colour, and pixels beside it.
  std::array<Count, mostSectors> alone{};
  std::array<Count, mostSectors> beside{};
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const Explained &placed = m_explained[i];
    const std::size_t part = pixels[i].partOf(parts);
    const bool isSo = (placed.byColours >> coloursAt(bits, placed.sector, m_sectors)) & 1U;
    if (placed.isOnTrack) {
      const unsigned int isInk = !isSo && std::abs(pixels[i].level) < m_slack ? 1 : 0;
      const unsigned int isPaper = !isSo && (placed.isCutOff || std::abs(1. - pixels[i].level) < m_slack) ? 1 : 0;
      ++counts.all[part];
      counts.ink[part] += isInk;
      counts.paper[part] += isPaper;
      if (placed.shares[1] > leastAlone) {
        alone[placed.sector].add(isInk + isPaper > 0);
      }
    }
    else if (pixels[i].track < 2. * m_slack) {
      counts.beside[part].add(!isSo);
      // Next to a sector of another colour the blur brings some of that.
      const bool isPrint = (placed.byColours >> coloursAt(printedBits, placed.sector, m_sectors)) & 1U;
      beside[placed.sector].add(!isPrint);
    }
  }
  OtherColours other;
  double onTrack = 0.;
  for (unsigned int part = 0; part < parts; ++part) {
    const unsigned int either = counts.ink[part] + counts.paper[part];
    onTrack += counts.all[part];
    if (either > leastOfDepth * counts.all[part] && isInPlainSight(counts, part, parts)) {
      other.ink += counts.ink[part];
      other.paper += counts.paper[part];
    }
  }
  for (unsigned int sector = 0; sector < m_sectors; ++sector) {
    const bool isBlack = isSectorBlack(word, sector, m_sectors);
    const bool isOther =
        (alone[sector].all >= fewestAlone && alone[sector].unexplained >= leastOfSector * alone[sector].all) ||
        isSectorBlack(isBlack ? printed.white : printed.black, sector, m_sectors);
    const bool isSeen =
        beside[sector].all > 0 && beside[sector].unexplained <= mostUnexplainedBesideSector * beside[sector].all;
    other.sectors += isOther && isSeen ? 1 : 0;
  }
  const double perPixel = 1. / std::max(onTrack, 1.);
  other.ink *= perPixel;
  other.paper *= perPixel;
  return other;
}

void WordEvidence::leaveOutUnexplained(CyclicCode::Word word, SeenParts &seen) const
{
  const std::vector<Pixel> &pixels = m_pixels.getMemory().pixels;
  const std::uint64_t bits = extended(word, m_sectors);
  std::array<Count, mostParts> onRing{};
  std::array<Count, mostParts> onTrack{};
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const Explained &placed = m_explained[i];
    const bool isOnTrack = pixels[i].track > 2. * m_slack;
    if (!isOnTrack && pixels[i].ring < leastInkOfRing) {
      continue;
    }
    const std::size_t part = pixels[i].partOf(seen.directions);
    const unsigned int colours = coloursAt(bits, placed.sector, m_sectors);
    (isOnTrack ? onTrack : onRing)[part].add(((placed.byColours >> colours) & 1U) == 0);
  }
  const auto isOther = [](const Count &count) { return count.unexplained > mostUnexplained * count.all; };
  for (unsigned int part = 0; part < seen.directions; ++part) {
    for (const unsigned int beside : {seen.directions - 1, 0U, 1U}) { // where the cover's blurred edge may be
      const unsigned int there = (part + beside) % seen.directions;
      seen.ring[there] = seen.ring[there] && !isOther(onRing[part]);
      seen.track[there] = seen.track[there] && !isOther(onTrack[part]);
      seen.center[there] = seen.center[there] && !isOther(onTrack[part]);
    }
  }
}
} // namespace circle_marker
END_VISP_NAMESPACE
