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
 * Whether the image shows a plain ring or disc all around.
 */

#include "decode/shape_evidence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "decode/marker_light.h"
#include "support/bilinear.h"
#include "support/normal_distribution.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Directions that are looked at: one for each pixel around the smallest ring.
constexpr std::size_t directions = 32;
// Share of them in which the shape must show: all but one. The leg of a P covers three.
constexpr double leastShare = 0.96;
// A direction shows it if its step is at least this share of what the median contrast makes there: noise of an eighth
// of the contrast, four times over.
constexpr double leastStep = 0.5;
// Blur of an interpolated sample, pixels: as for the code track.
constexpr double assumedBlur = 0.85;
// Where less than twice this share of the contrast is to be expected of the outer step, its absence does not tell:
// noise of 2 % of the contrast, and the outline off by a tenth of a pixel, make as much.
constexpr double stepInDoubt = 0.1;
// Where less than this share of the contrast is to be expected, noise is not enlarged to tell it.
constexpr double leastExpected = 0.1;
// Where white is read in the quiet zone, and the inside of a ring, of its inner radius, and of a disc: past most of the
// blur, as far from the edge as the print allows.
constexpr double whiteOfQuietZone = 0.6;
constexpr double insideOfRing = 0.65;
constexpr double rimOfDisc = 0.8;
constexpr double insideOfDisc = 0.4;
// Ink and paper lose the same share of their light in a shadow, to this factor; a dark thing beside a ring does not
// darken its ink.
constexpr double sameShare = 2.;
// Half of the width of a shadow's edge, pixels: penumbra and blur. Directions that it touches are not asked, as long as
// this share of all is left.
constexpr double edgeOfShadow = 2.5;
constexpr double leastAsked = 0.6;
// Light that falls off evenly leaves this share of that at the centre on the dark side: nine tenths of the bright
// side's is gone.
constexpr double leastLight = 0.15;

using Greys = std::array<double, directions>;

// Grey levels along a circle of the marker's plane; false if it reaches out of the image.
bool sampleCircle(const vpImage<unsigned char> &I, const CameraModel &camera, const MarkerPlane &plane, double radius,
                  Greys &greys)
{
  for (std::size_t i = 0; i < directions; ++i) {
    const double angle = 2. * M_PI * static_cast<double>(i) / directions;
    const Eigen::Vector2d point = radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    const auto grey = bilinear(I, camera.toPixel(plane.project(point)));
    if (!grey) {
      return false;
    }
    greys[i] = *grey;
  }
  return true;
}

double median(Greys greys)
{
  std::nth_element(greys.begin(), greys.begin() + directions / 2, greys.end());
  return greys[directions / 2];
}

/*! A ring's or disc's profile across its rim as it is printed, 1 for white and 0 for black, and as the blur leaves it.
 */
struct Profile
{
  double ringInner;
  double quietZone;

  // Grey level at a radius; blur in units of the outer radius; surround: what lies beyond the quiet zone, unknown.
  double at(double radius, double blur, double surround) const
  {
    const NormalDistribution &normal = NormalDistribution::instance();
    const double uptoInner = ringInner > 0. ? normal.at((ringInner - radius) / blur).cumulative : 0.;
    const double uptoOuter = normal.at((1. - radius) / blur).cumulative;
    const double uptoMargin = normal.at((1. + quietZone - radius) / blur).cumulative;
    return uptoInner + (uptoMargin - uptoOuter) + surround * (1. - uptoMargin);
  }
};

Eigen::Vector2d onCircle(double radius, std::size_t direction)
{
  const double angle = 2. * M_PI * static_cast<double>(direction) / directions;
  return radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
}

// Whether the dark side of the light around is a shadow: the ring's ink is darker there, too.
bool isShadow(const MarkerLight &light, const Greys &dark, double darkRadius)
{
  double lit = 0.;
  double shaded = 0.;
  double inLight = 0.;
  double inShadow = 0.;
  for (std::size_t i = 0; i < directions; ++i) {
    const bool isLit = light.distanceToShadow(onCircle(darkRadius, i)) > 0.;
    (isLit ? lit : shaded) += dark[i];
    (isLit ? inLight : inShadow) += 1.;
  }
  return inLight > 0. && inShadow > 0. &&
         shaded * light.getBright() * inLight < sameShare * lit * light.getDark() * inShadow;
}

// Fall-off of the light in one direction: its slope over the outer radius, in units of the light at the centre, from
// greys of the paper along a circle.
Eigen::Vector2d slopeOfLight(const Greys &paper, double radius)
{
  double mean = 0.;
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < directions; ++i) {
    mean += paper[i] / directions;
    slope += 2. * paper[i] / (directions * radius) * onCircle(1., i);
  }
  return slope / std::max(mean, 1.);
}

// Pixels for a unit of the radius across the marker's outline at a direction from its centre. Along that direction they
// are more where the image is an elongated ellipse: the way out crosses its edge at a slant, and the blur does not.
double pixelsPerUnit(const CameraModel &camera, const MarkerPlane &plane, std::size_t direction)
{
  constexpr double step = 0.1; // of the radius, to either side: a secant short enough to be a tangent
  const double angle = 2. * M_PI * static_cast<double>(direction) / directions;
  const Eigen::Vector2d out(std::cos(angle), std::sin(angle));
  const Eigen::Vector2d along(-out.y(), out.x());
  const auto secant = [&](const Eigen::Vector2d &way) {
    return Eigen::Vector2d(camera.toPixel(plane.project(out + step * way)) -
                           camera.toPixel(plane.project(out - step * way)));
  };
  const Eigen::Vector2d radial = secant(out);
  const Eigen::Vector2d tangent = secant(along).normalized();
  return std::abs(radial.x() * tangent.y() - radial.y() * tangent.x()) / (2. * step);
}
} // namespace

bool hasShapeAllAround(const vpImage<unsigned char> &I, const CameraModel &camera, const MarkerPlane &plane,
                       const vpCircleMarkerLayout &layout, double ringInner)
{
  const bool isDisc = ringInner == 0.;
  const double whiteRadius = 1. + whiteOfQuietZone * layout.quietZone;
  const double darkRadius = isDisc ? rimOfDisc : 0.5 * (1. + ringInner);
  const double insideRadius = isDisc ? insideOfDisc : insideOfRing * ringInner;
  Greys outside;
  Greys dark;
  Greys inside;
  if (!sampleCircle(I, camera, plane, whiteRadius, outside) || !sampleCircle(I, camera, plane, darkRadius, dark) ||
      !sampleCircle(I, camera, plane, insideRadius, inside)) {
    return false;
  }
  const MarkerLight light(outside.data(), directions, whiteRadius, 0.);
  const bool hasShadow = light.hasShadow() && isShadow(light, dark, darkRadius);
  std::array<bool, directions> isAsked;
  isAsked.fill(true);
  const std::array<std::pair<Greys *, double>, 3> circles = {
      {{&outside, whiteRadius}, {&dark, darkRadius}, {&inside, insideRadius}}};
  if (hasShadow) { // all as it would be in the light
    for (std::size_t i = 0; i < directions; ++i) {
      const double edge = edgeOfShadow / pixelsPerUnit(camera, plane, i);
      for (const auto &[greys, radius] : circles) {
        const Eigen::Vector2d place = onCircle(radius, i);
        (*greys)[i] *= light.getBright() / std::max(light.at(place), 1.);
        isAsked[i] = isAsked[i] && std::abs(light.distanceToShadow(place)) > edge;
      }
    }
  }
  else {
    const Eigen::Vector2d slope = isDisc ? slopeOfLight(outside, whiteRadius) : slopeOfLight(inside, insideRadius);
    for (const auto &[greys, radius] : circles) {
      for (std::size_t i = 0; i < directions; ++i) {
        (*greys)[i] /= std::max(1. + slope.dot(onCircle(radius, i)), leastLight);
      }
    }
  }
  const Profile profile = {ringInner, layout.quietZone};
  Greys expectedOuter; // with a surround as black as the ink: less it cannot be
  Greys contrast;
  for (std::size_t i = 0; i < directions; ++i) {
    const double blur = assumedBlur / pixelsPerUnit(camera, plane, i);
    expectedOuter[i] = profile.at(whiteRadius, blur, 0.) - profile.at(darkRadius, blur, 0.);
    // A ring's contrast is told by its inner step, which the surround hardly reaches; a disc has the outer one alone.
    const double expected =
        isDisc ? expectedOuter[i] : profile.at(insideRadius, blur, 0.5) - profile.at(darkRadius, blur, 0.5);
    contrast[i] = (isDisc ? outside[i] - dark[i] : inside[i] - dark[i]) / std::max(expected, leastExpected);
  }
  const double usual = median(contrast);
  if (usual <= 0.) {
    return false;
  }
  std::size_t shown = 0;
  std::size_t asked = 0;
  for (std::size_t i = 0; i < directions; ++i) {
    if (!isAsked[i]) {
      continue;
    }
    ++asked;
    const double outerStep = outside[i] - (isDisc ? inside[i] : dark[i]);
    const double leastOuter = std::min(leastStep * expectedOuter[i], expectedOuter[i] - stepInDoubt);
    shown += contrast[i] >= leastStep * usual && outerStep >= leastOuter * usual ? 1 : 0;
  }
  return static_cast<double>(shown) >= leastShare * static_cast<double>(asked) &&
         static_cast<double>(asked) >= leastAsked * directions;
}
} // namespace circle_marker
END_VISP_NAMESPACE
