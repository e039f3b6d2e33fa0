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
 * What is printed on a marker's sheet, as regions of the marker's plane.
 */

#include <cmath>
#include <utility>

#include "print.h"
#include "printed_grid.h"

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

namespace {

void appendCircle(double radius, bool hole, std::vector<PlaneCurve> &boundary)
{
  boundary.push_back(hole ? PlaneCurve::arc(radius, 2. * M_PI, 0.) : PlaneCurve::arc(radius, 0., 2. * M_PI));
}

PlanePoint polar(double radius, double angle)
{
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

// A run of black sectors between two angles; all of its edges lie `spread` further out.
void appendRun(double outer, double inner, double from, double to, double spread, std::vector<PlaneCurve> &boundary)
{
  const double outside = outer + spread;
  const double inside = inner - spread;
  // A line parallel to the radial edge, at the distance `spread`, cuts a circle at this angle from the edge.
  const double outsideTurn = std::asin(spread / outside);
  const double insideTurn = std::asin(spread / inside);
  boundary.push_back(PlaneCurve::arc(outside, from - outsideTurn, to + outsideTurn));
  boundary.push_back(PlaneCurve::line(polar(outside, to + outsideTurn), polar(inside, to + insideTurn)));
  boundary.push_back(PlaneCurve::arc(inside, to + insideTurn, from - insideTurn));
  boundary.push_back(PlaneCurve::line(polar(inside, from - insideTurn), polar(outside, from - outsideTurn)));
}

void appendCode(const vpSimulatedMarker &marker, double radius, std::vector<PlaneCurve> &boundary)
{
  const unsigned int n = marker.getNbSectors();
  const std::uint32_t word = *marker.getCodeword();
  const auto black = [&](unsigned int sector) { return (word >> (n - 1 - sector % n)) & 1; };
  const double step = 2. * M_PI / n;
  for (unsigned int first = 0; first < n; ++first) {
    if (!black(first) || black(first + n - 1)) {
      continue; // not the beginning of a run
    }
    unsigned int end = first + 1;
    while (black(end)) { // a codeword is never all black
      ++end;
    }
    std::vector<PlaneCurve> run;
    // Ink that spreads makes windows smaller.
    appendRun(marker.getTrackOuter() * radius, marker.getTrackInner() * radius, step * first, step * end,
              marker.hasWindows() ? -marker.getInkSpread() : marker.getInkSpread(), run);
    for (const PlaneCurve &curve : run) {
      boundary.push_back(marker.hasWindows() ? curve.reversed() : curve);
    }
  }
}

struct Projector
{
  const Paper &paper;
  const Lens &lens;

  PlanePoint operator()(const PlanePoint &p) const { return paper.project(p, lens); }
};

// Largest distance from chord to curve, in pixels. The triangle that stands for the piece of curve over the chord has
// the curve's area and stays within a third of this distance of it: 0.03 grey levels of a contrast of 200, of either
// sign, in pixels smaller than a chord, and next to nothing in larger ones.
constexpr double CHORD_ERROR = 4e-4;
// Below this distance a piece is a straight line, in pixels.
constexpr double STRAIGHT = 1e-9;
// Halvings of a part of a curve; the chord error falls by 4 each time, so that this is never reached in earnest.
constexpr int MOST_HALVINGS = 16;

double distanceToChord(const PlanePoint &p, const PlanePoint &from, const PlanePoint &to)
{
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  const double length = std::hypot(dx, dy);
  if (length < 1e-12) {
    return std::hypot(p.x - from.x, p.y - from.y);
  }
  return std::fabs(dx * (p.y - from.y) - dy * (p.x - from.x)) / length;
}

void appendChords(const PlaneCurve &curve, const Projector &projector, double t0, const PlanePoint &p0, double t1,
                  const PlanePoint &p1, int halvings, Outline &outline)
{
  const double t = 0.5 * (t0 + t1);
  const PlanePoint p = projector(curve.at(t));
  const double distance = distanceToChord(p, p0, p1);
  if (halvings == 0 || distance <= STRAIGHT) {
    outline.push_back({p0, p1});
    return;
  }
  if (distance <= CHORD_ERROR) {
    // A short curve is a parabola, two thirds of its height times the chord in area: a triangle 4/3 as high has as
    // much.
    const PlanePoint top = {(4. * p.x - 0.5 * (p0.x + p1.x)) / 3., (4. * p.y - 0.5 * (p0.y + p1.y)) / 3.};
    outline.push_back({p0, top});
    outline.push_back({top, p1});
    return;
  }
  appendChords(curve, projector, t0, p0, t, p, halvings - 1, outline);
  appendChords(curve, projector, t, p, t1, p1, halvings - 1, outline);
}

} // namespace

PlaneCurve PlaneCurve::line(const PlanePoint &from, const PlanePoint &to)
{
  PlaneCurve curve;
  curve.m_from = from;
  curve.m_to = to;
  return curve;
}

PlaneCurve PlaneCurve::arc(double radius, double fromAngle, double toAngle)
{
  PlaneCurve curve;
  curve.m_radius = radius;
  curve.m_fromAngle = fromAngle;
  curve.m_toAngle = toAngle;
  return curve;
}

PlanePoint PlaneCurve::at(double t) const
{
  if (!isLine()) {
    return polar(m_radius, (1. - t) * m_fromAngle + t * m_toAngle);
  }
  return {(1. - t) * m_from.x + t * m_to.x, (1. - t) * m_from.y + t * m_to.y};
}

PlaneCurve PlaneCurve::reversed() const
{
  PlaneCurve curve = *this;
  std::swap(curve.m_from, curve.m_to);
  std::swap(curve.m_fromAngle, curve.m_toAngle);
  return curve;
}

int PlaneCurve::parts() const
{
  // Arcs in parts of 22 degrees. A line is curved by distortion or a bent sheet alone; in 4 parts even an S, whose
  // middle lies on the chord, shows.
  return isLine() ? 4 : static_cast<int>(std::ceil(std::fabs(m_toAngle - m_fromAngle) / (M_PI / 8.)));
}

PrintedRegion sheetOf(const vpSimulatedMarker &marker)
{
  const double x = 0.5 * marker.getSheetWidth();
  const double y = 0.5 * marker.getSheetHeight();
  PrintedRegion sheet = {{}, 1.};
  for (const Segment &side : outlineOf({-x, -y, x, y})) {
    sheet.boundary.push_back(PlaneCurve::line(side.from, side.to));
  }
  return sheet;
}

std::vector<PrintedRegion> printOn(const vpSimulatedMarker &marker)
{
  if (!marker.isCircle()) {
    return printedGrid(marker);
  }
  const double radius = 0.5 * marker.getSize();
  PrintedRegion ink = {{}, 0.};
  std::vector<std::array<double, 2>> rings = marker.getRings();
  if (rings.empty()) {
    rings.push_back({marker.getRingRatio(), 1.});
  }
  for (const auto &[ratio, outer] : rings) {
    appendCircle(outer * radius + marker.getInkSpread(), false, ink.boundary);
    const double inner = ratio * radius - marker.getInkSpread();
    if (ratio > 0. && inner > 0.) {
      appendCircle(inner, true, ink.boundary);
    }
  }
  if (marker.getCodeword()) {
    appendCode(marker, radius, ink.boundary);
  }
  return {ink};
}

Outline project(const PrintedRegion &region, const Paper &paper, const Lens &lens)
{
  const Projector projector = {paper, lens};
  Outline outline;
  for (const PlaneCurve &curve : region.boundary) {
    const int parts = lens.keepsLines() && paper.isFlat() && curve.isLine() ? 1 : curve.parts();
    PlanePoint from = projector(curve.at(0.));
    for (int i = 1; i <= parts; ++i) {
      const double t = static_cast<double>(i) / parts;
      const PlanePoint to = projector(curve.at(t));
      appendChords(curve, projector, static_cast<double>(i - 1) / parts, from, t, to, MOST_HALVINGS, outline);
      from = to;
    }
  }
  return outline;
}

} // namespace marker_simulator
END_VISP_NAMESPACE
