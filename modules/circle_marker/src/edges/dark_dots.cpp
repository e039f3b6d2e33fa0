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
 * Small dark dots of an image.
 */

#include "edges/dark_dots.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "support/parabola.h"
#include "support/wider_registers.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Pixels of a row that are looked at together, each with a mark.
constexpr int pixelsAtOnce = 128;
using Marks = std::array<std::uint8_t, pixelsAtOnce>;

// By value: with references, as std::min() has them, compilers make no vector instructions of a loop over bytes.
std::uint8_t lesser(std::uint8_t p, std::uint8_t q)
{
  return p < q ? p : q;
}

std::uint8_t greater(std::uint8_t p, std::uint8_t q)
{
  return p > q ? p : q;
}

// Whether a grey level is less than another one by a rise.
std::uint8_t isDarker(std::uint8_t grey, std::uint8_t other, std::uint8_t rise)
{
  return static_cast<std::uint8_t>(greater(other, grey) - grey) >= rise ? 1 : 0;
}

// Whether any of so many pixels is darker than what is to the left and to the right; mostly none is.
VP_CIRCLE_MARKER_WIDER_REGISTERS
bool isAnyDarkerSideways(const std::uint8_t *row, int count, std::uint8_t rise)
{
  std::uint8_t isAny = 0;
  for (int x = 0; x < count; ++x) {
    isAny |= isDarker(row[x], lesser(greater(row[x - 3], row[x - 2]), greater(row[x + 2], row[x + 3])), rise);
  }
  return isAny != 0;
}

// Marks those that are darker than what is around. Along the diagonals the pixels nearest to two and three pixels away.
VP_CIRCLE_MARKER_WIDER_REGISTERS
void markDarker(const std::uint8_t *row, std::ptrdiff_t width, int count, std::uint8_t rise, Marks &marks)
{
  const std::uint8_t *above1 = row - width;
  const std::uint8_t *above2 = above1 - width;
  const std::uint8_t *above3 = above2 - width;
  const std::uint8_t *below1 = row + width;
  const std::uint8_t *below2 = below1 + width;
  const std::uint8_t *below3 = below2 + width;
  std::uint8_t *out = marks.data();
  for (int x = 0; x < count; ++x) {
    const std::uint8_t left = greater(row[x - 3], row[x - 2]);
    const std::uint8_t right = greater(row[x + 2], row[x + 3]);
    const std::uint8_t upper = greater(above3[x], above2[x]);
    const std::uint8_t lower = greater(below2[x], below3[x]);
    const std::uint8_t upperLeft = greater(above2[x - 2], above1[x - 1]);
    const std::uint8_t upperRight = greater(above2[x + 2], above1[x + 1]);
    const std::uint8_t lowerLeft = greater(below1[x - 1], below2[x - 2]);
    const std::uint8_t lowerRight = greater(below1[x + 1], below2[x + 2]);
    const std::uint8_t straight = lesser(lesser(left, right), lesser(upper, lower));
    const std::uint8_t diagonal = lesser(lesser(upperLeft, upperRight), lesser(lowerLeft, lowerRight));
    out[x] = isDarker(row[x], lesser(straight, diagonal), rise);
  }
}

// Whether a pixel is the darkest of the nine around it, the last one of equals.
bool isDarkest(const std::uint8_t *pixel, std::ptrdiff_t width)
{
  const std::uint8_t grey = *pixel;
  return grey <= pixel[-1] && grey < pixel[1] && grey <= pixel[-width] && grey < pixel[width] &&
         grey <= pixel[-width - 1] && grey <= pixel[-width + 1] && grey < pixel[width - 1] && grey < pixel[width + 1];
}

DarkDot dotAt(const vpImage<unsigned char> &I, int x, int y)
{
  const auto grey = [&](int dx, int dy) { return I[static_cast<unsigned int>(y + dy)][x + dx]; };
  DarkDot dot;
  dot.grey = grey(0, 0);
  dot.place = {x + vertexOfParabola(grey(-1, 0), dot.grey, grey(1, 0)),
               y + vertexOfParabola(grey(0, -1), dot.grey, grey(0, 1))};
  unsigned char brightest = 0;
  for (int dy = -dotReach; dy <= dotReach; ++dy) {
    for (int dx = -dotReach; dx <= dotReach; ++dx) {
      brightest = dx * dx + dy * dy <= dotReach * dotReach ? std::max(brightest, grey(dx, dy)) : brightest;
    }
  }
  dot.depth = brightest - dot.grey;
  return dot;
}
} // namespace

void findDarkDots(const vpImage<unsigned char> &I, int firstRow, int endRow, int rise, std::vector<DarkDot> &dots)
{
  const int width = static_cast<int>(I.getWidth());
  const int first = std::max(firstRow, dotReach);
  const int end = std::min(endRow, static_cast<int>(I.getHeight()) - dotReach);
  const auto least = static_cast<std::uint8_t>(std::clamp(rise, 1, 255));
  Marks marks;
  for (int y = first; y < end; ++y) {
    const std::uint8_t *row = I[static_cast<unsigned int>(y)];
    for (int from = dotReach; from < width - dotReach; from += pixelsAtOnce) {
      const int count = std::min(pixelsAtOnce, width - dotReach - from);
      if (!isAnyDarkerSideways(row + from, count, least)) {
        continue;
      }
      markDarker(row + from, width, count, least, marks);
      for (int i = 0; i < count; ++i) {
        if (marks[static_cast<std::size_t>(i)] != 0 && isDarkest(row + from + i, width)) {
          dots.push_back(dotAt(I, from + i, y));
        }
      }
    }
  }
}
} // namespace circle_marker
END_VISP_NAMESPACE
