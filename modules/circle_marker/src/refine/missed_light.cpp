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
// missed that the light is uneven. In even light no more than this share of that is left.
constexpr double muchUnexplained = 0.03;
constexpr double muchMoreThanNoise = 1.4;
constexpr double mostLeftInEvenLight = 0.6;
// What correlates by less is no print.
constexpr double leastCorrelation = 0.75;
// The light by the first fits is a little off, as their poses are.
constexpr int rounds = 3;

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

bool mayBeInUnevenLight(const Recognition &marker, const MarkerPattern &pattern, const RankedFits &few, double noise)
{
  if (marker.seen || !marker.isCertain || pattern.sectors == 0 || few.fits.empty() ||
      few.fits[0].correlation < leastCorrelation) {
    return false;
  }
  const FittedPose &fit = few.fits[0];
  if (mayBeTooBright(fit.photometry.white)) {
    return false;
  }
  return unexplainedBy(fit) > std::max(muchUnexplained * fit.photometry.tellableContrast(), muchMoreThanNoise * noise);
}

bool tellLight(MarkerInImage &view, const MarkerPattern &pattern, const FittedPose &fit, const FitSettings &settings,
               std::optional<UnevenLight> &light, const std::vector<FitPixel> &pixels,
               std::vector<ExplainedPixel> &explained, Fitter &fitter)
{
  fitter.explainPixels(pixels, fit, pattern, explained);
  if (light) {
    for (ExplainedPixel &pixel : explained) {
      const Eigen::Vector2d place = view.frame.center + view.frame.size * pixel.offset.cast<double>();
      pixel.grey = static_cast<float>(light->uneven(place, pixel.grey));
    }
  }
  const auto now = unevenLightOf(explained, view.frame, toSheet(fit.plane, view), settings.noise.sigma);
  if (now) {
    light = now;
    view.uneven = &*light;
  }
  return now.has_value();
}

RankedFits withEvenLight(MarkerInImage &view, const MarkerPattern &pattern, const RankedFits &few,
                         const FitSettings &settings, std::optional<UnevenLight> &light, std::vector<FitPixel> &pixels,
                         std::vector<ExplainedPixel> &explained, Fitter &fitter)
{
  RankedFits best = few;
  for (int round = 0; round < rounds; ++round) {
    const FittedPose &fit = best.fits[0];
    const std::optional<UnevenLight> before = light;
    if (!tellLight(view, pattern, fit, settings, light, pixels, explained, fitter)) {
      break;
    }
    const RankedFits again = fitFewPixels(view, pattern, true, settings, pixels, fitter);
    if (again.fits.empty() || unexplainedBy(again.fits[0]) >= unexplainedBy(fit)) {
      light = before;
      break;
    }
    best = again;
  }
  if (unexplainedBy(best.fits[0]) > mostLeftInEvenLight * unexplainedBy(few.fits[0])) {
    light.reset();
    view.uneven = nullptr;
    return few;
  }
  view.uneven = &*light;
  return best;
}
} // namespace circle_marker
END_VISP_NAMESPACE
