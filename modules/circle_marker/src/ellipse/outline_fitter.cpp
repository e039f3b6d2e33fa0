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
 * From a run of edge points to the outline of something dark.
 */

#include "ellipse/outline_fitter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "ellipse/ellipse_walk.h"
#include "ellipse/outline_greys.h"
#include "ellipse/sheet_ring.h"
#include "support/bilinear.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// The smallest ellipse worth trying: a minor axis of 4 pixels still shows its dark band.
constexpr double leastSemiMinor = 2.;
// A circle seen at 89.1 degrees has this axis ratio: of one of 800 pixels it leaves 12.
constexpr double leastAxisRatio = 0.015;
// Root-mean-square distance of a chain's points from their ellipse, pixels: noise and staircase, and a part that grows
// with size and leaves room for lens distortion (2 pixels on a ring of radius 300).
constexpr double fitTolerance = 0.4;
constexpr double fitToleranceOfSize = 0.006;
// Of longer chains only every second, third... point is fitted: more do not make a better start.
constexpr std::size_t mostFitPoints = 100;
// Share of the outline along which an edge must be found.
constexpr double leastSupport = 0.5;
// Where the first search has found all but one point of an outline, they fix the ellipse to a fraction of a pixel; what
// is less extrapolates from them, and is searched once more.
constexpr double wellSupported = 0.97;
// Points along a completed outline: one a pixel, no more than 128 (enough to start the refinement from). The first
// search, which only says where to look, makes do with fewer.
constexpr int fewestSamples = 24;
constexpr int mostSamples = 128;
constexpr int mostFirstSamples = 48;
// Distance of an edge from a completed outline, pixels: its own noise, and what is left of the ellipse's error.
constexpr double onOutline = 1.5;
// What the ellipse of an arc may be off on the far side, share of the semi-axis b, and what is left of that once edges
// all around are fitted, of the semi-axis a: by the lens, which bends an outline, more than by the fit.
constexpr double reachOfArc = 0.08;
constexpr double reachOfFit = 0.01;
// Share of an ellipse's perimeter that an arc must have to be judged by its centre at once.
constexpr double leastShareForCenter = 0.5;
// Share of an ellipse's perimeter, by their pixels, that two arcs must have to be completed: three bars that cover a
// quarter of a ring leave six arcs of 12 % each, which have fewer pixels along diagonals.
constexpr double leastShareOfJoined = 0.13;
// Share of an outline's points that is kept when it does not fit as a whole, and how often the choice is made again.
constexpr double trimmedShare = 0.75;
constexpr int trimmingPasses = 10;
// It is made as long as the farthest point that is kept comes nearer by this share: after that the choice is the same.
constexpr double leastTrimmed = 0.01;

// Beyond its dark line a thin ring's quiet zone is brighter by this, grey levels and noise of a pixel: one standard
// deviation of the difference of two interpolated samples. On grey ground a ring of 8 pixels shows 10 grey levels.
constexpr double leastRise = 1.;
constexpr double riseOfNoise = 0.7;
// Share of a thin ring's inner edge beyond which a dark line must be seen.
constexpr double leastDarkLine = 0.75;
// And share that is left when what does not fit is taken away.
constexpr double leastDarkLineOfMost = 0.6;
// Semi-minor axes of the outlines that are sought by their dark line, pixels: of smaller rings no code is left, of
// larger ones the outer edge shows, even on dark ground in a blur of 1.1 (from 11 on) and on ground that is brighter
// than the paper by more than that is than ink.
constexpr double leastThinRing = 2.3;
constexpr double mostThinRing = 16.;
// Ratio of the axes up to which a ring has ends: less narrow ones bend less sharply, and arcs are made of them. Ends
// that are told to belong together have 0.42 mostly (cap_pairs.cpp), but where noise moves them, and no arc is left,
// more.
constexpr double mostAxisRatioOfEnds = 0.6;
// And between its ends the blur leaves this share of the step that they have.
constexpr double leastStepBetweenEnds = 0.2;

double rootMeanSquareDistance(const EllipseCandidate &candidate, const EdgePoint *points, std::size_t count)
{
  double sum = 0.;
  for (std::size_t i = 0; i < count; ++i) {
    const double distance = sampsonDistance(candidate.conic, points[i].position);
    sum += distance * distance;
  }
  return std::sqrt(sum / static_cast<double>(count));
}

// Searches the whole outline for edges; leaves them in candidate.points and their share in candidate.support. Ends
// where that cannot be the least share any more, with something below it.
void searchOutline(const Gradient &gradient, EllipseCandidate &candidate, double reach, int most, double least)
{
  const EllipseParameters &ellipse = candidate.ellipse;
  const double perimeter = M_PI * (ellipse.a + ellipse.b); // of the circle of mean radius: right to 4 % at ratio 0.4
  const int samples = std::clamp(static_cast<int>(perimeter), fewestSamples, most);
  candidate.points.clear();
  candidate.points.reserve(mostSamples); // once and for all outlines that use this memory after it
  EllipseWalk walk(ellipse, samples);
  const int mostMissed = samples - static_cast<int>(std::ceil(least * samples));
  int missed = 0;
  for (int i = 0; i < samples && missed <= mostMissed; ++i, walk.next()) {
    const EdgePoint where = walk.here();
    const auto edge = searchEdge(gradient, where.position, where.normal(), reach);
    if (edge && std::abs(sampsonDistance(candidate.conic, edge->position)) <= std::max(reach, 1.)) {
      candidate.points.push_back(*edge);
    }
    else {
      ++missed;
    }
  }
  candidate.support = static_cast<double>(candidate.points.size()) / samples;
}

// Takes away the points that lie far from the ellipse.
void keepNear(EllipseCandidate &candidate)
{
  std::vector<EdgePoint> &points = candidate.points;
  const double bound = 2. * fitToleranceOf(candidate.ellipse);
  const auto end = std::remove_if(points.begin(), points.end(), [&](const EdgePoint &point) {
    return std::abs(sampsonDistance(candidate.conic, point.position)) > bound;
  });
  candidate.support *= static_cast<double>(end - points.begin()) / static_cast<double>(points.size());
  points.erase(end, points.end());
}

// Whether an ellipse is no larger than one that an image can show a piece of and still hold its centre, or nearly.
bool isWithinReach(const EllipseCandidate &candidate, const vpImage<unsigned char> &I)
{
  return candidate.ellipse.a <= I.getWidth() + I.getHeight();
}
} // namespace

double fitToleranceOf(const EllipseParameters &ellipse)
{
  return fitTolerance + fitToleranceOfSize * ellipse.a;
}

double riseBesideLine(const Gradient &gradient)
{
  return std::max(leastRise, riseOfNoise * gradient.noise.sigma);
}

EllipseReject OutlineFitter::fit(const vpImage<unsigned char> &I, const Gradient &gradient, const EdgePoint *points,
                                 std::size_t count, bool isWhole, const SoughtCenters &sought,
                                 EllipseCandidate &candidate)
{
  candidate.isThin = false;
  // A whole outline is fitted well enough at once; an arc's direct fit is too small.
  if (!fitPoints(points, count, candidate, isWhole ? directFit : roughFit) || !isWithinReach(candidate, I)) {
    return EllipseReject::NOT_AN_ELLIPSE;
  }
  // The centre of an ellipse is known as soon as half of it is.
  const double perimeter = M_PI * (candidate.ellipse.a + candidate.ellipse.b);
  const bool knowsCenter = isWhole || static_cast<double>(count) > leastShareForCenter * perimeter;
  const auto isNear = [&]() {
    return rootMeanSquareDistance(candidate, points, count) <= fitToleranceOf(candidate.ellipse);
  };
  const bool fits = isNear() || (isWhole && fitPoints(points, count, candidate) && isNear());
  if (knowsCenter && !hasSoughtCenter(I, points, count, candidate.ellipse.center, sought)) {
    return fits ? EllipseReject::OTHER_CENTER : EllipseReject::BAD_FIT;
  }
  if (!fits && (!isWhole || !fitMost(points, count, candidate))) {
    return EllipseReject::BAD_FIT;
  }
  return complete(I, gradient, sought, candidate);
}

EllipseReject OutlineFitter::fitJoined(const vpImage<unsigned char> &I, const Gradient &gradient,
                                       const EdgePoint *points, std::size_t count, double length,
                                       const SoughtCenters &sought, EllipseCandidate &candidate)
{
  candidate.isThin = false;
  if (!fitPoints(points, count, candidate, directFit)) {
    return EllipseReject::NOT_AN_ELLIPSE;
  }
  const double perimeter = M_PI * (candidate.ellipse.a + candidate.ellipse.b);
  if (rootMeanSquareDistance(candidate, points, count) > fitToleranceOf(candidate.ellipse)) {
    return EllipseReject::BAD_FIT;
  }
  if (length < leastShareOfJoined * perimeter) {
    return EllipseReject::LITTLE_SUPPORT;
  }
  if (length > leastShareForCenter * perimeter &&
      !hasSoughtCenter(I, points, count, candidate.ellipse.center, sought)) {
    return EllipseReject::OTHER_CENTER;
  }
  return complete(I, gradient, sought, candidate);
}

EllipseReject OutlineFitter::fitThinRing(const vpImage<unsigned char> &I, const Gradient &gradient,
                                         const EdgePoint *points, std::size_t count, ThinRing kind, double ringInner,
                                         EllipseCandidate &candidate)
{
  candidate.isThin = true;
  candidate.points.reserve(mostSamples);
  const double rise = riseBesideLine(gradient);
  if (kind == ThinRing::BY_SHEETS_SHAPE) {
    const auto line = darkLineOfSheet(I, points, count, rise);
    if (!line) {
      return EllipseReject::BRIGHT_INSIDE;
    }
    setOutline(*line, mostFirstSamples, candidate);
  }
  else {
    const RingNeighbour neighbour = kind == ThinRing::BY_INSIDE ? RingNeighbour::INSIDE : RingNeighbour::SHEET;
    const EllipseReject reason = fitDarkLine(I, points, count, neighbour, rise, candidate);
    if (reason != EllipseReject::NONE) {
      return reason;
    }
  }
  const double scale = 2. / (1. + ringInner); // from the middle of the ring to its outside
  EllipseParameters &ellipse = candidate.ellipse;
  ellipse.a *= scale;
  ellipse.b *= scale;
  if (ellipse.b < leastThinRing || ellipse.b > mostThinRing) {
    return EllipseReject::BRIGHT_INSIDE;
  }
  candidate.conic = conicFromEllipse(ellipse);
  for (EdgePoint &point : candidate.points) {
    point.position = ellipse.center + scale * (point.position - ellipse.center);
  }
  candidate.contrast = medianContrast(I, candidate);
  // By the sheet's shape the ring was found in all directions together: in most of them the blur may leave no step.
  const bool isDark = kind == ThinRing::BY_SHEETS_SHAPE || candidate.contrast >= rise;
  return isDark ? EllipseReject::NONE : EllipseReject::NOT_DARK_INSIDE;
}

EllipseReject OutlineFitter::fitEnds(const vpImage<unsigned char> &I, const Gradient &gradient, const EdgePoint *points,
                                     std::size_t count, const SoughtCenters &sought, EllipseCandidate &candidate)
{
  candidate.isThin = true;
  candidate.points.reserve(mostSamples);
  if (!fitPoints(points, count, candidate)) {
    return EllipseReject::NOT_AN_ELLIPSE;
  }
  if (rootMeanSquareDistance(candidate, points, count) > fitToleranceOf(candidate.ellipse) &&
      !fitMost(points, count, candidate)) {
    return EllipseReject::BAD_FIT;
  }
  const EllipseParameters ellipse = candidate.ellipse;
  if (ellipse.b < leastThinRing || ellipse.b > mostThinRing || ellipse.b > mostAxisRatioOfEnds * ellipse.a) {
    return EllipseReject::NOT_AN_ELLIPSE;
  }
  if (!hasSoughtCenter(I, points, count, ellipse.center, sought)) {
    return EllipseReject::OTHER_CENTER;
  }
  const GreysBeside beside = greysBeside(I, points, count);
  setOutline(ellipse, mostFirstSamples, candidate);
  candidate.contrast = medianContrast(I, candidate);
  const double least = std::max(riseBesideLine(gradient), leastStepBetweenEnds * (beside.bright - beside.dark));
  return candidate.contrast < least ? EllipseReject::NOT_DARK_INSIDE : EllipseReject::NONE;
}

// An ellipse through the dark line beside a closed edge.
EllipseReject OutlineFitter::fitDarkLine(const vpImage<unsigned char> &I, const EdgePoint *points, std::size_t count,
                                         RingNeighbour neighbour, double rise, EllipseCandidate &candidate)
{
  const LineSearch search = {mostFirstSamples, leastDarkLine};
  candidate.support = darkLineBeside(I, points, count, neighbour, rise, search, candidate.points);
  if (candidate.support < leastDarkLine) {
    return EllipseReject::BRIGHT_INSIDE;
  }
  if (!fitPoints(candidate.points.data(), candidate.points.size(), candidate, directFit)) {
    return EllipseReject::NOT_AN_ELLIPSE;
  }
  if (rootMeanSquareDistance(candidate, candidate.points.data(), candidate.points.size()) >
      fitToleranceOf(candidate.ellipse)) {
    // From the sheet, here and there the ring is missed.
    if (neighbour == RingNeighbour::INSIDE || !fitMost(candidate.points.data(), candidate.points.size(), candidate)) {
      return EllipseReject::BAD_FIT;
    }
    keepNear(candidate);
    if (candidate.support < leastDarkLineOfMost) {
      return EllipseReject::BAD_FIT;
    }
  }
  return EllipseReject::NONE;
}

EllipseReject OutlineFitter::follow(const vpImage<unsigned char> &I, const Gradient &gradient,
                                    const EllipseParameters &expected, const SoughtCenters &sought,
                                    EllipseCandidate &candidate)
{
  candidate.isThin = false;
  candidate.ellipse = expected;
  candidate.conic = conicFromEllipse(expected);
  return complete(I, gradient, sought, candidate);
}

// An ellipse through points; leaves candidate.conic and candidate.ellipse, or tells that there is none.
bool OutlineFitter::fitPoints(const EdgePoint *points, std::size_t count, EllipseCandidate &candidate,
                              const FitLimits &limits)
{
  m_positions.clear();
  const std::size_t stride = 1 + count / mostFitPoints;
  for (std::size_t i = 0; i < count; i += stride) {
    m_positions.push_back(points[i].position);
  }
  const auto conic = fitEllipse(m_positions.data(), m_positions.size(), limits);
  if (!conic) {
    return false;
  }
  const auto ellipse = ellipseFromConic(*conic);
  if (!ellipse || ellipse->b < leastSemiMinor || ellipse->b < leastAxisRatio * ellipse->a) {
    return false;
  }
  candidate.conic = *conic;
  candidate.ellipse = *ellipse;
  return true;
}

// An outline that has caught a piece of something else: fits what is left without the farthest points.
bool OutlineFitter::fitMost(const EdgePoint *points, std::size_t count, EllipseCandidate &candidate)
{
  const std::size_t stride = 1 + count / mostFitPoints;
  double previous = 0.;
  for (int pass = 0; pass < trimmingPasses; ++pass) {
    m_distances.clear();
    for (std::size_t i = 0; i < count; i += stride) {
      m_distances.push_back(std::abs(sampsonDistance(candidate.conic, points[i].position)));
    }
    m_sorted = m_distances;
    const auto bound =
        m_sorted.begin() + static_cast<std::ptrdiff_t>(trimmedShare * static_cast<double>(m_distances.size()));
    std::nth_element(m_sorted.begin(), bound, m_sorted.end());
    m_kept.clear();
    for (std::size_t i = 0; i < m_distances.size(); ++i) {
      if (m_distances[i] <= *bound) {
        m_kept.push_back(points[i * stride]);
      }
    }
    if (!fitPoints(m_kept.data(), m_kept.size(), candidate)) {
      return false;
    }
    if (std::abs(*bound - previous) < leastTrimmed * previous) {
      break;
    }
    previous = *bound;
  }
  return rootMeanSquareDistance(candidate, m_kept.data(), m_kept.size()) <= fitToleranceOf(candidate.ellipse);
}

EllipseReject OutlineFitter::complete(const vpImage<unsigned char> &I, const Gradient &gradient,
                                      const SoughtCenters &sought, EllipseCandidate &candidate)
{
  const auto fitsFound = [&]() {
    return fitPoints(candidate.points.data(), candidate.points.size(), candidate) && isWithinReach(candidate, I);
  };
  // The first search forgives the extrapolation of an arc, the second only the noise.
  searchOutline(gradient, candidate, onOutline + reachOfArc * candidate.ellipse.b, mostFirstSamples,
                0.5 * leastSupport);
  if (candidate.support < 0.5 * leastSupport) {
    return EllipseReject::LITTLE_SUPPORT;
  }
  if (!fitsFound()) {
    return EllipseReject::NOT_AN_ELLIPSE;
  }
  if (!hasSoughtCenter(I, candidate.points.data(), candidate.points.size(), candidate.ellipse.center, sought)) {
    return EllipseReject::OTHER_CENTER;
  }
  if (candidate.support < wellSupported) {
    searchOutline(gradient, candidate, onOutline + reachOfFit * candidate.ellipse.a, mostSamples, 0.5 * leastSupport);
    if (candidate.support < 0.5 * leastSupport) {
      return EllipseReject::LITTLE_SUPPORT;
    }
    if (!fitsFound()) {
      return EllipseReject::NOT_AN_ELLIPSE;
    }
  }
  searchOutline(gradient, candidate, onOutline, mostSamples, leastSupport);
  if (candidate.support < leastSupport) {
    return EllipseReject::LITTLE_SUPPORT;
  }
  if (rootMeanSquareDistance(candidate, candidate.points.data(), candidate.points.size()) >
      fitToleranceOf(candidate.ellipse)) {
    return EllipseReject::BAD_FIT;
  }
  candidate.contrast = medianContrast(I, candidate);
  if (candidate.contrast < gradient.startAt / sobelStepGain) { // the step of an edge that starts a chain
    return EllipseReject::NOT_DARK_INSIDE;
  }
  return EllipseReject::NONE;
}
} // namespace circle_marker
END_VISP_NAMESPACE
