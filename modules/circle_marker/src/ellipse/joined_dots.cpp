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
 * Outlines put together from two dark dots.
 */

#include "ellipse/joined_dots.h"

#include <algorithm>
#include <cmath>

#include "ellipse/dot_pairs.h"
#include "ellipse/outline_greys.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// A dot is darker than all around by this, grey levels and noise of a pixel: of a pair of black and white that differ
// by 40 the ends of a ring keep a third.
constexpr double leastDepth = 12.;
constexpr double depthOfNoise = 5.;
// Where there are more dots than these, of any image, and one more for so many pixels, they are of a texture, and each
// has too many others around. Clutter has one for 6000 pixels.
constexpr std::size_t fewestDots = 200;
constexpr std::size_t pixelsForDot = 600;
// Nor are dots with so many of them in a square of the size of the farthest pairs, twice as many as an image may have
// on the whole: each has that many others to make a ring with, and a patch of texture would take seconds.
constexpr std::size_t mostDotsInSquare = 40;
// Rows that a thread takes at once.
constexpr int rowsAtOnce = 64;
constexpr int pointsOfOutline = 48;

// Leaves out what is in a square with too many others.
void dropTexture(EllipseMemory &memory, unsigned int width, unsigned int height)
{
  constexpr auto side = static_cast<unsigned int>(farthestDots);
  const std::size_t columns = width / side + 1;
  const auto squareOf = [&](const DarkDot &dot) {
    return static_cast<std::size_t>(dot.place.y()) / side * columns + static_cast<std::size_t>(dot.place.x()) / side;
  };
  memory.dotsInSquares.assign(columns * (height / side + 1), 0);
  for (const DarkDot &dot : memory.dots) {
    ++memory.dotsInSquares[squareOf(dot)];
  }
  const auto isOfTexture = [&](const DarkDot &dot) { return memory.dotsInSquares[squareOf(dot)] > mostDotsInSquare; };
  memory.dots.erase(std::remove_if(memory.dots.begin(), memory.dots.end(), isOfTexture), memory.dots.end());
}

// The dots of all rows, from above to below; none if there are too many, or there was no time for all.
void findAll(const EllipseSearch &search, Workers &workers)
{
  for (EllipseMemory::Workspace &workspace : search.memory.workspaces) {
    workspace.dots.clear();
  }
  const int rise = static_cast<int>(std::ceil(std::max(leastDepth, depthOfNoise * search.gradient.noise.sigma)));
  const int height = static_cast<int>(search.I.getHeight());
  const int bands = (height + rowsAtOnce - 1) / rowsAtOnce;
  workers.run(static_cast<std::size_t>(bands), [&](std::size_t band, unsigned int worker) {
    if (!search.deadline.hasPassed()) {
      const int first = static_cast<int>(band) * rowsAtOnce;
      findDarkDots(search.I, first, std::min(first + rowsAtOnce, height), rise, search.memory.workspaces[worker].dots);
    }
  });
  std::vector<DarkDot> &dots = search.memory.dots;
  dots.clear();
  std::size_t count = 0;
  for (const EllipseMemory::Workspace &workspace : search.memory.workspaces) {
    count += workspace.dots.size();
  }
  if (count > fewestDots + search.I.getSize() / pixelsForDot || search.deadline.hasPassed()) {
    return;
  }
  for (const EllipseMemory::Workspace &workspace : search.memory.workspaces) {
    dots.insert(dots.end(), workspace.dots.begin(), workspace.dots.end());
  }
  dropTexture(search.memory, search.I.getWidth(), search.I.getHeight());
  std::sort(dots.begin(), dots.end(), [](const DarkDot &p, const DarkDot &q) {
    return p.place.y() != q.place.y() ? p.place.y() < q.place.y() : p.place.x() < q.place.x();
  });
}

// The rings between two dots, in the order of the dots. What a pair gives does not depend on what is known.
void findRings(const EllipseSearch &search, Workers &workers)
{
  using DotRing = EllipseMemory::DotRing;
  const std::vector<DarkDot> &dots = search.memory.dots;
  for (EllipseMemory::Workspace &workspace : search.memory.workspaces) {
    workspace.rings.clear();
  }
  workers.run(dots.size(), [&](std::size_t i, unsigned int worker) {
    if (search.deadline.hasPassed()) {
      return;
    }
    for (std::size_t j = i + 1; j < dots.size() && dots[j].place.y() - dots[i].place.y() <= farthestDots; ++j) {
      if (const auto ring = ringBetween(search.I, dots[i], dots[j], search.sought.thinRing)) {
        search.memory.workspaces[worker].rings.push_back({i, j, *ring});
      }
    }
  });
  std::vector<DotRing> &rings = search.memory.rings;
  rings.clear();
  for (const EllipseMemory::Workspace &workspace : search.memory.workspaces) {
    rings.insert(rings.end(), workspace.rings.begin(), workspace.rings.end());
  }
  std::sort(rings.begin(), rings.end(),
            [](const DotRing &p, const DotRing &q) { return p.one != q.one ? p.one < q.one : p.other < q.other; });
}

// Whether a ring, and what is beside it, is inside of an outline that is found: then it is a piece of its code.
bool isInside(const KnownOutlines &known, const EllipseParameters &ring)
{
  const Eigen::Vector2d aside = 2. * ring.b * Eigen::Vector2d(-std::sin(ring.angle), std::cos(ring.angle));
  return known.surrounds(ring.center - aside, wholeOutline) && known.surrounds(ring.center + aside, wholeOutline);
}
} // namespace

void joinDots(const EllipseSearch &search, Workers &workers)
{
  if (search.sought.thinRing <= 0. || search.other.known != nullptr) {
    return;
  }
  findAll(search, workers);
  findRings(search, workers);
  EllipseCandidate &candidate = search.memory.ofDots;
  for (const EllipseMemory::DotRing &ring : search.memory.rings) {
    if (search.deadline.hasPassed()) {
      return;
    }
    if (!isInside(search.memory.known, ring.ellipse)) {
      candidate.isThin = true;
      setOutline(ring.ellipse, pointsOfOutline, candidate);
      candidate.contrast = medianContrast(search.I, candidate);
      search.memory.known.take(candidate);
    }
  }
}
} // namespace circle_marker
END_VISP_NAMESPACE
