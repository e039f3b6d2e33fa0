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
 * Whether an outline may be a marker seen through a strong blur.
 */

#include "decode/edge_width.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
constexpr int groups = 8; // of directions that lie side by side or opposite, whose profiles are averaged
constexpr int directions = 4 * groups;
constexpr int reach = 4;         // samples to either side of the outline: the ring's width
constexpr double spacing = 0.05; // of samples, of the outline's mean radius: a quarter of a ring
constexpr double leastStep = 4.; // grey levels; less is no edge

// Edges are wide from this on, pixels and semi-minor axes: sharp ones, and those of defocus discs of 8 % of the
// diameter, through which sectors are still read, are seen up to 0.15 wide, those of 15 % and of ways of 25 % from
// 0.17.
constexpr double leastWidth = 3.2;
constexpr double leastRelativeWidth = 0.16;
// Semi-minor axis of the smallest blurred marker that is tried, pixels: its sectors have a pixel each.
constexpr double leastSemiMinor = 9.;
// Where paper (of the quiet zone's width, and no farther out than in the usual one), ring and track are looked at, in
// radii, and how the centre's grey level may differ from that of the
// paper, the track's least and greatest from those of ring and paper, and what they differ at least, in units of the
// step between ring and paper.
constexpr double paperOfQuietZone = 0.72;
constexpr double farthestPaper = 1.12;
constexpr double ringRadius = 0.88;
constexpr double trackRadius = 0.5;
constexpr double centerRadius = 0.1;
constexpr double mostOffPaper = 0.2;
constexpr double mostUnevenCenter = 0.3;
constexpr double mostBeyond = 0.4;
constexpr double leastOfTrack = 0.2;
// A lens out of focus and a steady motion blur the same to either side: what they make of a ring is the same in
// opposite directions. Radii at which it is compared, where little is seen of a code, and what it differs, rms, in
// units of the step at most: those of blurred markers of all families differ by up to 0.22, what is no marker mostly by
// 0.4 and more.
constexpr std::array<double, 3> symmetricRadii = {0.8, 0.88, 0.96};
constexpr double mostAsymmetry = 0.35;

constexpr std::size_t aroundCount = 24; // directions in which a circle of the marker is looked at
using AroundSamples = std::array<unsigned char, aroundCount>;

// Grey levels along an ellipse about the outline's centre: the third from below and from above, and the mean.
struct CircleGreys
{
  double low = 0.;
  double mean = 0.;
  double high = 0.;
};

// Nearest pixels along an ellipse about the outline's centre; nothing where it leaves the image.
std::optional<AroundSamples> samplesAround(const vpImage<unsigned char> &I, const EllipseParameters &outline,
                                           double radius)
{
  const double ca = std::cos(outline.angle);
  const double sa = std::sin(outline.angle);
  // The directions are the same for all.
  static const std::array<Eigen::Vector2d, aroundCount> unit = [] {
    std::array<Eigen::Vector2d, aroundCount> points;
    for (std::size_t i = 0; i < aroundCount; ++i) {
      const double angle = 2. * M_PI * static_cast<double>(i) / aroundCount;
      points[i] = {std::cos(angle), std::sin(angle)};
    }
    return points;
  }();
  AroundSamples greys;
  for (std::size_t i = 0; i < greys.size(); ++i) {
    const double along = radius * outline.a * unit[i].x();
    const double across = radius * outline.b * unit[i].y();
    const double u = outline.center.x() + along * ca - across * sa;
    const double v = outline.center.y() + along * sa + across * ca;
    if (!(u >= 0. && v >= 0. && u < I.getWidth() - 0.5 && v < I.getHeight() - 0.5)) {
      return std::nullopt;
    }
    greys[i] = I[static_cast<unsigned int>(v + 0.5)][static_cast<unsigned int>(u + 0.5)];
  }
  return greys;
}

std::optional<CircleGreys> greysAround(const vpImage<unsigned char> &I, const EllipseParameters &outline, double radius)
{
  constexpr std::size_t left = 2; // on either side: what a noisy pixel says is not asked
  auto greys = samplesAround(I, outline, radius);
  if (!greys) {
    return std::nullopt;
  }
  std::sort(greys->begin(), greys->end());
  CircleGreys result;
  result.low = (*greys)[left];
  result.high = (*greys)[greys->size() - 1 - left];
  result.mean = std::accumulate(greys->begin(), greys->end(), 0.) / aroundCount;
  return result;
}

// Whether the ring looks the same in opposite directions, to a share of the step.
bool isSymmetric(const vpImage<unsigned char> &I, const EllipseParameters &outline, double step)
{
  constexpr std::size_t half = aroundCount / 2;
  double squares = 0.;
  for (const double radius : symmetricRadii) {
    const auto greys = samplesAround(I, outline, radius);
    if (!greys) {
      return false;
    }
    for (std::size_t i = 0; i < half; ++i) {
      const double difference = static_cast<double>((*greys)[i]) - (*greys)[i + half];
      squares += difference * difference;
    }
  }
  return squares < mostAsymmetry * mostAsymmetry * step * step * half * symmetricRadii.size();
}
} // namespace

double edgeWidth(const vpImage<unsigned char> &I, const EllipseParameters &outline, double paper)
{
  const double step = std::max(1., spacing * std::sqrt(outline.a * outline.b));
  const Eigen::Vector2d major(std::cos(outline.angle), std::sin(outline.angle));
  const Eigen::Vector2d minor(-major.y(), major.x());
  std::array<double, groups> widths;
  std::size_t seen = 0;
  for (int group = 0; group < groups; ++group) {
    std::array<double, 2 * reach + 1> profile{};
    int count = 0;
    for (int i = 0; i < 4; ++i) {
      const int direction = 2 * group + (i & 1) + (i & 2) * groups;
      const double angle = 2. * M_PI * (direction + 0.5) / directions;
      const double c = std::cos(angle);
      const double s = std::sin(angle);
      const Eigen::Vector2d place = outline.center + outline.a * c * major + outline.b * s * minor;
      const Eigen::Vector2d normal = (outline.b * c * major + outline.a * s * minor).normalized();
      std::array<double, 2 * reach + 1> here;
      bool isInside = true;
      for (int t = -reach; t <= reach && isInside; ++t) {
        const Eigen::Vector2d p = place + t * step * normal;
        isInside = p.x() > -0.5 && p.y() > -0.5 && p.x() < I.getWidth() - 0.5 && p.y() < I.getHeight() - 0.5;
        if (isInside) {
          here[static_cast<std::size_t>(t + reach)] =
              I[static_cast<unsigned int>(p.y() + 0.5)][static_cast<unsigned int>(p.x() + 0.5)];
        }
      }
      if (isInside) {
        ++count;
        for (std::size_t t = 0; t < profile.size(); ++t) {
          profile[t] += here[t];
        }
      }
    }
    if (count == 0) {
      continue;
    }
    const double dark = *std::min_element(profile.begin(), profile.begin() + reach + 1);
    const double bright = std::min(*std::max_element(profile.begin() + reach, profile.end()), paper * count);
    double slope = 0.;
    for (std::size_t t = reach - 2; t <= reach + 2; ++t) {
      slope = std::max(slope, 0.5 * (profile[t + 1] - profile[t - 1]));
    }
    if (bright - dark >= leastStep * count && slope > 0.) {
      widths[seen++] = step * (bright - dark) / slope;
    }
  }
  if (2 * seen < widths.size()) {
    return 0.;
  }
  const auto second = widths.begin() + static_cast<std::ptrdiff_t>(seen) - 2;
  std::nth_element(widths.begin(), second, widths.begin() + static_cast<std::ptrdiff_t>(seen));
  return *second;
}

bool looksBlurred(const vpImage<unsigned char> &I, const EllipseParameters &outline, bool isCoded, double quietZone)
{
  if (outline.b < leastSemiMinor) {
    return false;
  }
  const auto paper = greysAround(I, outline, std::min(1. + paperOfQuietZone * quietZone, farthestPaper));
  const auto ring = paper ? greysAround(I, outline, ringRadius) : std::nullopt;
  const auto center = ring ? greysAround(I, outline, centerRadius) : std::nullopt;
  if (!center) {
    return false;
  }
  const double step = paper->high - ring->low;
  if (step < leastStep || std::abs(center->mean - paper->high) > mostOffPaper * step ||
      center->high - center->low > mostUnevenCenter * step) {
    return false;
  }
  const auto track = greysAround(I, outline, trackRadius);
  if (!track || (isCoded && track->high - track->low < leastOfTrack * step) ||
      ring->low - track->low > mostBeyond * step || track->high - paper->high > mostBeyond * step) {
    return false;
  }
  return isSymmetric(I, outline, step) &&
         edgeWidth(I, outline, paper->high) > std::max(leastWidth, leastRelativeWidth * outline.b);
}
} // namespace circle_marker
END_VISP_NAMESPACE
