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
 * How far a likelihood is believed that prefers one pose to the other.
 */

#ifndef VP_CIRCLE_MARKER_POSE_ODDS_H
#define VP_CIRCLE_MARKER_POSE_ODDS_H

#include "refine/fitted_pose.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Half of a robust sum of squares, grey levels^2, in units of the noise's variance: a negative log-likelihood, of
  pixels whose noise is independent.
  \param squares : The sum.
  \param noise : Standard deviation of a pixel's noise, grey levels.
  \param sharing : Number of pixels that share their noise: together they say as much as one.
*/
double costOf(double squares, double noise, double sharing);

/*!
  Log-odds of poses that are not refined. Each leaves more than at its minimum beside it, by the decrement k, by chance:
  as much as that varies, a variance of k^2, is added to that of the log-odds D, which is 2 D.
  \param odds : By the costs of both poses, not negative.
  \param first : The better one.
  \param noise : Standard deviation of a pixel's noise, grey levels.
*/
double unrefinedOdds(double odds, const FittedPose &first, double noise);

/*!
  Log-odds by what a fit leaves of the image. Where that is steep, and tells the poses from each other, the pixels may
  be less or more noisy than elsewhere, by FittedPose::edgeNoise. And where the model lacks something of the image, what
  neighbouring pixels leave together pulls the pose apart more than noise does, by the better fit's coherence, and
  prefers one of the two poses as much more. So the log-odds are divided by both, as those of overdispersed counts are
  (quasi-likelihood: McCullagh and Nelder, Generalized Linear Models, 1989, chapter 9). Of fits that an incoherent image
  did not let come to their ends the decrements count as well, as in unrefinedOdds().

  \param odds : By the costs of both poses, not negative.
  \param first : The better fit.
  \param second : The other one.
  \param noise : Standard deviation of a pixel's noise, grey levels.
*/
double coherentOdds(double odds, const FittedPose &first, const FittedPose &second, double noise);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
