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
 * What the residuals of a fit tell: noise, surround, cost, how much is explained.
 */

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Cholesky>

#include "refine/grey_model.h"
#include "refine/light_equations.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
namespace {
// Ratio of a normal distribution's standard deviation to its median absolute value.
constexpr double sigmaOfMedian = 1.4826;
// And to its 80 % quantile.
constexpr double sigmaOfQuantile = 0.7803;
// Quantiles are told from each other within these bounds, grey levels, by so many bisections: to a thousandth, where
// 400 pixels leave 4 %. Noise is never as low as the lower bound, rounding alone makes more.
constexpr float leastQuantile = 0.15f;
constexpr float mostQuantile = 512.f;
constexpr int bisections = 13;
// The share of the surround differs by no less than this from direction to direction, and is not known to differ by
// more.
constexpr double leastUneven = 0.03;
constexpr double mostUneven = 0.3;
// It shows where the surround may change a pixel by more than this many standard deviations of the noise, if there are
// so many of these pixels.
constexpr float clearSpread = 2.f;
constexpr double leastClearPixels = 20.;
// Fewer pixels than this between ink and paper are those of no photograph.
constexpr float fewPixels = 20.f;
// The values of which so many are smaller, and, of the last one, so much of the steepness. Bisections go over all
// values in their order, which is faster than to order them.
std::array<float, 3> quantilesOf(const std::vector<Lanes> &values, const std::vector<Lanes> &steepness,
                                 const std::array<float, 3> &smaller)
{
  std::array<float, 3> low, high, middle;
  low.fill(leastQuantile);
  high.fill(mostQuantile);
  for (int k = 0; k < bisections; ++k) {
    std::array<Lanes, 3> below;
    for (std::size_t i = 0; i < middle.size(); ++i) {
      below[i].setZero();
      middle[i] = std::sqrt(low[i] * high[i]);
    }
    for (std::size_t at = 0; at < values.size(); ++at) {
      below[0] += isPositive(middle[0] - values[at]);
      below[1] += isPositive(middle[1] - values[at]);
      below[2] += isPositive(middle[2] - values[at]) * steepness[at];
    }
    for (std::size_t i = 0; i < middle.size(); ++i) {
      (below[i].sum() > smaller[i] ? high[i] : low[i]) = middle[i];
    }
  }
  return middle;
}
} // namespace

ResidualSpread Likelihood::spreadOfResiduals()
{
  std::vector<Lanes> &sizes = m_memory.sizes;
  std::vector<Lanes> &steepness = m_memory.steepness;
  steepness.resize(m_memory.residuals.size(), Lanes::Ones()); // where it is not known all count alike
  Lanes count, steep;
  // darkest: of the grey levels that count.
  const auto gather = [&](float darkest) {
    sizes.clear();
    count.setZero();
    steep.setZero();
    std::size_t k = 0;
    forEachBlock(m_memory.blocks, [&](const PixelBlock &block, PixelSight) {
      const Lanes counts = isPositive(static_cast<float>(quantisation * quantisation) - block.variance) *
                           isPositive(brightest - block.grey) * isPositive(block.grey - darkest);
      count += counts;
      steep += counts * steepness[k];
      sizes.push_back(m_memory.residuals[k++].abs() + 2.f * mostQuantile * (1.f - counts));
    });
  };
  // What is as bright or as dark as can be tells nothing of the noise; where there is hardly anything else, ink does.
  gather(0.f);
  if (count.sum() < fewPixels) {
    gather(-1.f);
  }
  const float all = count.sum();
  if (all == 0.f) {
    return {HUGE_VAL, HUGE_VAL, HUGE_VAL};
  }
  const std::array<float, 3> quantiles = quantilesOf(sizes, steepness, {0.5f * all, 0.8f * all, 0.5f * steep.sum()});
  return {std::max(static_cast<double>(quantiles[0]) * sigmaOfMedian, quantisation),
          std::max(static_cast<double>(quantiles[1]) * sigmaOfQuantile, quantisation),
          std::max(static_cast<double>(quantiles[2]) * sigmaOfMedian, quantisation)};
}

// With white W, light l, gamma g and ink that leaves r of it a pixel is as bright as G = W (l r)^g: the light moves it
// by G, to a factor, and ink by W l^g - G, nearly. So no model is looked at again.
double Likelihood::bendOfResiduals(const Photometry &photometry, double noise) const
{
  LightEquations<7> equations; // light, its gradient, ink, and light's curvature
  std::size_t k = 0;
  forEachBlock(m_memory.blocks, [&](const PixelBlock &block, PixelSight) {
    const Lanes &residual = m_memory.residuals[k++];
    const Lanes weight = holdsPixel(block) * isPositive(brightest - (block.grey - residual)) *
                         biweight(residual, block.variance, static_cast<float>(noise)).weight;
    const Lanes model = block.grey - residual;
    const Lanes &u = block.offsetU;
    const Lanes &v = block.offsetV;
    const Lanes byU = model * u;
    const Lanes byV = model * v;
    const Lanes ink = whiteOf(block, photometry) - model;
    equations.add({model, byU, byV, ink, byU * u, byU * v, byV * v}, residual, weight);
  });
  const Eigen::Matrix<double, 7, 7> matrix = equations.matrix();
  const Eigen::Matrix<double, 7, 1> right = equations.right();
  const auto light = right.head<4>();
  return right.dot(matrix.ldlt().solve(right)) - light.dot(matrix.topLeftCorner<4, 4>().ldlt().solve(light));
}

double Likelihood::unevenShareOfResiduals(double noise) const
{
  const auto sigma = static_cast<float>(noise);
  double pixels = 0., squares = 0.;
  std::size_t k = 0;
  forEachBlock(m_memory.blocks, [&](const PixelBlock &block, PixelSight) {
    const Lanes &residual = m_memory.residuals[k++];
    const SurroundLanes *surround = m_memory.blocks.surroundOf(block);
    if (surround == nullptr) {
      return;
    }
    const Lanes isClear = isPositive(surround->spread - clearSpread * sigma) * holdsPixel(block);
    const Lanes spread = surround->spread.max(sigma);
    const Lanes excess = ((residual.square() - sigma * sigma) / spread.square()).min(1.f);
    pixels += static_cast<double>(isClear.sum());
    squares += static_cast<double>((isClear * excess).sum());
  });
  if (pixels < leastClearPixels) {
    return mostUneven;
  }
  return std::clamp(std::sqrt(std::max(squares / pixels, 0.)), leastUneven, mostUneven);
}

double Likelihood::costOfResiduals(const MarkerPlane &plane, const Photometry &photometry, double noise) const
{
  double cost = priorCost(plane, photometry, noise);
  std::size_t k = 0;
  forEachBlock(m_memory.blocks, [&](const PixelBlock &block, PixelSight) {
    const LossLanes loss = biweight(m_memory.residuals[k++], block.variance, static_cast<float>(noise));
    cost += static_cast<double>((loss.cost * holdsPixel(block)).sum());
  });
  return cost;
}

Explanation Likelihood::explain(double noise, double lacking) const
{
  // Weights, grey levels of model and image and their products, and inliers. Summed up in lanes: from a grey level in
  // the middle, so that the variances are no small differences of large sums.
  constexpr float middle = 128.f;
  std::array<Lanes, 7> sums;
  for (Lanes &lanes : sums) {
    lanes.setZero();
  }
  std::size_t k = 0;
  forEachBlock(m_memory.blocks, [&](const PixelBlock &block, PixelSight) {
    const Lanes &residual = m_memory.residuals[k++];
    const LossLanes loss = biweight(residual, block.variance, static_cast<float>(noise));
    const Lanes &w = loss.weight;
    const Lanes image = block.grey - middle;
    const Lanes model = image - residual;
    const Lanes wx = w * model;
    const Lanes wy = w * image;
    sums[0] += w;
    sums[1] += wx;
    sums[2] += wy;
    sums[3] += wx * model;
    sums[4] += wx * image;
    sums[5] += wy * image;
    const float scale = static_cast<float>(std::max(noise, lacking));
    sums[6] += biweight(residual, block.variance, scale).kept * holdsPixel(block);
  });
  const auto total = [&sums](std::size_t i) { return static_cast<double>(sums[i].sum()); };
  const double n = total(0), x = total(1), y = total(2), xx = total(3), xy = total(4), yy = total(5);
  const double inliers = total(6);
  const auto pixels =
      static_cast<double>(m_memory.blocks.count[0] + m_memory.blocks.count[1] + m_memory.blocks.count[2]);
  const double denominator = std::sqrt((n * xx - x * x) * (n * yy - y * y));
  return {denominator > 0. ? (n * xy - x * y) / denominator : 0., inliers / std::max(pixels, 1.)};
}
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE
