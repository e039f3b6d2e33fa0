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
 * Where edges turn back: the ends of what is narrow.
 */

#include "edges/edge_caps.h"

#include <algorithm>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Pixels to either side of a tip between which an edge has turned back: less than twice this is what is narrow wide.
constexpr std::ptrdiff_t mostReach = 7;
// And at least, near the ends of a chain.
constexpr std::ptrdiff_t leastReach = 4;
// An edge that turns back does so for several pixels: every other one is asked.
constexpr std::ptrdiff_t turnStep = 2;
// Square of the cosine of the least turn, 109 degrees: the tip of an ellipse with a quarter of the length as its width
// turns by more, a right angle by less.
constexpr double squaredCosine = 0.106;
// Pixels to either side of a tip that its axis is taken from.
constexpr std::ptrdiff_t axisReach = 14;
// Pixels to either side of a tip that may belong to the cap: the end of the longest narrow thing.
constexpr std::ptrdiff_t capReach = 230;
// Pixels between two gradients whose turn is told, and the tangent of one the wrong way, 0.5 rad, that ends a cap:
// twice what the noise makes of a gradient that just prolongs a chain.
constexpr std::ptrdiff_t turnStride = 4;
constexpr double concaveTangent = 0.55;

// Whole numbers, of two million at most: what is only asked for its sign, which is most, is not made a fraction.
int crossOf(const GradientVector &p, const GradientVector &q)
{
  return p.dx * q.dy - p.dy * q.dx;
}

int dotOf(const GradientVector &p, const GradientVector &q)
{
  return p.dx * q.dx + p.dy * q.dy;
}

// The pixels of a chain by their number, which goes round where the chain is closed.
class ChainPixels
{
public:
  ChainPixels(const EdgeChains &chains, const EdgeChain &chain)
      : m_pixels(&chains.pixels[chain.begin]), m_size(static_cast<std::ptrdiff_t>(chain.length())),
        m_closed(chain.closed)
  {
  }

  std::ptrdiff_t size() const { return m_size; }

  // How many pixels there are to one side, step being 1 or -1, at most so many.
  std::ptrdiff_t reachOn(std::ptrdiff_t i, std::ptrdiff_t step, std::ptrdiff_t most) const
  {
    return std::min(most, m_closed ? (m_size - 1) / 2 : step > 0 ? m_size - 1 - i : i);
  }

  // And to both sides.
  std::ptrdiff_t reachAt(std::ptrdiff_t i, std::ptrdiff_t most) const
  {
    return std::min(reachOn(i, 1, most), reachOn(i, -1, most));
  }

  // i: from -size to 2 size.
  std::ptrdiff_t numberOf(std::ptrdiff_t i) const { return i < 0 ? i + m_size : i < m_size ? i : i - m_size; }

  const EdgePixel &operator[](std::ptrdiff_t i) const { return m_pixels[numberOf(i)]; }

  Eigen::Vector2d position(std::ptrdiff_t i) const { return Eigen::Vector2d((*this)[i].x, (*this)[i].y); }

private:
  const EdgePixel *m_pixels;
  std::ptrdiff_t m_size;
  bool m_closed;
};

// Those pixels with their gradients.
class ChainGradient
{
public:
  ChainGradient(const Gradient &gradient, const ChainPixels &pixels) : m_gradient(gradient), m_pixels(pixels) {}

  // The way an edge turns back around a pixel: 1 around something dark, -1 around something bright, 0: it does not.
  int turnAt(std::ptrdiff_t i) const
  {
    const std::ptrdiff_t reach = m_pixels.reachAt(i, mostReach);
    if (reach < leastReach) {
      return 0;
    }
    const GradientVector before = at(i - reach);
    const GradientVector after = at(i + reach);
    const int dot = dotOf(before, after);
    if (dot >= 0 || static_cast<double>(dot) * dot < squaredCosine * before.squared() * after.squared()) {
      return 0;
    }
    const GradientVector middle = at(i);
    const int first = crossOf(before, middle);
    const int last = crossOf(middle, after);
    return first > 0 && last > 0 ? 1 : first < 0 && last < 0 ? -1 : 0;
  }

  // The first pixel before which the edge does not turn back for a while: no turn goes on beyond it. The number of
  // pixels if there is none.
  std::ptrdiff_t quietPixel() const
  {
    std::ptrdiff_t quiet = 0;
    std::ptrdiff_t i = 0;
    for (; i < m_pixels.size() && quiet <= mostReach; i += turnStep) {
      quiet = turnAt(i) == 0 ? quiet + turnStep : 0;
    }
    return std::min(i, m_pixels.size());
  }

  // Pixels on one side of a tip up to which the edge does not bend back.
  std::ptrdiff_t convexOn(std::ptrdiff_t tip, std::ptrdiff_t step, int turn) const
  {
    const std::ptrdiff_t reach = m_pixels.reachOn(tip, step, capReach);
    for (std::ptrdiff_t k = 0; k + turnStride <= reach; ++k) {
      const GradientVector here = at(tip + k * step);
      const GradientVector next = at(tip + (k + turnStride) * step);
      const int convex = turn * static_cast<int>(step) * crossOf(here, next);
      if (convex < 0 && convex < -concaveTangent * std::max(dotOf(here, next), 0)) {
        return k;
      }
    }
    return reach;
  }

private:
  const GradientVector &at(std::ptrdiff_t i) const { return m_gradient.at(m_pixels[i].x, m_pixels[i].y); }

  const Gradient &m_gradient;
  const ChainPixels &m_pixels;
};

// The cap around a tip.
EdgeCap capAt(const ChainPixels &pixels, const ChainGradient &gradient, std::ptrdiff_t tip, int turn)
{
  const std::ptrdiff_t reach = pixels.reachAt(tip, axisReach);
  EdgeCap cap;
  cap.pixel = static_cast<std::size_t>(tip);
  cap.before = static_cast<std::size_t>(gradient.convexOn(tip, -1, turn));
  cap.after = static_cast<std::size_t>(gradient.convexOn(tip, 1, turn));
  cap.tip = pixels.position(tip);
  cap.axis = (cap.tip - 0.5 * (pixels.position(tip - reach) + pixels.position(tip + reach))).normalized();
  cap.isDark = turn > 0;
  return cap;
}
} // namespace

void findCaps(const Gradient &gradient, const EdgeChains &chains, std::size_t index, ReusedList<EdgeCap> &caps)
{
  const ChainPixels pixels(chains, chains.chains[index]);
  const ChainGradient turns(gradient, pixels);
  int turn = 0;
  std::ptrdiff_t first = 0; // of the pixels around which the edge turns the same way
  std::ptrdiff_t last = 0;
  const auto close = [&]() {
    if (turn != 0) {
      EdgeCap &cap = caps.append();
      cap = capAt(pixels, turns, pixels.numberOf((first + last) / 2), turn);
      cap.chain = index;
    }
  };
  const std::ptrdiff_t start = chains.chains[index].closed ? turns.quietPixel() : 0;
  for (std::ptrdiff_t i = start; i < start + pixels.size(); i += turnStep) {
    const int here = turns.turnAt(pixels.numberOf(i));
    if (here == 0) {
      continue;
    }
    if (here != turn || i - last > mostReach) { // what is nearer is the same turn
      close();
      first = i;
      turn = here;
    }
    last = i;
  }
  close();
}

CapSides sidesOf(const EdgeChains &chains, const EdgeCap &cap, std::size_t reach)
{
  const ChainPixels pixels(chains, chains.chains[cap.chain]);
  const auto tip = static_cast<std::ptrdiff_t>(cap.pixel);
  return {pixels.position(tip - static_cast<std::ptrdiff_t>(std::min(cap.before, reach))),
          pixels.position(tip + static_cast<std::ptrdiff_t>(std::min(cap.after, reach)))};
}

void locateCap(const Gradient &gradient, const EdgeChains &chains, const EdgeCap &cap, std::size_t reach,
               std::vector<EdgePoint> &points)
{
  const EdgeChain &chain = chains.chains[cap.chain];
  const auto size = static_cast<std::ptrdiff_t>(chain.length());
  const auto tip = static_cast<std::ptrdiff_t>(cap.pixel);
  const std::ptrdiff_t from = tip - static_cast<std::ptrdiff_t>(std::min(cap.before, reach));
  const std::ptrdiff_t to = tip + 1 + static_cast<std::ptrdiff_t>(std::min(cap.after, reach));
  // In a closed chain what lies before its first pixel is at its end, and the other way round.
  const auto locate = [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    if (begin < end) {
      locateChain(gradient, chains,
                  {chain.begin + static_cast<std::size_t>(begin), chain.begin + static_cast<std::size_t>(end), false},
                  points);
    }
  };
  locate(from + size, size);
  locate(std::max<std::ptrdiff_t>(from, 0), std::min(to, size));
  locate(0, to - size);
}
} // namespace circle_marker
END_VISP_NAMESPACE
