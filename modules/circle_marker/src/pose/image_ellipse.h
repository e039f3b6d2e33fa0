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
 * Ellipses from moments and pixels to normalised coordinates.
 */

/*!
  \file image_ellipse.h
  \brief Ellipses from moments and pixels to normalised coordinates.
*/

#ifndef VP_CIRCLE_MARKER_IMAGE_ELLIPSE_H
#define VP_CIRCLE_MARKER_IMAGE_ELLIPSE_H

#include <cstddef>
#include <optional>
#include <vector>

#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpImagePoint.h>

#include "ellipse/conic.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Ellipse of given centre and centred second moments divided by the area,
  \f[ ({\bf x} - {\bf c})^T {\bf N}^{-1} ({\bf x} - {\bf c}) = 4, \quad
      {\bf N} = \left[\begin{array}{cc} n_{20} & n_{11} \\ n_{11} & n_{02} \end{array}\right]. \f]
  The eigenvalues of N are a^2 / 4 and b^2 / 4 (F. Chaumette, Image moments, IEEE Transactions on Robotics 20 (2004)).
  Nothing if N is not positive definite or anything is not finite.
*/
std::optional<CenteredEllipse> ellipseFromMoments(const Eigen::Vector2d &center, double n20, double n11, double n02);

/*! Points of an ellipse, at equal steps of the parameter of a unit circle that an affine map makes the ellipse. */
std::vector<Eigen::Vector2d> sampleEllipse(const CenteredEllipse &ellipse, std::size_t size);

/*!
  A pixel in normalised coordinates, with the camera's model pixel to metre. Nothing if it is not finite or does not
  look to the front.
*/
std::optional<Eigen::Vector2d> normalizePoint(const vpImagePoint &point, const vpCameraParameters &cam);

/*!
  An ellipse in pixels in normalised coordinates: exactly for a camera without distortion; else its contour is sampled
  and undistorted point by point and fitted again. Nothing where normalizePoint() has nothing.
*/
std::optional<CenteredEllipse> normalizeEllipse(const CenteredEllipse &pixels, const vpCameraParameters &cam);

/*!
  Moves the border pixels of a blob, the outermost pixels that belong to it, onto its outline. Where the outline's
  normal is within 45 degrees of an axis there is one border pixel in each row or column, and it lies between 0 and 1
  pixel inside along that axis: half a pixel in the mean, that is max(|n_u|, |n_v|) / 2 along the normal. Nothing if no
  ellipse fits the pixels.
*/
std::optional<std::vector<vpImagePoint>> outlineFromBorder(const std::vector<vpImagePoint> &border);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
