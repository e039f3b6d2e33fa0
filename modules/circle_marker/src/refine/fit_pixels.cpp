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
 * The pixels a marker's pose is refined on.
 */

#include "refine/fit_pixels.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "refine/lanes.h"
#include "refine/plane_point.h"
#include "refine/surround.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Half-width of the band of pixels along an edge: beyond 2.4 standard deviations of the blur lies 0.1 % of what an edge
// tells of its place and 1 % of what it tells of the blur; and the pose is known to this, pixels.
constexpr double bandOfBlur = 2.4;
constexpr double poseError = 0.3;
// A pixel that may see more than this share of what lies beyond the quiet zone is not used.
constexpr double mostSurround = 0.9;
// A pixel that sees less than this share of it sees nothing: a thousandth of the light is below the noise.
constexpr double leastSurround = 0.001;
// So many standard deviations of the blur away it is less.
constexpr double clearOfSurround = 3.1;
// The marker's box is looked through in tiles of laneCount pixels in either direction: far from all edges, or within a
// sector, one pixel of a tile is enough to know the level of the flat areas.
constexpr double tileHalf = 0.5 * (laneCount - 1);      // pixels, from its first pixel to its centre
constexpr double tileRadius = 0.7072 * (laneCount - 1); // pixels, from its centre to its corners
// Sectors that are narrower than this at the track's outer rim, in units of the band, are used as a whole.
constexpr double narrowSector = 3.;
// Hypotheses that are served.
constexpr std::size_t mostHypotheses = 2;

struct Box
{
  int left;
  int right;
  int top;
  int bottom;
};

// Box around the marker and its quiet zone in all hypotheses, within the image.
Box boundingBox(const vpImage<unsigned char> &I, const CameraModel &camera, const MarkerPlane *planes,
                std::size_t count, double radius)
{
  constexpr int directions = 24; // the polygon is 1 % too small; the margin below covers it
  Eigen::Vector2d least(HUGE_VAL, HUGE_VAL);
  Eigen::Vector2d most = -least;
  for (std::size_t i = 0; i < count; ++i) {
    for (int k = 0; k < directions; ++k) {
      const double angle = 2. * M_PI * k / directions;
      const Eigen::Vector2d p =
          camera.toPixel(planes[i].project(1.01 * radius * Eigen::Vector2d(std::cos(angle), std::sin(angle))));
      least = least.cwiseMin(p);
      most = most.cwiseMax(p);
    }
  }
  const auto inside = [](double value, int limit) {
    return static_cast<int>(std::clamp(value, 0., static_cast<double>(limit)));
  };
  const int width = static_cast<int>(I.getWidth());
  const int height = static_cast<int>(I.getHeight());
  return {inside(std::floor(least.x()), width - 1), inside(std::ceil(most.x()), width - 1),
          inside(std::floor(least.y()), height - 1), inside(std::ceil(most.y()), height - 1)};
}

// Length of all edges of the pattern in the image, pixels.
double edgeLength(const MarkerPattern &pattern, double meanRadius)
{
  double length = 0.;
  for (unsigned int i = 0; i < pattern.ringEdges; ++i) {
    length += 2. * M_PI * pattern.ring[i].radius;
  }
  if (pattern.sectors > 0) {
    // Half of the track's rims are black; of its sectors' borders, half are edges.
    length += M_PI * (pattern.track[0].radius + pattern.track[1].radius) +
              0.5 * pattern.sectors * (pattern.track[0].radius - pattern.track[1].radius);
  }
  return length * meanRadius;
}

// A tile as one hypothesis sees it: the plane to first order around the tile's centre.
struct Tile
{
  PlanePoint center;
  Eigen::Matrix2d metric; // of the plane in the image: a direction o of the plane has the gradient sqrt(o' metric o)
  std::array<Eigen::Vector2f, 3> borders; // unit vectors across edges between sectors, divided by their gradient
  int bordersSeen = 0;
  bool everySector = false; // sectors are so narrow that there is no need to look for their borders
};

// A look at one hypothesis, tile by tile.
class Hypothesis
{
public:
  Hypothesis(const MarkerPlane &plane, const MarkerPattern &pattern, double band)
      : m_plane(plane), m_pattern(pattern), m_band(band)
  {
  }

  // Whether any pixel of a tile may be near an edge.
  bool enter(const ModelPixel &center)
  {
    m_tile.center = planePoint(center, m_plane);
    m_tile.metric = m_tile.center.byPixel * m_tile.center.byPixel.transpose();
    const double radius = m_tile.center.q.norm();
    // However the tile lies, the radius changes by no more than this to its corners.
    const double change = (m_band + tileRadius) * std::sqrt(m_tile.metric.trace());
    bool isNear = false;
    for (unsigned int i = 0; i < m_pattern.ringEdges; ++i) {
      isNear = isNear || std::abs(radius - m_pattern.ring[i].radius) < change;
    }
    if (m_pattern.sectors == 0) {
      return isNear;
    }
    if (radius > m_pattern.track[0].radius + change || radius < m_pattern.track[1].radius - change) {
      return isNear;
    }
    isNear = isNear || std::abs(radius - m_pattern.track[0].radius) < change ||
             std::abs(radius - m_pattern.track[1].radius) < change;
    return seeBorders(radius) || isNear;
  }

  // Distance of the pixels of a row of the tile to the nearest edge; row: its distance below the tile's centre, pixels.
  Lanes distances(double row) const
  {
    const Eigen::Vector2f middle = (m_tile.center.q + row * m_tile.center.byPixel.col(1)).cast<float>();
    const Eigen::Vector2f step = m_tile.center.byPixel.col(0).cast<float>();
    const Lanes offset = Lanes::LinSpaced(-static_cast<float>(tileHalf), static_cast<float>(tileHalf));
    const Lanes qx = middle.x() + step.x() * offset;
    const Lanes qy = middle.y() + step.y() * offset;
    const Lanes radius = (qx * qx + qy * qy).max(1e-12f).sqrt();
    const Eigen::Matrix2f metric = m_tile.metric.cast<float>();
    const Lanes perGradient =
        radius * (metric(0, 0) * qx * qx + 2.f * metric(0, 1) * qx * qy + metric(1, 1) * qy * qy).rsqrt();
    const auto toCircle = [&](const RadialEdge &edge) -> Lanes {
      return (radius - static_cast<float>(edge.radius)).abs() * perGradient;
    };
    Lanes nearest = toCircle(m_pattern.ring[0]);
    if (m_pattern.ringEdges > 1) {
      nearest = nearest.min(toCircle(m_pattern.ring[1]));
    }
    if (m_pattern.sectors == 0) {
      return nearest;
    }
    nearest = nearest.min(toCircle(m_pattern.track[0])).min(toCircle(m_pattern.track[1]));
    // Outside of the track a border counts from the rim on: the larger of both distances is near enough.
    const Lanes outside = ((radius - static_cast<float>(m_pattern.track[0].radius))
                               .max(static_cast<float>(m_pattern.track[1].radius) - radius)
                               .max(0.f)) *
                          perGradient;
    if (m_tile.everySector) {
      return nearest.min(outside);
    }
    for (int k = 0; k < m_tile.bordersSeen; ++k) {
      const Eigen::Vector2f &across = m_tile.borders[static_cast<std::size_t>(k)];
      nearest = nearest.min((across.x() * qx + across.y() * qy).abs().max(outside));
    }
    return nearest;
  }

private:
  // The edges between sectors that a tile may see; whether there are any.
  bool seeBorders(double radius)
  {
    const double sectorAngle = 2. * M_PI / m_pattern.sectors;
    const double perPixel = std::sqrt(m_tile.metric.trace());
    m_tile.everySector = sectorAngle * m_pattern.track[0].radius < narrowSector * m_band * perPixel ||
                         (m_band + tileRadius) * perPixel > sectorAngle * radius;
    m_tile.bordersSeen = 0;
    if (m_tile.everySector) {
      return true;
    }
    const int nearest = m_pattern.nearestBorder(m_tile.center.q);
    for (int border = nearest - 1; border <= nearest + 1; ++border) {
      if (m_pattern.isBlack(border) == m_pattern.isBlack(border - 1)) {
        continue;
      }
      const Eigen::Vector2d &across = m_pattern.acrossBorder(border);
      const double gradient = (m_tile.center.byPixel.transpose() * across).norm();
      if (std::abs(across.dot(m_tile.center.q)) < (m_band + tileRadius) * gradient) {
        m_tile.borders[static_cast<std::size_t>(m_tile.bordersSeen++)] = (across / gradient).cast<float>();
      }
    }
    return m_tile.bordersSeen > 0;
  }

  const MarkerPlane &m_plane;
  const MarkerPattern &m_pattern;
  const double m_band; // pixels
  Tile m_tile;
};

// Completes pixels with what they see of the surround.
class SurroundShare
{
public:
  SurroundShare(const vpImage<unsigned char> &I, const CameraModel &camera, const MarkerPlane *planes,
                std::size_t count, const PaperEnds &papers, double blur)
      : m_planes(planes), m_count(count), m_outermost(papers[0].extent), m_blur(blur), m_papers(papers)
  {
    for (std::size_t shape = 0; shape < paperShapes; ++shape) {
      m_surrounds[shape] = surroundOf(I, camera, planes[0], m_papers[shape], blur);
    }
  }

  // Whether the pixel sees enough of the marker.
  bool complete(FitPixel &pixel) const
  {
    if (!m_isNear) {
      return true;
    }
    for (std::size_t i = 0; i < m_count; ++i) {
      const PlanePoint point = planePoint(pixel.model, m_planes[i]);
      if (point.q.norm() < m_outermost - clearOfSurround * m_blur * point.byPixel.norm()) {
        continue;
      }
      for (std::size_t shape = 0; shape < paperShapes; ++shape) {
        const Surround &surround = m_surrounds[shape];
        const double share = shareBeyond(point, m_papers[shape], m_blur);
        if (share > mostSurround) {
          return false;
        }
        BeyondPaper &beyond = pixel.beyond[shape];
        if (share > std::max(beyond.share, leastSurround)) {
          const unsigned int direction = Surround::directionOf(point.q);
          beyond = {share, static_cast<double>(surround.grey[direction]),
                    static_cast<double>(surround.spread[direction])};
        }
      }
    }
    return true;
  }

  // Tells whether any pixel of the tile around a pixel may see the surround.
  void enter(const ModelPixel &center)
  {
    m_isNear = false;
    for (std::size_t i = 0; i < m_count; ++i) {
      const PlanePoint point = planePoint(center, m_planes[i]);
      m_isNear =
          m_isNear || point.q.norm() > m_outermost - (clearOfSurround * m_blur + tileRadius) * point.byPixel.norm();
    }
  }

private:
  bool m_isNear = true;
  const MarkerPlane *m_planes;
  const std::size_t m_count;
  const double m_outermost;
  const double m_blur;
  const PaperEnds &m_papers;
  std::array<Surround, paperShapes> m_surrounds;
};
} // namespace

void selectPixels(const vpImage<unsigned char> &I, const CameraModel &camera, const MarkerPlane *planes,
                  std::size_t count, const MarkerPattern &pattern, double blur, double most,
                  std::vector<FitPixel> &pixels)
{
  pixels.clear();
  count = std::min(count, mostHypotheses);
  const double band = bandOfBlur * blur + poseError;
  const double outermost = pattern.paper[0].extent;
  const Box box = boundingBox(I, camera, planes, count, outermost);
  const Eigen::Vector2d center = camera.toPixel(planes[0].project(Eigen::Vector2d::Zero()));
  const double size = 0.25 * (box.right - box.left + box.bottom - box.top) / outermost;
  const double expected = 2. * band * edgeLength(pattern, size);
  // A lattice of one pixel in `keep`, slanted by the golden section so that it has no short period along any edge; the
  // edges of a marker that is thinned know white and black well enough without its flat areas.
  const int keep = std::max(1, static_cast<int>(std::ceil(expected / most)));
  const int slant = static_cast<int>(std::lround(0.382 * keep));
  SurroundShare surround(I, camera, planes, count, pattern.paper, blur);
  std::array<Hypothesis, mostHypotheses> hypotheses = {
      {{planes[0], pattern, band}, {planes[count - 1], pattern, band}}};
  const auto add = [&](int u, int v, FitPixel &pixel) {
    const Eigen::Vector2d where(u, v);
    pixel.model.meter = camera.toMeter(where);
    pixel.beyond = {};
    if (surround.complete(pixel)) {
      pixel.offset = (where - center) / size;
      pixel.grey = I[v][u];
      pixels.push_back(pixel);
    }
  };
  for (int top = box.top; top <= box.bottom; top += laneCount) {
    for (int left = box.left; left <= box.right; left += laneCount) {
      const Eigen::Vector2d middle(left + tileHalf, top + tileHalf);
      FitPixel pixel;
      pixel.model = {camera.toMeter(middle), camera.meterPerPixel(middle)};
      bool isNear = false;
      for (std::size_t i = 0; i < count; ++i) {
        isNear = hypotheses[i].enter(pixel.model) || isNear;
      }
      if (!isNear) {
        // Inside a plain ring anything may be printed: only the neighbourhood of its edges is known.
        if (pattern.sectors > 0 && keep == 1) {
          add(left, top, pixel);
        }
        continue;
      }
      surround.enter(pixel.model);
      const int right = std::min(left + laneCount - 1, box.right);
      for (int v = top; v <= std::min(top + laneCount - 1, box.bottom); ++v) {
        Lanes distance = Lanes::Constant(HUGE_VALF);
        for (std::size_t i = 0; i < count; ++i) {
          distance = distance.min(hypotheses[i].distances(v - top - tileHalf));
        }
        if (distance.minCoeff() >= static_cast<float>(band)) {
          continue;
        }
        int phase = (left + slant * v) % keep;
        for (int u = left; u <= right; ++u) {
          if (phase == 0 && distance[u - left] < static_cast<float>(band)) {
            add(u, v, pixel);
          }
          phase = phase + 1 < keep ? phase + 1 : 0;
        }
      }
    }
  }
}
} // namespace circle_marker
END_VISP_NAMESPACE
