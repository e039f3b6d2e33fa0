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
 * Poses of the experiments.
 */

#ifndef VP_EXPERIMENTS_POSES_H
#define VP_EXPERIMENTS_POSES_H

#include <cstdint>

#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpHomogeneousMatrix.h>

#include "common/visp_names.h"
#include "settings.h"

namespace experiments {
constexpr double nearestDepth = 0.36; // Metres: the thesis's.

/*! What is drawn from a frame's seed; each has a seed of its own. */
enum class Draw : std::uint64_t
{
  Pose = 1,
  Spin,
  CodedId,
  TagId,
  Noise,
  Cover,
  Direction,
  Clutter,
  Bound
};

std::uint64_t seedOf(Draw draw, std::uint64_t frameSeed);

/*! A number from 0 to 1, below 1. */
double uniformFrom(Draw draw, std::uint64_t frameSeed);

/*! An angle about the normal, even over the full turn, radians. */
double spinFrom(std::uint64_t frameSeed);

/*! A pose of a sheet that is all in the image; depth and angle even over their ranges, metres and radians. */
vpHomogeneousMatrix randomPose(const Settings &settings, const vpCameraParameters &cam, double leastDepth,
                               double mostDepth, double mostAngle, std::uint64_t frameSeed);

/*! The same at one depth and one angle, in random directions. */
vpHomogeneousMatrix poseAt(const Settings &settings, const vpCameraParameters &cam, double depth, double angle,
                           std::uint64_t frameSeed);
} // namespace experiments

#endif
