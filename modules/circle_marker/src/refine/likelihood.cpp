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
#include <tuple>

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
  // used: number of parameters that any pixel depends on, the first ones; formsProducts: whether the products for the
  // matrix are wanted.
  Sums(PassSums &sums, std::size_t used, bool formsProducts)
      : m_used(used), m_products(formsProducts ? used * (used + 1) / 2 : 0), m_sums(sums)
  {
    m_sums.pulls.clear();
    if (formsProducts) {
      m_sums.products.clear();
    }
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
      m_pullLanes[i] += weighted[i] * residual;
    }
    m_pullLanes[costAt] += loss.cost;
    m_pullLanes[squaresAt] += loss.tells * loss.weight * residual.square();
    m_pullLanes[keptAt] += loss.tells * loss.kept;
    if (++m_pending == blocksOfGroup) {
      closeGroup();
    }
  }

  // The sums of all directions: the matrix too, if its products are formed.
  void close(Equations &equations)
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
    if (m_products > 0) {
      const ProductSums total = totalOf(m_sums.products);
      std::size_t k = 0;
      for (int i = 0; i < parameters; ++i) {
        for (int j = 0; j <= i; ++j) {
          equations.matrix(i, j) = total[k++];
          equations.matrix(j, i) = equations.matrix(i, j);
        }
      }
    }
    const PullSums total = totalOf(m_sums.pulls);
    for (int i = 0; i < parameters; ++i) {
      equations.right[i] = total[static_cast<std::size_t>(i)];
    }
    equations.cost = total[costAt];
    equations.squares = total[squaresAt];
    equations.kept = total[keptAt];
  }

private:
  static constexpr std::size_t costAt = parameters;
  static constexpr std::size_t squaresAt = costAt + 1;
  static constexpr std::size_t keptAt = costAt + 2;

  template <class Numbers> static Numbers totalOf(const std::vector<Numbers> &all)
  {
    Numbers total = {};
    for (const Numbers &numbers : all) {
      for (std::size_t k = 0; k < numbers.size(); ++k) {
        total[k] += numbers[k];
      }
    }
    return total;
  }

  void clear()
  {
    for (std::size_t k = 0; k < wholeBlocks(m_products); ++k) {
      m_productLanes[k].setZero();
    }
    for (Lanes &lanes : m_pullLanes) {
      lanes.setZero();
    }
    m_groups = 0;
  }

  void closeGroup()
  {
    std::size_t k = 0;
    for (std::size_t i = 0; k < m_products; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        Lanes sum = m_productLanes[k];
        for (std::size_t block = 0; block < blocksOfGroup; ++block) {
          sum += m_weighted[block][i] * m_rows[block][j];
        }
        m_productLanes[k++] = sum;
      }
    }
    m_pending = 0;
    if (++m_groups == groupsToFlush) {
      flush();
    }
  }

  // Adds the first numbers of the lanes to those of a direction.
  template <class Numbers>
  static void addTo(std::vector<Numbers> &all, std::size_t direction, const Lanes *lanes, std::size_t count)
  {
    while (direction >= all.size()) {
      all.push_back(Numbers());
    }
    Numbers &numbers = all[direction];
    for (std::size_t k = 0; k < count; k += laneCount) {
      const Lanes each = sumOfEach(lanes + k);
      for (std::size_t i = 0; i < laneCount; ++i) {
        numbers[k + i] += static_cast<double>(each[static_cast<std::ptrdiff_t>(i)]);
      }
    }
  }

  void flush()
  {
    if (m_groups == 0) {
      return;
    }
    if (m_products > 0) {
      addTo(m_sums.products, m_direction, m_productLanes.data(), m_products);
    }
    addTo(m_sums.pulls, m_direction, m_pullLanes.data(), m_pullLanes.size());
    clear();
  }

  std::array<Lanes, std::tuple_size<ProductSums>::value> m_productLanes;
  std::array<Lanes, std::tuple_size<PullSums>::value> m_pullLanes;
  std::array<RowLanes, blocksOfGroup> m_rows;
  std::array<RowLanes, blocksOfGroup> m_weighted;
  const std::size_t m_used;     // parameters
  const std::size_t m_products; // of these; none if they are not wanted
  std::size_t m_pending = 0;    // blocks of the present group
  std::size_t m_groups = 0;     // since the last flush
  std::size_t m_direction = 0;  // of the first of them
  PassSums &m_sums;
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

void Likelihood::keepResiduals()
{
  m_memory.residuals.swap(m_memory.trial);
  m_memory.sums.pulls.swap(m_memory.trialSums.pulls);
  if (m_trialHasProducts) {
    m_memory.sums.products.swap(m_memory.trialSums.products);
    m_matrix = m_trialMatrix;
  }
}

bool Likelihood::startPhotometry(const MarkerPlane &plane, Photometry &photometry) const
{
  constexpr std::size_t unknowns = 4; // light, its gradient, contrast times light
  const ImageModel model(plane, m_pattern, photometry.blur, m_memory.blocks);
  std::array<Lanes, 2 * laneCount> sums; // lower triangle of the matrix, row by row, and the right-hand side
  for (Lanes &lanes : sums) {
    lanes.setZero();
  }
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
    std::array<Lanes, unknowns> row = {paper, paper * block.offsetU, paper * block.offsetV, -darkness.value};
    if (photometry.shadow) {
      const Lanes share = shadowOf(block, *photometry.shadow).value;
      for (Lanes &lanes : row) {
        lanes = share * lanes;
      }
    }
    std::size_t k = 0;
    for (std::size_t i = 0; i < unknowns; ++i) {
      const Lanes weighted = weight * row[i];
      for (std::size_t j = 0; j <= i; ++j) {
        sums[k++] += weighted * row[j];
      }
      sums[unknowns * (unknowns + 1) / 2 + i] += weighted * print;
    }
  });
  const std::array<Lanes, 2> totals = {sumOfEach(sums.data()), sumOfEach(sums.data() + laneCount)};
  const auto total = [&totals](std::size_t k) {
    return static_cast<double>(totals[k / laneCount][static_cast<std::ptrdiff_t>(k % laneCount)]);
  };
  Eigen::Matrix4d matrix;
  Eigen::Vector4d right;
  std::size_t k = 0;
  for (int i = 0; i < static_cast<int>(unknowns); ++i) {
    for (int j = 0; j <= i; ++j) {
      matrix(i, j) = total(k++);
      matrix(j, i) = matrix(i, j);
    }
    right[i] = total(unknowns * (unknowns + 1) / 2 + static_cast<std::size_t>(i));
  }
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
  return pass(plane, photometry, noise, true);
}

Equations Likelihood::pull(const MarkerPlane &plane, const Photometry &photometry, double noise)
{
  return pass(plane, photometry, noise, false);
}

Equations Likelihood::pass(const MarkerPlane &plane, const Photometry &photometry, double noise, bool formsProducts)
{
  const ImageModel model(plane, m_pattern, photometry.blur, m_memory.blocks);
  Equations equations;
  equations.used = photometry.shadow ? parameters : m_memory.blocks.surrounds.empty() ? surroundAt : shadowAt;
  Sums sums(m_memory.trialSums, static_cast<std::size_t>(equations.used), formsProducts);
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
  sums.close(equations);
  if (formsProducts) {
    m_trialMatrix = equations.matrix;
  }
  else {
    equations.matrix = m_matrix;
  }
  m_trialHasProducts = formsProducts;
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
