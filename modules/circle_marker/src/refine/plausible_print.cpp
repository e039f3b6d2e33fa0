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
 * Whether a fit is one of a print.
 */

#include "refine/plausible_print.h"

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// A marker without a code has its shape alone to prove itself; without refinement the start is worth less.
constexpr double leastCorrelationWithoutCode = 0.94;
constexpr double leastCorrelationUnrefined = 0.6;
// Share of the pixels that the model must explain.
constexpr double leastInliers = 0.5;
// A ring whose edges are explained only by a gamma beyond that of cameras is another ring; here, its logarithm.
constexpr double mostLogGamma = 1.;
// Unless it correlates by this (the sheet around a ring was taken for it with 0.98), and, below this radius, pixels,
// the gamma is not at its bound, 3.3 or 0.3 (fit_step.cpp): in 20 pixels a ring of ratio 0.6 is explained by that of
// 0.8, blurred, with the largest. Through a camera that is guessed large rings have any gamma.
constexpr double leastCorrelationOfAnyGamma = 0.99;
constexpr double anyLogGamma = 1.15;
constexpr double leastSizeOfAnyGamma = 20.;
// What is no marker, teeth on a ring, stripes, is explained by ink that has run by millimetres, by a sheet that is bent
// as if around a bucket, or by a light that ends on the marker: the spread in outer radii, and the coefficients of
// SheetBend.
constexpr double mostSpread = 0.03;
constexpr double mostBend = 0.12;
// Light that bends by more than this, root sum of squares of its coefficients, is no lens's: a cosine^4 has 0.71 over
// 300 pixels before one of 600.
constexpr double mostCurvature = 0.75;
// And by a blur nearly as wide as the marker: its standard deviation in outer radii. That of a motion by half a radius
// is a third of this, that of a disc of as much three fifths. (Stripes were explained by 0.49.)
constexpr double mostBlur = 0.43;
// Or by one of another size than was seen, by this factor of the distance.
constexpr double mostNearer = 1.5;
// Or by ink that is darker than no light at all, by so much of the paper's (stripes by 0.5 to 0.8, with what lies
// between them for the ground).
constexpr double mostContrast = 1.3;
// A code in doubt, which mostly is none, is given up as soon as a fit explains it by what no print under a lens is: by
// ink that takes more than all of the light, by a size that is not that of the outline, as a factor of the distance,
// or, once all pixels are fitted, by a blur of this many sectors, at the track's middle, whose standard deviation
// leaves nothing of a code. (By private counts, of 1971 such fits on the way to a code that was proven none is beyond
// the coarse limits and four are beyond the others; of 738 on what came to nothing a tenth and two in five.)
constexpr double mostAbsorptionInDoubt = 1.5;
constexpr double mostNearerInDoubt = 1.25;
constexpr double mostBlurInDoubt = 1.75;
// Of 500 coarse fits to codes in doubt, of markers of 8 to 40 pixels in any light that led on, two had less.
constexpr double leastCorrelationInDoubt = 0.75;
// A plain ring of which a part is covered has neither a code nor all of its outline to prove it: what is seen of it
// correlates by this, is explained to this share (edges of what covers it are in the rest: three bars leave 0.74),
// leaves no more than this factor of the noise and, by squares, this share of the contrast, and is blurred by no more
// than this, outer radii. (By private counts, of 1014 rings that were covered one in a hundred left 0.018 of the
// contrast and the most blurred had 0.058; of 113 things in pictures without any, among them squares, an 8 and an e,
// half left more than 0.03 and three in four were more blurred than 0.086.)
constexpr double leastCorrelationOfCovered = 0.95;
constexpr double leastInliersOfCovered = 0.7;
constexpr double mostNoiseOfCovered = 1.2;
constexpr double mostLackingOfCovered = 0.02;
constexpr double mostBlurOfCovered = 0.07;
// A coarse fit, which sees few pixels, leaves no more than so many times that.
constexpr double slackOfCoarse = 2.;

// Whether there are light, ink and paper as the fit has them.
bool isPlausible(const FittedPose &fit, const MarkerInImage &view)
{
  // The change of the light, without what it bends, from the centre to where two radii of the ring end that are
  // conjugate in its image: no more than their root sum of squares is it anywhere on the ring.
  Eigen::Vector2d change;
  for (int i = 0; i < 2; ++i) {
    const Eigen::Vector2d end = view.camera.toPixel(fit.plane.project(Eigen::Vector2d::Unit(i)));
    change[i] = fit.photometry.lightGradient.dot(end - view.frame.center) / view.frame.size;
  }
  const double nearer = view.marker.poses[0].center.norm() / fit.plane.center.norm();
  const SheetBend &bend = fit.plane.bend;
  const double curvature = fit.photometry.lightCurvature ? fit.photometry.lightCurvature->norm() : 0.;
  return change.norm() < 1. && curvature < mostCurvature && fit.photometry.contrast() < mostContrast &&
         std::abs(fit.photometry.blur.spread) < mostSpread && std::hypot(bend.bow, bend.saddle.norm()) < mostBend &&
         fit.photometry.blur.widest() < mostBlur * view.frame.size && std::max(nearer, 1. / nearer) < mostNearer;
}
} // namespace

bool mayBePrint(const FittedPose &fit, const MarkerInImage &view, bool isCoarse)
{
  const vpCircleMarkerFamily &family = view.marker.family;
  const double middle = 0.5 * (family.getLayout().codeInner + family.getLayout().codeOuter);
  const double sector = 2. * M_PI * middle * view.frame.size / family.getNbSectors(); // pixels
  const double nearer = view.marker.poses[0].center.norm() / fit.plane.center.norm();
  return (!isCoarse || fit.correlation >= leastCorrelationInDoubt) &&
         fit.photometry.absorption < mostAbsorptionInDoubt &&
         std::max(nearer, 1. / nearer) < (isCoarse ? mostNearer : mostNearerInDoubt) &&
         (isCoarse || fit.photometry.blur.sigma < mostBlurInDoubt * sector);
}

bool isRingWhereSeen(const FittedPose &fit, const MarkerInImage &view, double noise, bool isCoarse)
{
  const double slack = isCoarse ? slackOfCoarse : 1.;
  const double most = std::hypot(mostNoiseOfCovered * noise, mostLackingOfCovered * fit.photometry.tellableContrast());
  return fit.correlation >= leastCorrelationOfCovered && fit.inliers >= leastInliersOfCovered &&
         fit.noise < slack * most && fit.photometry.blur.widest() < slack * mostBlurOfCovered * view.frame.size;
}

bool isExplained(const FittedPose &best, const MarkerInImage &view, bool hasCode, bool refine)
{
  if (!refine) {
    return best.correlation >= leastCorrelationUnrefined && best.inliers >= leastInliers;
  }
  const double least = hasCode ? leastCorrelationOfMarker : leastCorrelationWithoutCode;
  // The fit of a ring to the sheet around it needs a gamma that no camera has. So do some small rings, of which it is
  // hardly known, but those explain the image, and do not want more of it than they may have. Of small codes it is
  // hardly known either.
  const double logGamma = std::abs(std::log(best.photometry.gamma));
  const double ofSize = view.frame.size < leastSizeOfAnyGamma ? anyLogGamma : HUGE_VAL;
  const bool isLikeCamera =
      hasCode || logGamma < (best.correlation >= leastCorrelationOfAnyGamma ? ofSize : mostLogGamma);
  return best.correlation >= least && best.inliers >= leastInliers && isLikeCamera && isPlausible(best, view);
}
} // namespace circle_marker
END_VISP_NAMESPACE
