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
 * Fit of an unsharp mask to pixels near a ring.
 */

/*!
  \file mask_fit.h
  \brief What a camera sharpened its image with, fitted to pixels near the two edges of a ring.
*/

#ifndef VP_CIRCLE_MARKER_MASK_FIT_H
#define VP_CIRCLE_MARKER_MASK_FIT_H

#include <vector>

#include <Eigen/Core>

#include "refine/unsharp_mask.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! A pixel near the ring. */
struct RingSample
{
  double grey;            //!< Its grey level.
  Eigen::Vector2d offset; //!< From the marker's centre, in units of the outer radius.
  double toOuter;         //!< Distance outside of the ring's outer edge, pixels,
  double toInner;         //!< and of its inner edge.
};

/*!
  The least-squares fit of a mask, by Levenberg's and Marquardt's method. Behind a mask white light with a slope is
  seen, from which the share of black takes the contrast; that share is (1 + a) D(b) - a D(hypot(b, s)), with the amount
  a and the standard deviation s of the mask, the blur b, and D the ring's share through a Gaussian.
*/
class MaskFit
{
public:
  explicit MaskFit(std::vector<RingSample> samples);

  /*! False if there is too little to be seen. */
  bool run();

  /*! The mask, whether it is one or not. */
  UnsharpMask mask() const;

  /*! Standard deviation of the mask's amount. */
  double errorOfAmount() const;

  /*! Variance of the residuals, grey levels^2. */
  double variance() const;

private:
  enum Parameter
  {
    WHITE,
    SLOPE_X,
    SLOPE_Y,
    CONTRAST,
    CONTRAST_TIMES_AMOUNT, // the last one of which the image is a linear function
    GROWTH,                // of black, pixels
    LN_BLUR,               // pixels
    LN_SIGMA,              // pixels
    PARAMETERS
  };
  static constexpr int linear = CONTRAST_TIMES_AMOUNT + 1;
  using Matrix = Eigen::Matrix<double, PARAMETERS, PARAMETERS>;
  using Vector = Eigen::Matrix<double, PARAMETERS, 1>;

  static double residualOf(const RingSample &sample, const Vector &theta, Vector &row);
  void linearise(const Vector &theta);
  void improve();
  void dropOdd();
  double errorOfOvershoot() const;
  static double overshootAt(const Vector &theta);

  std::vector<RingSample> m_samples;
  Vector m_theta;        // the parameters
  Matrix m_matrix;       // normal equations there,
  Vector m_right;        // right-hand side,
  double m_squares = 0.; // and the sum of squared residuals
};
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
