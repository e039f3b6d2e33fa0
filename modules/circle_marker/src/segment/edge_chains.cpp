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
#include <cstdlib>
#include <optional>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// The eight neighbours in the order of their angle from +x toward +y.
constexpr int stepX[8] = {1, 1, 0, -1, -1, -1, 0, 1};
constexpr int stepY[8] = {0, 1, 1, 1, 0, -1, -1, -1};
// Two neighbouring pixels of one edge differ in gradient direction by less than 60 degrees (cos^2 = 1/4), even on the
// tightest bend of a small oblique ring; the two edges of a thin line differ by 180.
constexpr double leastSquaredCosine = 0.25;
// A loop of fewer pixels than this is noise, and a chain closes on its start within this many pixels.
constexpr int closingDistance = 2;
// Marks of EdgeChains::visited.
constexpr std::uint8_t walked = 1;
constexpr std::uint8_t beside = 2;

// Octant of a direction: 0 for +x, 2 for +y, and so on.
int octant(int x, int y)
{
  const int ax = std::abs(x);
  const int ay = std::abs(y);
  if (5 * ay < 2 * ax) { // tan 22.5 degrees = 0.414
    return x > 0 ? 0 : 4;
  }
  if (5 * ax < 2 * ay) {
    return y > 0 ? 2 : 6;
  }
  if (x > 0) {
    return y > 0 ? 1 : 7;
  }
  return y > 0 ? 3 : 5;
}

class Linker
{
public:
  Linker(const Gradient &gradient, EdgeChains &result)
      : m_gradient(gradient), m_result(result), m_width(gradient.dx.cols), m_height(gradient.dx.rows),
        m_least(gradient.continueAbove * gradient.continueAbove)
  {
  }

  // Walks from (x, y), excluded, along the edge; forward has the bright side on the left. Returns the pixel of an
  // earlier walk, or of its own, that it ran into.
  std::optional<EdgePixel> walk(int x, int y, bool forward, std::vector<EdgePixel> &out)
  {
    while (true) {
      const int gx = m_gradient.dx.at<short>(y, x);
      const int gy = m_gradient.dy.at<short>(y, x);
      // The gradient (to the bright side) turned by a quarter: with v down, (-gy, gx) has it on the left.
      const int ahead = forward ? octant(-gy, gx) : octant(gy, -gx);
      int best = -1;
      int strongest = m_least - 1;
      for (int turn = -1; turn <= 1; ++turn) {
        const int direction = (ahead + turn + 8) & 7;
        const int nx = x + stepX[direction];
        const int ny = y + stepY[direction];
        if (nx < 1 || ny < 1 || nx >= m_width - 1 || ny >= m_height - 1) {
          continue;
        }
        const int hx = m_gradient.dx.at<short>(ny, nx);
        const int hy = m_gradient.dy.at<short>(ny, nx);
        const int magnitude = hx * hx + hy * hy;
        if (magnitude > strongest && sameDirection(gx, gy, hx, hy)) {
          strongest = magnitude;
          best = direction;
        }
      }
      if (best < 0) {
        return std::nullopt;
      }
      x += stepX[best];
      y += stepY[best];
      std::uint8_t &mark = m_result.visited[index(x, y)];
      if (mark == walked) {
        return EdgePixel{static_cast<short>(x), static_cast<short>(y)};
      }
      mark = walked;
      markBeside(x, y);
      out.push_back({static_cast<short>(x), static_cast<short>(y)});
    }
  }

  // Whether the gradient has a local maximum at (x, y) across the edge.
  bool isRidge(int x, int y, int gx, int gy) const
  {
    const int here = gx * gx + gy * gy;
    if (std::abs(gx) >= std::abs(gy)) {
      return here >= m_gradient.squaredMagnitude(x - 1, y) && here > m_gradient.squaredMagnitude(x + 1, y);
    }
    return here >= m_gradient.squaredMagnitude(x, y - 1) && here > m_gradient.squaredMagnitude(x, y + 1);
  }

  std::size_t index(int x, int y) const
  {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) + static_cast<std::size_t>(x);
  }

  // No other chain starts on the two pixels beside an edge pixel, across the edge.
  void markBeside(int x, int y)
  {
    const bool acrossIsHorizontal = std::abs(m_gradient.dx.at<short>(y, x)) >= std::abs(m_gradient.dy.at<short>(y, x));
    for (int side = -1; side <= 1; side += 2) {
      const int bx = acrossIsHorizontal ? x + side : x;
      const int by = acrossIsHorizontal ? y : y + side;
      std::uint8_t &mark = m_result.visited[index(bx, by)];
      const int dot = m_gradient.dx.at<short>(by, bx) * m_gradient.dx.at<short>(y, x) +
                      m_gradient.dy.at<short>(by, bx) * m_gradient.dy.at<short>(y, x);
      if (mark == 0 && dot > 0) {
        mark = beside;
      }
    }
  }

private:
  static bool sameDirection(int ax, int ay, int bx, int by)
  {
    const double dot = static_cast<double>(ax) * bx + static_cast<double>(ay) * by;
    const double squares = (static_cast<double>(ax) * ax + static_cast<double>(ay) * ay) *
                           (static_cast<double>(bx) * bx + static_cast<double>(by) * by);
    return dot > 0. && dot * dot > leastSquaredCosine * squares;
  }

  const Gradient &m_gradient;
  EdgeChains &m_result;
  int m_width;
  int m_height;
  int m_least;
};
} // namespace

namespace {
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
} // namespace

void linkEdgeChains(const Gradient &gradient, std::size_t shortest, EdgeChains &result)
{
  const int width = gradient.dx.cols;
  const int height = gradient.dx.rows;
  result.pixels.clear();
  result.chains.clear();
  result.visited.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
  Linker linker(gradient, result);
  const int start = gradient.startAt * gradient.startAt;
  for (int y = 1; y < height - 1; ++y) {
    const short *rowX = gradient.dx.ptr<short>(y);
    const short *rowY = gradient.dy.ptr<short>(y);
    for (int x = 1; x < width - 1; ++x) {
      const int gx = rowX[x];
      const int gy = rowY[x];
      if (gx * gx + gy * gy < start || result.visited[linker.index(x, y)] != 0 || !linker.isRidge(x, y, gx, gy)) {
        continue;
      }
      result.visited[linker.index(x, y)] = walked;
      linker.markBeside(x, y);
      const std::size_t begin = result.pixels.size();
      result.pixels.push_back({static_cast<short>(x), static_cast<short>(y)});
      const std::size_t loopBehind = loopStart(result.pixels, begin, linker.walk(x, y, false, result.pixels));
      std::reverse(result.pixels.begin() + static_cast<std::ptrdiff_t>(begin), result.pixels.end());
      // The reversed walk begins with its loop, if it ran into itself, and ends with the pixel it started from.
      const std::size_t tail = begin + (result.pixels.size() - loopBehind);
      const std::size_t loopAhead = loopStart(result.pixels, tail, linker.walk(x, y, true, result.pixels));
      const auto keep = [&](std::size_t from, std::size_t to, bool closed) {
        if (to >= from + shortest) {
          result.chains.push_back({from, to, closed || endsMeet(result.pixels, from, to)});
        }
      };
      const std::size_t count = result.chains.size();
      keep(begin, tail, true);
      keep(tail, loopAhead, false);
      keep(loopAhead, result.pixels.size(), true);
      if (result.chains.size() == count) {
        result.pixels.resize(begin);
      }
    }
  }
}
} // namespace circle_marker
END_VISP_NAMESPACE
