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
namespace circle_marker {
namespace {
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
// A print that stands out by less than this, grey levels, is none; rounding alone never gives as much.
constexpr double leastContrast = 0.5;
// The blur stays between that of the pixel's own area and a twentieth of a metre-wide smear.
constexpr double leastSigma = 0.29;
constexpr double mostSigma = 20.;
// Black grows by no more than this, pixels, and is expected to grow by none to this standard deviation.
constexpr double growthPrior = 0.3;
// The noise is estimated again after each of the first steps; later ones keep it, so that they have one cost to lower.
constexpr int noiseUpdates = 5;
// Below this damping a step is as long as the equations want it: only then a short one means convergence.
constexpr double freeDamping = 0.1;
// Beyond this damping no step lowers the cost: the fit is at its minimum, to rounding.
constexpr double mostDamping = 1e6;

// Normal equations of one pass over the pixels.
struct Equations
{
  Matrix matrix = Matrix::Zero();
  Vector right = Vector::Zero();
  double cost = 0.;    // robust sum of squares, grey levels^2
  double squares = 0.; // weighted sum of squared residuals, grey levels^2
  double weight = 0.;  // sum of the weights
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

// Share of a pixel's information that the unknown surround leaves: what lies beyond the quiet zone differs from white
// by up to half the light, in either direction.
double shareOfKnown(const FitPixel &pixel, const Photometry &photometry, double noise)
{
  const double surround = 0.5 * photometry.light * pixel.surround;
  return noise * noise / (noise * noise + surround * surround);
}

// Tukey's biweight loss of a residual, and the weight with which it enters the normal equations.
struct Loss
{
  double cost;
  double weight;
};

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

class Fit
{
public:
  Fit(const std::vector<FitPixel> &pixels, const MarkerPattern &pattern, const FitSettings &settings)
      : m_pixels(pixels), m_pattern(pattern), m_settings(settings)
  {
  }

  // Light and contrast that explain the image best at the start pose: linear least squares.
  bool startPhotometry(const MarkerPlane &plane, Photometry &photometry) const
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

  // One pass over the pixels.
  Equations linearise(const MarkerPlane &plane, const Photometry &photometry, double noise)
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
        const Vector row = gradientOf(pixel, photometry, darkness);
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

  // The residuals of the last pass are those of the present parameters.
  void keepResiduals() { m_residuals.swap(m_trial); }

  // Noise at the start, where nothing is known of it.
  double noiseAt(const MarkerPlane &plane, const Photometry &photometry)
  {
    m_residuals.clear();
    for (std::size_t i = 0; i < m_pixels.size(); ++i) {
      const double darkness = darknessAt(m_pixels[i].model, plane, m_pattern, photometry.blur).value;
      m_residuals.push_back(residualOf(m_pixels[i], photometry, darkness));
    }
    return noiseOfResiduals();
  }

  // Noise from the median of the residuals kept that see no surround.
  double noiseOfResiduals()
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

  // Cost of the residuals kept at another noise.
  double costOfResiduals(const Photometry &photometry, double noise) const
  {
    double cost = priorCost(photometry, noise);
    for (std::size_t k = 0; k < m_residuals.size(); ++k) {
      cost += shareOfKnown(m_pixels[k], photometry, noise) * biweight(m_residuals[k], noise).cost;
    }
    return cost;
  }

  // Correlation between model and image over the pixels, each with its weight.
  double correlation(const Photometry &photometry, double noise) const
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

  // Share of the pixels that the model explains.
  double inliers(double noise) const
  {
    double sum = 0.;
    for (const double residual : m_residuals) {
      sum += biweight(residual, noise).weight;
    }
    return sum / static_cast<double>(m_residuals.size());
  }

private:
  double priorCost(const Photometry &photometry, double noise) const
  {
    const double u = photometry.blur.growth / growthPrior;
    return m_settings.growth ? noise * noise * u * u : 0.;
  }

  // Prior on the growth of black; parameters that are not fitted are taken out of the equations, and a 1 (or for the
  // spin, something of the other angles' size) on the diagonal keeps them solvable.
  void constrain(const MarkerPlane &plane, const Photometry &photometry, double noise, Equations &equations) const
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

  const std::vector<FitPixel> &m_pixels;
  const MarkerPattern &m_pattern;
  FitSettings m_settings;
  std::vector<double> m_residuals; // of the present parameters
  std::vector<double> m_trial;     // of the last pass
  std::vector<double> m_absolute;
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

// Standard deviation of the noise from the weighted residuals: more efficient than the median.
double noiseOfSquares(const Equations &equations)
{
  // Of normal noise the biweight keeps this share of the mean square at its constant c:
  // (1 - 6 / c^2 + 15 / c^4) / (1 - 2 / c^2 + 3 / c^4).
  constexpr double biweightShrinkage = 0.828;
  const double freedom = std::max(equations.weight - parameters, 1.);
  return std::max(std::sqrt(equations.squares / freedom / biweightShrinkage), quantisation);
}

// Whether the marker faces the camera and lies in front of it.
bool isVisible(const MarkerPlane &plane)
{
  return plane.center.z() > plane.radius * 0.1 && plane.rotation.col(2).dot(plane.center) > 0.;
}

} // namespace

std::optional<FittedPose> fitPose(const std::vector<FitPixel> &pixels, const FitStart &start,
                                  const MarkerPattern &pattern, const FitSettings &settings)
{
  if (pixels.size() < 2 * parameters) {
    return std::nullopt;
  }
  Fit fit(pixels, pattern, settings);
  FittedPose result;
  result.plane = start.plane;
  if (start.photometry) {
    result.photometry = *start.photometry;
  }
  else if (!fit.startPhotometry(result.plane, result.photometry)) {
    return std::nullopt;
  }
  double noise = start.noise ? *start.noise : fit.noiseAt(result.plane, result.photometry);
  Equations equations = fit.linearise(result.plane, result.photometry, noise);
  fit.keepResiduals();
  double damping = 1e-3;
  int accepted = 0;
  for (int iteration = 0; iteration < settings.mostIterations; ++iteration) {
    Matrix damped = equations.matrix;
    damped.diagonal() *= 1. + damping;
    const Vector step = damped.ldlt().solve(equations.right);
    if (!step.allFinite()) {
      return std::nullopt;
    }
    const double size = step.dot(equations.matrix * step) / (noise * noise);
    if (damping < freeDamping && size < settings.convergence * settings.convergence) {
      applyStep(step, result.plane, result.photometry);
      break;
    }
    MarkerPlane plane = result.plane;
    Photometry photometry = result.photometry;
    applyStep(step, plane, photometry);
    if (isVisible(plane) && photometry.light > 0.) {
      const Equations trial = fit.linearise(plane, photometry, noise);
      if (trial.cost <= equations.cost) {
        result.plane = plane;
        result.photometry = photometry;
        equations = trial;
        fit.keepResiduals();
        damping *= 0.1;
        if (++accepted <= noiseUpdates) {
          noise = fit.noiseOfResiduals();
          equations.cost = fit.costOfResiduals(photometry, noise);
        }
        continue;
      }
    }
    damping = std::max(damping * 10., 1e-4);
    if (damping > mostDamping) {
      break;
    }
  }
  result.squares = equations.cost;
  result.noise = noiseOfSquares(equations);
  result.inliers = fit.inliers(noise);
  result.correlation = fit.correlation(result.photometry, noise);
  const Matrix inverse = equations.matrix.ldlt().solve(Matrix::Identity());
  if (!inverse.allFinite()) {
    return std::nullopt;
  }
  result.covariance = result.noise * result.noise * inverse.topLeftCorner<poseSize, poseSize>();
  return result;
}

double robustSquares(const std::vector<FitPixel> &pixels, const FittedPose &fit, const MarkerPattern &pattern,
                     double noise)
{
  double squares = 0.;
  for (const FitPixel &pixel : pixels) {
    const double darkness = darknessAt(pixel.model, fit.plane, pattern, fit.photometry.blur).value;
    squares +=
        shareOfKnown(pixel, fit.photometry, noise) * biweight(residualOf(pixel, fit.photometry, darkness), noise).cost;
  }
  return squares;
}
} // namespace circle_marker
END_VISP_NAMESPACE
