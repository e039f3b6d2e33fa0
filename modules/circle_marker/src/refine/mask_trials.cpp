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
 * Masks of a camera that sharpens, as they were tried, and what lies between them.
 */

#include "refine/mask_trials.h"

#include <algorithm>

#include <Eigen/Cholesky>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// What a mask adds at the frequency of exp(-0.3 sigma^2), 0.77 rad a pixel, is its strength: there the masks that leave
// nearly the same image, narrow ones of a large amount and wide ones of a small one, are alike.
constexpr double ofStrength = 0.3;
// Amounts beyond this are no camera's.
constexpr double mostAmount = 6.;
// Steps of the coordinates: of the strength, share of it, and of the width, ln.
constexpr double unitOfStrength = 0.3;
constexpr double unitOfWidth = 0.35;

double attenuationOf(double sigma)
{
  return 1. - std::exp(-ofStrength * sigma * sigma);
}
} // namespace

Eigen::Vector2d placeOf(double amount, double sigma)
{
  return {amount * attenuationOf(sigma), std::log(sigma)};
}

UnsharpMask maskOf(const Eigen::Vector2d &place)
{
  UnsharpMask mask;
  mask.sigma = std::exp(place[1]);
  mask.amount = place[0] / attenuationOf(mask.sigma);
  return mask;
}

double mostStrengthOf(double lnSigma)
{
  return mostAmount * attenuationOf(std::exp(lnSigma));
}

bool MaskTrials::add(const MaskTrial &trial)
{
  m_trials.push_back(trial);
  const bool isBetter = trial.left < best().left;
  if (isBetter) {
    m_best = m_trials.size() - 1;
  }
  return isBetter;
}

const MaskTrial *MaskTrials::at(const Eigen::Vector2d &place) const
{
  const auto *const found =
      std::find_if(m_trials.begin(), m_trials.end(), [&](const MaskTrial &trial) { return trial.place == place; });
  return found != m_trials.end() ? found : nullptr;
}

bool MaskTrials::isNear(const Eigen::Vector2d &place, double share) const
{
  return std::any_of(m_trials.begin(), m_trials.end(), [&](const MaskTrial &trial) {
    return (place - trial.place).cwiseQuotient(units()).norm() < share;
  });
}

Eigen::Vector2d MaskTrials::units() const
{
  return {unitOfStrength * best().place[0], unitOfWidth};
}

// Where a trial is, from the best one, in units(). No mask is so at any width.
Eigen::Vector2d MaskTrials::offBest(const MaskTrial &trial) const
{
  Eigen::Vector2d off = (trial.place - best().place).cwiseQuotient(units());
  if (trial.place[0] == 0.) {
    off[1] = 0.;
  }
  return off;
}

// Its weight in what is fitted: the less the farther it is from the best one.
double MaskTrials::weightOf(const MaskTrial &trial) const
{
  return std::pow(best().left / trial.left, 2.) / (1. + offBest(trial).squaredNorm());
}

std::optional<MaskTrials::Surface> MaskTrials::surface() const
{
  constexpr int coefficients = 6;
  Eigen::Matrix<double, coefficients, coefficients> matrix =
      1e-9 * Eigen::Matrix<double, coefficients, coefficients>::Identity();
  Eigen::Matrix<double, coefficients, 1> right = Eigen::Matrix<double, coefficients, 1>::Zero();
  int known = 0;
  for (const MaskTrial &trial : m_trials) {
    if (!std::isfinite(trial.left)) {
      continue;
    }
    const Eigen::Vector2d d = offBest(trial);
    Eigen::Matrix<double, coefficients, 1> row;
    row << 1., d[0], d[1], 0.5 * d[0] * d[0], d[0] * d[1], 0.5 * d[1] * d[1];
    matrix += weightOf(trial) * row * row.transpose();
    right += weightOf(trial) * trial.left * row;
    ++known;
  }
  if (known < coefficients) {
    return std::nullopt;
  }
  const Eigen::Matrix<double, coefficients, 1> c = matrix.ldlt().solve(right);
  Surface result;
  result.slope = c.segment<2>(1);
  result.curvature << c[3], c[4], c[4], c[5];
  return result;
}

Eigen::Matrix<double, 6, 2> MaskTrials::poseSlope() const
{
  Eigen::Matrix3d matrix = 1e-9 * Eigen::Matrix3d::Identity();
  Eigen::Matrix<double, 3, 6> right = Eigen::Matrix<double, 3, 6>::Zero();
  for (const MaskTrial &trial : m_trials) {
    if (trial.pose) {
      Eigen::Vector3d row;
      row << 1., offBest(trial);
      matrix += weightOf(trial) * row * row.transpose();
      right += weightOf(trial) * row * trial.pose->transpose();
    }
  }
  return matrix.ldlt().solve(right).bottomRows<2>().transpose();
}
} // namespace circle_marker
END_VISP_NAMESPACE
