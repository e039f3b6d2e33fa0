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
 * The edge of a shadow on a marker, by what a fit without one leaves.
 */

#include "refine/shadow_split.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "refine/shadow.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Directions of the edge that are tried, and places along each: 8 degrees and a twentieth of a radius apart, from where
// a fit finds the rest of the way.
constexpr int directions = 24;
constexpr int places = 56;
constexpr double farthest = 1.4; // of the marker's size: the quiet zone ends before
// How well white and black are told apart on either side, as a share of how well by all pixels: by a tenth of them, as
// many white as black. Fewer may see one edge, and no more than that it is off.
constexpr double leastOnASide = 0.01;
// Light that is left in a shadow: in less no print is seen, and of more the light's gradient takes enough.
constexpr double leastFactor = 0.1;
constexpr double mostFactor = 0.85;
// The fit has a gradient and a gamma besides, which may have followed the shadow: what two strengths of light leave is
// at most this factor of what it leaves. (With 1.5 two or three percent fewer of small markers under a shadow are
// found.)
constexpr double mostLeft = 2.5;

// Sums over pixels of grey level I and share of black D, for the line I = white - step D that fits best.
struct Sums
{
  double n = 0.;
  double d = 0.;
  double dd = 0.;
  double i = 0.;
  double id = 0.;

  void add(const ExplainedPixel &pixel)
  {
    const double weight = pixel.weight;
    n += weight;
    d += weight * pixel.darkness;
    dd += weight * pixel.darkness * pixel.darkness;
    i += weight * pixel.grey;
    id += weight * pixel.grey * pixel.darkness;
  }
  void add(const Sums &other, double sign)
  {
    n += sign * other.n;
    d += sign * other.d;
    dd += sign * other.dd;
    i += sign * other.i;
    id += sign * other.id;
  }

  double determinant() const { return n * dd - d * d; }
  double white() const { return (dd * i - d * id) / determinant(); }
  double step() const { return (d * i - n * id) / determinant(); }
  // Of the sum of I^2.
  double explained() const { return white() * i - step() * id; }
};

struct Split
{
  double explained = 0.; // of the sum of I^2
  double direction = 0.; // rad
  double edge = 0.;
  double whiteBefore = 1.; // where the coordinate along the direction is less than the edge
  double whiteBehind = 1.;
};

// The best place for the edge in one direction.
void trySplits(const std::vector<ExplainedPixel> &pixels, double direction, Split &best)
{
  std::array<Sums, places> bins;
  const Eigen::Vector2f along(static_cast<float>(std::cos(direction)), static_cast<float>(std::sin(direction)));
  constexpr auto perPlace = static_cast<float>(places / (2. * farthest));
  for (const ExplainedPixel &pixel : pixels) {
    const float t = perPlace * (along.dot(pixel.offset) + static_cast<float>(farthest));
    bins[static_cast<std::size_t>(std::clamp(static_cast<int>(t), 0, places - 1))].add(pixel);
  }
  Sums all;
  for (const Sums &bin : bins) {
    all.add(bin, 1.);
  }
  const double least = leastOnASide * all.determinant();
  Sums before;
  Sums behind = all;
  for (int k = 0; k + 1 < places; ++k) {
    before.add(bins[static_cast<std::size_t>(k)], 1.);
    behind.add(bins[static_cast<std::size_t>(k)], -1.);
    const bool haveBoth = before.determinant() > least && behind.determinant() > least;
    if (!haveBoth || before.step() <= 0. || behind.step() <= 0.) {
      continue;
    }
    const double explained = before.explained() + behind.explained();
    if (explained > best.explained) {
      best = {explained, direction, (k + 1) / static_cast<double>(perPlace) - farthest, before.white(), behind.white()};
    }
  }
}
} // namespace

std::optional<Shadow> shadowBySplit(const std::vector<ExplainedPixel> &pixels, double frameSize)
{
  double leftByFit = 0.;
  double squares = 0.;
  for (const ExplainedPixel &pixel : pixels) {
    const double left = pixel.grey - pixel.fitted;
    leftByFit += pixel.weight * left * left;
    squares += static_cast<double>(pixel.weight) * pixel.grey * pixel.grey;
  }
  Split best;
  for (int k = 0; k < directions; ++k) {
    const double direction = M_PI * k / directions;
    trySplits(pixels, direction, best);
  }
  const double factor = std::min(best.whiteBefore, best.whiteBehind) / std::max(best.whiteBefore, best.whiteBehind);
  if (!(squares - best.explained < mostLeft * leftByFit && factor >= leastFactor && factor <= mostFactor)) {
    return std::nullopt;
  }
  const bool isDarkBehind = best.whiteBehind < best.whiteBefore;
  Shadow shadow;
  shadow.factor = factor;
  shadow.direction = isDarkBehind ? best.direction : best.direction + M_PI;
  shadow.edge = isDarkBehind ? best.edge : -best.edge;
  shadow.softness = softnessAtStart(frameSize);
  shadow.frameSize = frameSize;
  return shadow;
}
} // namespace circle_marker
END_VISP_NAMESPACE
