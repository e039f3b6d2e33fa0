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
 * Image gradient with a threshold that follows the image noise.
 */

#include "segment/gradient.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "support/wider_registers.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// A component of the Sobel gradient sums 12 units of squared weight: its noise is sqrt(12) that of a pixel.
constexpr double sobelNoiseGain = 3.464;
// At 6 and 4 standard deviations a million pixels of pure noise start no chain and seldom prolong one.
constexpr double startSigmas = 6.;
constexpr double continueSigmas = 4.;
// Least steps, in grey levels, worth following in a noise-free image.
constexpr double leastStartStep = 7.;
constexpr double leastContinueStep = 4.;
// Rows that a thread takes at once, and between two looks at the clock: 0.1 ms on 4000 pixels.
constexpr int rowsAtOnce = 64;

// Of a vector that may start a chain one component is at least its length divided by sqrt(2).
short leastComponentOf(const Gradient &gradient)
{
  return static_cast<short>(std::min(gradient.startAt * M_SQRT1_2, 32767.));
}

short sizeOf(short component)
{
  return std::max(component, static_cast<short>(-component));
}

/*! A row of the image with its neighbours. */
struct ThreeRows
{
  const unsigned char *above;
  const unsigned char *here;
  const unsigned char *below;
};

// Columns whose sums are made at once, and stay in the nearest memory.
constexpr int columnsAtOnce = 1024;

// Sums and differences of the three rows, from a column before those that are made at once to one after them: all
// pixels of a row share them with their neighbours, so that each is made once and not for the left, the middle and the
// right.
struct RowSums
{
  std::array<short, columnsAtOnce + 2> smoothed; // above + 2 here + below
  std::array<short, columnsAtOnce + 2> steps;    // below - above
};

VP_CIRCLE_MARKER_WIDER_REGISTERS
void sumRows(const ThreeRows &rows, int count, RowSums &sums)
{
  const auto [above, here, below] = rows;
  short *smoothed = sums.smoothed.data();
  short *steps = sums.steps.data();
  for (int x = 0; x < count; ++x) {
    smoothed[x] = static_cast<short>(above[x] + 2 * here[x] + below[x]);
    steps[x] = static_cast<short>(below[x] - above[x]);
  }
}

// Gradients of pixels of a row. Plain arithmetic in 16 bits and no branch: compilers make vector instructions of it.
VP_CIRCLE_MARKER_WIDER_REGISTERS
void sobelRow(const RowSums &sums, int count, GradientVector *out)
{
  const short *smoothed = sums.smoothed.data();
  const short *steps = sums.steps.data();
  for (int x = 0; x < count; ++x) {
    out[x].dx = static_cast<short>(smoothed[x + 2] - smoothed[x]);
    out[x].dy = static_cast<short>(steps[x] + 2 * steps[x + 1] + steps[x + 2]);
  }
}

// The same, and where chains may start in it.
VP_CIRCLE_MARKER_WIDER_REGISTERS
void sobelRowOfStarts(const RowSums &sums, int count, short least, GradientVector *out, std::uint8_t *strong)
{
  const short *smoothed = sums.smoothed.data();
  const short *steps = sums.steps.data();
  for (int x = 0; x < count; ++x) {
    const short dx = static_cast<short>(smoothed[x + 2] - smoothed[x]);
    const short dy = static_cast<short>(steps[x] + 2 * steps[x + 1] + steps[x + 2]);
    out[x].dx = dx;
    out[x].dy = dy;
    strong[x] = std::max(sizeOf(dx), sizeOf(dy)) >= least ? 1 : 0;
  }
}

// Makes room for the gradient of an image and sets its thresholds by the image's noise.
void prepareGradient(const vpImage<unsigned char> &I, Gradient &gradient, NoiseSource noise)
{
  gradient.width = static_cast<int>(I.getWidth());
  gradient.height = static_cast<int>(I.getHeight());
  gradient.vectors.resize(I.getSize());
  gradient.strong.resize(gradient.strongIndex(gradient.height + 1));
  if (noise == NoiseSource::IMAGE) {
    gradient.noise = estimateNoise(I);
  }
  const double sigma = sobelNoiseGain * gradient.noise.sigma;
  gradient.startAt = static_cast<int>(std::lround(std::max(startSigmas * sigma, sobelStepGain * leastStartStep)));
  gradient.continueAbove =
      static_cast<int>(std::lround(std::max(continueSigmas * sigma, sobelStepGain * leastContinueStep)));
}

// The rows from firstRow to before endRow.
void computeRows(const vpImage<unsigned char> &I, int firstRow, int endRow, Gradient &gradient)
{
  const int width = gradient.width;
  const short least = leastComponentOf(gradient);
  RowSums sums;
  for (int y = firstRow; y < endRow; ++y) {
    const bool hasStarts = y % rowsBetweenStarts == firstStartRow;
    GradientVector *out = gradient.vectors.data() + gradient.index(0, y);
    std::uint8_t *strong = gradient.strong.data() + gradient.strongIndex(y);
    if (y == 0 || y == gradient.height - 1) {
      std::fill(out, out + width, GradientVector{0, 0});
      if (hasStarts) {
        std::fill(strong, strong + width, std::uint8_t{0});
      }
      continue;
    }
    const auto row = static_cast<unsigned int>(y);
    out[0] = {0, 0};
    out[width - 1] = {0, 0};
    if (hasStarts) {
      strong[0] = 0;
      strong[width - 1] = 0;
    }
    for (int x = 1; x < width - 1; x += columnsAtOnce) {
      const int count = std::min(columnsAtOnce, width - 1 - x);
      sumRows({I[row - 1] + x - 1, I[row] + x - 1, I[row + 1] + x - 1}, count + 2, sums);
      if (hasStarts) {
        sobelRowOfStarts(sums, count, least, out + x, strong + x);
      }
      else {
        sobelRow(sums, count, out + x);
      }
    }
  }
}

int bandsOf(const Gradient &gradient)
{
  return (gradient.height + rowsAtOnce - 1) / rowsAtOnce;
}

// One band of rows; zero if there is no time.
void computeBand(const vpImage<unsigned char> &I, int band, const Deadline &deadline, Gradient &gradient)
{
  const int first = band * rowsAtOnce;
  const int end = std::min(first + rowsAtOnce, gradient.height);
  if (!deadline.hasPassed()) {
    computeRows(I, first, end, gradient);
    return;
  }
  const auto begin = gradient.vectors.begin();
  std::fill(begin + static_cast<std::ptrdiff_t>(gradient.index(0, first)),
            begin + static_cast<std::ptrdiff_t>(gradient.index(0, end)), GradientVector{0, 0});
}
} // namespace

void computeGradient(const vpImage<unsigned char> &I, Gradient &gradient, const Deadline &deadline, NoiseSource noise)
{
  prepareGradient(I, gradient, noise);
  for (int band = 0; band < bandsOf(gradient); ++band) {
    computeBand(I, band, deadline, gradient);
  }
}

void computeGradient(const vpImage<unsigned char> &I, Gradient &gradient, Workers &workers, const Deadline &deadline,
                     NoiseSource noise)
{
  prepareGradient(I, gradient, noise);
  workers.run(static_cast<std::size_t>(bandsOf(gradient)),
              [&](std::size_t band, unsigned int) { computeBand(I, static_cast<int>(band), deadline, gradient); });
}
} // namespace circle_marker
END_VISP_NAMESPACE
