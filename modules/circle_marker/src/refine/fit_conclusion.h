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
 * What is known at the end of a fit besides pose and light.
 */

/*!
  \file fit_conclusion.h
  \brief What is known at the end of a fit besides pose and light.
*/

#ifndef VP_CIRCLE_MARKER_FIT_CONCLUSION_H
#define VP_CIRCLE_MARKER_FIT_CONCLUSION_H

#include "refine/likelihood.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
/*!
  Whether edges are asked for noise of their own: in final fits. Where several pixels share their noise, the picture was
  smoothed, enlarged or made of a mosaic of colours, which makes less noise of flat paper than of edges; what that means
  for the pose is in the sharing.
*/
inline bool mayHaveNoisyEdges(const FitSettings &settings)
{
  constexpr double mostSharing = 1.5; // pixels
  return settings.exactBends && settings.noise.sharing <= mostSharing;
}

/*!
  Noise, covariance and how well the image is explained, from the last equations of a fit.
  \param fit : The likelihood, with the residuals kept that the equations are of.
  \param equations : The last that were kept.
  \param lastStep : Step from where these were made to where the fit ended.
  \param noise : By which the pixels were weighed, grey levels.
  \param settings : Of the fit.
  \param result : Pose and light at the end; takes the rest.
  \return False if the equations are singular.
*/
bool conclude(const Likelihood &fit, const Equations &equations, const ParameterVector &lastStep, double noise,
              const FitSettings &settings, FittedPose &result);
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
