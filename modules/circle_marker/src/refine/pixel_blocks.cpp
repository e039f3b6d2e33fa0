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
 * Pixels in blocks of lanes, sorted by what they see.
 */

#include "refine/pixel_blocks.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "refine/lens_second_order.h"
#include "refine/sector_table.h"
#include "refine/surround_lanes.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
namespace {
// An edge is seen up to this many standard deviations of the blur: beyond lie 5e-5 of the contrast, a tenth of what
// rounding to grey levels leaves.
constexpr double reachOfEdges = 3.9;
// Borders that a pixel of the track may see, but no more than mostSeen: those whose distance at the inner rim, along
// the image's shorter axis, is within its sight.
int bordersSeen(const MarkerPlane &plane, const MarkerPattern &pattern, const BlurParameters &blur, double unit,
                double poseError, int mostSeen)
{
  if (pattern.sectors == 0) {
    return 0;
  }
  const double distance = blur.widest() / blur.sigma * sightThrough(blur, poseError); // in the image, at most
  const double sector = 2. * M_PI / pattern.sectors * pattern.track[1].radius * plane.semiMinor(unit); // pixels
  // With k to either side of the nearest, the next one is at least k + 1/2 sectors away.
  return std::min(distance < 0.5 * sector ? 1 : distance < 1.5 * sector ? 3 : 5, mostSeen);
}

// The pixels of a block by their numbers: one that is not full has its last pixel again in the other lanes.
std::array<const FitPixel *, laneCount> pixelsOf(const std::vector<FitPixel> &pixels, const unsigned int *numbers,
                                                 std::size_t count)
{
  std::array<const FitPixel *, laneCount> chosen;
  for (std::size_t k = 0; k < laneCount; ++k) {
    chosen[k] = &pixels[numbers[std::min(k, count - 1)]];
  }
  return chosen;
}

// Variance of a block's lanes of which the first ones, so many, hold a pixel.
Lanes holdingOnly(std::size_t count)
{
  return lanesOf([&](int lane) { return static_cast<std::size_t>(lane) < count ? 0.f : noPixel; });
}

// What pixels may see that see from one radius to another, as the numbers of PixelSight.
Lanes sightOf(const Lanes &least, const Lanes &most, const MarkerPattern &pattern)
{
  if (pattern.sectors == 0) {
    return Lanes::Zero();
  }
  const auto outerRim = static_cast<float>(pattern.track[0].radius);
  const auto innerRim = static_cast<float>(pattern.track[1].radius);
  const auto ring = static_cast<float>(pattern.ring[1].radius);
  const Lanes seesTrack = isPositive(outerRim - least) * isPositive(most - innerRim);
  return seesTrack * (2.f - isPositive(ring - most));
}

// The largest radius that pixels see: on the long axis of an oblique marker the circles are nearest across it, where
// the radius does not change at first.
Lanes farthestOf(const PlaneLanes &point, float seen)
{
  const Lanes alongU = point.qyByU * point.outX - point.qxByU * point.outY;
  const Lanes alongV = point.qyByV * point.outX - point.qxByV * point.outY;
  const Lanes out = point.radius + seen * point.gradient;
  return (out * out + seen * seen * (alongU * alongU + alongV * alongV)).sqrt();
}

// Within a kind and a direction, pixels come by the edges that they may see, so that a block sees as few as can be: the
// ring's outer or inner circle; the track's outer rim, that and a border, a border, that and the inner rim, the inner
// rim; or any.
constexpr std::array<int, pixelSights> groups = {{2, 5, 1}};
constexpr std::array<int, pixelSights + 1> firstBin = {{0, 2 * directions, 7 * directions, 8 * directions}};

// The bins of pixels by their kind, direction and group, all whole numbers. In every other direction the groups come
// the other way round, so that few blocks have pixels of more than one.
Lanes binOf(const Lanes &kind, const Lanes &direction, const Lanes &group)
{
  const Lanes isTrack = 1.f - (kind - 1.f).abs();
  const Lanes isBoth = (kind - 1.f).max(0.f);
  const Lanes last =
      (1.f - kind).max(0.f) * static_cast<float>(groups[0] - 1) + isTrack * static_cast<float>(groups[1] - 1);
  const Lanes isOdd = direction - 2.f * (0.5f * direction).floor();
  return isTrack * static_cast<float>(firstBin[1]) + isBoth * static_cast<float>(firstBin[2]) +
         direction * (last + 1.f) + group + isOdd * (last - 2.f * group);
}

unsigned char directionOf(int kind, int bin)
{
  return static_cast<unsigned char>((bin - firstBin[static_cast<std::size_t>(kind)]) /
                                    groups[static_cast<std::size_t>(kind)]);
}

// Sorts pixels and writes them into blocks.
class Packer
{
public:
  Packer(const std::vector<FitPixel> &pixels, const MarkerPlane &plane, const MarkerPattern &pattern,
         const Photometry &photometry, double noise, PixelBlocks &blocks)
      : m_pixels(pixels), m_isUniform(isUniform(pixels)), m_pattern(pattern), m_photometry(photometry),
        m_papers(placedAt(pattern.paper, photometry.paper)), m_noise(noise), m_blocks(blocks),
        m_homography(plane, blocks.reference, photometry.blur.shape()), m_table(pattern, blocks.borders)
  {
  }

  // Looks where all pixels are on the marker and sorts them: by kind, then by direction. seen: how far they see,
  // pixels.
  void sort(double seen)
  {
    constexpr float perTurn = static_cast<float>(directions) / 6.2831853f;
    constexpr auto lastBin = static_cast<float>(firstBin[pixelSights] - 1);
    m_blocks.bins.resize((m_pixels.size() + laneCount - 1) / laneCount * laneCount);
    std::array<const FitPixel *, laneCount> pixels;
    PlaceLanes place;
    PlaneLanes point;
    for (std::size_t first = 0; first < m_pixels.size(); first += laneCount) {
      const std::size_t last = m_pixels.size() - 1 - first;
      for (std::size_t k = 0; k < laneCount; ++k) {
        pixels[k] = &m_pixels[first + std::min(k, last)];
      }
      placeOf(pixels, place);
      m_homography.apply(place, point);
      const Lanes angle = roughAngle(point.qx, point.qy);
      const Lanes direction = (perTurn * (angle + 3.1415927f)).max(0.f).min(directions - 0.5f).floor();
      const Lanes margin = static_cast<float>(seen) * point.gradient;
      const Lanes most = farthestOf(point, static_cast<float>(seen));
      const Lanes sight = sightOf(point.radius - margin, most, m_pattern);
      const Lanes group = groupOf(sight, point.radius, margin, angle);
      // A pixel that does not see the plane has any place, but in the table.
      const Lanes bins = binOf(sight, direction, group).max(0.f).min(lastBin);
      writeBytes(bins, &m_blocks.bins[first]);
    }
    sortByBins();
  }

  // Fills the blocks.
  void fill()
  {
    m_blocks.surrounds.clear();
    m_blocks.sectors.clear();
    std::size_t first = 0;
    for (std::size_t kind = 0; kind < pixelSights; ++kind) {
      const std::size_t end = first + m_blocks.count[kind];
      std::vector<PixelBlock> &blocks = m_blocks.bySight[kind];
      blocks.resize((m_blocks.count[kind] + laneCount - 1) / laneCount);
      m_blocks.direction[kind].clear();
      for (PixelBlock &block : blocks) {
        m_blocks.direction[kind].push_back(
            directionOf(static_cast<int>(kind), m_blocks.bins[m_blocks.sortedPixels[first]]));
        const std::size_t count = std::min<std::size_t>(laneCount, end - first);
        fillBlock(&m_blocks.sortedPixels[first], count, static_cast<PixelSight>(kind), block);
        first += count;
      }
    }
  }

private:
  // Puts the pixels in the order of their bins, those of one bin as they come. Neighbours mostly have one bin, and each
  // waits for the one before to be counted: so both halves of the pixels go side by side.
  void sortByBins()
  {
    constexpr auto bins = static_cast<std::size_t>(firstBin[pixelSights]);
    const std::size_t half = m_pixels.size() / 2;
    std::array<std::array<unsigned int, bins>, 2> next = {}; // of either half: how many, then where the next one goes
    const unsigned char *const ofFirst = m_blocks.bins.data();
    const unsigned char *const ofSecond = ofFirst + half;
    for (std::size_t k = 0; k < half; ++k) {
      ++next[0][ofFirst[k]];
      ++next[1][ofSecond[k]];
    }
    const bool isOdd = m_pixels.size() % 2 != 0;
    if (isOdd) {
      ++next[1][ofSecond[half]];
    }
    unsigned int start = 0;
    std::size_t bin = 0;
    for (std::size_t kind = 0; kind < pixelSights; ++kind) {
      const unsigned int before = start;
      for (; bin < static_cast<std::size_t>(firstBin[kind + 1]); ++bin) {
        const std::array<unsigned int, 2> counts = {next[0][bin], next[1][bin]};
        next[0][bin] = start;
        next[1][bin] = start + counts[0];
        start += counts[0] + counts[1];
      }
      m_blocks.count[kind] = start - before;
    }
    m_blocks.sortedPixels.resize(m_pixels.size());
    unsigned int *const sorted = m_blocks.sortedPixels.data();
    const auto second = static_cast<unsigned int>(half);
    for (unsigned int k = 0; k < second; ++k) {
      sorted[next[0][ofFirst[k]]++] = k;
      sorted[next[1][ofSecond[k]]++] = second + k;
    }
    if (isOdd) {
      sorted[next[1][ofSecond[half]]++] = 2 * second;
    }
  }

  // Which edges pixels may see, as binOf() counts them.
  Lanes groupOf(const Lanes &sight, const Lanes &radius, const Lanes &margin, const Lanes &angle) const
  {
    const auto middle = static_cast<float>(0.5 * (m_pattern.ring[0].radius + m_pattern.ring[1].radius));
    const Lanes isInner = isPositive(middle - radius);
    if (m_pattern.sectors == 0) {
      return isInner;
    }
    const auto outerRim = static_cast<float>(m_pattern.track[0].radius);
    const auto innerRim = static_cast<float>(m_pattern.track[1].radius);
    const Lanes seesOuter = isPositive(radius - outerRim + margin);
    const Lanes seesInner = isPositive(innerRim + margin - radius) * (1.f - seesOuter);
    const Lanes seesNoBorder = m_table.seesNoBorder(radius, margin, angle);
    const Lanes isTrack = isPositive(sight - 0.5f) * isPositive(1.5f - sight);
    const Lanes atRim = 2.f + (seesInner - seesOuter) * (1.f + seesNoBorder);
    return isTrack * atRim + isPositive(0.5f - sight) * isInner;
  }

  // Places of the pixels of a block in its units.
  void placeOf(const std::array<const FitPixel *, laneCount> &pixels, PlaceLanes &place) const
  {
    const auto pixel = [&pixels](int lane) -> const FitPixel & { return *pixels[static_cast<std::size_t>(lane)]; };
    const ImageReference &reference = m_blocks.reference;
    const auto perUnit = static_cast<float>(1. / reference.unit);
    place.x = lanesOf([&](int lane) { return pixel(lane).meter.x(); });
    place.y = lanesOf([&](int lane) { return pixel(lane).meter.y(); });
    place.x = perUnit * (place.x - static_cast<float>(reference.meter.x()));
    place.y = perUnit * (place.y - static_cast<float>(reference.meter.y()));
    if (m_isUniform) {
      const Eigen::Matrix2f derivative = perUnit * m_pixels[0].meterPerPixel;
      place.xByU.setConstant(derivative(0, 0));
      place.xByV.setConstant(derivative(0, 1));
      place.yByU.setConstant(derivative(1, 0));
      place.yByV.setConstant(derivative(1, 1));
      return;
    }
    place.xByU = lanesOf([&](int lane) { return pixel(lane).meterPerPixel(0, 0); });
    place.xByV = lanesOf([&](int lane) { return pixel(lane).meterPerPixel(0, 1); });
    place.yByU = lanesOf([&](int lane) { return pixel(lane).meterPerPixel(1, 0); });
    place.yByV = lanesOf([&](int lane) { return pixel(lane).meterPerPixel(1, 1); });
    for (Lanes *lanes : {&place.xByU, &place.xByV, &place.yByU, &place.yByV}) {
      *lanes = perUnit * *lanes;
    }
  }

  void fillBlock(const unsigned int *sorted, std::size_t count, PixelSight sight, PixelBlock &block)
  {
    const std::array<const FitPixel *, laneCount> pixels = pixelsOf(m_pixels, sorted, count);
    const bool seesSurround =
        std::any_of(pixels.begin(), pixels.end(), [](const FitPixel *pixel) { return pixel->seesSurround(); });
    const auto pixel = [&pixels](int lane) -> const FitPixel & { return *pixels[static_cast<std::size_t>(lane)]; };
    block.offsetU = lanesOf([&](int lane) { return pixel(lane).offset.x(); });
    block.offsetV = lanesOf([&](int lane) { return pixel(lane).offset.y(); });
    block.grey = lanesOf([&](int lane) { return pixel(lane).grey; });
    block.variance = holdingOnly(count);
    placeOf(pixels, block.place);
    block.correction.setZero();
    block.sectors = PixelBlock::none;
    block.surround = PixelBlock::none;
    if (sight == PixelSight::RING && !seesSurround) {
      return;
    }
    PlaneLanes point;
    m_homography.apply(block.place, point);
    if (sight != PixelSight::RING) {
      block.sectors = m_blocks.sectors.size();
      m_table.put(point.qx, point.qy, m_blocks.sectors.emplace_back());
    }
    if (seesSurround) {
      block.surround = m_blocks.surrounds.size();
      putSurround(pixels, point, m_papers, m_photometry, static_cast<float>(m_noise), block,
                  m_blocks.surrounds.emplace_back());
    }
  }

  const std::vector<FitPixel> &m_pixels;
  const bool m_isUniform;
  const MarkerPattern &m_pattern;
  const Photometry &m_photometry;
  const PaperEnds m_papers; // as the sheet is cut
  const double m_noise;
  PixelBlocks &m_blocks;
  const PlaneHomography m_homography;
  const SectorTable m_table;
};
} // namespace

double sightThrough(const BlurParameters &blur, double poseError)
{
  // Lengths are larger by this factor at most than in the image.
  const double longer = blur.widest() / blur.sigma;
  return reachOfEdges * blur.sigma + longer * poseError;
}

bool serve(const PixelBlocks &blocks, const MarkerPlane &plane, const MarkerPattern &pattern,
           const BlurParameters &blur, double poseError, int mostSeen)
{
  if (!blocks.sorting) {
    return false;
  }
  const double motion = printMotion(blocks.sorting->plane, plane) / blocks.reference.unit;
  return sightThrough(blur, poseError + motion) <= blocks.sorting->seen &&
         bordersSeen(plane, pattern, blur, blocks.reference.unit, poseError, mostSeen) <= blocks.borders;
}

void packPixels(const std::vector<FitPixel> &pixels, const MarkerPlane &plane, const MarkerPattern &pattern,
                const Photometry &photometry, double noise, double poseError, int mostSeen, PixelBlocks &blocks)
{
  if (pixels.empty()) {
    for (std::size_t kind = 0; kind < pixelSights; ++kind) {
      blocks.bySight[kind].clear();
      blocks.direction[kind].clear();
    }
    blocks.count.fill(0);
    blocks.sorting.reset();
    return;
  }
  const ModelPixel middle = pixels[pixels.size() / 2].model();
  blocks.reference = {middle.meter, std::sqrt(std::abs(middle.meterPerPixel.determinant())), secondOrderOfLens(pixels)};
  const double seen = sightThrough(photometry.blur, poseError);
  blocks.sorting = {plane, seen};
  blocks.borders = bordersSeen(plane, pattern, photometry.blur, blocks.reference.unit, poseError, mostSeen);
  Packer packer(pixels, plane, pattern, photometry, noise, blocks);
  packer.sort(seen);
  packer.fill();
}

void judgeSurround(const std::vector<FitPixel> &pixels, const MarkerPlane &plane, const MarkerPattern &pattern,
                   const Photometry &photometry, double noise, PixelBlocks &blocks)
{
  if (blocks.surrounds.empty()) {
    return;
  }
  const PlaneHomography homography(plane, blocks.reference, photometry.blur.shape());
  const PaperEnds papers = placedAt(pattern.paper, photometry.paper);
  PlaneLanes point;
  const unsigned int *first = blocks.sortedPixels.data();
  for (std::size_t kind = 0; kind < pixelSights; ++kind) {
    const unsigned int *end = first + blocks.count[kind];
    for (PixelBlock &block : blocks.bySight[kind]) {
      const auto count = std::min<std::size_t>(laneCount, static_cast<std::size_t>(end - first));
      if (block.surround != PixelBlock::none) {
        homography.apply(block.place, point);
        block.variance = holdingOnly(count);
        putSurround(pixelsOf(pixels, first, count), point, papers, photometry, static_cast<float>(noise), block,
                    blocks.surrounds[block.surround]);
      }
      first += count;
    }
  }
}
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE
