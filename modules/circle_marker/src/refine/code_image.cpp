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
// Where paper is brighter than this, grey levels, a pixel that is as well cannot be told from brighter. It is taken for
// white if by that it is wrong by no more than this share of the contrast.
constexpr double brightest = 254.;
constexpr double mostHidden = 0.1;

constexpr double fullTurn = 2. * M_PI;

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

// The sectors that a pixel sees.
struct SeenSectors
{
  std::array<int, mostSectors> numbers;
  std::array<double, mostSectors> weights; // shares of the pixel
  int count = 0;

  // By the edges between them, each on its own.
  void set(const CodePixel &pixel, const vpCircleMarkerLayout &layout, const SectorBorders &borders)
  {
    const PlanePoint &point = pixel.point;
    const int own = static_cast<int>(std::floor(borders.place(pixel.angle)));
    const double blur = point.byPixel.norm() / std::max(point.q.norm(), layout.codeInner); // rad, at most
    const int wide = std::clamp(static_cast<int>(std::ceil(borders.inSectors(reach * blur))), 1, mostReach);
    count = 2 * wide + 1;
    double from = beyond(borders.across(own - wide), pixel.rims, point);
    for (int k = 0; k < count; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const double to = beyond(borders.across(own - wide + k + 1), pixel.rims, point);
      numbers[i] = borders.sector(own - wide + k);
      weights[i] = from - to;
      from = to;
    }
  }

  // Along lines.
  void set(const TrackPiece *pieces, std::size_t pieceCount, const SectorBorders &borders)
  {
    SectorVector shares = SectorVector::Zero();
    std::for_each_n(pieces, pieceCount, [&](const TrackPiece &piece) { addSectors(piece, borders, shares); });
    count = 0;
    for (int sector = 0; sector < borders.count(); ++sector) {
      if (shares[sector] > leastShare) {
        numbers[static_cast<std::size_t>(count)] = sector;
        weights[static_cast<std::size_t>(count++)] = shares[sector];
      }
    }
  }
};
} // namespace

bool lookAtCode(const vpImage<unsigned char> &I, const CameraModel &camera, const FittedPose &fit,
                const ImageFrame &frame, const vpCircleMarkerLayout &layout, int sectors, CodeImage &track)
{
  const Photometry &photometry = fit.photometry;
  if (photometry.shadow) {
    return false;
  }
  const Eigen::Matrix2d blur = photometry.blur.sigma * photometry.blur.shape();
  Eigen::Vector2d least(HUGE_VAL, HUGE_VAL), most(-HUGE_VAL, -HUGE_VAL);
  for (int k = 0; k < 16; ++k) {
    const double angle = fullTurn * k / 16;
    const Eigen::Vector2d p =
        camera.toPixel(fit.plane.project(layout.codeOuter * Eigen::Vector2d(std::cos(angle), std::sin(angle))));
    least = least.cwiseMin(p);
    most = most.cwiseMax(p);
  }
  const double margin = around * photometry.blur.widest() + 1.;
  if (least.minCoeff() < margin || most.x() > I.getWidth() - 1. - margin || most.y() > I.getHeight() - 1. - margin) {
    return false;
  }
  track.pixels.clear();
  track.pieces.clear();
  double squaredContrast = 0.;
  for (int v = static_cast<int>(least.y() - margin); v <= static_cast<int>(most.y() + margin) + 1; ++v) {
    for (int u = static_cast<int>(least.x() - margin); u <= static_cast<int>(most.x() + margin) + 1; ++u) {
      if (u < 0 || v < 0 || u >= static_cast<int>(I.getWidth()) || v >= static_cast<int>(I.getHeight())) {
        continue;
      }
      const Eigen::Vector2d p(u, v);
      PlanePoint point = planePoint({camera.toMeter(p), camera.meterPerPixel(p)}, fit.plane);
      point.byPixel = point.byPixel * blur;
      const Rims rims = {insideOf(layout.codeOuter, point), insideOf(layout.codeInner, point)};
      const bool isByLines = wantsLines(point, layout, sectors);
      if (rims.outer.distance < -around || (rims.inner.distance > around && !isByLines)) {
        continue;
      }
      const Eigen::Vector2d offset = (p - frame.center) / frame.size;
      const double light = photometry.whiteAt(offset);
      const double contrast = light * photometry.contrast();
      double grey = I[static_cast<unsigned int>(v)][static_cast<unsigned int>(u)];
      const bool isHidden = light > brightest && grey > brightest;
      if (contrast <= 0. || (isHidden && light - brightest > mostHidden * contrast)) {
        return false;
      }
      grey = isHidden ? light : grey;
      const std::size_t begin = track.pieces.size();
      const double ring = isByLines ? cutLines(point, layout, track.pieces) : ringAt(layout, point);
      if (isByLines && track.pieces.size() == begin) {
        continue; // sees nothing of the track
      }
      track.pixels.push_back({point, rims, std::atan2(point.q.y(), point.q.x()),
                              photometry.blackOf(grey / light) - ring, begin, track.pieces.size()});
      squaredContrast += contrast * contrast;
    }
  }
  if (track.pixels.empty()) {
    return false;
  }
  const double contrast = std::sqrt(squaredContrast / static_cast<double>(track.pixels.size()));
  track.noise = std::hypot(fit.noise / contrast, modelError);
  return true;
}

Squares squaresOf(const CodeImage &track, const vpCircleMarkerLayout &layout, int sectors, double start)
{
  Squares result;
  const SectorBorders borders(sectors, start);
  SeenSectors seen;
  for (const CodePixel &pixel : track.pixels) {
    if (pixel.begin == pixel.end) {
      seen.set(pixel, layout, borders);
    }
    else {
      seen.set(&track.pieces[pixel.begin], pixel.end - pixel.begin, borders);
    }
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
