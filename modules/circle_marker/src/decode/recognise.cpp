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
 * What marker an outline belongs to, before its pose is refined.
 */

#include "decode/recognise.h"

#include <algorithm>
#include <cmath>

#include "decode/radial_profile.h"
#include "decode/shape_evidence.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// The radial profile of a blurred thin ring keeps this share of the step across the outline.
constexpr double shareOfContrast = 0.3;
// A code cannot be read on a smaller semi-minor axis, pixels: its track would be less than a pixel wide there.
constexpr double leastCodeSemiMinor = 3.;
// Nor where the track has fewer pixels than sectors: what is read then is made of the blur's model, not of the image.
constexpr double leastSectorPixels = 1.;
// The smallest plain ring that is promised to be found has a minor axis of 8 pixels, whose blurred outline shrinks by
// up to 0.3; smaller ones have too many look-alikes.
constexpr double leastRingSemiMinor = 3.7;
// Share of the outline that must be seen where no code proves the marker.
constexpr double leastSupport = 0.75;
// A ring whose measured inner radius is this near to the family's own is taken for one of that family's ratio: by the
// steps of the profile, and by the blur of its inner edge in pixels, which matters on small rings.
constexpr double sameRatio = 0.03;
constexpr double sameRatioPixels = 0.8;

// Turns the second pose so that its x axis has the image direction of the first pose's x axis.
void copySpin(const MarkerPlane &from, MarkerPlane &to)
{
  const Eigen::Vector2d onTo = to.intersect(from.project(Eigen::Vector2d(1., 0.)));
  to.spin(std::atan2(onTo.y(), onTo.x()));
}

std::optional<Recognition> recogniseCode(const vpImage<unsigned char> &I, const CameraModel &camera,
                                         const PosePair &poses, const vpCircleMarkerFamily &family,
                                         const DecodeSettings &settings)
{
  std::array<std::optional<CodeReading>, 2> codes;
  for (std::size_t i = 0; i < 2; ++i) {
    if (const auto sectors = readSectors(I, camera, poses[i], family)) {
      codes[i] = identify(*sectors, family, settings);
    }
  }
  if (!codes[0] && !codes[1]) {
    return std::nullopt;
  }
  const std::size_t best = !codes[1] || (codes[0] && codes[0]->margin >= codes[1]->margin) ? 0 : 1;
  const std::size_t other = 1 - best;
  Recognition result;
  result.family = family;
  result.code = *codes[best];
  result.ringInner = family.getLayout().ringInner;
  result.poses = poses;
  result.poses[best].spin(codes[best]->spin);
  if (codes[other] && codes[other]->id == codes[best]->id) {
    result.poses[other].spin(codes[other]->spin);
  }
  else {
    copySpin(result.poses[best], result.poses[other]);
  }
  return result;
}

std::optional<Recognition> recogniseShape(const vpImage<unsigned char> &I, const CameraModel &camera,
                                          const PosePair &poses, const EllipseCandidate &outline,
                                          const vpCircleMarkerFamily &family)
{
  const bool isSmallRing = family.getType() == vpCircleMarkerFamily::RING && outline.ellipse.b < leastRingSemiMinor;
  if (outline.support < leastSupport || isSmallRing) {
    return std::nullopt;
  }
  const auto profile = radialProfile(I, camera, poses[0]);
  if (!profile) {
    return std::nullopt;
  }
  const auto inner = innerRadius(*profile, shareOfContrast * outline.contrast);
  const bool isDisc = inner && *inner == 0.;
  if (!inner || isDisc != (family.getType() == vpCircleMarkerFamily::DISC)) {
    return std::nullopt;
  }
  Recognition result;
  result.family = family;
  result.code.margin = 1.;
  const double nominal = family.getLayout().ringInner;
  const double slack = sameRatio + sameRatioPixels / outline.ellipse.b;
  result.ringInner = std::abs(*inner - nominal) < slack ? nominal : *inner;
  if (!hasShapeAllAround(I, camera, poses[0], family.getLayout(), result.ringInner)) {
    return std::nullopt;
  }
  result.poses = poses;
  return result;
}
} // namespace

std::optional<Recognition> recognise(const vpImage<unsigned char> &I, const CameraModel &camera, const PosePair &poses,
                                     const EllipseCandidate &outline, const vpCircleMarkerFamily &family,
                                     const DecodeSettings &settings)
{
  if (!family.isCoded()) {
    return recogniseShape(I, camera, poses, outline, family);
  }
  const vpCircleMarkerLayout &layout = family.getLayout();
  const double trackPixels = M_PI * outline.ellipse.a * outline.ellipse.b *
                             (layout.codeOuter * layout.codeOuter - layout.codeInner * layout.codeInner);
  if (outline.ellipse.b < leastCodeSemiMinor || trackPixels < leastSectorPixels * family.getNbSectors()) {
    return std::nullopt;
  }
  return recogniseCode(I, camera, poses, family, settings);
}
} // namespace circle_marker
END_VISP_NAMESPACE
