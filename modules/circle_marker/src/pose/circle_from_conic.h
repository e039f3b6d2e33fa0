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
 * Closed-form position of a circle of known radius from its image conic.
 */

/*!
  \file circle_from_conic.h
  \brief Closed-form position of a circle of known radius from its image conic, and back.

  A circle with centre C and unit normal N, seen in normalised coordinates x = (x, y, 1), has the image
  \f[ {\bf x}^T {\bf Q} \, {\bf x} = 0, \quad
      {\bf Q} = h^2 {\bf I} - h ({\bf C} {\bf N}^T + {\bf N} {\bf C}^T) + ({\bf C}^T {\bf C} - r^2) {\bf N} {\bf N}^T,
      \quad h = {\bf N}^T {\bf C}. \f]
  With the eigenvalues \f$ \lambda_1 \ge \lambda_2 > 0 > \lambda_3 \f$ of Q and their unit eigenvectors, the two circles
  of radius r on that cone are, for s = +1 and -1,
  \f[ {\bf N} = s \, g \, {\bf e}_1 + k \, {\bf e}_3, \quad
      {\bf C} = \frac{r}{\sqrt{-\lambda_1 \lambda_3}} (s \, \lambda_3 \, g \, {\bf e}_1 + \lambda_1 k \, {\bf e}_3),
  \quad g = \sqrt{\frac{\lambda_1 - \lambda_2}{\lambda_1 - \lambda_3}}, \quad k = \sqrt{\frac{\lambda_2 -
  \lambda_3}{\lambda_1 - \lambda_3}}. \f]

  K. Kanatani and W. Liu, 3D interpretation of conics and orthogonality, CVGIP: Image Understanding 58 (1993).
  Q. Chen, H. Wu and T. Wada, Camera calibration with two arbitrary coplanar circles, ECCV 2004, section 3.
*/

#ifndef VP_CIRCLE_MARKER_CIRCLE_FROM_CONIC_H
#define VP_CIRCLE_MARKER_CIRCLE_FROM_CONIC_H

#include <array>
#include <optional>

#include <Eigen/Core>

#include <visp3/circle_marker/vpConfigCircleMarker.h>
#include <visp3/core/vpHomogeneousMatrix.h>

#include "ellipse/conic.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Position of a circle: its centre, metres, and its unit normal pointing away from the camera (normal . center > 0),
  both in the camera frame.
*/
struct CirclePosition
{
  Eigen::Vector3d center;
  Eigen::Vector3d normal;
};

/*!
  The two circles of a given radius on the cone whose section at z = 1 is the ellipse x^T Q x = 0.
  Returns nothing if Q is not the image of a circle in front of the camera: hyperbola, parabola, point, imaginary
  ellipse, a coefficient that is not finite, a radius that is not positive and finite.

  \param Q : Symmetric 3x3 conic in normalised coordinates, of any scale and sign; its upper triangle is read.
  \param radius : Radius of the circle, metres.
  \return Always both circles. The first is the one whose normal is closer to the optical axis (larger z): an order
  without evidence, only a stable one. They are equal if the circle is seen along its own axis.

  The result is as exact as Q: no difference of close numbers is taken but in the ellipse's own offset
  \f$ Q_{33} - {\bf b}^T {\bf A}^{-1} {\bf b} \f$. Near the view along the circle's axis the normal is, whatever the
  algorithm, limited by the rounding of Q to about 1e-16 / (angle between normal and line of sight) radian.
*/
std::optional<std::array<CirclePosition, 2>> circlesFromConic(const Eigen::Matrix3d &Q, double radius);

/*!
  The same from the centred form of the ellipse, which has room for more digits than its conic: exact also for an
  ellipse whose size is below a millionth of its distance from the image's centre.
*/
std::optional<std::array<CirclePosition, 2>> circlesFromEllipse(const CenteredEllipse &ellipse, double radius);

/*!
  Pose of a circle's frame (z-aligned: z away from the camera), its spin set by convention: the marker's x axis is the
  direction of its plane that is closest to the camera's x axis. Seen from the front this is the identity rotation.
  If the plane is perpendicular to the camera's x axis, its y axis is the one closest to the camera's y axis instead.
*/
vpHomogeneousMatrix poseFromCirclePosition(const CirclePosition &position);

/*! Its rotation alone, without memory from the heap. */
Eigen::Matrix3d rotationFromCirclePosition(const CirclePosition &position);

/*!
  Image, in normalised coordinates, of the circle of a given radius in the plane z = 0 of a frame, centred at its
  origin; either direction of z. Unit Frobenius norm; negative inside an ellipse. The inverse of circlesFromConic().
*/
Eigen::Matrix3d conicFromPose(const vpHomogeneousMatrix &cMo, double radius);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
