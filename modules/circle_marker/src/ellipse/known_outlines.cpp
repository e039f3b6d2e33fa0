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
 * Outlines found so far, each of them once.
 */

#include "ellipse/known_outlines.h"

#include <algorithm>
#include <cmath>

#include "ellipse/outline_fitter.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Two ellipses are one outline if centres and axes agree to this share of the minor semi-axis (and a pixel).
constexpr double sameOutline = 0.1;
// Of one that was found by its edge and one that was found by its dark line, to this share (and this part of a pixel):
// on ground brighter than paper the edge found is that of the sheet where it is near, up to a tenth farther out.
constexpr double sameByLine = 0.03;
constexpr double pixelByLine = 0.75;

// Share of an arc's points that lie on an outline if it is known by that.
constexpr double shareHeld = 0.75;
// And if both are outlines of one edge: of a sheet that is bent, whose ring's image is no ellipse, 0.8 were seen.
constexpr double shareAlong = 0.5;

double slackOf(const EllipseParameters &ellipse)
{
  return 1. + sameOutline * ellipse.b;
}

bool isWithin(double slack, const EllipseParameters &p, const EllipseParameters &q)
{
  return std::abs(p.a - q.a) < slack && std::abs(p.b - q.b) < slack && (p.center - q.center).norm() < slack;
}
} // namespace

bool isSameOutline(const EllipseParameters &p, const EllipseParameters &q)
{
  return isWithin(slackOf(p.b < q.b ? p : q), p, q);
}

void KnownOutlines::reset(int width, int height)
{
  outlines.clear();
  m_centers.reset(width, height);
  m_points.reset(width, height);
  m_large.clear();
}

int KnownOutlines::find(const EllipseParameters &ellipse, bool isThin) const
{
  int same = -1;
  const auto isSame = [&](int number) {
    const EllipseCandidate &known = outlines[static_cast<std::size_t>(number)];
    const bool isOne =
        known.isThin == isThin
            ? isSameOutline(known.ellipse, ellipse)
            : isWithin(pixelByLine + sameByLine * std::min(known.ellipse.b, ellipse.b), known.ellipse, ellipse);
    if (isOne) {
      same = number;
    }
    return same >= 0;
  };
  // Of two outlines that are the same, either both are large or their centres are less than a cell apart.
  const double reach = std::min<double>(slackOf(ellipse), CellIndex::side);
  if (!m_centers.any(ellipse.center.x(), ellipse.center.y(), reach, isSame) && slackOf(ellipse) > CellIndex::side) {
    return std::any_of(m_large.begin(), m_large.end(), isSame) ? same : -1;
  }
  return same;
}

bool KnownOutlines::take(EllipseCandidate &candidate)
{
  int number = find(candidate.ellipse, candidate.isThin);
  const bool isNew = number < 0;
  if (!isNew) {
    EllipseCandidate &known = outlines[static_cast<std::size_t>(number)];
    const bool isBetter = candidate.isThin == known.isThin ? candidate.support > known.support : !candidate.isThin;
    if (!isBetter) {
      return false;
    }
    std::swap(known, candidate);
  }
  else {
    number = static_cast<int>(outlines.size());
    std::swap(outlines.append(), candidate);
  }
  const EllipseCandidate &kept = outlines[static_cast<std::size_t>(number)];
  m_centers.add(number, kept.ellipse.center.x(), kept.ellipse.center.y());
  if (slackOf(kept.ellipse) > CellIndex::side) {
    m_large.push_back(number);
  }
  for (const EdgePoint &point : kept.points) {
    m_points.add(number, point.position.x(), point.position.y());
  }
  return isNew;
}

double KnownOutlines::shareOn(const EllipseCandidate &known, const EdgePoint *points, std::size_t count,
                              std::size_t stride, double scale, double shift) const
{
  const double slack = 1. + fitToleranceOf(known.ellipse);
  std::size_t on = 0;
  std::size_t asked = 0;
  for (std::size_t i = 0; i < count; i += stride) {
    const Eigen::Vector2d position = scale * points[i].position + Eigen::Vector2d(shift, shift);
    on += std::abs(sampsonDistance(known.conic, position)) < scale * slack ? 1 : 0;
    ++asked;
  }
  return static_cast<double>(on) / static_cast<double>(asked);
}

template <typename IsOn>
bool KnownOutlines::anyAlong(const EdgePoint *points, std::size_t count, double scale, double shift,
                             const IsOn &isOn) const
{
  // An outline that holds three quarters of the points holds one of three in the middle, a quarter of the run apart,
  // but for a strange choice; outlines are looked for in the cells around each.
  for (const std::size_t i : {count / 4, count / 2, 3 * count / 4}) {
    const Eigen::Vector2d position = scale * points[i].position + Eigen::Vector2d(shift, shift);
    if (m_points.any(position.x(), position.y(), 2.,
                     [&](int number) { return isOn(outlines[static_cast<std::size_t>(number)]); })) {
      return true;
    }
  }
  return false;
}

bool KnownOutlines::holds(const EdgePoint *points, std::size_t count, double scale, double shift,
                          double leastSupport) const
{
  const std::size_t stride = 4 + count / 100; // a hundred points decide as well as all
  return anyAlong(points, count, scale, shift, [&](const EllipseCandidate &known) {
    return known.support >= leastSupport && shareOn(known, points, count, stride, scale, shift) > shareHeld;
  });
}

const EllipseCandidate *KnownOutlines::betterAlong(const EllipseCandidate &outline) const
{
  const std::vector<EdgePoint> &points = outline.points;
  const std::size_t stride = 1 + points.size() / 32; // an arc has few, and whether half of them are along it shows so
  const EllipseCandidate *better = nullptr;
  anyAlong(points.data(), points.size(), 1., 0., [&](const EllipseCandidate &known) {
    const bool isBetter =
        known.isThin == outline.isThin ? known.support > outline.support : outline.isThin && known.support >= wellFound;
    if (isBetter && (better == nullptr || known.ellipse.a > better->ellipse.a) &&
        shareOn(known, points.data(), points.size(), stride, 1., 0.) > shareAlong) {
      better = &known;
    }
    return false;
  });
  return better;
}

bool KnownOutlines::surrounds(const Eigen::Vector2d &point, double leastSupport, std::size_t first) const
{
  for (std::size_t i = first; i < outlines.size(); ++i) {
    const EllipseCandidate &known = outlines[i];
    if (known.support >= leastSupport &&
        (point - known.ellipse.center).squaredNorm() < known.ellipse.a * known.ellipse.a &&
        sampsonDistance(known.conic, point) < 0.) {
      return true;
    }
  }
  return false;
}
} // namespace circle_marker
END_VISP_NAMESPACE
