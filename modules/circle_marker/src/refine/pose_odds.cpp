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
 * How far a likelihood is believed that prefers one pose to the other.
 */

#include "refine/pose_odds.h"

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Log-odds D whose variance, 2 D, has that of costs in it that are off by k.
double loweredBy(double k, double odds)
{
  if (!std::isfinite(odds)) {
    return odds;
  }
  return 2. * odds * odds / std::max(2. * odds + k * k, 1e-9);
}
} // namespace

double costOf(double squares, double noise, double sharing)
{
  return squares / (2. * noise * noise * sharing);
}

double unrefinedOdds(double odds, const FittedPose &first, double noise)
{
  return loweredBy(costOf(first.decrement, noise, first.sharing), odds);
}

double coherentOdds(double odds, const FittedPose &first, const FittedPose &second, double noise)
{
  const double ofEdges = odds / first.edgeNoise;
  if (first.coherence <= 1.) {
    return ofEdges;
  }
  double behind = 0.; // grey levels^2
  for (const FittedPose *fit : {&first, &second}) {
    behind += !fit->isSettled && fit->decrement > 0. ? fit->decrement : 0.;
  }
  return loweredBy(costOf(behind, noise, first.sharing) / (first.coherence * first.edgeNoise),
                   ofEdges / first.coherence);
}
} // namespace circle_marker
END_VISP_NAMESPACE
