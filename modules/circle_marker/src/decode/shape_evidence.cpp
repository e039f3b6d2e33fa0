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
#include <optional>

#include <Eigen/Cholesky>

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
// Blurs of an interpolated sample that are tried, pixels: as for the code track and more. With less, steps are larger
// than expected, which harms nothing; and on a thin ring little blur of grey ink looks like much of black.
constexpr double usualBlur = 0.85;
constexpr std::array<double, 3> blurs = {{usualBlur, 1.1, 1.4}};
// How far beyond the quiet zone its surround is looked at, pixels: most of the blur is over.
constexpr double lookBeyond = 1.5;
// Where less than twice this share of the contrast is to be expected of the outer step, its absence does not tell:
// noise of 2 % of the contrast, and the outline off by a sixth of a pixel, make as much.
constexpr double stepInDoubt = 0.15;
// Where the inside of a ring is read, of its inner radius, and a disc: past most of the blur, as far from the edge as
// the print allows.
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

Eigen::Vector2d onCircle(double radius, std::size_t direction)
{
  const double angle = 2. * M_PI * static_cast<double>(direction) / directions;
  return radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
}

/*! Grey levels along a circle of the marker's plane, radius in units of the outer one. */
struct Circle
{
  double radius;
  Greys greys;
};

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

/*! The outline of a marker, direction by direction. */
struct Outline
{
  Greys pixelsPerUnit; // see above
  Greys radius;        // of the true outline, in units of the radius of the one that was found

  // Grey level at a radius in one direction; nothing outside of the image.
  std::optional<double> sample(const vpImage<unsigned char> &I, const CameraModel &camera, const MarkerPlane &plane,
                               double at, std::size_t direction) const
  {
    return bilinear(I, camera.toPixel(plane.project(onCircle(radius[direction] * at, direction))));
  }
};

// Both edges of a thin ring are found farther apart than they are: the gradient of a dark line of width w has its
// extremes at sigma from its middle if w is nothing, at w / 2 if it is much; the fourth powers' sum is within 4 % of
// what is between.
Outline outlineOf(const CameraModel &camera, const MarkerPlane &plane, double ringInner)
{
  Outline outline;
  for (std::size_t i = 0; i < directions; ++i) {
    outline.pixelsPerUnit[i] = pixelsPerUnit(camera, plane, i);
    const double half = 0.5 * (1. - ringInner) * outline.pixelsPerUnit[i];
    const double found = std::pow(std::pow(half, 4.) + std::pow(usualBlur, 4.), 0.25);
    outline.radius[i] = ringInner > 0. ? 1. - (found - half) / outline.pixelsPerUnit[i] : 1.;
  }
  return outline;
}

// False if it reaches out of the image.
bool sampleCircle(const vpImage<unsigned char> &I, const CameraModel &camera, const MarkerPlane &plane,
                  const Outline &outline, Circle &circle)
{
  for (std::size_t i = 0; i < directions; ++i) {
    const auto grey = outline.sample(I, camera, plane, circle.radius, i);
    if (!grey) {
      return false;
    }
    circle.greys[i] = *grey;
  }
  return true;
}

// What a sample sees: shares of paper, ink and surround.
struct Shares
{
  double paper, ink, surround;
};

/*! A ring's or disc's profile across its rim as it is printed, and as the blur leaves it. */
struct Profile
{
  double ringInner;
  double quietZone;

  // At a radius; blur in units of the outer radius.
  Shares at(double radius, double blur) const
  {
    const NormalDistribution &normal = NormalDistribution::instance();
    const double uptoInner = ringInner > 0. ? normal.at((ringInner - radius) / blur).cumulative : 0.;
    const double uptoOuter = normal.at((1. - radius) / blur).cumulative;
    const double uptoMargin = normal.at((1. + quietZone - radius) / blur).cumulative;
    return {uptoInner + uptoMargin - uptoOuter, uptoOuter - uptoInner, 1. - uptoMargin};
  }
};

// Whether the dark side of the light around is a shadow: the ring's ink is darker there, too.
bool isShadow(const MarkerLight &light, const Circle &dark)
{
  double lit = 0.;
  double shaded = 0.;
  double inLight = 0.;
  double inShadow = 0.;
  for (std::size_t i = 0; i < directions; ++i) {
    const Eigen::Vector2d place = onCircle(dark.radius, i);
    const bool isLit = light.distanceToShadow(place) > 0.;
    (isLit ? lit : shaded) += dark.greys[i];
    (isLit ? inLight : inShadow) += light.at(place);
  }
  return inLight > 0. && inShadow > 0. && shaded * inLight < sameShare * lit * inShadow;
}

// Fall-off of the light in one direction: its slope over the outer radius, in units of the light at the centre, from
// greys of the paper along a circle.
Eigen::Vector2d slopeOfLight(const Circle &paper)
{
  double mean = 0.;
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < directions; ++i) {
    mean += paper.greys[i] / directions;
    slope += 2. * paper.greys[i] / (directions * paper.radius) * onCircle(1., i);
  }
  return slope / std::max(mean, 1.);
}

// Beyond the quiet zone. What is out of the image is taken for as dark as the ink.
Circle lookAround(const vpImage<unsigned char> &I, const CameraModel &camera, const MarkerPlane &plane,
                  const Outline &outline, double quietZone, const Circle &dark)
{
  Circle surround = {1. + quietZone, {}};
  for (std::size_t i = 0; i < directions; ++i) {
    const double radius = outline.radius[i] * surround.radius + lookBeyond / outline.pixelsPerUnit[i];
    const auto grey = bilinear(I, camera.toPixel(plane.project(onCircle(radius, i))));
    surround.greys[i] = grey ? *grey : dark.greys[i];
  }
  return surround;
}

/*! The print that explains the greys of all directions best. */
struct Print
{
  Profile profile;
  double blur; // pixels
  double paper, ink;

  // Grey level at a radius and direction.
  double at(double radius, std::size_t i, const Outline &outline, const Circle &surround) const
  {
    const Shares shares = profile.at(radius, blur / outline.pixelsPerUnit[i]);
    return shares.paper * paper + shares.ink * ink + shares.surround * surround.greys[i];
  }
};

// For each blur, paper and ink by linear least squares.
Print fitPrint(const Profile &profile, const std::array<const Circle *, 3> &circles, const Outline &outline,
               const Circle &surround)
{
  Print best = {profile, blurs[0], 0., 0.};
  double least = HUGE_VAL;
  for (const double blur : blurs) {
    Eigen::Matrix2d matrix = Eigen::Matrix2d::Zero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    double squares = 0.;
    for (const Circle *circle : circles) {
      for (std::size_t i = 0; i < directions; ++i) {
        const Shares shares = profile.at(circle->radius, blur / outline.pixelsPerUnit[i]);
        const Eigen::Vector2d row(shares.paper, shares.ink);
        const double grey = circle->greys[i] - shares.surround * surround.greys[i];
        matrix += row * row.transpose();
        right += grey * row;
        squares += grey * grey;
      }
    }
    const Eigen::Vector2d solution = matrix.ldlt().solve(right);
    const double left = squares - right.dot(solution);
    if (left < least) {
      least = left;
      best = {profile, blur, solution[0], solution[1]};
    }
  }
  return best;
}
} // namespace

bool hasDarkRing(const vpImage<unsigned char> &I, const CameraModel &camera, const MarkerPlane &plane)
{
  // Where a small ring is, whose outline is found up to a tenth of the radius too far out, and a larger one, which is
  // found where it is.
  constexpr double paperRadius = 1.04;
  constexpr double ringRadius = 0.85;
  constexpr double least = 0.3; // of the usual step
  // Directions that may have less; and where the marker is seen at more than 45 degrees: along the sides of its ellipse
  // the blur leaves little of a quiet zone before dark ground, or of the far side of the ring.
  constexpr std::size_t mostLess = 3;
  constexpr std::size_t mostLessAtSlant = 7;
  constexpr double slant = 0.7; // cosine
  Greys steps;
  for (std::size_t i = 0; i < directions; ++i) {
    const auto paper = bilinear(I, camera.toPixel(plane.project(onCircle(paperRadius, i))));
    const auto ring = bilinear(I, camera.toPixel(plane.project(onCircle(ringRadius, i))));
    if (!paper || !ring) {
      return false;
    }
    steps[i] = *paper - *ring;
  }
  std::sort(steps.begin(), steps.end());
  const double usual = steps[directions / 2];
  const bool isSlanted = std::abs(plane.foreshortening()) < slant;
  return usual > 0. && steps[isSlanted ? mostLessAtSlant : mostLess] > least * usual;
}

bool hasShapeAllAround(const vpImage<unsigned char> &I, const CameraModel &camera, const MarkerPlane &plane,
                       const vpCircleMarkerLayout &layout, double ringInner)
{
  const bool isDisc = ringInner == 0.;
  Circle outside = {radiusOfWhite(layout.quietZone), {}};
  Circle dark = {isDisc ? rimOfDisc : 0.5 * (1. + ringInner), {}};
  Circle inside = {isDisc ? insideOfDisc : insideOfRing * ringInner, {}};
  const Outline outline = outlineOf(camera, plane, ringInner);
  if (!sampleCircle(I, camera, plane, outline, dark) || !sampleCircle(I, camera, plane, outline, inside)) {
    return false;
  }
  std::array<bool, directions> isAsked;
  for (std::size_t i = 0; i < directions; ++i) {
    const auto grey = outline.sample(I, camera, plane, outside.radius, i);
    if (!grey && isDisc) {
      return false;
    }
    isAsked[i] = grey.has_value();
    outside.greys[i] = grey ? *grey : inside.greys[i]; // the quiet zone may end at the image's border
  }
  Circle surround = lookAround(I, camera, plane, outline, layout.quietZone, dark);
  const MarkerLight light(outside.greys.data(), directions, outside.radius, 0.);
  if (light.hasShadow() && isShadow(light, dark)) { // all as it would be in the light
    for (std::size_t i = 0; i < directions; ++i) {
      const double edge = edgeOfShadow / outline.pixelsPerUnit[i];
      for (Circle *circle : {&outside, &dark, &inside, &surround}) {
        const Eigen::Vector2d place = onCircle(circle->radius, i);
        circle->greys[i] *= light.litAt(Eigen::Vector2d::Zero()) / std::max(light.at(place), 1.);
        isAsked[i] = isAsked[i] && std::abs(light.distanceToShadow(place)) > edge;
      }
    }
  }
  else {
    const Eigen::Vector2d slope = slopeOfLight(isDisc ? outside : inside);
    for (Circle *circle : {&outside, &dark, &inside, &surround}) {
      for (std::size_t i = 0; i < directions; ++i) {
        circle->greys[i] /= std::max(1. + slope.dot(onCircle(circle->radius, i)), leastLight);
      }
    }
  }
  const Print print = fitPrint({ringInner, layout.quietZone}, {{&outside, &dark, &inside}}, outline, surround);
  const double contrast = print.paper - print.ink;
  if (contrast <= 0.) {
    return false;
  }
  // Of the surround a single look is not much: it is expected to be as dark as the ink at least.
  for (double &grey : surround.greys) {
    grey = std::min(grey, print.ink);
  }
  // Whether the step from the second circle to the first one is there.
  const auto shows = [&](const Circle &white, const Circle &black, std::size_t i) {
    const double expected = print.at(white.radius, i, outline, surround) - print.at(black.radius, i, outline, surround);
    return white.greys[i] - black.greys[i] >= std::min(leastStep * expected, expected - stepInDoubt * contrast);
  };
  std::size_t shown = 0;
  std::size_t asked = 0;
  for (std::size_t i = 0; i < directions; ++i) {
    if (isAsked[i]) {
      ++asked;
      shown += shows(outside, dark, i) && (isDisc ? shows(outside, inside, i) : shows(inside, dark, i)) ? 1 : 0;
    }
  }
  return static_cast<double>(shown) >= leastShare * static_cast<double>(asked) &&
         static_cast<double>(asked) >= leastAsked * directions;
}
} // namespace circle_marker
END_VISP_NAMESPACE
