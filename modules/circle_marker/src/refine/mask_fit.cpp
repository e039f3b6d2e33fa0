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
 * Fit of an unsharp mask to pixels near a ring.
 */

#include "refine/mask_fit.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>

#include "support/normal_distribution.h"
#include "support/sensor_range.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Where the fit of the mask starts, pixels: a sharp lens, and what most cameras do.
constexpr double startBlur = 0.7;
constexpr double startSigma = 1.5;
// The blur is no less than half of what the area of a pixel makes, and no more than what leaves a halo to be seen.
constexpr double leastBlur = 0.15;
constexpr double mostBlur = 4.;
// Widths of masks that are tried, pixels: beyond those that are one.
constexpr double leastSigma = 0.25;
constexpr double mostSigma = 10.;
constexpr int mostSteps = 15;
constexpr double settled = 1e-4; // change of the sum of squares by a step, share of it
// Samples that are off by more than this, standard deviations, show something else; they are left out once.
constexpr double oddResidual = 3.5;
// Share of black through a Gaussian and its derivatives.
struct Darkness
{
  double value;
  double byGrowth; // 1 / pixel
  double byScale;  // by the logarithm of the Gaussian's standard deviation
};

Darkness darknessThrough(double blur, double growth, const RingSample &sample)
{
  const NormalDistribution &normal = NormalDistribution::instance();
  const double outer = (growth - sample.toOuter) / blur;
  const double inner = -(growth + sample.toInner) / blur;
  const NormalDistribution::Value atOuter = normal.at(outer);
  const NormalDistribution::Value atInner = normal.at(inner);
  return {atOuter.cumulative - atInner.cumulative, (atOuter.density + atInner.density) / blur,
          inner * atInner.density - outer * atOuter.density};
}

} // namespace

MaskFit::MaskFit(std::vector<RingSample> samples) : m_samples(std::move(samples))
{
  m_theta << 0., 0., 0., 0., 0., 0., std::log(startBlur), std::log(startSigma);
}

bool MaskFit::run()
{
  if (m_samples.size() < 8 * PARAMETERS) {
    return false;
  }
  // The linear ones first.
  linearise(m_theta);
  const Eigen::Matrix<double, linear, linear> matrix = m_matrix.topLeftCorner<linear, linear>();
  m_theta.head<linear>() += matrix.ldlt().solve(m_right.head<linear>());
  improve();
  dropOdd();
  improve();
  return m_theta.allFinite() && m_theta[CONTRAST] > 0.;
}

UnsharpMask MaskFit::mask() const
{
  UnsharpMask result;
  result.amount = m_theta[CONTRAST_TIMES_AMOUNT] / m_theta[CONTRAST];
  result.sigma = std::exp(m_theta[LN_SIGMA]);
  result.white = m_theta[WHITE];
  result.ink = m_theta[WHITE] - m_theta[CONTRAST];
  result.halo = overshootAt(m_theta);
  // What noise leaves unknown; of large rings, of which that is little, what the amount alone is off by: with the first
  // alone the covariance was somewhat too small (testDetectorHalo). No more than all of it: where most grey levels are
  // cut off, the equations may know nothing.
  const double ofAmount = result.halo * errorOfAmount() / result.amount;
  result.error = std::min(std::max(ofAmount, errorOfOvershoot()), result.halo);
  return result;
}

double MaskFit::variance() const
{
  return m_squares / std::max<double>(static_cast<double>(m_samples.size()) - PARAMETERS, 1.);
}

double MaskFit::errorOfAmount() const
{
  const double ofProduct =
      m_matrix.ldlt().solve(Vector::Unit(CONTRAST_TIMES_AMOUNT))[CONTRAST_TIMES_AMOUNT] * variance();
  return std::sqrt(std::max(ofProduct, 0.)) / m_theta[CONTRAST];
}

// Standard deviation of the overshoot, by all parameters that it depends on: a narrower mask of a larger amount leaves
// nearly the same image, and another overshoot.
double MaskFit::errorOfOvershoot() const
{
  Vector gradient = Vector::Zero();
  for (const Parameter parameter : {CONTRAST, CONTRAST_TIMES_AMOUNT, LN_BLUR, LN_SIGMA}) {
    const bool isGrey = parameter == CONTRAST || parameter == CONTRAST_TIMES_AMOUNT;
    const double step = isGrey ? 1e-3 * m_theta[CONTRAST] : 1e-3;
    const Vector change = step * Vector::Unit(parameter);
    gradient[parameter] = (overshootAt(m_theta + change) - overshootAt(m_theta - change)) / (2. * step);
  }
  return std::sqrt(std::max(0., gradient.dot(m_matrix.ldlt().solve(gradient)) * variance())); // 0 of what is no number
}

// By how much the image of a lone edge goes beyond black, share of the contrast.
double MaskFit::overshootAt(const Vector &theta)
{
  const double amount = theta[CONTRAST_TIMES_AMOUNT] / theta[CONTRAST];
  const double blur = std::exp(theta[LN_BLUR]);
  const double wider = std::hypot(blur, std::exp(theta[LN_SIGMA]));
  const NormalDistribution &normal = NormalDistribution::instance();
  double most = 0.;
  for (double x = 0.; x < 2. * wider; x += 0.1 * wider) {
    most =
        std::max(most, (1. + amount) * normal.at(x / blur).cumulative - amount * normal.at(x / wider).cumulative - 1.);
  }
  return most;
}

// Residual of a sample; and its derivative, with the other sign. A grey level that was cut off tells where it is not
// reached.
double MaskFit::residualOf(const RingSample &sample, const Vector &theta, Vector &row)
{
  const double blur = std::exp(theta[LN_BLUR]);
  const double sigma = std::exp(theta[LN_SIGMA]);
  const double wider = std::hypot(blur, sigma);
  const Darkness sharp = darknessThrough(blur, theta[GROWTH], sample);
  const Darkness wide = darknessThrough(wider, theta[GROWTH], sample);
  const double contrast = theta[CONTRAST] + theta[CONTRAST_TIMES_AMOUNT]; // of the sharp one
  row << 1., sample.offset.x(), sample.offset.y(), -sharp.value, wide.value - sharp.value,
      -contrast * sharp.byGrowth + theta[CONTRAST_TIMES_AMOUNT] * wide.byGrowth,
      -contrast * sharp.byScale + theta[CONTRAST_TIMES_AMOUNT] * wide.byScale * blur * blur / (wider * wider),
      theta[CONTRAST_TIMES_AMOUNT] * wide.byScale * sigma * sigma / (wider * wider);
  const double residual = sample.grey - row.head<linear>().dot(theta.head<linear>());
  if ((mayBeTooBright(sample.grey) && residual < 0.) || (mayBeTooDark(sample.grey) && residual > 0.)) {
    row.setZero();
    return 0.;
  }
  return residual;
}

void MaskFit::linearise(const Vector &theta)
{
  m_matrix.setZero();
  m_right.setZero();
  m_squares = 0.;
  Vector row;
  for (const RingSample &sample : m_samples) {
    const double residual = residualOf(sample, theta, row);
    m_matrix.selfadjointView<Eigen::Lower>().rankUpdate(row);
    m_right += residual * row;
    m_squares += residual * residual;
  }
  m_matrix = m_matrix.selfadjointView<Eigen::Lower>();
}

void MaskFit::improve()
{
  double damping = 1e-3;
  linearise(m_theta);
  for (int step = 0; step < mostSteps; ++step) {
    const Matrix matrix = m_matrix;
    const Vector right = m_right;
    const double before = m_squares;
    Matrix damped = matrix;
    damped.diagonal() *= 1. + damping;
    damped.diagonal().array() += 1e-9 * matrix.trace();
    Vector trial = m_theta + damped.ldlt().solve(right);
    trial[LN_BLUR] = std::clamp(trial[LN_BLUR], std::log(leastBlur), std::log(mostBlur));
    trial[LN_SIGMA] = std::clamp(trial[LN_SIGMA], std::log(leastSigma), std::log(mostSigma));
    linearise(trial);
    if (m_squares <= before) {
      m_theta = trial;
      damping *= 0.1;
      if (before - m_squares < settled * before) {
        return;
      }
    }
    else {
      m_matrix = matrix;
      m_right = right;
      m_squares = before;
      damping *= 10.;
    }
  }
}

void MaskFit::dropOdd()
{
  Vector row;
  const double most = oddResidual * std::sqrt(m_squares / static_cast<double>(m_samples.size()));
  m_samples.erase(
      std::remove_if(m_samples.begin(), m_samples.end(),
                     [&](const RingSample &sample) { return std::abs(residualOf(sample, m_theta, row)) > most; }),
      m_samples.end());
}
} // namespace circle_marker
END_VISP_NAMESPACE
