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
 * What an estimator at the Cramer-Rao bound would make of a frame.
 */

#ifndef VP_EXPERIMENTS_IDEAL_ESTIMATE_H
#define VP_EXPERIMENTS_IDEAL_ESTIMATE_H

#include <cstdint>

#include <visp3/circle_marker_simulator/vpSimulatedMarker.h>

#include "experiment.h"
#include "sample.h"

namespace experiments {
/*!
  A pose that is off by an error drawn from the normal distribution with the covariance of the bound: its statistics are
  those of the best unbiased estimator, and are to be had in the same way as any other method's. What surrounds the
  sheet is unknown to it.

  \e marker: At its true pose.
  \e seed: Of the error.
  \return Pose of the marker, z into it, metres.
*/
vpHomogeneousMatrix idealEstimate(const vpSimulatedMarker &marker, const Scene &scene, std::uint64_t seed);

/*!
  What the image of a marker tells of its pose: as deviations the standard deviations of the bound (the normal's as the
  root of the mean square), as log-odds the mean ones that a true pose has against the mirrored one.
*/
Sample limitOf(const vpSimulatedMarker &marker, const Scene &scene);

/*!
  A pose that is off by an error drawn from a normal distribution.

  \e covariance: 6 x 6, of delta with true pose = exp(delta) * estimate, translation first, metres and radians.
*/
vpHomogeneousMatrix drawnEstimate(const vpHomogeneousMatrix &truth, const vpMatrix &covariance, std::uint64_t seed);
} // namespace experiments

#endif
