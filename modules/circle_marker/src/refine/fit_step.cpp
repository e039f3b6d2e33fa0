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
 * One step of a fit: what it leads to, and whether that can be.
 */

#include "refine/fit_step.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
namespace {
// The blur stays between that of the pixel's own area and one that no marker is recognised through, pixels.
constexpr double leastSigma = 0.29;
constexpr double mostSigma = 20.;
// Cameras' gamma lies between 0.4 and 2.4.
constexpr double leastGamma = 0.3;
constexpr double mostGamma = 3.3;
// Grey levels rise with the light on tone curves between -1 and 2.
constexpr double leastToneCurve = -0.9;
constexpr double mostToneCurve = 1.8;
// What a shadow leaves of the light, and the softness of its edge, in units of the marker's size.
constexpr double mostFactor = 1.;
constexpr double leastSoftness = 0.003;
constexpr double mostSoftness = 1.;
// A step that lowers the logarithm of gamma by more than this leaves no less than this part of the share of the light
// that ink leaves: below leastLight the image does not tell that any more. Ink that takes nearly all light, before a
// camera with a gamma of 0.45, is blacker than black by the step from a gamma of 1, and from there no fit came back.
// (Halos, which are blacker than black, are so at any gamma. With 0.1 one of 60 rings of another ratio was explained.)
constexpr double fallOfGamma = 0.3;
constexpr double leastOfShare = 0.2;
// Light, ink, gamma and blur that have changed by less than this share are the same to the matrix of a pass: by as
// much it is wrong.
constexpr double nearLight = 0.01;

// A share of the light after a step, and one of the logarithm of gamma: the grey level, not the light, is what the
// image tells, so share^gamma changes by what the step says to first order, and gamma alone leaves it as it is.
double shareAfter(double share, double step, double bend)
{
  if (share <= leastLight) {
    return share + step;
  }
  const double after = std::pow(share, std::exp(-bend)) + step + share * std::log(share) * bend;
  return after < leastLight && bend < -fallOfGamma ? std::max(after, leastOfShare * share) : after;
}

Eigen::Vector3d curvatureOf(const Photometry &photometry)
{
  return photometry.lightCurvature.value_or(Eigen::Vector3d::Zero());
}
} // namespace

UsedMatrix usedPart(const ParameterMatrix &matrix, const UsedParameters &used)
{
  const auto count = static_cast<Eigen::Index>(used.count());
  UsedMatrix part(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j < count; ++j) {
      part(j, i) = matrix(used.at(j), used.at(i));
    }
  }
  return part;
}

UsedVector usedPart(const ParameterVector &vector, const UsedParameters &used)
{
  UsedVector part(static_cast<Eigen::Index>(used.count()));
  for (Eigen::Index k = 0; k < part.size(); ++k) {
    part[k] = vector[used.at(k)];
  }
  return part;
}

ParameterVector solveEquations(const ParameterMatrix &matrix, const ParameterVector &right, const UsedParameters &used)
{
  const UsedVector part = usedPart(matrix, used).ldlt().solve(usedPart(right, used));
  ParameterVector solution = ParameterVector::Zero();
  for (Eigen::Index k = 0; k < part.size(); ++k) {
    solution[used.at(k)] = part[k];
  }
  return solution;
}

void applyStep(const ParameterVector &step, MarkerPlane &plane, Photometry &photometry)
{
  plane.center += plane.radius * (plane.rotation * step.head<3>());
  const Eigen::Vector3d turn = step.segment<3>(3);
  const double angle = turn.norm();
  if (angle > 0.) {
    plane.rotation = plane.rotation * Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
  }
  const double gamma = std::clamp(photometry.gamma * std::exp(step[gammaAt]), leastGamma, mostGamma);
  const double bend = std::log(gamma / photometry.gamma);
  photometry.gamma = gamma;
  photometry.white += step[lightAt];
  photometry.lightGradient = (std::exp(-bend) + bend) * photometry.lightGradient + step.segment<2>(gradientAt);
  if (photometry.lightCurvature) {
    photometry.lightCurvature =
        (std::exp(-bend) + bend) * *photometry.lightCurvature + step.segment<curvatureSize>(curvatureAt);
  }
  photometry.absorption = 1. - shareAfter(1. - photometry.absorption, -step[absorptionAt], bend);
  photometry.blur.sigma = std::clamp(photometry.blur.sigma + step[sigmaAt], leastSigma, mostSigma);
  photometry.blur.elongate(step.segment<2>(elongationAt));
  photometry.blur.spread += step[spreadAt];
  plane.bend.bow += step[bendAt];
  plane.bend.saddle += step.segment<2>(bendAt + 1);
  for (std::size_t shape = 0; shape < paperShapes; ++shape) {
    photometry.surround[shape] += step[surroundAt + static_cast<int>(shape)];
  }
  photometry.paper.shift += step.segment<2>(paperAt);
  photometry.paper.turn += step[paperAt + 2];
  photometry.paper.growth += step[paperAt + 3];
  if (photometry.toneCurve) {
    photometry.toneCurve = std::clamp(*photometry.toneCurve + step[toneAt], leastToneCurve, mostToneCurve);
  }
  if (photometry.shadow) {
    Shadow &shadow = *photometry.shadow;
    shadow.factor = std::clamp(shareAfter(shadow.factor, step[shadowAt], bend), leastLightInShadow, mostFactor);
    shadow.direction += step[shadowAt + 1];
    shadow.edge += step[shadowAt + 2];
    shadow.softness = std::clamp(shadow.softness + step[shadowAt + 3], leastSoftness, mostSoftness);
  }
}

bool isAlike(const Photometry &p, const Photometry &q)
{
  return std::abs(p.white - q.white) < nearLight * p.white && std::abs(p.absorption - q.absorption) < nearLight &&
         std::abs(p.gamma - q.gamma) < nearLight * p.gamma &&
         std::abs(p.toneCurve.value_or(0.) - q.toneCurve.value_or(0.)) < nearLight &&
         (curvatureOf(p) - curvatureOf(q)).norm() < nearLight &&
         std::abs(p.blur.sigma - q.blur.sigma) < nearLight * p.blur.sigma;
}

bool isPrint(const Photometry &photometry)
{
  return photometry.white > 0. && photometry.absorption > 0.;
}
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE
