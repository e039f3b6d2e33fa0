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

#include "refine/surround.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
namespace {
// An edge is seen up to this many standard deviations of the blur: beyond lie 5e-5 of the contrast, a tenth of what
// rounding to grey levels leaves.
constexpr double reachOfEdges = 3.9;

// A block without pixels: harmless numbers that count nothing.
PixelBlock emptyBlock()
{
  PixelBlock block;
  PlaceLanes &place = block.place;
  for (Lanes *lanes : {&place.x, &place.y, &place.xByV, &place.yByU, &block.offsetU, &block.offsetV, &block.grey,
                       &block.surround[0], &block.surround[1], &block.beyond[0], &block.beyond[1], &block.spread,
                       &block.acrossX, &block.base, &block.correction}) {
    lanes->setZero();
  }
  for (Lanes *lanes : {&place.xByU, &place.yByV, &block.acrossY}) {
    lanes->setOnes();
  }
  for (Lanes &lanes : block.change) {
    lanes.setZero();
  }
  block.variance.setConstant(noPixel);
  return block;
}

// Angle of vectors in [-pi, pi], to 1e-3 rad: enough to know the nearest border.
Lanes roughAngle(const Lanes &x, const Lanes &y)
{
  const Lanes width = x.abs();
  const Lanes height = y.abs();
  const Lanes t = width.min(height) / width.max(height).max(1e-12f);
  // Chebyshev's polynomial of the arc tangent on [0, 1], odd, of degree 5.
  const Lanes square = t * t;
  const Lanes octant = t * (0.995354f + square * (-0.288679f + square * 0.079331f));
  const Lanes quadrant = octant + isPositive(height - width) * (1.5707963f - 2.f * octant);
  const Lanes half = quadrant + isPositive(-x) * (3.1415927f - 2.f * quadrant);
  return half * (1.f - 2.f * isPositive(-y));
}

// Borders that a pixel of the track may see: those whose distance at the inner rim, along the image's shorter axis, is
// within reachOfEdges.
int bordersSeen(const MarkerPlane &plane, const MarkerPattern &pattern, double unit, double distance)
{
  const double tilt = plane.rotation.col(2).dot(plane.center.normalized());
  const double minor = plane.radius * std::abs(tilt) / (plane.center.norm() * unit); // pixels
  const double sector = 2. * M_PI / pattern.sectors * pattern.track[1].radius * minor;
  // With k to either side of the nearest, the next one is at least k + 1/2 sectors away.
  return distance < 0.5 * sector ? 1 : distance < 1.5 * sector ? 3 : 5;
}

// What the surround may do to a pixel: something between nothing and all of its share.
void putSurround(const FitPixel &pixel, const PlanePoint &point, const PaperEnds &papers, const Photometry &photometry,
                 double noise, Eigen::Index lane, PixelBlock &block)
{
  const double light = photometry.light + photometry.lightGradient.dot(pixel.offset);
  double variance = 0.;
  double most = 0.;
  for (std::size_t shape = 0; shape < paperShapes; ++shape) {
    BeyondPaper beyond = pixel.beyond[shape];
    if (beyond.share <= 0.) {
      continue;
    }
    // The pose is better known than when the pixel was chosen.
    beyond.share = shareBeyond(point, papers[shape], photometry.blur.sigma);
    double doubt = 0.25 * light * light; // where nothing is seen of it, anything is possible
    if (std::isfinite(beyond.spread)) {
      block.surround[shape][lane] = static_cast<float>(beyond.share);
      block.beyond[shape][lane] = static_cast<float>(beyond.grey);
      most = std::max(most, beyond.share * std::abs(beyond.grey - light));
      // Noise alone spreads the few looks: by as much, and half as much again by chance.
      doubt = std::max(beyond.spread * beyond.spread - 2. * noise * noise, 0.);
      doubt *= photometry.surround[shape] * photometry.surround[shape];
    }
    variance = std::max(variance, beyond.share * beyond.share * doubt);
  }
  block.spread[lane] = static_cast<float>(most);
  block.variance[lane] = static_cast<float>(variance + photometry.unevenShare * photometry.unevenShare * most * most);
}

// For each border between sectors, what a pixel sees to which it is the nearest.
class SectorTable
{
public:
  SectorTable(const MarkerPattern &pattern, int borders)
      : m_sectors(static_cast<float>(pattern.sectors)), m_borders(borders)
  {
    for (unsigned int sector = 0; sector < pattern.sectors; ++sector) {
      const int nearest = static_cast<int>(sector);
      View &view = m_views[sector];
      view.acrossX = static_cast<float>(pattern.acrossBorder(nearest).x());
      view.acrossY = static_cast<float>(pattern.acrossBorder(nearest).y());
      const int first = nearest - borders / 2;
      float before = pattern.isBlack(first - 1) ? 1.f : 0.f;
      view.base = before;
      for (int k = 0; k < borders; ++k) {
        const float after = pattern.isBlack(first + k) ? 1.f : 0.f;
        view.change[static_cast<std::size_t>(k)] = after - before;
        before = after;
      }
    }
  }

  // Puts what the pixels of a block see that are at (x, y) on the marker's plane.
  void put(const Lanes &x, const Lanes &y, PixelBlock &block) const
  {
    // Borders from -n / 2 to n / 2, shifted by n so that cutting off rounds them.
    const Lanes nearest = roughAngle(x, y) * (m_sectors * 0.15915494f) + (m_sectors + 0.5f);
    const int sectors = static_cast<int>(m_sectors);
    for (int lane = 0; lane < laneCount; ++lane) {
      const int border = static_cast<int>(nearest[lane]);
      const View &view = m_views[static_cast<std::size_t>(border < sectors ? border : border - sectors)];
      block.acrossX[lane] = view.acrossX;
      block.acrossY[lane] = view.acrossY;
      block.base[lane] = view.base;
      for (int k = 0; k < m_borders; ++k) {
        block.change[k + (mostBorders - m_borders) / 2][lane] = view.change[static_cast<std::size_t>(k)];
      }
    }
  }

private:
  struct View
  {
    float acrossX, acrossY, base;
    std::array<float, mostBorders> change;
  };
  std::array<View, 31> m_views;
  float m_sectors;
  int m_borders;
};

// Writes pixels into the blocks of their kinds.
class Packer
{
public:
  Packer(const MarkerPlane &plane, const MarkerPattern &pattern, const Photometry &photometry, double noise,
         PixelBlocks &blocks)
      : m_pattern(pattern), m_photometry(photometry), m_noise(noise), m_blocks(blocks),
        m_homography(plane, blocks.reference, photometry.blur.shape()), m_table(pattern, blocks.borders),
        m_empty(emptyBlock())
  {
  }

  // Where pixels are on the marker's plane.
  void look(const PlaceLanes &place, PlaneLanes &point) const { m_homography.apply(place, point); }

  // direction: of the pixel from the marker's centre.
  void put(const FitPixel &pixel, PixelSight sight, std::size_t direction, const PlaceLanes &place, Eigen::Index from)
  {
    const auto kind = static_cast<std::size_t>(sight);
    const std::size_t lane = m_blocks.count[kind]++ % laneCount;
    std::vector<PixelBlock> &group = m_blocks.bySight[kind];
    if (lane == 0) {
      group.push_back(m_empty);
      m_blocks.direction[kind].push_back(static_cast<unsigned char>(direction));
    }
    PixelBlock &block = group.back();
    const auto to = static_cast<Eigen::Index>(lane);
    block.place.x[to] = place.x[from];
    block.place.y[to] = place.y[from];
    block.place.xByU[to] = place.xByU[from];
    block.place.xByV[to] = place.xByV[from];
    block.place.yByU[to] = place.yByU[from];
    block.place.yByV[to] = place.yByV[from];
    block.offsetU[to] = static_cast<float>(pixel.offset.x());
    block.offsetV[to] = static_cast<float>(pixel.offset.y());
    block.grey[to] = static_cast<float>(pixel.grey);
    block.variance[to] = 0.f;
    m_pixels[kind][lane] = &pixel;
    if (lane + 1 == laneCount) {
      complete(sight);
    }
  }

  // Completes the last block of each kind.
  void finish()
  {
    for (std::size_t kind = 0; kind < pixelSights; ++kind) {
      if (m_blocks.count[kind] % laneCount != 0) {
        complete(static_cast<PixelSight>(kind));
      }
    }
  }

private:
  void complete(PixelSight sight)
  {
    const auto kind = static_cast<std::size_t>(sight);
    PixelBlock &block = m_blocks.bySight[kind].back();
    const std::size_t count = (m_blocks.count[kind] - 1) % laneCount + 1;
    PlaneLanes point;
    m_homography.apply(block.place, point);
    if (sight != PixelSight::RING) {
      m_table.put(point.qx, point.qy, block);
    }
    for (std::size_t k = 0; k < count; ++k) {
      const FitPixel &pixel = *m_pixels[kind][k];
      if (pixel.beyond[0].share > 0. || pixel.beyond[1].share > 0.) {
        const auto lane = static_cast<Eigen::Index>(k);
        PlanePoint there;
        there.q << point.qx[lane], point.qy[lane];
        there.byPixel << point.qxByU[lane], point.qxByV[lane], point.qyByU[lane], point.qyByV[lane];
        m_blocks.seesSurround = true;
        putSurround(pixel, there, m_pattern.paper, m_photometry, m_noise, lane, block);
      }
    }
  }

  const MarkerPattern &m_pattern;
  const Photometry &m_photometry;
  const double m_noise;
  PixelBlocks &m_blocks;
  const PlaneHomography m_homography;
  const SectorTable m_table;
  const PixelBlock m_empty;
  std::array<std::array<const FitPixel *, laneCount>, pixelSights> m_pixels; // of the last blocks
};

// What a pixel at a radius may see; margin: how far it sees, in radii.
PixelSight sightOf(float radius, float margin, const MarkerPattern &pattern)
{
  if (pattern.sectors == 0 || radius > static_cast<float>(pattern.track[0].radius) + margin ||
      radius < static_cast<float>(pattern.track[1].radius) - margin) {
    return PixelSight::RING;
  }
  return radius < static_cast<float>(pattern.ring[1].radius) - margin ? PixelSight::TRACK : PixelSight::RING_AND_TRACK;
}
// Places of eight pixels in the units of the blocks.
void placeOf(const FitPixel *pixels, Eigen::Index count, const ImageReference &reference, PlaceLanes &place)
{
  const double perUnit = 1. / reference.unit;
  for (Eigen::Index lane = 0; lane < count; ++lane) {
    const ModelPixel &model = pixels[lane].model;
    place.x[lane] = static_cast<float>(perUnit * (model.meter.x() - reference.meter.x()));
    place.y[lane] = static_cast<float>(perUnit * (model.meter.y() - reference.meter.y()));
    place.xByU[lane] = static_cast<float>(perUnit * model.meterPerPixel(0, 0));
    place.xByV[lane] = static_cast<float>(perUnit * model.meterPerPixel(0, 1));
    place.yByU[lane] = static_cast<float>(perUnit * model.meterPerPixel(1, 0));
    place.yByV[lane] = static_cast<float>(perUnit * model.meterPerPixel(1, 1));
  }
}

// Looks where all pixels are on the marker and sorts them: by kind, then by direction.
void sortPixels(const std::vector<FitPixel> &pixels, const MarkerPattern &pattern, double seen, const Packer &packer,
                PixelBlocks &blocks)
{
  constexpr float perTurn = static_cast<float>(directions) / 6.2831853f;
  std::array<unsigned int, pixelSights *directions + 1> start = {};
  blocks.places.clear();
  blocks.bins.resize(pixels.size());
  PlaceLanes place = emptyBlock().place;
  PlaneLanes point;
  for (std::size_t first = 0; first < pixels.size(); first += laneCount) {
    const std::size_t count = std::min<std::size_t>(laneCount, pixels.size() - first);
    placeOf(&pixels[first], static_cast<Eigen::Index>(count), blocks.reference, place);
    blocks.places.push_back(place);
    packer.look(place, point);
    const Lanes direction = perTurn * (roughAngle(point.qx, point.qy) + 3.1415927f);
    for (std::size_t k = 0; k < count; ++k) {
      const auto lane = static_cast<Eigen::Index>(k);
      const PixelSight sight = sightOf(point.radius[lane], static_cast<float>(seen) * point.gradient[lane], pattern);
      const std::size_t bin = static_cast<std::size_t>(sight) * directions +
                              std::min(static_cast<std::size_t>(direction[lane]), directions - 1);
      blocks.bins[first + k] = static_cast<unsigned char>(bin);
      ++start[bin + 1];
    }
  }
  for (std::size_t bin = 1; bin < start.size(); ++bin) {
    start[bin] += start[bin - 1];
  }
  blocks.sortedPixels.resize(pixels.size());
  for (std::size_t k = 0; k < pixels.size(); ++k) {
    blocks.sortedPixels[start[blocks.bins[k]]++] = static_cast<unsigned int>(k);
  }
}
} // namespace

void packPixels(const std::vector<FitPixel> &pixels, const MarkerPlane &plane, const MarkerPattern &pattern,
                const Photometry &photometry, double noise, double poseError, PixelBlocks &blocks)
{
  blocks.seesSurround = false;
  for (std::size_t kind = 0; kind < pixelSights; ++kind) {
    blocks.bySight[kind].clear();
    blocks.direction[kind].clear();
  }
  blocks.count.fill(0);
  if (pixels.empty()) {
    return;
  }
  const FitPixel &middle = pixels[pixels.size() / 2];
  blocks.reference = {middle.model.meter, std::sqrt(std::abs(middle.model.meterPerPixel.determinant()))};
  // Pixels, in coordinates in which the blur is round: there lengths are larger by this factor at most.
  const double longer = photometry.blur.widest() / photometry.blur.sigma;
  const double seen = reachOfEdges * photometry.blur.sigma + longer * poseError;
  blocks.borders = pattern.sectors > 0 ? bordersSeen(plane, pattern, blocks.reference.unit, longer * seen) : 0;
  Packer packer(plane, pattern, photometry, noise, blocks);
  sortPixels(pixels, pattern, seen, packer, blocks);
  for (const unsigned int k : blocks.sortedPixels) {
    packer.put(pixels[k], static_cast<PixelSight>(blocks.bins[k] / directions), blocks.bins[k] % directions,
               blocks.places[k / laneCount], static_cast<Eigen::Index>(k % laneCount));
  }
  packer.finish();
}
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE
