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

#include "refine/grey_model.h"
#include "refine/line_model.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
namespace {
// A print that stands out by less than this, grey levels, is none; rounding alone never gives as much.
constexpr double leastContrast = 0.5;
// Black grows by no more than this, pixels, and is expected to grow by none to this standard deviation.
constexpr double growthPrior = 0.3;
// Ink spreads by some 0.1 mm, radii of markers are some 30 to 100 mm.
constexpr double spreadPrior = 0.003;
// Most pictures are not moved; those that are have blurs longer by any amount. So the prior of the elongation is
// Cauchy's, with this scale: a tenth of a pixel of motion hardly shows.
constexpr double elongationPrior = 0.03;
// The paper mostly ends where it may, at a square or, less often, at a circle, or goes on in some directions.
constexpr std::array<double, paperShapes> expectedSurround = {{0.25, 0.5}};
constexpr double surroundPrior = 0.5;
// Steps of a shadow's parameters have this standard deviation at most.
constexpr double shadowPrior = 0.3;
// In the first guess of light and contrast, before the noise is known, a pixel with this variance, grey levels^2, from
// the surround counts half.
constexpr float guessedVariance = 25.f;
// Blocks whose products are summed up at once, so that each sum is loaded and stored once for all of them.
constexpr std::size_t blocksOfGroup = 4;
// Groups whose sums are taken in single precision before they go to double: the depth is a difference of things that
// are known a thousand times better, and of 100 blocks' sums in single precision nothing would be left of it.
constexpr std::size_t groupsToFlush = 8;

// Sums of one pass, direction by direction, in lanes and then in double precision.
class Sums
{
public:
  // used: number of parameters that any pixel depends on, the first ones.
  Sums(std::vector<SumsOfDirection> &sums, std::size_t used) : m_used(used), m_sums(sums)
  {
    m_sums.clear();
    clear();
  }

  // The row of the next block, to be filled in before add().
  RowLanes &row() { return m_rows[m_pending]; }

  void add(const Lanes &residual, const LossLanes &loss, std::size_t direction)
  {
    if (m_pending == 0 && direction != m_direction) {
      flush();
      m_direction = direction;
    }
    const RowLanes &row = m_rows[m_pending];
    RowLanes &weighted = m_weighted[m_pending];
    for (std::size_t i = 0; i < m_used; ++i) {
      weighted[i] = loss.weight * row[i];
      m_lanes[products + i] += weighted[i] * residual;
    }
    m_lanes[costAt] += loss.cost;
    m_lanes[squaresAt] += loss.tells * loss.weight * residual.square();
    m_lanes[keptAt] += loss.tells * loss.kept;
    if (++m_pending == blocksOfGroup) {
      closeGroup();
    }
  }

  Equations equations()
  {
    if (m_pending > 0) {
      for (; m_pending < blocksOfGroup; ++m_pending) {
        for (std::size_t i = 0; i < m_used; ++i) {
          m_rows[m_pending][i].setZero();
          m_weighted[m_pending][i].setZero();
        }
      }
      closeGroup();
    }
    flush();
    SumsOfDirection total = {};
    for (const SumsOfDirection &sums : m_sums) {
      for (std::size_t k = 0; k < sumsOfDirection; ++k) {
        total[k] += sums[k];
      }
    }
    Equations result;
    std::size_t k = 0;
    for (int i = 0; i < parameters; ++i) {
      for (int j = 0; j <= i; ++j) {
        result.matrix(i, j) = total[k++];
        result.matrix(j, i) = result.matrix(i, j);
      }
      result.right[i] = total[static_cast<std::size_t>(products + i)];
    }
    result.cost = total[costAt];
    result.squares = total[squaresAt];
    result.kept = total[keptAt];
    return result;
  }

private:
  static constexpr std::size_t costAt = products + parameters;
  static constexpr std::size_t squaresAt = costAt + 1;
  static constexpr std::size_t keptAt = costAt + 2;

  void clear()
  {
    for (Lanes &lanes : m_lanes) {
      lanes.setZero();
    }
    m_groups = 0;
  }

  void closeGroup()
  {
    std::size_t k = 0;
    for (std::size_t i = 0; i < m_used; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        Lanes sum = m_lanes[k];
        for (std::size_t block = 0; block < blocksOfGroup; ++block) {
          sum += m_weighted[block][i] * m_rows[block][j];
        }
        m_lanes[k++] = sum;
      }
    }
    m_pending = 0;
    if (++m_groups == groupsToFlush) {
      flush();
    }
  }

  void flush()
  {
    if (m_groups == 0) {
      return;
    }
    if (m_direction >= m_sums.size()) {
      m_sums.resize(m_direction + 1);
    }
    SumsOfDirection &sums = m_sums[m_direction];
    for (std::size_t k = 0; k < sumsOfDirection; k += laneCount) {
      const Lanes each = sumOfEach(&m_lanes[k]);
      for (std::size_t i = 0; i < laneCount; ++i) {
        sums[k + i] += static_cast<double>(each[static_cast<std::ptrdiff_t>(i)]);
      }
    }
    clear();
  }

  std::array<Lanes, sumsOfDirection> m_lanes;
  std::array<RowLanes, blocksOfGroup> m_rows;
  std::array<RowLanes, blocksOfGroup> m_weighted;
  const std::size_t m_used;    // parameters
  std::size_t m_pending = 0;   // blocks of the present group
  std::size_t m_groups = 0;    // since the last flush
  std::size_t m_direction = 0; // of the first of them
  std::vector<SumsOfDirection> &m_sums;
};

} // namespace

Likelihood::Likelihood(const MarkerPattern &pattern, const FitSettings &settings, FitMemory &memory)
    : m_pattern(pattern), m_settings(settings), m_memory(memory)
{
}

void Likelihood::setPixels(const std::vector<FitPixel> &pixels, const MarkerPlane &plane, const Photometry &photometry,
                           double noise)
{
  packPixels(pixels, plane, m_pattern, photometry, noise, m_settings.poseError, m_settings.bordersSeen,
             m_memory.blocks);
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
    Lanes paper = Lanes::Ones();
    Lanes print = block.grey;
    if (const SurroundLanes *surround = m_memory.blocks.surroundOf(block)) {
      for (std::size_t shape = 0; shape < paperShapes; ++shape) {
        const Lanes share = static_cast<float>(photometry.surround[shape]) * surround->share[shape];
        paper -= share;
        print -= share * surround->beyond[shape];
      }
    }
    std::array<Lanes, 4> row = {paper, paper * block.offsetU, paper * block.offsetV, -darkness.value};
    if (photometry.shadow) {
      const Lanes share = shadowOf(block, *photometry.shadow).value;
      for (Lanes &lanes : row) {
        lanes = share * lanes;
      }
    }
    for (int i = 0; i < 4; ++i) {
      const Lanes weighted = weight * row[static_cast<std::size_t>(i)];
      for (int j = 0; j < 4; ++j) {
        matrix(i, j) += static_cast<double>((weighted * row[static_cast<std::size_t>(j)]).sum());
      }
      right[i] += static_cast<double>((weighted * print).sum());
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
  const int used = photometry.shadow ? parameters : m_memory.blocks.surrounds.empty() ? surroundAt : shadowAt;
  Sums sums(m_memory.trialSums, static_cast<std::size_t>(used));
  m_memory.trial.clear();
  DarknessLanes darkness;
  std::size_t k = 0;
  PixelSight last = PixelSight::RING;
  forEachBlock(m_memory.blocks, [&](const PixelBlock &block, PixelSight sight) {
    model.evaluate(block, sight, darkness);
    const SurroundLanes *surround = m_memory.blocks.surroundOf(block);
    const GreyLanes grey = greyOf(block, surround, photometry, darkness.value);
    m_memory.trial.push_back(grey.residual);
    LossLanes loss = biweight(grey.residual, block.variance, static_cast<float>(noise));
    const Lanes holds = holdsPixel(block);
    loss.cost *= holds;
    loss.kept *= holds;
    if (grey.isCut) {
      loss.tells *= grey.tells;
    }
    rowOf(block, surround, photometry, darkness, grey, sums.row());
    k = sight == last ? k : 0;
    last = sight;
    const std::size_t direction = m_memory.blocks.direction[static_cast<std::size_t>(sight)][k++];
    // Coherence is not asked for where bends are not corrected: it is for a final fit.
    sums.add(grey.residual, loss, m_settings.exactBends ? direction : 0);
  });
  Equations equations = sums.equations();
  equations.used = used;
  constrain(photometry, noise, equations);
  return equations;
}

void Likelihood::evaluate(const MarkerPlane &plane, const Photometry &photometry)
{
  const ImageModel model(plane, m_pattern, photometry.blur, m_memory.blocks);
  m_memory.residuals.clear();
  DarknessLanes darkness;
  forEachBlock(m_memory.blocks, [&](const PixelBlock &block, PixelSight sight) {
    model.evaluate(block, sight, darkness);
    m_memory.residuals.push_back(greyOf(block, m_memory.blocks.surroundOf(block), photometry, darkness.value).residual);
  });
}

double Likelihood::priorCost(const Photometry &photometry, double noise) const
{
  const double u = m_settings.growth ? photometry.blur.growth / growthPrior : 0.;
  const double v = m_settings.growth ? photometry.blur.spread / spreadPrior : 0.;
  const double w = photometry.blur.elongation.squaredNorm() / (elongationPrior * elongationPrior);
  double cost = u * u + v * v + 2. * std::log1p(w);
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
  // Cauchy's prior as a normal one that becomes weaker with the elongation. Its width makes the step, and goes to the
  // covariance.
  const Eigen::Vector2d &elongation = photometry.blur.elongation;
  const double elongationWeight = 2. * noise * noise / (elongationPrior * elongationPrior + elongation.squaredNorm());
  for (int k = 0; k < 2; ++k) {
    equations.matrix(elongationAt + k, elongationAt + k) += elongationWeight;
    equations.right[elongationAt + k] -= elongationWeight * elongation[k];
  }
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
    const double weightOfSpread = noise * noise / (spreadPrior * spreadPrior);
    equations.matrix(spreadAt, spreadAt) += weightOfSpread;
    equations.right[spreadAt] -= weightOfSpread * photometry.blur.spread;
  }
  else {
    hold(growthAt);
    hold(spreadAt);
  }
  if (!m_settings.spinIsKnown) {
    hold(spinAt);
  }
  // Of a shadow whose edge passes beside the marker not everything is known.
  for (int k = 0; k < shadowSize; ++k) {
    equations.matrix(shadowAt + k, shadowAt + k) += noise * noise / (shadowPrior * shadowPrior);
  }
}
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE
