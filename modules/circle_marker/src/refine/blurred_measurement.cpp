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
 * Poses of a marker that was read through a strong blur.
 */

#include "refine/blurred_measurement.h"

#include <algorithm>
#include <array>
#include <cmath>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// measure() looks at every pixel, noise and all, the reading at means of many: it may leave this share of the variance
// more. A model that lacks a motion leaves a tenth and more.
constexpr double mostOfNoise = 0.02;
// The pose of a plain ring bears less of it: it is known by its outline alone. Fits of rings out of focus, which are
// right, leave 0.001 more; of moved ones 0.005 and more.
constexpr double mostOfNoiseOfRing = 0.0025;
// In noise of a twelfth of the contrast sharp edges look wide. A fit that sees them sharp, pixels, and leaves no more
// than such noise does, is the better one.
constexpr double sharp = 2.;
constexpr double mostOfMuchNoise = 0.06;
// Of a disc with a larger radius than this, by the outline's major semi-axis, the Gaussian makes as much of an error as
// the reading does, and does not know of it.
constexpr double wideDisc = 0.135;

FittedPose fittedPose(const Recognition &marker, std::size_t i)
{
  const BlurredPoses &blurred = *marker.blurred;
  FittedPose pose;
  pose.plane = marker.poses[i];
  pose.squares = 2. * blurred.cost[i] * blurred.noise * blurred.noise;
  pose.noise = blurred.noise;
  pose.inliers = 1.;
  pose.correlation = std::sqrt(std::max(1. - blurred.unexplained, 0.));
  pose.covariance = turnedCovariance(blurred.covariance[i], pose.plane.rotation, pose.plane.radius);
  return pose;
}

bool isRight(const FittedPose &fit, const Recognition &marker)
{
  const BlurredPoses &blurred = *marker.blurred;
  const double most = marker.family.isCoded() ? mostOfNoise : mostOfNoiseOfRing;
  const double unexplained = 1. - std::pow(fit.correlation, 2.);
  return (blurred.disc < wideDisc && unexplained < blurred.unexplained + most) ||
         (fit.photometry.blur.widest() < sharp && unexplained < mostOfMuchNoise);
}
} // namespace

std::optional<Measurement> bestMeasurement(const Recognition &marker, std::optional<Measurement> measured)
{
  if (!marker.blurred || (measured && isRight(measured->first, marker))) {
    return measured;
  }
  const std::array<double, 2> &cost = marker.blurred->cost;
  const std::size_t best = cost[1] < cost[0] ? 1 : 0;
  const FittedPose first = fittedPose(marker, best);
  if (cost[1 - best] == HUGE_VAL) {
    return Measurement{first, std::nullopt, cost[best], HUGE_VAL};
  }
  return Measurement{first, fittedPose(marker, 1 - best), cost[best], cost[1 - best]};
}
} // namespace circle_marker
END_VISP_NAMESPACE
