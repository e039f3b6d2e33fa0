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
 * Ellipses that may be the outer edge of a marker.
 */

#include "ellipse/ellipse_candidates.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "edges/convex_arcs.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// The smallest ellipse worth trying: a minor axis of 4 pixels still shows its dark band.
constexpr double leastSemiMinor = 2.;
// A circle seen at 85 degrees has an axis ratio of 0.087.
constexpr double leastAxisRatio = 0.08;
// Root-mean-square distance of a chain's points from their ellipse, pixels: noise and staircase, and a part that grows
// with size and leaves room for lens distortion (2 pixels on a ring of radius 300).
constexpr double fitTolerance = 0.4;
constexpr double fitToleranceOfSize = 0.006;
// Of longer chains only every second, third... point is fitted: more do not make a better start.
constexpr std::size_t mostFitPoints = 100;
// Share of the outline along which an edge must be found.
constexpr double leastSupport = 0.5;
// Points along a completed outline: one a pixel, no more than 128 (enough to start the refinement from).
constexpr int fewestSamples = 24;
constexpr int mostSamples = 128;
// Share of an outline's points that is kept when it does not fit as a whole, and how often the choice is made again.
constexpr double trimmedShare = 0.75;
constexpr int trimmingPasses = 10;
// Two ellipses are one outline if centres and axes agree to this share of the minor semi-axis (and a pixel).
constexpr double sameOutline = 0.1;

std::optional<EllipseCandidate> fitPoints(const EdgePoint *points, std::size_t count,
                                          std::vector<Eigen::Vector2d> &buffer)
{
  buffer.clear();
  const std::size_t stride = 1 + count / mostFitPoints;
  for (std::size_t i = 0; i < count; i += stride) {
    buffer.push_back(points[i].position);
  }
  const auto conic = fitEllipse(buffer.data(), buffer.size(), nullptr, roughFit);
  if (!conic) {
    return std::nullopt;
  }
  const auto ellipse = ellipseFromConic(*conic);
  if (!ellipse || ellipse->b < leastSemiMinor || ellipse->b < leastAxisRatio * ellipse->a) {
    return std::nullopt;
  }
  EllipseCandidate candidate;
  candidate.conic = *conic;
  candidate.ellipse = *ellipse;
  return candidate;
}

double rootMeanSquareDistance(const EllipseCandidate &candidate, const EdgePoint *points, std::size_t count)
{
  double sum = 0.;
  for (std::size_t i = 0; i < count; ++i) {
    const double distance = sampsonDistance(candidate.conic, points[i].position);
    sum += distance * distance;
  }
  return std::sqrt(sum / static_cast<double>(count));
}

double tolerance(const EllipseParameters &ellipse)
{
  return fitTolerance + fitToleranceOfSize * ellipse.a;
}

// Point and outward unit normal of an ellipse at a parameter angle.
EdgePoint pointOfEllipse(const EllipseParameters &ellipse, double parameter)
{
  const Eigen::Vector2d major(std::cos(ellipse.angle), std::sin(ellipse.angle));
  const Eigen::Vector2d minor(-major.y(), major.x());
  const double c = std::cos(parameter);
  const double s = std::sin(parameter);
  EdgePoint point;
  point.position = ellipse.center + ellipse.a * c * major + ellipse.b * s * minor;
  point.normal = (ellipse.b * c * major + ellipse.a * s * minor).normalized();
  return point;
}

// Searches the whole outline for edges; leaves them in candidate.points and their share in candidate.support.
void searchOutline(const Gradient &gradient, EllipseCandidate &candidate, double reach)
{
  const EllipseParameters &ellipse = candidate.ellipse;
  const double perimeter = M_PI * (ellipse.a + ellipse.b); // of the circle of mean radius: right to 4 % at ratio 0.4
  const int samples = std::clamp(static_cast<int>(perimeter), fewestSamples, mostSamples);
  candidate.points.clear();
  int found = 0;
  for (int i = 0; i < samples; ++i) {
    const EdgePoint where = pointOfEllipse(ellipse, 2. * M_PI * i / samples);
    const auto edge = searchEdge(gradient, where.position, where.normal, reach);
    if (edge && std::abs(sampsonDistance(candidate.conic, edge->position)) <= std::max(reach, 1.)) {
      candidate.points.push_back(*edge);
      ++found;
    }
  }
  candidate.support = static_cast<double>(found) / samples;
}

// Step between the brightest pixel outside and the darkest inside of an outline, median over it, grey levels.
double medianContrast(const vpImage<unsigned char> &I, const EllipseCandidate &candidate)
{
  constexpr int directions = 32;
  constexpr int reach = 3; // pixels to either side: past the blur of the edge
  std::vector<int> steps;
  for (int i = 0; i < directions; ++i) {
    const EdgePoint where = pointOfEllipse(candidate.ellipse, 2. * M_PI * i / directions);
    int brightest = -1;
    int darkest = 256;
    for (int t = -reach; t <= reach; ++t) {
      const Eigen::Vector2d p = where.position + t * where.normal;
      const long u = std::lround(p.x());
      const long v = std::lround(p.y());
      if (u < 0 || v < 0 || u >= static_cast<long>(I.getWidth()) || v >= static_cast<long>(I.getHeight())) {
        continue;
      }
      const int grey = I[static_cast<unsigned int>(v)][u];
      if (t > 0) {
        brightest = std::max(brightest, grey);
      }
      else {
        darkest = std::min(darkest, grey);
      }
    }
    if (brightest >= 0 && darkest <= 255) {
      steps.push_back(brightest - darkest);
    }
  }
  if (steps.empty()) {
    return 0.;
  }
  std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2), steps.end());
  return steps[steps.size() / 2];
}

class Finder
{
public:
  Finder(const vpImage<unsigned char> &I, const Gradient &gradient, std::vector<EllipseCandidate> &candidates)
      : m_image(I), m_gradient(gradient), m_candidates(candidates)
  {
  }

  // Tries a run of edge points as one outline; a whole outline may have caught a piece of something else.
  EllipseReject tryPoints(const EdgePoint *points, std::size_t count, bool isWhole)
  {
    auto candidate = fitPoints(points, count, m_buffer);
    if (!candidate || candidate->ellipse.a > m_image.getWidth() + m_image.getHeight()) {
      return EllipseReject::NOT_AN_ELLIPSE;
    }
    if (rootMeanSquareDistance(*candidate, points, count) > tolerance(candidate->ellipse)) {
      candidate = isWhole ? fitMost(*candidate, points, count) : std::nullopt;
      if (!candidate) {
        return EllipseReject::BAD_FIT;
      }
    }
    return complete(*candidate);
  }

  // Whether most of the points lie on an outline that is already known.
  bool isKnown(const EdgePoint *points, std::size_t count) const
  {
    for (const EllipseCandidate &known : m_candidates) {
      std::size_t on = 0;
      for (std::size_t i = 0; i < count; i += 4) {
        on += std::abs(sampsonDistance(known.conic, points[i].position)) < 1. + tolerance(known.ellipse) ? 1 : 0;
      }
      if (4 * on > (3 * count) / 4) {
        return true;
      }
    }
    return false;
  }

private:
  // An outline that has caught a piece of something else: fits what is left without the farthest points.
  std::optional<EllipseCandidate> fitMost(const EllipseCandidate &start, const EdgePoint *points, std::size_t count)
  {
    EllipseCandidate candidate = start;
    for (int pass = 0; pass < trimmingPasses; ++pass) {
      m_distances.clear();
      for (std::size_t i = 0; i < count; ++i) {
        m_distances.push_back(std::abs(sampsonDistance(candidate.conic, points[i].position)));
      }
      const auto bound = m_distances.begin() + static_cast<std::ptrdiff_t>(trimmedShare * static_cast<double>(count));
      std::vector<double> sorted = m_distances;
      std::nth_element(sorted.begin(), sorted.begin() + (bound - m_distances.begin()), sorted.end());
      const double farthest = sorted[static_cast<std::size_t>(bound - m_distances.begin())];
      m_kept.clear();
      for (std::size_t i = 0; i < count; ++i) {
        if (m_distances[i] <= farthest) {
          m_kept.push_back(points[i]);
        }
      }
      auto refit = fitPoints(m_kept.data(), m_kept.size(), m_buffer);
      if (!refit) {
        return std::nullopt;
      }
      candidate = *refit;
    }
    if (rootMeanSquareDistance(candidate, m_kept.data(), m_kept.size()) > tolerance(candidate.ellipse)) {
      return std::nullopt;
    }
    return candidate;
  }

  EllipseReject complete(EllipseCandidate &candidate)
  {
    // The first search forgives the extrapolation of an arc, the second only the noise.
    for (const double reach : {1.5 + 0.08 * candidate.ellipse.b, 1.5 + 0.01 * candidate.ellipse.a}) {
      searchOutline(m_gradient, candidate, reach);
      if (candidate.support < 0.5 * leastSupport) {
        return EllipseReject::LITTLE_SUPPORT;
      }
      auto refit = fitPoints(candidate.points.data(), candidate.points.size(), m_buffer);
      if (!refit) {
        return EllipseReject::NOT_AN_ELLIPSE;
      }
      candidate.conic = refit->conic;
      candidate.ellipse = refit->ellipse;
    }
    searchOutline(m_gradient, candidate, 1.5);
    if (candidate.support < leastSupport) {
      return EllipseReject::LITTLE_SUPPORT;
    }
    if (rootMeanSquareDistance(candidate, candidate.points.data(), candidate.points.size()) >
        tolerance(candidate.ellipse)) {
      return EllipseReject::BAD_FIT;
    }
    candidate.contrast = medianContrast(m_image, candidate);
    if (candidate.contrast < 0.25 * m_gradient.startAt) { // the step of an edge that starts a chain
      return EllipseReject::NOT_DARK_INSIDE;
    }
    for (EllipseCandidate &known : m_candidates) {
      if (isSameOutline(known.ellipse, candidate.ellipse)) {
        if (candidate.support > known.support) {
          known = candidate;
        }
        return EllipseReject::NONE;
      }
    }
    m_candidates.push_back(candidate);
    return EllipseReject::NONE;
  }

  const vpImage<unsigned char> &m_image;
  const Gradient &m_gradient;
  std::vector<EllipseCandidate> &m_candidates;
  std::vector<Eigen::Vector2d> m_buffer;
  std::vector<double> m_distances;
  std::vector<EdgePoint> m_kept;
};
} // namespace

bool isSameOutline(const EllipseParameters &p, const EllipseParameters &q)
{
  const double slack = 1. + sameOutline * std::min(p.b, q.b);
  return (p.center - q.center).norm() < slack && std::abs(p.a - q.a) < slack && std::abs(p.b - q.b) < slack;
}

void findEllipses(const vpImage<unsigned char> &I, const Gradient &gradient, const EdgeChains &chains,
                  std::vector<EllipseCandidate> &candidates)
{
  candidates.clear();
  Finder finder(I, gradient, candidates);
  std::vector<EdgePoint> points;
  std::vector<std::pair<std::size_t, std::size_t>> arcs;
  std::vector<const EdgeChain *> open;
  for (const EdgeChain &chain : chains.chains) {
    if (!chain.closed) {
      open.push_back(&chain);
      continue;
    }
    points.clear();
    locateChain(gradient, chains, chain, points);
    if (points.size() < 8 || doubledArea(points) <= 0.) {
      continue;
    }
    if (finder.tryPoints(points.data(), points.size(), true) != EllipseReject::NONE) {
      open.push_back(&chain);
    }
  }
  for (const EdgeChain *chain : open) {
    points.clear();
    locateChain(gradient, chains, *chain, points);
    cutConvexArcs(points, arcs);
    for (const auto &[begin, end] : arcs) {
      if (!finder.isKnown(points.data() + begin, end - begin)) {
        finder.tryPoints(points.data() + begin, end - begin, false);
      }
    }
  }
  std::sort(candidates.begin(), candidates.end(),
            [](const EllipseCandidate &p, const EllipseCandidate &q) { return p.ellipse.a > q.ellipse.a; });
}
} // namespace circle_marker
END_VISP_NAMESPACE
