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

#include "refine/circle_edges.h"
#include "refine/corners.h"
#include "refine/light_lanes.h"
#include "refine/surround.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
/*! How a share changes as an end of the paper moves under the pixels' rays. */
struct EndLanes
{
  Lanes footX, footY; //!< Point of the end that is nearest in the image, on the plane.
  Lanes byX, byY;     //!< Derivative of the share by the rays' place on the plane there, 1 / radius.
};

/*! The share of what pixels see that lies beyond the paper, and its derivatives. */
struct ShareLanes
{
  Lanes share;
  Lanes byDistance;               //!< By where the paper ends, 1 / pixel.
  Lanes bySigma;                  //!< 1 / pixel.
  Lanes byElongation[2];          //!< By a step of BlurParameters::elongate().
  Lanes byExtent;                 //!< By PaperEnd::extent.
  std::array<EndLanes, 2> ends{}; //!< Of a square the two nearer sides, of a circle the first alone.
  std::size_t endCount = 1;
};

/*! The same of paper that ends at a circle. blur: standard deviation, pixels, where the blur is round. */
inline ShareLanes shareBeyondCircle(const PlaneLanes &point, const PaperEnd &paper, float blur)
{
  const float perBlur = 1.f / blur;
  const auto centerX = static_cast<float>(paper.center.x());
  const auto centerY = static_cast<float>(paper.center.y());
  const Lanes x = point.qx - centerX;
  const Lanes y = point.qy - centerY;
  const Lanes radius = (x * x + y * y).max(1e-12f).sqrt();
  const Lanes outX = x / radius;
  const Lanes outY = y / radius;
  const Lanes gradientU = point.qxByU * outX + point.qyByU * outY;
  const Lanes gradientV = point.qxByV * outX + point.qyByV * outY;
  const Lanes perGradient = (gradientU * gradientU + gradientV * gradientV).rsqrt();
  const Lanes distance = (radius - static_cast<float>(paper.extent)) * perGradient; // pixels
  const Lanes z = perBlur * distance;
  const NormalLanes beyond = normalOf(z);
  const Lanes byRadius = perBlur * perGradient * beyond.density;
  const Lanes way = distance * perGradient;
  ShareLanes result;
  result.share = beyond.cumulative;
  result.byDistance = perBlur * beyond.density;
  result.bySigma = -perBlur * z * beyond.density;
  Lanes stretched[2];
  stretchOf(gradientU, gradientV, perGradient, stretched);
  for (std::size_t k = 0; k < 2; ++k) {
    result.byElongation[k] = -z * beyond.density * stretched[k];
  }
  const Lanes footX = x - way * (gradientU * point.qxByU + gradientV * point.qxByV);
  const Lanes footY = y - way * (gradientU * point.qyByU + gradientV * point.qyByV);
  const Lanes perRadius = (footX * footX + footY * footY).rsqrt(); // the circle's normal is that at the foot
  result.ends[0] = {footX + centerX, footY + centerY, byRadius * perRadius * footX, byRadius * perRadius * footY};
  result.byExtent = -byRadius;
  return result;
}

/*! A side of a square sheet, as pixels see it. */
struct SideLanes
{
  /*! axisX, axisY: of the square, on the plane, across the side. */
  SideLanes(const PlaneLanes &point, float axisX, float axisY, float center, float extent, float perBlur)
  {
    const Lanes along = axisX * point.qx + axisY * point.qy - center;
    sign = (1e30f * along).max(-1.f).min(1.f);
    byU = sign * (axisX * point.qxByU + axisY * point.qyByU);
    byV = sign * (axisX * point.qxByV + axisY * point.qyByV);
    perLength = (byU * byU + byV * byV).rsqrt();
    standardised = (perBlur * (extent - along.abs()) * perLength).max(-6.5f).min(6.5f);
    inside = normalOf(standardised);
  }

  Lanes sign;         // of the place along the axis
  Lanes byU, byV;     // derivative of the distance along it, outward, by the pixel
  Lanes perLength;    // of that
  Lanes standardised; // distance in standard deviations of the blur, positive on the paper
  NormalLanes inside; // share on the paper's side of it
};

/*! The same of a square sheet. */
inline ShareLanes shareBeyondSquare(const PlaneLanes &point, const PaperEnd &paper, float blur)
{
  const auto extent = static_cast<float>(paper.extent);
  const float perBlur = 1.f / blur;
  const auto c = static_cast<float>(std::cos(paper.angle));
  const auto s = static_cast<float>(std::sin(paper.angle));
  const Eigen::Vector2f center = paper.alongAxes(paper.center).cast<float>();
  const std::array<SideLanes, 2> sides = {
      {{point, c, s, center.x(), extent, perBlur}, {point, -s, c, center.y(), extent, perBlur}}};
  const SideLanes &x = sides[0];
  const SideLanes &y = sides[1];
  Lanes inside = x.inside.cumulative * y.inside.cumulative;
  std::array<Lanes, 2> bySide = {x.inside.density * y.inside.cumulative, y.inside.density * x.inside.cumulative};
  const Lanes density = x.inside.density * y.inside.density;
  if (density.maxCoeff() >= static_cast<float>(leastPaperCorner)) { // aslant a corner is not a right angle
    const Lanes rho = (x.byU * y.byU + x.byV * y.byV) * x.perLength * y.perLength;
    const CornerLanes corner = cornerOf(x.standardised, y.standardised, density, rho, mostCornerTerms);
    inside += corner.value;
    bySide[0] += corner.byA;
    bySide[1] += corner.byB;
  }
  ShareLanes result;
  result.share = 1.f - inside;
  result.byDistance = perBlur * (bySide[0] + bySide[1]);
  result.bySigma.setZero();
  result.byElongation[0].setZero();
  result.byElongation[1].setZero();
  result.byExtent.setZero();
  result.endCount = 2;
  for (std::size_t i = 0; i < 2; ++i) {
    const SideLanes &side = sides[i];
    const Lanes byBlur = side.standardised * bySide[i];
    result.bySigma += perBlur * byBlur;
    Lanes stretched[2];
    stretchOf(side.byU, side.byV, side.perLength, stretched);
    result.byElongation[0] += byBlur * stretched[0];
    result.byElongation[1] += byBlur * stretched[1];
    const Lanes way = blur * side.standardised * side.perLength;
    const Lanes byOutward = perBlur * bySide[i] * side.perLength;
    const Lanes byAlong = byOutward * side.sign;
    result.byExtent -= byOutward;
    const float axisX = i == 0 ? c : -s;
    const float axisY = i == 0 ? s : c;
    result.ends[i] = {point.qx + way * (side.byU * point.qxByU + side.byV * point.qxByV),
                      point.qy + way * (side.byU * point.qyByU + side.byV * point.qyByV), axisX * byAlong,
                      axisY * byAlong};
  }
  return result;
}

/*! shareBeyond() of a block. blur: standard deviation, pixels, in the coordinates of the points' derivatives. */
inline ShareLanes shareBeyond(const PlaneLanes &point, const PaperEnd &paper, float blur)
{
  return paper.shape == PaperShape::ROUND ? shareBeyondCircle(point, paper, blur)
                                          : shareBeyondSquare(point, paper, blur);
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
    surround.isKnown[shape] = isKnown;
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
