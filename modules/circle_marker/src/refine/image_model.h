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
 * What a blurring camera makes of a marker: the darkness of a pixel.
 */

/*!
  \file image_model.h
  \brief The image of a marker, as a function of its pose.

  A pixel sees the print through the lens' blur, a Gaussian of standard deviation s, and its own area, a square of
  variance 1/12; both together are taken for a Gaussian of variance \f$ \sigma^2 = s^2 + 1/12 \f$ pixels^2. The share of
  black that it sees near a straight edge at the signed distance d is \f$ \Phi(d/\sigma) \f$. Near a circle of image
  curvature \f$ \kappa \f$ the mean of the curve over the blur shifts by \f$ \kappa \sigma^2 / 2 \f$ toward its centre:
  \f[ D = \Phi\left(\frac{d - \kappa \sigma^2 / 2}{\sigma}\right). \f]
  Where a circular and a radial edge of the code track meet, the two events are correlated by the angle between the
  edges in the image, \f$ \rho \f$, and their joint probability is the tetrachoric series
  \f[ \Phi_2(a, b; \rho) = \Phi(a) \Phi(b) + \varphi(a) \varphi(b) \left(\rho + \frac{\rho^2}{2} a b
      + \frac{\rho^3}{6} (a^2 - 1)(b^2 - 1) + \dots\right). \f]
*/

#ifndef VP_CIRCLE_MARKER_IMAGE_MODEL_H
#define VP_CIRCLE_MARKER_IMAGE_MODEL_H

#include <Eigen/Core>

#include "pose/marker_plane.h"
#include "refine/marker_pattern.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! A pixel as the model needs it. */
struct ModelPixel
{
  Eigen::Vector2d meter;         //!< Normalised coordinates of its centre.
  Eigen::Matrix2d meterPerPixel; //!< Their derivative with respect to the pixel.
};

/*! Parameters of the image that are not the pose. */
struct BlurParameters
{
  double sigma = 0.8; //!< Standard deviation of lens blur and pixel area together, pixels.
  double growth = 0.; //!< Distance by which every black region is larger than designed, pixels.
};

/*! Share of black that a pixel sees, and its derivatives. */
struct Darkness
{
  double value = 0.;
  Eigen::Matrix<double, 6, 1> byPose = Eigen::Matrix<double, 6, 1>::Zero(); //!< See below.
  double bySigma = 0.;                                                      //!< 1 / pixel.
  double byGrowth = 0.;                                                     //!< 1 / pixel.
};

/*!
  Evaluates the model at a pixel.

  The derivative by the pose is with respect to (t, w): the marker's centre moves by t (metres) and the marker turns
  about its own centre by w (rad), both expressed in the camera frame.
*/
Darkness darknessAt(const ModelPixel &pixel, const MarkerPlane &plane, const MarkerPattern &pattern,
                    const BlurParameters &blur);

/*! Where a pixel lies on the pattern. */
struct PatternDistance
{
  double toEdges = 0.;        //!< Distance to the nearest edge, pixels, to first order.
  double radius = 0.;         //!< Distance to the marker's centre, in units of the outer radius.
  double radiusPerPixel = 0.; //!< Length of its gradient in the image.
};

/*! Where a pixel lies on the pattern at a pose. */
PatternDistance distanceToPattern(const ModelPixel &pixel, const MarkerPlane &plane, const MarkerPattern &pattern);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
