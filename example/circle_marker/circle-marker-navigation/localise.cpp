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
 * Where a camera is, from all markers that it sees.
 */

#include "localise.h"

#include <algorithm>
#include <cmath>

#include <visp3/core/vpExponentialMap.h>

namespace navigation {
namespace {
/*! What one marker says. */
struct Opinion
{
  vpHomogeneousMatrix wMc;
  vpMatrix information; //!< Inverse of the covariance.
};

// A pose that is e^20 times likelier than the other one is the pose.
constexpr double certainOdds = 20.;
// Metres and radians; dead reckoning is never as wrong as that in this program, a wrong marker nearly always is.
constexpr double mostSurprise = 0.7;
// Root of the mean square of six numbers in standard deviations: beyond, one of the fused poses is wrong.
constexpr double mostSigmas = 6.;

vpColVector difference(const vpHomogeneousMatrix &from, const vpHomogeneousMatrix &to)
{
  return vpExponentialMap::inverse(from.inverse() * to);
}

std::vector<Opinion> opinionsOf(const vpCircleMarkerDatabase &database,
                                const std::vector<vpCircleMarkerDetection> &detections,
                                const vpHomogeneousMatrix &expected)
{
  std::vector<Opinion> opinions;
  for (const vpCircleMarkerDetection &detection : detections) {
    const vpCircleMarkerEntry *entry = database.find(detection.family, detection.id);
    // Five degrees of freedom do not fix a camera.
    if (entry == nullptr || !entry->wMo || detection.dof < 6) {
      continue;
    }
    Opinion opinion{*entry->wMo * detection.cMo.inverse(), detection.covariance.inverseByCholesky()};
    if (detection.hasSecondPose && detection.logOdds < certainOdds) {
      const vpHomogeneousMatrix other = *entry->wMo * detection.cMo2.inverse();
      if (difference(expected, other).frobeniusNorm() < difference(expected, opinion.wMc).frobeniusNorm()) {
        opinion = {other, detection.covariance2.inverseByCholesky()};
      }
    }
    if (difference(expected, opinion.wMc).frobeniusNorm() < mostSurprise) {
      opinions.push_back(opinion);
    }
  }
  return opinions;
}

/*! The most likely pose of some opinions. */
Location fuse(const std::vector<Opinion> &opinions)
{
  Location location;
  location.wMc = opinions.front().wMc;
  location.markers = static_cast<unsigned int>(opinions.size());
  constexpr int steps = 4; // the differences are small: each step gains some digits
  for (int i = 0; i < steps; ++i) {
    vpMatrix information(6, 6, 0.);
    vpColVector right(6, 0.);
    for (const Opinion &opinion : opinions) {
      information += opinion.information;
      right += opinion.information * difference(location.wMc, opinion.wMc);
    }
    location.covariance = information.inverseByCholesky();
    location.wMc = location.wMc * vpExponentialMap::direct(location.covariance * right);
  }
  return location;
}

double sigmasOf(const Opinion &opinion, const Location &location)
{
  const vpColVector d = difference(location.wMc, opinion.wMc);
  return std::sqrt(std::max(0., d.t() * (opinion.information * d)) / 6.);
}
} // namespace

std::optional<Location> locate(const vpCircleMarkerDatabase &database,
                               const std::vector<vpCircleMarkerDetection> &detections,
                               const vpHomogeneousMatrix &expected)
{
  std::vector<Opinion> opinions = opinionsOf(database, detections, expected);
  while (!opinions.empty()) {
    const Location location = fuse(opinions);
    const auto worst = std::max_element(opinions.begin(), opinions.end(), [&](const Opinion &a, const Opinion &b) {
      return sigmasOf(a, location) < sigmasOf(b, location);
    });
    if (opinions.size() < 2 || sigmasOf(*worst, location) < mostSigmas) {
      return location;
    }
    opinions.erase(worst);
  }
  return std::nullopt;
}
} // namespace navigation
