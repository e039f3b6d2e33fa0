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
 * The fit of a marker under a shadow that its quiet zone does not show.
 */

#include "refine/missed_shadow.h"

#include <algorithm>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// A fit that leaves more than this share of the contrast unexplained may have missed the edge of a shadow: of small
// oblique markers the quiet zone is too narrow to show it. One with the shadow leaves at most this share of that.
constexpr double muchUnexplained = 0.02;
constexpr double mostLeftWithShadow = 0.8;
// Markers fitted without the shadow on them correlate by this; most letters by less.
constexpr double leastCorrelation = 0.94;
} // namespace

bool mayHaveShadow(const Recognition &marker, const MarkerPattern &pattern, const RankedFits &few)
{
  if (marker.seen || pattern.sectors == 0 || few.fits.empty() || few.fits[0].correlation < leastCorrelation) {
    return false;
  }
  const Photometry &photometry = few.fits[0].photometry;
  return unexplainedBy(few.fits[0]) > muchUnexplained * photometry.tellableContrast();
}

RankedFits withMissedShadow(const MarkerInImage &view, const MarkerPattern &pattern, const RankedFits &few,
                            FitSettings &settings, FittingMemory &memory)
{
  const FittedPose &plain = few.fits[0];
  memory.fitter->explainPixels(memory.pixels, plain, pattern, memory.explained);
  FitSettings shaded = settings;
  shaded.shadow = shadowBySplit(memory.explained, view.frame.size);
  if (!shaded.shadow) {
    return few;
  }
  const RankedFits again = fitFewPixels(view, pattern, true, shaded, memory.pixels, *memory.fitter);
  if (again.fits.empty() || unexplainedBy(again.fits[0]) > mostLeftWithShadow * unexplainedBy(plain)) {
    return few;
  }
  settings.shadow = shaded.shadow;
  return again;
}
} // namespace circle_marker
END_VISP_NAMESPACE
