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
 * The fits of one marker, the likeliest first.
 */

#include "refine/ranked_fits.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "refine/fit_starts.h"
#include "refine/pose_odds.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Two fits closer than this, in standard deviations, are one pose.
constexpr double samePose = 0.3;
// Difference of the blur, pixels, or of gamma, share of it, between two fits at their minimum.
constexpr double sameLight = 0.03;
constexpr double sameGamma = 0.06;
// A pose whose log-odds against are beyond this on few pixels is not refined any further.
constexpr double hopelessOdds = 30.;
// And a fit that is so far behind another one, and does not catch up, is not taken to its end; if there is a code:
// without one the poses differ by little, and come to their likelihoods slowly.
constexpr double givenUpOdds = 3. * hopelessOdds;
// Cosine of the angle between the directions of two poses' tilts within which they lean to the same side.
constexpr double oneSide = 0.5;

// Angle between the normals of a fit and of another pose, in standard deviations of the fit; HUGE_VAL beyond 90
// degrees.
double distance(const FittedPose &fit, const MarkerPlane &other)
{
  const Eigen::Vector3d normal = fit.plane.rotation.col(2);
  if (normal.dot(other.rotation.col(2)) <= 0.) {
    return HUGE_VAL;
  }
  const Eigen::Vector3d turn = 0.5 * normal.cross(other.rotation.col(2));
  const Eigen::Matrix3d covariance = fit.covariance.bottomRightCorner<3, 3>() +
                                     1e-12 * Eigen::Matrix3d::Identity(); // the held spin leaves it singular
  return 2. * std::sqrt(turn.dot(covariance.inverse() * turn));
}

// Whether two poses lean to the same side of the line of sight: the likelihood has one maximum on each, and what ends
// beside it has not come to its end.
bool isOnOneSide(const MarkerPlane &p, const MarkerPlane &q)
{
  const Eigen::Vector3d sight = p.center.normalized();
  const auto lean = [&sight](const MarkerPlane &plane) {
    const Eigen::Vector3d normal = plane.rotation.col(2);
    return Eigen::Vector3d(normal - normal.dot(sight) * sight);
  };
  return lean(p).dot(lean(q)) > oneSide * lean(p).norm() * lean(q).norm();
}
} // namespace

Few<FittedPose> fitAll(const std::vector<FitPixel> &pixels, const Few<FitStart> &starts, const MarkerPattern &pattern,
                       FitSettings settings, Fitter &fitter, const std::optional<FittedPose> &before)
{
  std::optional<FittedPose> best;
  const auto enter = [&](const FittedPose &fit) {
    if (pattern.sectors > 0 && fit.isSettled && (!best || fit.noise < best->noise)) {
      best = fit;
      settings.rival = Rival{fit.squares, fit.scale, givenUpOdds * fit.sharing};
    }
  };
  if (before) {
    enter(*before);
  }
  Few<FittedPose> fits;
  for (FitStart start : starts) {
    const bool isSecond = settings.isClear && best && !start.photometry;
    if (isSecond) {
      start.photometry = best->photometry;
      start.noise = best->noise;
      if (starts.size() > 2) { // they face the camera: what is left is the mirror image of where one has led
        start.plane = mirrored(best->plane);
      }
    }
    const auto fit = fitter.fitPose(pixels, start, pattern, settings);
    settings.samePixels = true;
    if (fit) {
      fits.push_back(*fit);
      enter(*fit);
    }
    if (fit && isSecond) {
      break;
    }
  }
  return fits;
}

RankedFits rank(const std::vector<FitPixel> &pixels, const MarkerPattern &pattern, bool exactBends,
                const Few<FittedPose> &unranked, Fitter &fitter)
{
  if (unranked.empty()) {
    return {};
  }
  RankedFits ranked = {unranked, 0.};
  Few<FittedPose> &fits = ranked.fits;
  const auto best = std::min_element(fits.begin(), fits.end(),
                                     [](const FittedPose &p, const FittedPose &q) { return p.noise < q.noise; });
  ranked.noise = best->noise;
  if (fits.size() > 1) {
    Photometry surround = best->photometry;
    surround.endError = 0.; // each fit has the paper end where it is: that tells them apart
    for (FittedPose &fit : fits) {
      fit.squares = fitter.robustSquares(pixels, fit, pattern, surround, ranked.noise, exactBends);
      fit.scale = ranked.noise;
    }
    const auto isBetter = [](const FittedPose &p, const FittedPose &q) { return p.squares < q.squares; };
    for (FittedPose *next = fits.begin(); next != fits.end(); ++next) {
      std::iter_swap(next, std::min_element(next, fits.end(), isBetter));
    }
  }
  return ranked;
}

bool isSamePose(const FittedPose &p, const FittedPose &q)
{
  return distance(p, q.plane) < samePose || isOnOneSide(p.plane, q.plane);
}

void keepTwo(RankedFits &ranked)
{
  Few<FittedPose> kept;
  for (const FittedPose &fit : ranked.fits) {
    if (kept.empty() || (kept.size() < 2 && !isSamePose(kept[0], fit))) {
      kept.push_back(fit);
    }
  }
  ranked.fits = kept;
}

RankedFits withMirrored(const std::vector<FitPixel> &pixels, const RankedFits &ranked, const MarkerPattern &pattern,
                        const FitSettings &settings, Fitter &fitter)
{
  const FittedPose &best = ranked.fits[0];
  Few<FitStart> starts;
  starts.push_back({mirrored(best.plane), best.photometry, ranked.noise});
  Few<FittedPose> fits = fitAll(pixels, starts, pattern, settings, fitter, best);
  fits.push_back(best);
  RankedFits both = rank(pixels, pattern, true, fits, fitter);
  keepTwo(both);
  return both;
}

RankedFits fitExtended(const std::vector<FitPixel> &pixels, const RankedFits &fits, const LightExtension &extension,
                       const MarkerPattern &pattern, FitSettings settings, Fitter &fitter)
{
  settings.samePixels = true;
  Few<FitStart> starts;
  for (const FittedPose &fit : fits.fits) {
    Photometry light = fit.photometry;
    extension.extend(light);
    starts.push_back({fit.plane, light, fits.noise});
  }
  Few<FittedPose> extended = fitAll(pixels, starts, pattern, settings, fitter);
  extended.push_back(fits.fits[0]);
  RankedFits ranked = rank(pixels, pattern, true, extended, fitter);
  const FittedPose &best = ranked.fits[0];
  const auto isWithout = [&](const FittedPose &fit) { return !extension.has(fit.photometry); };
  FittedPose *const last = std::find_if(ranked.fits.begin(), ranked.fits.end(), isWithout);
  if (last == ranked.fits.end() || isWithout(best) || !extension.isPossible(best.photometry) ||
      costOf(last->squares - best.squares, ranked.noise, best.sharing) / best.edgeNoise < extension.leastGain) {
    return fits;
  }
  std::rotate(last, last + 1, ranked.fits.end());
  ranked.fits.pop_back();
  keepTwo(ranked);
  return ranked.fits.size() > 1 ? ranked : withMirrored(pixels, ranked, pattern, settings, fitter);
}

bool isSameLight(const Photometry &p, const Photometry &q)
{
  return std::abs(p.blur.sigma - q.blur.sigma) < sameLight && std::abs(p.gamma - q.gamma) < sameGamma * p.gamma;
}

bool isHopeless(const FittedPose &fit, const FittedPose &best, double noise)
{
  const double behind = fit.squares - best.squares;
  const double ahead = fit.isSettled ? 0. : std::min(fit.decrement, 0.5 * behind);
  return costOf(behind - ahead, noise, best.sharing) > hopelessOdds;
}
} // namespace circle_marker
END_VISP_NAMESPACE
