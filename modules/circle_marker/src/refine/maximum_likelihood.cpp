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

BEGIN_VISP_NAMESPACE
namespace circle_marker
{
namespace
{
constexpr int poseSize = 6;
constexpr int lightAt = 6;
constexpr int gradientAt = 7;
constexpr int contrastAt = 9;
constexpr int sigmaAt = 10;
constexpr int growthAt = 11;
constexpr int parameters = 12;
using Vector = Eigen::Matrix<double, parameters, 1>;
using Matrix = Eigen::Matrix<double, parameters, parameters>;

// Tukey's constant for 95 % efficiency with normal noise.
constexpr double tukey = 4.685;
// Ratio of a normal distribution's standard deviation to its median absolute value.
constexpr double sigmaOfMedian = 1.4826;
// The noise is measured on pixels that see less than this share of the surround.
constexpr double cleanSurround = 0.005;
// Noise of rounding to whole grey levels.
constexpr double quantisation = 0.2887;
// The blur stays between that of the pixel's own area and a twentieth of a metre-wide smear.
constexpr double leastSigma = 0.29;
constexpr double mostSigma = 20.;
// Black grows by no more than this, pixels, and is expected to grow by none to this standard deviation.
constexpr double growthPrior = 0.3;
// A step is the last if it moves no parameter by more than this share of its standard deviation.
constexpr double convergence = 0.02;

struct Equations
{
  Matrix matrix = Matrix::Zero();
  Vector right = Vector::Zero();
  double squares = 0.;
};

double residualOf(const FitPixel &pixel, const Photometry &photometry, double darkness)
{
  const double light = photometry.light + photometry.lightGradient.dot(pixel.offset);
  return pixel.grey - light * (1. - photometry.contrast * darkness);
}

// Row of the Jacobian of the modelled grey level.
Vector gradientOf(const FitPixel &pixel, const Photometry &photometry, const Darkness &darkness)
{
  const double light = photometry.light + photometry.lightGradient.dot(pixel.offset);
  const double reflectance = 1. - photometry.contrast * darkness.value;
  const double byDarkness = -light * photometry.contrast;
  Vector row;
  row.head<poseSize>() = byDarkness * darkness.byPose;
  row[lightAt] = reflectance;
  row.segment<2>(gradientAt) = reflectance * pixel.offset;
  row[contrastAt] = -light * darkness.value;
  row[sigmaAt] = byDarkness * darkness.bySigma;
  row[growthAt] = byDarkness * darkness.byGrowth;
  return row;
}

double median(std::vector<double> &values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

class Fit
{
public:
  Fit(const std::vector<FitPixel> &pixels, const MarkerPattern &pattern, const FitSettings &settings)
    : m_pixels(pixels), m_pattern(pattern), m_settings(settings), m_weights(pixels.size(), 1.)
  { }

  // Light and contrast that explain the image best at the start pose: linear least squares.
  bool startPhotometry(const MarkerPlane &plane, Photometry &photometry) const
  {
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    for (const FitPixel &pixel : m_pixels) {
      const double darkness = darknessAt(pixel.model, plane, m_pattern, photometry.blur).value;
      const Eigen::Vector4d row(1., pixel.offset.x(), pixel.offset.y(), -darkness);
      matrix.noalias() += row * row.transpose();
      right += pixel.grey * row;
    }
    const Eigen::Vector4d solution = matrix.ldlt().solve(right);
    if (!solution.allFinite() || solution[0] <= 0. || solution[3] <= 0.) {
      return false;
    }
    photometry.light = solution[0];
    photometry.lightGradient = solution.segment<2>(1);
    photometry.contrast = std::min(solution[3] / solution[0], 1.);
    return true;
  }

  // Noise from the residuals of the present parameters, and the weights that follow from it.
  double reweight(const MarkerPlane &plane, const Photometry &photometry)
  {
    m_absolute.clear();
    m_residuals.resize(m_pixels.size());
    for (std::size_t i = 0; i < m_pixels.size(); ++i) {
      const double darkness = darknessAt(m_pixels[i].model, plane, m_pattern, photometry.blur).value;
      m_residuals[i] = residualOf(m_pixels[i], photometry, darkness);
      if (m_pixels[i].surround < cleanSurround) {
        m_absolute.push_back(std::abs(m_residuals[i]));
      }
    }
    if (m_absolute.empty()) {
      return HUGE_VAL;
    }
    const double noise = std::max(sigmaOfMedian * median(m_absolute), quantisation);
    for (std::size_t i = 0; i < m_pixels.size(); ++i) {
      const double u = m_residuals[i] / (tukey * noise);
      // What lies beyond the quiet zone differs from white by up to half the light, in either direction.
      const double surround = 0.5 * photometry.light * m_pixels[i].surround;
      const double known = noise * noise / (noise * noise + surround * surround);
      m_weights[i] = std::abs(u) < 1. ? known * (1. - u * u) * (1. - u * u) : 0.;
    }
    return noise;
  }

  Equations normalEquations(const MarkerPlane &plane, const Photometry &photometry, double noise) const
  {
    Equations equations;
    for (std::size_t i = 0; i < m_pixels.size(); ++i) {
      if (m_weights[i] == 0.) {
        continue;
      }
      const Darkness darkness = darknessAt(m_pixels[i].model, plane, m_pattern, photometry.blur);
      const double residual = residualOf(m_pixels[i], photometry, darkness.value);
      const Vector row = gradientOf(m_pixels[i], photometry, darkness);
      equations.matrix.selfadjointView<Eigen::Lower>().rankUpdate(row, m_weights[i]);
      equations.right += m_weights[i] * residual * row;
      equations.squares += m_weights[i] * residual * residual;
    }
    equations.matrix = equations.matrix.selfadjointView<Eigen::Lower>();
    constrain(plane, photometry, noise, equations);
    return equations;
  }

  double weightedSquares(const MarkerPlane &plane, const Photometry &photometry, double noise) const
  {
    double squares = priorSquares(photometry, noise);
    for (std::size_t i = 0; i < m_pixels.size(); ++i) {
      if (m_weights[i] > 0.) {
        const double darkness = darknessAt(m_pixels[i].model, plane, m_pattern, photometry.blur).value;
        const double residual = residualOf(m_pixels[i], photometry, darkness);
        squares += m_weights[i] * residual * residual;
      }
    }
    return squares;
  }

  const std::vector<double> &weights() const { return m_weights; }

private:
  double priorSquares(const Photometry &photometry, double noise) const
  {
    const double u = photometry.blur.growth / growthPrior;
    return m_settings.growth ? noise * noise * u * u : 0.;
  }

  // Prior on the growth of black; parameters that are not fitted are held.
  void constrain(const MarkerPlane &plane, const Photometry &photometry, double noise, Equations &equations) const
  {
    const double hold = 1e6 * (equations.matrix.trace() + 1.);
    if (m_settings.growth) {
      const double weight = noise * noise / (growthPrior * growthPrior);
      equations.matrix(growthAt, growthAt) += weight;
      equations.right[growthAt] -= weight * photometry.blur.growth;
      equations.squares += priorSquares(photometry, noise);
    }
    else {
      equations.matrix(growthAt, growthAt) += hold;
    }
    if (!m_settings.spinIsKnown) {
      const Eigen::Vector3d normal = plane.rotation.col(2);
      equations.matrix.block<3, 3>(3, 3) += hold * normal * normal.transpose();
    }
  }

  const std::vector<FitPixel> &m_pixels;
  const MarkerPattern &m_pattern;
  FitSettings m_settings;
  std::vector<double> m_weights;
  std::vector<double> m_absolute;
  std::vector<double> m_residuals;
};

void applyStep(const Vector &step, MarkerPlane &plane, Photometry &photometry)
{
  plane.center += step.head<3>();
  const Eigen::Vector3d turn = step.segment<3>(3);
  const double angle = turn.norm();
  if (angle > 0.) {
    plane.rotation = Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix() * plane.rotation;
  }
  photometry.light += step[lightAt];
  photometry.lightGradient += step.segment<2>(gradientAt);
  photometry.contrast += step[contrastAt];
  photometry.blur.sigma = std::clamp(photometry.blur.sigma + step[sigmaAt], leastSigma, mostSigma);
  photometry.blur.growth += step[growthAt];
}

// Whether the marker faces the camera and lies in front of it.
bool isVisible(const MarkerPlane &plane)
{
  return plane.center.z() > plane.radius * 0.1 && plane.rotation.col(2).dot(plane.center) > 0.;
}

double correlationOf(const std::vector<FitPixel> &pixels, const std::vector<double> &weights, const FittedPose &fit,
                     const MarkerPattern &pattern)
{
  double n = 0., x = 0., y = 0., xx = 0., xy = 0., yy = 0.;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const double darkness = darknessAt(pixels[i].model, fit.plane, pattern, fit.photometry.blur).value;
    const double model = pixels[i].grey - residualOf(pixels[i], fit.photometry, darkness);
    const double w = weights[i];
    n += w;
    x += w * model;
    y += w * pixels[i].grey;
    xx += w * model * model;
    xy += w * model * pixels[i].grey;
    yy += w * pixels[i].grey * pixels[i].grey;
  }
  const double denominator = std::sqrt((n * xx - x * x) * (n * yy - y * y));
  return denominator > 0. ? (n * xy - x * y) / denominator : 0.;
}
} // namespace

std::optional<FittedPose> fitPose(const std::vector<FitPixel> &pixels, const MarkerPlane &start,
                                  const MarkerPattern &pattern, const FitSettings &settings)
{
  if (pixels.size() < 2 * parameters) {
    return std::nullopt;
  }
  Fit fit(pixels, pattern, settings);
  FittedPose result;
  result.plane = start;
  if (!fit.startPhotometry(result.plane, result.photometry)) {
    return std::nullopt;
  }
  double damping = 1e-3;
  double noise = fit.reweight(result.plane, result.photometry);
  Equations equations = fit.normalEquations(result.plane, result.photometry, noise);
  for (int iteration = 0; iteration < settings.mostIterations; ++iteration) {
    Matrix damped = equations.matrix;
    damped.diagonal() *= 1. + damping;
    const Vector step = damped.ldlt().solve(equations.right);
    if (!step.allFinite()) {
      return std::nullopt;
    }
    MarkerPlane plane = result.plane;
    Photometry photometry = result.photometry;
    applyStep(step, plane, photometry);
    const bool better = isVisible(plane) && photometry.light > 0. &&
                        fit.weightedSquares(plane, photometry, noise) <= equations.squares;
    if (!better) {
      damping = std::max(damping * 10., 1e-4);
      if (damping > 1e6) {
        break;
      }
      continue;
    }
    damping *= 0.1;
    result.plane = plane;
    result.photometry = photometry;
    const bool last = step.dot(equations.matrix * step) < convergence * convergence * noise * noise;
    noise = fit.reweight(result.plane, result.photometry);
    equations = fit.normalEquations(result.plane, result.photometry, noise);
    if (last) {
      break;
    }
  }
  double weight = 0.;
  for (const double w : fit.weights()) {
    weight += w;
  }
  result.inliers = weight / static_cast<double>(pixels.size());
  const double freedom = std::max(weight - parameters, 1.);
  // The biweight shrinks the sum of squares of normal noise by 1.10 per unit of weight at its constant: 0.806 / 0.886.
  constexpr double biweightShrinkage = 0.909;
  result.noise = std::max(std::sqrt(equations.squares / freedom / biweightShrinkage), quantisation);
  const Matrix inverse = equations.matrix.ldlt().solve(Matrix::Identity());
  if (!inverse.allFinite()) {
    return std::nullopt;
  }
  result.covariance = result.noise * result.noise * inverse.topLeftCorner<poseSize, poseSize>();
  result.squares = robustSquares(pixels, result, pattern, result.noise);
  result.correlation = correlationOf(pixels, fit.weights(), result, pattern);
  return result;
}

double robustSquares(const std::vector<FitPixel> &pixels, const FittedPose &fit, const MarkerPattern &pattern,
                     double noise)
{
  const double bound = tukey * noise;
  double squares = 0.;
  for (const FitPixel &pixel : pixels) {
    const double darkness = darknessAt(pixel.model, fit.plane, pattern, fit.photometry.blur).value;
    const double surround = 0.5 * fit.photometry.light * pixel.surround;
    const double known = noise * noise / (noise * noise + surround * surround);
    const double u = std::min(std::abs(residualOf(pixel, fit.photometry, darkness)) / bound, 1.);
    const double kept = 1. - u * u;
    squares += known * bound * bound / 3. * (1. - kept * kept * kept);
  }
  return squares;
}
} // namespace circle_marker
END_VISP_NAMESPACE
