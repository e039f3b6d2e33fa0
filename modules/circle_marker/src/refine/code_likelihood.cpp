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
 * The likelihood of all codewords at a measured pose.
 */

#include "refine/code_likelihood.h"

#include <algorithm>
#include <array>

#include "decode/cyclic_code.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Phases of the sectors that are tried: an eighth of a sector moves no edge by more than a small part of the blur.
constexpr int phases = 8;
// Spins of one marker in neighbouring phases differ by less than a sector, after which it is another codeword.
constexpr double sameSpin = 0.95;

constexpr double fullTurn = 2. * M_PI;

/*!
  The quadratic form for whole words, by look-ups: what four sectors have to do with the next four, and, where pixels
  see both sides of a marker, with all others.
*/
class WordCosts
{
public:
  WordCosts(const Squares &squares, unsigned int sectors) : m_groups((sectors + 3) / 4)
  {
    for (unsigned int group = 0; group < m_groups; ++group) {
      m_near[group] = tableOf(squares, sectors, group, (group + 1) % m_groups, true);
      for (unsigned int other = group + 2; other < m_groups && other < group + m_groups - 1; ++other) {
        const Table table = tableOf(squares, sectors, group, other, false);
        if (table.back() > 0.f) { // of all eight black: there is no more
          m_far[m_farCount++] = {4 * group, 4 * other, table};
        }
      }
    }
  }

  // A cost that is greater than most is any that is greater: what sectors far apart have to do with each other adds to
  // it, since a pixel sees no less than nothing of any.
  float of(CyclicCode::Word word, float most) const
  {
    const CyclicCode::Word first = word & 15U;
    float cost = 0.f;
    for (unsigned int group = 0; group + 1 < m_groups; ++group) {
      cost += m_near[group][(word >> (4 * group)) & 255U];
    }
    cost += m_near[m_groups - 1][(word >> (4 * (m_groups - 1))) | (first << 4)];
    for (unsigned int k = 0; k < m_farCount && cost <= most; ++k) {
      cost += m_far[k].costs[((word >> m_far[k].shift) & 15U) | (((word >> m_far[k].otherShift) & 15U) << 4)];
    }
    return cost;
  }

private:
  static constexpr unsigned int mostGroups = (mostSectors + 3) / 4;
  using Table = std::array<float, 256>;

  struct Far
  {
    unsigned int shift, otherShift;
    Table costs;
  };

  // Of one group's bits with another's; hasOwn: and of the former alone.
  static Table tableOf(const Squares &squares, unsigned int sectors, unsigned int group, unsigned int other,
                       bool hasOwn)
  {
    Table costs;
    for (unsigned int value = 0; value < costs.size(); ++value) {
      double cost = 0.;
      for (unsigned int i = 0; i < 4; ++i) {
        if (((value >> i) & 1U) == 0 || 4 * group + i >= sectors) {
          continue;
        }
        const unsigned int a = sectors - 1 - 4 * group - i; // sector 0 is the most significant bit
        if (hasOwn) {
          cost += squares.matrix(a, a) - 2. * squares.right[a];
        }
        for (unsigned int j = hasOwn ? i + 1 : 4; j < 8; ++j) {
          const unsigned int bit = j < 4 ? 4 * group + j : 4 * other + j - 4;
          if (((value >> j) & 1U) != 0 && bit < sectors) {
            cost += 2. * squares.matrix(a, sectors - 1 - bit);
          }
        }
      }
      costs[value] = static_cast<float>(cost);
    }
    return costs;
  }

  unsigned int m_groups;
  unsigned int m_farCount = 0;
  std::array<Table, mostGroups> m_near;
  std::array<Far, mostGroups *(mostGroups - 3) / 2> m_far;
};

/*! A codeword at a phase. */
struct Contender
{
  CyclicCode::Word word = 0;
  double cost = HUGE_VAL;
  PlacedCode code;
};

// The two best codewords at a phase. A white track, the zero word, costs nothing but the squares; it may be the best.
std::array<Contender, 2> bestTwo(const Squares &squares, const CyclicCode &code, double start)
{
  const WordCosts costs(squares, code.getLength());
  CyclicCode::Word best = 0, second = 0;
  float bestCost = 0.f, secondCost = HUGE_VALF;
  code.forEachCodeword([&](CyclicCode::Word word) {
    const float cost = costs.of(word, secondCost);
    if (cost < bestCost) {
      second = best;
      secondCost = bestCost;
      best = word;
      bestCost = cost;
    }
    else if (cost < secondCost) {
      second = word;
      secondCost = cost;
    }
  });
  std::array<Contender, 2> two;
  two[0].word = best;
  two[0].cost = squares.squares + static_cast<double>(bestCost);
  two[1].word = second;
  two[1].cost = squares.squares + static_cast<double>(secondCost);
  for (Contender &contender : two) {
    if (const auto identity = code.identify(contender.word)) { // else constant: no marker's
      contender.code.id = identity->id;
      contender.code.spin = std::remainder(start + fullTurn * identity->rotation / code.getLength(), fullTurn);
    }
  }
  return two;
}
} // namespace

std::optional<LikelyCode> mostLikelyCode(const vpImage<unsigned char> &I, const CameraModel &camera,
                                         const FittedPose &fit, const ImageFrame &frame,
                                         const vpCircleMarkerFamily &family, CodeImage &track, const Deadline &deadline)
{
  const vpCircleMarkerLayout &layout = family.getLayout();
  const CyclicCode &code = codeOf(family);
  const auto sectors = static_cast<int>(code.getLength());
  if (!lookAtCode(I, camera, fit, frame, layout, sectors, track)) {
    return std::nullopt;
  }
  const double pitch = fullTurn / sectors;
  std::array<Contender, 2 * phases> contenders;
  for (int phase = 0; phase < phases; ++phase) {
    if (deadline.hasPassed()) { // a phase of bch31 takes about a millisecond
      return std::nullopt;
    }
    const double start = pitch * phase / phases;
    const auto two = bestTwo(squaresOf(track, layout, sectors, start), code, start);
    std::copy(two.begin(), two.end(), contenders.begin() + 2 * phase);
  }
  const Contender &best = *std::min_element(contenders.begin(), contenders.end(),
                                            [](const auto &p, const auto &q) { return p.cost < q.cost; });
  if (best.code.id < 0) {
    return LikelyCode();
  }
  Contender next;
  for (const Contender &contender : contenders) {
    const double apart = std::abs(std::remainder(contender.code.spin - best.code.spin, fullTurn));
    const bool isSame = contender.code.id == best.code.id && apart < sameSpin * pitch;
    if (!isSame && contender.cost < next.cost) {
      next = contender;
    }
  }
  const double variance = track.noise * track.noise;
  return LikelyCode{best.code, next.code, (next.cost - best.cost) / (2. * variance),
                    std::sqrt(std::max(best.cost, 0.) / (variance * static_cast<double>(track.pixels.size())))};
}
} // namespace circle_marker
END_VISP_NAMESPACE
