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
 * Which of the two circles on a cone is the right one.
 */

/*!
  \file circle_evidence.h
  \brief Which of the two circles on a cone is the right one.
*/

#ifndef VP_CIRCLE_MARKER_CIRCLE_EVIDENCE_H
#define VP_CIRCLE_MARKER_CIRCLE_EVIDENCE_H

#include <array>
#include <cstddef>
#include <vector>

#include "pose/circle_from_conic.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! Sum of squared distances of points to a conic. */
double squaredDistances(const Eigen::Matrix3d &conic, const std::vector<Eigen::Vector2d> &points);

/*! Sum of squared distances, normalised coordinates, of points to the image of a circle. */
double squaredDistances(const CirclePosition &circle, double radius, const std::vector<Eigen::Vector2d> &points);

/*!
  ln(likelihood of the first circle / of the second) from the contour of a second circle with the same centre, whose
  image the two circles predict at different places: half the difference of the sums of squared distances over the
  variance. That variance is \f$ \sigma^2 (1 + n_2 / n_1) \f$: the prediction has the noise of the first contour.

  \param circles : The two circles on the cone of the first contour.
  \param radius : Radius of the second circle, metres.
  \param points : Its contour, normalised coordinates: n2 points.
  \param sigma : Standard deviation of a point across the contour, normalised coordinates.
  \param firstSize : Number n1 of points of the first contour.
*/
double concentricLogOdds(const std::array<CirclePosition, 2> &circles, double radius,
                         const std::vector<Eigen::Vector2d> &points, double sigma, std::size_t firstSize);

/*!
  The same from an expected normal, of either sign, with a Gaussian error of standard deviation sigma, radians.
*/
double normalLogOdds(const std::array<CirclePosition, 2> &circles, const Eigen::Vector3d &normal, double sigma);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
