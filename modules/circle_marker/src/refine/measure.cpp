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
#include <array>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "refine/few_pixels.h"
#include "refine/shadow.h"
#include "refine/surround.h"
#include "support/few.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
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

// Bounds of the blur that sets the width of the band of pixels around an edge, pixels, and of its elongation: motion
// of 12 pixels makes a sharp picture's blur 4.5 times as long as wide.
constexpr double leastBlur = 0.6;
constexpr double mostBlur = 6.;
constexpr double mostElongation = 0.75;
// Pixels that were chosen for a blur narrower than the present one by this factor in any direction do not show it.
constexpr double muchWider = 1.5;
// All pixels are used up to a marker of some 500 pixels diameter: every pixel that is left out is information lost.
constexpr double manyPixels = 20000.;
// How far the first fits may go from the outlines, and the later ones from these, until their pixels are sorted anew,
// pixels.
constexpr double coarseError = 2.;
constexpr double fineError = 0.6;
// Borders of sectors that a pixel may see in the first fits: of those farther away few see any.
constexpr int coarseBorders = 3;
// Last step of the coarse fit, in standard deviations, and its steps at most: a pose that fits badly creeps. Where
// there is no code, or perhaps another one, even the right one may.
constexpr double coarseConvergence = 0.5;
constexpr int coarseIterations = 4;
constexpr int coarseIterationsUncertain = 6;
// Looks at few pixels: those around an outline that is off by more than the blur do not show where it should be.
constexpr int mostLooks = 3;
constexpr double farOff = 0.8; // pixels
// Error with which the closed form knows the axes of the outline, pixels.
constexpr double outlineError = 0.1;
// Black that has grown by more than this on each side, pixels, three times what is expected of it at most, is another
// ring.
constexpr double mostGrowth = 0.9;
// Two fits of one marker stand in the same light, and are equally sharp: by this difference of their blur or of the
// growth of black, pixels, one of them is not at its minimum.
constexpr double sameLight = 0.03;
// A pose whose log-odds against are beyond this on the coarse pixels is not refined any further.
constexpr double hopelessOdds = 30.;
// Of smaller markers, radius in pixels, both are refined: all pixels cost little more than the few, and a coarse fit
// that was stuck made the right pose of some markers of 16 pixels hopeless.
constexpr double leastHopelessSize = 20.;
// And a fit that is so far behind another one, and does not catch up, is not taken to its end; if there is a code:
// without one the poses differ by little, and come to their likelihoods slowly.
constexpr double givenUpOdds = 3. * hopelessOdds;

bool isSamePose(const FittedPose &p, const FittedPose &q)
{
  const Eigen::Vector3d turn = 0.5 * (p.plane.rotation.col(2).cross(q.plane.rotation.col(2)));
  const Eigen::Matrix3d covariance =
      p.covariance.bottomRightCorner<3, 3>() + 1e-12 * Eigen::Matrix3d::Identity(); // the held spin leaves it singular
  const double squared = 4. * turn.dot(covariance.inverse() * turn);
  return p.plane.rotation.col(2).dot(q.plane.rotation.col(2)) > 0. && squared < samePose * samePose;
}
// The marker turned about its centre, the shortest way, so that its normal has another direction.
MarkerPlane turnedTo(const MarkerPlane &plane, const Eigen::Vector3d &normal)
{
  MarkerPlane turned = plane;
  turned.rotation =
      Eigen::Quaterniond::FromTwoVectors(plane.rotation.col(2), normal).toRotationMatrix() * plane.rotation;
  return turned;
}

// The blur by which pixels are chosen.
BlurParameters boundedBlur(const BlurParameters &fitted)
{
  BlurParameters blur;
  blur.sigma = std::clamp(fitted.sigma, leastBlur, mostBlur);
  const double size = fitted.elongation.norm();
  blur.elongation = fitted.elongation * std::min(1., mostElongation / std::max(size, 1e-12));
  return blur;
}

// Size of a pixel at the marker's centre, normalised coordinates.
double meterPerPixelAt(const MarkerPlane &plane, const CameraModel &camera)
{
  return camera.meterPerPixel(camera.toPixel(plane.project(Eigen::Vector2d::Zero()))).col(0).norm();
}

// Where to start from: the two poses of the outline; or, if it is too round to show its tilt, four directions of tilt.
// Facing the camera is a saddle of the likelihood, from which no descent leads away.
Few<FitStart> startsOf(const PosePair &poses, const CameraModel &camera, bool spinIsKnown)
{
  const MarkerPlane &plane = poses[0];
  const Eigen::Vector3d sight = plane.center.normalized();
  const double radius = plane.radius / (plane.center.z() * meterPerPixelAt(plane, camera)); // pixels
  const double leastTilt = std::sqrt(2. * outlineError / radius); // its cosine shortens an axis by outlineError
  if (std::acos(std::min(plane.rotation.col(2).dot(sight), 1.)) > leastTilt) {
    // Without a code the spins are any: what lies around the marker is known by its direction in one of them.
    MarkerPlane second = poses[1];
    if (!spinIsKnown) {
      copySpin(poses[0], second);
    }
    Few<FitStart> two;
    two.push_back({poses[0], std::nullopt, std::nullopt});
    two.push_back({second, std::nullopt, std::nullopt});
    return two;
  }
  const Eigen::Vector3d first = plane.rotation.col(0) - plane.rotation.col(0).dot(sight) * sight;
  const Eigen::Vector3d across = first.normalized();
  const Eigen::Vector3d along = sight.cross(across);
  Few<FitStart> starts;
  for (const Eigen::Vector3d &direction : {across, Eigen::Vector3d(-across), along, Eigen::Vector3d(-along)}) {
    const Eigen::Vector3d normal = std::cos(leastTilt) * sight + std::sin(leastTilt) * direction;
    starts.push_back({turnedTo(plane, normal), std::nullopt, std::nullopt});
  }
  return starts;
}

// Keeps the best pose and the best of those that are not the same as it.
void keepTwo(Few<FittedPose> &ranked)
{
  Few<FittedPose> kept;
  for (const FittedPose &fit : ranked) {
    if (kept.empty() || (kept.size() < 2 && !isSamePose(kept[0], fit))) {
      kept.push_back(fit);
    }
  }
  ranked = kept;
}

// Fits every start on the pixels; those that lead nowhere are left out. A start is given up when it is behind the best
// fit before it by some log-odds.
Few<FittedPose> fitAll(const std::vector<FitPixel> &pixels, const Few<FitStart> &starts, const MarkerPattern &pattern,
                       FitSettings settings, double givenUp, Fitter &fitter)
{
  Few<FittedPose> fits;
  for (const FitStart &start : starts) {
    const auto fit = fitter.fitPose(pixels, start, pattern, settings);
    settings.samePixels = true;
    if (!fit) {
      continue;
    }
    fits.push_back(*fit);
    if (pattern.sectors > 0 && fit->isSettled && (!settings.rival || fit->noise < settings.rival->noise)) {
      settings.rival = Rival{fit->squares, fit->noise, givenUp};
    }
  }
  return fits;
}

// Puts the fit that explains the pixels best first; all are judged by the noise of the best. Returns that noise.
double rank(const std::vector<FitPixel> &pixels, const MarkerPattern &pattern, bool exactBends, Few<FittedPose> &fits,
            Fitter &fitter)
{
  const auto best = std::min_element(fits.begin(), fits.end(),
                                     [](const FittedPose &p, const FittedPose &q) { return p.noise < q.noise; });
  const double noise = best->noise;
  if (fits.size() > 1) {
    const Photometry surround = best->photometry;
    for (FittedPose &fit : fits) {
      fit.squares = fitter.robustSquares(pixels, fit, pattern, surround, noise, exactBends);
    }
    const auto isBetter = [](const FittedPose &p, const FittedPose &q) { return p.squares < q.squares; };
    for (FittedPose *next = fits.begin(); next != fits.end(); ++next) {
      std::iter_swap(next, std::min_element(next, fits.end(), isBetter));
    }
  }
  return noise;
}

// A pose without a chance beside the best, by what the few pixels say: neither as it is nor one step on, if its steps
// were cut off. What that step would bring is known roughly, far from the minimum: to half of the way it is behind.
bool isHopeless(const FittedPose &fit, const FittedPose &best, double noise)
{
  const double behind = fit.squares - best.squares;
  const double ahead = fit.isSettled ? 0. : std::min(fit.decrement, 0.5 * behind);
  return behind - ahead > 2. * hopelessOdds * noise * noise;
}

// The pose that looks nearly the same: its normal on the other side of the line of sight.
MarkerPlane mirrored(const MarkerPlane &plane)
{
  const Eigen::Vector3d sight = plane.center.normalized();
  const Eigen::Vector3d normal = plane.rotation.col(2);
  return turnedTo(plane, 2. * normal.dot(sight) * sight - normal);
}

bool isSameLight(const Photometry &p, const Photometry &q)
{
  return std::max(std::abs(p.blur.sigma - q.blur.sigma), std::abs(p.blur.growth - q.blur.growth)) < sameLight;
}

// Leaves out what is known to be covered: much of it would pull the first steps away, and raise what is taken for
// noise.
void dropCovered(const Recognition &marker, std::vector<FitPixel> &pixels)
{
  if (marker.seen) {
    pixels.erase(std::remove_if(pixels.begin(), pixels.end(),
                                [&](const FitPixel &pixel) { return !marker.seen->holds(pixel.meter.cast<double>()); }),
                 pixels.end());
  }
}

// Fits on the same pixels, the best first, and its noise.
struct RankedFits
{
  Few<FittedPose> fits;
  double noise = 0.;
};

// Fits from all starts on few pixels around some poses; those that are the same count once.
RankedFits fitAround(const vpImage<unsigned char> &I, const CameraModel &camera, const ImageFrame &frame,
                     const Recognition &marker, const MarkerPattern &pattern, const FitSettings &settings,
                     const Few<MarkerPlane> &around, const BlurParameters &blur, const Few<FitStart> &starts,
                     MeasureMemory &memory)
{
  selectFewPixels(I, camera, frame, around.data(), around.size(), pattern, blur, memory.pixels);
  dropCovered(marker, memory.pixels);
  RankedFits ranked;
  ranked.fits = fitAll(memory.pixels, starts, pattern, settings, givenUpOdds, *memory.fitter);
  if (!ranked.fits.empty()) {
    ranked.noise = rank(memory.pixels, pattern, settings.exactBends, ranked.fits, *memory.fitter);
    keepTwo(ranked.fits);
  }
  return ranked;
}

// Coarse fits from all starts on few pixels around them; if the best has come far from its start, again on the pixels
// around where it is now.
RankedFits fitFewPixels(const vpImage<unsigned char> &I, const CameraModel &camera, const ImageFrame &frame,
                        const Recognition &marker, const MarkerPattern &pattern, const FitSettings &settings,
                        MeasureMemory &memory)
{
  RankedFits ranked;
  Few<MarkerPlane> around;
  for (const MarkerPlane &pose : marker.poses) {
    around.push_back(pose);
  }
  Few<FitStart> starts = startsOf(marker.poses, camera, settings.spinIsKnown);
  BlurParameters blur; // of a sharp picture
  for (int look = 0; look < mostLooks; ++look) {
    const RankedFits now = fitAround(I, camera, frame, marker, pattern, settings, around, blur, starts, memory);
    if (now.fits.empty()) {
      break;
    }
    ranked = now;
    const Few<FittedPose> &fits = ranked.fits;
    const MarkerPlane &best = fits[0].plane;
    const auto isNear = [&](const MarkerPlane &looked) {
      return outlineMotion(looked, best) < farOff * meterPerPixelAt(best, camera);
    };
    const BlurParameters fitted = boundedBlur(fits[0].photometry.blur);
    const bool isWide = fitted.widest() > muchWider * blur.widest();
    // With a light far from what was guessed, of which an over-exposed picture shows little, even the best creeps. They
    // all stand in the same light.
    const bool isSettled = fits[0].isSettled || settings.mostIterations == 0;
    if (!isWide && isSettled && std::any_of(around.begin(), around.end(), isNear)) {
      break;
    }
    blur = fitted;
    around.clear();
    starts.clear();
    for (const FittedPose &fit : fits) {
      around.push_back(fit.plane);
      std::optional<Photometry> light;
      if (isWide || !isSettled) {
        light = isSettled ? fit.photometry : fits[0].photometry;
      }
      starts.push_back({fit.plane, light, std::nullopt});
    }
  }
  return ranked;
}

// What covers a part of a marker draws its outline aside, and of the two poses the right one may end in a minimum
// beside its own, where it looks hopeless: the mirrored pose of the best fit is a start that nothing has drawn.
void addMirrored(const vpImage<unsigned char> &I, const CameraModel &camera, const ImageFrame &frame,
                 const Recognition &marker, const MarkerPattern &pattern, const FitSettings &settings,
                 MeasureMemory &memory, RankedFits &ranked)
{
  const Few<FittedPose> &fits = ranked.fits;
  if (fits.empty() || (fits.size() > 1 && isSameLight(fits[0].photometry, fits[1].photometry))) {
    return;
  }
  Few<MarkerPlane> around;
  Few<FitStart> starts;
  for (const MarkerPlane &plane : {fits[0].plane, mirrored(fits[0].plane)}) {
    around.push_back(plane);
    starts.push_back({plane, fits[0].photometry, std::nullopt});
  }
  if (fits.size() > 1) {
    starts.push_back({fits[1].plane, fits[1].photometry, std::nullopt});
  }
  const BlurParameters blur = boundedBlur(fits[0].photometry.blur);
  const RankedFits again = fitAround(I, camera, frame, marker, pattern, settings, around, blur, starts, memory);
  if (!again.fits.empty()) {
    ranked = again;
  }
}

// Whether a ring has the design's ratio of radii, whatever the first look at it said: it fits, and black is not larger
// or smaller than printers and cameras make it.
bool isRightRing(const RankedFits &ranked)
{
  return !ranked.fits.empty() && ranked.fits[0].correlation >= leastCorrelationWithoutCode &&
         std::abs(ranked.fits[0].photometry.blur.growth) < mostGrowth;
}
} // namespace

ImageFrame frameOf(const MarkerPlane &plane, const CameraModel &camera)
{
  return {camera.toPixel(plane.project(Eigen::Vector2d::Zero())),
          plane.radius / (plane.center.z() * meterPerPixelAt(plane, camera))};
}

std::optional<Measurement> measure(const vpImage<unsigned char> &I, const CameraModel &camera,
                                   const Recognition &marker, bool refine, MeasureMemory &memory)
{
  MarkerPattern pattern = patternOf(marker.family, marker.code.id, marker.family.getLayout().ringInner);
  FitSettings settings;
  settings.spinIsKnown = pattern.sectors > 0;
  settings.poseError = fineError;
  settings.growth = pattern.ringEdges > 1; // the size of a lone disc cannot be told from a growth of its black

  const ImageFrame frame = frameOf(marker.poses[0], camera);
  if (!marker.seen) { // what covers a marker looks like the edge of a shadow
    settings.shadow = shadowOn(I, camera, frame, marker.poses[0], marker.family.getLayout().quietZone);
  }

  // All starts on few pixels, to know which are worth more and how wide the blur is.
  FitSettings coarse = settings;
  coarse.convergence = coarseConvergence;
  coarse.poseError = coarseError;
  coarse.bordersSeen = coarseBorders;
  coarse.exactBends = false;
  const bool isCodeKnown = pattern.sectors > 0 && marker.isCertain;
  coarse.mostIterations = !refine ? 0 : isCodeKnown ? coarseIterations : coarseIterationsUncertain;
  RankedFits few = fitFewPixels(I, camera, frame, marker, pattern, coarse, memory);
  if (marker.ringInner != marker.family.getLayout().ringInner && !isRightRing(few)) {
    pattern = patternOf(marker.family, marker.code.id, marker.ringInner);
    few = fitFewPixels(I, camera, frame, marker, pattern, coarse, memory);
  }
  if (marker.seen && refine) {
    addMirrored(I, camera, frame, marker, pattern, coarse, memory, few);
  }
  Few<FittedPose> &fits = few.fits;
  double noise = few.noise;
  if (fits.empty()) {
    return std::nullopt;
  }

  // Those that have a chance on all pixels.
  std::optional<FittedPose> hopeless;
  double hopelessCost = 0.;
  if (refine) {
    if (fits.size() > 1 && frame.size > leastHopelessSize && isHopeless(fits[1], fits[0], noise)) {
      hopeless = fits[1];
      hopelessCost = (fits[1].squares - fits[0].squares) / (2. * noise * noise);
      fits.pop_back();
    }
    const std::array<MarkerPlane, 2> planes = {fits.front().plane, fits.back().plane};
    const BlurParameters blur = boundedBlur(fits[0].photometry.blur);
    if (!settings.spinIsKnown) {
      PaperEnd &square = pattern.paper[static_cast<std::size_t>(PaperShape::SQUARE)];
      square.angle = squareAngleOf(I, camera, planes[0], square.extent, blur.sigma);
    }
    memory.fitter->selectPixels(I, camera, frame, planes.data(), fits.size(), pattern, blur, manyPixels, memory.pixels);
    dropCovered(marker, memory.pixels);
    Few<FitStart> starts;
    for (const FittedPose &fit : fits) {
      starts.push_back({fit.plane, fit.photometry, noise});
    }
    fits = fitAll(memory.pixels, starts, pattern, settings, givenUpOdds, *memory.fitter);
    if (fits.empty()) {
      return std::nullopt;
    }
    noise = rank(memory.pixels, pattern, true, fits, *memory.fitter);
    // From where a small marker's coarse fit ends, a wrong pose may come to its minimum and the right one be stuck.
    if (fits.size() > 1 && !isSameLight(fits[0].photometry, fits[1].photometry)) {
      const FitStart again = {mirrored(fits[0].plane), fits[0].photometry, noise};
      settings.samePixels = true;
      if (const auto other = memory.fitter->fitPose(memory.pixels, again, pattern, settings)) {
        fits.push_back(*other);
        noise = rank(memory.pixels, pattern, true, fits, *memory.fitter);
        keepTwo(fits);
      }
    }
  }
  const double refined = pattern.sectors > 0 ? leastCorrelation : leastCorrelationWithoutCode;
  const double least = refine ? refined : leastCorrelationUnrefined;
  const bool isExplained = fits[0].correlation >= least && fits[0].inliers >= leastInliers;
  if (!isExplained) {
    return std::nullopt;
  }
  Measurement result;
  result.first = fits[0];
  result.cost = fits[0].squares / (2. * noise * noise);
  if (fits.size() > 1 && !isSamePose(fits[0], fits[1])) {
    result.second = fits[1];
    result.cost2 = fits[1].squares / (2. * noise * noise);
  }
  else if (hopeless) {
    // What the few pixels say against it: all of them would say more.
    result.second = hopeless;
    result.cost2 = result.cost + hopelessCost;
  }
  return result;
}
} // namespace circle_marker
END_VISP_NAMESPACE
