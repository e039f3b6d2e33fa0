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
 * The noise of an image.
 */

#include "segment/image_noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "support/sensor_range.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Every 8th pixel of every 8th row: 19 thousand samples of a 1280 x 960 image fix the noise to 1 %.
constexpr unsigned int noiseSampling = 8;
// Blocks of so many pixels' side are asked how flat they are, so many of them at most, evenly over the image; with
// fewer than the least the flattest of them are flat by chance.
constexpr int sideOfBlock = 8;
constexpr int pixelsOfBlock = sideOfBlock * sideOfBlock;
constexpr std::size_t mostBlocks = 256;
constexpr std::size_t leastBlocks = 30;
// The share of blocks that is taken for flat, since photographs seldom have more of them, and the quantile of a normal
// distribution that has as much below it.
constexpr double flatShare = 0.1;
constexpr double flatQuantile = -1.2816;
// By how much the variance of other flat blocks is more than that of the flattest tenth at most: where nine pixels
// share their noise nine in ten have less.
constexpr double mostOfFlattest = 4.;
// Pixels that share their noise share it with so many others at most: the quarters of a block tell no more.
constexpr double mostSharing = 16.;
// Noise that pixels share is more than what the Laplacians see by this factor: after demosaicing 1.6 to 4. In
// photographs of cubes with letters all over, whose noise is independent, it was 1.5.
constexpr double clearlyMore = 1.5;
// And more than this, grey levels: on slopes without noise rounding makes waves of 0.29, but at edges it is
// independent.
constexpr double leastShared = 0.45;

// Of noise that is independent from pixel to pixel.
double independentNoise(const vpImage<unsigned char> &I)
{
  constexpr int largest = 16 * 255; // of the absolute response: the weights' absolute values sum to 16
  std::array<int, largest + 1> histogram{};
  int samples = 0;
  for (unsigned int y = 1; y + 1 < I.getHeight(); y += noiseSampling) {
    const unsigned char *above = I[y - 1];
    const unsigned char *here = I[y];
    const unsigned char *below = I[y + 1];
    for (unsigned int x = 1; x + 1 < I.getWidth(); x += noiseSampling) {
      const int response = above[x - 1] - 2 * above[x] + above[x + 1] - 2 * here[x - 1] + 4 * here[x] -
                           2 * here[x + 1] + below[x - 1] - 2 * below[x] + below[x + 1];
      ++histogram[static_cast<std::size_t>(std::abs(response))];
      ++samples;
    }
  }
  int below = 0;
  int median = 0;
  while (median < largest && 2 * (below + histogram[static_cast<std::size_t>(median)]) < samples) {
    below += histogram[static_cast<std::size_t>(median)];
    ++median;
  }
  // Responses are whole numbers: the median is placed inside its own, half a unit to either side (0: to one side), or
  // a noise of one grey level, whose median response is 4, would be known to 12 % only.
  const int here = histogram[static_cast<std::size_t>(median)];
  const double share = here > 0 ? (0.5 * samples - below) / here : 0.;
  const double placed = median > 0 ? median - 0.5 + share : 0.5 * share;
  // The response of unit noise has standard deviation 6; the median of |x| of a normal x is 0.6745 sigma.
  return placed / (6. * 0.6745);
}

/*! What a block of the image is, besides the plane that is nearest to its grey levels. */
struct Block
{
  double variance = 0.;   // of its pixels, grey levels^2
  double ofQuarters = 0.; // of the means of its quarters
};

// Nothing if grey levels of the block are cut off.
std::optional<Block> blockAt(const vpImage<unsigned char> &I, unsigned int top, unsigned int left)
{
  constexpr int half = sideOfBlock / 2;
  // Coordinates are from the block's middle in half pixels: -7, -5 ... 7. Sum of their squares.
  constexpr int squaredCoordinates = pixelsOfBlock * (pixelsOfBlock - 1) / 3;
  std::array<int, 4> quarters{};
  int squares = 0;
  int alongU = 0;
  int alongV = 0;
  int least = 255;
  int most = 0;
  for (int y = 0; y < sideOfBlock; ++y) {
    const unsigned char *row = I[top + static_cast<unsigned int>(y)] + left;
    std::array<int, 2> halves{};
    for (int x = 0; x < sideOfBlock; ++x) {
      const int grey = row[x];
      halves[static_cast<std::size_t>(x / half)] += grey;
      squares += grey * grey;
      alongU += (2 * x + 1 - sideOfBlock) * grey;
      least = std::min(least, grey);
      most = std::max(most, grey);
    }
    alongV += (2 * y + 1 - sideOfBlock) * (halves[0] + halves[1]);
    const auto upper = static_cast<std::size_t>(2 * (y / half));
    quarters[upper] += halves[0];
    quarters[upper + 1] += halves[1];
  }
  if (mayBeTooDark(least) || mayBeTooBright(most)) {
    return std::nullopt;
  }
  const auto square = [](int number) { return static_cast<double>(number) * number; };
  const int sum = quarters[0] + quarters[1] + quarters[2] + quarters[3];
  const double mean = square(sum) / pixelsOfBlock;
  const double slope = (square(alongU) + square(alongV)) / squaredCoordinates;
  // What no plane explains of four quarters: half of this difference varies as the mean of one.
  const double across = square(quarters[0] - quarters[1] - quarters[2] + quarters[3]) / square(2 * half * half);
  return Block{std::max(squares - mean - slope, 0.) / (pixelsOfBlock - 3), across};
}

// The blocks of an image, as many as there are.
std::size_t blocksOf(const vpImage<unsigned char> &I, std::array<Block, mostBlocks> &blocks)
{
  constexpr auto side = static_cast<unsigned int>(sideOfBlock);
  const double pixelsForEach = static_cast<double>(I.getSize()) / mostBlocks;
  const auto stride = std::max(side, static_cast<unsigned int>(std::ceil(std::sqrt(pixelsForEach))));
  std::size_t count = 0;
  for (unsigned int top = 0; top + side <= I.getHeight(); top += stride) {
    for (unsigned int left = 0; left + side <= I.getWidth() && count < blocks.size(); left += stride) {
      if (const auto block = blockAt(I, top, left)) {
        blocks[count++] = *block;
      }
    }
  }
  return count;
}

// Of noise that pixels share; none if the image has no room to tell.
ImageNoise sharedNoise(const vpImage<unsigned char> &I)
{
  std::array<Block, mostBlocks> blocks;
  const std::size_t count = blocksOf(I, blocks);
  if (count < leastBlocks) {
    return {};
  }
  const auto end = blocks.begin() + static_cast<std::ptrdiff_t>(count);
  const auto flattest = blocks.begin() + static_cast<std::ptrdiff_t>(flatShare * static_cast<double>(count));
  std::nth_element(blocks.begin(), flattest, end,
                   [](const Block &p, const Block &q) { return p.variance < q.variance; });
  const double least = flattest->variance;
  Block sum;
  for (auto block = blocks.begin(); block != end; ++block) {
    if (block->variance <= mostOfFlattest * least) {
      sum.variance += block->variance;
      sum.ofQuarters += block->ofQuarters;
    }
  }
  if (sum.variance == 0.) {
    return {};
  }
  ImageNoise noise;
  noise.sharing = std::clamp(0.25 * pixelsOfBlock * sum.ofQuarters / sum.variance, 1., mostSharing);
  // The flattest tenth has less than the others by chance, the more so the more pixels share their noise: the quantile
  // of chi^2 / n by Wilson and Hilferty (Proceedings of the National Academy of Sciences 17, 1931).
  const double perFreedom = 2. / 9. * noise.sharing / (pixelsOfBlock - 3);
  noise.sigma = std::sqrt(least / std::pow(1. - perFreedom + flatQuantile * std::sqrt(perFreedom), 3.));
  return noise;
}
} // namespace

ImageNoise estimateNoise(const vpImage<unsigned char> &I)
{
  const ImageNoise independent = {independentNoise(I), 1.};
  const ImageNoise shared = sharedNoise(I);
  return shared.sigma > std::max(clearlyMore * independent.sigma, leastShared) ? shared : independent;
}
} // namespace circle_marker
END_VISP_NAMESPACE
