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

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
namespace {
// The second-order distance to a circle is not let further from the first-order one than by this share, and the shift
// by its curvature not beyond half of the blur: only pixels that do not see the circle come so far.
constexpr float leastStretch = 0.8f;
constexpr float mostStretch = 1.25f;
constexpr float mostCurvature = 1.f;
constexpr float leastFading = 0.4f;
constexpr float mostFading = 2.f;
// Terms of the tetrachoric series: as many as leave 2e-4 of the contrast, but no more than these.
constexpr int mostCornerTerms = 10;
constexpr double cornerPrecision = 2e-4;
// Product of two densities below which a corner is not seen.
constexpr float leastCorner = 1e-5f;
// Edges that bend by less than this within the blur, in units of it, are straight at corners: 2e-4 of the contrast.
constexpr float leastBend = 2e-3f;
// Squared sine of the angle between two edges: corners are not sharper.
constexpr float leastSquaredSine = 0.05f;
// A block that is farther from an edge than this many standard deviations of the blur, to first order, does not see it.
// Beyond lie 3e-7 of the contrast.
constexpr float farFromEdge = 5.f;
// Inner radius of a ring without one, in units of the outer: so far away that no pixel sees it.
constexpr float noEdge = -100.f;

// What the curvature of circles about the centre needs of a block's pixels.
struct CurvatureLanes
{
  Lanes perGradient;  // 1 / length of the radius' gradient in the image, pixels
  Lanes alongNormal;  // second derivative of the radius along the gradient, by the gradient, 1 / pixel
  Lanes alongTangent; // and along the circle
  Lanes fading;       // share by which the circles' curvature falls on the way out, 1 / pixel
  Lanes stretched[2]; // stretch of the blur across the circles by each part of an elongation
};

// Stretch of the blur across an edge by each part of an elongation: cosine and sine of twice the direction of its
// normal (u, v) of length 1 / perLength.
void stretchOf(const Lanes &u, const Lanes &v, const Lanes &perLength, Lanes stretched[2])
{
  const Lanes cosine = u * perLength;
  const Lanes sine = v * perLength;
  stretched[0] = cosine * cosine - sine * sine;
  stretched[1] = 2.f * cosine * sine;
}

void curvatureOf(const PlaneLanes &p, CurvatureLanes &curvature)
{
  curvature.perGradient = p.gradient.inverse();
  const Lanes perRadius = p.radius.inverse();
  const Lanes hu = p.qyByU * p.outX - p.qxByU * p.outY;
  const Lanes hv = p.qyByV * p.outX - p.qxByV * p.outY;
  const Lanes normal = (hu * p.gradientU + hv * p.gradientV) * curvature.perGradient;
  const Lanes tangent = (hv * p.gradientU - hu * p.gradientV) * curvature.perGradient;
  curvature.alongNormal = normal * normal * perRadius * curvature.perGradient;
  curvature.alongTangent = tangent * tangent * perRadius * curvature.perGradient;
  curvature.fading = p.gradient * perRadius + 3.f * curvature.alongNormal;
  stretchOf(p.gradientU, p.gradientV, curvature.perGradient, curvature.stretched);
}

// An edge that none of the pixels sees: all are on the same side of it as this distance.
void seeNothing(const Lanes &distance, EdgeLanes &edge)
{
  edge.standardised = (1e30f * distance).max(-6.5f).min(6.5f);
  edge.normal.cumulative = (1e30f * distance).max(0.f).min(1.f);
  edge.normal.density.setZero();
  edge.bend.setZero();
  edge.byRadius.setZero();
  edge.bySigma.setZero();
  edge.byStretch.setZero();
}

// Circle of a radius, black inside (blackSide 1) or outside (-1).
void seeCircle(const PlaneLanes &p, const CurvatureLanes &curvature, float radius, float blackSide, float sigma,
               const Lanes &growth, EdgeLanes &edge)
{
  const float perSigma = 1.f / sigma;
  const Lanes first = (radius - p.radius) * curvature.perGradient;
  if (first.abs().minCoeff() > farFromEdge * sigma) {
    seeNothing(blackSide * first, edge);
    return;
  }
  // Second-order distance along the gradient to the level set of the radius.
  const Lanes bow = curvature.alongNormal * first;
  const Lanes stretch = (1.f - 0.5f * bow).max(leastStretch).min(mostStretch);
  const Lanes scaled = perSigma * first * stretch;
  // Curvature where the edge is, in units of the blur: half of it is the mean, and its square half of the variance, of
  // what the edge bends away within the blur.
  const Lanes atEdge =
      curvature.alongTangent * (1.f - curvature.fading * first * stretch).max(leastFading).min(mostFading);
  const Lanes bend = (0.5f * sigma) * atEdge.min(mostCurvature * perSigma);
  const Lanes squared = bend * bend;
  edge.bend = blackSide * bend;
  // The density stays what it is from 6.5 on, and the corners' polynomials must not grow on.
  edge.standardised = (blackSide * (scaled - bend) * (1.f - squared) + growth * perSigma).max(-6.5f).min(6.5f);
  edge.normal = normalOf(edge.standardised);
  edge.byRadius =
      (-blackSide * perSigma) * curvature.perGradient * (1.f - bow - squared).max(leastStretch).min(mostStretch);
  edge.bySigma = -perSigma * (blackSide * (scaled * (1.f + squared) + bend) + growth * perSigma);
  // Distances across shrink, and the curvature with them and with the square of what is longer along the edge.
  edge.byStretch = -blackSide * (scaled * (1.f + squared) - 3.f * bend);
}

// Black between two circles.
void seeBand(const PlaneLanes &p, const EdgeLanes &outer, const EdgeLanes &inner, float perSigma,
             const CurvatureLanes &curvature, SumLanes &band)
{
  band.value = outer.normal.cumulative + inner.normal.cumulative - 1.f;
  const Lanes byRadius = outer.normal.density * outer.byRadius + inner.normal.density * inner.byRadius;
  band.byX = byRadius * p.outX;
  band.byY = byRadius * p.outY;
  band.bySigma = outer.normal.density * outer.bySigma + inner.normal.density * inner.bySigma;
  band.byGrowth = perSigma * (outer.normal.density + inner.normal.density);
  band.bySpread = curvature.perGradient * band.byGrowth;
  const Lanes byStretch = outer.normal.density * outer.byStretch + inner.normal.density * inner.byStretch;
  band.byElongation[0] = byStretch * curvature.stretched[0];
  band.byElongation[1] = byStretch * curvature.stretched[1];
}

// Probability of both sides of two edges less the product of the probabilities, and its derivatives.
struct CornerLanes
{
  Lanes value;
  Lanes byA;
  Lanes byB;
};

// By the tetrachoric series, whose n-th term is rho^(n+1) / (n+1)! He_n(a) He_n(b) with the Hermite polynomials He_n,
// all times both densities; the derivative of a density times He_n is that of - He_(n+1).
CornerLanes cornerOf(const Lanes &a, const Lanes &b, const Lanes &density, const Lanes &rho, int terms)
{
  Lanes power = rho;
  Lanes hermiteA = Lanes::Ones(), previousA = Lanes::Zero();
  Lanes hermiteB = Lanes::Ones(), previousB = Lanes::Zero();
  CornerLanes corner = {Lanes::Zero(), Lanes::Zero(), Lanes::Zero()};
  for (int n = 0; n < terms; ++n) {
    const auto order = static_cast<float>(n);
    const Lanes nextA = a * hermiteA - order * previousA;
    const Lanes nextB = b * hermiteB - order * previousB;
    corner.value += power * hermiteA * hermiteB;
    corner.byA -= power * nextA * hermiteB;
    corner.byB -= power * hermiteA * nextB;
    power *= rho / (order + 2.f);
    previousA = hermiteA;
    previousB = hermiteB;
    hermiteA = nextA;
    hermiteB = nextB;
  }
  corner.value *= density;
  corner.byA *= density;
  corner.byB *= density;
  return corner;
}

// What the bend of the circular edge b adds to a corner. The edge's distance is less by bend t^2 at the place t along
// it, on average over the black side of the straight edge, t < h = (a - rho b) / sqrt(1 - rho^2), by
// bend (Phi(h) - h phi(h)) instead of bend Phi(h).
void addBend(const Lanes &a, const Lanes &b, const Lanes &bend, const Lanes &isEdge, const Lanes &densityOfB,
             const Lanes &rho, CornerLanes &corner)
{
  const Lanes perSine = (1.f - rho * rho).max(leastSquaredSine).rsqrt();
  const Lanes h = ((a - rho * b) * perSine).max(-6.5f).min(6.5f);
  const Lanes factor = isEdge * bend * densityOfB * 0.39894228f * (-0.5f * h * h).exp();
  const Lanes byH = factor * (1.f - h * h) * perSine;
  corner.value += factor * h;
  corner.byA += byH;
  corner.byB -= byH * rho + factor * h * b;
}

int cornerTermsFor(double rho)
{
  int terms = 1;
  // The Hermite functions are bounded so that term n is about a tenth of rho^(n+1) / (n+1).
  while (terms < mostCornerTerms && 0.1 * std::pow(rho, terms + 1) / (terms + 1) > cornerPrecision) {
    ++terms;
  }
  return terms;
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
  const Lanes slope = perSigma * change * normal.density;
  code.value += change * normal.cumulative;
  code.byX += slope * perGradient * acrossX;
  code.byY += slope * perGradient * acrossY;
  code.bySigma -= slope * standardised;
  const Lanes byGrowth = slope * change;
  code.byGrowth += byGrowth;
  code.bySpread += byGrowth * perGradient;
  Lanes stretched[2];
  stretchOf(gu, gv, perGradient, stretched);
  for (std::size_t k = 0; k < 2; ++k) {
    code.byElongation[k] -= change * normal.density * distance * stretched[k];
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
    const Lanes byRadius = corner.byB * rim.byRadius;
    corners.value += corner.value;
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

template <PixelSight sight, int borders>
void ImageModel::evaluateAs(const PixelBlock &block, DarknessLanes &darkness) const
{
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
      seeBorder(p, track, acrossX, acrossY, sectors.change[k + (mostBorders - borders) / 2], code, corners);
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
  const Lanes bySlope = (total.byX * (p.qx - m_cx) + total.byY * (p.qy - m_cy)) * m_perDepth;
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

void ImageModel::evaluate(const PixelBlock &block, PixelSight sight, DarknessLanes &darkness) const
{
  evaluateParabolas(block, sight, darkness);
  darkness.value += block.correction;
}

void ImageModel::evaluateParabolas(const PixelBlock &block, PixelSight sight, DarknessLanes &darkness) const
{
  if (sight == PixelSight::RING || m_borders == 0) {
    evaluateAs<PixelSight::RING, 0>(block, darkness);
  }
  else if (sight == PixelSight::TRACK) {
    m_borders == 1   ? evaluateAs<PixelSight::TRACK, 1>(block, darkness)
    : m_borders == 3 ? evaluateAs<PixelSight::TRACK, 3>(block, darkness)
                     : evaluateAs<PixelSight::TRACK, 5>(block, darkness);
  }
  else {
    m_borders == 1   ? evaluateAs<PixelSight::RING_AND_TRACK, 1>(block, darkness)
    : m_borders == 3 ? evaluateAs<PixelSight::RING_AND_TRACK, 3>(block, darkness)
                     : evaluateAs<PixelSight::RING_AND_TRACK, 5>(block, darkness);
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
