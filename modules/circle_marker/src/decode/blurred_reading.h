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
 * Code and pose of a marker seen through a strong blur.
 */

#ifndef VP_CIRCLE_MARKER_BLURRED_READING_H
#define VP_CIRCLE_MARKER_BLURRED_READING_H

#include <array>
#include <cmath>
#include <optional>

#include "decode/blurred_marker.h"
#include "decode/identify.h"
#include "ellipse/conic.h"
#include "support/deadline.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! The poses of a marker that was read through a blur, as the reading has them. */
struct BlurredPoses
{
  //! Covariance of the twist (t, w) of each in the marker's frame: outer radii, rad.
  std::array<Eigen::Matrix<double, 6, 6>, 2> covariance;
  std::array<double, 2> cost = {{0., HUGE_VAL}}; //!< Negative log-likelihoods; HUGE_VAL if there is no second.
  double noise = 0.;                             //!< Root mean square of the residuals, grey levels.
  double unexplained = 1.;                       //!< Share of the variance that is left.
  double disc = 0.;                              //!< Radius of a defocus, by the outline's major semi-axis.
};

/*! What was read through a blur. */
struct BlurredReading
{
  BlurredFit fit;          //!< The better pose, spin zero at the start of a sector, and blur.
  MarkerPlane twin;        //!< The other pose of the same circle.
  BlurredPoses poses;      //!< How well both are known.
  CodeReading code;        //!< Its margin: 1 - what the codeword leaves unexplained, by what the next one leaves.
  double unexplained = 1.; //!< Share of the variance that the codeword leaves.
};

/*!
  Fits the marker of a family to the image around a blurred outline and compares all codewords by what they leave
  unexplained of it: each with its own light and contrast, all with the blur that fits sectors of any grey best.
  \param I : The image.
  \param camera : Its camera.
  \param outline : Ellipse of the blurred outline, pixels.
  \param radius : Outer radius of the ring, metres.
  \param family : The family.
  \param leastMargin : Of the code.
  \param deadline : When to stop: there is no result then.
  \return Nothing if nothing like the marker is there, or its code is not certain.
*/
std::optional<BlurredReading> readBlurred(const vpImage<unsigned char> &I, const CameraModel &camera,
                                          const EllipseParameters &outline, double radius,
                                          const vpCircleMarkerFamily &family, double leastMargin,
                                          const Deadline &deadline = Deadline());

/*!
  Fits a plain ring to the image around a blurred outline: as readBlurred(), without codewords. What no code proves must
  be proven by what the fit leaves: a fiftieth of the variance at most.
*/
std::optional<BlurredReading> fitBlurredRing(const vpImage<unsigned char> &I, const CameraModel &camera,
                                             const EllipseParameters &outline, double radius,
                                             const vpCircleMarkerFamily &family, const Deadline &deadline = Deadline());
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
