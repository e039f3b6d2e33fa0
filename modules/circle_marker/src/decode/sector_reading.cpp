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

// Radii at which a marker is looked at, in units of its outer radius.
struct Radii
{
  explicit Radii(const vpCircleMarkerLayout &layout)
      : white(radiusOfWhite(layout.quietZone)), black(0.5 * (1. + layout.ringInner))
  {
    // The middle half of the track: its rims are blurred into the white beside.
    const double width = layout.codeOuter - layout.codeInner;
    track = {layout.codeInner + 0.3 * width, layout.codeInner + 0.5 * width, layout.codeInner + 0.7 * width};
  }

  double white;                // in the quiet zone
  double black;                // in the ring
  std::array<double, 3> track; // from the inside
};

// A few samples that have to agree with a black ring between white and white: what most outlines in clutter fail.
vpCircleMarkerReject judgeRing(const vpImage<unsigned char> &I, const CameraModel &camera, const MarkerPlane &plane,
                               const Radii &radii)
{
  constexpr int directions = 16;
  double white = 0.;
  double black = 0.;
  for (int i = 0; i < directions; ++i) {
    const double angle = 2. * M_PI * i / directions;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const auto outside = sampleAt(I, camera, plane, radii.white, c, s);
    const auto ring = sampleAt(I, camera, plane, radii.black, c, s);
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

// A code track with what tells the light on it, all in the same directions.
struct SampledTrack
{
  CodeTrack code;
  std::array<double, mostSamples> white; // of the quiet zone, grey levels
  std::array<double, mostSamples> black; // of the ring
  std::array<Eigen::Vector2d, mostSamples> direction;
};

// Blur along the track at a place on it, rad.
double blurAlong(const CameraModel &camera, const MarkerPlane &plane, const Eigen::Vector2d &place)
{
  constexpr double step = 0.02; // rad: a secant short enough to be a tangent
  const Eigen::Rotation2Dd turn(step);
  const Eigen::Vector2d before = camera.toPixel(plane.project(turn.inverse() * place));
  const Eigen::Vector2d after = camera.toPixel(plane.project(turn * place));
  return trackBlur * 2. * step / (after - before).norm();
}

// The grey levels as they are in the image; false if a sample lies outside of it.
bool sampleGreys(const vpImage<unsigned char> &I, const CameraModel &camera, const MarkerPlane &plane,
                 const Radii &radii, SampledTrack &sampled)
{
  CodeTrack &track = sampled.code;
  for (unsigned int i = 0; i < track.samples; ++i) {
    const double angle = 2. * M_PI * (i + 0.5) / track.samples;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    double sum = 0.;
    for (const double radius : radii.track) {
      const auto grey = sampleAt(I, camera, plane, radius, c, s);
      if (!grey) {
        return false;
      }
      sum += *grey / 3.;
    }
    const auto white = sampleAt(I, camera, plane, radii.white, c, s);
    const auto black = sampleAt(I, camera, plane, radii.black, c, s);
    if (!white || !black) {
      return false;
    }
    track.grey[i] = sum;
    sampled.white[i] = *white;
    sampled.black[i] = *black;
    sampled.direction[i] << c, s;
    track.blur[i] = blurAlong(camera, plane, radii.track[1] * sampled.direction[i]);
  }
  return true;
}

// Makes reflectances of the grey levels, by the white of the quiet zone around; false if black and white are much the
// same.
bool undoLight(const Radii &radii, SampledTrack &sampled)
{
  CodeTrack &track = sampled.code;
  const MarkerLight light(sampled.white.data(), track.samples, radii.white);
  const double white = light.mean();
  double black = 0.; // as it would be in mean light, which multiplies white and black alike
  for (unsigned int i = 0; i < track.samples; ++i) {
    const double here = light.hasShadow() ? std::max(light.at(radii.black * sampled.direction[i]), 1.) : white;
    black += sampled.black[i] * white / (here * track.samples);
  }
  if (white - black < leastContrast) {
    return false;
  }
  for (unsigned int i = 0; i < track.samples; ++i) {
    const Eigen::Vector2d place = radii.track[1] * sampled.direction[i];
    track.grey[i] = (track.grey[i] * white / std::max(light.at(place), 1.) - black) / (white - black);
    // On the edge of a shadow the light is not known.
    const double edge = edgeOfShadow * track.blur[i] * radii.track[1];
    track.weight[i] = light.hasShadow() && std::abs(light.distanceToShadow(place)) < edge ? weightOnShadow : 1.;
  }
  return true;
}
} // namespace

Judged<SectorReading> readSectors(const vpImage<unsigned char> &I, const CameraModel &camera, const MarkerPlane &plane,
                                  const vpCircleMarkerFamily &family)
{
  const Radii radii(family.getLayout());
  const vpCircleMarkerReject ring = judgeRing(I, camera, plane, radii);
  if (ring != vpCircleMarkerReject::NONE) {
    return ring;
  }
  SampledTrack sampled;
  sampled.code.samples = samplesPerSector * family.getNbSectors();
  if (!sampleGreys(I, camera, plane, radii, sampled)) {
    return vpCircleMarkerReject::OUT_OF_IMAGE;
  }
  if (!undoLight(radii, sampled)) {
    return vpCircleMarkerReject::NO_RING;
  }
  const auto sectors = solveTrack(sampled.code, family.getNbSectors());
  return sectors ? Judged<SectorReading>(*sectors) : vpCircleMarkerReject::NO_SECTORS;
}
} // namespace circle_marker
END_VISP_NAMESPACE
