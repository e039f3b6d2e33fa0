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
 * A marker in an image that the camera has sharpened: measured in what that was before.
 */

#include "vpDetectorCircleMarkerImpl.h"

#include <algorithm>
#include <cmath>

#include "refine/coarse_fits.h"
#include "refine/fit_starts.h"
#include "support/sensor_range.h"
#include "outer_edge.h"

BEGIN_VISP_NAMESPACE

using namespace circle_marker;

namespace {
// What leaves more than this factor of the noise, beyond so many standard deviations of chance, may have been
// sharpened. Of images that were not, with noise of 0 to 8 grey levels, it is a few markers of a hundred; larger limits
// miss small rings.
constexpr double muchLeft = 1.03;
constexpr double clearOfChance = 1.7;
// Beside a larger marker, radius in pixels, a halo is seen if there is one; to search for its mask takes long.
constexpr double largestWithoutHalo = 100.;
// What is like no marker in the image as it is leaves no more than this factor of the noise in what that was before:
// undoing a mask takes from what covers a part of a code, too.
constexpr double mostLeftOfUnlike = 1.6;
// A halo moves edges by less than this, pixels. (Those of a disc in a photograph were moved by 1.1 pixels behind a mask
// that was none, testPhotographs; behind masks of two times the detail of 2 pixels it is some 0.1.)
constexpr double mostShift = 0.4;
// Nor does what is left become more than this many times as much, in units of the noise.
constexpr double mostWorse = 1.2;
// It has a code, as much that is round is like a ring behind some mask (clutter had twice as many rings); and it has no
// larger radius than this, pixels: halos are some pixels wide, and large markers are like one with them.
constexpr double largestUnlike = 60.;
// Masks take from the blur, as much as this one adds to it, pixels.
constexpr double takenByMasks = 0.5;
// By so much, ln, a mask has to make the image likelier. (Two parameters gain 1 by chance.)
constexpr double leastGain = 10.;

// Noise behind a mask: of the highest frequencies, by which a marker is measured.
ImageNoise noiseBehind(const UnsharpMask &mask, const ImageNoise &noise)
{
  return {std::max(noise.sigma / (1. + mask.amount), quantisation), noise.sharing, noise.isResampled};
}

// By how much the outer edge lies farther out or in by one measurement than by the other, pixels.
double shiftBetween(const FittedPose &one, const FittedPose &other, const CameraModel &camera)
{
  const double scale = frameOf(one.plane, camera).size / frameOf(other.plane, camera).size;
  return std::abs(scale - 1.) * frameOf(one.plane, camera).size;
}

cv::Rect boxOf(const PixelBox &box)
{
  return {box.left, box.top, box.width(), box.height()};
}
} // namespace

/*!
  The same, whatever the ratio of a ring. What is none though its code was read, or leaves more than noise, may be in
  an image that the camera has sharpened: then it is measured in what the image was before.
*/
bool vpDetectorCircleMarker::Impl::measureSharpened(const Visit &visit, const EllipseCandidate &outline,
                                                    const Recognition &marker, Workspace &workspace, Found &measured,
                                                    Fit &fit) const
{
  const bool isMeasured = measureIn(visit, outline, marker, workspace, measured, fit);
  if (!settings.refinePose || marker.seen || marker.blurred || visit.deadline.hasPassed()) {
    return isMeasured;
  }
  const auto mayBeSharpened = [&] {
    const FittedPose &first = fit.measurement->first;
    const double most = mostLeftByNoise(first, fit.pixels, visit.noise.sigma, muchLeft, clearOfChance);
    return fit.halo >= leastHalo ||
           (frameOf(first.plane, visit.camera).size < largestWithoutHalo && first.noise > most);
  };
  const auto mayBeRestored = [&] {
    return marker.isCertain && marker.family.isCoded() && frameOf(marker.poses[0], visit.camera).size < largestUnlike;
  };
  if (isMeasured ? !mayBeSharpened() : !mayBeRestored()) {
    return isMeasured;
  }
  if (!isMeasured) {
    for (const MarkerPlane &pose : marker.poses) {
      fit.poses.push_back(pose);
    }
  }
  const bool isRestored = searchMask(visit, outline, isMeasured ? measured.marker : marker, workspace, fit, measured);
  return isMeasured || (isRestored && fit.left < mostLeftOfUnlike);
}

/*!
  Looks for the mask behind which a marker is explained best, and measures it there. False, and nothing changes, if the
  image was not sharpened.
*/
bool vpDetectorCircleMarker::Impl::searchMask(const Visit &visit, const EllipseCandidate &outline,
                                              const Recognition &marker, Workspace &workspace, Fit &fit,
                                              Found &measured) const
{
  Recognition there = marker;
  there.asSeen = &visit.I;
  there.poses[0] = fit.poses[0].flattened();
  there.poses[1] = fit.poses.size() > 1 ? fit.poses[1].flattened() : mirrored(there.poses[0]);
  const cv::Rect box = boxOf(surroundingsOf(outline, there.family, visit.I));
  std::optional<FittedPose> around; // where it was measured first: around its edges pixels are chosen
  const auto choose = [&](const FittedPose &found) {
    around = found;
    around->photometry.toneCurve.reset();
    around->photometry.lightCurvature.reset();
    around->photometry.blur.sigma = std::hypot(found.photometry.blur.sigma, takenByMasks);
  };
  if (fit.measurement) {
    choose(fit.measurement->first);
  }
  const auto behind = [&](const UnsharpMask &mask, const FittedPose *nearest) -> std::optional<FitBehind> {
    if (!undo(mask, visit.I, box, visit.deadline, workspace.restored)) {
      return std::nullopt;
    }
    const ImageNoise noise = noiseBehind(mask, visit.noise);
    if (!around || nearest == nullptr) {
      const auto first =
          measureInOneLook(workspace.restored, visit.camera, there, workspace.measuring, visit.deadline, noise);
      if (!first) {
        return std::nullopt;
      }
      choose(*first);
      nearest = &*around; // once more, as all that it will be compared with
    }
    const auto found = measureNearby(workspace.restored, visit.camera, there, *around, *nearest, workspace.measuring,
                                     visit.deadline, noise);
    if (!found || (fit.measurement && shiftBetween(fit.measurement->first, *found, visit.camera) > mostShift)) {
      return std::nullopt;
    }
    return FitBehind{*found, workspace.measuring.pixels.size()};
  };
  FittedPose from;
  from.plane = there.poses[0];
  if (fit.measurement) {
    from = fit.measurement->first;
  }
  else { // nothing is known of paper and ink
    from.photometry.white = 255.;
    from.photometry.absorption = 1.;
  }
  const auto known = !fit.measurement        ? MaskSearch::Known::NOTHING
                     : fit.halo >= leastHalo ? MaskSearch::Known::HALO
                                             : MaskSearch::Known::POSE;
  MaskSearch search(from, known, std::max(visit.noise.sigma, quantisation), behind);
  const auto found = search.run();
  return found && found->gain > leastGain && !visit.deadline.hasPassed() &&
         measureBehind(visit, *found, outline, there, workspace, fit, measured);
}

/*! A marker in what the image was before a mask; false, and nothing changes, if it is none there. */
bool vpDetectorCircleMarker::Impl::measureBehind(const Visit &visit, const SearchedMask &found,
                                                 const EllipseCandidate &outline, const Recognition &marker,
                                                 Workspace &workspace, Fit &fit, Found &measured) const
{
  const cv::Rect around = boxOf(surroundingsOf(outline, marker.family, visit.I));
  if (!undo(found.mask, visit.I, around, visit.deadline, workspace.restored)) {
    return false;
  }
  const ImageNoise noise = noiseBehind(found.mask, visit.noise);
  const Visit before = {workspace.restored, visit.size, visit.camera,          visit.deadline, noise,
                        visit.isSizeGiven,  &found,     visit.isCameraGuessed, false};
  Fit restoredFit;
  Found restored;
  if (!measureIn(before, outline, marker, workspace, restored, restoredFit)) {
    return false;
  }
  // With light and code looked at again it may be another marker, or a worse one.
  if (fit.measurement &&
      (restored.marker.code.id != measured.marker.code.id ||
       shiftBetween(fit.measurement->first, restoredFit.measurement->first, visit.camera) > mostShift ||
       restoredFit.left > mostWorse * fit.left)) {
    return false;
  }
  restored.noise = visit.noise;
  restored.marker.asSeen = nullptr;
  measured = std::move(restored);
  fit = restoredFit;
  return true;
}

END_VISP_NAMESPACE
