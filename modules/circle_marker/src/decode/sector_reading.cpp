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
 * Grey levels of the sectors of a marker's code track.
 */

#include "decode/sector_reading.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "decode/marker_light.h"
#include "support/bilinear.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// The white centre is brighter than the ring by this share of the contrast at least: a ring of 17 pixels at 60 degrees
// keeps nine tenths after the blur, while a dark blob taken for a marker is darkest there.
constexpr double leastCenter = 0.2;
// Least contrast of the ring, grey levels.
constexpr double leastContrast = 6.;
// Half of the width of a shadow's edge, in units of the blur, and what a sample on it counts.
constexpr double edgeOfShadow = 2.;
constexpr double weightOnShadow = 0.1;

std::optional<double> sampleAt(const vpImage<unsigned char> &I, const CameraModel &camera, const MarkerPlane &plane,
                               double radius, double c, double s)
{
  return bilinear(I, camera.toPixel(plane.project(Eigen::Vector2d(radius * c, radius * s))));
}

// A few samples that have to agree with a black ring between white and white: what most outlines in clutter fail.
vpCircleMarkerReject judgeRing(const vpImage<unsigned char> &I, const CameraModel &camera, const MarkerPlane &plane,
                               const vpCircleMarkerLayout &layout)
{
  constexpr int directions = 16;
  double white = 0.;
  double black = 0.;
  for (int i = 0; i < directions; ++i) {
    const double angle = 2. * M_PI * i / directions;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const auto outside = sampleAt(I, camera, plane, radiusOfWhite(layout.quietZone), c, s);
    const auto ring = sampleAt(I, camera, plane, 0.5 * (1. + layout.ringInner), c, s);
    if (!outside || !ring) {
      return vpCircleMarkerReject::OUT_OF_IMAGE;
    }
    white += *outside / directions;
    black += *ring / directions;
  }
  const auto center = bilinear(I, camera.toPixel(plane.project(Eigen::Vector2d::Zero())));
  const bool isRing = white - black >= leastContrast && center && *center - black >= leastCenter * (white - black);
  return isRing ? vpCircleMarkerReject::NONE : vpCircleMarkerReject::NO_RING;
}

Judged<CodeTrack> sampleTrack(const vpImage<unsigned char> &I, const CameraModel &camera, const MarkerPlane &plane,
                              const vpCircleMarkerFamily &family)
{
  const vpCircleMarkerLayout &layout = family.getLayout();
  const double width = layout.codeOuter - layout.codeInner;
  // The middle half of the track: its rims are blurred into the white beside.
  const double radii[3] = {layout.codeInner + 0.3 * width, layout.codeInner + 0.5 * width,
                           layout.codeInner + 0.7 * width};
  const double whiteRadius = radiusOfWhite(layout.quietZone);
  const double blackRadius = 0.5 * (1. + layout.ringInner);
  CodeTrack track;
  track.samples = samplesPerSector * family.getNbSectors();
  track.weight.fill(1.);
  // The light is known by the white of the quiet zone around.
  std::array<double, mostSamples> outside;
  std::array<double, mostSamples> ring;
  std::array<Eigen::Vector2d, mostSamples> direction;
  const double step = 0.02; // rad: a secant short enough to be a tangent
  const Eigen::Rotation2Dd turn(step);
  for (unsigned int i = 0; i < track.samples; ++i) {
    const double angle = 2. * M_PI * (i + 0.5) / track.samples;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    direction[i] << c, s;
    double sum = 0.;
    for (const double radius : radii) {
      const auto grey = sampleAt(I, camera, plane, radius, c, s);
      if (!grey) {
        return vpCircleMarkerReject::OUT_OF_IMAGE;
      }
      sum += *grey / 3.;
    }
    track.grey[i] = sum;
    const auto white = sampleAt(I, camera, plane, whiteRadius, c, s);
    const auto black = sampleAt(I, camera, plane, blackRadius, c, s);
    if (!white || !black) {
      return vpCircleMarkerReject::OUT_OF_IMAGE;
    }
    outside[i] = *white;
    ring[i] = *black;
    // Angle for a pixel along the track at its middle radius.
    const Eigen::Vector2d middle = radii[1] * direction[i];
    const Eigen::Vector2d before = camera.toPixel(plane.project(turn.inverse() * middle));
    const Eigen::Vector2d after = camera.toPixel(plane.project(turn * middle));
    track.blur[i] = trackBlur * 2. * step / (after - before).norm();
  }
  const MarkerLight light(outside.data(), track.samples, whiteRadius);
  const double white = light.mean();
  double black = 0.; // as it would be in mean light, which multiplies white and black alike
  for (unsigned int i = 0; i < track.samples; ++i) {
    const double here = light.hasShadow() ? std::max(light.at(blackRadius * direction[i]), 1.) : white;
    black += ring[i] * white / (here * track.samples);
  }
  if (white - black < leastContrast) {
    return vpCircleMarkerReject::NO_RING;
  }
  for (unsigned int i = 0; i < track.samples; ++i) {
    const Eigen::Vector2d place = radii[1] * direction[i];
    track.grey[i] = (track.grey[i] * white / std::max(light.at(place), 1.) - black) / (white - black);
    // On the edge of a shadow the light is not known.
    if (light.hasShadow() && std::abs(light.distanceToShadow(place)) < edgeOfShadow * track.blur[i] * radii[1]) {
      track.weight[i] = weightOnShadow;
    }
  }
  return track;
}

} // namespace

Judged<SectorReading> readSectors(const vpImage<unsigned char> &I, const CameraModel &camera, const MarkerPlane &plane,
                                  const vpCircleMarkerFamily &family)
{
  const vpCircleMarkerReject ring = judgeRing(I, camera, plane, family.getLayout());
  if (ring != vpCircleMarkerReject::NONE) {
    return ring;
  }
  const Judged<CodeTrack> track = sampleTrack(I, camera, plane, family);
  if (!track) {
    return track.reason();
  }
  const auto sectors = solveTrack(*track, family.getNbSectors());
  return sectors ? Judged<SectorReading>(*sectors) : vpCircleMarkerReject::NO_SECTORS;
}
} // namespace circle_marker
END_VISP_NAMESPACE
