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
 * Pixels of a code track at a measured pose, and what they say of its sectors and of a codeword.
 */

#include "decode/track_pixels.h"

#include <algorithm>
#include <cmath>

#include "pose/circle_bounds.h"
#include "support/normal_distribution.h"
#include "support/pixel_box.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// What the model leaves of a level, share of the contrast; a pixel's noise comes to it, this many standard deviations.
constexpr double modelError = 0.015;
constexpr double mostOfNoise = 3.5;
// How much more than usual the root mean square of what is left of a sector's pixels may be, divided by the root of
// their number: it is known to 0.7 of that.
constexpr double mostOfSpread = 1.6;
// A pixel that is that near to ink or paper, or beyond it, in standard deviations of noise besides the model's error,
// is like it: most pixels of a cover that has just this grey level are.
constexpr double likeOfNoise = 1.;
// The inner part of the centre, in which directions are not told apart.
constexpr double middleOfCenter = 0.28;
// A pixel shows a sector alone if its share of it is this share of the greatest that any pixel has.
constexpr double leastPurity = 0.85;
// Pixels, and share of those that show a sector alone, by which it is read.
constexpr double fewestPixels = 2.5;
constexpr double leastShareOfPixels = 0.25;
// So many pixels of the other kind, share of those of the one, make it neither.
constexpr double mostOfOther = 0.15;
// Weights of a sector that only pixels tell which may be covered by something like them.
constexpr double doubtfulWeight = 0.3;
// Steps by which the grid of sectors is turned, of a sector: from the first look, and once sectors are known.
constexpr double firstStep = 1. / 12.;
constexpr double secondStep = 1. / 24.;
// So many pixels tell as much as all.
constexpr double enoughPixels = 3000.;
constexpr int largestStep = 1 << 16; // pixels: more than an image has
} // namespace

TrackPixels::TrackPixels(const vpImage<unsigned char> &I, const CameraModel &camera, const MeasuredRing &ring,
                         const vpCircleMarkerFamily &family, TrackMemory &memory)
    : m_layout(family.getLayout()), m_sectors(family.getNbSectors()), m_noise(ring.noiseOfLevel()),
      m_slack(modelError + mostOfNoise * m_noise), m_memory(memory), m_pixels(memory.pixels), m_placed(memory.placed)
{
  collect(I, camera, ring);
  findCover();
}

void TrackPixels::collect(const vpImage<unsigned char> &I, const CameraModel &camera, const MeasuredRing &ring)
{
  m_pixels.clear();
  constexpr int directions = 32;
  const auto [least, most] = boundsOfCircle(ring.plane, camera, 1., directions);
  const double area = M_PI_4 * (most - least).prod();
  const int step = std::max(1, pixelWithin(std::round(std::sqrt(area / enoughPixels)), largestStep));
  const NormalDistribution &normal = NormalDistribution::instance();
  const Eigen::Matrix2d blur = ring.photometry.blur.sigma * ring.photometry.blur.shape();
  const double growth = ring.photometry.blur.spread;
  const int lastColumn = static_cast<int>(I.getWidth()) - 1;
  const int lastRow = static_cast<int>(I.getHeight()) - 1;
  const int right = pixelWithin(most.x() + 1., lastColumn);
  const int bottom = pixelWithin(most.y() + 1., lastRow);
  const int left = std::min(pixelWithin(least.x(), lastColumn), right); // of a circle that is nowhere in the image, too
  const int top = std::min(pixelWithin(least.y(), lastRow), bottom);
  m_memory.columns = static_cast<std::size_t>((right - left) / step + 3);
  m_memory.grid.assign(m_memory.columns * static_cast<std::size_t>((bottom - top) / step + 3), -1);
  for (int v = top; v <= bottom; v += step) {
    for (int u = left; u <= right; u += step) {
      const Eigen::Vector2d place(u, v);
      const Eigen::Vector2d meter = camera.toMeter(place);
      const Eigen::Vector2d q = ring.plane.intersect(meter);
      const double radius = q.norm();
      if (radius < middleOfCenter || radius > 1. || !(ring.whiteAt(place) > 1.)) {
        continue;
      }
      const Eigen::Matrix2d perPixel = camera.meterPerPixel(place);
      Eigen::Matrix2d byPixel;
      byPixel.col(0) = ring.plane.intersect(meter + perPixel.col(0)) - q;
      byPixel.col(1) = ring.plane.intersect(meter + perPixel.col(1)) - q;
      const Eigen::Vector2d out = q / radius;
      const Eigen::Matrix2d blurred = blur * byPixel.transpose();
      const double across = (blurred * out).norm();
      const double along = (blurred * Eigen::Vector2d(-out.y(), out.x())).norm();
      const auto upTo = [&](double edge) { return normal.at((edge - radius) / across).cumulative; };
      Pixel pixel;
      pixel.turn = std::atan2(q.y(), q.x()) / (2. * M_PI);
      pixel.turn += pixel.turn < 0. ? 1. : 0.;
      pixel.ring = upTo(1. + growth) - upTo(m_layout.ringInner - growth);
      pixel.track = upTo(m_layout.codeOuter + growth) - upTo(m_layout.codeInner - growth);
      pixel.spread = along / radius / (2. * M_PI);
      pixel.growth = growth / radius / (2. * M_PI);
      const double grey = I[static_cast<unsigned int>(v)][static_cast<unsigned int>(u)];
      pixel.level = ring.levelAt(place, grey);
      pixel.isCutOff = ring.isCutOff(place, grey);
      pixel.cell = static_cast<std::size_t>((v - top) / step + 1) * m_memory.columns +
                   static_cast<std::size_t>((u - left) / step + 1);
      m_memory.grid[pixel.cell] = static_cast<int>(m_pixels.size());
      m_pixels.push_back(pixel);
    }
  }
}

// Where something is seen that is neither print nor paper, but as dark as ink or as bright as paper.
void TrackPixels::findCover()
{
  const unsigned int parts = partsPerSector * m_sectors;
  const double like = modelError + likeOfNoise * m_noise;
  std::array<int, mostParts> ink{};
  std::array<int, mostParts> paper{};
  int all = 0;
  for (const Pixel &pixel : m_pixels) {
    if (pixel.mayBePrint(m_slack)) {
      continue;
    }
    const std::size_t part = pixel.partOf(parts);
    ink[part] += pixel.level < like ? 1 : 0;
    const bool isLikePaper = pixel.isCutOff || pixel.level > 1. - like;
    paper[part] += isLikePaper ? 1 : 0;
    all += pixel.level < like || isLikePaper ? 1 : 0;
  }
  m_hasLikePrint = all > fewestOfCover;
  for (unsigned int i = 0; i < parts; ++i) {
    int inks = 0;
    int papers = 0;
    for (unsigned int k = 0; k <= 2 * coverReach; ++k) {
      const unsigned int beside = (i + parts + k - coverReach) % parts;
      inks += ink[beside];
      papers += paper[beside];
    }
    m_inkCover[i] = inks >= fewestOfCover;
    m_paperCover[i] = papers >= fewestOfCover;
  }
}

void TrackPixels::turnTo(double phase)
{
  const NormalDistribution &normal = NormalDistribution::instance();
  const unsigned int parts = partsPerSector * m_sectors;
  const double first = phase / (2. * M_PI);
  m_phase = phase;
  m_placed.clear();
  std::array<double, mostSectors> purest{};
  for (const Pixel &pixel : m_pixels) {
    if (pixel.track < 2. * m_slack) {
      continue;
    }
    double place = (pixel.turn - first) * m_sectors;
    place -= m_sectors * std::floor(place / m_sectors);
    Placed placed;
    placed.sector = std::min(static_cast<unsigned int>(place), m_sectors - 1);
    const double inside = place - placed.sector;
    const double width = pixel.spread * m_sectors;
    placed.before = pixel.track * normal.at(-inside / width).cumulative;
    placed.after = pixel.track * normal.at((inside - 1.) / width).cumulative;
    placed.own = pixel.track - placed.before - placed.after; // pure ones hardly feel that black grows at borders
    placed.residual = pixel.level - (1. - pixel.ring);
    placed.isCutOff = pixel.isCutOff;
    const std::size_t part = pixel.partOf(parts);
    placed.isTrusted = {!m_paperCover[part], !m_inkCover[part]};
    purest[placed.sector] = std::max(purest[placed.sector], placed.own);
    m_placed.push_back(placed);
  }
  m_placed.erase(std::remove_if(m_placed.begin(), m_placed.end(),
                                [&](const Placed &placed) { return placed.own < leastPurity * purest[placed.sector]; }),
                 m_placed.end());
}

// Counts the pixels of all sectors, of which some may be known.
TrackPixels::Tallies TrackPixels::count(const Kinds &kinds) const
{
  Tallies tallies;
  for (const Placed &placed : m_placed) {
    Tally &tally = tallies[placed.sector];
    tally.all += 1.;
    double lowest = placed.residual; // if the sector is white
    double highest = lowest;
    const auto add = [&](unsigned int neighbour, double share) {
      const Kind kind = kinds[neighbour % m_sectors];
      highest += kind == Kind::WHITE ? 0. : share;
      lowest += kind == Kind::BLACK ? share : 0.;
    };
    add(placed.sector + m_sectors - 1, placed.before);
    add(placed.sector + 1, placed.after);
    if (placed.own - (highest - lowest) < 2. * m_slack) {
      continue;
    }
    for (const std::size_t black : {0, 1}) {
      const double more = black == 1 ? placed.own : 0.;
      const double residual = std::max({0., lowest + more, placed.isCutOff ? 0. : -(highest + more)});
      if (residual < m_slack) {
        tally.explained[black] += 1.;
        tally.trusted[black] += placed.isTrusted[black] ? 1. : 0.;
        tally.squares[black] += residual * residual;
      }
    }
  }
  return tallies;
}

// Whether the pixels of a sector are those of a kind, white (0) or black (1).
bool TrackPixels::isSo(const Tally &tally, std::size_t kind, bool trusts) const
{
  const double number = (trusts ? tally.trusted : tally.explained)[kind];
  if (number < std::max(fewestPixels, leastShareOfPixels * tally.all) ||
      tally.explained[1 - kind] > mostOfOther * tally.explained[kind]) {
    return false;
  }
  const double usual = std::hypot(m_noise, usualModelError) * (1. + mostOfSpread / std::sqrt(tally.explained[kind]));
  return tally.squares[kind] < usual * usual * tally.explained[kind];
}

// How well the pixels agree with what they should be: the more of them and the nearer the better.
double TrackPixels::fitOf(const Kinds &kinds) const
{
  const Tallies tallies = count(kinds);
  double sum = 0.;
  for (unsigned int k = 0; k < m_sectors; ++k) {
    const Tally &tally = tallies[k];
    const bool isBlack = kinds[k] == Kind::UNKNOWN ? tally.explained[1] > tally.explained[0] : kinds[k] == Kind::BLACK;
    const std::size_t kind = isBlack ? 1 : 0;
    sum += tally.explained[kind] - tally.explained[1 - kind] - tally.squares[kind] / (m_slack * m_slack);
  }
  return sum;
}

// Turns the grid of sectors to the phase about the present one that agrees best with what the sectors are.
void TrackPixels::improvePhase(const Kinds &kinds, double firstStep)
{
  turnTo(leastPhase(m_phase, m_sectors, firstStep, [&](double phase) {
    turnTo(phase);
    return -fitOf(kinds);
  }));
}

// What is known of the sectors if nothing is known of their neighbours at first.
TrackPixels::Kinds TrackPixels::kindsAlone() const
{
  Kinds kinds;
  kinds.fill(Kind::UNKNOWN);
  constexpr int passes = 3; // the neighbours of a sector, then itself, then once more
  for (int pass = 0; pass < passes; ++pass) {
    const Tallies tallies = count(kinds);
    for (unsigned int k = 0; k < m_sectors; ++k) {
      kinds[k] = isSo(tallies[k], 1, true) ? Kind::BLACK : isSo(tallies[k], 0, true) ? Kind::WHITE : Kind::UNKNOWN;
    }
  }
  return kinds;
}

void TrackPixels::improve(SectorReading &reading)
{
  Kinds unknown;
  unknown.fill(Kind::UNKNOWN);
  m_phase = reading.phase;
  improvePhase(unknown, firstStep);
  improvePhase(kindsAlone(), secondStep);
  const Kinds kinds = kindsAlone();
  const Tallies tallies = count(kinds);
  reading.phase = m_phase;
  for (unsigned int k = 0; k < m_sectors; ++k) {
    const bool isBlack = isSo(tallies[k], 1, false);
    if (kinds[k] != Kind::UNKNOWN) {
      reading.soft[k] = kinds[k] == Kind::BLACK ? 1. : -1.;
      reading.seen[k] = 1.;
    }
    else if (isBlack || isSo(tallies[k], 0, false)) {
      reading.soft[k] = isBlack ? 1. : -1.;
      reading.seen[k] = doubtfulWeight;
    }
    else {
      reading.seen[k] *= doubtfulWeight;
    }
  }
}

TrackPixels::Kinds TrackPixels::kindsOf(CyclicCode::Word word) const
{
  Kinds kinds;
  for (unsigned int k = 0; k < m_sectors; ++k) {
    kinds[k] = isSectorBlack(word, k, m_sectors) ? Kind::BLACK : Kind::WHITE;
  }
  return kinds;
}

CodewordVerdict TrackPixels::judge(CyclicCode::Word word) const
{
  const Kinds kinds = kindsOf(word);
  const Tallies tallies = count(kinds);
  CodewordVerdict verdict;
  for (unsigned int k = 0; k < m_sectors; ++k) {
    const std::size_t kind = kinds[k] == Kind::BLACK ? 1 : 0;
    verdict.all += tallies[k].all;
    verdict.explained += tallies[k].explained[kind];
    if (isSo(tallies[k], kind, true)) {
      ++verdict.confirmed;
    }
    else if (isSo(tallies[k], 1 - kind, true)) {
      ++verdict.contradicted;
    }
  }
  return verdict;
}
} // namespace circle_marker
END_VISP_NAMESPACE
