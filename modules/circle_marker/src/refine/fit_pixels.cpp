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
#include <cmath>

#include "support/normal_distribution.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Half-width of the band of pixels along an edge, in units of the blur: beyond, an edge has no slope.
constexpr double bandOfBlur = 3.2;
// A pixel that may see more than this share of what lies beyond the quiet zone is not used.
constexpr double mostSurround = 0.3;
// Of the flat areas, one pixel in 16 is enough to know their level.
constexpr int flatStride = 4;

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
} // namespace

void selectPixels(const vpImage<unsigned char> &I, const CameraModel &camera, const MarkerPlane *planes,
                  std::size_t count, const MarkerPattern &pattern, double blur, double quietZone, double most,
                  std::vector<FitPixel> &pixels)
{
  pixels.clear();
  const double band = bandOfBlur * blur;
  const double outermost = 1. + quietZone;
  const Box box = boundingBox(I, camera, planes, count, outermost);
  const Eigen::Vector2d center = camera.toPixel(planes[0].project(Eigen::Vector2d::Zero()));
  const double size = 0.25 * (box.right - box.left + box.bottom - box.top) / outermost;
  const double expected = 2. * band * edgeLength(pattern, size);
  // A lattice of one pixel in `keep`, slanted by the golden section so that it has no short period along any edge; the
  // edges of a marker that is thinned know white and black well enough without its flat areas.
  const int keep = std::max(1, static_cast<int>(std::ceil(expected / most)));
  const int slant = static_cast<int>(std::lround(0.382 * keep));
  for (int v = box.top; v <= box.bottom; ++v) {
    for (int u = box.left; u <= box.right; ++u) {
      const bool flatSample = keep < flatStride && u % flatStride == 0 && v % flatStride == 0;
      if ((u + slant * v) % keep != 0 && !flatSample) {
        continue;
      }
      FitPixel pixel;
      const Eigen::Vector2d where(u, v);
      pixel.model.meter = camera.toMeter(where);
      pixel.model.meterPerPixel = camera.meterPerPixel(where);
      bool inside = true;
      double distance = HUGE_VAL;
      for (std::size_t i = 0; i < count && inside; ++i) {
        const PatternDistance here = distanceToPattern(pixel.model, planes[i], pattern);
        distance = std::min(distance, here.toEdges);
        const double toSurround = (outermost - here.radius) / here.radiusPerPixel;
        pixel.surround = std::max(pixel.surround, NormalDistribution::instance().at(-toSurround / blur).cumulative);
        inside = pixel.surround < mostSurround;
      }
      if (!inside || (distance > band && !flatSample)) {
        continue;
      }
      // Inside a plain ring anything may be printed: only the neighbourhood of its edges is known.
      if (pattern.sectors == 0 && distance > band) {
        continue;
      }
      pixel.offset = (where - center) / size;
      pixel.grey = I[v][u];
      pixels.push_back(pixel);
    }
  }
}
} // namespace circle_marker
END_VISP_NAMESPACE
