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

#include "refine/likelihood.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// The blur stays between that of the pixel's own area and one that no marker is recognised through, pixels.
constexpr double leastSigma = 0.29;
constexpr double mostSigma = 20.;
// The noise is estimated again after each of the first steps; later ones keep it, so that they have one cost to lower.
constexpr int noiseUpdates = 5;
// Below this damping a step is as long as the equations want it: only then a short one means convergence.
constexpr double freeDamping = 0.1;
// Beyond this damping no step lowers the cost: the fit is at its minimum, to rounding.
constexpr double mostDamping = 1e6;

void applyStep(const ParameterVector &step, MarkerPlane &plane, Photometry &photometry)
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
  Likelihood fit(pixels, pattern, settings);
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
    ParameterMatrix damped = equations.matrix;
    damped.diagonal() *= 1. + damping;
    const ParameterVector step = damped.ldlt().solve(equations.right);
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
  const ParameterMatrix inverse = equations.matrix.ldlt().solve(ParameterMatrix::Identity());
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
