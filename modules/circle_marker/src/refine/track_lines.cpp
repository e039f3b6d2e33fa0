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
 * What a pixel sees of the ring and of each sector of a code, where they are small or bend sharply.
 */

#include "refine/track_lines.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Geometry>

#include "refine/bend_limits.h"
#include "support/normal_distribution.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
constexpr double fullTurn = 2. * M_PI;

// Lines across the blur, by the trapezoidal rule: half of the steps to either side, 0.6 standard deviations each, and
// what the normal distribution has there. The 0.3 % that they leave is little beside the model error that the
// codewords' likelihood reckons with (code_image.cpp).
constexpr int lines = 12;
constexpr double step = 0.6;
// The blur's end, standard deviations.
constexpr double end = 4.5;
// Of a line, less is not worth a look.
constexpr double leastShare = 1e-5;

// Where a line crosses a circle.
struct Chord
{
  double first, second; // standard deviations
};

// A line in the plane.
struct PlaneLine
{
  Eigen::Vector2d from, along;

  Eigen::Vector2d at(double s) const { return from + s * along; }

  std::optional<Chord> chordOf(double radius) const
  {
    const double a = along.squaredNorm();
    const double b = from.dot(along);
    const double discriminant = b * b - a * (from.squaredNorm() - radius * radius);
    if (!(discriminant > 0.) || a == 0.) {
      return std::nullopt;
    }
    const double half = std::sqrt(discriminant);
    return Chord{(-b - half) / a, (-b + half) / a};
  }
};

double cumulative(double s)
{
  return NormalDistribution::instance().at(s).cumulative;
}

double shareOf(const std::optional<Chord> &chord)
{
  return chord ? cumulative(chord->second) - cumulative(chord->first) : 0.;
}

void addPiece(const PlaneLine &line, double first, double last, double weight, std::vector<TrackPiece> &pieces)
{
  first = std::max(first, -end);
  last = std::min(last, end);
  if (first >= last) {
    return;
  }
  const double before = cumulative(first);
  const double after = cumulative(last);
  if (after - before < leastShare) {
    return;
  }
  const Eigen::Vector2d p = line.at(first);
  const Eigen::Vector2d q = line.at(last);
  const double turn = std::atan2(p.x() * q.y() - p.y() * q.x(), p.dot(q));
  pieces.push_back({line.from, line.along, before, after, std::atan2(p.y(), p.x()), turn, weight});
}

// Derivatives of the radius and of the place along the circle, by the blur.
struct Slopes
{
  explicit Slopes(const PlanePoint &point)
  {
    const double r = point.q.norm();
    const Eigen::Vector2d out = r > 0. ? Eigen::Vector2d(point.q / r) : Eigen::Vector2d::UnitX();
    outward = point.byPixel.transpose() * out;
    along = point.byPixel.transpose() * Eigen::Vector2d(-out.y(), out.x());
  }

  Eigen::Vector2d outward, along;
};
} // namespace

bool wantsLines(const PlanePoint &point, const vpCircleMarkerLayout &layout, int sectors)
{
  if (point.byPixel.norm() * bend_limits::leastSemiMinor > 1.) {
    return true;
  }
  const Slopes slopes(point);
  const double r = point.q.norm();
  const double g = slopes.outward.norm();
  // What changes the place on the circle without a change of the radius.
  const double h = (slopes.along.x() * slopes.outward.y() - slopes.along.y() * slopes.outward.x()) / g;
  return 0.5 * h * h / g > bend_limits::strongOfTrack * layout.codeInner ||
         r + layout.codeInner < bend_limits::seenAcross * g ||
         fullTurn / sectors * r < bend_limits::leastSpacing * slopes.along.norm();
}

double cutLines(const PlanePoint &point, const vpCircleMarkerLayout &layout, std::vector<TrackPiece> &pieces)
{
  // Lines half-way between the right angles to the circle and to the radius through the pixel: they cross both.
  const Slopes slopes(point);
  const Eigen::Vector2d outward = slopes.outward.normalized();
  const Eigen::Vector2d along = slopes.along.normalized();
  const Eigen::Vector2d direction = (outward + (outward.dot(along) < 0. ? -1. : 1.) * along).normalized();
  const Eigen::Vector2d across(-direction.y(), direction.x());
  PlaneLine line;
  line.along = point.byPixel * direction;
  double ring = 0.;
  for (int k = 0; k < lines; ++k) {
    const double place = step * (k - 0.5 * (lines - 1));
    const double weight = step * std::exp(-0.5 * place * place) / std::sqrt(fullTurn);
    line.from = point.q + place * (point.byPixel * across);
    ring += weight * (shareOf(line.chordOf(1.)) - shareOf(line.chordOf(layout.ringInner)));
    const auto outer = line.chordOf(layout.codeOuter);
    if (!outer) {
      continue;
    }
    const auto inner = line.chordOf(layout.codeInner);
    addPiece(line, outer->first, inner ? inner->first : outer->second, weight, pieces);
    if (inner) {
      addPiece(line, inner->second, outer->second, weight, pieces);
    }
  }
  return ring;
}

void addSectors(const TrackPiece &piece, const SectorBorders &borders, SectorVector &shares)
{
  const int sense = piece.turn < 0. ? -1 : 1;
  const double first = borders.place(piece.angle);
  const double last = first + borders.inSectors(piece.turn);
  int sector = static_cast<int>(std::floor(first));
  double before = piece.before;
  const auto add = [&](double until) {
    shares[borders.sector(sector)] += piece.weight * (until - before);
    before = until;
  };
  while (sense > 0 ? sector + 1 < last : sector > last) {
    const Eigen::Vector2d &normal = borders.across(sense > 0 ? sector + 1 : sector);
    const double crossing = -normal.dot(piece.from) / normal.dot(piece.along);
    add(std::clamp(cumulative(crossing), before, piece.after));
    sector += sense;
  }
  add(piece.after);
}
} // namespace circle_marker
END_VISP_NAMESPACE
