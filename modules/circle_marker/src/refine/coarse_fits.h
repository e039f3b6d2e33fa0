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

#ifndef VP_CIRCLE_MARKER_COARSE_FITS_H
#define VP_CIRCLE_MARKER_COARSE_FITS_H

#include <optional>

#include "decode/recognise.h"
#include "decode/uneven_light.h"
#include "refine/ranked_fits.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! What the fits of a marker look at. */
struct MarkerInImage
{
  const vpImage<unsigned char> &I;
  const CameraModel &camera;
  const ImageFrame frame; //!< Coordinates of the light.
  const Recognition &marker;
  std::optional<UnevenLight> uneven; //!< The light on it, if pixels are to be taken to even light.
};

/*! What a fit leaves, grey levels: the more the fewer pixels it explains; of mere noise 1 / keptOfNoise times that. */
double unexplainedBy(const FittedPose &fit);

/*! Share of normal noise that is not taken for outliers: the biweight's mean. */
constexpr double keptOfNoise = 0.915;

/*!
  What a fit leaves at most, grey levels, if all of it is noise, rounding and what any model lacks.
  \param fit : The fit.
  \param pixels : Number of its pixels.
  \param noise : Of the image, standard deviation, grey levels.
  \param factor : Of the noise, without chance.
  \param deviations : Standard deviations of chance.
*/
double mostLeftByNoise(const FittedPose &fit, std::size_t pixels, double noise, double factor, double deviations);

/*! The blur by which pixels are chosen: that of a fit, within bounds. */
BlurParameters boundedBlur(const BlurParameters &fitted);

/*!
  Leaves out what is known to be covered: much of it would pull the first steps away, and raise what is taken for noise.
*/
void dropCovered(const Recognition &marker, std::vector<FitPixel> &pixels);

/*! Leaves out what the sensor cut off, where a marker is measured in what the image was before it was sharpened. */
void dropCutOff(const MarkerInImage &view, std::vector<FitPixel> &pixels);

/*!
  Takes pixels to even light, if the light on the marker is known to be uneven. Those that are as bright as the sensor
  tells are left out: in even light nothing would show that they are.
*/
void evenOut(const MarkerInImage &view, std::vector<FitPixel> &pixels);

/*!
  Fits from all starts on few pixels around them; if the best has come far from its start, again on the pixels around
  where it is now.
  \param view : What is looked at.
  \param pattern : The print.
  \param refine : Whether poses may move.
  \param settings : Of the fit on all pixels.
  \param pixels : Working memory, holds the few pixels.
  \param fitter : Fits.
*/
RankedFits fitFewPixels(const MarkerInImage &view, const MarkerPattern &pattern, bool refine,
                        const FitSettings &settings, std::vector<FitPixel> &pixels, Fitter &fitter);

/*!
  Fits from two poses on few pixels around them, each to its end, whatever the other one leaves.
  \param view : What is looked at.
  \param pattern : The print.
  \param first : The better one, whose light both start with.
  \param second : The other one.
  \param settings : Of the fit on all pixels.
  \param pixels : Working memory, holds the few pixels.
  \param fitter : Fits.
*/
RankedFits fitToTheirEnds(const MarkerInImage &view, const MarkerPattern &pattern, const FittedPose &first,
                          const MarkerPlane &second, const FitSettings &settings, std::vector<FitPixel> &pixels,
                          Fitter &fitter);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
