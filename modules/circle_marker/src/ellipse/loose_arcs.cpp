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
 * Arcs of one ellipse with something between them.
 */

#include "ellipse/loose_arcs.h"

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// The last points of an arc already feel the corner where it was cut: two are left out.
constexpr std::size_t spoiltPoints = 2;
// One marker's ink and paper are alike all around, but for light that falls off: the dark sides differ by no more than
// this share of the smaller step, and the steps by this factor.
constexpr double mostOtherDark = 0.4;
constexpr double mostOtherStep = 1.6;
// Two arcs of an ellipse that bend less than this together, rad, do not fix it.
constexpr double leastTurnTogether = 1.;
// By how much the directions that two arcs look to may overlap, rad: those of an edge near a corner are that wrong.
constexpr double mostOverlap = 0.25;
// How far beyond a tangent a point may be, pixels, and share of its distance, for the tangent's own error.
constexpr double mostBeyond = 1.;
constexpr double mostBeyondOfDistance = 0.12;

bool isAlike(const GreysBeside &one, const GreysBeside &other)
{
  const double step = one.bright - one.dark;
  const double otherStep = other.bright - other.dark;
  const double least = std::min(step, otherStep);
  return least > 0. && std::max(step, otherStep) < mostOtherStep * least &&
         std::abs(one.dark - other.dark) < mostOtherDark * least;
}

// Whether all of an arc lies inside of the tangents of another one.
bool isInside(const LooseArc &arc, const LooseArc &other)
{
  for (const EdgePoint &tangent : other.ends) {
    for (const EdgePoint &point : arc.ends) {
      const Eigen::Vector2d away = point.position - tangent.position;
      if (away.dot(tangent.across) > mostBeyond + mostBeyondOfDistance * away.norm()) {
        return false;
      }
    }
  }
  return true;
}

double directionOf(const EdgePoint &point)
{
  return std::atan2(point.across.y(), point.across.x());
}

// Whether the normals of two arcs have different directions: those of a convex curve go round once.
bool lookElsewhere(const LooseArc &one, const LooseArc &other)
{
  constexpr double round = 2. * M_PI;
  double ahead = directionOf(other.ends.front()) - directionOf(one.ends.front());
  ahead -= round * std::floor(ahead / round);
  return ahead > one.turn - mostOverlap && ahead + other.turn < round + mostOverlap;
}
} // namespace

void LooseArc::set(const vpImage<unsigned char> &I, std::size_t chainIndex, const EdgePoint *chainPoints,
                   std::size_t count, double bend)
{
  chain = chainIndex;
  points.assign(chainPoints + spoiltPoints, chainPoints + count - spoiltPoints);
  turn = bend;
  greys = greysBeside(I, points.data(), points.size());
  ends = {points.front(), points[points.size() / 2], points.back()};
  for (EdgePoint &end : ends) {
    end.across.normalize();
  }
}

bool mayBelongTogether(const LooseArc &one, const LooseArc &other)
{
  return one.turn + other.turn > leastTurnTogether && isAlike(one.greys, other.greys) && lookElsewhere(one, other) &&
         isInside(one, other) && isInside(other, one);
}
} // namespace circle_marker
END_VISP_NAMESPACE
