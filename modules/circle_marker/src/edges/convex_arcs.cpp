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
 * Convex arcs cut from chains of edge points.
 */

#include "edges/convex_arcs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Chords over which the bend is measured, points. Two chords of 5 pixels with points good to 0.1 pixel give an angle
// good to 0.03 rad.
constexpr std::size_t chord = 5;
// A bend the wrong way of more than this ends an arc: five times the angle's noise.
constexpr double concaveTangent = -0.151; // of -0.15 rad
// A sharper bend than this is a corner: an arc of radius 5 pixels bends by 1 rad.
constexpr double cornerTangent = 1.965; // of 1.1 rad
// A blunter corner bends by this at least, rad: ten times the angle's noise; and by so many times the mean of its arc.
constexpr double leastCorner = 0.3;
constexpr double cornerOfMean = 3.;
// Points on either side of a corner whose edge is rounded by it.
constexpr std::size_t roundedPoints = 3;
// Shorter arcs do not fix an ellipse.
constexpr std::size_t fewestPoints = 16;
// Pixels between two gradients whose turn is told: a ring of radius 5 turns by a radian in between.
constexpr std::size_t turnStride = 5;
// How much more an arc may turn than the gradients at its ends tell, rad: the direction of a gradient that just
// prolongs a chain is good to a quarter.
constexpr double noiseOfTurn = 0.3;

// Angle of a tangent, rad, to half a percent: an arc tangent takes longer than all else that is done with a point.
double roughAngle(double tangent)
{
  constexpr double fit = 0.28;
  const double squared = tangent * tangent;
  return squared <= 1. ? tangent / (1. + fit * squared) : std::copysign(M_PI_2, tangent) - tangent / (squared + fit);
}

// Tangent of the bend at a point; nothing if it is a right angle or more, to either side.
std::optional<double> bendAt(const std::vector<EdgePoint> &points, std::size_t i)
{
  const Eigen::Vector2d before = points[i].position - points[i - chord].position;
  const Eigen::Vector2d after = points[i + chord].position - points[i].position;
  const double along = before.dot(after);
  if (along <= 0.) {
    return std::nullopt;
  }
  return (before.x() * after.y() - before.y() * after.x()) / along;
}

// What a run of points bends in all, rad.
double turnOf(const std::vector<EdgePoint> &points, std::size_t begin, std::size_t end)
{
  double turn = 0.;
  for (std::size_t i = begin + chord; i + chord < end; ++i) {
    turn += roughAngle(bendAt(points, i).value_or(0.)) / static_cast<double>(chord);
  }
  return turn;
}
} // namespace

double mostTurn(const Gradient &gradient, const EdgeChains &chains, const EdgeChain &chain)
{
  const auto at = [&](std::size_t i) { return gradient.at(chains.pixels[i].x, chains.pixels[i].y); };
  double most = 0.;
  double turn = 0.; // of the run of pixels up to here that turns most
  GradientVector before = at(chain.begin);
  for (std::size_t i = chain.begin + turnStride; most < leastArcTurn; i += turnStride) {
    const GradientVector here = at(std::min(i, chain.end - 1));
    const int cross = before.dx * here.dy - before.dy * here.dx;
    const int dot = before.dx * here.dx + before.dy * here.dy;
    if (dot > 0) {
      turn = std::max(0., turn + roughAngle(static_cast<double>(cross) / dot));
    }
    else {
      turn = cross > 0 ? turn + M_PI : 0.; // no arc goes on beyond a sharp turn the wrong way
    }
    most = std::max(most, turn + noiseOfTurn);
    if (i + 1 >= chain.end) {
      break;
    }
    before = here;
  }
  return most;
}

void cutConvexArcs(const std::vector<EdgePoint> &points, double leastTurn, std::vector<ConvexArc> &arcs,
                   const Deadline &deadline)
{
  arcs.clear();
  const std::size_t n = points.size();
  if (n < fewestPoints) {
    return;
  }
  std::size_t begin = 0;
  double turn = 0.;
  const auto endArc = [&](std::size_t end) {
    if (end >= begin + fewestPoints && turn >= leastTurn) {
      arcs.push_back({begin, end, turn});
    }
  };
  constexpr std::size_t pointsAtOnce = 4096; // between two looks at the clock: 0.2 ms
  for (std::size_t i = chord; i + chord < n; ++i) {
    if (i % pointsAtOnce == 0 && deadline.hasPassed()) {
      return;
    }
    const std::optional<double> bend = bendAt(points, i);
    if (!bend || *bend < concaveTangent || *bend > cornerTangent) {
      endArc(i);
      begin = i + 1;
      turn = 0.;
      continue;
    }
    turn += roughAngle(*bend) / static_cast<double>(chord); // each bend is seen by as many overlapping pairs of chords
  }
  endArc(n);
}

bool cutAtCorner(const std::vector<EdgePoint> &points, const ConvexArc &arc, double leastTurn,
                 std::vector<ConvexArc> &arcs)
{
  double sharpest = 0.;
  std::size_t corner = arc.begin;
  for (std::size_t i = arc.begin + chord; i + chord < arc.end; ++i) {
    const double bend = bendAt(points, i).value_or(0.);
    if (bend > sharpest) {
      sharpest = bend;
      corner = i;
    }
  }
  const double mean = arc.turn * static_cast<double>(chord) / static_cast<double>(arc.length());
  if (roughAngle(sharpest) < std::max(leastCorner, cornerOfMean * mean)) {
    return false;
  }
  const std::array<std::pair<std::size_t, std::size_t>, 2> sides = {
      {{arc.begin, corner - roundedPoints}, {corner + 1 + roundedPoints, arc.end}}};
  for (const auto &[begin, end] : sides) {
    if (end < begin + fewestPoints) {
      continue;
    }
    const double turn = turnOf(points, begin, end);
    if (turn >= leastTurn) {
      arcs.push_back({begin, end, turn});
    }
  }
  return true;
}
} // namespace circle_marker
END_VISP_NAMESPACE
