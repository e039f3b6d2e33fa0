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
 * Darkness of strongly bent edges, integrated along lines.
 */

#include "refine/line_model.h"

#include <algorithm>
#include <cmath>

#include "refine/bend_limits.h"
#include "refine/image_model.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
namespace {
// A line across the edges: its place across in standard deviations of the blur, and its weight.
struct Node
{
  float place;
  float weight;
};
// Lines at right angles to a ring's edges that bend little see a smooth function of their place: the Gauss-Hermite rule
// of five nodes (Abramowitz and Stegun, table 25.10, for the standard normal distribution).
constexpr std::array<Node, 5> ringNodes = {{{-2.856970f, 0.01125741f},
                                            {-1.355626f, 0.22207592f},
                                            {0.f, 0.53333333f},
                                            {1.355626f, 0.22207592f},
                                            {2.856970f, 0.01125741f}}};
// Lines at 45 degrees to edges see a function that is no smoother than the blur, and has kinks where they pass corners:
// the trapezoidal rule with a step of 0.45 standard deviations. With one of 0.6 the kinks leave 0.3 % of the contrast.
constexpr std::array<Node, 14> aslantNodes = {{{-2.925f, 0.00249425f},
                                               {-2.475f, 0.00840635f},
                                               {-2.025f, 0.02313827f},
                                               {-1.575f, 0.05201270f},
                                               {-1.125f, 0.09548678f},
                                               {-0.675f, 0.14316357f},
                                               {-0.225f, 0.17529808f},
                                               {0.225f, 0.17529808f},
                                               {0.675f, 0.14316357f},
                                               {1.125f, 0.09548678f},
                                               {1.575f, 0.05201270f},
                                               {2.025f, 0.02313827f},
                                               {2.475f, 0.00840635f},
                                               {2.925f, 0.00249425f}}};
// Crossings farther away than this many standard deviations see none of the blur.
constexpr float farFromCrossing = 5.f;
// Lines cross the borders that matter more steeply than this.
constexpr float leastCosine = 0.2f;

// In the precision of the lanes.
constexpr auto strongBendOfRing = static_cast<float>(bend_limits::strongOfRing);
constexpr auto strongBendOfTrack = static_cast<float>(bend_limits::strongOfTrack);
constexpr auto seenAcross = static_cast<float>(bend_limits::seenAcross);
constexpr auto leastSpacing = static_cast<float>(bend_limits::leastSpacing);
constexpr auto leastSemiMinor = static_cast<float>(bend_limits::leastSemiMinor);
// Where a circle of the ring bends by more than this, lines that cross it see less than half of the blur inside of it.
constexpr float sharpBend = 0.25f;
} // namespace

// Points (q0 + s m) / (w0 + s w) of the plane, with s in standard deviations of the blur from the point nearest to the
// pixel.
struct LineModel::Line
{
  Lanes qx, qy, w0;
  Lanes mx, my, w;
  Lanes rimGrowth; // growth of black along the line at a circle, standard deviations
};

// How parallel lines cross a border.
struct LineModel::Crossing
{
  Lanes perSpeed; // standard deviations by the distance from it on the plane
  Lanes change;   // 1 from white to black, -1 from black to white
  Lanes growth;   // of black along the line there, standard deviations
};

// Share of the blur before the two crossings of a circle.
struct LineModel::Chord
{
  Lanes before, after;
};

LineModel::LineModel(const MarkerPlane &plane, const MarkerPattern &pattern, const BlurParameters &blur,
                     const ImageReference &reference)
    : m_homography(plane, reference, blur.shape()), m_ring{static_cast<float>(pattern.ring[0].radius),
                                                           pattern.ringEdges > 1
                                                               ? static_cast<float>(pattern.ring[1].radius)
                                                               : 0.f},
      m_track{static_cast<float>(pattern.track[0].radius), static_cast<float>(pattern.track[1].radius)},
      m_perSigma(static_cast<float>(1. / blur.sigma)), m_spread(static_cast<float>(blur.spread))
{
  const int sectors = static_cast<int>(pattern.sectors);
  if (sectors > 0) {
    m_sectorAngle = 6.2831853f / static_cast<float>(sectors);
    m_first = pattern.darknessOf(-1);
  }
  for (int k = 0; k < sectors; ++k) {
    if (pattern.darknessOf(k) != pattern.darknessOf(k - 1)) {
      const Eigen::Vector2d &across = pattern.acrossBorder(k);
      m_borders[m_borderCount++] = {static_cast<float>(across.y()), static_cast<float>(-across.x()),
                                    pattern.darknessOf(k) - pattern.darknessOf(k - 1), 2 * k >= sectors};
    }
  }
}

// Crossings of a circle whose inside grows.
LineModel::Chord LineModel::chordOf(const Line &line, float radius, const Lanes &growth) const
{
  const float squared = radius * radius;
  const Lanes a = (line.mx * line.mx + line.my * line.my - squared * line.w * line.w).max(1e-12f);
  const Lanes b = line.qx * line.mx + line.qy * line.my - squared * line.w0 * line.w;
  const Lanes c = line.qx * line.qx + line.qy * line.qy - squared * line.w0 * line.w0;
  const Lanes discriminant = b * b - a * c;
  const Lanes half = discriminant.max(0.f).sqrt();
  const Lanes perA = a.inverse();
  const Lanes isCrossed = isPositive(discriminant);
  const Lanes first = ((-b - half) * perA - isCrossed * growth).max(-6.5f).min(6.5f);
  const Lanes second = ((-b + half) * perA + isCrossed * growth).max(-6.5f).min(6.5f);
  Chord chord;
  chord.after = cumulativeOf(second);
  chord.before = first.maxCoeff() < -farFromCrossing ? Lanes(Lanes::Zero()) : cumulativeOf(first);
  return chord;
}

Lanes LineModel::ringAlong(const Line &line) const
{
  const Chord outer = chordOf(line, m_ring[0], line.rimGrowth);
  Lanes black = outer.after - outer.before;
  if (m_ring[1] > 0.f) {
    const Chord inner = chordOf(line, m_ring[1], -line.rimGrowth);
    black -= inner.after - inner.before;
  }
  return black;
}

void LineModel::crossBorders(const PlaneLanes &p, const Lanes &u, const Lanes &v, const Line &line,
                             Crossings &crossings) const
{
  for (std::size_t k = 0; k < m_borderCount; ++k) {
    const float acrossX = -m_borders[k].alongY;
    const float acrossY = m_borders[k].alongX;
    const Lanes speed = acrossX * line.mx + acrossY * line.my;
    const Lanes sense = 2.f * isPositive(speed) - 1.f;
    Crossing &crossing = crossings[k];
    crossing.perSpeed = (sense * speed.abs().max(1e-12f)).inverse();
    crossing.change = m_borders[k].change * sense;
    // Where black grows the border moves away from it.
    const Lanes gu = p.qxByU * acrossX + p.qyByU * acrossY;
    const Lanes gv = p.qxByV * acrossX + p.qyByV * acrossY;
    const Lanes perGradient = (gu * gu + gv * gv).rsqrt();
    const Lanes cosine = (gu * u + gv * v).abs() * perGradient;
    crossing.growth = crossing.change * (m_perSigma * m_spread * perGradient) / cosine.max(leastCosine);
  }
}

Lanes LineModel::trackAlong(const Line &line, const Crossings &crossings) const
{
  const Chord outer = chordOf(line, m_track[0], line.rimGrowth);
  const Chord inner = chordOf(line, m_track[1], -line.rimGrowth);
  // The sector that the line comes from: that of its direction backward, or of where the image ends in that direction
  // if it does before the plane's horizon.
  const Lanes ahead = line.w.max(0.f);
  const Lanes fromX = ahead * line.qx - line.mx * line.w0;
  const Lanes fromY = ahead * line.qy - line.my * line.w0;
  const Lanes isLower = isPositive(-fromY);
  Lanes code = Lanes::Constant(m_first);
  Lanes black = Lanes::Zero();
  for (std::size_t k = 0; k < m_borderCount; ++k) {
    const Border &border = m_borders[k];
    const float acrossX = -border.alongY;
    const float acrossY = border.alongX;
    const Lanes isPast = isPositive(acrossX * fromX + acrossY * fromY);
    code += border.change * (border.isLower ? Lanes(isPast.min(isLower)) : Lanes(isPast.max(isLower)));
    const Crossing &crossing = crossings[k];
    const Lanes at = -(acrossX * line.qx + acrossY * line.qy) * crossing.perSpeed;
    const Lanes w = line.w0 + at * line.w;
    const Lanes isOnRay =
        isPositive(border.alongX * (line.qx + at * line.mx) + border.alongY * (line.qy + at * line.my)) * isPositive(w);
    const Lanes change = crossing.change * isOnRay;
    const Lanes grown = at - crossing.growth;
    Lanes before;
    if (((grown.abs() - farFromCrossing) * change.abs()).minCoeff() >= 0.f) {
      before = isPositive(grown);
    }
    else {
      before = cumulativeOf(grown);
    }
    const auto beyond = [&before](const Chord &chord) -> Lanes {
      return chord.after - before.max(chord.before).min(chord.after);
    };
    black += change * (beyond(outer) - beyond(inner));
  }
  return black + code * (outer.after - outer.before - inner.after + inner.before);
}

Lanes LineModel::darkness(const PixelBlock &block, PixelSight sight) const
{
  PlaneLanes p;
  m_homography.apply(block.place, p);
  // Direction of the lines: at right angles to the circle through the pixel; with sectors, half-way between that and
  // the right angle to the radius through it.
  const Lanes perGradient = p.gradient.inverse();
  Lanes u = p.gradientU * perGradient;
  Lanes v = p.gradientV * perGradient;
  const bool hasTrack = sight != PixelSight::RING && m_borderCount > 0;
  const bool isAslant = hasTrack || bendAt(p) > sharpBend * m_ring[0];
  if (isAslant) {
    const Lanes bu = p.qyByU * p.outX - p.qxByU * p.outY;
    const Lanes bv = p.qyByV * p.outX - p.qxByV * p.outY;
    const Lanes perLength = (bu * bu + bv * bv).rsqrt();
    const Lanes side = 2.f * isPositive(bu * u + bv * v) - 1.f;
    u += side * perLength * bu;
    v += side * perLength * bv;
    const Lanes perSum = (u * u + v * v).rsqrt();
    u *= perSum;
    v *= perSum;
  }
  Line line;
  line.rimGrowth = m_perSigma * m_spread * perGradient / ((p.gradientU * u + p.gradientV * v) * perGradient);
  const float sigma = 1.f / m_perSigma;
  const DirectionLanes along = m_homography.along(block.place, sigma * u, sigma * v);
  const DirectionLanes across = m_homography.along(block.place, -sigma * v, sigma * u);
  line.mx = along.x;
  line.my = along.y;
  line.w = along.w;
  Crossings crossings;
  if (hasTrack) {
    crossBorders(p, u, v, line, crossings);
  }
  Lanes black = Lanes::Zero();
  const auto sumOver = [&](const auto &nodes) {
    for (const Node &node : nodes) {
      line.qx = p.qx + node.place * across.x;
      line.qy = p.qy + node.place * across.y;
      line.w0 = 1.f + node.place * across.w;
      Lanes part = Lanes::Zero();
      if (sight != PixelSight::TRACK) {
        part += ringAlong(line);
      }
      if (hasTrack) {
        part += trackAlong(line, crossings);
      }
      black += node.weight * part;
    }
  };
  if (isAslant) {
    sumOver(aslantNodes);
  }
  else {
    sumOver(ringNodes);
  }
  return black;
}

// Of a circle of radius 1, the largest among the pixels. The curvature of a circle about the centre is h^2 / (r g),
// with the gradient g of the radius r and the derivative h of the place on the plane along both circles.
float LineModel::bendAt(const PlaneLanes &p) const
{
  const Lanes hu = p.qyByU * p.outX - p.qxByU * p.outY;
  const Lanes hv = p.qyByV * p.outX - p.qxByV * p.outY;
  const Lanes h = (hv * p.gradientU - hu * p.gradientV) / p.gradient;
  return 0.5f / m_perSigma * (h * h / p.gradient).maxCoeff();
}

bool LineModel::isBent(const PixelBlock &block, PixelSight sight) const
{
  PlaneLanes p;
  m_homography.apply(block.place, p);
  const Lanes squaredWidth = p.qxByU * p.qxByU + p.qxByV * p.qxByV + p.qyByU * p.qyByU + p.qyByV * p.qyByV;
  if (squaredWidth.maxCoeff() > m_perSigma * m_perSigma / (leastSemiMinor * leastSemiMinor)) {
    return true;
  }
  const float bend = bendAt(p);
  const auto isSeenAcross = [&](float radius) {
    return ((p.radius + radius) / p.gradient).minCoeff() * m_perSigma < seenAcross;
  };
  const float ring = m_ring[1] > 0.f ? m_ring[1] : m_ring[0];
  if (sight != PixelSight::TRACK && (bend > strongBendOfRing * ring || isSeenAcross(ring))) {
    return true;
  }
  return sight != PixelSight::RING &&
         (bend > strongBendOfTrack * m_track[1] || isSeenAcross(m_track[1]) || hasManyBorders(p));
}

// Whether more borders between sectors are seen than a block has.
bool LineModel::hasManyBorders(const PlaneLanes &p) const
{
  const Lanes hu = p.qyByU * p.outX - p.qxByU * p.outY;
  const Lanes hv = p.qyByV * p.outX - p.qxByV * p.outY;
  const Lanes spacing = m_sectorAngle * m_perSigma * p.radius * (hu * hu + hv * hv).rsqrt();
  return m_borderCount > 0 && spacing.minCoeff() < leastSpacing;
}

bool correctBends(const MarkerPlane &plane, const MarkerPattern &pattern, const BlurParameters &blur,
                  PixelBlocks &blocks)
{
  const LineModel exact(plane, pattern, blur, blocks.reference);
  const ImageModel parabolas(plane, pattern, blur, blocks);
  bool isAnyBent = false;
  for (std::size_t kind = 0; kind < pixelSights; ++kind) {
    const auto sight = static_cast<PixelSight>(kind);
    for (PixelBlock &block : blocks.bySight[kind]) {
      block.correction.setZero();
      if (exact.isBent(block, sight)) {
        Lanes darkness;
        parabolas.evaluate(block, sight, darkness);
        block.correction = exact.darkness(block, sight) - darkness;
        isAnyBent = true;
      }
    }
  }
  return isAnyBent;
}
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE
