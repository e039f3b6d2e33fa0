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
 * Fits of a marker whose sheet is bent.
 */

#include "refine/bent_sheet.h"

#include <algorithm>
#include <cmath>

#include "refine/fit_starts.h"
#include "refine/pose_odds.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Log-odds by which a bent sheet explains the pixels better than a flat one. Three more numbers do by 8 of their own
// accord once in 1000 markers.
constexpr double leastGain = 8.;
// And to what share of before the parts of the print pull the pose apart: what covers a marker is explained a little by
// a bend as well, but the parts pull it apart as before.
constexpr double mostCoherence = 0.5;

// Paper is not stretched: it bends about one axis, and then its bow is as large as its saddle. The bow is the less well
// known of both; what has hardly any and a large saddle, as under the edge of a shadow that was not seen, is no paper.
constexpr double mostSaddle = 2.;    // of the bow
constexpr double saddleError = 5e-3; // and beyond that

bool isPaper(const SheetBend &bend)
{
  return bend.saddle.norm() < mostSaddle * std::abs(bend.bow) + saddleError;
}
} // namespace

RankedFits fitBent(const std::vector<FitPixel> &pixels, const RankedFits &fits, const MarkerPattern &pattern,
                   FitSettings settings, Fitter &fitter)
{
  settings.samePixels = true;
  const RankedFits flat = fits.fits.size() > 1 ? fits : withMirrored(pixels, fits, pattern, settings, fitter);
  const FittedPose &rival = flat.fits[0];
  if (rival.coherence <= 1.) {
    return flat;
  }
  settings.bend = true;
  Few<FitStart> starts;
  for (const FittedPose &fit : flat.fits) {
    starts.push_back({fit.plane, fit.photometry, flat.noise});
  }
  Few<FittedPose> bent = fitAll(pixels, starts, pattern, settings, fitter);
  bent.push_back(rival);
  RankedFits ranked = rank(pixels, pattern, true, bent, fitter);
  const auto isFlat = [](const FittedPose &fit) { return !fit.plane.bend.isAny(); };
  FittedPose *const last = std::find_if(ranked.fits.begin(), ranked.fits.end(), isFlat);
  if (last == ranked.fits.end()) {
    return flat; // the rival's start was bent, and there is nothing to compare with
  }
  const FittedPose &best = ranked.fits[0];
  const double gain = costOf(last->squares - best.squares, ranked.noise, best.sharing) / best.edgeNoise;
  const bool isCoherent = best.coherence > std::max(mostCoherence * rival.coherence, 1.);
  if (gain < leastGain || isCoherent || !isPaper(best.plane.bend)) {
    return flat;
  }
  std::rotate(last, last + 1, ranked.fits.end());
  ranked.fits.pop_back();
  keepTwo(ranked);
  return ranked;
}
} // namespace circle_marker
END_VISP_NAMESPACE
