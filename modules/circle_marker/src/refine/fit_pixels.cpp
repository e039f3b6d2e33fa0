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

#include "pose/circle_bounds.h"
#include "refine/fit_starts.h"
#include "refine/surround_share.h"
#include "support/pixel_box.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
namespace {
// Half-width of the band of pixels along an edge: beyond 2 standard deviations of the blur lies 0.5 % of what an edge
// tells of its place and 5 % of what it tells of the blur. A small marker, which has few pixels, uses them up to 2.4
// standard deviations: 0.1 and 1 % lie beyond. A large one has so many that time counts: 2.4 % of what an edge tells of
// its place lie beyond 1.6, and a fifth of the pixels.
constexpr double bandOfBlur = 2.;
constexpr double bandOfSmall = 2.4;
constexpr double bandOfLarge = 1.6;
constexpr double smallMarker = 40.;  // diameter, pixels
constexpr double largeMarker = 200.; // diameter, pixels

// Box around the marker and its quiet zone in all hypotheses, within the image.
PixelBox boundingBox(const vpImage<unsigned char> &I, const CameraModel &camera, const MarkerPlane *planes,
                     std::size_t count, double radius)
{
  constexpr int directions = 24; // the polygon is 1 % too small; the margin below covers it
  Eigen::Vector2d least(HUGE_VAL, HUGE_VAL);
  Eigen::Vector2d most = -least;
  for (std::size_t i = 0; i < count; ++i) {
    const ImageBounds bounds = boundsOfCircle(planes[i], camera, 1.01 * radius, directions);
    least = least.cwiseMin(bounds.least);
    most = most.cwiseMax(bounds.most);
  }
  const int width = static_cast<int>(I.getWidth());
  const int height = static_cast<int>(I.getHeight());
  return {pixelWithin(std::floor(least.x()), width - 1), pixelWithin(std::floor(least.y()), height - 1),
          pixelWithin(std::ceil(most.x()), width - 1) + 1, pixelWithin(std::ceil(most.y()), height - 1) + 1};
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

// Whether the paper may end within so many pixels of the outermost edge, along the image's shorter axis. end: in radii.
bool mayShowEnd(const MarkerPlane *planes, std::size_t count, const CameraModel &camera, double end, double distance)
{
  return std::any_of(planes, planes + count, [&](const MarkerPlane &plane) {
    return (end - 1.) * plane.semiMinor(meterPerPixelAt(plane, camera)) < distance;
  });
}

// One pixel in so many, in a lattice that is slanted by the golden section so that it has no short period along any
// edge; the edges of a marker that is thinned know white and black well enough without its flat areas.
struct Lattice
{
  explicit Lattice(int pixels) : keep(pixels), slant(static_cast<int>(std::lround(0.382 * pixels))) {}

  bool holdsAll() const { return keep == 1; }
  bool holds(int u, int v) const { return keep == 1 || (u + slant * v) % keep == 0; }

  int keep;
  int slant;
};

// Adds pixels, row by row, with what the model needs of each.
class PixelAdder
{
public:
  PixelAdder(const vpImage<unsigned char> &I, const CameraModel &camera, const ImageFrame &frame,
             SurroundShare &surround, std::vector<FitPixel> &pixels)
      : m_image(I), m_camera(camera), m_frame(frame), m_surround(surround), m_pixels(pixels),
        m_perSize(1. / frame.size), m_isLinear(camera.isLinear()), m_corner(camera.toMeter(Eigen::Vector2d::Zero())),
        m_perPixel(camera.meterPerPixel(Eigen::Vector2d::Zero()).diagonal())
  {
  }

  // Goes to a row.
  void enter(int v)
  {
    m_row = v;
    m_greys = m_image[static_cast<unsigned int>(v)];
    m_meterY = m_corner.y() + v * m_perPixel.y();
    m_offsetY = static_cast<float>(m_perSize * (v - m_frame.center.y()));
  }

  // Adds the pixel of a column of the row.
  void add(int u, const Eigen::Matrix2f &meterPerPixel)
  {
    const Eigen::Vector2d meter = m_isLinear ? Eigen::Vector2d(m_corner.x() + u * m_perPixel.x(), m_meterY)
                                             : m_camera.toMeter(Eigen::Vector2d(u, m_row));
    FitPixel &pixel = m_pixels.emplace_back();
    pixel.meterPerPixel = meterPerPixel;
    pixel.meter = meter.cast<float>();
    pixel.offset << static_cast<float>(m_perSize * (u - m_frame.center.x())), m_offsetY;
    pixel.grey = m_greys[u];
    if (m_surround.isNear() && !m_surround.complete(u, m_row, meter, pixel)) {
      m_pixels.pop_back();
    }
  }

private:
  const vpImage<unsigned char> &m_image;
  const CameraModel &m_camera;
  const ImageFrame m_frame;
  SurroundShare &m_surround;
  std::vector<FitPixel> &m_pixels;
  const double m_perSize;
  const bool m_isLinear;
  const Eigen::Vector2d m_corner;   // normalised coordinates
  const Eigen::Vector2d m_perPixel; // of these, if linear
  int m_row = 0;
  const unsigned char *m_greys = nullptr; // the row's
  double m_meterY = 0.;                   // the row's, if linear
  float m_offsetY = 0.f;                  // the row's
};

using Hypotheses = std::array<TileView, mostHypotheses>;

// Calls visit(v, columns) for each row of the tile that the hypotheses look at, as far as the box reaches: its columns,
// from the tile's first, that are nearer than the band is wide to an edge in any of them.
template <class Visit>
void forEachRow(const Hypotheses &hypotheses, std::size_t count, int left, int top, const PixelBox &box, double band,
                const Visit &visit)
{
  for (int v = top; v < std::min(top + laneCount, box.bottom); ++v) {
    Lanes distance = Lanes::Constant(HUGE_VALF);
    for (std::size_t i = 0; i < count; ++i) {
      distance = distance.min(hypotheses[i].distances(v - top - tileHalf));
    }
    LaneList columns = lanesBelow(distance, static_cast<float>(band));
    while (columns.count > 0 && left + columns.lanes[static_cast<std::size_t>(columns.count - 1)] >= box.right) {
      --columns.count;
    }
    visit(v, columns);
  }
}
} // namespace

void selectPixels(const vpImage<unsigned char> &I, const CameraModel &camera, const ImageFrame &frame,
                  const MarkerPlane *planes, std::size_t count, const MarkerPattern &pattern, const PixelChoice &choice,
                  std::vector<FitPixel> &pixels)
{
  const BlurParameters &blur = choice.blur;
  pixels.clear();
  count = std::min(count, mostHypotheses);
  // In coordinates in which the blur is round: there lengths are larger by this factor at most.
  const double longer = blur.widest() / blur.sigma;
  const double outermost = pattern.paper[0].extent;
  const PixelBox box = boundingBox(I, camera, planes, count, outermost);
  const double size = 0.25 * (box.width() + box.height() - 2) / outermost;
  const double deviations = 2. * size < smallMarker ? bandOfSmall : 2. * size > largeMarker ? bandOfLarge : bandOfBlur;
  const double band = deviations * blur.sigma + longer * choice.poseError;
  const double expected = 2. * band * edgeLength(pattern, size);
  const Lattice lattice(std::max(1, static_cast<int>(std::ceil(expected / choice.manyPixels))));
  // Inside a plain ring anything may be printed: only the neighbourhood of its edges is known.
  const bool usesFlat = pattern.sectors > 0 && lattice.holdsAll();
  const double flatTiles = M_PI * std::pow(outermost * size / laneCount, 2.);
  const Lattice flatLattice(std::max(1, static_cast<int>(std::ceil(flatTiles / choice.manyFlat))));
  SurroundShare surround(I, camera, planes, count, pattern.paper, blur);
  Hypotheses hypotheses = {
      {{planes[0], pattern, band, blur.shape()}, {planes[count - 1], pattern, band, blur.shape()}}};
  const bool showsEnd = mayShowEnd(planes, count, camera, outermost, band + clearOfSurround * blur.widest());
  PixelAdder adder(I, camera, frame, surround, pixels);
  for (int top = box.top; top < box.bottom; top += laneCount) {
    for (int left = box.left; left < box.right; left += laneCount) {
      const Eigen::Vector2d middle(left + tileHalf, top + tileHalf);
      const ModelPixel tile = {camera.toMeter(middle), camera.meterPerPixel(middle)};
      bool isNear = false;
      for (std::size_t i = 0; i < count; ++i) {
        isNear = hypotheses[i].enter(tile) || isNear;
      }
      if (!isNear && !(usesFlat && flatLattice.holds((left - box.left) / laneCount, (top - box.top) / laneCount))) {
        continue;
      }
      surround.enter(middle, hypotheses);
      const Eigen::Matrix2f derivative = tile.meterPerPixel.cast<float>();
      if (!isNear) {
        // Near an end of the paper that no edge is seen with, it would tell nothing of the pose, and the fit would go
        // on until it knows how the sheet is cut.
        if (showsEnd || !surround.isNear()) {
          adder.enter(top);
          adder.add(left, derivative);
        }
        continue;
      }
      forEachRow(hypotheses, count, left, top, box, band, [&](int v, const LaneList &columns) {
        adder.enter(v);
        for (int k = 0; k < columns.count; ++k) {
          const int u = left + columns.lanes[static_cast<std::size_t>(k)];
          if (lattice.holds(u, v)) {
            adder.add(u, derivative);
          }
        }
      });
    }
  }
}
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE
