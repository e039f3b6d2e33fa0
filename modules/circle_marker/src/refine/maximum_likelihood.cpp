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
 * Maximum-likelihood pose of a marker from the grey levels around its edges.
 */

#include "refine/maximum_likelihood.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "refine/fit_conclusion.h"
#include "refine/fit_preparation.h"
#include "refine/fit_progress.h"
#include "refine/fit_step.h"
#include "refine/grey_model.h"
#include "refine/likelihood.h"
#include "refine/nearly_frontal.h"
#include "refine/resampling_doubt.h"
#include "refine/surround_model.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
namespace {
// The damping of the first step after one that failed. The steps are not damped otherwise: in the marker's frame the
// depth is a difference of well known things, and the least damping of these holds it back.
constexpr double leastDamping = 1e-3;
// Beyond this damping no step lowers the cost: the fit is at its minimum, to rounding.
constexpr double mostDamping = 1e6;
// Relative error of a cost, summed up in single precision.
constexpr double rounding = 1e-6;
// Reweighting alone makes a step too short: the biweight's slope, E[psi'] = 0.762, is less than its mean weight, 0.915.
constexpr double biweightStep = 0.915 / 0.762;
// What a step leaves of the way: by the chance of the weights this share, and by the bend of the edges' profiles as
// much as it moves them, in units of their blur.
constexpr double stepError = 0.2;

// Noise that a fit starts with is that of a coarser one; it is too large if less than this share of it is left.
constexpr double overestimated = 0.8;

// How a fit is after a step.
enum class FitState
{
  GOES_ON,
  ENDED,
  SINGULAR
};

// Fewer pixels do not tell the parameters of a marker, 28 with a shadow: two for each.
constexpr std::size_t fewestPixels = 56;

// A step of the parameters, and where it leads to.
struct Trial
{
  ParameterVector step;
  double size = 0.; // standard deviations, of the step without damping
  MarkerPlane plane;
  Photometry photometry;
  bool isStale = false; // whether the pixels have to be prepared again there
};

// One fit on its way from a start to the likelihood's maximum.
class PoseFit
{
public:
  PoseFit(const std::vector<FitPixel> &pixels, const MarkerPattern &pattern, const FitSettings &settings,
          FitMemory &memory)
      : m_pattern(pattern), m_settings(settings), m_memory(memory), m_likelihood(pattern, settings, memory),
        m_preparation(pixels, settings, m_likelihood, memory), m_race(settings.rival)
  {
  }

  // False if the start explains nothing.
  bool start(const FitStart &start)
  {
    m_result.plane = start.plane;
    if (start.photometry) {
      m_result.photometry = *start.photometry;
    }
    else {
      m_result.photometry.shadow = m_settings.shadow;
      m_preparation.sort(m_result.plane, m_result.photometry, 0.);
      if (!m_likelihood.startPhotometry(m_result.plane, m_result.photometry)) {
        return false;
      }
    }
    m_preparation.prepare(m_result.plane, m_result.photometry, start.noise.value_or(0.));
    if (start.noise) {
      m_noise = *start.noise;
    }
    else {
      m_likelihood.evaluate(m_result.plane, m_result.photometry);
      m_noise = m_likelihood.spreadOfResiduals().wide;
    }
    if (!std::isfinite(m_noise)) {
      return false;
    }
    m_descent = NoiseDescent(start.noise.has_value(), m_settings.isClear);
    linearise(m_result.plane, m_result.photometry);
    return true;
  }

  FitState step()
  {
    const std::optional<Trial> trial = propose();
    if (!trial) {
      return FitState::SINGULAR;
    }
    if (isEnd(*trial)) {
      return end(*trial);
    }
    if (trial->plane.showsFront() && isPrint(trial->photometry) && isTaken(*trial)) {
      // While the noise comes down, all residuals are outliers to the rival's: their cost tells nothing.
      if (m_descent.isDown() && m_race.isLost(m_likelihood, trial->plane, trial->photometry)) {
        return FitState::ENDED;
      }
      if (!m_descent.isOver()) {
        m_noise = m_descent.next(m_likelihood);
        m_equations.cost = m_likelihood.costOfResiduals(trial->plane, trial->photometry, m_noise);
      }
      return FitState::GOES_ON;
    }
    m_damping = std::max(m_damping * 10., leastDamping);
    m_result.isSettled = m_damping > mostDamping;
    return m_result.isSettled ? FitState::ENDED : FitState::GOES_ON;
  }

  std::optional<FittedPose> finish()
  {
    if (!conclude(m_likelihood, m_equations, m_lastStep, m_noise, m_settings, m_result)) {
      return std::nullopt;
    }
    if (m_settings.exactBends && m_settings.noise.isResampled) {
      addResamplingDoubt(m_pattern, m_memory.blocks.reference.unit, m_result);
    }
    if (m_settings.exactBends && isNearlyFrontal(m_result)) {
      tellLeanInformation();
    }
    return m_result;
  }

private:
  // By how much more is known of a larger lean: by the equations of one at which the narrower side is closer to the
  // middle by as much as leaves a pixel of its edge one and a half standard deviations.
  void tellLeanInformation()
  {
    constexpr double mostResidual = 1.5;
    const Photometry &light = m_result.photometry;
    const double radius =
        m_result.plane.radius / (m_result.plane.center.z() * m_memory.blocks.reference.unit);  // pixels
    const double slope = light.tellableContrast() / (std::sqrt(2. * M_PI) * light.blur.sigma); // grey levels a pixel
    const Eigen::Vector2d lean = leanOf(m_result.plane);
    const double more =
        4. * mostResidual * m_noise / (slope * radius); // an edge moves by a quarter of the lean's square
    const Eigen::Vector2d along = lean.norm() > 0. ? Eigen::Vector2d(lean.normalized()) : Eigen::Vector2d::UnitX();
    const MarkerPlane leaning = leaningBy(m_result.plane, std::sqrt(lean.squaredNorm() + more) * along);
    const auto informationOf = [](const Equations &equations) {
      const UsedMatrix matrix = usedPart(equations.matrix, equations.used);
      Eigen::Matrix<double, Eigen::Dynamic, 2, 0, parameters, 2> columns(matrix.rows(), 2);
      columns.setZero();
      columns(3, 0) = columns(4, 1) = 1.;
      matrix.ldlt().solveInPlace(columns);
      return Eigen::Matrix2d(columns.middleRows<2>(3).inverse());
    };
    const Eigen::Matrix2d here = informationOf(m_equations);
    const Eigen::Matrix2d there = informationOf(m_likelihood.linearise(leaning, light, m_noise));
    const Eigen::Matrix3d turned =
        m_result.plane.rotation.transpose() * m_result.covariance.bottomRightCorner<3, 3>() * m_result.plane.rotation;
    const double scale =
        turned.topLeftCorner<2, 2>().inverse().trace() / here.trace(); // by noise, coherence and resampling
    const double byLean = 0.5 * scale * (there - here).trace() / more;
    if (byLean > 0.) {
      m_result.leanInformation = byLean;
    }
  }

  // Nothing if the equations are singular.
  std::optional<Trial> propose() const
  {
    ParameterMatrix damped = m_equations.matrix;
    damped.diagonal() *= 1. + m_damping;
    Trial trial;
    trial.step = solveEquations(damped, m_equations.right, m_equations.used);
    if (!trial.step.allFinite()) {
      return std::nullopt;
    }
    const ParameterVector whole =
        m_damping > 0. ? solveEquations(m_equations.matrix, m_equations.right, m_equations.used) : trial.step;
    trial.size = std::sqrt(whole.dot(m_equations.matrix * whole)) / m_noise;
    trial.plane = m_result.plane;
    trial.photometry = m_result.photometry;
    applyStep(biweightStep * trial.step, trial.plane, trial.photometry);
    trial.isStale = m_preparation.isStale(trial.plane, trial.photometry, m_noise);
    return trial;
  }

  // Whether what a step leaves of the way is too short to be worth another one.
  bool isEnd(const Trial &trial) const
  {
    const double bend =
        outlineMotion(m_result.plane, trial.plane) / (m_memory.blocks.reference.unit * trial.photometry.blur.sigma);
    return !trial.isStale && m_descent.isDown() && trial.size * (stepError + bend) < m_settings.convergence;
  }

  // Takes the last step, without looking; unless the pixels are to be prepared better for it.
  FitState end(const Trial &trial)
  {
    m_result.plane = trial.plane;
    m_result.photometry = trial.photometry;
    m_result.photometry.unevenShare = m_likelihood.unevenShareOfResiduals(m_noise);
    const bool isRough = m_preparation.isRough(m_result.plane, m_result.photometry);
    const ResidualSpread spread = m_likelihood.spreadOfResiduals();
    const double noise = mayHaveNoisyEdges(m_settings) ? std::max(spread.median, spread.steep) : spread.median;
    // Too large: steps are longer than they seemed, and outliers count too much. Too small: edges, which are drawn or
    // printed less well than the paper is even, are outliers.
    const bool isRaised = std::isfinite(noise) && noise * overestimated > m_noise && !m_isRaised;
    if (!isRough && (noise < overestimated * m_noise || isRaised)) {
      m_isRaised = m_isRaised || isRaised;
      m_noise = noise;
      linearise(m_result.plane, m_result.photometry);
      return FitState::GOES_ON;
    }
    if (!isRough) {
      m_lastStep = trial.step;
      m_result.isSettled = true;
      return FitState::ENDED;
    }
    m_noise = std::min(m_noise, noise);
    m_preparation.prepare(m_result.plane, m_result.photometry, m_noise);
    linearise(m_result.plane, m_result.photometry);
    return FitState::GOES_ON;
  }

  // Takes a step if it lowers the cost.
  bool isTaken(const Trial &trial)
  {
    const double unit = m_memory.blocks.reference.unit;
    const bool isNear = m_matrixPlace.servesAt(trial.plane, trial.photometry, trial.size, unit) && m_descent.isOver();
    if (trial.isStale) {
      return isTakenStale(trial);
    }
    const Equations equations = isNear ? m_likelihood.pull(trial.plane, trial.photometry, m_noise)
                                       : m_likelihood.linearise(trial.plane, trial.photometry, m_noise);
    if (!isLower(equations.cost)) {
      return false;
    }
    take(trial);
    m_equations = equations;
    m_likelihood.keepResiduals();
    if (!isNear) {
      m_matrixPlace.set(trial.plane, trial.photometry);
    }
    return true;
  }

  // The same where the pixels are to be prepared again: equations are wanted of those only.
  bool isTakenStale(const Trial &trial)
  {
    if (!isLower(m_likelihood.cost(trial.plane, trial.photometry, m_noise))) {
      return false;
    }
    take(trial);
    m_preparation.prepare(trial.plane, trial.photometry, m_noise);
    linearise(trial.plane, trial.photometry);
    return true;
  }

  bool isLower(double cost) const { return cost <= m_equations.cost * (1. + rounding); }

  void take(const Trial &trial)
  {
    m_result.plane = trial.plane;
    m_result.photometry = trial.photometry;
    m_damping = m_damping > leastDamping ? 0.1 * m_damping : 0.;
  }

  void linearise(const MarkerPlane &plane, const Photometry &photometry)
  {
    m_equations = m_likelihood.linearise(plane, photometry, m_noise);
    m_likelihood.keepResiduals();
    m_matrixPlace.set(plane, photometry);
  }

  const MarkerPattern &m_pattern;
  const FitSettings &m_settings;
  const FitMemory &m_memory;
  Likelihood m_likelihood;
  FitPreparation m_preparation;
  Race m_race;
  NoiseDescent m_descent = NoiseDescent(false);
  MatrixPlace m_matrixPlace;
  Equations m_equations;   // at the result, until the last step
  double m_noise = 0.;     // by which pixels are weighed, grey levels
  bool m_isRaised = false; // whether that has been too small
  double m_damping = 0.;
  ParameterVector m_lastStep = ParameterVector::Zero(); // beyond the equations
  FittedPose m_result;
};
} // namespace

std::optional<FittedPose> fitPose(const std::vector<FitPixel> &pixels, const FitStart &start,
                                  const MarkerPattern &pattern, const FitSettings &settings, FitMemory &memory)
{
  if (pixels.size() < fewestPixels) {
    return std::nullopt;
  }
  PoseFit fit(pixels, pattern, settings, memory);
  if (!fit.start(start)) {
    return std::nullopt;
  }
  FitState state = FitState::GOES_ON;
  for (int iteration = 0; iteration < settings.mostIterations && state == FitState::GOES_ON; ++iteration) {
    if (settings.deadline.hasPassed()) { // a step on the pixels of a large marker takes up to a millisecond
      return std::nullopt;
    }
    state = fit.step();
  }
  return state == FitState::SINGULAR ? std::nullopt : fit.finish();
}

double robustSquares(const std::vector<FitPixel> &pixels, const FittedPose &fit, const MarkerPattern &pattern,
                     const Photometry &surround, double noise, bool exactBends, FitMemory &memory)
{
  FitSettings settings;
  settings.gammaAndSpread = false;
  settings.exactBends = exactBends;
  Likelihood likelihood(pattern, settings, memory);
  if (!likelihood.keepPixels(pixels, fit.plane, surround, noise, 0.)) {
    likelihood.setPixels(pixels, fit.plane, surround, noise);
  }
  likelihood.correct(fit.plane, fit.photometry);
  likelihood.evaluate(fit.plane, fit.photometry);
  return likelihood.costOfResiduals(fit.plane, fit.photometry, noise);
}

void explainPixels(const std::vector<FitPixel> &pixels, const FittedPose &fit, const MarkerPattern &pattern,
                   FitMemory &memory, std::vector<ExplainedPixel> &explained)
{
  FitSettings settings;
  settings.exactBends = false;
  Likelihood likelihood(pattern, settings, memory);
  if (!likelihood.keepPixels(pixels, fit.plane, fit.photometry, fit.noise, 0.)) {
    likelihood.setPixels(pixels, fit.plane, fit.photometry, fit.noise);
  }
  explained.clear();
  const float variance = static_cast<float>(fit.noise * fit.noise);
  const ImageModel model(fit.plane, pattern, fit.photometry.blur, memory.blocks);
  SurroundModel beyond(fit.plane, pattern.paper, fit.photometry, memory.blocks);
  Lanes darkness;
  forEachBlock(memory.blocks, [&](const PixelBlock &block, PixelSight sight) {
    model.evaluate(block, sight, darkness);
    const Lanes fitted = block.grey - greyOf(block, beyond.at(block), fit.photometry, darkness).residual;
    const Lanes weight = holdsPixel(block) * variance / (variance + block.variance);
    for (int lane = 0; lane < laneCount; ++lane) {
      explained.push_back({Eigen::Vector2f(block.offsetU[lane], block.offsetV[lane]), block.grey[lane], fitted[lane],
                           darkness[lane], weight[lane]});
    }
  });
}
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE
