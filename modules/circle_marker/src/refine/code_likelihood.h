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
 * The likelihood of all codewords at a measured pose.
 */

/*!
  \file code_likelihood.h
  \brief The likelihood of all codewords at a measured pose.

  Once pose, light, gamma and blur are measured, the black that a pixel of the code track sees, with gamma undone
  (Photometry::blackOf()), is linear in the colours c_k of the sectors, 1 for black:
  \f[ D = D_0 + \sum_k w_k c_k, \f] with D_0 the black of the ring and w_k the share of the pixel's blurred sight that
  sector k has. With noise of standard deviation s the squared residuals of a codeword are a quadratic form of its bits,
  over 2 s^2 its negative log likelihood. Where sectors are as small as the blur each pixel sees several of them, and
  reading them one by one takes the mixture of two for one; among codewords there is one that mixes to what is seen, and
  the next one says how sure that is.
*/

#ifndef VP_CIRCLE_MARKER_CODE_LIKELIHOOD_H
#define VP_CIRCLE_MARKER_CODE_LIKELIHOOD_H

#include <cmath>
#include <optional>

#include "refine/code_image.h"
#include "support/deadline.h"

#include <visp3/circle_marker/vpCircleMarkerFamily.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! A codeword on a code track. */
struct PlacedCode
{
  int id = -1;      //!< -1: a track all black or all white.
  double spin = 0.; //!< Angle from the plane's x axis to the marker's own, rad, in (-pi, pi].
};

/*! The codeword that explains a code track best. */
struct LikelyCode
{
  PlacedCode best;         //!< It, or a track all black or all white if that explains more than any.
  PlacedCode next;         //!< What explains it best of all others.
  double odds = HUGE_VAL;  //!< Natural logarithm of its odds against the next one.
  double unexplained = 0.; //!< Root of the mean squared residual, in units of the noise.
};

/*!
  Reads the code of a marker whose pose is measured.
  \param view : The marker; its spin may be any.
  \param family : Family of the marker, with a code.
  \param track : Working memory.
  \param deadline : When to stop: there is no result then.
  \return Nothing where the model does not hold: where the sensor cannot tell how bright the paper is by more than a
  tenth of the contrast, at the image's border.
*/
std::optional<LikelyCode> mostLikelyCode(const MeasuredView &view, const vpCircleMarkerFamily &family, CodeImage &track,
                                         const Deadline &deadline = Deadline());
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
