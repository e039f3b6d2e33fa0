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
 * The pixels of a code track, and their likelihood as a function of the sectors.
 */

#include "refine/code_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "pose/circle_bounds.h"
#include "refine/surround.h"
#include "support/sensor_range.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// A pixel sees the sectors whose borders are within this many standard deviations of the blur; and no more than these
// to either side of the one that it lies in.
constexpr double reach = 3.;
constexpr int mostReach = 4;
// Pixels of the track, and this many standard deviations of the blur around it.
constexpr double around = 1.5;
// What the model leaves besides noise, in units of the contrast: pose, blur and light are not exact.
constexpr double modelError = 0.04;
// Less of a sector is not worth its products.
constexpr double leastShare = 1e-3;
// What is brighter than the sensor can tell is taken for white if by that it is wrong by no more than this share of the
// contrast.
constexpr double mostHidden = 0.1;

// The side of a circle about the centre that is nearer to it. Its curvature takes from what is inside: image_model.h.
BlurredEdge insideOf(double radius, const PlanePoint &point)
{
  const double r = std::max(point.q.norm(), 1e-6);
  const Eigen::Vector2d gradient = point.byPixel.transpose() * (point.q / r); // of the radius, by the blur
  const double length = gradient.norm();
  return {(radius - r) / length - 0.5 * length / std::max(r, length), -gradient / length};
}

// The side of a border between sectors toward larger angles.
BlurredEdge beyondBorder(const Eigen::Vector2d &across, const PlanePoint &point)
{
  const Eigen::Vector2d gradient = point.byPixel.transpose() * across;
  const double length = gradient.norm();
  return {across.dot(point.q) / length, gradient / length};
}

// What the probability of both sides is more than the product of both: two terms of the tetrachoric series.
double together(const BlurredEdge &a, const BlurredEdge &b)
{
  const double rho = a.gradient.dot(b.gradient);
  return a.density * b.density * rho * (1. + 0.5 * rho * a.distance * b.distance);
}

// Share of the pixel that lies in the track beyond a border, whose normal is told.
double beyond(const Eigen::Vector2d &across, const Rims &rims, const PlanePoint &point)
{
  const BlurredEdge border = beyondBorder(across, point);
  return (rims.outer.share - rims.inner.share) * border.share + together(rims.outer, border) -
         together(rims.inner, border);
}

// Black of the ring that a pixel sees.
double ringAt(const vpCircleMarkerLayout &layout, const PlanePoint &point)
{
  const double inner = layout.ringInner > 0. ? insideOf(layout.ringInner, point).share : 0.;
  return insideOf(1., point).share - inner;
}

// The sectors that a pixel sees, by the edges between them, each on its own.
SeenSectors seenByEdges(const CodePixel &pixel, const vpCircleMarkerLayout &layout, const SectorBorders &borders)
{
  SeenSectors seen;
  const PlanePoint &point = pixel.point;
  const int own = static_cast<int>(std::floor(borders.place(pixel.angle)));
  const double blur = point.byPixel.norm() / std::max(point.q.norm(), layout.codeInner); // rad, at most
  const int wide = std::clamp(static_cast<int>(std::ceil(borders.inSectors(reach * blur))), 1, mostReach);
  seen.count = 2 * wide + 1;
  double from = beyond(borders.across(own - wide), pixel.rims, point);
  for (int k = 0; k < seen.count; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const double to = beyond(borders.across(own - wide + k + 1), pixel.rims, point);
    seen.numbers[i] = borders.sector(own - wide + k);
    seen.weights[i] = from - to;
    from = to;
  }
  return seen;
}

// And along lines.
SeenSectors seenAlongLines(const TrackPiece *pieces, std::size_t pieceCount, const SectorBorders &borders)
{
  SectorVector shares = SectorVector::Zero();
  std::for_each_n(pieces, pieceCount, [&](const TrackPiece &piece) { addSectors(piece, borders, shares); });
  SeenSectors seen;
  for (int sector = 0; sector < borders.count(); ++sector) {
    if (shares[sector] > leastShare) {
      seen.numbers[static_cast<std::size_t>(seen.count)] = sector;
      seen.weights[static_cast<std::size_t>(seen.count++)] = shares[sector];
    }
  }
  return seen;
}

// What a pixel shows, and how much ink would take of it.
struct SeenLight
{
  double share;     // of the grey level of white paper
  double mostTold;  // greatest share that the sensor can tell
  double contrast;  // grey levels
  bool isTooBright; // whether the share is wrong by more than a little, because the sensor cannot tell it
};

// What the ground beyond the quiet zone does to the grey levels of pixels that see it: of an ellipse that is 6 pixels
// wide the ground is seen from the code track. By its measured pose, light and ends of the paper (grey_model.h).
class SeenGround
{
public:
  SeenGround(const MeasuredView &view, const vpCircleMarkerLayout &layout)
      : m_view(view), m_papers(placedAt(papersAround(layout), view.fit.photometry.paper)),
        m_surrounds{{{view.I, view.camera, view.fit.plane, m_papers[0], view.fit.photometry.blur.widest()},
                     {view.I, view.camera, view.fit.plane, m_papers[1], view.fit.photometry.blur.widest()}}}
  {
  }

  // Grey levels by which a pixel is brighter than if the paper went on, as it does where the image ends. point: in
  // units of the blur; white: grey level of white paper there.
  double brightens(const PlanePoint &point, double white)
  {
    if (point.q.norm() < m_papers[0].extent - clearOfSurround * point.byPixel.norm()) {
      return 0.;
    }
    const unsigned int direction = Surround::directionOf(point.q);
    double more = 0.;
    for (std::size_t shape = 0; shape < paperShapes; ++shape) {
      const Ground &ground = m_surrounds[shape].toward(direction);
      if (std::isfinite(ground.spread)) {
        more += m_view.fit.photometry.surround[shape] * shareBeyond(point, m_papers[shape], 1.).share *
                (ground.grey - white);
      }
    }
    return more;
  }

private:
  const MeasuredView &m_view;
  const PaperEnds m_papers;
  std::array<Surround, paperShapes> m_surrounds;
};

// Takes pixels into the image of a code.
class CodePixels
{
public:
  CodePixels(const MeasuredView &view, const vpCircleMarkerLayout &layout, int sectors, CodeImage &track)
      : m_view(view), m_photometry(view.fit.photometry), m_layout(layout), m_sectors(sectors), m_track(track),
        m_blur(m_photometry.blur.sigma * m_photometry.blur.shape()), m_ground(view, layout)
  {
    m_track.pixels.clear();
    m_track.pieces.clear();
    m_track.isOverExposed = false;
  }

  // A pixel, which is taken if it sees the track; false if there is no light on it.
  bool add(const Eigen::Vector2d &pixel, double grey)
  {
    PlanePoint point = planePoint({m_view.camera.toMeter(pixel), m_view.camera.meterPerPixel(pixel)}, m_view.fit.plane);
    point.byPixel = point.byPixel * m_blur;
    const Rims rims = {insideOf(m_layout.codeOuter, point), insideOf(m_layout.codeInner, point)};
    const bool isByLines = wantsLines(point, m_layout, m_sectors);
    if (rims.outer.distance < -around || (rims.inner.distance > around && !isByLines)) {
      return true;
    }
    const auto light = lightOf(pixel, point, grey);
    if (!light) {
      return false;
    }
    const std::size_t begin = m_track.pieces.size();
    const double ring = isByLines ? cutLines(point, m_layout, m_track.pieces) : ringAt(m_layout, point);
    if (isByLines && m_track.pieces.size() == begin) {
      return true; // sees nothing of the track
    }
    const double leastTold = light->mostTold < 1. ? m_photometry.blackOf(light->mostTold) - ring : -HUGE_VAL;
    m_track.pixels.push_back({point, rims, std::atan2(point.q.y(), point.q.x()),
                              m_photometry.blackOf(light->share) - ring, leastTold, begin, m_track.pieces.size()});
    m_track.isOverExposed |= light->isTooBright;
    m_squaredContrast += light->contrast * light->contrast;
    return true;
  }

  // Root mean square over the pixels, grey levels.
  double contrast() const { return std::sqrt(m_squaredContrast / static_cast<double>(m_track.pixels.size())); }

private:
  // Nothing where there is none.
  std::optional<SeenLight> lightOf(const Eigen::Vector2d &pixel, const PlanePoint &point, double grey)
  {
    const double light = m_view.whiteAt(pixel);
    const double contrast = light * m_photometry.contrast();
    if (contrast <= 0.) {
      return std::nullopt;
    }
    const double brightest = m_view.inEvenLight(pixel, brightestTold);
    const bool isHidden = light > brightest && mayBeTooBright(grey);
    const double onPaper = (isHidden ? light : m_view.inEvenLight(pixel, grey)) - m_ground.brightens(point, light);
    return SeenLight{onPaper / light, brightest / light, contrast,
                     isHidden && light - brightest > mostHidden * contrast};
  }

  const MeasuredView &m_view;
  const Photometry &m_photometry;
  const vpCircleMarkerLayout &m_layout;
  const int m_sectors;
  CodeImage &m_track;
  const Eigen::Matrix2d m_blur;
  SeenGround m_ground;
  double m_squaredContrast = 0.;
};
} // namespace

bool lookAtCode(const MeasuredView &view, const vpCircleMarkerLayout &layout, int sectors, CodeImage &track)
{
  const vpImage<unsigned char> &I = view.I;
  constexpr int directions = 16;
  const auto [least, most] = boundsOfCircle(view.fit.plane, view.camera, layout.codeOuter, directions);
  const double margin = around * view.fit.photometry.blur.widest() + 1.;
  const bool isInside = least.x() >= margin && least.y() >= margin && most.x() <= I.getWidth() - 1. - margin &&
                        most.y() <= I.getHeight() - 1. - margin;
  if (!isInside) {
    return false;
  }
  CodePixels pixels(view, layout, sectors, track);
  const auto left = static_cast<unsigned int>(least.x() - margin);
  const auto top = static_cast<unsigned int>(least.y() - margin);
  const unsigned int right = std::min(static_cast<unsigned int>(most.x() + margin) + 1, I.getWidth() - 1);
  const unsigned int bottom = std::min(static_cast<unsigned int>(most.y() + margin) + 1, I.getHeight() - 1);
  for (unsigned int v = top; v <= bottom; ++v) {
    for (unsigned int u = left; u <= right; ++u) {
      if (!pixels.add(Eigen::Vector2d(u, v), I[v][u])) {
        return false;
      }
    }
  }
  if (track.pixels.empty()) {
    return false;
  }
  track.noise = std::hypot(view.fit.noise / pixels.contrast(), modelError);
  return true;
}

SeenSectors sectorsSeenBy(const CodePixel &pixel, const CodeImage &track, const vpCircleMarkerLayout &layout,
                          const SectorBorders &borders)
{
  return pixel.begin == pixel.end ? seenByEdges(pixel, layout, borders)
                                  : seenAlongLines(&track.pieces[pixel.begin], pixel.end - pixel.begin, borders);
}

Squares squaresOf(const CodeImage &track, const vpCircleMarkerLayout &layout, int sectors, double start)
{
  Squares result;
  const SectorBorders borders(sectors, start);
  for (const CodePixel &pixel : track.pixels) {
    const SeenSectors seen = sectorsSeenBy(pixel, track, layout, borders);
    for (int i = 0; i < seen.count; ++i) {
      const auto a = static_cast<std::size_t>(i);
      result.right[seen.numbers[a]] += seen.weights[a] * pixel.black;
      for (int j = 0; j < seen.count; ++j) {
        const auto b = static_cast<std::size_t>(j);
        result.matrix(seen.numbers[a], seen.numbers[b]) += seen.weights[a] * seen.weights[b];
      }
    }
    result.squares += pixel.black * pixel.black;
  }
  return result;
}
} // namespace circle_marker
END_VISP_NAMESPACE
