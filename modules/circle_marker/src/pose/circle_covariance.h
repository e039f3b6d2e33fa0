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
 * Covariance of the pose of a circle from the noise of its contour.
 */

/*!
  \file circle_covariance.h
  \brief Covariance of the pose of a circle from the noise of its contour.
*/

#ifndef VP_CIRCLE_MARKER_CIRCLE_COVARIANCE_H
#define VP_CIRCLE_MARKER_CIRCLE_COVARIANCE_H

#include <cmath>
#include <vector>

#include "pose/circle_from_conic.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! Variance of a spin of which nothing is known, rad^2: uniform in ]-pi, pi]. */
constexpr double uniformSpinVariance = M_PI * M_PI / 3.;

/*!
  Derivative of the signed distance between a contour point and the projected circle, normalised coordinates, by the
  pose's increment \f$ \delta = (\upsilon, \omega) \f$, metres and radians, in the camera frame.

  The ray x meets the plane of the circle at P = s x. With e the unit vector from the centre C to P, N the normal and
  \f$ {\bf g} = {\bf e} - {\bf N} ({\bf e}^T {\bf x}) / ({\bf N}^T {\bf x}) \f$, moving the circle by delta changes
  \f$ |{\bf P} - {\bf C}| \f$ by \f$ -{\bf g}^T \upsilon - s ({\bf x} \times {\bf g})^T \omega \f$, and moving x in the
  image changes it by \f$ s (g_x, g_y) \f$; the distance is their ratio.
*/
Eigen::Matrix<double, 1, 6> circleDistanceJacobian(const CirclePosition &circle, const Eigen::Vector2d &point);

/*!
  Covariance of delta, with cMo_true = exp(delta) cMo, for contour points with independent noise: the inverse of the
  information \f$ \sum {\bf J}^T {\bf J} / \sigma^2 \f$ in the five degrees of freedom of a circle (translation of its
  centre, tilt about its centre); the spin about the normal is not seen and has the variance of a uniform angle,
  pi^2/3. The tilt has the information of a uniform angle in ]-pi/2, pi/2[ besides, so that the covariance stays finite
  where the circle is seen along its axis and the tilt, to first order, does not move its image. There the covariance is
  a linearisation: of the tilt it states more uncertainty than there is, and of upsilon it leaves out -omega x dt / 2 of
  the logarithm, which from afar is as large as the error across the line of sight.

  \param circle : The circle.
  \param points : Its contour, normalised coordinates.
  \param sigma : Standard deviation of a point across the contour, normalised coordinates (pixels / focal length).
*/
Eigen::Matrix<double, 6, 6> circleCovariance(const CirclePosition &circle, const std::vector<Eigen::Vector2d> &points,
                                             double sigma);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
