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
 * What a blurring camera makes of a marker: the darkness of a pixel.
 */

#include "refine/image_model.h"

#include <cmath>
#include <type_traits>

#include "refine/circle_edges.h"
#include "refine/corners.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
namespace {
// Inner radius of a ring without one, in units of the outer: so far away that no pixel sees it.
constexpr float noEdge = -100.f;

// Puts the share of black, and the derivatives that were asked for.
void put(const SumLanes &total, const PlaneLanes &, float, float, float, Lanes &value)
{
  value = total.value;
}

void put(const SumLanes &total, const PlaneLanes &p, float cx, float cy, float perDepth, DarknessLanes &darkness)
{
  const Lanes bySlope = (total.byX * (p.qx - cx) + total.byY * (p.qy - cy)) * perDepth;
  darkness.value = total.value;
  darkness.byTwist[0] = -total.byX;
  darkness.byTwist[1] = -total.byY;
  darkness.byTwist[2] = bySlope;
  darkness.byTwist[3] = bySlope * p.qy;
  darkness.byTwist[4] = -bySlope * p.qx;
  darkness.byTwist[5] = total.byX * p.qy - total.byY * p.qx;
  darkness.bySigma = total.bySigma;
  darkness.byElongation[0] = total.byElongation[0];
  darkness.byElongation[1] = total.byElongation[1];
  darkness.byGrowth = total.byGrowth;
  darkness.bySpread = total.bySpread;
}
} // namespace

ImageModel::ImageModel(const MarkerPlane &plane, const MarkerPattern &pattern, const BlurParameters &blur,
                       const PixelBlocks &blocks)
    : m_blocks(blocks), m_homography(plane, blocks.reference, blur.shape())
{
  const Eigen::Vector3d c = -plane.rotation.transpose() * plane.center / plane.radius;
  m_cx = static_cast<float>(c.x());
  m_cy = static_cast<float>(c.y());
  m_perDepth = static_cast<float>(-1. / c.z());
  m_ring[0] = static_cast<float>(pattern.ring[0].radius);
  m_ring[1] = pattern.ringEdges > 1 ? static_cast<float>(pattern.ring[1].radius) : noEdge;
  m_track[0] = static_cast<float>(pattern.track[0].radius);
  m_track[1] = static_cast<float>(pattern.track[1].radius);
  m_borders = pattern.sectors > 0 ? blocks.borders : 0;
  const double sectorAngle = pattern.sectors > 0 ? 2. * M_PI / pattern.sectors : 0.;
  m_cosSector = static_cast<float>(std::cos(sectorAngle));
  m_sinSector = static_cast<float>(std::sin(sectorAngle));
  m_sigma = static_cast<float>(blur.sigma);
  m_growth = static_cast<float>(blur.growth);
  m_spread = static_cast<float>(blur.spread);
  // Circle and radius meet in the image at the angle whose cosine is at most (1 - k^2) / (1 + k^2), k the cosine of the
  // tilt.
  const double squared = std::pow(plane.rotation.col(2).dot(plane.center.normalized()), 2.);
  m_cornerTerms = cornerTermsFor((1. - squared) / (1. + squared));
}

// One border between sectors, and its corners with the track's rims.
template <bool hasSlopes>
void ImageModel::seeBorder(const PlaneLanes &p, const TrackLanes &track, const Lanes &acrossX, const Lanes &acrossY,
                           const Lanes &change, SumLanes &code, SumLanes &corners) const
{
  const EdgeLanes &outer = track.outer;
  const EdgeLanes &inner = track.inner;
  const float perSigma = 1.f / m_sigma;
  const Lanes gu = p.qxByU * acrossX + p.qyByU * acrossY;
  const Lanes gv = p.qxByV * acrossX + p.qyByV * acrossY;
  const Lanes perGradient = (gu * gu + gv * gv).rsqrt();
  const Lanes distance = perSigma * (acrossX * p.qx + acrossY * p.qy) * perGradient;
  const Lanes isEdge = change * change;
  if ((distance.abs() + farFromEdge * (1.f - isEdge)).minCoeff() >= farFromEdge) {
    code.value += change * (1e30f * distance).max(0.f).min(1.f);
    return;
  }
  const Lanes standardised = distance + perSigma * change * (m_growth + m_spread * perGradient);
  const NormalLanes normal = normalOf(standardised);
  code.value += change * normal.cumulative;
  Lanes stretched[2];
  if constexpr (hasSlopes) {
    const Lanes slope = perSigma * change * normal.density;
    code.byX += slope * perGradient * acrossX;
    code.byY += slope * perGradient * acrossY;
    code.bySigma -= slope * standardised;
    const Lanes byGrowth = slope * change;
    code.byGrowth += byGrowth;
    code.bySpread += byGrowth * perGradient;
    stretchOf(gu, gv, perGradient, stretched);
    for (std::size_t k = 0; k < 2; ++k) {
      code.byElongation[k] -= change * normal.density * distance * stretched[k];
    }
  }
  const Lanes density = isEdge * normal.density;
  if ((density * (outer.normal.density + inner.normal.density)).maxCoeff() < leastCorner) {
    return;
  }
  // Where the border meets a rim, both on their black sides.
  const Lanes a = change * standardised.max(-6.5f).min(6.5f);
  const Lanes aByAcross = perSigma * change * perGradient;
  const Lanes rho = (gu * p.gradientU + gv * p.gradientV) * perGradient * change / p.gradient;
  const auto meet = [&](const EdgeLanes &rim, const Lanes &correlation) {
    CornerLanes corner = cornerOf(a, rim.standardised, density * rim.normal.density, correlation, m_cornerTerms);
    if (rim.bend.abs().maxCoeff() > leastBend) {
      addBend(a, rim.standardised, rim.bend, isEdge, rim.normal.density, correlation, corner);
    }
    corners.value += corner.value;
    if constexpr (!hasSlopes) {
      return;
    }
    const Lanes byRadius = corner.byB * rim.byRadius;
    corners.byX += corner.byA * aByAcross * acrossX + byRadius * p.outX;
    corners.byY += corner.byA * aByAcross * acrossY + byRadius * p.outY;
    corners.bySigma += corner.byB * rim.bySigma - perSigma * corner.byA * a;
    corners.byGrowth += perSigma * (corner.byA + corner.byB);
    corners.bySpread += perSigma * (corner.byA * perGradient + corner.byB / p.gradient);
    for (std::size_t k = 0; k < 2; ++k) {
      corners.byElongation[k] +=
          corner.byB * rim.byStretch * track.stretched[k] - corner.byA * change * distance * stretched[k];
    }
  };
  meet(outer, -rho);
  meet(inner, rho);
}

template <PixelSight sight, int borders, class Result>
void ImageModel::evaluateAs(const PixelBlock &block, Result &result) const
{
  constexpr bool hasSlopes = std::is_same<Result, DarknessLanes>::value;
  PlaneLanes p;
  CurvatureLanes curvature;
  m_homography.apply(block.place, p);
  curvatureOf(p, curvature);
  SumLanes total;
  const Lanes growth = m_growth + m_spread * curvature.perGradient; // pixels
  if (sight != PixelSight::TRACK) {
    EdgeLanes outer, inner;
    seeCircle(p, curvature, m_ring[0], 1.f, m_sigma, growth, outer);
    seeCircle(p, curvature, m_ring[1], -1.f, m_sigma, growth, inner);
    seeBand(p, outer, inner, 1.f / m_sigma, curvature, total);
  }
  if (sight != PixelSight::RING) {
    const SectorLanes &sectors = m_blocks.sectors[block.sectors];
    TrackLanes track;
    SumLanes band, code;
    seeCircle(p, curvature, m_track[0], 1.f, m_sigma, growth, track.outer);
    seeCircle(p, curvature, m_track[1], -1.f, m_sigma, growth, track.inner);
    seeBand(p, track.outer, track.inner, 1.f / m_sigma, curvature, band);
    SumLanes corners;
    for (std::size_t k = 0; k < 2; ++k) {
      track.stretched[k] = curvature.stretched[k];
    }
    for (SumLanes *sum : {&code, &corners}) {
      for (Lanes *lanes : {&sum->value, &sum->byX, &sum->byY, &sum->bySigma, &sum->byElongation[0],
                           &sum->byElongation[1], &sum->byGrowth, &sum->bySpread}) {
        lanes->setZero();
      }
    }
    code.value = sectors.base;
    // The first border is the nearest one turned back by the sectors between them.
    Lanes acrossX = sectors.acrossX;
    Lanes acrossY = sectors.acrossY;
    for (int back = 0; back < borders / 2; ++back) {
      const Lanes turned = m_cosSector * acrossX + m_sinSector * acrossY;
      acrossY = m_cosSector * acrossY - m_sinSector * acrossX;
      acrossX = turned;
    }
    for (int k = 0; k < borders; ++k) {
      seeBorder<hasSlopes>(p, track, acrossX, acrossY, sectors.change[k + (mostBorders - borders) / 2], code, corners);
      if (k + 1 < borders) {
        const Lanes turned = m_cosSector * acrossX - m_sinSector * acrossY;
        acrossY = m_cosSector * acrossY + m_sinSector * acrossX;
        acrossX = turned;
      }
    }
    SumLanes seen;
    seen.value = band.value * code.value + corners.value;
    const auto derivative = [&](const Lanes &byBand, const Lanes &byCode, const Lanes &byCorners) -> Lanes {
      return band.value * byCode + code.value * byBand + byCorners;
    };
    seen.byX = derivative(band.byX, code.byX, corners.byX);
    seen.byY = derivative(band.byY, code.byY, corners.byY);
    seen.bySigma = derivative(band.bySigma, code.bySigma, corners.bySigma);
    seen.byGrowth = derivative(band.byGrowth, code.byGrowth, corners.byGrowth);
    seen.bySpread = derivative(band.bySpread, code.bySpread, corners.bySpread);
    for (std::size_t k = 0; k < 2; ++k) {
      seen.byElongation[k] = derivative(band.byElongation[k], code.byElongation[k], corners.byElongation[k]);
    }
    if (sight == PixelSight::TRACK) {
      total = seen;
    }
    else {
      total.value += seen.value;
      total.byX += seen.byX;
      total.byY += seen.byY;
      total.bySigma += seen.bySigma;
      total.byGrowth += seen.byGrowth;
      total.bySpread += seen.bySpread;
      total.byElongation[0] += seen.byElongation[0];
      total.byElongation[1] += seen.byElongation[1];
    }
  }
  put(total, p, m_cx, m_cy, m_perDepth, result);
}

void ImageModel::evaluate(const PixelBlock &block, PixelSight sight, DarknessLanes &darkness) const
{
  evaluateParabolas(block, sight, darkness);
  darkness.value += block.correction;
}

void ImageModel::evaluate(const PixelBlock &block, PixelSight sight, Lanes &value) const
{
  evaluateParabolas(block, sight, value);
  value += block.correction;
}

template <class Result>
void ImageModel::evaluateParabolas(const PixelBlock &block, PixelSight sight, Result &result) const
{
  if (sight == PixelSight::RING || m_borders == 0) {
    evaluateAs<PixelSight::RING, 0>(block, result);
  }
  else if (sight == PixelSight::TRACK) {
    m_borders == 1   ? evaluateAs<PixelSight::TRACK, 1>(block, result)
    : m_borders == 3 ? evaluateAs<PixelSight::TRACK, 3>(block, result)
                     : evaluateAs<PixelSight::TRACK, 5>(block, result);
  }
  else {
    m_borders == 1   ? evaluateAs<PixelSight::RING_AND_TRACK, 1>(block, result)
    : m_borders == 3 ? evaluateAs<PixelSight::RING_AND_TRACK, 3>(block, result)
                     : evaluateAs<PixelSight::RING_AND_TRACK, 5>(block, result);
  }
}

Darkness darknessAt(const ModelPixel &pixel, const MarkerPlane &plane, const MarkerPattern &pattern,
                    const BlurParameters &blur)
{
  FitPixel single;
  single.meter = pixel.meter.cast<float>();
  single.meterPerPixel = pixel.meterPerPixel.cast<float>();
  Photometry photometry;
  photometry.blur = blur;
  PixelBlocks blocks;
  packPixels({single}, plane, pattern, photometry, 0., 0., mostBorders, blocks);
  const ImageModel model(plane, pattern, blur, blocks);
  Darkness darkness;
  for (std::size_t kind = 0; kind < pixelSights; ++kind) {
    if (blocks.count[kind] == 0) {
      continue;
    }
    DarknessLanes lanes;
    model.evaluate(blocks.bySight[kind][0], static_cast<PixelSight>(kind), lanes);
    const Eigen::Vector3d translation(lanes.byTwist[0][0], lanes.byTwist[1][0], lanes.byTwist[2][0]);
    const Eigen::Vector3d turn(lanes.byTwist[3][0], lanes.byTwist[4][0], lanes.byTwist[5][0]);
    darkness.value = lanes.value[0];
    darkness.byPose << plane.rotation * translation / plane.radius, plane.rotation * turn;
    darkness.bySigma = lanes.bySigma[0];
    darkness.byElongation << lanes.byElongation[0][0], lanes.byElongation[1][0];
    darkness.byGrowth = lanes.byGrowth[0];
    darkness.bySpread = lanes.bySpread[0];
  }
  return darkness;
}
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE
