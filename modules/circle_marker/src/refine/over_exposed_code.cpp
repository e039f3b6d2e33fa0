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
 * A code that paper hides which is brighter than the sensor can tell.
 */

#include "refine/over_exposed_code.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "decode/cyclic_code.h"
#include "support/sensor_range.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
using Word = CyclicCode::Word;

// Other words whose cost is computed in full: the likeliest as far as single sectors tell, which neighbours that both
// differ do not quite. (Of 221 comparisons in testOverExposedCode another word than these was the likeliest in 43, by
// less than 1 where the odds, ln, were below 100: what is doubtful stays so. Private counts.)
constexpr std::size_t mostOthers = 32;

// A black sector that is longer than this, in standard deviations of the blur, shows its ink in the middle. Directions
// in which that is asked.
constexpr double longSector = 4.;
constexpr int directions = 16;

// Whether anywhere on the track sectors are short and paper is brighter than the sensor can tell.
bool mayHideSectors(const MeasuredView &view, const vpCircleMarkerFamily &family)
{
  const CameraModel &camera = view.camera;
  const FittedPose &fit = view.fit;
  const vpCircleMarkerLayout &layout = family.getLayout();
  const double radius = 0.5 * (layout.codeInner + layout.codeOuter);
  const double longest = 2. * M_PI * radius / family.getNbSectors() / longSector;
  const Eigen::Matrix2d blur = fit.photometry.blur.sigma * fit.photometry.blur.shape();
  for (int i = 0; i < directions; ++i) {
    const double angle = 2. * M_PI * i / directions;
    const Eigen::Vector2d along(-std::sin(angle), std::cos(angle));
    const Eigen::Vector2d place(radius * std::cos(angle), radius * std::sin(angle));
    const Eigen::Vector2d pixel = camera.toPixel(fit.plane.project(place));
    const PlanePoint point = planePoint({camera.toMeter(pixel), camera.meterPerPixel(pixel)}, fit.plane);
    const double blurAlong = (along.transpose() * point.byPixel * blur).norm();
    if (blurAlong > longest && view.whiteAt(pixel) > view.inEvenLight(pixel, brightestTold)) {
      return true;
    }
  }
  return false;
}

// A word and what it leaves: squares of black.
struct OtherWord
{
  Word word;
  double cost;
};

// The likeliest others so far.
class LikeliestOthers
{
public:
  void add(Word word, double cost)
  {
    if (m_count == mostOthers && cost >= m_all.back().cost) {
      return;
    }
    m_count = std::min(m_count + 1, mostOthers);
    std::size_t at = m_count - 1;
    for (; at > 0 && m_all[at - 1].cost > cost; --at) {
      m_all[at] = m_all[at - 1];
    }
    m_all[at] = {word, cost};
  }

  OtherWord *begin() { return m_all.data(); }
  OtherWord *end() { return m_all.data() + m_count; }

private:
  std::array<OtherWord, mostOthers> m_all;
  std::size_t m_count = 0;
};

// The colours of words on a track whose first sector begins at the plane's x axis.
class ClippedTrack
{
public:
  ClippedTrack(const CodeImage &track, const vpCircleMarkerLayout &layout, unsigned int sectors)
      : m_track(track), m_layout(layout), m_sectors(sectors), m_borders(static_cast<int>(sectors), 0.)
  {
  }

  // Calls visit(pixel, sectors that it sees) for every pixel.
  template <class Visitor> void forEachPixel(const Visitor &visit) const
  {
    for (const CodePixel &pixel : m_track.pixels) {
      visit(pixel, sectorsSeenBy(pixel, m_track, m_layout, m_borders));
    }
  }

  Word bitOf(int sector) const { return Word(1) << (m_sectors - 1 - static_cast<unsigned int>(sector)); }

  // Black that a word gives a pixel.
  double blackBy(Word word, const SeenSectors &seen) const
  {
    double black = 0.;
    for (int i = 0; i < seen.count; ++i) {
      const auto k = static_cast<std::size_t>(i);
      black += (word & bitOf(seen.numbers[k])) != 0 ? seen.weights[k] : 0.;
    }
    return black;
  }

private:
  const CodeImage &m_track;
  const vpCircleMarkerLayout &m_layout;
  const unsigned int m_sectors;
  const SectorBorders m_borders;
};

// What a black leaves of a pixel, squared, as far as the sensor can tell.
double squareLeft(const CodePixel &pixel, double black)
{
  const double left = std::max(black, pixel.leastTold) - std::max(pixel.black, pixel.leastTold);
  return left * left;
}

// How much more a word leaves with each one of its sectors of the other colour.
SectorVector costsOfChanges(const ClippedTrack &track, Word word)
{
  SectorVector costs = SectorVector::Zero();
  track.forEachPixel([&](const CodePixel &pixel, const SeenSectors &seen) {
    const double black = track.blackBy(word, seen);
    const double left = squareLeft(pixel, black);
    for (int i = 0; i < seen.count; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const bool isBlack = (word & track.bitOf(seen.numbers[k])) != 0;
      const double changed = isBlack ? black - seen.weights[k] : black + seen.weights[k];
      costs[seen.numbers[k]] += squareLeft(pixel, changed) - left;
    }
  });
  return costs;
}

// The likeliest other words by those.
LikeliestOthers likeliestOthers(Word word, const CyclicCode &code, const ClippedTrack &track, const SectorVector &costs)
{
  LikeliestOthers others;
  const auto add = [&](Word other) {
    if (other == word) {
      return;
    }
    double cost = 0.;
    for (unsigned int k = 0; k < code.getLength(); ++k) {
      const auto sector = static_cast<int>(k);
      cost += ((word ^ other) & track.bitOf(sector)) != 0 ? costs[sector] : 0.;
    }
    others.add(other, cost);
  };
  add(0);
  code.forEachCodeword(add);
  return others;
}
} // namespace

std::optional<double> oddsIfOverExposed(const MeasuredView &view, const vpCircleMarkerFamily &family, Word word,
                                        CodeImage &track)
{
  const CyclicCode &code = codeOf(family);
  const unsigned int sectors = code.getLength();
  const vpCircleMarkerLayout &layout = family.getLayout();
  if (!mayHideSectors(view, family) || !lookAtCode(view, layout, static_cast<int>(sectors), track) ||
      !track.isOverExposed) {
    return std::nullopt;
  }
  const ClippedTrack clipped(track, layout, sectors);
  LikeliestOthers others = likeliestOthers(word, code, clipped, costsOfChanges(clipped, word));
  for (OtherWord &other : others) {
    other.cost = 0.;
  }
  double cost = 0.;
  clipped.forEachPixel([&](const CodePixel &pixel, const SeenSectors &seen) {
    cost += squareLeft(pixel, clipped.blackBy(word, seen));
    for (OtherWord &other : others) {
      other.cost += squareLeft(pixel, clipped.blackBy(other.word, seen));
    }
  });
  const auto next = std::min_element(others.begin(), others.end(),
                                     [](const OtherWord &p, const OtherWord &q) { return p.cost < q.cost; });
  return (next->cost - cost) / (2. * track.noise * track.noise * view.fit.sharing);
}
} // namespace circle_marker
END_VISP_NAMESPACE
