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
 * Fits of a marker on few pixels: which poses are worth more, and how wide the blur is.
 */

#include "refine/coarse_fits.h"

#include <algorithm>
#include <cmath>

#include "refine/few_pixels.h"
#include "refine/fit_starts.h"
#include "support/sensor_range.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Bounds of the blur that sets the width of the band of pixels around an edge, pixels, and of its elongation: motion
// of 12 pixels makes a sharp picture's blur 4.5 times as long as wide.
constexpr double leastBlur = 0.6;
constexpr double mostBlur = 6.;
constexpr double mostElongation = 0.75;
// Pixels that were chosen for a blur narrower than the present one by this factor in any direction do not show it.
constexpr double muchWiderBlur = 1.5;
// How far the fits may go from the outlines until their pixels are sorted anew, pixels.
constexpr double coarseError = 2.;
// Borders of sectors that a pixel may see: of those farther away few see any.
constexpr int coarseBorders = 3;
// Last step, in standard deviations, and steps at most: a pose that fits badly creeps, and without a code, or with
// another one, even the right one may.
constexpr double coarseConvergence = 0.5;
constexpr int coarseIterations = 6;
// And of a fit that is to come to its end: of 22 mirrored poses of sharp rings eight were still on their way after 25.
constexpr int iterationsToTheEnd = 60;
// Looks at few pixels: those around an outline that is off by more than the blur do not show where it should be.
constexpr int mostLooks = 3;
constexpr double farOff = 0.8; // pixels

// Borders between black and white sectors that tell the spin of a covered marker. Where fewer are seen, as crossing
// bars may leave of them, a fit to the rest turned a right spin by 16 to 180 degrees.
constexpr unsigned int leastBorders = 3;

// Those of fits on few pixels; settings: of the fit on all pixels.
FitSettings coarseSettings(const FitSettings &settings, int mostIterations)
{
  FitSettings coarse = settings;
  coarse.convergence = coarseConvergence;
  coarse.poseError = coarseError;
  coarse.bordersSeen = coarseBorders;
  coarse.exactBends = false;
  coarse.mostIterations = mostIterations;
  return coarse;
}

// The coarse fits of a marker with one print.
class CoarseFits
{
public:
  CoarseFits(const MarkerInImage &view, const MarkerPattern &pattern, const FitSettings &settings,
             std::vector<FitPixel> &pixels, Fitter &fitter)
      : m_view(view), m_pattern(pattern), m_settings(settings), m_pixels(pixels), m_fitter(fitter)
  {
  }

  // From all starts; if the best has come far from its start, again on the pixels around where it is now.
  RankedFits fit()
  {
    RankedFits ranked;
    Few<MarkerPlane> around;
    for (const MarkerPlane &pose : m_view.marker.poses) {
      around.push_back(pose);
    }
    const bool mayMove = m_settings.mostIterations > 0;
    Few<FitStart> starts = startsOf(m_view.marker.poses, m_view.camera, m_settings.spinIsKnown, mayMove);
    BlurParameters blur; // of a sharp picture
    for (int look = 0; look < mostLooks; ++look) {
      const RankedFits now = fitAround(around, blur, starts);
      if (now.fits.empty()) {
        break;
      }
      ranked = now;
      const Few<FittedPose> &fits = ranked.fits;
      const MarkerPlane &best = fits[0].plane;
      const auto isNear = [&](const MarkerPlane &looked) {
        return outlineMotion(looked, best) < farOff * meterPerPixelAt(best, m_view.camera);
      };
      const BlurParameters fitted = boundedBlur(fits[0].photometry.blur);
      const bool isWide = fitted.widest() > muchWiderBlur * blur.widest();
      // With a light far from what was guessed, of which an over-exposed picture shows little, even the best creeps.
      // They all stand in the same light.
      const bool isSettled = fits[0].isSettled || !mayMove;
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
  RankedFits fitMirrored(const RankedFits &ranked)
  {
    const Few<FittedPose> &fits = ranked.fits;
    if (fits.empty() || (fits.size() > 1 && isSameLight(fits[0].photometry, fits[1].photometry))) {
      return ranked;
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
    const RankedFits again = fitAround(around, blur, starts);
    return again.fits.empty() ? ranked : again;
  }

  // From two poses, neither of which ends because the other one is better.
  RankedFits fitBoth(const FittedPose &first, const MarkerPlane &second)
  {
    Few<MarkerPlane> around;
    around.push_back(first.plane);
    around.push_back(second);
    choosePixels(around, boundedBlur(first.photometry.blur));
    Few<FittedPose> fits;
    FitSettings settings = m_settings;
    for (const MarkerPlane &plane : around) {
      if (const auto fit = m_fitter.fitPose(m_pixels, {plane, first.photometry, std::nullopt}, m_pattern, settings)) {
        fits.push_back(*fit);
      }
      settings.samePixels = true;
    }
    RankedFits ranked = rank(m_pixels, m_pattern, m_settings.exactBends, fits, m_fitter);
    keepTwo(ranked);
    return ranked;
  }

private:
  void choosePixels(const Few<MarkerPlane> &around, const BlurParameters &blur)
  {
    selectFewPixels(m_view.I, m_view.camera, m_view.frame, around.data(), around.size(), m_pattern, blur, m_pixels);
    dropCovered(m_view.marker, m_pixels);
    dropCutOff(m_view, m_pixels);
    evenOut(m_view, m_pixels);
  }

  // From all starts on the pixels around some poses; those that are the same count once.
  RankedFits fitAround(const Few<MarkerPlane> &around, const BlurParameters &blur, const Few<FitStart> &starts)
  {
    choosePixels(around, blur);
    RankedFits ranked = rank(m_pixels, m_pattern, m_settings.exactBends,
                             fitAll(m_pixels, starts, m_pattern, m_settings, m_fitter), m_fitter);
    keepTwo(ranked);
    return ranked;
  }

  const MarkerInImage &m_view;
  const MarkerPattern &m_pattern;
  const FitSettings m_settings;
  std::vector<FitPixel> &m_pixels;
  Fitter &m_fitter;
};
} // namespace

double unexplainedBy(const FittedPose &fit)
{
  return fit.noise / std::max(fit.inliers, 1e-3);
}

double mostLeftByNoise(const FittedPose &fit, std::size_t pixels, double noise, double factor, double deviations)
{
  constexpr double lacking = 0.001; // of the contrast: edges' shapes, in any image
  const double chance = deviations * std::sqrt(fit.sharing / (2. * static_cast<double>(pixels)));
  return std::hypot((factor + chance) * std::max(noise, quantisation), lacking * fit.photometry.tellableContrast());
}

BlurParameters boundedBlur(const BlurParameters &fitted)
{
  BlurParameters blur;
  blur.sigma = std::clamp(fitted.sigma, leastBlur, mostBlur);
  const double size = fitted.elongation.norm();
  blur.elongation = fitted.elongation * std::min(1., mostElongation / std::max(size, 1e-12));
  return blur;
}

void dropCovered(const Recognition &marker, std::vector<FitPixel> &pixels)
{
  if (!marker.seen) {
    return;
  }
  const SeenParts &seen = *marker.seen;
  const bool keepsTrack =
      marker.family.isCoded() && seen.bordersSeen(marker.family.getCodeword(marker.code.id),
                                                  marker.family.getNbSectors(), marker.poses[0]) < leastBorders;
  const auto isCovered = [&](const FitPixel &pixel) {
    const Eigen::Vector2d meter = pixel.meter.cast<double>();
    return !seen.holds(meter) && !(keepsTrack && seen.isOnTrack(meter));
  };
  pixels.erase(std::remove_if(pixels.begin(), pixels.end(), isCovered), pixels.end());
}

void dropCutOff(const MarkerInImage &view, std::vector<FitPixel> &pixels)
{
  const vpImage<unsigned char> *asSeen = view.marker.asSeen;
  if (asSeen == nullptr) {
    return;
  }
  const auto isCutOff = [&](const FitPixel &pixel) {
    const Eigen::Vector2d place = view.frame.center + view.frame.size * pixel.offset.cast<double>();
    const int grey =
        (*asSeen)[static_cast<unsigned int>(std::lround(place.y()))][static_cast<unsigned int>(std::lround(place.x()))];
    return mayBeTooBright(grey) || mayBeTooDark(grey);
  };
  pixels.erase(std::remove_if(pixels.begin(), pixels.end(), isCutOff), pixels.end());
}

void evenOut(const MarkerInImage &view, std::vector<FitPixel> &pixels)
{
  if (!view.uneven) {
    return;
  }
  const auto isTooBright = [](const FitPixel &pixel) { return mayBeTooBright(pixel.grey); };
  pixels.erase(std::remove_if(pixels.begin(), pixels.end(), isTooBright), pixels.end());
  for (FitPixel &pixel : pixels) {
    const Eigen::Vector2d place = view.frame.center + view.frame.size * pixel.offset.cast<double>();
    pixel.grey = static_cast<float>(view.uneven->evened(place, pixel.grey));
  }
}

RankedFits fitFewPixels(const MarkerInImage &view, const MarkerPattern &pattern, bool refine,
                        const FitSettings &settings, std::vector<FitPixel> &pixels, Fitter &fitter)
{
  CoarseFits fits(view, pattern, coarseSettings(settings, refine ? coarseIterations : 0), pixels, fitter);
  const RankedFits ranked = fits.fit();
  return view.marker.seen && refine ? fits.fitMirrored(ranked) : ranked;
}

RankedFits fitToTheirEnds(const MarkerInImage &view, const MarkerPattern &pattern, const FittedPose &first,
                          const MarkerPlane &second, const FitSettings &settings, std::vector<FitPixel> &pixels,
                          Fitter &fitter)
{
  return CoarseFits(view, pattern, coarseSettings(settings, iterationsToTheEnd), pixels, fitter).fitBoth(first, second);
}
} // namespace circle_marker
END_VISP_NAMESPACE
