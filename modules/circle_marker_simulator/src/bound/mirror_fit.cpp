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
 * Fit of the mirrored pose to the image of a marker.
 */

#include <cmath>

#include <Eigen/Dense>

#include <visp3/core/vpException.h>

#include "mirror_fit.h"

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

namespace {

// Steps of a fit; 4 to 8 are usual.
constexpr int MOST_STEPS = 25;
// A step that lessens the squared distance by less than this share ends the fit: 0.05 % of the distance.
constexpr double ENOUGH = 1e-3;
// Above this distance a wrong choice has a probability below 1e-88. The second fit, which lessens the distance by 0.1
// to 3 %, is then left out, and a step that lessens the squared distance by less than the given share ends the first
// one.
constexpr double CERTAIN = 40.;
constexpr double ENOUGH_IF_CERTAIN = 0.1;
// Two images that are this near (in standard deviations of the noise) need not be told apart better.
constexpr double SAME = 1e-3;
// Damping, as a share of the diagonal: first value, factor after a good and after a bad step, and where to give up.
constexpr double DAMPING = 1e-4;
constexpr double LESS_DAMPING = 0.1;
constexpr double MORE_DAMPING = 10.;
constexpr double MOST_DAMPING = 1e6;

Eigen::Vector3d normalOf(const vpHomogeneousMatrix &cMo)
{
  return Eigen::Vector3d(cMo[0][2], cMo[1][2], cMo[2][2]);
}

Eigen::Vector3d sightOf(const vpHomogeneousMatrix &cMo)
{
  return Eigen::Vector3d(cMo[0][3], cMo[1][3], cMo[2][3]).normalized();
}

double squaredDistance(const Eigen::VectorXd &residual, const Eigen::VectorXd &weights)
{
  return (residual.array().square() * weights.array()).sum();
}

// A trial state that cannot be rendered (turned away) is as bad as can be. Without blur that is held, at 0.
bool isPossible(const ViewState &state)
{
  return state.cMo[2][3] > 0. && normalOf(state.cMo).dot(sightOf(state.cMo)) > 0. && state.blurVariance >= 0.;
}

ViewState fit(const MarkerView &view, const Eigen::VectorXd &weights, const Eigen::VectorXd &target,
              const ViewState &start, const FreeParameters &free, double &squared)
{
  ViewState state = start;
  Eigen::VectorXd residual = target - view.image(state);
  squared = squaredDistance(residual, weights);
  double damping = DAMPING;
  for (int i = 0; i < MOST_STEPS && squared > SAME * SAME; ++i) {
    const Eigen::Matrix3d axes = turnAxes(state.cMo);
    const ViewDerivatives J = view.derivatives(state, axes, free);
    ViewMatrix N = informationOf(J, weights);
    for (int k = 0; k < VIEW_PARAMETERS; ++k) {
      N(k, k) += !free[k] ? 1. : 0.;
    }
    const ViewStep gradient = J.transpose() * weights.cwiseProduct(residual);
    const double before = squared;
    while (damping < MOST_DAMPING) {
      ViewMatrix damped = N;
      damped.diagonal() *= 1. + damping;
      const ViewStep scale = damped.diagonal().cwiseSqrt().cwiseInverse();
      const ViewMatrix scaled = scale.asDiagonal() * damped * scale.asDiagonal();
      const ViewStep step = scale.cwiseProduct(scaled.ldlt().solve(scale.cwiseProduct(gradient)));
      const ViewState trial = moved(state, step, axes);
      if (isPossible(trial)) {
        const Eigen::VectorXd trialResidual = target - view.image(trial);
        const double trialSquared = squaredDistance(trialResidual, weights);
        if (trialSquared < squared) {
          state = trial;
          residual = trialResidual;
          squared = trialSquared;
          damping *= LESS_DAMPING;
          break;
        }
      }
      damping *= MORE_DAMPING;
    }
    if (before - squared <= (squared > CERTAIN * CERTAIN ? ENOUGH_IF_CERTAIN : ENOUGH) * before) {
      break;
    }
  }
  return state;
}

} // namespace

vpHomogeneousMatrix mirrored(const vpHomogeneousMatrix &cMo)
{
  const Eigen::Vector3d normal = normalOf(cMo);
  const Eigen::Vector3d sight = sightOf(cMo);
  const Eigen::Vector3d axis = normal.cross(sight);
  const double sine = axis.norm();
  if (sine == 0.) {
    return cMo;
  }
  ViewStep step = ViewStep::Zero();
  step.segment<3>(TURN) = 2. * std::atan2(sine, normal.dot(sight)) * axis / sine;
  return moved({cMo, 1., 0., 0.}, step, Eigen::Matrix3d::Identity()).cMo;
}

MirrorFit fitMirror(const MarkerView &view, const Eigen::VectorXd &weights, const ViewState &truth, bool hasSpin)
{
  const Eigen::VectorXd target = view.image(truth);
  ViewState start = truth;
  start.cMo = mirrored(truth.cMo);
  FreeParameters free;
  free.fill(true);
  free[SPIN] = hasSpin;
  free[BLUR] = truth.blurVariance > 0.;
  free[TURN] = false;
  free[TURN + 1] = false;
  double squared = 0.;
  const ViewState reflected = fit(view, weights, target, start, free, squared);
  const double reflectedDistance = std::sqrt(squared);
  if (reflectedDistance > CERTAIN) {
    return {reflected, reflectedDistance, true};
  }

  free[TURN] = true;
  free[TURN + 1] = true;
  const ViewState best = fit(view, weights, target, reflected, free, squared);
  const Eigen::Vector3d normal = normalOf(best.cMo);
  const bool ranBack = normal.dot(normalOf(truth.cMo)) >= normal.dot(normalOf(start.cMo));
  if (ranBack) {
    return {reflected, reflectedDistance, false};
  }
  return {best, std::sqrt(squared), true};
}

} // namespace marker_simulator
END_VISP_NAMESPACE
