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
 * Markers that are printed otherwise than by default, and rivals of another kind.
 */

#include <algorithm>
#include <sstream>

#include "design.h"
#include "method.h"
#include "poses.h"

namespace experiments {
namespace {
/*! A word with as many ones as zeros, but for one: those of codes are like that on average. */
std::uint32_t wordFrom(unsigned int sectors, std::uint64_t frameSeed)
{
  std::uint64_t seed = seedOf(Draw::CodedId, frameSeed);
  std::uint32_t word = 0;
  for (unsigned int ones = 0; ones < (sectors + 1) / 2;) {
    seed = seedOf(Draw::CodedId, seed);
    const std::uint32_t bit = 1u << (seed >> 32) % sectors;
    ones += (word & bit) == 0 ? 1 : 0;
    word |= bit;
  }
  return word;
}

bool isTag(const Design &design)
{
  return !design.composition && design.family == "36h11";
}
} // namespace

std::string nameOf(const Design &design)
{
  std::ostringstream name;
  name << design.family << ' ' << design.layout.ringInner << ' ' << design.layout.codeOuter << ' '
       << design.layout.codeInner << ' ' << design.layout.quietZone;
  if (design.composition) {
    for (const auto &ring : design.composition->rings) {
      name << ' ' << ring[0] << ' ' << ring[1];
    }
    name << ' ' << design.composition->track[0] << ' ' << design.composition->track[1] << ' '
         << design.composition->sectors << ' ' << design.composition->isWindows;
  }
  return name.str();
}

double sizeOf(const Design &design, const Settings &settings)
{
  // The white border of a tag is one of its ten cells on either side.
  return isTag(design) ? tagOnSheet(settings.sheetSide()) : settings.sheetSide() / (1. + design.layout.quietZone);
}

int idOf(const Design &design, std::uint64_t frameSeed)
{
  if (isTag(design)) {
    return static_cast<int>(seedOf(Draw::TagId, frameSeed) % tagIds);
  }
  const unsigned int ids = design.composition ? 0 : vpCircleMarkerFamily::fromName(design.family).getNbIds();
  return ids == 0 ? -1 : static_cast<int>(seedOf(Draw::CodedId, frameSeed) % ids);
}

vpSimulatedMarker markerOf(const Design &design, const Settings &settings, std::uint64_t frameSeed)
{
  const double size = sizeOf(design, settings);
  if (design.composition) {
    const Composition &parts = *design.composition;
    vpSimulatedMarker marker = vpSimulatedMarker::rings(parts.rings, size);
    if (parts.sectors > 0) {
      marker.setTrack(parts.track[0], parts.track[1], parts.sectors, wordFrom(parts.sectors, frameSeed),
                      parts.isWindows);
    }
    return marker;
  }
  const int id = idOf(design, frameSeed);
  if (isTag(design)) {
    return vpSimulatedMarker::aprilTag36h11(id, size);
  }
  if (id < 0) {
    return vpSimulatedMarker::ring(size, design.layout.ringInner);
  }
  vpSimulatedMarker marker = vpSimulatedMarker::circle(design.family, id, size);
  return marker.setLayout(design.layout.ringInner, design.layout.codeInner, design.layout.codeOuter);
}

unsigned int codeDistanceOf(const Design &design)
{
  constexpr unsigned int tagDistance = 11; // Of 36h11: its name says so.
  if (design.composition) {
    return design.composition->distance;
  }
  return isTag(design) ? tagDistance : vpCircleMarkerFamily::fromName(design.family).getMinimumDistance();
}

Wanted wantedOf(const Design &design, const Settings &settings)
{
  const double size = sizeOf(design, settings);
  if (design.composition) {
    const auto &rings = design.composition->rings;
    const auto widest = std::max_element(rings.begin(), rings.end(),
                                         [](const auto &a, const auto &b) { return a[1] - a[0] < b[1] - b[0]; });
    const double ratio = (*widest)[0] / (*widest)[1];
    return {ratio > 0. ? vpCircleMarkerFamily::ring(ratio) : vpCircleMarkerFamily::fromName("disc"),
            size * (*widest)[1]};
  }
  const auto family = vpCircleMarkerFamily::fromName(design.family);
  return {family.isCoded() ? family.withLayout(design.layout) : vpCircleMarkerFamily::ring(design.layout.ringInner),
          size};
}
} // namespace experiments
