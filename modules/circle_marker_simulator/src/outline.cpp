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
 * Outlines of plane regions as unordered sets of directed segments.
 */

#include <algorithm>
#include <limits>
#include <utility>

#include "outline.h"

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

namespace {

Box boxOf(const Segment &s)
{
  return {std::min(s.from.x, s.to.x), std::min(s.from.y, s.to.y), std::max(s.from.x, s.to.x),
          std::max(s.from.y, s.to.y)};
}

bool overlap(const Box &a, const Box &b)
{
  return a.left <= b.right && b.left <= a.right && a.top <= b.bottom && b.top <= a.bottom;
}

double cross(double ax, double ay, double bx, double by)
{
  return ax * by - ay * bx;
}

// A cut of a segment: where along it, from 0 to 1, and the point, which is the same for both segments cut there.
struct Cut
{
  double at;
  PlanePoint point;
};

using Cuts = std::vector<std::vector<Cut>>;

// Crossings of the segments of two outlines. A segment's first end belongs to it and its last does not, so that a
// crossing at a corner counts once.
void findCuts(const Outline &a, const Outline &b, Cuts &cutsOfA, Cuts &cutsOfB)
{
  std::vector<Box> boxes(b.size());
  std::transform(b.begin(), b.end(), boxes.begin(), [](const Segment &s) { return boxOf(s); });
  const Box all = boundingBox(b);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Box box = boxOf(a[i]);
    if (!overlap(box, all)) {
      continue;
    }
    const double ax = a[i].to.x - a[i].from.x;
    const double ay = a[i].to.y - a[i].from.y;
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (!overlap(box, boxes[j])) {
        continue;
      }
      const double bx = b[j].to.x - b[j].from.x;
      const double by = b[j].to.y - b[j].from.y;
      const double determinant = cross(ax, ay, bx, by);
      if (determinant == 0.) {
        continue; // parallel
      }
      const double dx = b[j].from.x - a[i].from.x;
      const double dy = b[j].from.y - a[i].from.y;
      const double atA = cross(dx, dy, bx, by) / determinant;
      const double atB = cross(dx, dy, ax, ay) / determinant;
      if (atA >= 0. && atA < 1. && atB >= 0. && atB < 1.) {
        const PlanePoint point = {a[i].from.x + atA * ax, a[i].from.y + atA * ay};
        cutsOfA[i].push_back({atA, point});
        cutsOfB[j].push_back({atB, point});
      }
    }
  }
}

// Appends the pieces of an outline that are inside (or outside) of another one.
void appendPieces(const Outline &outline, Cuts &cuts, const Outline &other, bool inside, bool reversed, Outline &result)
{
  const Box box = boundingBox(other);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    std::vector<Cut> &here = cuts[i];
    std::sort(here.begin(), here.end(), [](const Cut &a, const Cut &b) { return a.at < b.at; });
    PlanePoint from = outline[i].from;
    for (std::size_t k = 0; k <= here.size(); ++k) {
      const PlanePoint to = k < here.size() ? here[k].point : outline[i].to;
      const PlanePoint middle = {0.5 * (from.x + to.x), 0.5 * (from.y + to.y)};
      const bool nearby =
          middle.x >= box.left && middle.x <= box.right && middle.y >= box.top && middle.y <= box.bottom;
      if ((nearby && isInside(other, middle)) == inside) {
        result.push_back(reversed ? Segment{to, from} : Segment{from, to});
      }
      from = to;
    }
  }
}

} // namespace

Box boundingBox(const Outline &outline)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Box all = {infinity, infinity, -infinity, -infinity};
  for (const Segment &segment : outline) {
    const Box box = boxOf(segment);
    all = {std::min(all.left, box.left), std::min(all.top, box.top), std::max(all.right, box.right),
           std::max(all.bottom, box.bottom)};
  }
  return all;
}

double area(const Outline &outline)
{
  double twice = 0.;
  for (const Segment &s : outline) {
    twice += cross(s.from.x, s.from.y, s.to.x, s.to.y);
  }
  return 0.5 * twice;
}

void reverse(Outline &outline)
{
  for (Segment &segment : outline) {
    std::swap(segment.from, segment.to);
  }
}

bool isInside(const Outline &outline, const PlanePoint &point)
{
  int winding = 0;
  for (const Segment &s : outline) {
    const bool fromAbove = s.from.y <= point.y;
    const bool toAbove = s.to.y <= point.y;
    if (fromAbove == toAbove) {
      continue; // the segment does not cross the point's row; half-open, so that a shared corner counts once
    }
    const double side = cross(s.to.x - s.from.x, s.to.y - s.from.y, point.x - s.from.x, point.y - s.from.y);
    if (fromAbove && side > 0.) {
      ++winding;
    }
    else if (toAbove && side < 0.) {
      --winding;
    }
  }
  return winding > 0;
}

Outline subtract(const Outline &region, const Outline &cover)
{
  if (region.empty() || cover.empty() || !overlap(boundingBox(region), boundingBox(cover))) {
    return region;
  }
  Cuts cutsOfRegion(region.size());
  Cuts cutsOfCover(cover.size());
  findCuts(region, cover, cutsOfRegion, cutsOfCover);
  Outline result;
  appendPieces(region, cutsOfRegion, cover, false, false, result);
  appendPieces(cover, cutsOfCover, region, true, true, result);
  return result;
}

Outline intersect(const Outline &region, const Outline &frame)
{
  if (region.empty() || frame.empty() || !overlap(boundingBox(region), boundingBox(frame))) {
    return {};
  }
  Cuts cutsOfRegion(region.size());
  Cuts cutsOfFrame(frame.size());
  findCuts(region, frame, cutsOfRegion, cutsOfFrame);
  Outline result;
  appendPieces(region, cutsOfRegion, frame, true, false, result);
  appendPieces(frame, cutsOfFrame, region, true, false, result);
  return result;
}

Outline outlineOf(const Box &box)
{
  const PlanePoint a = {box.left, box.top};
  const PlanePoint b = {box.right, box.top};
  const PlanePoint c = {box.right, box.bottom};
  const PlanePoint d = {box.left, box.bottom};
  return {{a, b}, {b, c}, {c, d}, {d, a}};
}

} // namespace marker_simulator
END_VISP_NAMESPACE
