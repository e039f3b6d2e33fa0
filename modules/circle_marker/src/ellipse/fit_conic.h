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
 * Fit of an ellipse to points.
 */

/*!
  \file fit_conic.h
  \brief Fit of an ellipse to points.
*/

#ifndef VP_CIRCLE_MARKER_FIT_CONIC_H
#define VP_CIRCLE_MARKER_FIT_CONIC_H

#include <cstddef>
#include <optional>

#include <Eigen/Core>

#include <visp3/circle_marker/vpConfigCircleMarker.h>

#include "ellipse/conic.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! When the iterations of fitEllipse() end. */
struct FitLimits
{
  int iterations = 10;      //!< Most of them. Two to four are used on contours, more on short noisy arcs.
  double leastGain = 1e-13; //!< Share of the cost: below the default, comparing costs compares their rounding.
  double leastStep = 1e-8;  //!< Of coefficients of order 1; the next step is smaller by far.
};

/*! For ellipses that only say where to look: within a percent of the least root-mean-square distance. */
constexpr FitLimits roughFit = {3, 0.02, 1e-4};

/*! The direct fit alone: near the best on points from all of an outline, too small and too flat on an arc. */
constexpr FitLimits directFit = {0, 0., 0.};

/*!
  Fits an ellipse to points: the direct ellipse-specific least squares (A. Fitzgibbon, M. Pilu and R. Fisher, Direct
  least square fitting of ellipses, PAMI 21 (1999), in the stable form of R. Halir and J. Flusser, WSCG 1998) as a
  start, then Gauss-Newton on the sum of squared Sampson distances, which has neither the preference of the former for
  small flat ellipses nor its large bias on arcs.

  The points are whitened (their scatter made the unit matrix) first: both the direct fit, which is invariant to affine
  maps, and the normal equations stay well conditioned for slender ellipses. Sampson distances are those of the original
  coordinates. Exact on exact points; no memory is allocated.

  \param points : At least 5 points, in any unit.
  \param size : Number of points.
  \param limits : When to stop.
  \return Conic of unit Frobenius norm, negative inside; nothing for fewer than 5 points, points on a line or not
  finite, or if no ellipse is near them.
*/
std::optional<Eigen::Matrix3d> fitEllipse(const Eigen::Vector2d *points, std::size_t size,
                                          const FitLimits &limits = FitLimits());
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
