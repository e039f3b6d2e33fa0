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

#include "decode/word_evidence.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "decode/extended_word.h"
#include "support/normal_distribution.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Least share of its sector that a pixel must show to tell it.
constexpr float leastOwn = 0.3f;
// Standard deviation of what the model leaves of a pixel's level at an edge, which phase and pose move, share of the
// contrast.
constexpr double edgeError = 0.02;
// So many standard deviations hold three quarters of the pixels. Of a cover whose grey level is off by two they hold a
// fifth; of a sector with the cover's blurred edge in it most.
constexpr double innerDeviations = 1.2;
constexpr double noneInner = 0.3;
constexpr double allInner = 0.6;
// Grey levels that covers have, share of the contrast.
constexpr double coverRange = 1.2;
constexpr double brightestCover = 1.1;
// Pixels by which a sector is told to 1 - 1 / e.
constexpr double tellingPixels = 3.;
// Levels that near to ink and paper may be the cover's, not those in between.
constexpr float nearPrint = 0.12f;
// Parts of a sector beyond coverReach over which it becomes unlikely that the same covers them.
constexpr unsigned int coverFades = 16;
// What a sector says for itself that may be covered by something like it: the odds that it is not covered.
constexpr double doubtful = 0.5;
// A sector's colour is told if it is by so much, by two pixels, and the other one is not.
constexpr float leastTold = 0.5f;
// What the edges of a sector say, rims and borders, which no cover of one grey level has.
constexpr double edgeOdds = 4.;
} // namespace

WordEvidence::WordEvidence(const TrackPixels &pixels)
    : m_pixels(pixels), m_sectors(pixels.getSectors()), m_slack(static_cast<float>(pixels.getSlack())),
      m_inner(static_cast<float>(innerDeviations * std::hypot(pixels.getNoise(), usualModelError))),
      m_innerAtEdge(static_cast<float>(innerDeviations * std::hypot(pixels.getNoise(), edgeError))),
      m_explained(pixels.getMemory().explained)
{
  findRangeOfCutOff();
  findCover();
  spreadTrust();
}

// Grey levels of covers that the sensor does not tell from paper.
void WordEvidence::findRangeOfCutOff()
{
  for (const Pixel &pixel : m_pixels.getMemory().pixels) {
    if (pixel.isCutOff) {
      m_cutOffRange = std::max(m_cutOffRange, brightestCover - pixel.level);
    }
  }
}

void WordEvidence::findCover()
{
  const unsigned int parts = partsPerSector * m_sectors;
  for (auto &kind : m_cover) {
    kind.fill(0);
  }
  for (const Pixel &pixel : m_pixels.getMemory().pixels) {
    if (pixel.mayBePrint(m_slack)) {
      continue;
    }
    const std::size_t part = pixel.partOf(parts);
    m_cover[0][part] += pixel.isCutOff || std::abs(1. - pixel.level) < m_slack ? 1 : 0;
    m_cover[1][part] += std::abs(pixel.level) < m_slack ? 1 : 0;
  }
}

void WordEvidence::spreadTrust()
{
  const int parts = static_cast<int>(partsPerSector * m_sectors);
  for (std::size_t kind = 0; kind < 2; ++kind) {
    m_trust[kind].fill(1.f);
    for (int i = 0; i < parts; ++i) {
      const auto at = [&](int k) { return m_cover[kind][static_cast<std::size_t>((i + parts + k) % parts)]; };
      if (at(0) == 0 || at(-1) + at(0) + at(1) < fewestOfCover) {
        continue;
      }
      const int reach = static_cast<int>(coverReach + coverFades);
      for (int k = -reach; k <= reach; ++k) {
        const float trust =
            std::max(0.f, static_cast<float>(std::abs(k)) - static_cast<float>(coverReach)) / coverFades;
        float &here = m_trust[kind][static_cast<std::size_t>((i + 2 * parts + k) % parts)];
        here = std::min(here, trust);
      }
    }
  }
}

// A pixel on the grid of sectors, without what explains it.
WordEvidence::Explained WordEvidence::placedAt(const Pixel &pixel, double phase) const
{
  const NormalDistribution &normal = NormalDistribution::instance();
  Explained placed;
  double place = (pixel.turn - phase / (2. * M_PI)) * m_sectors;
  place -= m_sectors * std::floor(place / m_sectors);
  placed.sector = std::min(static_cast<unsigned int>(place), m_sectors - 1);
  const double inside = place - placed.sector;
  const double width = pixel.spread * m_sectors;
  const double grown = pixel.growth / pixel.spread; // standard deviations of the blur
  const auto beyond = [&](double border) { return static_cast<float>(pixel.track * normal.at(border).cumulative); };
  const double toAfter = (inside - 1.) / width;
  const double toBefore = -inside / width;
  const float after = beyond(toAfter);
  const float before = beyond(toBefore);
  placed.shares = {after, static_cast<float>(pixel.track) - after - before, before};
  placed.growth = {{{after - beyond(toAfter - grown), beyond(toAfter + grown) - after},
                    {before - beyond(toBefore - grown), beyond(toBefore + grown) - before}}};
  placed.residual = static_cast<float>(pixel.level - (1. - pixel.ring));
  placed.isCutOff = pixel.isCutOff;
  return placed;
}

void WordEvidence::turnTo(double phase)
{
  m_phase = phase;
  const std::vector<Pixel> &pixels = m_pixels.getMemory().pixels;
  m_explained.resize(pixels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    Explained placed = placedAt(pixels[i], phase);
    placed.isOnTrack = placed.shares[1] > std::max(leastOwn, 2.f * m_slack);
    for (unsigned int colours = 0; colours < 8; ++colours) {
      const bool isSo = std::abs(placed.residualOf(colours)) < m_slack;
      placed.byColours |= static_cast<std::uint8_t>(isSo ? 1U << colours : 0U);
    }
    m_explained[i] = placed;
  }
  weigh();
}

// The patterns of colours, bit by bit, that a pixel and those beside it show all together.
std::uint32_t WordEvidence::patternsShownAt(std::size_t i) const
{
  const std::vector<Pixel> &pixels = m_pixels.getMemory().pixels;
  const std::vector<int> &grid = m_pixels.getMemory().grid;
  const auto columns = static_cast<std::ptrdiff_t>(m_pixels.getMemory().columns);
  const Explained &placed = m_explained[i];
  std::uint32_t shown = ~0U;
  const auto restrict = [&](const Explained &other, int ahead) { // other by so many sectors ahead
    std::uint32_t mask = 0;
    for (unsigned int pattern = 0; pattern < patterns; ++pattern) {
      mask |= static_cast<std::uint32_t>((other.byColours >> ((pattern >> (1 - ahead)) & 7U)) & 1U) << pattern;
    }
    shown &= mask;
  };
  restrict(placed, 0);
  for (const std::ptrdiff_t step : {std::ptrdiff_t(-1), std::ptrdiff_t(1), -columns, columns}) {
    const int beside = grid[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(pixels[i].cell) + step)];
    if (beside < 0) {
      continue;
    }
    const Explained &other = m_explained[static_cast<std::size_t>(beside)];
    const int ahead = static_cast<int>((other.sector + m_sectors - placed.sector + 1) % m_sectors) - 1;
    if (ahead <= 1) {
      restrict(other, ahead);
    }
  }
  return shown;
}

// Counts a pixel for the patterns that it shows.
void WordEvidence::count(std::size_t i, std::array<Tally, patterns> &ofSector) const
{
  const Pixel &pixel = m_pixels.getMemory().pixels[i];
  const Explained &placed = m_explained[i];
  const unsigned int parts = partsPerSector * m_sectors;
  const std::size_t part = pixel.partOf(parts);
  const std::uint32_t shown = patternsShownAt(i);
  for (unsigned int pattern = 0; pattern < patterns; ++pattern) {
    if (((shown >> pattern) & 1U) == 0) {
      continue;
    }
    const float residual = placed.residualOf((pattern >> 1) & 7U);
    const float level = placed.isCutOff ? 1.f : static_cast<float>(pixel.level) - residual; // as it should be
    const bool isEdge = level > nearPrint && level < 1.f - nearPrint;
    Tally &tally = ofSector[pattern];
    tally.counted += 1.f;
    tally.trusted += level < nearPrint ? m_trust[1][part] : level > 1.f - nearPrint ? m_trust[0][part] : 1.f;
    tally.inner += std::abs(residual) < (isEdge ? m_innerAtEdge : m_inner) ? 1.f : 0.f;
    tally.edges += isEdge ? 1.f : 0.f;
    tally.cutOff += placed.isCutOff ? 1.f : 0.f;
  }
}

// What the pixels that show a pattern say for it.
WordEvidence::Told WordEvidence::toldBy(const Tally &tally) const
{
  const double count = tally.counted;
  if (count < 1.) {
    return {};
  }
  const double noise = m_pixels.getNoise();
  const double seen = 1. - std::exp(-count / tellingPixels);
  const double trust = tally.trusted / count;
  const double told = trust * seen;
  const double ofMean = std::sqrt(noise * noise / count + usualModelError * usualModelError);
  const double ofCutOff = tally.cutOff / count; // share of the pixels that all brighter covers look like
  const double chance = (1. - ofCutOff) * std::log(coverRange / (std::sqrt(2. * M_PI) * ofMean)) +
                        ofCutOff * std::log(coverRange / m_cutOffRange);
  const double quality = std::clamp((tally.inner / count - noneInner) / (allInner - noneInner), 0., 1.);
  const double odds = std::max(0., chance) * quality;
  const double shaped = 1. - std::exp(-static_cast<double>(tally.edges) / tellingPixels);
  return {static_cast<float>(told * odds + (seen - told) * std::min(doubtful, odds) + quality * edgeOdds * shaped),
          static_cast<float>(quality * seen * std::max(trust, shaped))};
}

void WordEvidence::weigh()
{
  std::array<std::array<Tally, patterns>, mostSectors> tallies{};
  for (std::size_t i = 0; i < m_explained.size(); ++i) {
    const Explained &placed = m_explained[i];
    if (placed.isOnTrack && placed.byColours != 0) {
      count(i, tallies[placed.sector]);
    }
  }
  for (unsigned int k = 0; k < m_sectors; ++k) {
    for (unsigned int pattern = 0; pattern < patterns; ++pattern) {
      const Told told = toldBy(tallies[k][pattern]);
      m_evidence[k][pattern] = told.odds;
      m_told[k][pattern] = told.share;
    }
  }
}

void WordEvidence::findCoverBeside(CyclicCode::Word word)
{
  const unsigned int parts = partsPerSector * m_sectors;
  const std::vector<Pixel> &pixels = m_pixels.getMemory().pixels;
  const std::uint64_t bits = extended(word, m_sectors);
  findCover();
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const Explained &placed = m_explained[i];
    const unsigned int colours = coloursAt(bits, placed.sector, m_sectors);
    if (!placed.isOnTrack || (placed.byColours >> colours) & 1U) {
      continue;
    }
    const double level = pixels[i].level;
    const std::size_t part = pixels[i].partOf(parts);
    m_cover[0][part] += placed.isCutOff || std::abs(1. - level) < m_slack ? 1 : 0;
    m_cover[1][part] += std::abs(level) < m_slack ? 1 : 0;
  }
  spreadTrust();
  weigh();
}

double WordEvidence::pixelsPerSector() const
{
  const auto count =
      std::count_if(m_explained.begin(), m_explained.end(), [](const Explained &placed) { return placed.isOnTrack; });
  return static_cast<double>(count) / m_sectors;
}

LikeliestWord WordEvidence::likeliest(const CyclicCode &code) const
{
  const unsigned int n = m_sectors;
  LikeliestWord result;
  float best = -std::numeric_limits<float>::infinity();
  double others = 0.; // sum of their likelihoods, in units of that of the best
  code.forEachCodeword([&](CyclicCode::Word word) {
    const std::uint64_t bits = extended(word, n);
    float sum = 0.f;
    for (unsigned int k = 0; k < n; ++k) {
      sum += m_evidence[k][(bits >> (n - 1 - k)) & 31U];
    }
    if (sum > best) {
      others = (others + 1.) * std::exp(static_cast<double>(best) - static_cast<double>(sum));
      best = sum;
      result.word = word;
    }
    else {
      others += std::exp(static_cast<double>(sum) - static_cast<double>(best));
    }
  });
  result.odds = -std::log(std::max(others, 1e-30));
  const std::uint64_t bits = extended(result.word, n);
  for (unsigned int k = 0; k < n; ++k) {
    const unsigned int pattern = (bits >> (n - 1 - k)) & 31U;
    result.confirmed += m_told[k][pattern];
    result.confirmedBlack += (pattern & 4U) != 0 ? m_told[k][pattern] : 0.;
    result.contradicted += m_told[k][pattern ^ 4U];
    result.odds -= static_cast<double>(m_evidence[k][pattern ^ 4U]);
  }
  return result;
}

PrintedSectors WordEvidence::printedSectors() const
{
  // Viterbi's algorithm around the track, once for each four colours that it may begin with: the pattern of a sector
  // goes on with the last four colours of that before it.
  constexpr unsigned int states = patterns / 2;
  using Scores = std::array<float, states>;
  constexpr float none = -std::numeric_limits<float>::infinity();
  float best = none;
  PrintedSectors printed;
  for (unsigned int first = 0; first < states; ++first) {
    std::array<std::array<std::uint8_t, states>, mostSectors> dropped; // the colour before the four
    Scores scores;
    scores.fill(none);
    scores[first] = 0.f;
    for (unsigned int k = 0; k < m_sectors; ++k) {
      Scores next;
      for (unsigned int state = 0; state < states; ++state) { // the four last colours of the sector's pattern
        const unsigned int before = state >> 1;               // of the pattern before it, but for its first
        const float white = scores[before] + m_evidence[k][state];
        const float black = scores[before | (states / 2)] + m_evidence[k][state | states];
        dropped[k][state] = black > white ? 1 : 0;
        next[state] = std::max(white, black);
      }
      scores = next;
    }
    if (scores[first] <= best) {
      continue;
    }
    best = scores[first];
    printed = {};
    unsigned int state = first;
    for (unsigned int k = m_sectors; k-- > 0;) {
      const unsigned int pattern = state | (dropped[k][state] != 0 ? states : 0U);
      const CyclicCode::Word bit = CyclicCode::Word(1) << (m_sectors - 1 - k);
      if (m_told[k][pattern] > leastTold && m_told[k][pattern ^ 4U] <= leastTold) {
        ((pattern & 4U) != 0 ? printed.black : printed.white) |= bit;
      }
      state = pattern >> 1;
    }
  }
  return printed;
}
} // namespace circle_marker
END_VISP_NAMESPACE
