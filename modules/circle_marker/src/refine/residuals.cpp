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
#include <cmath>

#include "refine/grey_model.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
namespace {
// Ratio of a normal distribution's standard deviation to its median absolute value.
constexpr double sigmaOfMedian = 1.4826;
// And to its 80 % quantile.
constexpr double sigmaOfQuantile = 0.7803;
// The share of the surround differs by no less than this from direction to direction, and is not known to differ by
// more.
constexpr double leastUneven = 0.03;
constexpr double mostUneven = 0.3;
// It shows where the surround may change a pixel by more than this many standard deviations of the noise, if there are
// so many of these pixels.
constexpr float clearSpread = 2.f;
constexpr double leastClearPixels = 20.;
} // namespace

ResidualSpread Likelihood::spreadOfResiduals()
{
  std::vector<float> &absolute = m_memory.absolute;
  absolute.resize(laneCount * m_memory.residuals.size() + 1);
  std::size_t count = 0;
  std::size_t k = 0;
  forEachBlock(m_memory.blocks, [&](const PixelBlock &block, PixelSight) {
    const Lanes size = m_memory.residuals[k++].abs();
    for (int lane = 0; lane < laneCount; ++lane) {
      // What is as bright as can be tells nothing of the noise.
      absolute[count] = size[lane];
      const bool counts =
          block.variance[lane] < static_cast<float>(quantisation * quantisation) && block.grey[lane] < brightest;
      count += counts ? 1 : 0;
    }
  });
  if (count == 0) {
    return {HUGE_VAL, HUGE_VAL};
  }
  const auto placeOf = [&](double share) {
    return absolute.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(count));
  };
  const auto end = absolute.begin() + static_cast<std::ptrdiff_t>(count);
  const auto upper = placeOf(0.8);
  std::nth_element(absolute.begin(), upper, end);
  const double wide = static_cast<double>(*upper) * sigmaOfQuantile;
  const auto middle = placeOf(0.5); // it lies below the other
  std::nth_element(absolute.begin(), middle, upper);
  const double median = static_cast<double>(*middle) * sigmaOfMedian;
  return {std::max(median, quantisation), std::max(wide, quantisation)};
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

Explanation Likelihood::explain(double noise) const
{
  double n = 0., x = 0., y = 0., xx = 0., xy = 0., yy = 0., inliers = 0.;
  std::size_t k = 0;
  forEachBlock(m_memory.blocks, [&](const PixelBlock &block, PixelSight) {
    const Lanes &residual = m_memory.residuals[k++];
    const LossLanes loss = biweight(residual, block.variance, static_cast<float>(noise));
    const Lanes &w = loss.weight;
    const Lanes model = block.grey - residual;
    const Lanes wx = w * model;
    const Lanes wy = w * block.grey;
    n += static_cast<double>(w.sum());
    x += static_cast<double>(wx.sum());
    y += static_cast<double>(wy.sum());
    xx += static_cast<double>((wx * model).sum());
    xy += static_cast<double>((wx * block.grey).sum());
    yy += static_cast<double>((wy * block.grey).sum());
    inliers += static_cast<double>((loss.kept * holdsPixel(block)).sum());
  });
  const auto pixels =
      static_cast<double>(m_memory.blocks.count[0] + m_memory.blocks.count[1] + m_memory.blocks.count[2]);
  const double denominator = std::sqrt((n * xx - x * x) * (n * yy - y * y));
  return {denominator > 0. ? (n * xy - x * y) / denominator : 0., inliers / std::max(pixels, 1.)};
}
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE
