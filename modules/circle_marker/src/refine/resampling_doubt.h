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
 * What the resampling of a picture adds to the covariance of a pose.
 */

#ifndef VP_CIRCLE_MARKER_RESAMPLING_DOUBT_H
#define VP_CIRCLE_MARKER_RESAMPLING_DOUBT_H

#include <visp3/circle_marker/vpConfigCircleMarker.h>

#include "refine/fitted_pose.h"
#include "refine/marker_pattern.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  By how much a line with straight sides moves in its best fit for each pixel^3 that its blur's third moment grows,
  1 / pixel^2: a twelfth over the blur's variance if it is wide, three times that if it is thin, because its sides then
  lie in each other's blur.
  \param width : Between the sides, pixels.
  \param blurVariance : Of the normal distribution that the blur is fitted as, pixels^2.
*/
double motionByThirdMoment(double width, double blurVariance);

/*!
  Takes into account that the picture is interpolated between the pixels of another, as undistorted ones are.

  Linear interpolation at the phase p between two pixels keeps where a blurred edge is, and adds p (1 - p) to the
  variance of its blur, but p (1 - p) (1 - 2p) to its third moment as well, which a model with a symmetric blur takes
  for a shift of the edge by a twelfth of it over the blur's variance: 0.009 pixels in the root mean square over p of an
  edge along the columns that is blurred by 0.8, and more of a ring that is not much wider than its blur. Rows and
  columns have phases of their own, and the moments across an edge go with the cubes of its normal's parts. The phases
  change slowly over the image, so that many pixels agree on them, and none of them looks wrong. The covariance grows by
  what independent shifts of up to six parts of the marker do to the pose; FittedPose::resampled is by how much less its
  tilt is known then.
  \param pattern : What is printed.
  \param unit : Size of a pixel in normalised coordinates.
  \param fit : The pose, with the covariance of its normal equations.
*/
void addResamplingDoubt(const MarkerPattern &pattern, double unit, FittedPose &fit);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
