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
 * Radial structure of a marker: ring, disc or neither.
 */

#ifndef VP_CIRCLE_MARKER_RADIAL_PROFILE_H
#define VP_CIRCLE_MARKER_RADIAL_PROFILE_H

#include <array>
#include <optional>

#include "pose/marker_plane.h"
#include "support/camera_model.h"

#include <visp3/core/vpImage.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! Median grey level over the angle, as a function of the radius. */
struct RadialProfile
{
  static constexpr unsigned int size = 56; //!< Number of radii.
  static constexpr double step = 0.02;     //!< Their distance, in units of the outer radius.
  std::array<double, size> grey{};         //!< At the radii step/2, 3 step/2, ...

  static double radiusAt(unsigned int i) { return (i + 0.5) * step; }
};

/*! Profile around a hypothetical pose; nothing if less than half of some circle lies in the image. */
std::optional<RadialProfile> radialProfile(const vpImage<unsigned char> &I, const CameraModel &camera,
                                           const MarkerPlane &plane);

/*!
  Inner radius of the dark ring below the outer edge, in units of the outer radius: where the profile climbs back to
  the middle between the ring's black and the white around. Zero for a disc, dark to its centre. Nothing if there is no
  dark band, or its inner side is not clear.
  \param profile : Around the pose.
  \param quietZone : Width of the white around the ring, in outer radii.
  \param leastContrast : Of the band, grey levels.
*/
std::optional<double> innerRadius(const RadialProfile &profile, double quietZone, double leastContrast);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
