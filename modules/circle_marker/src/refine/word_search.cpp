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
 * The codewords of a cyclic code that leave the least of a code track.
 */

#include "refine/word_search.h"

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
using Word = CyclicCode::Word;

constexpr unsigned int groupBits = 4;
constexpr unsigned int groupValues = 1U << groupBits;
constexpr Word groupMask = groupValues - 1;
constexpr unsigned int mostGroups = (mostSectors + groupBits - 1) / groupBits;

// Costs of the bits of two groups, the first group's in the lower half of the index.
using PairTable = std::array<float, groupValues * groupValues>;
using GroupTable = std::array<float, groupValues>;

// A product of the quadratic form; bits count from the last sector.
double product(const Squares &squares, unsigned int sectors, unsigned int bit, unsigned int other)
{
  return bit < sectors && other < sectors ? 2. * squares.matrix(sectors - 1 - bit, sectors - 1 - other) : 0.;
}

double alone(const Squares &squares, unsigned int sectors, unsigned int bit)
{
  const unsigned int sector = sectors - 1 - bit;
  return bit < sectors ? squares.matrix(sector, sector) - 2. * squares.right[sector] : 0.;
}

// What one group's bits have to do with another's; hasOwn: and with each other.
PairTable tableOf(const Squares &squares, unsigned int sectors, unsigned int group, unsigned int other, bool hasOwn)
{
  constexpr unsigned int bits = 2 * groupBits;
  std::array<double, groupValues * groupValues> costs{};
  std::array<double, groupValues * groupValues> added; // by one bit more, for all values of those above it
  for (unsigned int i = groupBits; i-- > 0;) {
    const unsigned int bit = groupBits * group + i;
    const unsigned int step = 2U << i;
    added[0] = hasOwn ? alone(squares, sectors, bit) : 0.;
    for (unsigned int j = i + 1; j < bits; ++j) {
      const unsigned int above = j < groupBits ? groupBits * group + j : groupBits * other + j - groupBits;
      const double more = hasOwn || j >= groupBits ? product(squares, sectors, bit, above) : 0.;
      for (unsigned int value = 0; value < 1U << j; value += step) {
        added[value | 1U << j] = added[value] + more;
      }
    }
    for (unsigned int value = 0; value < costs.size(); value += step) {
      costs[value | 1U << i] = costs[value] + added[value];
    }
  }
  PairTable table;
  std::transform(costs.begin(), costs.end(), table.begin(), [](double cost) { return static_cast<float>(cost); });
  return table;
}

// The quadratic form of a word by its groups of four bits, from the last sectors: each with itself and the next, around
// the circle, and with those farther away where pixels see both.
class GroupCosts
{
public:
  GroupCosts(const Squares &squares, unsigned int sectors) : m_groups((sectors + groupBits - 1) / groupBits)
  {
    for (unsigned int group = 0; group < m_groups; ++group) {
      m_near[group] = tableOf(squares, sectors, group, (group + 1) % m_groups, true);
      m_farBegin[group] = m_farBegin[m_groups]; // which counts them
      for (unsigned int other = group + 2; other < m_groups && other < group + m_groups - 1; ++other) {
        const PairTable table = tableOf(squares, sectors, group, other, false);
        if (table.back() > 0.f) { // of all eight black: there is no more
          m_far[m_farBegin[m_groups]++] = {groupBits * other, table};
        }
      }
    }
    boundRest();
  }

  unsigned int last() const { return m_groups - 1; }

  // What a group costs where it and those above it are fixed: the last group's own comes with those around the circle.
  float ofGroup(Word word, unsigned int group) const
  {
    const Word here = word >> (groupBits * group);
    float cost = group < last() ? m_near[group][here & (groupMask | groupMask << groupBits)] : 0.f;
    for (unsigned int k = m_farBegin[group]; k < m_farBegin[group + 1]; ++k) {
      const Far &far = m_far[k];
      cost += far.costs[(here & groupMask) | (word >> far.shift & groupMask) << groupBits];
    }
    return cost;
  }

  // What the last group costs with the first: of a whole word.
  float around(Word word) const
  {
    return m_near[last()][word >> (groupBits * last()) | (word & groupMask) << groupBits];
  }

  // The least that is still to be added where a group and those above it are fixed.
  float leastRest(Word word, unsigned int group) const
  {
    return m_leastBelow[group][word >> (groupBits * group) & groupMask] +
           m_leastAround[word >> (groupBits * last()) & groupMask];
  }

private:
  struct Far
  {
    unsigned int shift;
    PairTable costs;
  };

  void boundRest()
  {
    m_leastBelow[0].fill(0.f);
    for (unsigned int group = 1; group < m_groups; ++group) {
      for (unsigned int value = 0; value < groupValues; ++value) {
        float &least = m_leastBelow[group][value];
        least = HUGE_VALF;
        for (unsigned int below = 0; below < groupValues; ++below) {
          const float cost = m_near[group - 1][below | value << groupBits] + m_leastBelow[group - 1][below];
          least = std::min(least, cost);
        }
      }
    }
    for (unsigned int value = 0; value < groupValues; ++value) {
      m_leastAround[value] = HUGE_VALF;
      for (unsigned int first = 0; first < groupValues; ++first) {
        m_leastAround[value] = std::min(m_leastAround[value], m_near[last()][value | first << groupBits]);
      }
    }
  }

  unsigned int m_groups;
  std::array<PairTable, mostGroups> m_near;
  std::array<Far, mostGroups *(mostGroups - 3) / 2> m_far; // of groups with some above them
  std::array<unsigned int, mostGroups + 1> m_farBegin{};   // of each group
  std::array<GroupTable, mostGroups> m_leastBelow;         // of all groups below one, by its value
  GroupTable m_leastAround;                                // of the last group with the first, by the last one's value
};

class WordSearch
{
public:
  WordSearch(const GroupCosts &costs, const CyclicCode &code) : m_costs(costs), m_code(code)
  {
    const unsigned int bitsOfLast = code.getLength() - groupBits * costs.last();
    descend(0, 0.f, costs.last(), bitsOfLast, code.getDimension());
  }

  Word best() const { return m_best; }
  Word second() const { return m_second; }
  double bestCost() const { return static_cast<double>(m_bestCost); }
  double secondCost() const { return static_cast<double>(m_secondCost); }

private:
  struct Branch
  {
    float bound, cost;
    Word word;
  };

  // Fixes a group by as many bits of the message, its highest that are left.
  void descend(Word word, float cost, unsigned int group, unsigned int bits, unsigned int messageLeft)
  {
    if (messageLeft < bits) { // they fix all the rest
      for (Word message = 0; message < Word(1) << messageLeft; ++message) {
        finish(word ^ m_code.encode(message), cost, group);
      }
      return;
    }
    messageLeft -= bits;
    std::array<Branch, groupValues> branches;
    const unsigned int count = 1U << bits;
    for (Word message = 0; message < count; ++message) {
      Branch &branch = branches[message];
      branch.word = word ^ m_code.encode(message << messageLeft);
      branch.cost = cost + m_costs.ofGroup(branch.word, group);
      branch.bound = branch.cost + m_costs.leastRest(branch.word, group);
    }
    std::sort(branches.begin(), branches.begin() + count,
              [](const Branch &p, const Branch &q) { return p.bound < q.bound; });
    for (unsigned int k = 0; k < count && branches[k].bound < m_secondCost; ++k) {
      descend(branches[k].word, branches[k].cost, group - 1, groupBits, messageLeft);
    }
  }

  // A whole word, of which this group and those below it are not counted yet.
  void finish(Word word, float cost, unsigned int group)
  {
    cost += m_costs.around(word);
    for (unsigned int k = group + 1; k-- > 0;) {
      cost += m_costs.ofGroup(word, k);
    }
    if (word == 0) {
      return; // it was the first
    }
    if (cost < m_bestCost) {
      m_second = m_best;
      m_secondCost = m_bestCost;
      m_best = word;
      m_bestCost = cost;
    }
    else if (cost < m_secondCost) {
      m_second = word;
      m_secondCost = cost;
    }
  }

  const GroupCosts &m_costs;
  const CyclicCode &m_code;
  Word m_best = 0; // the zero word costs nothing but the squares
  Word m_second = 0;
  float m_bestCost = 0.f;
  float m_secondCost = HUGE_VALF;
};
} // namespace

std::array<CostedWord, 2> bestTwoWords(const Squares &squares, const CyclicCode &code)
{
  const GroupCosts costs(squares, code.getLength());
  const WordSearch search(costs, code);
  return {
      {{search.best(), squares.squares + search.bestCost()}, {search.second(), squares.squares + search.secondCost()}}};
}
} // namespace circle_marker
END_VISP_NAMESPACE
