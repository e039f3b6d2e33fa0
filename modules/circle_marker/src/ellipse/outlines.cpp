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
 * Outlines of markers at two scales of the image.
 */

#include "ellipse/outlines.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// The outline of the smallest marker that can be read, with a minor axis of 4 pixels, has 20 pixels.
constexpr std::size_t shortestChain = 14;
// Of the half-size image only outlines of this semi-minor axis count, pixels of the half: smaller ones are found at
// full size or not worth it.
constexpr double leastHalfSemiMinor = 5.;

// Rows of the image that a thread takes at once.
constexpr int rowsAtOnce = 64;

// The gradient of an image, its rows shared among the threads.
void computeGradient(const vpImage<unsigned char> &I, NoiseSource noise, Workers &workers, const Deadline &deadline,
                     Gradient &gradient)
{
  prepareGradient(I, gradient, noise);
  const int bands = (gradient.height + rowsAtOnce - 1) / rowsAtOnce;
  workers.run(static_cast<std::size_t>(bands), [&](std::size_t band, unsigned int) {
    const int first = static_cast<int>(band) * rowsAtOnce;
    if (!deadline.hasPassed()) {
      computeGradientRows(I, first, std::min(first + rowsAtOnce, gradient.height), gradient);
    }
  });
}

// Every pixel of the half is the mean of four; an odd last row or column is left out.
void halve(const vpImage<unsigned char> &I, vpImage<unsigned char> &half)
{
  const unsigned int width = I.getWidth() / 2; // a number of its own: what is written might be the image's otherwise
  const unsigned int height = I.getHeight() / 2;
  half.resize(height, width);
  for (unsigned int y = 0; y < height; ++y) {
    const unsigned char *above = I[2 * y];
    const unsigned char *below = I[2 * y + 1];
    unsigned char *out = half[y];
    // Two pixels are read as one number of 16 bits: so compilers make vector instructions of it.
    for (unsigned int x = 0; x < width; ++x) {
      std::uint16_t upper;
      std::uint16_t lower;
      std::memcpy(&upper, above + 2 * x, sizeof(upper));
      std::memcpy(&lower, below + 2 * x, sizeof(lower));
      const auto sum = static_cast<std::uint16_t>((upper & 0xff) + (upper >> 8) + (lower & 0xff) + (lower >> 8));
      out[x] = static_cast<unsigned char>((sum + 2) >> 2);
    }
  }
}

// From pixels of the half-size image: pixel u' covers 2 u' and 2 u' + 1, its centre is at 2 u' + 1/2.
constexpr double halfScale = 2.;
constexpr double halfShift = 0.5;

EllipseParameters enlarged(EllipseParameters ellipse)
{
  ellipse.center = halfScale * ellipse.center + Eigen::Vector2d(halfShift, halfShift);
  ellipse.a *= halfScale;
  ellipse.b *= halfScale;
  return ellipse;
}

void enlarge(EllipseCandidate &outline)
{
  const Eigen::Vector2d shift(halfShift, halfShift);
  outline.ellipse = enlarged(outline.ellipse);
  outline.conic = conicFromEllipse(outline.ellipse);
  for (EdgePoint &point : outline.points) {
    point.position = halfScale * point.position + shift;
  }
}
} // namespace

const ReusedList<EllipseCandidate> &findOutlines(const vpImage<unsigned char> &I, const SoughtCenters &sought,
                                                 Workers &workers, const Deadline &deadline, OutlineMemory &memory,
                                                 NoiseSource noise)
{
  OutlineMemory::Scale &full = memory.full;
  OutlineMemory::Scale &half = memory.half;
  computeGradient(I, noise, workers, deadline, full.gradient);
  workers.run(2, [&](std::size_t scale, unsigned int) {
    if (scale == 0) {
      linkEdgeChains(full.gradient, shortestChain, full.chains, deadline);
    }
    else {
      halve(I, memory.halved);
      computeGradient(memory.halved, half.gradient, deadline, noise);
      linkEdgeChains(half.gradient, shortestChain, half.chains, deadline);
    }
  });
  findEllipses(I, full.gradient, full.chains, sought, OtherScale(), workers, deadline, full.ellipses);
  const OtherScale atFull = {&full.ellipses.known, halfScale, halfShift};
  findEllipses(memory.halved, half.gradient, half.chains, sought, atFull, workers, deadline, half.ellipses);
  KnownOutlines &known = full.ellipses.known;
  for (EllipseCandidate &outline : half.ellipses.known.outlines) {
    EllipseReject reason = EllipseReject::NONE;
    if (outline.ellipse.b < leastHalfSemiMinor) {
      reason = EllipseReject::TOO_SHORT;
    }
    else if (known.hasSame(enlarged(outline.ellipse))) {
      reason = EllipseReject::KNOWN_OUTLINE;
    }
    if (reason == EllipseReject::NONE) {
      enlarge(outline);
      known.take(outline);
    }
    else if (half.ellipses.keepsRefusals) {
      half.ellipses.benches.front().refusals.push_back({0, reason, outline.ellipse, outline.points});
    }
  }
  std::sort(known.outlines.begin(), known.outlines.end(),
            [](const EllipseCandidate &p, const EllipseCandidate &q) { return p.ellipse.a > q.ellipse.a; });
  return known.outlines;
}
} // namespace circle_marker
END_VISP_NAMESPACE
