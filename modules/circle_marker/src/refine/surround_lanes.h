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
 * What pixels see beyond the paper, a block at a time.
 */

/*!
  \file surround_lanes.h
  \brief What the pixels of a block see beyond the paper: shareBeyond() in lanes, and what may come of it.
*/

#ifndef VP_CIRCLE_MARKER_SURROUND_LANES_H
#define VP_CIRCLE_MARKER_SURROUND_LANES_H

#include <array>
#include <cmath>

#include "refine/light_lanes.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
/*! The share of what pixels see that lies beyond the paper, and its derivative by where that ends, 1 / pixel. */
struct ShareLanes
{
  Lanes share;
  Lanes byDistance;
};

/*! shareBeyond() of a block. blur: standard deviation, pixels, in the coordinates of the points' derivatives. */
inline ShareLanes shareBeyond(const PlaneLanes &point, const PaperEnd &paper, float blur)
{
  const auto extent = static_cast<float>(paper.extent);
  const float perBlur = 1.f / blur;
  if (paper.shape == PaperShape::ROUND) {
    const NormalLanes beyond = normalOf(perBlur * (point.radius - extent) / point.gradient);
    return {beyond.cumulative, perBlur * beyond.density};
  }
  const auto c = static_cast<float>(std::cos(paper.angle));
  const auto s = static_cast<float>(std::sin(paper.angle));
  const auto inside = [&](const Lanes &q, const Lanes &byU, const Lanes &byV) {
    return normalOf(perBlur * (extent - q.abs()) * (byU * byU + byV * byV).rsqrt());
  };
  const NormalLanes x =
      inside(c * point.qx + s * point.qy, c * point.qxByU + s * point.qyByU, c * point.qxByV + s * point.qyByV);
  const NormalLanes y =
      inside(c * point.qy - s * point.qx, c * point.qyByU - s * point.qxByU, c * point.qyByV - s * point.qxByV);
  return {1.f - x.cumulative * y.cumulative, perBlur * (x.density * y.cumulative + y.density * x.cumulative)};
}

/*!
  Puts what the surround may do to the pixels of a block: something between nothing and all of its share.
  \param pixels : The pixels, with what was seen of the surround.
  \param point : Where they are on the marker.
  \param papers : Where the paper may end.
  \param photometry : Light and blur.
  \param noise : Standard deviation, grey levels.
  \param block : The block: its variance is added to.
  \param surround : The result.
*/
inline void putSurround(const std::array<const FitPixel *, laneCount> &pixels, const PlaneLanes &point,
                        const PaperEnds &papers, const Photometry &photometry, float noise, PixelBlock &block,
                        SurroundLanes &surround)
{
  constexpr float mostSpread = 1e3f; // grey levels: more is not known
  const Lanes light = whiteOf(block, photometry);
  Lanes variance = Lanes::Zero();
  Lanes most = Lanes::Zero();
  Lanes byEnd = Lanes::Zero(); // change of the grey level by where the paper ends
  for (std::size_t shape = 0; shape < paperShapes; ++shape) {
    const auto beyond = [&pixels, shape](int lane) -> const BeyondPaper & {
      return pixels[static_cast<std::size_t>(lane)]->beyond[shape];
    };
    const Lanes isSeen = isPositive(lanesOf([&](int lane) { return beyond(lane).share; }));
    const Lanes spread = lanesOf([&](int lane) { return beyond(lane).spread; }).min(mostSpread);
    const Lanes isKnown = isSeen * isPositive(mostSpread - spread);
    // The pose is better known than when the pixels were chosen.
    const ShareLanes now = shareBeyond(point, papers[shape], static_cast<float>(photometry.blur.sigma));
    const auto share = static_cast<float>(photometry.surround[shape]);
    surround.share[shape] = isKnown * now.share;
    surround.beyond[shape] = isKnown * lanesOf([&](int lane) { return beyond(lane).grey; });
    const Lanes change = isKnown * (surround.beyond[shape] - light);
    most = most.max(now.share * change.abs());
    byEnd += share * now.byDistance * change;
    // Noise alone spreads the few looks: by as much, and half as much again by chance. Where nothing is seen of it,
    // anything is possible.
    const Lanes known = share * share * (spread * spread - 2.f * noise * noise).max(0.f);
    const Lanes doubt = isKnown * known + (isSeen - isKnown) * (0.25f * light * light);
    variance = variance.max(now.share * now.share * doubt);
  }
  surround.spread = most;
  const auto uneven = static_cast<float>(photometry.unevenShare);
  const Lanes end = static_cast<float>(photometry.endError) * byEnd;
  block.variance += variance + uneven * uneven * most * most + end * end;
}
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
