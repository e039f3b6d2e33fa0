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
 * What an estimator at the Cramer-Rao bound would make of a frame.
 */

#include <cmath>

#include <visp3/circle_marker_simulator/vpMarkerPoseBound.h>
#include <visp3/core/vpColVector.h>
#include <visp3/core/vpExponentialMap.h>
#include <visp3/core/vpMath.h>

#include "common/pose_error.h"
#include "common/seeds.h"
#include "ideal_estimate.h"

namespace experiments {
namespace {
constexpr unsigned int dimensions = 6;

/*! A number above 0, up to 1. */
double shareFrom(std::uint64_t seed)
{
  constexpr double step = 1. / 9007199254740992.; // 2^-53
  return (static_cast<double>(seed >> 11) + 1.) * step;
}

/*! A number of the standard normal distribution (Box and Muller, 1958). */
double normalFrom(std::uint64_t seed)
{
  return std::sqrt(-2. * std::log(shareFrom(mixed(seed, 0)))) * std::cos(2. * M_PI * shareFrom(mixed(seed, 1)));
}

/*! The lower triangle L with L L^T = A (Cholesky); a pivot that rounding makes negative counts as 0. */
vpMatrix lowerRootOf(const vpMatrix &A)
{
  vpMatrix L(dimensions, dimensions);
  for (unsigned int j = 0; j < dimensions; ++j) {
    for (unsigned int i = j; i < dimensions; ++i) {
      double rest = A[i][j];
      for (unsigned int k = 0; k < j; ++k) {
        rest -= L[i][k] * L[j][k];
      }
      L[i][j] = i == j ? std::sqrt(std::fmax(rest, 0.)) : L[j][j] > 0. ? rest / L[j][j] : 0.;
    }
  }
  return L;
}

vpMarkerPoseBound limitFor(const Scene &scene)
{
  vpMarkerPoseBound limit(scene.cam, scene.photometry);
  limit.setSurround(vpMarkerPoseBound::UNKNOWN_SURROUND);
  return limit;
}
} // namespace

vpHomogeneousMatrix idealEstimate(const vpSimulatedMarker &marker, const Scene &scene, std::uint64_t seed)
{
  return drawnEstimate(marker.getPose(), limitFor(scene).bound(marker).covariance, seed);
}

Sample limitOf(const vpSimulatedMarker &marker, const Scene &scene)
{
  constexpr double millimetres = 1e3; // In a metre.
  const vpMarkerPoseBound limit = limitFor(scene);
  const vpPoseBound bound = limit.bound(marker);
  const double separation = limit.separation(marker).separation;
  const vpHomogeneousMatrix &cMo = marker.getPose();
  Sample sample;
  sample.method = Method::Limit;
  sample.x = cMo[0][3];
  sample.y = cMo[1][3];
  sample.z = cMo[2][3];
  sample.angle = vpMath::deg(tiltOf(cMo));
  sample.first =
      Deviation{millimetres * bound.x, millimetres * bound.y, millimetres * bound.z, vpMath::deg(bound.normal)};
  sample.second = sample.first; // The mirrored pose is known as well as the true one.
  sample.logOdds = 0.5 * separation * separation;
  return sample;
}

vpHomogeneousMatrix drawnEstimate(const vpHomogeneousMatrix &truth, const vpMatrix &covariance, std::uint64_t seed)
{
  vpColVector draw(dimensions);
  for (unsigned int i = 0; i < dimensions; ++i) {
    draw[i] = normalFrom(mixed(seed, i));
  }
  const vpColVector delta = lowerRootOf(covariance) * draw;
  return vpExponentialMap::direct(-1. * delta) * truth;
}
} // namespace experiments
