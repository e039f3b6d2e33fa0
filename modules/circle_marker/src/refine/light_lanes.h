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
 * The light on the pixels of a block.
 */

#ifndef VP_CIRCLE_MARKER_LIGHT_LANES_H
#define VP_CIRCLE_MARKER_LIGHT_LANES_H

#include "decode/photometry.h"
#include "refine/pixel_blocks.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
// The light without a shadow, in units of that at the marker's centre.
inline Lanes lightOf(const PixelBlock &block, const Photometry &photometry)
{
  const Eigen::Vector2f gradient = photometry.lightGradient.cast<float>();
  Lanes light = 1.f + gradient.x() * block.offsetU + gradient.y() * block.offsetV;
  if (photometry.lightCurvature) {
    const Eigen::Vector3f bend = photometry.lightCurvature->cast<float>();
    light +=
        (bend[0] * block.offsetU + bend[1] * block.offsetV) * block.offsetU + bend[2] * block.offsetV * block.offsetV;
  }
  return light.max(static_cast<float>(leastLight));
}

// Grey level of white paper if no shadow fell on it; Photometry::whiteAt() is that under it.
inline Lanes whiteOf(const PixelBlock &block, const Photometry &photometry)
{
  const auto gamma = static_cast<float>(photometry.gamma);
  return static_cast<float>(photometry.white) * (gamma * lightOf(block, photometry).log()).exp();
}
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
