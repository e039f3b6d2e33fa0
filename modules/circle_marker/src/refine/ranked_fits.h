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

#ifndef VP_CIRCLE_MARKER_RANKED_FITS_H
#define VP_CIRCLE_MARKER_RANKED_FITS_H

#include <vector>

#include "refine/fitter.h"
#include "support/few.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! Fits on the same pixels, the best first, and its noise, by which all of them are judged, grey levels. */
struct RankedFits
{
  Few<FittedPose> fits;
  double noise = 0.;
};

/*!
  Fits every start on the pixels; those that lead nowhere are left out. A start with a code that is far behind the best
  fit before it, and does not catch up, is given up. With FitSettings::isClear the first fit with a code that has
  settled is followed by one more, of a start without photometry, which goes on with its light and noise; if there are
  more than two starts, because the marker faces the camera, that one starts from its mirror image.
  \param pixels : What is explained.
  \param starts : From where.
  \param pattern : The print.
  \param settings : Of the fits.
  \param fitter : Fits.
  \param before : The best of earlier fits on these pixels, if there are any.
*/
Few<FittedPose> fitAll(const std::vector<FitPixel> &pixels, const Few<FitStart> &starts, const MarkerPattern &pattern,
                       FitSettings settings, Fitter &fitter, const std::optional<FittedPose> &before = std::nullopt);

/*! Ranks fits by how well they explain the pixels, at the noise of the least noisy. */
RankedFits rank(const std::vector<FitPixel> &pixels, const MarkerPattern &pattern, bool exactBends,
                const Few<FittedPose> &fits, Fitter &fitter);

/*!
  Whether two fits are one pose: to within what is known of it; or, as the likelihood has one maximum on each side of
  the line of sight, because both lean to the same side, and the worse has not come to its end.
*/
bool isSamePose(const FittedPose &p, const FittedPose &q);

/*! Keeps the best pose and the best of those that are not the same as it. */
void keepTwo(RankedFits &ranked);

/*!
  The best fit and the one from its mirrored pose, which may have looked hopeless before the model had all that it has
  now.
  \param pixels : The pixels.
  \param ranked : The best.
  \param pattern : The print.
  \param settings : Of the fit.
  \param fitter : Fits.
*/
RankedFits withMirrored(const std::vector<FitPixel> &pixels, const RankedFits &ranked, const MarkerPattern &pattern,
                        const FitSettings &settings, Fitter &fitter);

/*! More that the model of the light may have. */
struct LightExtension
{
  void (*extend)(Photometry &light) = nullptr;           //!< Adds it, doing nothing yet.
  bool (*has)(const Photometry &light) = nullptr;        //!< Whether a light has it.
  bool (*isPossible)(const Photometry &light) = nullptr; //!< Whether a camera and a lamp do what a light has of it.
  double leastGain = 0.; //!< Log-odds by which it has to explain the pixels better than a light without.
};

/*!
  Fits both poses with more of the light.
  \param pixels : The pixels, those that the fitter has.
  \param fits : Those without, at least one.
  \param extension : What more.
  \param pattern : The print.
  \param settings : Of these fits.
  \param fitter : Fits.
  \return The fits with it, or those without if they explain the pixels as well.
*/
RankedFits fitExtended(const std::vector<FitPixel> &pixels, const RankedFits &fits, const LightExtension &extension,
                       const MarkerPattern &pattern, FitSettings settings, Fitter &fitter);

/*! Whether two fits stand in the same light and are equally sharp: if not, one of them is not at its minimum. */
bool isSameLight(const Photometry &p, const Photometry &q);

/*!
  Whether a pose has no chance beside the best, by what few pixels say: neither as it is nor one step on, if its steps
  were cut off. What that step would bring is known roughly, far from the minimum: to half of the way it is behind.
*/
bool isHopeless(const FittedPose &fit, const FittedPose &best, double noise);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
