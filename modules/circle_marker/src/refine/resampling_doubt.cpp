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
 * What the resampling of a picture adds to the covariance of a pose.
 */

#include "refine/resampling_doubt.h"

#include <algorithm>
#include <cmath>

#include "refine/edge_equations.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Root mean square over p of the third moment p (1 - p) (1 - 2p), pixels^3: the square's mean is 1 / 210.
constexpr double thirdMoment = 0.069;
// A part of the marker shifts as one, so long along its edge, pixels: over much more than that the phase of an
// undistorted picture changes. So many parts at least, because it changes there, too, and at most, because of larger
// markers parts of all sizes do.
constexpr double lengthOfPart = 40.;
constexpr int leastParts = 2;
constexpr int mostParts = 6;
// Parts begin by this share of one before the angle of which some edge's point may lie exactly.
constexpr double besidePoints = 0.1;
} // namespace

// The line is S(x) = E(x + w / 2) - E(x - w / 2), E the normal distribution with the blur's variance s^2, to which the
// third moment adds -S''' / 6 for each of its units: to first order the fit moves by <S'', S''> / (6 <S', S'>).
// Products of the derivatives of both sides are those of q = exp(-w^2 / (4 s^2)) by w.
double motionByThirdMoment(double width, double blurVariance)
{
  const double ofWidth = std::max(width * width / (2. * blurVariance), 1e-6);
  const double overlap = std::exp(-ofWidth / 2.);
  return (1. + ofWidth * overlap / (1. - overlap)) / (12. * blurVariance);
}

void addResamplingDoubt(const MarkerPattern &pattern, double unit, FittedPose &fit)
{
  const double blurVariance = fit.photometry.blur.sigma * fit.photometry.blur.sigma;  // pixels^2
  const double length = 2. * M_PI * fit.plane.radius / (fit.plane.center.z() * unit); // of the outer edge, pixels
  const int parts = std::clamp(static_cast<int>(length / lengthOfPart), leastParts, mostParts);
  EdgeEquations equations(fit.plane);
  PoseColumns right = PoseColumns::Zero(6, 2 * parts); // of each part, u and v
  forEachEdge(pattern, [&](const MarkerEdge &edge) {
    const EdgeEquations::Seen seen = equations.add(edge);
    const double width = std::abs(seen.across.dot(seen.byPlace * edge.toOther)) / unit; // pixels
    // Across an edge the blur has the third moments of rows and columns by the cubes of its normal's parts.
    const Eigen::RowVector2d moved =
        thirdMoment * motionByThirdMoment(width, blurVariance) * seen.across.array().cube(); // pixels
    const double turn = std::atan2(edge.place.y(), edge.place.x()) / (2. * M_PI) + 0.5;
    const int part = static_cast<int>(parts * turn + besidePoints) % parts;
    right.middleCols<2>(2 * part) += unit * seen.byPose * moved;
  });
  const PoseColumns motions = equations.solve(right);
  const double known = fit.covariance.bottomRightCorner<3, 3>().trace();
  fit.covariance += motions * motions.transpose();
  fit.resampled = fit.covariance.bottomRightCorner<3, 3>().trace() / known;
}
} // namespace circle_marker
END_VISP_NAMESPACE
