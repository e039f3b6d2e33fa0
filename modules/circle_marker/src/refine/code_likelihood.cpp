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

#include "refine/word_search.h"
#include "support/few.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Phases of the sectors that are tried: an eighth of a sector moves no edge by more than a small part of the blur. Not
// those of the first reading (phasesPerSector), which are as many.
constexpr int phases = 8;
// Spins of one marker in neighbouring phases differ by less than a sector, after which it is another codeword.
constexpr double sameSpin = 0.95;

constexpr double fullTurn = 2. * M_PI;

/*! A codeword at a phase. */
struct Contender
{
  PlacedCode code;
  double cost = HUGE_VAL;
};

// The two best codewords at a phase that leave less than the limit. One of them may be a white track.
std::array<Contender, 2> bestTwo(const Squares &squares, const CyclicCode &code, double start, double limit)
{
  const auto words = bestTwoWords(squares, code, limit);
  std::array<Contender, 2> two;
  for (std::size_t i = 0; i < two.size(); ++i) {
    two[i].cost = words[i].squares;
    if (const auto identity = code.identify(words[i].word)) { // else constant: no marker's
      two[i].code.id = identity->id;
      two[i].code.spin = std::remainder(start + fullTurn * identity->rotation / code.getLength(), fullTurn);
    }
  }
  return two;
}

// The codewords of all phases, as far as they come into question as the best or the next.
class Contenders
{
public:
  void add(const std::array<Contender, 2> &two)
  {
    m_all.push_back(two[0]);
    m_all.push_back(two[1]);
    m_best = std::min_element(m_all.begin(), m_all.end(), isBetter);
  }

  const Contender &best() const { return *m_best; }

  // What leaves as much as the best with another number is neither the best nor the next.
  double limit() const
  {
    return nextIf([this](const Contender &other) { return other.code.id != m_best->code.id; }).cost;
  }

  // The best but one; the same codeword turned by less than a sector is the same.
  Contender next(double pitch) const
  {
    return nextIf([&](const Contender &other) {
      const double apart = std::abs(std::remainder(other.code.spin - m_best->code.spin, fullTurn));
      return other.code.id != m_best->code.id || apart >= sameSpin * pitch;
    });
  }

private:
  static bool isBetter(const Contender &p, const Contender &q) { return p.cost < q.cost; }

  template <class Condition> Contender nextIf(const Condition &isOther) const
  {
    Contender next;
    for (const Contender &contender : m_all) {
      if (isOther(contender) && isBetter(contender, next)) {
        next = contender;
      }
    }
    return next;
  }

  Few<Contender, 2 * phases> m_all;
  const Contender *m_best = nullptr;
};
} // namespace

std::optional<LikelyCode> mostLikelyCode(const MeasuredView &view, const vpCircleMarkerFamily &family, CodeImage &track,
                                         const Deadline &deadline)
{
  const vpCircleMarkerLayout &layout = family.getLayout();
  const CyclicCode &code = codeOf(family);
  const auto sectors = static_cast<int>(code.getLength());
  if (!lookAtCode(view, layout, sectors, track) || track.isOverExposed) {
    return std::nullopt;
  }
  const double pitch = fullTurn / sectors;
  Contenders contenders;
  for (int phase = 0; phase < phases; ++phase) {
    if (deadline.hasPassed()) { // a phase of bch31 may take half a millisecond
      return std::nullopt;
    }
    const double start = pitch * phase / phases;
    const double limit = phase > 0 ? contenders.limit() : HUGE_VAL;
    contenders.add(bestTwo(squaresOf(track, layout, sectors, start), code, start, limit));
  }
  const Contender &best = contenders.best();
  if (best.code.id < 0) {
    return LikelyCode();
  }
  const Contender next = contenders.next(pitch);
  const double variance = track.noise * track.noise;
  return LikelyCode{best.code, next.code, (next.cost - best.cost) / (2. * variance * view.fit.sharing),
                    std::sqrt(std::max(best.cost, 0.) / (variance * static_cast<double>(track.pixels.size())))};
}
} // namespace circle_marker
END_VISP_NAMESPACE
