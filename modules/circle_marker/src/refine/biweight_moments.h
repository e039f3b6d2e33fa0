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
 * What Tukey's biweight does to normal noise.
 */

/*!
  \file biweight_moments.h
  \brief What Tukey's biweight, w = (1 - r^2 / c^2)^2, does to residuals r of normal noise, and how that noise is told
  from them. The moments are those of a normal distribution of variance 1, without its tails beyond c, which hold less
  than a hundred-thousandth of it.
*/

#ifndef VP_CIRCLE_MARKER_BIWEIGHT_MOMENTS_H
#define VP_CIRCLE_MARKER_BIWEIGHT_MOMENTS_H

#include <algorithm>
#include <cmath>

#include "refine/grey_model.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
/*! Means over a normal distribution. */
struct BiweightMoments
{
  double weight = 1.;  //!< Of w.
  double squares = 1.; //!< Of w r^2; of the slope of w r, too.
  double pull = 1.;    //!< Of (w r)^2.
};

/*! \param c : The biweight's constant, standard deviations of the noise, no less than Tukey's. */
inline BiweightMoments biweightMoments(double c)
{
  const double a = 1. / (c * c);
  return {1. - a * (2. - 3. * a), 1. - a * (6. - 15. * a), 1. - a * (12. - a * (90. - a * (420. - 945. * a)))};
}

/*! Noise of residuals, and moments of their weights. */
struct WeighedNoise
{
  double sigma = 0.; //!< Standard deviation, grey levels.
  BiweightMoments moments;
};

/*!
  Standard deviation of the noise from the weighted residuals, which is more efficient than the median.
  \param squares : Sum of squared residuals, each with its weight, grey levels^2.
  \param freedom : Sum of the weights, without the parameters that were fitted.
  \param noise : Standard deviation by which the pixels were weighed: that of the noise or more, grey levels.
*/
inline WeighedNoise weighedNoise(double squares, double freedom, double noise)
{
  // What pixels are weighed by is told from the median of the residuals, and differs from their noise by chance.
  constexpr double mostByChance = 1.2;
  constexpr int steps = 4; // each takes four fifths of the error away, at least
  const double weighed = std::sqrt(squares / freedom);
  WeighedNoise result;
  double ratio = 1.;
  for (int k = 0; k < steps; ++k) {
    result.moments = biweightMoments(tukey * ratio);
    result.sigma = std::max(weighed * std::sqrt(result.moments.weight / result.moments.squares), quantisation);
    ratio = noise > mostByChance * result.sigma ? noise / result.sigma : 1.;
  }
  return result;
}
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
