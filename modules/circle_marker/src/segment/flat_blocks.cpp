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
 * The flattest parts of an image.
 */

#include "segment/flat_blocks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "support/sensor_range.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Blocks of so many pixels' side are asked how flat they are, so many of them at most, evenly over the image; with
// fewer than the least the flattest of them are flat by chance.
constexpr int sideOfBlock = 8;
constexpr int pixelsOfBlock = sideOfBlock * sideOfBlock;
constexpr std::size_t mostBlocks = 256;
constexpr std::size_t leastBlocks = 30;
// The share of blocks that is taken for flat, since photographs seldom have more of them.
constexpr double flatShare = 0.1;
// With edges in this share of the blocks a frame is full of them.
constexpr double edgeShare = 0.2;
// Of how many blocks they are the flattest is counted by those that differ from them by no more than this many standard
// deviations of chance, and again, in some rounds, with what that has told.
constexpr double mostChance = 2.;
constexpr int rounds = 3;
// By how much the variance of other flat blocks is more than that of the flattest tenth at most: where nine pixels
// share their noise nine in ten have less.
constexpr double mostOfFlattest = 4.;
// Where texture fills the image but for a few sheets of paper a tenth is not flat. This many blocks are, if they have
// less of the tenth's variance than this: of noise that 16 pixels share they have an eighth of it and more.
constexpr std::size_t fewBlocks = 3;
constexpr double leastOfTenth = 1. / 16.;
static_assert(fewBlocks <= flatShare * leastBlocks, "the few are a part of the tenth");
// And if they have any noise, here its variance, grey levels^2, 0.45 squared: blocks that JPEG has left nothing of, and
// drawings beside a photograph, tell nothing of the noise elsewhere.
constexpr double leastOfFew = 0.2;
// Pixels that share their noise share it with so many others at most: the quarters of a block tell no more.
constexpr double mostSharing = 16.;
// So many flat blocks are asked how alike their neighbouring pixels are: of independent noise they tell 0 +- 0.025.
constexpr std::size_t blocksOfLikeness = 32;

/*! What a block of the image is, besides the plane that is nearest to its grey levels. */
struct Block
{
  double variance = 0.;   // of its pixels, grey levels^2
  double ofQuarters = 0.; // of the means of its quarters
  unsigned int top = 0;   // where it begins
  unsigned int left = 0;
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
  return Block{std::max(squares - mean - slope, 0.) / (pixelsOfBlock - 3), across, top, left};
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

// Variance of the differences of pixels of a block that are so many apart, half the sum of both directions: of
// independent noise twice that of a pixel.
double varianceOfDifferences(const vpImage<unsigned char> &I, const Block &block, int apart)
{
  const int count = sideOfBlock * (sideOfBlock - apart);
  int alongU = 0;
  int alongV = 0;
  int squares = 0;
  for (int y = 0; y < sideOfBlock; ++y) {
    const unsigned char *row = I[block.top + static_cast<unsigned int>(y)] + block.left;
    for (int x = 0; x + apart < sideOfBlock; ++x) {
      const int difference = row[x + apart] - row[x];
      alongU += difference;
      squares += difference * difference;
    }
  }
  for (int y = 0; y + apart < sideOfBlock; ++y) {
    const unsigned char *row = I[block.top + static_cast<unsigned int>(y)] + block.left;
    const unsigned char *below = I[block.top + static_cast<unsigned int>(y + apart)] + block.left;
    for (int x = 0; x < sideOfBlock; ++x) {
      const int difference = below[x] - row[x];
      alongV += difference;
      squares += difference * difference;
    }
  }
  // Less those of a plane.
  const double ofPlane = (static_cast<double>(alongU) * alongU + static_cast<double>(alongV) * alongV) / count;
  return 0.5 * (squares - ofPlane) / count;
}

// See FlatBlocks, of the first blocks that have no more than a variance.
double likenessOf(const vpImage<unsigned char> &I, const std::array<Block, mostBlocks> &blocks, std::size_t count,
                  double most)
{
  double variance = 0.;
  double difference = 0.;
  std::size_t asked = 0;
  for (std::size_t k = 0; k < count && asked < blocksOfLikeness; ++k) {
    if (blocks[k].variance <= most) {
      variance += blocks[k].variance;
      difference += varianceOfDifferences(I, blocks[k], 2) - varianceOfDifferences(I, blocks[k], 1);
      ++asked;
    }
  }
  return 0.5 * difference / variance;
}

// Quantile of a normal distribution, by Tukey's lambda distribution that is nearest to it: within 0.003 from 0.1 to
// 0.9.
double normalQuantile(double probability)
{
  constexpr double lambda = 0.135;
  return (std::pow(probability, lambda) - std::pow(1. - probability, lambda)) / 0.1975;
}

// Variance of the pixels of flat blocks, as the flattest have less by chance, the more so the more pixels share their
// noise, and the more flat blocks there are.
double varianceOfFlat(const std::array<Block, mostBlocks> &blocks, std::size_t count, double flattest, double sharing)
{
  // Quantiles of chi^2 / n by Wilson and Hilferty (Proceedings of the National Academy of Sciences 17, 1931).
  const double perFreedom = 2. / 9. * sharing / (pixelsOfBlock - 3);
  const auto byChance = [&](double deviations) {
    return std::pow(1. - perFreedom + deviations * std::sqrt(perFreedom), 3.);
  };
  double share = 1.; // of the blocks that are flat
  double variance = flattest / byChance(normalQuantile(flatShare));
  for (int round = 0; round < rounds; ++round) {
    const auto end = blocks.begin() + static_cast<std::ptrdiff_t>(count);
    const double most = byChance(mostChance) * variance;
    const auto flat = std::count_if(blocks.begin(), end, [&](const Block &block) { return block.variance <= most; });
    share = std::clamp(static_cast<double>(flat) / static_cast<double>(count), 2. * flatShare, share);
    variance = flattest / byChance(normalQuantile(flatShare / share));
  }
  return variance;
}
} // namespace

std::optional<FlatBlocks> findFlatBlocks(const vpImage<unsigned char> &I)
{
  std::array<Block, mostBlocks> blocks;
  const std::size_t count = blocksOf(I, blocks);
  if (count < leastBlocks) {
    return std::nullopt;
  }
  const auto first = blocks.begin();
  const auto end = first + static_cast<std::ptrdiff_t>(count);
  const auto few = first + (fewBlocks - 1);
  const auto tenth = first + static_cast<std::ptrdiff_t>(flatShare * static_cast<double>(count));
  const auto middle = first + static_cast<std::ptrdiff_t>(count / 2);
  const auto isFlatter = [](const Block &p, const Block &q) { return p.variance < q.variance; };
  const auto upper = first + static_cast<std::ptrdiff_t>((1. - edgeShare) * static_cast<double>(count));
  std::nth_element(first, upper, end, isFlatter);
  std::nth_element(first, middle, upper, isFlatter);
  std::nth_element(first, tenth, middle, isFlatter);
  std::nth_element(first, few, tenth, isFlatter);

  FlatBlocks flat;
  flat.medianVariance = middle->variance;
  flat.upperVariance = upper->variance;
  if (few->variance >= leastOfFew && few->variance < leastOfTenth * tenth->variance) {
    flat.variance = few->variance;
    return flat;
  }
  Block sum;
  for (auto block = first; block != end; ++block) {
    if (block->variance <= mostOfFlattest * tenth->variance) {
      sum.variance += block->variance;
      sum.ofQuarters += block->ofQuarters;
    }
  }
  if (sum.variance == 0.) {
    return flat;
  }
  flat.likeness = likenessOf(I, blocks, count, mostOfFlattest * tenth->variance);
  flat.sharing = std::clamp(0.25 * pixelsOfBlock * sum.ofQuarters / sum.variance, 1., mostSharing);
  flat.variance = varianceOfFlat(blocks, count, tenth->variance, flat.sharing);
  return flat;
}
} // namespace circle_marker
END_VISP_NAMESPACE
