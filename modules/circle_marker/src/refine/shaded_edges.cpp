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

#include "refine/grey_model.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
namespace {
// Where the light changes by less than this, in units of what a shadow takes by its softness, it is even: beyond four
// standard deviations of the edge.
constexpr float leastSlope = 1e-4f;
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
  const BlurParameters &blur = photometry.blur;
  Shadow shadow = *photometry.shadow;
  const Eigen::Vector2d toDark(std::cos(shadow.direction), std::sin(shadow.direction));
  const Eigen::Vector2d blurred = blur.shape() * blur.shape() * (blur.sigma * blur.sigma * toDark); // C toDark
  const double along = blurred.norm();
  const double acrossEdge = std::sqrt(blurred.dot(toDark));                   // standard deviation of the blur there
  shadow.softness = std::max(shadow.softness, acrossEdge / shadow.frameSize); // no edge is sharper than the blur
  const double step = shiftOfBlur * acrossEdge;
  const Eigen::Vector2d shift = step / along * blurred;
  // Of the light's first and second derivative by the pixel, with what the print's differences have besides.
  const auto first = static_cast<float>(along / (2. * step * shadow.frameSize));
  const auto second = static_cast<float>(0.5 * std::pow(along / (step * shadow.frameSize), 2.) / shadow.softness);
  const auto least = leastSlope * static_cast<float>((1. - shadow.factor) / shadow.softness);
  const ImageModel model(plane, pattern, blur, blocks);
  bool isAnyShaded = false;
  for (std::size_t kind = 0; kind < pixelSights; ++kind) {
    const auto sight = static_cast<PixelSight>(kind);
    for (PixelBlock &block : blocks.bySight[kind]) {
      const ShadowLanes light = shadowOf(block, shadow);
      const Lanes &fall = light.by[2]; // by the edge's place: less light toward the dark side
      if (fall.maxCoeff() < least) {
        continue;
      }
      Lanes before;
      Lanes here;
      Lanes behind;
      model.evaluate(shifted(block, -shift), sight, before);
      model.evaluate(block, sight, here);
      model.evaluate(shifted(block, shift), sight, behind);
      const Lanes together = second * light.by[3] * (behind - 2.f * here + before) - first * fall * (behind - before);
      block.correction += together / light.value;
      isAnyShaded = true;
    }
  }
  return isAnyShaded;
}
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE
