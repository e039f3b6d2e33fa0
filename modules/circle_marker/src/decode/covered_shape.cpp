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
 * What is seen of a plain ring that something covers in part.
 */

#include "decode/covered_shape.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "decode/marker_light.h"
#include "decode/usual_ink.h"
#include "support/bilinear.h"
#include "support/normal_distribution.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Directions that are looked at: of a ring of 40 pixels one for every second pixel around.
constexpr unsigned int directions = 64;
// Share of the ring that must be seen.
constexpr double leastRing = 0.5;
// A direction shows the ring if its step is this share of the usual one, on either side.
constexpr double leastStep = 0.6;
// Where the white inside is read, of the ring's inner radius: past most of the blur of its edge, where a marker of the
// usual print has its code.
constexpr double besideRing = 0.75;
// And nearer to the centre, where that print is white again.
constexpr double towardCenter = 0.4;
// What covers the inside of a ring may leave its edge and its centre, or the white that follows it. Of the sectors of a
// code, where it is so, a fifth and more are black: share of the directions that show the edge.
constexpr double mostLikeSectors = 0.18;
// In a wider blur, outer radii, the print's centre is not white any more where it is looked at.
constexpr double leastTold = 0.08;
// Where the white between ring and code is read, of the ring's inner radius: in its middle, in the usual print.
constexpr double insideRing = 0.925;
// And the widest blur that leaves enough of it between two blacks, outer radii.
constexpr double mostGap = 0.06;
// So many runs of black behind such white are sectors: what lies in a plain ring without touching it is one or two.
constexpr unsigned int leastSectors = 3;

/*! Radii at which each direction is looked at, from the outside. */
enum Place : std::size_t
{
  OUTSIDE,
  RING,
  GAP,
  INSIDE,
  CENTER
};
constexpr std::size_t places = 5;

/*! One direction from the marker's centre. */
struct Direction
{
  bool isInImage = false;
  std::array<double, places> grey;  // levels
  std::array<double, places> paper; // share that the blur leaves there
  double blur = 0.;                 // outer radii
  double ink = 0.;                  // share of the light that it takes by the outer step
};

Eigen::Vector2d onCircle(double radius, unsigned int direction)
{
  const double angle = 2. * M_PI * (direction + 0.5) / directions;
  return radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
}

Direction lookAt(const vpImage<unsigned char> &I, const CameraModel &camera, const MarkerPlane &plane,
                 const std::array<double, places> &radii, double ringInner, unsigned int i)
{
  Direction direction;
  std::array<Eigen::Vector2d, places> pixels;
  for (std::size_t k = 0; k < places; ++k) {
    pixels[k] = camera.toPixel(plane.project(onCircle(radii[k], i)));
    const auto grey = bilinear(I, pixels[k]);
    if (!grey) {
      return direction;
    }
    direction.grey[k] = *grey;
  }
  direction.isInImage = true;
  const NormalDistribution &normal = NormalDistribution::instance();
  direction.blur = trackBlur * (radii[OUTSIDE] - radii[INSIDE]) / (pixels[OUTSIDE] - pixels[INSIDE]).norm();
  for (std::size_t k = 0; k < places; ++k) {
    direction.paper[k] = 1. - normal.at((1. - radii[k]) / direction.blur).cumulative +
                         normal.at((ringInner - radii[k]) / direction.blur).cumulative;
  }
  return direction;
}

// The share of the light that the ring takes, in units of what is left of the step to a place through the blur.
double inkBeside(const Direction &direction, Place place)
{
  const double step = std::max(direction.paper[place] - direction.paper[RING], leastExpected);
  return (1. - direction.grey[RING] / std::max(direction.grey[place], 1.)) / step;
}

// The ink on which enough directions agree; nothing if too few do.
std::optional<double> inkOf(const std::array<Direction, directions> &all)
{
  std::array<double, directions> inks;
  std::size_t count = 0;
  for (const Direction &direction : all) {
    if (direction.isInImage && direction.ink >= leastInk) {
      inks[count++] = direction.ink;
    }
  }
  const UsualInk usual = usualInk(inks.data(), count);
  return static_cast<double>(usual.agreeing) >= leastRing * directions ? std::make_optional(usual.ink) : std::nullopt;
}

/*! What a direction has inside of the white that follows the ring. */
enum class Behind
{
  UNKNOWN,
  WHITE,
  BLACK
};

// How often black begins around, past what is not known.
unsigned int runsOfBlack(const std::array<Behind, directions> &all)
{
  unsigned int runs = 0;
  Behind last = Behind::UNKNOWN;
  for (unsigned int i = 0; i < 2 * directions; ++i) { // the first turn tells what comes before the second
    const Behind here = all[i % directions];
    if (here != Behind::UNKNOWN) {
      runs += i >= directions && here == Behind::BLACK && last == Behind::WHITE ? 1 : 0;
      last = here;
    }
  }
  return runs;
}
} // namespace

std::optional<SeenParts> seenPartsOfRing(const vpImage<unsigned char> &I, const CameraModel &camera,
                                         const MarkerPlane &plane, const vpCircleMarkerLayout &layout)
{
  const double inner = layout.ringInner;
  const std::array<double, places> radii = {{radiusOfWhite(layout.quietZone), 0.5 * (1. + inner), insideRing * inner,
                                             besideRing * inner, towardCenter * inner}};
  std::array<Direction, directions> all;
  for (unsigned int i = 0; i < directions; ++i) {
    all[i] = lookAt(I, camera, plane, radii, inner, i);
    all[i].ink = all[i].isInImage ? inkBeside(all[i], OUTSIDE) : 0.;
  }
  const auto ink = inkOf(all);
  if (!ink) {
    return std::nullopt;
  }
  SeenParts seen;
  seen.plane = plane;
  seen.directions = directions;
  seen.gap = radii[CENTER]; // the white inside belongs to the ring up to there
  seen.core = 0.;
  std::size_t edges = 0;
  std::size_t likeSectors = 0;
  std::array<Behind, directions> behind{};
  for (unsigned int i = 0; i < directions; ++i) {
    const Direction &direction = all[i];
    const auto isUsual = [&](double here) { return here > leastStep * *ink && here < *ink / leastStep; };
    if (direction.isInImage && isUsual(direction.ink)) {
      ++edges;
      seen.ring[i] = isUsual(inkBeside(direction, INSIDE));
      const bool isLikeSector = direction.blur > leastTold || isUsual(inkBeside(direction, CENTER));
      likeSectors += !seen.ring[i] && isLikeSector ? 1 : 0;
      if (direction.blur < mostGap && isUsual(inkBeside(direction, GAP))) {
        behind[i] = seen.ring[i] ? Behind::WHITE : Behind::BLACK;
      }
    }
  }
  const auto behindGap = static_cast<std::size_t>(std::count(behind.begin(), behind.end(), Behind::BLACK));
  const double mostCovered = mostLikeSectors * static_cast<double>(edges);
  const bool hasCode = static_cast<double>(likeSectors) > mostCovered ||
                       (static_cast<double>(behindGap) > mostCovered && runsOfBlack(behind) >= leastSectors);
  if (hasCode || static_cast<double>(seen.ring.count()) < leastRing * directions) {
    return std::nullopt;
  }
  // Between a direction that is seen and one that is not lies the edge of what covers it.
  const std::bitset<mostSamples> ring = seen.ring;
  for (unsigned int i = 0; i < directions; ++i) {
    seen.ring[i] = ring[i] && ring[(i + 1) % directions] && ring[(i + directions - 1) % directions];
  }
  return seen;
}
} // namespace circle_marker
END_VISP_NAMESPACE
