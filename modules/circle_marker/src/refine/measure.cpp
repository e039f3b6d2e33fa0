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
 * Both poses of a recognised marker, refined and weighed against each other.
 */

#include "refine/measure.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

BEGIN_VISP_NAMESPACE
namespace circle_marker
{
namespace
{
// A marker's image agrees with its model to better than this correlation, even with noise of a third of the contrast;
// without refinement the start is worth less.
constexpr double leastCorrelation = 0.85;
// A marker without a code has its shape alone to prove itself.
constexpr double leastCorrelationWithoutCode = 0.94;
constexpr double leastCorrelationUnrefined = 0.6;
// Share of the pixels that the model must explain.
constexpr double leastInliers = 0.5;
// Two fits closer than this, in standard deviations, are one pose.
constexpr double samePose = 0.3;

// Blur of a sharp picture, lens 0.75 and pixel area 0.29, pixels; from which a wider band is worth a second fit; and
// the widest.
constexpr double commonBlur = 0.8;
constexpr double muchBlur = 1.1;
constexpr double mostBlur = 6.;
// Pixels of the first, coarse fit: 25 for each of its 12 parameters still make a good start for the fine one.
constexpr std::size_t coarsePixels = 400;
// A pose whose log-odds against are beyond this on the coarse pixels is not refined any further.
constexpr double hopelessOdds = 100.;

bool isSamePose(const FittedPose &p, const FittedPose &q)
{
  const Eigen::Vector3d turn = 0.5 * (p.plane.rotation.col(2).cross(q.plane.rotation.col(2)));
  const Eigen::Matrix3d covariance = p.covariance.bottomRightCorner<3, 3>() +
                                     1e-12 * Eigen::Matrix3d::Identity(); // the held spin leaves it singular
  const double squared = 4. * turn.dot(covariance.inverse() * turn);
  return p.plane.rotation.col(2).dot(q.plane.rotation.col(2)) > 0. && squared < samePose * samePose;
}
// Refines both poses on a part of the pixels, and then on all of them what is worth it.
std::vector<FittedPose> fitBoth(const std::vector<FitPixel> &pixels, const PosePair &poses,
                                const MarkerPattern &pattern, const FitSettings &settings)
{
  const std::size_t stride = std::max<std::size_t>(1, pixels.size() / coarsePixels);
  std::vector<FittedPose> fits;
  for (const MarkerPlane &start : poses) {
    if (const auto fit = fitPose(pixels, stride, {start, std::nullopt}, pattern, settings)) {
      fits.push_back(*fit);
    }
  }
  if (stride == 1 || fits.empty()) {
    return fits;
  }
  double least = HUGE_VAL;
  double noise = HUGE_VAL;
  for (const FittedPose &fit : fits) {
    least = std::min(least, fit.squares);
    noise = std::min(noise, fit.noise);
  }
  for (FittedPose &fit : fits) {
    if (fit.squares - least > 2. * hopelessOdds * noise * noise) {
      continue;
    }
    if (const auto fine = fitPose(pixels, 1, {fit.plane, fit.photometry}, pattern, settings)) {
      fit = *fine;
    }
  }
  return fits;
}
} // namespace

std::optional<Measurement> measure(const vpImage<unsigned char> &I, const CameraModel &camera,
                                   const Recognition &marker, bool refine, std::vector<FitPixel> &pixels)
{
  const MarkerPattern pattern = patternOf(marker.family, marker.code.id, marker.ringInner);
  const double quietZone = marker.family.getLayout().quietZone;
  selectPixels(I, camera, marker.poses.data(), marker.poses.size(), pattern, commonBlur, quietZone, pixels);
  FitSettings settings;
  settings.spinIsKnown = pattern.sectors > 0;
  settings.growth = pattern.ringEdges > 1; // the size of a lone disc cannot be told from a growth of its black
  settings.mostIterations = refine ? settings.mostIterations : 0;
  std::vector<FittedPose> fits = fitBoth(pixels, marker.poses, pattern, settings);
  if (refine && !fits.empty() && fits[0].photometry.blur.sigma > muchBlur) {
    // The band around the edges was too narrow to see all of them.
    const double blur = std::min(fits[0].photometry.blur.sigma, mostBlur);
    selectPixels(I, camera, marker.poses.data(), marker.poses.size(), pattern, blur, quietZone, pixels);
    fits = fitBoth(pixels, marker.poses, pattern, settings);
  }
  if (fits.empty()) {
    return std::nullopt;
  }
  // Both are judged by the noise of the one that explains the image better.
  double noise = HUGE_VAL;
  for (const FittedPose &fit : fits) {
    noise = std::min(noise, fit.noise);
  }
  for (FittedPose &fit : fits) {
    fit.squares = robustSquares(pixels, fit, pattern, noise);
  }
  std::sort(fits.begin(), fits.end(), [](const FittedPose &p, const FittedPose &q) { return p.squares < q.squares; });
  const double refined = pattern.sectors > 0 ? leastCorrelation : leastCorrelationWithoutCode;
  const double least = refine ? refined : leastCorrelationUnrefined;
  if (fits[0].correlation < least || fits[0].inliers < leastInliers) {
    return std::nullopt;
  }
  Measurement result;
  result.first = fits[0];
  result.cost = fits[0].squares / (2. * noise * noise);
  if (fits.size() > 1 && !isSamePose(fits[0], fits[1])) {
    result.second = fits[1];
    result.cost2 = fits[1].squares / (2. * noise * noise);
  }
  return result;
}
} // namespace circle_marker
END_VISP_NAMESPACE
