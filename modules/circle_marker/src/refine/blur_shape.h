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
 * What the shape of a wide blur leaves of a fit.
 */

/*!
  \file blur_shape.h
  \brief A lens out of focus blurs by a disc, the model by a Gaussian: what that leaves.
*/

#ifndef VP_CIRCLE_MARKER_BLUR_SHAPE_H
#define VP_CIRCLE_MARKER_BLUR_SHAPE_H

#include <optional>

#include "refine/fitted_pose.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Widens the covariance of a marker that is seen through a wide blur: what neighbouring directions pull differently is
  in it (coherence.cpp), what all of them leave alike is not. With a code most of that cancels: its edges face all ways.
  So it does in a motion, but for some of it on a ring without a code.
  \param noise : Of the image, standard deviation, grey levels.
  \param isCoded : Whether the marker has a code.
  \param leftAlike : What all directions leave alike beside the ring's outer edge, share of the contrast (haloOf()); the
  rest is none of the blur's shape: of an enlarged picture much is left, but every other pixel leaves the opposite.
  Nothing if it is not known.
  \param fit : The pose.
*/
void widenByShapeOfBlur(double noise, bool isCoded, const std::optional<double> &leftAlike, FittedPose &fit);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
