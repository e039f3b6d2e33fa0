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
 * The spin of a marker whose code is covered in part.
 */

#include "refine/spin_search.h"

#include <cmath>

#include "refine/fit_starts.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Of whole markers fewer pixels than this share are seldom explained; of one with a quarter of it covered, within the
// ring, 0.68 were.
constexpr double mostInliers = 0.8;
// Spins that are tried on either side, to half a sector: half a pixel apart on a track of 60 pixels diameter, one and a
// half on one of 200. On larger ones a sharp picture's best spin may lie between two.
constexpr int spins = 10;

// The turn from a fit's spin with which the pixels are explained best, rad; none after the deadline.
double bestTurn(const std::vector<FitPixel> &pixels, const RankedFits &ranked, const MarkerPattern &pattern,
                const Deadline &deadline, Fitter &fitter)
{
  const FittedPose &best = ranked.fits[0];
  const double step = M_PI / (spins * static_cast<double>(pattern.sectors));
  double turn = 0.;
  double least = HUGE_VAL;
  for (int k = -spins; k <= spins; ++k) {
    if (deadline.hasPassed()) {
      return 0.;
    }
    FittedPose turned = best;
    turned.plane.spin(k * step);
    const double squares = fitter.robustSquares(pixels, turned, pattern, best.photometry, ranked.noise, true);
    if (squares < least) {
      least = squares;
      turn = k * step;
    }
  }
  return turn;
}
} // namespace

bool mayBeTurned(const FittedPose &fit)
{
  return fit.inliers < mostInliers;
}

RankedFits withBetterSpin(const std::vector<FitPixel> &pixels, const RankedFits &ranked, const MarkerPattern &pattern,
                          FitSettings settings, Fitter &fitter)
{
  const double turn = bestTurn(pixels, ranked, pattern, settings.deadline, fitter);
  if (turn == 0.) {
    return ranked;
  }
  MarkerPlane plane = ranked.fits[0].plane;
  plane.spin(turn);
  settings.samePixels = true;
  Few<FitStart> starts;
  for (const MarkerPlane &start : {plane, mirrored(plane)}) {
    starts.push_back({start, ranked.fits[0].photometry, ranked.noise});
  }
  Few<FittedPose> fits = fitAll(pixels, starts, pattern, settings, fitter);
  for (const FittedPose &fit : ranked.fits) {
    fits.push_back(fit);
  }
  RankedFits turned = rank(pixels, pattern, true, fits, fitter);
  keepTwo(turned);
  return turned.fits[0].plane.rotation == ranked.fits[0].plane.rotation ? ranked : turned;
}
} // namespace circle_marker
END_VISP_NAMESPACE
