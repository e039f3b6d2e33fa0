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

#include "refine/corners.h"
#include "refine/edge_motion.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
namespace {
// Inner radius of a ring without one, in units of the outer: so far away that no pixel sees it.
constexpr float noEdge = -100.f;

Lanes &valueOf(Lanes &value)
{
  return value;
}
Lanes &valueOf(DarknessLanes &darkness)
{
  return darkness.value;
}
} // namespace

ImageModel::ImageModel(const MarkerPlane &plane, const MarkerPattern &pattern, const BlurParameters &blur,
                       const PixelBlocks &blocks, bool seesBend)
    : m_blocks(blocks), m_homography(plane, blocks.reference, blur.shape()), m_second(blocks.reference),
      m_seesBend(seesBend)
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
  m_spread = static_cast<float>(blur.spread);
  // Circle and radius meet in the image at the angle whose cosine is at most (1 - k^2) / (1 + k^2), k the cosine of the
  // tilt.
  const double squared = std::pow(plane.foreshortening(), 2.);
  m_cornerTerms = cornerTermsFor((1. - squared) / (1. + squared));
}

// One border between sectors, and its corners with the track's rims. band: share of black between the rims.
template <class Result>
void ImageModel::seeBorder(const PlaneLanes &p, const CurvatureLanes &curvature, const Lanes &band,
                           const Lanes &acrossX, const Lanes &acrossY, const Lanes &change, TrackLanes &track,
                           Lanes &code, Lanes &corners, Result &result) const
{
  constexpr bool hasSlopes = std::is_same<Result, DarknessLanes>::value;
  const float perSigma = 1.f / m_sigma;
  const Lanes gu = p.qxByU * acrossX + p.qyByU * acrossY;
  const Lanes gv = p.qxByV * acrossX + p.qyByV * acrossY;
  const Lanes perGradient = (gu * gu + gv * gv).rsqrt();
  // To second order: the border is straight, but the scale changes across it.
  const Lanes first = (acrossX * p.qx + acrossY * p.qy) * perGradient;
  const Lanes bow = first * m_second.across(p, gu * perGradient, gv * perGradient);
  const Lanes distance = perSigma * first * (1.f + 0.5f * bow).max(leastStretch).min(mostStretch);
  const Lanes isEdge = change * change;
  if ((distance.abs() + farFromEdge * (1.f - isEdge)).minCoeff() >= farFromEdge) {
    code += change * (1e30f * distance).max(0.f).min(1.f);
    return;
  }
  const Lanes standardised = distance + perSigma * m_spread * change * perGradient;
  const NormalLanes normal = normalOf(standardised);
  code += change * normal.cumulative;
  Lanes byDistance = change * normal.density * band; // of the share of black
  Lanes byCosine = Lanes::Zero();                    // of the angle between border and rims
  const Lanes density = isEdge * normal.density;
  const bool hasCorners =
      (density * (track.outer.normal.density + track.inner.normal.density)).maxCoeff() >= leastCorner;
  if (hasCorners) {
    // Where the border meets a rim, both on their black sides.
    const Lanes a = change * standardised.max(-6.5f).min(6.5f);
    const Lanes rho = (gu * p.gradientU + gv * p.gradientV) * perGradient * change / p.gradient;
    const auto meet = [&](const EdgeLanes &rim, float side, Lanes &byRim) {
      const Lanes correlation = side * rho;
      CornerLanes corner =
          cornerOf(a, rim.standardised, Lanes(density * rim.normal.density), correlation, m_cornerTerms);
      if (rim.bend.abs().maxCoeff() > leastBend) {
        addBend(a, rim.standardised, rim.bend, isEdge, rim.normal.density, correlation, corner);
      }
      corners += corner.value;
      byDistance += change * corner.byA;
      byRim += corner.byB;
      byCosine += side * corner.byRho;
    };
    meet(track.outer, -1.f, track.outerCorners);
    meet(track.inner, 1.f, track.innerCorners);
  }
  if constexpr (hasSlopes) {
    SlopeLanes slope;
    const Lanes way = first * perGradient;
    slope.footX = p.qx - way * (gu * p.qxByU + gv * p.qxByV);
    slope.footY = p.qy - way * (gu * p.qyByU + gv * p.qyByV);
    slope.byX = perSigma * perGradient * acrossX;
    slope.byY = perSigma * perGradient * acrossY;
    slope.bySigma = -perSigma * standardised;
    stretchOf(gu, gv, perGradient, slope.byElongation);
    for (Lanes &byElongation : slope.byElongation) {
      byElongation *= -standardised;
    }
    slope.bySpread = perSigma * change * perGradient;
    const EdgeMotion motion(m_cx, m_cy, m_perDepth, m_seesBend);
    motion.addStraight(slope, byDistance, result);
    if (hasCorners) {
      motion.addAngle(p, curvature, slope, acrossX, acrossY, change * byCosine, result);
    }
  }
}

template <PixelSight sight, int borders, class Result>
void ImageModel::evaluateAs(const PixelBlock &block, Result &result) const
{
  constexpr bool hasSlopes = std::is_same<Result, DarknessLanes>::value;
  PlaneLanes p;
  CurvatureLanes curvature;
  m_homography.apply(block.place, p);
  curvatureOf(p, m_second, curvature);
  result.setZero();
  const Lanes growth = m_spread * curvature.perGradient; // pixels
  const auto count = [&](const EdgeLanes &edge, const Lanes &weight) {
    if constexpr (hasSlopes) {
      if (edge.isSeen) {
        EdgeMotion(m_cx, m_cy, m_perDepth, m_seesBend).addCircle(p, edge, weight, result);
      }
    }
  };
  if (sight != PixelSight::TRACK) {
    EdgeLanes outer, inner;
    seeCircle<hasSlopes>(p, curvature, m_ring[0], 1.f, m_sigma, growth, outer);
    seeCircle<hasSlopes>(p, curvature, m_ring[1], -1.f, m_sigma, growth, inner);
    valueOf(result) = outer.normal.cumulative + inner.normal.cumulative - 1.f;
    count(outer, outer.normal.density);
    count(inner, inner.normal.density);
  }
  if (sight != PixelSight::RING) {
    const SectorLanes &sectors = m_blocks.sectors[block.sectors];
    TrackLanes track;
    seeCircle<hasSlopes>(p, curvature, m_track[0], 1.f, m_sigma, growth, track.outer);
    seeCircle<hasSlopes>(p, curvature, m_track[1], -1.f, m_sigma, growth, track.inner);
    track.outerCorners.setZero();
    track.innerCorners.setZero();
    const Lanes band = track.outer.normal.cumulative + track.inner.normal.cumulative - 1.f;
    Lanes code = sectors.base;
    Lanes corners = Lanes::Zero();
    // The first border is the nearest one turned back by the sectors between them.
    Lanes acrossX = sectors.acrossX;
    Lanes acrossY = sectors.acrossY;
    for (int back = 0; back < borders / 2; ++back) {
      const Lanes turned = m_cosSector * acrossX + m_sinSector * acrossY;
      acrossY = m_cosSector * acrossY - m_sinSector * acrossX;
      acrossX = turned;
    }
    for (int k = 0; k < borders; ++k) {
      seeBorder(p, curvature, band, acrossX, acrossY, sectors.change[k + (mostBorders - borders) / 2], track, code,
                corners, result);
      if (k + 1 < borders) {
        const Lanes turned = m_cosSector * acrossX - m_sinSector * acrossY;
        acrossY = m_cosSector * acrossY + m_sinSector * acrossX;
        acrossX = turned;
      }
    }
    valueOf(result) += band * code + corners;
    count(track.outer, track.outer.normal.density * code + track.outerCorners);
    count(track.inner, track.inner.normal.density * code + track.innerCorners);
  }
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
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE
