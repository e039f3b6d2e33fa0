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
namespace {
// An edge is seen up to this many standard deviations of the blur (3e-6 of the contrast), and the pose at which the
// pixels are sorted may be off by this much, pixels.
constexpr double reach = 4.5;
constexpr double poseError = 1.;

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

// Angle of a vector, to 1e-3 rad and several times faster than std::atan2: enough to know the nearest border.
float roughAngle(float x, float y)
{
  const float least = std::min(std::abs(x), std::abs(y));
  const float most = std::max(std::abs(x), std::abs(y));
  const float t = least / std::max(most, 1e-12f);
  // Chebyshev's polynomial of the arc tangent on [0, 1], odd, of degree 5.
  const float square = t * t;
  const float octant = t * (0.995354f + square * (-0.288679f + square * 0.079331f));
  const float quadrant = std::abs(y) > std::abs(x) ? 1.5707963f - octant : octant;
  const float half = x < 0.f ? 3.1415927f - quadrant : quadrant;
  return y < 0.f ? -half : half;
}

// Borders that a pixel of the track may see: those whose distance at the inner rim, along the image's shorter axis, is
// within reach.
int bordersSeen(const MarkerPlane &plane, const MarkerPattern &pattern, double unit, double distance)
{
  const double tilt = plane.rotation.col(2).dot(plane.center.normalized());
  const double minor = plane.radius * std::abs(tilt) / (plane.center.norm() * unit); // pixels
  const double sector = 2. * M_PI / pattern.sectors * pattern.track[1].radius * minor;
  // With k to either side of the nearest, the next one is at least k + 1/2 sectors away.
  return distance < 0.5 * sector ? 1 : distance < 1.5 * sector ? 3 : 5;
}

// What the surround may do to a pixel: something between nothing and all of its share.
void putSurround(const FitPixel &pixel, const MarkerPlane &plane, const PaperEnds &papers, const Photometry &photometry,
                 double noise, Eigen::Index lane, PixelBlock &block)
{
  block.grey[lane] = static_cast<float>(pixel.grey);
  block.spread[lane] = 0.f;
  block.variance[lane] = 0.f;
  const double light = photometry.light + photometry.lightGradient.dot(pixel.offset);
  double variance = 0.;
  double most = 0.;
  for (std::size_t shape = 0; shape < paperShapes; ++shape) {
    BeyondPaper beyond = pixel.beyond[shape];
    block.surround[shape][lane] = 0.f;
    block.beyond[shape][lane] = 0.f;
    if (beyond.share <= 0.) {
      continue;
    }
    // The pose is better known than when the pixel was chosen.
    beyond.share = shareBeyond(planePoint(pixel.model, plane), papers[shape], photometry.blur.sigma);
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

// What a pixel of the track may see of the sectors.
void putSectors(float x, float y, const MarkerPattern &pattern, int borders, std::size_t lane, PixelBlock &block)
{
  const auto l = static_cast<Eigen::Index>(lane);
  // Borders from -n / 2 to n / 2, shifted by n so that cutting off rounds them.
  const auto n = static_cast<float>(pattern.sectors);
  constexpr float perTurn = 0.15915494f; // 1 / 2 pi
  const int nearest = static_cast<int>(roughAngle(x, y) * n * perTurn + n + 0.5f) - static_cast<int>(pattern.sectors);
  const Eigen::Vector2d &across = pattern.acrossBorder(nearest);
  block.acrossX[l] = static_cast<float>(across.x());
  block.acrossY[l] = static_cast<float>(across.y());
  const int first = nearest - borders / 2;
  float before = pattern.isBlack(first - 1) ? 1.f : 0.f;
  block.base[l] = before;
  for (int k = 0; k < borders; ++k) {
    const float after = pattern.isBlack(first + k) ? 1.f : 0.f;
    block.change[k + (mostBorders - borders) / 2][l] = after - before;
    before = after;
  }
}

// Adds a pixel to the blocks of its kind.
void put(const FitPixel &pixel, const MarkerPlane &plane, PixelSight sight, const PlaceLanes &place,
         const PlaneLanes &point, Eigen::Index from, const MarkerPattern &pattern, const Photometry &photometry,
         double noise, PixelBlocks &blocks)
{
  const auto kind = static_cast<std::size_t>(sight);
  const std::size_t lane = blocks.count[kind]++ % laneCount;
  std::vector<PixelBlock> &group = blocks.bySight[kind];
  if (lane == 0) {
    group.push_back(emptyBlock());
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
  putSurround(pixel, plane, pattern.paper, photometry, noise, to, block);
  if (sight != PixelSight::RING) {
    putSectors(point.qx[from], point.qy[from], pattern, blocks.borders, lane, block);
  }
}

// What a pixel at a radius may see; margin: how far it sees, in radii.
PixelSight sightOf(float radius, float margin, const MarkerPattern &pattern)
{
  if (pattern.sectors == 0 || radius > static_cast<float>(pattern.track[0].radius) + margin ||
      radius < static_cast<float>(pattern.track[1].radius) - margin) {
    return PixelSight::RING;
  }
  return radius < static_cast<float>(pattern.ring[1].radius) - margin ? PixelSight::TRACK : PixelSight::RING_AND_TRACK;
}
} // namespace

void packPixels(const std::vector<FitPixel> &pixels, const MarkerPlane &plane, const MarkerPattern &pattern,
                const Photometry &photometry, double noise, PixelBlocks &blocks)
{
  for (std::vector<PixelBlock> &group : blocks.bySight) {
    group.clear();
  }
  blocks.count.fill(0);
  if (pixels.empty()) {
    return;
  }
  const FitPixel &middle = pixels[pixels.size() / 2];
  blocks.reference = {middle.model.meter, std::sqrt(std::abs(middle.model.meterPerPixel.determinant()))};
  const double seen = reach * photometry.blur.sigma + poseError; // pixels
  blocks.borders = pattern.sectors > 0 ? bordersSeen(plane, pattern, blocks.reference.unit, seen) : 0;
  const PlaneHomography homography(plane, blocks.reference);
  const double perUnit = 1. / blocks.reference.unit;
  PlaceLanes place = emptyBlock().place;
  PlaneLanes point;
  for (std::size_t start = 0; start < pixels.size(); start += laneCount) {
    const auto count = static_cast<Eigen::Index>(std::min<std::size_t>(laneCount, pixels.size() - start));
    for (Eigen::Index lane = 0; lane < count; ++lane) {
      const ModelPixel &model = pixels[start + static_cast<std::size_t>(lane)].model;
      place.x[lane] = static_cast<float>(perUnit * (model.meter.x() - blocks.reference.meter.x()));
      place.y[lane] = static_cast<float>(perUnit * (model.meter.y() - blocks.reference.meter.y()));
      place.xByU[lane] = static_cast<float>(perUnit * model.meterPerPixel(0, 0));
      place.xByV[lane] = static_cast<float>(perUnit * model.meterPerPixel(0, 1));
      place.yByU[lane] = static_cast<float>(perUnit * model.meterPerPixel(1, 0));
      place.yByV[lane] = static_cast<float>(perUnit * model.meterPerPixel(1, 1));
    }
    homography.apply(place, point);
    for (Eigen::Index lane = 0; lane < count; ++lane) {
      const PixelSight sight = sightOf(point.radius[lane], static_cast<float>(seen) * point.gradient[lane], pattern);
      put(pixels[start + static_cast<std::size_t>(lane)], plane, sight, place, point, lane, pattern, photometry, noise,
          blocks);
    }
  }
}
} // namespace circle_marker
END_VISP_NAMESPACE
