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
 * Where parabolas and a few borders are no model of what a pixel sees.
 */

#ifndef VP_CIRCLE_MARKER_BEND_LIMITS_H
#define VP_CIRCLE_MARKER_BEND_LIMITS_H

#include <visp3/circle_marker/vpConfigCircleMarker.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  From where on what a pixel sees is summed up along lines: by the model that poses are fitted with (line_model.h) and
  by the likelihood of codewords (track_lines.h). Lengths in standard deviations of the blur.
*/
namespace bend_limits {
/*!
  Bend of an edge, curvature times blur / 2, from which parabolas leave an error that shows, for the ring, where it is
  of the order of the bend's cube and the pose leans on it, and for the track, where it is of that of its square: up to
  there the depth is biased by less than a fifth of its standard deviation.
*/
constexpr double strongOfRing = 0.09;
constexpr double strongOfTrack = 0.13;
/*! A parabola is one side of a circle. The other is seen from this distance: 0.1 % of an edge lie beyond. */
constexpr double seenAcross = 3.;
/*! Where borders between sectors are closer to each other than this, more of them are seen than the five of a block. */
constexpr double leastSpacing = 1.6;
/*! Around the ends of an ellipse with a semi-minor axis shorter than this bends change within the blur. */
constexpr double leastSemiMinor = 4.;
} // namespace bend_limits
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
