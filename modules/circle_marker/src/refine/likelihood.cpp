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
#include <cmath>

#include <Eigen/Cholesky>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Tukey's constant for 95 % efficiency with normal noise.
constexpr double tukey = 4.685;
// Ratio of a normal distribution's standard deviation to its median absolute value.
constexpr double sigmaOfMedian = 1.4826;
// The noise is measured on pixels that see less than this share of the surround.
constexpr double cleanSurround = 0.005;
// A print that stands out by less than this, grey levels, is none; rounding alone never gives as much.
constexpr double leastContrast = 0.5;
// Black grows by no more than this, pixels, and is expected to grow by none to this standard deviation.
constexpr double growthPrior = 0.3;

// Row of the Jacobian of the modelled grey level.
ParameterVector gradientOf(const FitPixel &pixel, const Photometry &photometry, const Darkness &darkness)
{
  const double light = photometry.light + photometry.lightGradient.dot(pixel.offset);
  const double reflectance = 1. - photometry.contrast * darkness.value;
  const double byDarkness = -light * photometry.contrast;
  ParameterVector row;
  row.head<poseSize>() = byDarkness * darkness.byPose;
  row[lightAt] = reflectance;
  row.segment<2>(gradientAt) = reflectance * pixel.offset;
  row[contrastAt] = -light * darkness.value;
  row[sigmaAt] = byDarkness * darkness.bySigma;
  row[growthAt] = byDarkness * darkness.byGrowth;
  return row;
}

} // namespace

double residualOf(const FitPixel &pixel, const Photometry &photometry, double darkness)
{
  const double light = photometry.light + photometry.lightGradient.dot(pixel.offset);
  return pixel.grey - light * (1. - photometry.contrast * darkness);
}

double shareOfKnown(const FitPixel &pixel, const Photometry &photometry, double noise)
{
  const double surround = 0.5 * photometry.light * pixel.surround;
  return noise * noise / (noise * noise + surround * surround);
}

Loss biweight(double residual, double noise)
{
  const double bound = tukey * noise;
  const double u = residual / bound;
  if (std::abs(u) >= 1.) {
    return {bound * bound / 3., 0.};
  }
  const double kept = 1. - u * u;
  return {bound * bound / 3. * (1. - kept * kept * kept), kept * kept};
}

Likelihood::Likelihood(const std::vector<FitPixel> &pixels, const MarkerPattern &pattern, const FitSettings &settings)
    : m_pixels(pixels), m_pattern(pattern), m_settings(settings)
{
}

bool Likelihood::startPhotometry(const MarkerPlane &plane, Photometry &photometry) const
{
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  for (std::size_t i = 0; i < m_pixels.size(); ++i) {
    const FitPixel &pixel = m_pixels[i];
    const double darkness = darknessAt(pixel.model, plane, m_pattern, photometry.blur).value;
    const Eigen::Vector4d row(1., pixel.offset.x(), pixel.offset.y(), -darkness);
    matrix.noalias() += row * row.transpose();
    right += pixel.grey * row;
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
  Equations equations;
  m_trial.clear();
  for (std::size_t i = 0; i < m_pixels.size(); ++i) {
    const FitPixel &pixel = m_pixels[i];
    const Darkness darkness = darknessAt(pixel.model, plane, m_pattern, photometry.blur);
    const double residual = residualOf(pixel, photometry, darkness.value);
    m_trial.push_back(residual);
    const Loss loss = biweight(residual, noise);
    const double known = shareOfKnown(pixel, photometry, noise);
    equations.cost += known * loss.cost;
    const double weight = known * loss.weight;
    equations.weight += weight;
    equations.squares += weight * residual * residual;
    if (weight > 0.) {
      const ParameterVector row = gradientOf(pixel, photometry, darkness);
      for (int column = 0; column < parameters; ++column) {
        const double factor = weight * row[column];
        for (int line = column; line < parameters; ++line) {
          equations.matrix(line, column) += factor * row[line];
        }
        equations.right[column] += factor * residual;
      }
    }
  }
  equations.matrix = equations.matrix.selfadjointView<Eigen::Lower>();
  constrain(plane, photometry, noise, equations);
  return equations;
}

double Likelihood::noiseAt(const MarkerPlane &plane, const Photometry &photometry)
{
  m_residuals.clear();
  for (std::size_t i = 0; i < m_pixels.size(); ++i) {
    const double darkness = darknessAt(m_pixels[i].model, plane, m_pattern, photometry.blur).value;
    m_residuals.push_back(residualOf(m_pixels[i], photometry, darkness));
  }
  return noiseOfResiduals();
}

double Likelihood::noiseOfResiduals()
{
  m_absolute.clear();
  for (std::size_t k = 0; k < m_residuals.size(); ++k) {
    if (m_pixels[k].surround < cleanSurround) {
      m_absolute.push_back(std::abs(m_residuals[k]));
    }
  }
  if (m_absolute.empty()) {
    return HUGE_VAL;
  }
  const auto middle = m_absolute.begin() + static_cast<std::ptrdiff_t>(m_absolute.size() / 2);
  std::nth_element(m_absolute.begin(), middle, m_absolute.end());
  return std::max(sigmaOfMedian * *middle, quantisation);
}

double Likelihood::costOfResiduals(const Photometry &photometry, double noise) const
{
  double cost = priorCost(photometry, noise);
  for (std::size_t k = 0; k < m_residuals.size(); ++k) {
    cost += shareOfKnown(m_pixels[k], photometry, noise) * biweight(m_residuals[k], noise).cost;
  }
  return cost;
}

double Likelihood::correlation(const Photometry &photometry, double noise) const
{
  double n = 0., x = 0., y = 0., xx = 0., xy = 0., yy = 0.;
  for (std::size_t k = 0; k < m_residuals.size(); ++k) {
    const FitPixel &pixel = m_pixels[k];
    const double model = pixel.grey - m_residuals[k];
    const double w = biweight(m_residuals[k], noise).weight * shareOfKnown(pixel, photometry, noise);
    n += w;
    x += w * model;
    y += w * pixel.grey;
    xx += w * model * model;
    xy += w * model * pixel.grey;
    yy += w * pixel.grey * pixel.grey;
  }
  const double denominator = std::sqrt((n * xx - x * x) * (n * yy - y * y));
  return denominator > 0. ? (n * xy - x * y) / denominator : 0.;
}

double Likelihood::inliers(double noise) const
{
  double sum = 0.;
  for (const double residual : m_residuals) {
    sum += biweight(residual, noise).weight;
  }
  return sum / static_cast<double>(m_residuals.size());
}

double Likelihood::priorCost(const Photometry &photometry, double noise) const
{
  const double u = photometry.blur.growth / growthPrior;
  return m_settings.growth ? noise * noise * u * u : 0.;
}

// Prior on the growth of black; parameters that are not fitted are taken out of the equations, and a 1 (or for the
// spin, something of the other angles' size) on the diagonal keeps them solvable.
void Likelihood::constrain(const MarkerPlane &plane, const Photometry &photometry, double noise,
                           Equations &equations) const
{
  if (m_settings.growth) {
    const double weight = noise * noise / (growthPrior * growthPrior);
    equations.matrix(growthAt, growthAt) += weight;
    equations.right[growthAt] -= weight * photometry.blur.growth;
    equations.cost += priorCost(photometry, noise);
  }
  else {
    equations.matrix.row(growthAt).setZero();
    equations.matrix.col(growthAt).setZero();
    equations.matrix(growthAt, growthAt) = 1.;
    equations.right[growthAt] = 0.;
  }
  if (!m_settings.spinIsKnown) {
    const Eigen::Vector3d normal = plane.rotation.col(2);
    const Eigen::Matrix3d withoutSpin = Eigen::Matrix3d::Identity() - normal * normal.transpose();
    const double size = equations.matrix.block<3, 3>(3, 3).trace() + 1.;
    equations.matrix.middleRows<3>(3) = (withoutSpin * equations.matrix.middleRows<3>(3)).eval();
    equations.matrix.middleCols<3>(3) = (equations.matrix.middleCols<3>(3) * withoutSpin).eval();
    equations.matrix.block<3, 3>(3, 3) += size * normal * normal.transpose();
    equations.right.segment<3>(3) = (withoutSpin * equations.right.segment<3>(3)).eval();
  }
}
} // namespace circle_marker
END_VISP_NAMESPACE
