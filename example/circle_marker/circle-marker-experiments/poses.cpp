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

#include <cmath>

#include <visp3/circle_marker_simulator/vpRandomMarkerPose.h>
#include <visp3/core/vpRotationMatrix.h>
#include <visp3/core/vpThetaUVector.h>
#include <visp3/core/vpTranslationVector.h>

#include "common/pose_error.h"
#include "common/reference_camera.h"
#include "common/seeds.h"
#include "method.h"
#include "poses.h"

namespace experiments {
namespace {
// All markers have the same sheet, so a pose that suits one of them suits the others.
vpSimulatedMarker anyMarker(const Settings &settings)
{
  vpSimulatedMarker marker = vpSimulatedMarker::circle(codedFamily, 0, settings.size);
  marker.setSheetSide(settings.sheetSide());
  return marker;
}

vpRotationMatrix turn(double angle, double x, double y, double z)
{
  return vpRotationMatrix(vpThetaUVector(angle * x, angle * y, angle * z));
}
} // namespace

std::uint64_t seedOf(Draw draw, std::uint64_t frameSeed)
{
  return mixed(frameSeed, static_cast<std::uint64_t>(draw));
}

double uniformFrom(Draw draw, std::uint64_t frameSeed)
{
  constexpr double step = 1. / 9007199254740992.; // 2^-53: the numbers of 53 bits are all exact.
  return static_cast<double>(seedOf(draw, frameSeed) >> 11) * step;
}

double spinFrom(std::uint64_t frameSeed)
{
  return (2. * uniformFrom(Draw::Spin, frameSeed) - 1.) * M_PI;
}

vpHomogeneousMatrix randomPose(const Settings &settings, const vpCameraParameters &cam, double leastDepth,
                               double mostDepth, double mostAngle, std::uint64_t frameSeed)
{
  vpRandomPoseRange range;
  range.minDepth = leastDepth;
  range.maxDepth = mostDepth;
  range.maxTilt = mostAngle;
  return vpRandomMarkerPose(anyMarker(settings), cam, imageWidth, imageHeight, range, seedOf(Draw::Pose, frameSeed));
}

vpHomogeneousMatrix poseAt(const Settings &settings, const vpCameraParameters &cam, double depth, double angle,
                           std::uint64_t frameSeed)
{
  // The simulator's poses have even angles from 0: only the place of a pose that faces the camera is taken from it.
  const vpHomogeneousMatrix facing = randomPose(settings, cam, depth, depth, 0., frameSeed);
  const double azimuth = 2. * M_PI * uniformFrom(Draw::Direction, frameSeed);
  return facing *
         vpHomogeneousMatrix(vpTranslationVector(0., 0., 0.), turn(angle, std::cos(azimuth), std::sin(azimuth), 0.) *
                                                                  turn(spinFrom(frameSeed), 0., 0., 1.));
}
} // namespace experiments
