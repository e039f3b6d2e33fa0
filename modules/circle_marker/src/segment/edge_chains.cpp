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
 * Chains of edge pixels that follow the ridges of the gradient.
 */

#include "segment/edge_chains.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <optional>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// The eight neighbours in the order of their angle from +x toward +y.
constexpr int stepX[8] = {1, 1, 0, -1, -1, -1, 0, 1};
constexpr int stepY[8] = {0, 1, 1, 1, 0, -1, -1, -1};
// Two neighbouring pixels of one edge differ in gradient direction by less than 60 degrees (cos^2 = 1/4), even on the
// tightest bend of a small oblique ring; the two edges of a thin line differ by 180.
constexpr std::int64_t leastSquaredCosineInverse = 4;
// A loop of fewer pixels than this is noise, and a chain closes on its start within this many pixels.
constexpr int closingDistance = 2;
// Chains start in every second row: whatever bends enough to be a piece of an ellipse crosses some of them, and the
// search for starts is half as long.
constexpr int rowsApart = 2;
// Marks of EdgeChains::visited.
constexpr std::uint8_t walked = 1;
constexpr std::uint8_t beside = 2;

// Octant of a direction: 0 for +x, 2 for +y, and so on. By a table: edges turn all the time, and a branch that the
// processor cannot foresee takes longer than the rest of a step.
int octant(int x, int y)
{
  static constexpr std::uint8_t octants[2][2][3] = {{{4, 5, 6}, {4, 3, 2}}, {{0, 7, 6}, {0, 1, 2}}};
  const int ax = std::abs(x);
  const int ay = std::abs(y);
  // Nearer to the x axis than 22.5 degrees (tangent 0.414), between, nearer to the y axis.
  const int kind = 1 - (5 * ay < 2 * ax ? 1 : 0) + (5 * ax < 2 * ay ? 1 : 0);
  return octants[x > 0 ? 1 : 0][y > 0 ? 1 : 0][kind];
}

// A walk that ran into one of its own pixels has gone round a loop: index of the loop's first pixel, or the size.
std::size_t loopStart(const std::vector<EdgePixel> &pixels, std::size_t begin, const std::optional<EdgePixel> &hit)
{
  if (hit) {
    for (std::size_t i = begin; i < pixels.size(); ++i) {
      if (pixels[i].x == hit->x && pixels[i].y == hit->y) {
        return i;
      }
    }
  }
  return pixels.size();
}

bool endsMeet(const std::vector<EdgePixel> &pixels, std::size_t begin, std::size_t end)
{
  const EdgePixel first = pixels[begin];
  const EdgePixel last = pixels[end - 1];
  return std::abs(first.x - last.x) <= closingDistance && std::abs(first.y - last.y) <= closingDistance;
}

// Tells of each component of a row's gradients whether it is large enough that the pixel could start a chain: one of
// the two is at least the magnitude divided by sqrt(2). Without a branch, for vector instructions.
void markStrong(const GradientVector *row, std::size_t width, short least, std::uint8_t *strong)
{
  static_assert(sizeof(GradientVector) == 2 * sizeof(short), "read as a row of components");
  const short *components = &row->dx;
  for (std::size_t i = 0; i < 2 * width; ++i) {
    const short size = std::max(components[i], static_cast<short>(-components[i]));
    strong[i] = size >= least ? 1 : 0;
  }
}

bool noneOfEight(const std::uint8_t *bytes)
{
  std::uint64_t word;
  std::memcpy(&word, bytes, sizeof(word));
  return word == 0;
}

class Linker
{
public:
  Linker(const Gradient &gradient, EdgeChains &result)
      : m_gradient(gradient), m_result(result), m_width(gradient.width),
        m_least(std::max(gradient.continueAbove * gradient.continueAbove, 1))
  {
    for (std::size_t i = 0; i < m_steps.size(); ++i) {
      m_steps[i] = static_cast<std::ptrdiff_t>(stepY[i]) * m_width + stepX[i];
    }
  }

  // Walks from (x, y), excluded, along the edge; forward has the bright side on the left. Returns the pixel of an
  // earlier walk, or of its own, that it ran into.
  std::optional<EdgePixel> walk(int x, int y, bool forward, std::vector<EdgePixel> &out, const Deadline &deadline)
  {
    constexpr std::size_t stepsAtOnce = 4096; // between two looks at the clock: some 0.1 ms
    const GradientVector *here = m_gradient.vectors.data() + m_gradient.index(x, y);
    while (true) {
      // The gradient (to the bright side) turned by a quarter: with v down, (-gy, gx) has it on the left.
      const int ahead = octant(-here->dy, here->dx) + (forward ? 0 : 4);
      const std::int64_t squared = here->squared();
      // The strongest of three, as a number with its turn in the last two bits, the first of equals; -1 if there is
      // none. Without a branch: which it is cannot be foreseen. No step leaves the image: along its border the gradient
      // is zero.
      std::int64_t strongest = -1;
      for (int turn = 0; turn < 3; ++turn) {
        const GradientVector next = here[m_steps[(ahead + turn + 7) & 7]];
        const std::int64_t magnitude = next.squared();
        const std::int64_t dot = here->dx * next.dx + here->dy * next.dy;
        const int fits = static_cast<int>(magnitude >= m_least) & static_cast<int>(dot > 0) &
                         static_cast<int>(dot * dot * leastSquaredCosineInverse > squared * magnitude);
        strongest = std::max(strongest, (4 * magnitude + (2 - turn)) | static_cast<std::int64_t>(fits - 1));
      }
      if (strongest < 0) {
        return std::nullopt;
      }
      const auto best = static_cast<std::size_t>((ahead + 2 - (strongest & 3) + 7) & 7);
      here += m_steps[best];
      x += stepX[best];
      y += stepY[best];
      const auto place = static_cast<std::size_t>(here - m_gradient.vectors.data());
      const EdgePixel pixel = {static_cast<short>(x), static_cast<short>(y)};
      if (m_result.visited[place] == walked) {
        return pixel;
      }
      m_result.visited[place] = walked;
      markBeside(place);
      out.push_back(pixel);
      if (out.size() % stepsAtOnce == 0 && deadline.hasPassed()) {
        return std::nullopt;
      }
    }
  }

  // Links the edge through a pixel, in both directions, and keeps the chains that are long enough.
  void linkThrough(int x, int y, std::size_t shortest, const Deadline &deadline)
  {
    std::vector<EdgePixel> &pixels = m_result.pixels;
    m_result.visited[m_gradient.index(x, y)] = walked;
    markBeside(m_gradient.index(x, y));
    const std::size_t begin = pixels.size();
    pixels.push_back({static_cast<short>(x), static_cast<short>(y)});
    const std::size_t loopBehind = loopStart(pixels, begin, walk(x, y, false, pixels, deadline));
    std::reverse(pixels.begin() + static_cast<std::ptrdiff_t>(begin), pixels.end());
    // The reversed walk begins with its loop, if it ran into itself, and ends with the pixel it started from.
    const std::size_t tail = begin + (pixels.size() - loopBehind);
    const std::size_t loopAhead = loopStart(pixels, tail, walk(x, y, true, pixels, deadline));
    const auto keep = [&](std::size_t from, std::size_t to, bool closed) {
      if (to >= from + shortest) {
        m_result.chains.push_back({from, to, closed || endsMeet(pixels, from, to)});
      }
    };
    const std::size_t count = m_result.chains.size();
    keep(begin, tail, true);
    keep(tail, loopAhead, false);
    keep(loopAhead, pixels.size(), true);
    if (m_result.chains.size() == count) {
      pixels.resize(begin);
    }
  }

  // Whether the gradient has a local maximum at (x, y) across the edge.
  bool isRidge(int x, int y) const
  {
    const GradientVector vector = m_gradient.at(x, y);
    const int here = vector.squared();
    if (std::abs(vector.dx) >= std::abs(vector.dy)) {
      return here >= m_gradient.squaredMagnitude(x - 1, y) && here > m_gradient.squaredMagnitude(x + 1, y);
    }
    return here >= m_gradient.squaredMagnitude(x, y - 1) && here > m_gradient.squaredMagnitude(x, y + 1);
  }

  // No other chain starts on the two pixels beside an edge pixel, across the edge.
  void markBeside(std::size_t place)
  {
    const GradientVector here = m_gradient.vectors[place];
    const auto across = static_cast<std::ptrdiff_t>(std::abs(here.dx) >= std::abs(here.dy) ? 1 : m_width);
    for (const std::ptrdiff_t step : {-across, across}) {
      const auto other = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(place) + step);
      const GradientVector there = m_gradient.vectors[other];
      std::uint8_t &mark = m_result.visited[other];
      if (mark == 0 && there.dx * here.dx + there.dy * here.dy > 0) {
        mark = beside;
      }
    }
  }

private:
  const Gradient &m_gradient;
  EdgeChains &m_result;
  int m_width;
  int m_least;
  std::array<std::ptrdiff_t, 8> m_steps; // from a pixel to its neighbours, in the order of their angle
};
} // namespace

void linkEdgeChains(const Gradient &gradient, std::size_t shortest, EdgeChains &result, const Deadline &deadline)
{
  const auto width = static_cast<std::size_t>(gradient.width);
  result.pixels.clear();
  result.chains.clear();
  result.visited.assign(gradient.vectors.size(), 0);
  constexpr std::size_t atOnce = 4; // pixels whose two bytes fill a word
  result.strong.assign((width + atOnce - 1) / atOnce * atOnce * 2, 0);
  Linker linker(gradient, result);
  const int start = gradient.startAt * gradient.startAt;
  const auto leastComponent = static_cast<short>(std::min(gradient.startAt * M_SQRT1_2, 32767.));
  for (int y = 1; y < gradient.height - 1 && !deadline.hasPassed(); y += rowsApart) {
    markStrong(gradient.vectors.data() + gradient.index(0, y), width, leastComponent, result.strong.data());
    for (std::size_t first = 0; first < width; first += atOnce) {
      if (noneOfEight(result.strong.data() + 2 * first)) {
        continue;
      }
      for (std::size_t i = first; i < std::min(first + atOnce, width); ++i) {
        const int x = static_cast<int>(i);
        const std::size_t place = gradient.index(x, y);
        if (result.visited[place] == 0 && gradient.vectors[place].squared() >= start && linker.isRidge(x, y)) {
          linker.linkThrough(x, y, shortest, deadline);
        }
      }
    }
  }
}
} // namespace circle_marker
END_VISP_NAMESPACE
