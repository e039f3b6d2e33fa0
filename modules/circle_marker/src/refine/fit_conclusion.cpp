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
 * What is known at the end of a fit besides pose and light.
 */

#include "refine/fit_conclusion.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "refine/fit_step.h"
#include "refine/grey_model.h"
#include "support/symmetric_eigen.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
namespace {
// Standard deviation of the noise from the weighted residuals: more efficient than the median.
double noiseOfSquares(const Equations &equations)
{
  // Of normal noise the biweight keeps this share of the mean square at its constant c:
  // (1 - 6 / c^2 + 15 / c^4) / (1 - 2 / c^2 + 3 / c^4).
  constexpr double biweightShrinkage = 0.828;
  const double freedom = std::max(equations.kept - static_cast<double>(equations.used.count()), 1.);
  return std::max(std::sqrt(equations.squares / freedom / biweightShrinkage), quantisation);
}

// The residuals of steep pixels are taken to have the variance of all until they tell otherwise: as if so many of them
// had said so.
constexpr double expectedPixels = 30.;
// Parameters that only they tell of: pose, blur, contrast, gamma and the ink's spread.
constexpr double parametersOfSteep = 12.;

// Pixels that share what a fit leaves of them, as far as that is the image's noise. What the model lacks is not shared:
// where it pulls neighbours the same way, the coherence tells it. left: standard deviation of what is left, grey
// levels; blur: of the edges, pixels.
double sharingOf(const ImageNoise &noise, double left, double blur)
{
  // The more the edges are blurred the longer the waves that move them: those of eight pixels, for which the sharing is
  // known, at a blur of 0.85 pixels, and in the end the longest, of which smoothed, enlarged and demosaiced pictures
  // have twice as much.
  constexpr double ofLongest = 2.;
  constexpr double halfway = 1.47; // pixels
  const double ofBlur = ofLongest * blur / std::hypot(blur, halfway);
  const double share = std::min(noise.sigma * noise.sigma / (left * left), 1.);
  return 1. + share * ofBlur * (noise.sharing - 1.);
}

// Variance of the residuals where the image is steep, which is where it tells of the pose, over that of all: what an
// edge is drawn, printed or sampled with is no noise that all pixels have.
double noiseAtEdges(const Equations &equations, double noise)
{
  if (equations.squaredSteepness <= 0.) {
    return 1.;
  }
  const double pixels = equations.steepness * equations.steepness / equations.squaredSteepness;
  const double ratio = equations.steepSquares / (pullOfNoise * noise * noise * equations.steepness);
  const double freedom = std::max(pixels - parametersOfSteep, 1.);
  return (expectedPixels + ratio * pixels) / (expectedPixels + freedom);
}

// Standard deviation of what the model may lack without leaving anything out, share of the contrast. In a picture that
// was drawn without noise the pixels at edges are outliers by a grey level or two, as no drawn edge has the model's
// blur. (Of bch31's densest codes, as circle-marker-create draws them, a third of the pixels were, and they were taken
// for covered.) As far as the biweight goes this is 3 % of the contrast.
constexpr double mayLack = 0.0064;

// The biweight's mean is 0.915 with normal noise, and the equations' information with it; its efficiency is 0.95.
constexpr double biweightCovariance = 0.915 / 0.95;

// Through a lens of 20,000 pixels and more the depth of a small marker is known a ten-thousandth as well as its place
// across, and the sums in single precision may say anything of it, that it has a negative variance, too. It is then
// taken for as large as it is negative: little is known.
Eigen::Matrix<double, 6, 6> positive(const Eigen::Matrix<double, 6, 6> &covariance)
{
  if (Eigen::LLT<Eigen::Matrix<double, 6, 6>>(covariance).info() == Eigen::Success) {
    return covariance;
  }
  const SymmetricEigen eigen = symmetricEigen(covariance);
  return eigen.vectors * eigen.values.cwiseAbs().asDiagonal() * eigen.vectors.transpose();
}
} // namespace

bool conclude(const Likelihood &fit, const Equations &equations, const ParameterVector &lastStep, double noise,
              const FitSettings &settings, FittedPose &result)
{
  result.squares = equations.cost;
  result.scale = noise;
  result.noise = noiseOfSquares(equations);
  result.sharing = sharingOf(settings.noise, result.noise, result.photometry.blur.sigma);
  const Explanation explanation = fit.explain(noise, mayLack * result.photometry.tellableContrast());
  result.inliers = explanation.inliers;
  result.correlation = explanation.correlation;
  // The pose's columns of the inverse, and the step that would be next.
  const UsedVector right = usedPart(equations.right, equations.used);
  const Eigen::Index used = right.size();
  Eigen::Matrix<double, Eigen::Dynamic, poseSize + 1, 0, parameters, poseSize + 1> columns(used, poseSize + 1);
  columns.setIdentity(); // the pose's parameters are used, and first
  columns.col(poseSize) = right;
  usedPart(equations.matrix, equations.used).ldlt().solveInPlace(columns);
  if (!columns.allFinite()) {
    return false;
  }
  result.decrement = right.dot(columns.col(poseSize));
  PoseInfluence influence = columns.leftCols<poseSize>().transpose();
  Eigen::Matrix<double, 6, 6> covariance = positive(influence.leftCols<poseSize>());
  influence.leftCols<poseSize>() = covariance;
  if (settings.exactBends) {
    result.edgeNoise = mayHaveNoisyEdges(settings) ? noiseAtEdges(equations, result.noise) : 1.;
    // What the parts pull is compared with what edges are off by: then that is not counted twice.
    const double shared = result.noise * std::sqrt(result.edgeNoise * result.sharing);
    const CoherentCovariance coherent = fit.coherentCovariance(influence, usedPart(lastStep, equations.used), shared);
    result.coherence = coherent.ratio;
    result.bendOfLight = fit.bendOfResiduals(result.photometry, noise);
    covariance = result.edgeNoise * coherent.covariance;
  }
  covariance *= biweightCovariance * result.noise * result.noise * result.sharing;
  if (!settings.spinIsKnown) {
    covariance.row(spinAt).setZero();
    covariance.col(spinAt).setZero();
  }
  result.covariance = turnedCovariance(covariance, result.plane.rotation, result.plane.radius);
  return true;
}
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE
