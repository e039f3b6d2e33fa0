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

  // The least that the groups below one add where it and those above it are fixed.
  float leastBelow(Word word, unsigned int group) const
  {
    return m_leastBelow[group][word >> (groupBits * group) & groupMask];
  }

  // The same of around().
  float leastAround(Word word) const { return m_leastAround[word >> (groupBits * last()) & groupMask]; }

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
  // limit: what a word must cost less than.
  WordSearch(const GroupCosts &costs, const CyclicCode &code, float limit) : m_costs(costs), m_limit(limit)
  {
    listLevels(code);
    add(0, 0.f); // the zero word costs nothing but the squares
    descend(0, 0.f, costs.last(), 0);
  }

  std::array<CostedWord, 2> result(double squares) const
  {
    std::array<CostedWord, 2> words;
    for (std::size_t i = 0; i < words.size(); ++i) {
      words[i] = {m_words[i], squares + static_cast<double>(m_wordCosts[i])};
    }
    return words;
  }

private:
  struct Branch
  {
    float bound, cost;
    Word word;
  };

  // Some bits of the message: the words that they alone make, and whether they fix one group or all that are left.
  struct Level
  {
    unsigned int count = 0;
    std::array<Word, groupValues> words;
    bool fixesAll = false;
  };

  // From the highest group, which may have less bits, to that for which not enough bits of the message are left.
  void listLevels(const CyclicCode &code)
  {
    unsigned int bits = code.getLength() - groupBits * m_costs.last();
    unsigned int left = code.getDimension();
    for (Level &level : m_levels) {
      level.fixesAll = left < bits;
      const unsigned int here = std::min(left, bits);
      left -= here;
      level.count = 1U << here;
      for (Word message = 0; message < level.count; ++message) {
        level.words[message] = code.encode(message << left);
      }
      if (level.fixesAll) {
        break;
      }
      bits = groupBits;
    }
  }

  // Fixes a group, in each way that is not hopeless.
  void descend(Word word, float cost, unsigned int group, unsigned int depth)
  {
    const Level &level = m_levels[depth];
    if (level.fixesAll) {
      std::for_each_n(level.words.begin(), level.count, [&](Word more) { finish(word ^ more, cost, group); });
      return;
    }
    std::array<Branch, groupValues> branches;
    unsigned int count = 0;
    for (unsigned int k = 0; k < level.count; ++k) {
      Branch &branch = branches[count];
      branch.word = word ^ level.words[k];
      branch.cost = cost + m_costs.ofGroup(branch.word, group);
      branch.bound = branch.cost + m_costs.leastBelow(branch.word, group) + m_costs.leastAround(branch.word);
      count += branch.bound < m_limit ? 1 : 0;
    }
    std::sort(branches.begin(), branches.begin() + count,
              [](const Branch &p, const Branch &q) { return p.bound < q.bound; });
    for (unsigned int k = 0; k < count && branches[k].bound < m_limit; ++k) {
      descend(branches[k].word, branches[k].cost, group - 1, depth + 1);
    }
  }

  // A whole word, of which this group and those below it are not counted yet.
  void finish(Word word, float cost, unsigned int group)
  {
    cost += m_costs.around(word);
    for (unsigned int k = group + 1; k-- > 0;) {
      cost += m_costs.ofGroup(word, k);
      if (cost + m_costs.leastBelow(word, k) >= m_limit) {
        return;
      }
    }
    if (word != 0) { // which was the first
      add(word, cost);
    }
  }

  void add(Word word, float cost)
  {
    if (!(cost < m_limit)) {
      return;
    }
    const std::size_t place = cost < m_wordCosts[0] ? 0 : 1;
    if (place == 0) {
      m_words[1] = m_words[0];
      m_wordCosts[1] = m_wordCosts[0];
    }
    m_words[place] = word;
    m_wordCosts[place] = cost;
    m_limit = std::min(m_limit, m_wordCosts[1]);
  }

  const GroupCosts &m_costs;
  std::array<Level, mostGroups + 1> m_levels;
  std::array<Word, 2> m_words{};
  std::array<float, 2> m_wordCosts = {HUGE_VALF, HUGE_VALF};
  float m_limit;
};
} // namespace

std::array<CostedWord, 2> bestTwoWords(const Squares &squares, const CyclicCode &code, double limit)
{
  const GroupCosts costs(squares, code.getLength());
  return WordSearch(costs, code, static_cast<float>(limit - squares.squares)).result(squares.squares);
}
} // namespace circle_marker
END_VISP_NAMESPACE
