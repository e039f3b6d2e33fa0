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
 * Coarse fits of a marker in uneven light.
 */

#include "refine/missed_light.h"

#include <algorithm>

#include <Eigen/LU>

#include "refine/light_fit.h"
#include "support/sensor_range.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// A fit that leaves more than this share of the contrast unexplained, and more than this factor of the noise, may have
// missed that the light is uneven.
constexpr double muchUnexplained = 0.03;
constexpr double muchMoreThanNoise = 1.4;
// Of a plain ring or a disc, whose pose bends to where no code would follow: with the limits above one of 70 pixels was
// mirrored by odds of e^19 under a weak reflection. Below this radius, pixels, light explains a little of anything.
constexpr double muchUnexplainedUncoded = 0.015;
constexpr double muchMoreThanNoiseUncoded = 1.2;
constexpr double leastSizeUncoded = 20.;
// In even light no more than this share of the variance is left that is not the noise's. By private counts of markers
// of 12 to 45 pixels nine in ten under reflections have less than 0.24, nine in ten that were moved, or compressed by
// JPEG, more than 0.4.
constexpr double mostLeftInEvenLight = 0.3;
// The paper is brighter than the sensor can tell if that is what the fit says, and this share of the pixels.
constexpr double mostTooBright = 0.01;
// What correlates by less is no print: of 1300 under reflections none did by less than 0.91 (private counts), and one
// that was read wrong did by 0.81, and was explained by light.
constexpr double leastCorrelation = 0.9;
// The light by the first fits is a little off, as their poses are.
constexpr int rounds = 3;

// Variance that a fit leaves besides that of the image's noise, grey levels^2.
double excessOf(const FittedPose &fit, double noise)
{
  const double left = unexplainedBy(fit);
  return left * left - noise * noise;
}

bool isPaperTooBright(const FittedPose &fit, const std::vector<FitPixel> &pixels)
{
  const auto isTooBright = [](const FitPixel &pixel) { return mayBeTooBright(pixel.grey); };
  const auto count = std::count_if(pixels.begin(), pixels.end(), isTooBright);
  return mayBeTooBright(fit.photometry.white) &&
         static_cast<double>(count) > mostTooBright * static_cast<double>(pixels.size());
}

// From the coordinates of an image's frame to the marker's plane, in outer radii, near its centre.
Eigen::Matrix2d toSheet(const MarkerPlane &plane, const MarkerInImage &view)
{
  Eigen::Matrix2d radii;
  const Eigen::Vector2d center = view.camera.toPixel(plane.project(Eigen::Vector2d::Zero()));
  for (int i = 0; i < 2; ++i) {
    radii.col(i) = (view.camera.toPixel(plane.project(Eigen::Vector2d::Unit(i))) - center) / view.frame.size;
  }
  return radii.inverse();
}
} // namespace

bool mayBeInUnevenLight(const MarkerInImage &view, const MarkerPattern &pattern, const RankedFits &few,
                        const std::vector<FitPixel> &pixels, double noise)
{
  const Recognition &marker = view.marker;
  if (marker.seen || !marker.isCertain || few.fits.empty() || few.fits[0].correlation < leastCorrelation) {
    return false;
  }
  const FittedPose &fit = few.fits[0];
  const bool isUncoded = pattern.sectors == 0 && view.frame.size > leastSizeUncoded;
  const double share = isUncoded ? muchUnexplainedUncoded : muchUnexplained;
  const double factor = isUncoded ? muchMoreThanNoiseUncoded : muchMoreThanNoise;
  const double most = std::max(share * fit.photometry.tellableContrast(), factor * noise);
  return unexplainedBy(fit) > most && !isPaperTooBright(fit, pixels);
}

bool tellLight(MarkerInImage &view, const MarkerPattern &pattern, const FittedPose &fit, const FitSettings &settings,
               FittingMemory &memory)
{
  memory.fitter->explainPixels(memory.pixels, fit, pattern, memory.explained);
  if (view.uneven) {
    for (ExplainedPixel &pixel : memory.explained) {
      const Eigen::Vector2d place = view.frame.center + view.frame.size * pixel.offset.cast<double>();
      pixel.grey = static_cast<float>(view.uneven->uneven(place, pixel.grey));
    }
  }
  const auto now = unevenLightOf(memory.explained, view.frame, toSheet(fit.plane, view), settings.noise.sigma);
  if (now) {
    view.uneven = now;
  }
  return now.has_value();
}

RankedFits withEvenLight(MarkerInImage &view, const MarkerPattern &pattern, const RankedFits &few,
                         const FitSettings &settings, FittingMemory &memory)
{
  RankedFits best = few;
  for (int round = 0; round < rounds; ++round) {
    const FittedPose &fit = best.fits[0];
    const std::optional<UnevenLight> before = view.uneven;
    if (!tellLight(view, pattern, fit, settings, memory)) {
      break;
    }
    const RankedFits again = fitFewPixels(view, pattern, true, settings, memory.pixels, *memory.fitter);
    if (again.fits.empty() || unexplainedBy(again.fits[0]) >= unexplainedBy(fit)) {
      view.uneven = before;
      break;
    }
    best = again;
  }
  const double noise = settings.noise.sigma;
  if (excessOf(best.fits[0], noise) > mostLeftInEvenLight * excessOf(few.fits[0], noise)) {
    view.uneven.reset();
    return few;
  }
  return best;
}
} // namespace circle_marker
END_VISP_NAMESPACE
