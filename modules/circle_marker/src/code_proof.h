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
 * Whether the likeliest code of a measured marker is beyond doubt.
 */

#ifndef VP_CIRCLE_MARKER_CODE_PROOF_H
#define VP_CIRCLE_MARKER_CODE_PROOF_H

#include <cstddef>

#include "refine/code_likelihood.h"
#include "refine/fitted_pose.h"

#include <visp3/circle_marker/vpCircleMarkerFamily.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! Odds of a code, ln, from which it needs no comparison with the next one measured on its own. */
constexpr double clearOdds = 40.;

/*! A marker that was measured with the code that is to be proven. */
struct CodeToProve
{
  const vpCircleMarkerFamily &family; //!< Of the marker.
  const FittedPose &fit;              //!< What was measured.
  double noise;                       //!< Standard deviation of the image's noise, grey levels.
  bool isCertain;                     //!< Whether the code was read sector by sector without doubt or correction.
  std::size_t pixels;                 //!< Number that the marker was measured on.
  double sector;                      //!< Length of a sector at the track's middle along the shorter axis, pixels.
};

/*!
  Whether the likeliest code is beyond doubt: by its odds, by what it and the whole measurement leave unexplained, and
  as the measurement looks like a print.
*/
bool isProven(const LikelyCode &code, const CodeToProve &what);

/*!
  Whether the likeliest code, if it is not the one that was measured with, is worth being measured with: the pose may be
  off without it, but some codeword explains what is seen.
*/
bool isWorthMeasuring(const LikelyCode &code);

/*!
  Whether a measurement leaves no more of the image than that of a print does, where codes cannot be compared.
  \param fit : What was measured.
  \param noise : Standard deviation of the image's noise, grey levels.
*/
bool leavesWhatPrintsLeave(const FittedPose &fit, double noise);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
