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
 * Likelihood of the grey levels around a marker, and its normal equations.
 */

#include "refine/likelihood.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Cholesky>

#include "refine/line_model.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Tukey's constant for 95 % efficiency with normal noise.
constexpr double tukey = 4.685;
// Ratio of a normal distribution's standard deviation to its median absolute value.
constexpr double sigmaOfMedian = 1.4826;
// And to its 80 % quantile.
constexpr double sigmaOfQuantile = 0.7803;
// A print that stands out by less than this, grey levels, is none; rounding alone never gives as much.
constexpr double leastContrast = 0.5;
// Black grows by no more than this, pixels, and is expected to grow by none to this standard deviation.
constexpr double growthPrior = 0.3;
// The paper mostly ends where it may, at a square or, less often, at a circle, or goes on in some directions.
constexpr std::array<double, paperShapes> expectedSurround = {{0.25, 0.5}};
constexpr double surroundPrior = 0.5;
// The share of the surround differs by no less than this from direction to direction, and is not known to differ by
// more.
constexpr double leastUneven = 0.03;
constexpr double mostUneven = 0.3;
// It shows where the surround may change a pixel by more than this many standard deviations of the noise, if there are
// so many of these pixels.
constexpr float clearSpread = 2.f;
constexpr double leastClearPixels = 20.;
// In the first guess of light and contrast, before the noise is known, a pixel with this variance, grey levels^2, from
// the surround counts half.
constexpr float guessedVariance = 25.f;
// Blocks whose sums are taken in single precision before they go to double.
constexpr std::size_t blocksToFlush = 32;

constexpr int products = parameters * (parameters + 1) / 2;

// Weight and loss of a residual.
struct LossLanes
{
  Lanes kept;   // share of the pixel that is not taken for an outlier
  Lanes tells;  // how much the pixel tells of the noise: little if the surround may change it
  Lanes weight; // with that of the noise in what is uncertain of it
  Lanes cost;
};

// Tukey's biweight of residuals with noise and what the surround may add.
LossLanes biweight(const Lanes &residual, const Lanes &variance, float noise)
{
  const float bound = static_cast<float>(tukey * tukey);
  const Lanes perVariance = (noise * noise + variance).inverse();
  const Lanes kept = (1.f - residual.square() * perVariance * (1.f / bound)).max(0.f);
  const Lanes certainty = noise * noise * perVariance;
  return {kept.square(), certainty.square(), certainty * kept.square(),
          noise * noise * bound / 3.f * (1.f - kept.cube())};
}

// 1 for lanes that hold a pixel, else 0.
Lanes holdsPixel(const PixelBlock &block)
{
  return (1e-3f * (noPixel - block.variance)).min(1.f);
}

// Sums of one pass, in lanes and then in double precision.
class Sums
{
public:
  Sums()
  {
    m_total.fill(0.);
    clear();
  }

  void add(const std::array<Lanes, parameters> &row, const Lanes &residual, const LossLanes &loss)
  {
    int k = 0;
    for (int i = 0; i < parameters; ++i) {
      const Lanes weighted = loss.weight * row[static_cast<std::size_t>(i)];
      for (int j = 0; j <= i; ++j) {
        m_lanes[static_cast<std::size_t>(k++)] += weighted * row[static_cast<std::size_t>(j)];
      }
      m_lanes[static_cast<std::size_t>(products + i)] += weighted * residual;
    }
    m_lanes[costAt] += loss.cost;
    m_lanes[squaresAt] += loss.tells * loss.weight * residual.square();
    m_lanes[keptAt] += loss.tells * loss.kept;
    if (++m_blocks == blocksToFlush) {
      flush();
    }
  }

  Equations equations()
  {
    flush();
    Equations result;
    int k = 0;
    for (int i = 0; i < parameters; ++i) {
      for (int j = 0; j <= i; ++j) {
        result.matrix(i, j) = m_total[static_cast<std::size_t>(k++)];
        result.matrix(j, i) = result.matrix(i, j);
      }
      result.right[i] = m_total[static_cast<std::size_t>(products + i)];
    }
    result.cost = m_total[costAt];
    result.squares = m_total[squaresAt];
    result.kept = m_total[keptAt];
    return result;
  }

private:
  static constexpr std::size_t costAt = products + parameters;
  static constexpr std::size_t squaresAt = costAt + 1;
  static constexpr std::size_t keptAt = costAt + 2;
  static constexpr std::size_t size = costAt + 3;

  void clear()
  {
    for (Lanes &lanes : m_lanes) {
      lanes.setZero();
    }
    m_blocks = 0;
  }

  void flush()
  {
    for (std::size_t k = 0; k < size; ++k) {
      m_total[k] += static_cast<double>(m_lanes[k].sum());
    }
    clear();
  }

  std::array<Lanes, size> m_lanes;
  std::array<double, size> m_total;
  std::size_t m_blocks = 0;
};

// Clusters of neighbouring pixels whose pulls on the parameters are compared with what independent noise would give.
constexpr std::size_t clusters = 32;
// Fewer than this, and they tell nothing.
constexpr std::size_t leastClusters = 10;
// The ratio counts if it is above that of independent noise by this many of its standard deviations.
constexpr double clearOfChance = 3.;
// With normal noise, mean of (w r)^2 over that of w for the biweight's weights w.
constexpr double pullOfNoise = 0.6605;

// Calls use(block, sight) for all blocks, in their order.
template <class Use> void forEachBlock(const PixelBlocks &blocks, const Use &use)
{
  for (std::size_t kind = 0; kind < pixelSights; ++kind) {
    for (const PixelBlock &block : blocks.bySight[kind]) {
      use(block, static_cast<PixelSight>(kind));
    }
  }
}

// The grey levels of a block as the model has them.
struct GreyLanes
{
  Lanes light;
  Lanes reflectance;
  Lanes paper; // share of what does not lie beyond the quiet zone
  Lanes residual;
};

GreyLanes greyOf(const PixelBlock &block, const Photometry &photometry, const Lanes &darkness)
{
  GreyLanes grey;
  grey.light = static_cast<float>(photometry.light) + static_cast<float>(photometry.lightGradient.x()) * block.offsetU +
               static_cast<float>(photometry.lightGradient.y()) * block.offsetV;
  const Lanes around = static_cast<float>(photometry.surround[0]) * block.surround[0];
  const Lanes beside = static_cast<float>(photometry.surround[1]) * block.surround[1];
  grey.paper = 1.f - around - beside;
  grey.reflectance = 1.f - static_cast<float>(photometry.contrast) * darkness;
  grey.residual = block.grey - grey.light * grey.reflectance - around * (block.beyond[0] - grey.light) -
                  beside * (block.beyond[1] - grey.light);
  return grey;
}
// Derivatives of a block's grey levels by all parameters.
using RowLanes = std::array<Lanes, parameters>;

void rowOf(const PixelBlock &block, const Photometry &photometry, const DarknessLanes &darkness, const GreyLanes &grey,
           RowLanes &row)
{
  const Lanes byDarkness = -static_cast<float>(photometry.contrast) * grey.light;
  for (std::size_t k = 0; k < poseSize; ++k) {
    row[k] = byDarkness * darkness.byTwist[k];
  }
  const Lanes byLight = grey.reflectance + grey.paper - 1.f;
  row[lightAt] = byLight;
  row[gradientAt] = byLight * block.offsetU;
  row[gradientAt + 1] = byLight * block.offsetV;
  row[contrastAt] = -grey.light * darkness.value;
  row[sigmaAt] = byDarkness * darkness.bySigma;
  row[growthAt] = byDarkness * darkness.byGrowth;
  for (std::size_t shape = 0; shape < paperShapes; ++shape) {
    row[surroundAt + shape] = block.surround[shape] * (block.beyond[shape] - grey.light);
  }
}
} // namespace

Likelihood::Likelihood(const MarkerPattern &pattern, const FitSettings &settings, FitMemory &memory)
    : m_pattern(pattern), m_settings(settings), m_memory(memory)
{
}

void Likelihood::setPixels(const std::vector<FitPixel> &pixels, const MarkerPlane &plane, const Photometry &photometry,
                           double noise)
{
  packPixels(pixels, plane, m_pattern, photometry, noise, m_memory.blocks);
}

bool Likelihood::correct(const MarkerPlane &plane, const Photometry &photometry)
{
  return m_settings.exactBends && correctBends(plane, m_pattern, photometry.blur, m_memory.blocks);
}

bool Likelihood::startPhotometry(const MarkerPlane &plane, Photometry &photometry) const
{
  const ImageModel model(plane, m_pattern, photometry.blur, m_memory.blocks);
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  DarknessLanes darkness;
  forEachBlock(m_memory.blocks, [&](const PixelBlock &block, PixelSight sight) {
    model.evaluate(block, sight, darkness);
    const Lanes weight = guessedVariance / (guessedVariance + block.variance);
    const Lanes around = static_cast<float>(photometry.surround[0]) * block.surround[0];
    const Lanes beside = static_cast<float>(photometry.surround[1]) * block.surround[1];
    const Lanes paper = 1.f - around - beside;
    const std::array<Lanes, 4> row = {paper, paper * block.offsetU, paper * block.offsetV, -darkness.value};
    for (int i = 0; i < 4; ++i) {
      const Lanes weighted = weight * row[static_cast<std::size_t>(i)];
      for (int j = 0; j < 4; ++j) {
        matrix(i, j) += static_cast<double>((weighted * row[static_cast<std::size_t>(j)]).sum());
      }
      right[i] +=
          static_cast<double>((weighted * (block.grey - around * block.beyond[0] - beside * block.beyond[1])).sum());
    }
  });
  const Eigen::Vector4d solution = matrix.ldlt().solve(right);
  if (!solution.allFinite() || solution[0] <= 0. || solution[3] < leastContrast) {
    return false;
  }
  photometry.light = solution[0];
  photometry.lightGradient = solution.segment<2>(1);
  photometry.contrast = std::min(solution[3] / solution[0], 1.);
  return true;
}

Equations Likelihood::linearise(const MarkerPlane &plane, const Photometry &photometry, double noise)
{
  const ImageModel model(plane, m_pattern, photometry.blur, m_memory.blocks);
  Sums sums;
  m_memory.trial.clear();
  DarknessLanes darkness;
  RowLanes row;
  forEachBlock(m_memory.blocks, [&](const PixelBlock &block, PixelSight sight) {
    model.evaluate(block, sight, darkness);
    const GreyLanes grey = greyOf(block, photometry, darkness.value);
    m_memory.trial.push_back(grey.residual);
    LossLanes loss = biweight(grey.residual, block.variance, static_cast<float>(noise));
    const Lanes holds = holdsPixel(block);
    loss.cost *= holds;
    loss.kept *= holds;
    rowOf(block, photometry, darkness, grey, row);
    sums.add(row, grey.residual, loss);
  });
  Equations equations = sums.equations();
  constrain(photometry, noise, equations);
  return equations;
}

double Likelihood::coherence(const MarkerPlane &plane, const Photometry &photometry, double noise) const
{
  const PixelBlocks &blocks = m_memory.blocks;
  const std::size_t count = blocks.bySight[0].size() + blocks.bySight[1].size() + blocks.bySight[2].size();
  const std::size_t blocksOfCluster = (count + clusters - 1) / clusters;
  if (count < leastClusters) {
    return 1.;
  }
  const ImageModel model(plane, m_pattern, photometry.blur, blocks);
  DarknessLanes darkness;
  RowLanes row;
  using PoseMatrix = Eigen::Matrix<double, poseSize, poseSize>;
  PoseMatrix all = PoseMatrix::Zero(), pulls = PoseMatrix::Zero();
  std::array<PoseMatrix, clusters> information;
  std::size_t cluster = 0, k = 0;
  PoseMatrix ofCluster = PoseMatrix::Zero();
  Eigen::Matrix<double, poseSize, 1> pull = Eigen::Matrix<double, poseSize, 1>::Zero();
  const auto close = [&]() {
    all += ofCluster;
    pulls += pull * pull.transpose();
    information[cluster++] = ofCluster;
    ofCluster.setZero();
    pull.setZero();
  };
  forEachBlock(blocks, [&](const PixelBlock &block, PixelSight sight) {
    model.evaluate(block, sight, darkness);
    const GreyLanes grey = greyOf(block, photometry, darkness.value);
    rowOf(block, photometry, darkness, grey, row);
    const LossLanes loss = biweight(grey.residual, block.variance, static_cast<float>(noise));
    for (int i = 0; i < poseSize; ++i) {
      const Lanes weighted = loss.weight * row[static_cast<std::size_t>(i)];
      pull[i] += static_cast<double>((weighted * grey.residual).sum());
      for (int j = 0; j <= i; ++j) {
        ofCluster(i, j) += static_cast<double>((weighted * row[static_cast<std::size_t>(j)]).sum());
        ofCluster(j, i) = ofCluster(i, j);
      }
    }
    if (++k % blocksOfCluster == 0) {
      close();
    }
  });
  if (k % blocksOfCluster != 0) {
    close();
  }
  // The pulls' sum is 0 after the fit, which takes a little away; the share of each cluster in what is known tells how
  // much that is, and how much the ratio varies by chance.
  const int fitted = m_settings.spinIsKnown ? poseSize : spinAt;
  const Eigen::LDLT<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, poseSize, poseSize>> known(
      all.topLeftCorner(fitted, fitted));
  double squaredShares = 0.;
  for (std::size_t i = 0; i < cluster; ++i) {
    const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, poseSize, poseSize> share =
        known.solve(information[i].topLeftCorner(fitted, fitted));
    squaredShares += (share * share).trace() / fitted;
  }
  const double expected = pullOfNoise * noise * noise * (1. - squaredShares);
  const double ratio = known.solve(pulls.topLeftCorner(fitted, fitted)).trace() / (fitted * expected);
  const double byChance = std::sqrt(2. * squaredShares / fitted);
  return ratio > 1. + clearOfChance * byChance ? ratio : 1.;
}

void Likelihood::evaluate(const MarkerPlane &plane, const Photometry &photometry)
{
  const ImageModel model(plane, m_pattern, photometry.blur, m_memory.blocks);
  m_memory.residuals.clear();
  DarknessLanes darkness;
  forEachBlock(m_memory.blocks, [&](const PixelBlock &block, PixelSight sight) {
    model.evaluate(block, sight, darkness);
    m_memory.residuals.push_back(greyOf(block, photometry, darkness.value).residual);
  });
}

ResidualSpread Likelihood::spreadOfResiduals()
{
  std::vector<float> &absolute = m_memory.absolute;
  absolute.clear();
  std::size_t k = 0;
  forEachBlock(m_memory.blocks, [&](const PixelBlock &block, PixelSight) {
    const Lanes &residual = m_memory.residuals[k++];
    for (int lane = 0; lane < laneCount; ++lane) {
      if (block.variance[lane] < static_cast<float>(quantisation * quantisation)) {
        absolute.push_back(std::abs(residual[lane]));
      }
    }
  });
  if (absolute.empty()) {
    return {HUGE_VAL, HUGE_VAL};
  }
  const auto quantile = [&absolute](double share) {
    const auto place = absolute.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(absolute.size()));
    std::nth_element(absolute.begin(), place, absolute.end());
    return static_cast<double>(*place);
  };
  return {std::max(quantile(0.5) * sigmaOfMedian, quantisation),
          std::max(quantile(0.8) * sigmaOfQuantile, quantisation)};
}

double Likelihood::unevenShareOfResiduals(double noise) const
{
  const auto sigma = static_cast<float>(noise);
  double pixels = 0., squares = 0.;
  std::size_t k = 0;
  forEachBlock(m_memory.blocks, [&](const PixelBlock &block, PixelSight) {
    const Lanes &residual = m_memory.residuals[k++];
    const Lanes isClear = (1e30f * (block.spread - clearSpread * sigma)).max(0.f).min(1.f) * holdsPixel(block);
    const Lanes spread = block.spread.max(sigma);
    const Lanes excess = ((residual.square() - sigma * sigma) / spread.square()).min(1.f);
    pixels += static_cast<double>(isClear.sum());
    squares += static_cast<double>((isClear * excess).sum());
  });
  if (pixels < leastClearPixels) {
    return mostUneven;
  }
  return std::clamp(std::sqrt(std::max(squares / pixels, 0.)), leastUneven, mostUneven);
}

double Likelihood::costOfResiduals(const Photometry &photometry, double noise) const
{
  double cost = priorCost(photometry, noise);
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

double Likelihood::priorCost(const Photometry &photometry, double noise) const
{
  const double u = m_settings.growth ? photometry.blur.growth / growthPrior : 0.;
  double cost = u * u;
  for (std::size_t shape = 0; shape < paperShapes; ++shape) {
    const double s = (photometry.surround[shape] - expectedSurround[shape]) / surroundPrior;
    cost += s * s;
  }
  return noise * noise * cost;
}

// Prior on the growth of black; parameters that are not fitted are taken out of the equations, and a 1 on the diagonal
// keeps these solvable.
void Likelihood::constrain(const Photometry &photometry, double noise, Equations &equations) const
{
  const double surroundWeight = noise * noise / (surroundPrior * surroundPrior);
  for (std::size_t shape = 0; shape < paperShapes; ++shape) {
    const int at = surroundAt + static_cast<int>(shape);
    equations.matrix(at, at) += surroundWeight;
    equations.right[at] -= surroundWeight * (photometry.surround[shape] - expectedSurround[shape]);
  }
  equations.cost += priorCost(photometry, noise);
  const auto hold = [&equations](int at) {
    equations.matrix.row(at).setZero();
    equations.matrix.col(at).setZero();
    equations.matrix(at, at) = 1.;
    equations.right[at] = 0.;
  };
  if (m_settings.growth) {
    const double weight = noise * noise / (growthPrior * growthPrior);
    equations.matrix(growthAt, growthAt) += weight;
    equations.right[growthAt] -= weight * photometry.blur.growth;
  }
  else {
    hold(growthAt);
  }
  if (!m_settings.spinIsKnown) {
    hold(spinAt);
  }
}
} // namespace circle_marker
END_VISP_NAMESPACE
