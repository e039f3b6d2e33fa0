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
 * The less likely of a marker's two poses: whether it is worth a fit, and how far behind it ends.
 */

#include "refine/other_pose.h"

#include <algorithm>

#include "refine/fine_fits.h"
#include "refine/fit_starts.h"
#include "refine/pose_odds.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Whether a pose was given up so far from its end that by the equations there nothing may be left between it and the
// best. Of a ring that nearly faces the camera they mean little: halfway between its two poses one of 52 pixels, a
// tenth of which was covered, had 1027 before it and was 773 behind, with odds of e^75 against the right one.
bool isFarFromEnd(const FittedPose &other, const FittedPose &best)
{
  return !other.isSettled && other.decrement > 0.5 * (other.squares - best.squares);
}

// Whether the other pose of a marker was given up on its way though something is left that the model lacks, or was far
// from its end: how far it would have come is not known then, and the odds are not. (Of a ring of 250 pixels whose
// edges were sharper than a lens makes them they were e^0.1, and in other noise e^700.)
bool isGivenUpEarly(const MarkerInImage &view, const FittedPose *other, const FittedPose &best)
{
  if (!other || other->isSettled || view.frame.size <= leastHopelessSize) {
    return false;
  }
  return best.coherence > 1. || (!view.marker.hasCode() && isFarFromEnd(*other, best));
}
} // namespace

std::optional<GivenUp> giveUpHopeless(const MarkerInImage &view, RankedFits &coarse)
{
  Few<FittedPose> &fits = coarse.fits;
  if (fits.size() < 2 || view.frame.size <= leastHopelessSize || !isHopeless(fits[1], fits[0], coarse.noise)) {
    return std::nullopt;
  }
  const GivenUp givenUp = {fits[1], costOf(fits[1].squares - fits[0].squares, coarse.noise, fits[0].sharing)};
  fits.pop_back();
  return givenUp;
}

void leaveBest(RankedFits &coarse)
{
  while (coarse.fits.size() > 1) {
    coarse.fits.pop_back();
  }
}

bool compareAtTheirEnds(MarkerInImage &view, RankedFits &ranked, std::optional<GivenUp> &givenUp,
                        const FitSettings &settings, MarkerPattern &pattern, MeasureMemory &memory)
{
  const FittedPose best = ranked.fits[0];
  FittedPose *other = givenUp ? &givenUp->fit : ranked.fits.size() > 1 ? &ranked.fits[1] : nullptr;
  // What covers a code is lacking at any pose: one was read as another by this.
  const bool isAsked = view.marker.seen ? !view.marker.hasCode() : isGivenUpEarly(view, other, best);
  if (!isAsked) {
    return false;
  }
  RankedFits few =
      fitToTheirEnds(view, pattern, best, mirrored(best.plane), settings, memory.fewPixels, *memory.fitter);
  if (few.fits.size() < 2) {
    // Whether from the mirrored pose, too, one comes to the best: then the other is no end, and what it leaves counts
    // as it is; that of a covered ring, which may be anything, is none.
    const bool isAlone = !few.fits.empty() && isSamePose(few.fits[0], best);
    if (isAlone && view.marker.seen) {
      leaveBest(ranked);
      givenUp.reset();
    }
    else if (other) {
      other->isSettled = isAlone;
    }
    return false;
  }
  givenUp = giveUpHopeless(view, few);
  if (givenUp && isSamePose(few.fits[0], best)) {
    if (!givenUp->fit.isSettled) { // after so many steps: as much may be left of the way as isHopeless() allows
      const double ahead = costOf(givenUp->fit.decrement, few.noise, few.fits[0].sharing);
      givenUp->moreCost -= std::min(ahead, 0.5 * givenUp->moreCost);
      givenUp->fit.isSettled = true;
    }
    leaveBest(ranked);
  }
  else {
    ranked = fitFinely(view, few, false, givenUp.has_value(), settings, pattern, memory);
  }
  return !ranked.fits.empty() && !isSamePose(ranked.fits[0], best);
}
} // namespace circle_marker
END_VISP_NAMESPACE
