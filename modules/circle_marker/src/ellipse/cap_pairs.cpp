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
 * The two ends of one narrow thing.
 */

#include "ellipse/cap_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// A narrow thing from tip to tip, pixels: of a shorter marker no code is left.
constexpr double shortestNarrow = 10.;
// Cosine of the angle between the axis of an end and the way from the other one's tip, 32 degrees: of a cap of few
// pixels the axis is that wrong.
constexpr double leastAlong = 0.85;
// Pixels of both ends, by the distance of their tips: along either side of what is narrow lies one for each of its
// length, or 0.7 along a diagonal, so that this is 50 to 70 % of the outline. What has less is seldom one thing.
constexpr double leastPixels = 1.;
// The sides of an end lie so far from that line: 0.21 of the length are those of an ellipse with 0.42 of it as its
// width, and a pixel and a half is what a tip may be off. Nearer than half a pixel there is nothing between them.
constexpr double mostBeside = 0.21;
constexpr double mostOff = 1.5;
constexpr double leastBeside = 0.5;
// Caps whose outlooks are compared with that of one in a row.
constexpr std::size_t capsAtOnce = 64;

// The number of the band of rows, as high as the longest narrow thing, that a cap lies in.
double bandOf(const EdgeCap &cap)
{
  return std::floor(cap.tip.y() / longestNarrow);
}

// outward: unit vector from the other tip.
bool areSidesBeside(const CapSides &sides, const EdgeCap &cap, const Eigen::Vector2d &outward, double length)
{
  // A chain goes around what is dark clockwise as the image is seen.
  const double sign = cap.isDark ? 1. : -1.;
  const auto beside = [&](const Eigen::Vector2d &side) {
    const Eigen::Vector2d from = side - cap.tip;
    return sign * (outward.x() * from.y() - outward.y() * from.x());
  };
  const double most = mostBeside * length + mostOff;
  const double after = beside(sides.after);
  const double before = -beside(sides.before);
  return after >= leastBeside && after <= most && before >= leastBeside && before <= most;
}
} // namespace

bool lookApart(const CapOutlook &one, const CapOutlook &other)
{
  const Eigen::Vector2d along = one.tip - other.tip;
  const double squared = along.squaredNorm();
  const double out = along.dot(one.axis);
  const double otherOut = -along.dot(other.axis);
  const double least = leastAlong * leastAlong * squared;
  // All at once: which of these refuses a pair cannot be foreseen.
  const int isSame = static_cast<int>(one.isDark == other.isDark);
  const int looksAway = static_cast<int>(out > 0.) & static_cast<int>(otherOut > 0.);
  const int isAlong = static_cast<int>(out * out >= least) & static_cast<int>(otherOut * otherOut >= least);
  const int isLong = static_cast<int>(squared >= shortestNarrow * shortestNarrow) &
                     static_cast<int>(squared <= longestNarrow * longestNarrow);
  return (isSame & looksAway & isAlong & isLong) != 0;
}

void CapOutlooks::clear()
{
  for (std::vector<double> *numbers : {&m_tipU, &m_tipV, &m_axisU, &m_axisV, &m_side}) {
    numbers->clear();
  }
}

void CapOutlooks::add(const EdgeCap &cap)
{
  m_tipU.push_back(cap.tip.x());
  m_tipV.push_back(cap.tip.y());
  m_axisU.push_back(cap.axis.x());
  m_axisV.push_back(cap.axis.y());
  m_side.push_back(cap.isDark ? 1. : -1.);
}

void CapOutlooks::findApart(std::size_t one, std::size_t begin, std::size_t end, std::vector<std::size_t> &apart) const
{
  apart.clear();
  const double tipU = m_tipU[one];
  const double tipV = m_tipV[one];
  const double axisU = m_axisU[one];
  const double axisV = m_axisV[one];
  const double side = m_side[one];
  std::array<double, capsAtOnce> marks; // above 0 where a pair is to be looked at
  for (std::size_t first = begin; first < end; first += capsAtOnce) {
    const std::size_t count = std::min(capsAtOnce, end - first);
    const double *u = m_tipU.data() + first;
    const double *v = m_tipV.data() + first;
    const double *outU = m_axisU.data() + first;
    const double *outV = m_axisV.data() + first;
    const double *otherSide = m_side.data() + first;
    // Without a branch: compilers make vector instructions of it.
    for (std::size_t k = 0; k < count; ++k) {
      const double alongU = tipU - u[k];
      const double alongV = tipV - v[k];
      const double squared = alongU * alongU + alongV * alongV;
      const double out = alongU * axisU + alongV * axisV;
      const double otherOut = -(alongU * outU[k] + alongV * outV[k]);
      const double least = leastAlong * leastAlong * squared;
      const double nearest = out < otherOut ? out : otherOut; // both look away if the less does, and far enough
      double mark = nearest > 0. ? 1. : -1.;
      mark = nearest * nearest >= least ? mark : -1.;
      mark = side * otherSide[k] > 0. ? mark : -1.;
      mark = squared >= shortestNarrow * shortestNarrow ? mark : -1.;
      marks[k] = squared <= longestNarrow * longestNarrow ? mark : -1.;
    }
    for (std::size_t k = 0; k < count; ++k) {
      if (marks[k] > 0.) {
        apart.push_back(first + k);
      }
    }
  }
}

bool mayBeEnds(const EdgeChains &chains, const EdgeCap &one, const EdgeCap &other)
{
  if (!lookApart(CapOutlook(one), CapOutlook(other))) {
    return false;
  }
  const Eigen::Vector2d along = one.tip - other.tip;
  const double length = along.norm();
  const auto half = static_cast<std::size_t>(0.5 * length);
  std::size_t pixels = 0;
  for (const EdgeCap *cap : {&one, &other}) {
    pixels += std::min(cap->before, half) + std::min(cap->after, half);
  }
  return static_cast<double>(pixels) >= leastPixels * length &&
         areSidesBeside(sidesOf(chains, one, half), one, along / length, length) &&
         areSidesBeside(sidesOf(chains, other, half), other, -along / length, length);
}

void sortCaps(std::vector<const EdgeCap *> &caps)
{
  std::sort(caps.begin(), caps.end(), [](const EdgeCap *p, const EdgeCap *q) {
    return bandOf(*p) != bandOf(*q)   ? bandOf(*p) < bandOf(*q)
           : p->tip.x() != q->tip.x() ? p->tip.x() < q->tip.x()
           : p->tip.y() != q->tip.y() ? p->tip.y() < q->tip.y()
                                      : p->chain < q->chain;
  });
}

std::array<CapRange, 2> candidatesFor(const std::vector<const EdgeCap *> &caps, std::size_t i)
{
  const double left = caps[i]->tip.x() - longestNarrow;
  const double right = caps[i]->tip.x() + longestNarrow;
  const double band = bandOf(*caps[i]);
  // The first cap of a band, or of one after it, from here to the right.
  const auto firstOf = [&](double wanted, double from) {
    const auto found = std::partition_point(caps.begin(), caps.end(), [&](const EdgeCap *cap) {
      return bandOf(*cap) < wanted || (bandOf(*cap) == wanted && cap->tip.x() < from);
    });
    return static_cast<std::size_t>(found - caps.begin());
  };
  return {{{i + 1, firstOf(band, right)}, {firstOf(band + 1., left), firstOf(band + 1., right)}}};
}

void locateEnds(const Gradient &gradient, const EdgeChains &chains, const EdgeCap &one, const EdgeCap &other,
                std::vector<EdgePoint> &points)
{
  const auto half = static_cast<std::size_t>(0.5 * (one.tip - other.tip).norm());
  points.clear();
  locateCap(gradient, chains, one, half, points);
  locateCap(gradient, chains, other, half, points);
}
} // namespace circle_marker
END_VISP_NAMESPACE
