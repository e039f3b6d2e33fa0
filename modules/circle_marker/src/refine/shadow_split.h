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
 * The edge of a shadow on a marker, by what a fit without one leaves.
 */

/*!
  \file shadow_split.h
  \brief The edge of a shadow on a marker, by what a fit without one leaves.
*/

#ifndef VP_CIRCLE_MARKER_SHADOW_SPLIT_H
#define VP_CIRCLE_MARKER_SHADOW_SPLIT_H

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "decode/photometry.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! A pixel, and what a fit makes of it. */
struct ExplainedPixel
{
  Eigen::Vector2f offset = Eigen::Vector2f::Zero(); //!< In the coordinates of an ImageFrame.
  float grey = 0.f;                                 //!< Measured grey level.
  float fitted = 0.f;                               //!< That of the fit.
  float darkness = 0.f;                             //!< Share of black that it sees, by the fit.
  float weight = 0.f;                               //!< 0 to 1: less where what lies beyond the paper may be seen.
};

/*!
  Looks for the line across a marker on whose two sides the print stands in light of two strengths: that white and black
  are of other grey levels on either side explains the image about as well as the fit does. Light and gamma of that,
  which may have followed the step as far as they could, do not count.
  \param pixels : The pixels around a marker's edges, by a fit that missed it. Its pose may be off by some pixels.
  \param frameSize : Size of the ImageFrame, pixels.
  \return Where a fit with a shadow may start; nothing if the strengths differ little, or explain far less than the fit.
*/
std::optional<Shadow> shadowBySplit(const std::vector<ExplainedPixel> &pixels, double frameSize);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
