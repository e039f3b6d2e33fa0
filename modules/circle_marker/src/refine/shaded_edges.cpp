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
 * Edges of a print where the edge of a shadow falls on them.
 */

#include "refine/shaded_edges.h"

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
namespace {
// Beyond this many standard deviations of the shadow's edge the light is even.
constexpr float farFromShadow = 4.f;
// Shift by which derivatives are taken, in standard deviations of the blur: of the first it leaves a twentieth.
constexpr double shiftOfBlur = 0.6;

// The pixels of a block elsewhere.
PixelBlock shifted(const PixelBlock &block, const Eigen::Vector2d &pixels)
{
  PixelBlock other = block;
  const auto u = static_cast<float>(pixels.x());
  const auto v = static_cast<float>(pixels.y());
  other.place.x += u * block.place.xByU + v * block.place.xByV;
  other.place.y += u * block.place.yByU + v * block.place.yByV;
  return other;
}
} // namespace

bool correctShadedEdges(const MarkerPlane &plane, const MarkerPattern &pattern, const Photometry &photometry,
                        PixelBlocks &blocks)
{
  if (!photometry.shadow || photometry.shadow->frameSize <= 0.) {
    return false;
  }
  const Shadow &shadow = *photometry.shadow;
  const BlurParameters &blur = photometry.blur;
  const Eigen::Vector2d toDark(std::cos(shadow.direction), std::sin(shadow.direction));
  const Eigen::Vector2d blurred = blur.shape() * blur.shape() * (blur.sigma * blur.sigma * toDark); // C toDark
  const double along = blurred.norm();
  const double acrossEdge = std::sqrt(blurred.dot(toDark)); // standard deviation of the blur there
  // A shadow's edge is no sharper than the blur.
  const double softness = std::max(shadow.softness * shadow.frameSize, acrossEdge);
  const double step = shiftOfBlur * acrossEdge;
  const Eigen::Vector2d shift = step / along * blurred;
  const auto lost = static_cast<float>(1. - shadow.factor);
  const auto first = static_cast<float>(along / softness / (2. * step));
  const auto second = static_cast<float>(0.5 * along * along / (softness * softness * step * step));
  const auto perSoftness = static_cast<float>(1. / shadow.softness);
  const ImageModel model(plane, pattern, blur, blocks);
  bool isAnyShaded = false;
  for (std::size_t kind = 0; kind < pixelSights; ++kind) {
    const auto sight = static_cast<PixelSight>(kind);
    for (PixelBlock &block : blocks.bySight[kind]) {
      const Lanes z = perSoftness * (static_cast<float>(toDark.x()) * block.offsetU +
                                     static_cast<float>(toDark.y()) * block.offsetV - static_cast<float>(shadow.edge));
      if (z.abs().minCoeff() > farFromShadow) {
        continue;
      }
      Lanes before;
      Lanes here;
      Lanes behind;
      model.evaluate(shifted(block, -shift), sight, before);
      model.evaluate(block, sight, here);
      model.evaluate(shifted(block, shift), sight, behind);
      const NormalLanes normal = normalOf(z);
      const Lanes slope = -lost * normal.density; // of the light, by softness
      const Lanes together = first * slope * (behind - before) - second * slope * z * (behind - 2.f * here + before);
      block.correction += together / (1.f - lost * normal.cumulative);
      isAnyShaded = true;
    }
  }
  return isAnyShaded;
}
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE
