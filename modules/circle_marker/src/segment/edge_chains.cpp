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

#include "support/prefetch.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// The eight neighbours in the order of their angle from +x toward +y.
constexpr int stepX[8] = {1, 1, 0, -1, -1, -1, 0, 1};
constexpr int stepY[8] = {0, 1, 1, 1, 0, -1, -1, -1};
// Two neighbouring pixels of one edge differ in gradient direction by less than 60 degrees (cos^2 = 1/4), even on the
// tightest bend of a small oblique ring; the two edges of a thin line differ by 180.
constexpr std::int64_t leastSquaredCosineInverse = 4;
// A chain closes on its start within this many pixels.
constexpr int closingDistance = 2;
// Bits of EdgeChains::visited.
constexpr std::uint8_t noStart = 1; // no chain starts here any more: one has passed here or beside
constexpr std::uint8_t walked = 2;  // one has passed here
// How far ahead of a walk, steps, memory is asked for: each row of a large image is on another page, and what is not in
// the nearest caches takes as long as five to ten steps.
constexpr std::ptrdiff_t stepsToPrefetch = 8;

// Sectors of the direction of an edge: of each quadrant three, nearer than 22.5 degrees to the one axis, between, or
// nearer to the other.
constexpr int kinds = 3;
constexpr int sectors = 4 * kinds;

// Sector of the direction of an edge whose gradient is given. Without a branch: edges turn all the time, and a branch
// that the processor cannot foresee takes longer than the rest of a step.
int sectorAlong(const GradientVector &gradient)
{
  const int ax = std::abs(static_cast<int>(gradient.dx));
  const int ay = std::abs(static_cast<int>(gradient.dy));
  const int kind = 1 - static_cast<int>(5 * ay < 2 * ax) + static_cast<int>(5 * ax < 2 * ay); // tangent 0.414
  return kind + kinds * (static_cast<int>(gradient.dx > 0) + 2 * static_cast<int>(gradient.dy > 0));
}

// The octant that a sector of sectorAlong() is a piece of: 0 for +x, 2 for +y, and so on.
int octantOf(int sector)
{
  // The gradient turned by a quarter: with v down, (-gy, gx) has it on the left.
  static constexpr int octants[2][2][kinds] = {{{6, 7, 0}, {2, 1, 0}}, {{6, 5, 4}, {2, 3, 4}}};
  return octants[sector / (2 * kinds)][sector / kinds % 2][sector % kinds];
}

int dotOf(const GradientVector &p, const GradientVector &q)
{
  return p.dx * q.dx + p.dy * q.dy;
}

// Whether two gradients are of one edge.
bool areOneEdge(const GradientVector &here, const GradientVector &next)
{
  const std::int64_t dot = dotOf(here, next);
  return dot > 0 && dot * dot * leastSquaredCosineInverse > static_cast<std::int64_t>(here.squared()) * next.squared();
}

class Linker
{
public:
  Linker(const Gradient &gradient, EdgeChains &result)
      : m_gradient(gradient), m_result(result), m_width(gradient.width), m_start(gradient.startAt * gradient.startAt),
        m_least(std::max(gradient.continueAbove * gradient.continueAbove, 1))
  {
    for (std::size_t i = 0; i < m_ahead.size(); ++i) {
      const int behind = i < sectors ? 4 : 0;
      for (int turn = 0; turn < 3; ++turn) {
        const int neighbour = (octantOf(static_cast<int>(i % sectors)) + behind + turn + 7) % 8;
        m_ahead[i].places[turn] = static_cast<std::ptrdiff_t>(stepY[neighbour]) * m_width + stepX[neighbour];
        m_ahead[i].steps[turn] = {static_cast<short>(stepX[neighbour]), static_cast<short>(stepY[neighbour])};
      }
    }
    m_result.pixels.resize(m_result.pixels.capacity()); // room to write into, not to append to
  }

  ~Linker() { m_result.pixels.resize(m_count); }

  Linker(const Linker &) = delete;
  Linker &operator=(const Linker &) = delete;

  // Links the edge through a pixel, in both directions, and keeps the chains that are long enough.
  void linkThrough(int x, int y, std::size_t shortest, const Deadline &deadline)
  {
    const std::size_t place = m_gradient.index(x, y);
    m_result.visited[place] |= walked | noStart;
    markBeside(m_gradient.vectors.data() + place, m_result.visited.data() + place);
    const std::size_t begin = m_count;
    append({static_cast<short>(x), static_cast<short>(y)});
    const std::size_t loopBehind = loopStart(begin, walk(x, y, false, deadline));
    std::vector<EdgePixel> &pixels = m_result.pixels;
    std::reverse(pixels.begin() + static_cast<std::ptrdiff_t>(begin),
                 pixels.begin() + static_cast<std::ptrdiff_t>(m_count));
    // The reversed walk begins with its loop, if it ran into itself, and ends with the pixel it started from.
    const std::size_t tail = begin + (m_count - loopBehind);
    const std::size_t loopAhead = loopStart(tail, walk(x, y, true, deadline));
    const auto keep = [&](std::size_t from, std::size_t to, bool closed) {
      if (to >= from + shortest) {
        m_result.chains.push_back({from, to, closed || endsMeet(from, to)});
      }
    };
    const std::size_t count = m_result.chains.size();
    keep(begin, tail, true);
    keep(tail, loopAhead, false);
    keep(loopAhead, m_count, true);
    if (m_result.chains.size() == count) {
      m_count = begin;
    }
  }

  // Whether a chain may start at an index: the gradient is strong enough and has a local maximum there across the edge.
  bool isStart(std::size_t place) const
  {
    const GradientVector *const vector = m_gradient.vectors.data() + place;
    const std::ptrdiff_t across = acrossOf(*vector);
    const int here = vector->squared();
    return (static_cast<int>(here >= m_start) & static_cast<int>(here >= vector[-across].squared()) &
            static_cast<int>(here > vector[across].squared())) != 0;
  }

private:
  /*! The three neighbours ahead of a pixel, from the left to the right. */
  struct Ahead
  {
    std::array<std::ptrdiff_t, 3> places; // indices of the neighbours, from that of the pixel
    std::array<EdgePixel, 3> steps;       // to the neighbours
  };

  void append(const EdgePixel &pixel)
  {
    if (m_count == m_result.pixels.size()) {
      constexpr std::size_t atFirst = 4096; // pixels: a few ordinary edges
      m_result.pixels.resize(std::max(atFirst, 2 * m_count));
    }
    m_result.pixels[m_count++] = pixel;
  }

  // Walks from (x, y), excluded, along the edge; forward has the bright side on the left. Returns the pixel of an
  // earlier walk, or of its own, that it ran into.
  std::optional<EdgePixel> walk(int x, int y, bool forward, const Deadline &deadline)
  {
    constexpr std::size_t stepsAtOnce = 4096; // between two looks at the clock: some 0.1 ms
    const GradientVector *here = m_gradient.vectors.data() + m_gradient.index(x, y);
    std::uint8_t *visited = m_result.visited.data() + m_gradient.index(x, y);
    const Ahead *const aheads = m_ahead.data() + (forward ? sectors : 0);
    GradientVector vector = *here;
    while (true) {
      const Ahead &ahead = aheads[sectorAlong(vector)];
      prefetch(here + stepsToPrefetch * ahead.places[1]);
      prefetch(visited + stepsToPrefetch * ahead.places[1]);
      const int turn = strongestOf(here, ahead, vector);
      if (turn < 0) {
        return std::nullopt;
      }
      here += ahead.places[turn];
      visited += ahead.places[turn];
      x += ahead.steps[turn].x;
      y += ahead.steps[turn].y;
      const EdgePixel pixel = {static_cast<short>(x), static_cast<short>(y)};
      if ((*visited & walked) != 0) {
        return pixel;
      }
      *visited = walked | noStart;
      markBeside(here, visited);
      append(pixel);
      if (m_count % stepsAtOnce == 0 && deadline.hasPassed()) {
        return std::nullopt;
      }
    }
  }

  // Of three neighbours of a pixel the one with the strongest gradient that is of the same edge, the first of equals;
  // -1 if there is none. Takes the pixel's gradient and gives the neighbour's. No step leaves the image: along its
  // border the gradient is zero.
  int strongestOf(const GradientVector *here, const Ahead &ahead, GradientVector &vector) const
  {
    // Without a branch: which it is cannot be foreseen.
    const GradientVector left = here[ahead.places[0]];
    const GradientVector straight = here[ahead.places[1]];
    const GradientVector right = here[ahead.places[2]];
    const int ofLeft = left.squared();
    const int ofStraight = straight.squared();
    const int ofRight = right.squared();
    int turn = ofLeft >= ofStraight ? 0 : 1;
    int most = std::max(ofLeft, ofStraight);
    GradientVector next = ofLeft >= ofStraight ? left : straight;
    turn = most >= ofRight ? turn : 2;
    next = most >= ofRight ? next : right;
    most = std::max(most, ofRight);
    if (most >= m_least && areOneEdge(vector, next)) {
      vector = next;
      return turn; // nearly always
    }
    const GradientVector before = vector;
    turn = -1;
    most = m_least - 1;
    for (int other = 0; other < 3; ++other) {
      next = here[ahead.places[other]];
      if (next.squared() > most && areOneEdge(before, next)) {
        most = next.squared();
        vector = next;
        turn = other;
      }
    }
    return turn;
  }

  // No other chain starts on the two pixels beside an edge pixel, across the edge.
  void markBeside(const GradientVector *here, std::uint8_t *visited) const
  {
    static_assert(noStart == 1, "set by a comparison");
    const GradientVector vector = *here;
    const std::ptrdiff_t across = acrossOf(vector);
    visited[-across] |= static_cast<std::uint8_t>(dotOf(here[-across], vector) > 0);
    visited[across] |= static_cast<std::uint8_t>(dotOf(here[across], vector) > 0);
  }

  // From a pixel to its neighbour along the image axis that crosses the edge more squarely. Without a branch.
  std::ptrdiff_t acrossOf(const GradientVector &vector) const
  {
    const int ax = std::abs(static_cast<int>(vector.dx));
    const int ay = std::abs(static_cast<int>(vector.dy));
    return 1 + static_cast<std::ptrdiff_t>(ax < ay) * (m_width - 1);
  }

  // A walk that ran into one of its own pixels has gone round a loop: index of the loop's first pixel, or the end.
  std::size_t loopStart(std::size_t begin, const std::optional<EdgePixel> &hit) const
  {
    if (hit) {
      for (std::size_t i = begin; i < m_count; ++i) {
        if (m_result.pixels[i].x == hit->x && m_result.pixels[i].y == hit->y) {
          return i;
        }
      }
    }
    return m_count;
  }

  bool endsMeet(std::size_t begin, std::size_t end) const
  {
    const EdgePixel first = m_result.pixels[begin];
    const EdgePixel last = m_result.pixels[end - 1];
    return std::abs(first.x - last.x) <= closingDistance && std::abs(first.y - last.y) <= closingDistance;
  }

  const Gradient &m_gradient;
  EdgeChains &m_result;
  int m_width;
  int m_start;                            // squared magnitude of a pixel that starts a chain
  int m_least;                            // squared magnitude of a pixel that prolongs a chain
  std::size_t m_count = 0;                // pixels of all chains so far
  std::array<Ahead, 2 * sectors> m_ahead; // by the sector of an edge, backward and forward
};

// Pixels whose bytes fill a word, and so many that are passed at once where the gradient is weak: nearly everywhere.
constexpr int pixelsAtOnce = 8;
constexpr int pixelsPassed = 4 * pixelsAtOnce;

// Whether the gradient of none of so many pixels is strong enough to start a chain; without a look at what is visited.
bool isWeak(const std::uint8_t *strong)
{
  const auto wordAt = [&](int word) {
    std::uint64_t marks;
    std::memcpy(&marks, strong + word * pixelsAtOnce, sizeof(marks));
    return marks;
  };
  return (wordAt(0) | wordAt(1) | wordAt(2) | wordAt(3)) == 0;
}

// Whether a chain may start at one of so many pixels.
bool mayStart(const std::uint8_t *strong, const std::uint8_t *visited)
{
  std::uint64_t strongWord;
  std::uint64_t visitedWord;
  std::memcpy(&strongWord, strong, sizeof(strongWord));
  std::memcpy(&visitedWord, visited, sizeof(visitedWord));
  return (strongWord & ~visitedWord) != 0;
}
} // namespace

void linkEdgeChains(const Gradient &gradient, std::size_t shortest, EdgeChains &result, const Deadline &deadline)
{
  result.chains.clear();
  result.visited.assign(gradient.vectors.size(), 0);
  Linker linker(gradient, result);
  for (int y = firstStartRow; y < gradient.height - 1 && !deadline.hasPassed(); y += rowsBetweenStarts) {
    const std::uint8_t *strong = gradient.strong.data() + gradient.strongIndex(y);
    const std::size_t row = gradient.index(0, y);
    const std::uint8_t *visited = result.visited.data() + row;
    for (int first = 0; first < gradient.width; first += pixelsAtOnce) {
      while (first + pixelsPassed <= gradient.width && isWeak(strong + first)) {
        first += pixelsPassed;
      }
      const int count = std::min(pixelsAtOnce, gradient.width - first);
      if (count == pixelsAtOnce && !mayStart(strong + first, visited + first)) {
        continue;
      }
      // Those that may, without a branch; then those that do, which are few.
      std::array<int, pixelsAtOnce> starts;
      std::size_t found = 0;
      for (int x = first; x < first + count; ++x) {
        starts[found] = x;
        found += static_cast<std::size_t>(strong[x] & ~visited[x] & 1);
      }
      for (std::size_t i = 0; i < found; ++i) {
        const int x = starts[i];
        if (linker.isStart(row + static_cast<std::size_t>(x)) && visited[x] == 0) {
          linker.linkThrough(x, y, shortest, deadline);
        }
      }
    }
  }
}

std::int64_t doubledArea(const EdgeChains &edges, const EdgeChain &chain)
{
  std::int64_t area = 0;
  EdgePixel previous = edges.pixels[chain.end - 1];
  for (std::size_t i = chain.begin; i < chain.end; ++i) {
    const EdgePixel here = edges.pixels[i];
    area += previous.x * here.y - previous.y * here.x;
    previous = here;
  }
  return area;
}
} // namespace circle_marker
END_VISP_NAMESPACE
