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
 * A shadow whose edge falls on a marker.
 */

#include "refine/shadow.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "decode/marker_light.h"
#include "support/bilinear.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Looks around the marker.
constexpr std::size_t directions = 64;
} // namespace

std::optional<Shadow> shadowOn(const vpImage<unsigned char> &I, const CameraModel &camera, const ImageFrame &frame,
                               const MarkerPlane &plane, double quietZone)
{
  const double radius = radiusOfWhite(quietZone);
  std::array<double, directions> whites;
  for (std::size_t k = 0; k < directions; ++k) {
    const double angle = 2. * M_PI * static_cast<double>(k) / directions;
    const auto grey =
        bilinear(I, camera.toPixel(plane.project(radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)))));
    if (!grey) {
      return std::nullopt;
    }
    whites[k] = *grey;
  }
  const MarkerLight light(whites.data(), directions, radius, 0.);
  if (!light.hasShadow()) {
    return std::nullopt;
  }
  // Two points of the edge, which is straight in the plane and in the image.
  const double atCenter = light.distanceToShadow(Eigen::Vector2d::Zero());
  const Eigen::Vector2d toLight(light.distanceToShadow(Eigen::Vector2d::UnitX()) - atCenter,
                                light.distanceToShadow(Eigen::Vector2d::UnitY()) - atCenter);
  const Eigen::Vector2d foot = -atCenter * toLight;
  const auto inFrame = [&](const Eigen::Vector2d &q) -> Eigen::Vector2d {
    return (camera.toPixel(plane.project(q)) - frame.center) / frame.size;
  };
  const Eigen::Vector2d p = inFrame(foot);
  const Eigen::Vector2d along = inFrame(foot + Eigen::Vector2d(-toLight.y(), toLight.x())) - p;
  Eigen::Vector2d toDark = Eigen::Vector2d(-along.y(), along.x()).normalized();
  if (toDark.dot(inFrame(foot - 0.1 * toLight) - p) < 0.) {
    toDark = -toDark;
  }
  Shadow shadow;
  shadow.factor = std::max(light.getFactor(), leastLightInShadow);
  shadow.direction = std::atan2(toDark.y(), toDark.x());
  shadow.edge = toDark.dot(p);
  shadow.softness = softnessAtStart(frame.size);
  shadow.frameSize = frame.size;
  return shadow;
}
} // namespace circle_marker
END_VISP_NAMESPACE
