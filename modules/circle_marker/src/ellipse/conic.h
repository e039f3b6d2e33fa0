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
 * Ellipses as conics, as axes and centred: conversions and distances.
 */

/*!
  \file conic.h
  \brief Ellipses as conics, as axes and centred: conversions and distances.

  A conic is a symmetric 3x3 matrix Q of any scale; its points are \f$ {\bf x}^T {\bf Q} {\bf x} = 0 \f$ with
  x = (x, y, 1), in pixels or in normalised coordinates alike.
*/

#ifndef VP_CIRCLE_MARKER_CONIC_H
#define VP_CIRCLE_MARKER_CONIC_H

#include <optional>

#include <Eigen/Core>

#include <visp3/circle_marker/vpConfigCircleMarker.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! An ellipse by its axes, in the unit of its coordinates. */
struct EllipseParameters
{
  Eigen::Vector2d center = Eigen::Vector2d::Zero(); //!< Centre.
  double a = 0.;                                    //!< Semi-major axis.
  double b = 0.;                                    //!< Semi-minor axis.
  double angle = 0.; //!< Of the major axis, from x toward y, radians, in ]-pi/2, pi/2]; 0 for a circle.
};

/*!
  An ellipse as (x - center)^T A (x - center) + offset = 0, with A positive definite and offset < 0. Unlike the nine
  coefficients of a conic this keeps a small ellipse far from the origin free of cancellation.
*/
struct CenteredEllipse
{
  Eigen::Matrix2d A;      //!< Shape.
  Eigen::Vector2d center; //!< Centre.
  double offset;          //!< Value at the centre.
};

/*! Centre form of a conic; nothing if it is not a real ellipse of finite, positive size. */
std::optional<CenteredEllipse> centerConic(const Eigen::Matrix3d &Q);

/*! Axes of a conic; nothing if it is not a real ellipse of finite, positive size. */
std::optional<EllipseParameters> ellipseFromConic(const Eigen::Matrix3d &Q);

/*! Half the width and half the height of the upright box around an ellipse. */
Eigen::Vector2d halfExtents(const EllipseParameters &ellipse);

/*! Conic of an ellipse: unit Frobenius norm, negative inside. */
Eigen::Matrix3d conicFromEllipse(const EllipseParameters &ellipse);

/*!
  Signed distance of a point to an ellipse to first order, \f$ F / |\nabla F| \f$ with \f$ F = {\bf x}^T {\bf Q}
  {\bf x} \f$ (P. Sampson, Fitting conic sections to "very scattered" data, CGIP 18 (1982)): positive outside for a
  conic that is negative inside.
*/
double sampsonDistance(const Eigen::Matrix3d &Q, const Eigen::Vector2d &point);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
