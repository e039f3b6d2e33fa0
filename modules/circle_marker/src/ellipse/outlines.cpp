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
 * Outlines of markers at three scales of the image.
 */

#include "ellipse/outlines.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "support/wider_registers.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// The outline of the smallest marker that can be read, with a minor axis of 4 pixels, has 20 pixels.
constexpr std::size_t shortestChain = 14;
// Of a reduced image only outlines of this semi-minor axis count, its pixels: smaller ones are found at a larger size
// or not worth it, larger ones are lost there in noise. And images that have no room for one, and three pixels on
// either side for its edge, are not reduced.
constexpr double leastReducedSemiMinor = 4.;
constexpr unsigned int leastReducedSide = 16;

// A row of the half: the means of four pixels. Two are read as one number of 16 bits: so compilers make vector
// instructions of it.
VP_CIRCLE_MARKER_WIDER_REGISTERS
void halveRow(const unsigned char *above, const unsigned char *below, std::size_t width, unsigned char *out)
{
  for (std::size_t x = 0; x < width; ++x) {
    std::uint16_t upper;
    std::uint16_t lower;
    std::memcpy(&upper, above + 2 * x, sizeof(upper));
    std::memcpy(&lower, below + 2 * x, sizeof(lower));
    const auto sum = static_cast<std::uint16_t>((upper & 0xff) + (upper >> 8) + (lower & 0xff) + (lower >> 8));
    out[x] = static_cast<unsigned char>((sum + 2) >> 2);
  }
}

// Every pixel of the half is the mean of four; an odd last row or column is left out.
void halve(const vpImage<unsigned char> &I, vpImage<unsigned char> &half)
{
  const unsigned int width = I.getWidth() / 2;
  const unsigned int height = I.getHeight() / 2;
  half.resize(height, width);
  for (unsigned int y = 0; y < height; ++y) {
    halveRow(I[2 * y], I[2 * y + 1], width, half[y]);
  }
}

// From pixels of a reduced image. At the half, pixel u' covers 2 u' and 2 u' + 1; its centre is at 2 u' + 1/2.
struct Enlargement
{
  explicit Enlargement(std::size_t halvings)
      : scale(std::ldexp(1., static_cast<int>(halvings))), shift(0.5 * (scale - 1.))
  {
  }

  Eigen::Vector2d operator()(const Eigen::Vector2d &position) const
  {
    return scale * position + Eigen::Vector2d(shift, shift);
  }

  EllipseParameters operator()(EllipseParameters ellipse) const
  {
    ellipse.center = (*this)(ellipse.center);
    ellipse.a *= scale;
    ellipse.b *= scale;
    return ellipse;
  }

  double scale;
  double shift;
};

void enlarge(const Enlargement &enlarged, EllipseCandidate &outline)
{
  outline.ellipse = enlarged(outline.ellipse);
  outline.conic = conicFromEllipse(outline.ellipse);
  for (EdgePoint &point : outline.points) {
    point.position = enlarged(point.position);
  }
}

// The image at all smaller scales, up to their chains.
void linkReduced(const vpImage<unsigned char> &I, NoiseSource noise, const Deadline &deadline, OutlineMemory &memory)
{
  const vpImage<unsigned char> *larger = &I;
  for (OutlineMemory::ReducedScale &scale : memory.reduced) {
    halve(*larger, scale.image);
    larger = &scale.image;
    scale.isUsed = std::min(scale.image.getWidth(), scale.image.getHeight()) >= leastReducedSide;
    if (scale.isUsed) {
      computeGradient(scale.image, scale.gradient, deadline, noise);
      linkEdgeChains(scale.gradient, shortestChain, scale.chains, deadline);
    }
  }
}

// Adds the outlines of a smaller scale to those of the image.
void addReduced(const Enlargement &enlarged, const SoughtCenters &sought, Workers &workers, const Deadline &deadline,
                OutlineMemory::ReducedScale &scale, KnownOutlines &known)
{
  const OtherScale atFull = {&known, enlarged.scale, enlarged.shift};
  findEllipses(scale.image, scale.gradient, scale.chains, sought, atFull, workers, deadline, scale.ellipses);
  for (EllipseCandidate &outline : scale.ellipses.known.outlines) {
    EllipseReject reason = EllipseReject::NONE;
    if (outline.ellipse.b < leastReducedSemiMinor) {
      reason = EllipseReject::TOO_SHORT;
    }
    else if (known.hasSame(enlarged(outline.ellipse), outline.isThin)) {
      reason = EllipseReject::KNOWN_OUTLINE;
    }
    if (reason == EllipseReject::NONE) {
      enlarge(enlarged, outline);
      known.take(outline);
    }
    else if (scale.ellipses.keepsRefusals) {
      scale.ellipses.workspaces.front().refusals.push_back({0, reason, outline.ellipse, outline.points});
    }
  }
}

// Puts the outlines in order: the largest first, but what is found of an edge in part behind what is found of more of
// it. (The ellipse of an arc of a bent sheet's ring was larger than that of all of it: read before it, it gave the
// marker, as one of which a part is covered, at a pose that was off.)
void rankOutlines(KnownOutlines &known)
{
  for (EllipseCandidate &outline : known.outlines) {
    const bool mayBeAnArc = outline.support < wellFound || outline.isThin;
    const EllipseCandidate *better = mayBeAnArc ? known.betterAlong(outline) : nullptr;
    outline.behind = better != nullptr ? better->ellipse.a : HUGE_VAL;
  }
  std::sort(known.outlines.begin(), known.outlines.end(), comesBefore);
}
} // namespace

const ReusedList<EllipseCandidate> &findOutlines(const vpImage<unsigned char> &I, const SoughtCenters &sought,
                                                 Workers &workers, const Deadline &deadline, OutlineMemory &memory,
                                                 NoiseSource noise)
{
  OutlineMemory::Scale &full = memory.full;
  computeGradient(I, full.gradient, workers, deadline, noise);
  workers.run(2, [&](std::size_t part, unsigned int) {
    if (part == 0) {
      linkEdgeChains(full.gradient, shortestChain, full.chains, deadline);
    }
    else {
      linkReduced(I, noise, deadline, memory);
    }
  });
  findEllipses(I, full.gradient, full.chains, sought, OtherScale(), workers, deadline, full.ellipses);
  KnownOutlines &known = full.ellipses.known;
  SoughtCenters soughtReduced = sought;
  for (std::size_t i = 0; i < memory.reduced.size() && memory.reduced[i].isUsed; ++i) {
    addReduced(Enlargement(i + 1), soughtReduced, workers, deadline, memory.reduced[i], known);
    soughtReduced.thinRing = 0.; // what is thin at a quarter is not at the full size
  }
  rankOutlines(known);
  return known.outlines;
}
} // namespace circle_marker
END_VISP_NAMESPACE
