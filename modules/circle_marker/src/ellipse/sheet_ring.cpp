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
 * The ring on a small sheet, by the sheet's shape.
 */

#include "ellipse/sheet_ring.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "support/bilinear.h"
#include "support/parabola.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// The middle of a ring lies, in units of the ellipse that has a sheet's second moments, at 0.67 on a square sheet with
// a quiet zone of a sixth of the radius, at 0.77 on a round one, and farther in where the sheet is larger.
constexpr double nearest = 0.36;
constexpr double farthest = 0.96;
constexpr std::size_t steps = 31; // of 0.02: a tenth of a pixel of the smallest ring
// Semi-minor axis of that ellipse, pixels: on larger sheets the ring has an outer edge.
constexpr double mostSemiMinor = 10.;
// Directions that are asked at a first look, at the next, and then. All lie around the ends of the longer axis, where
// the blur leaves most of the ring.
constexpr std::array<std::size_t, 2> fewDirections = {{2, 8}};
constexpr std::size_t manyDirections = 48;
// The line is deeper than this share of all differences along the way: of what is no ring little is.
constexpr double leastDepth = 0.1;
// Area of a sheet, of that of the ellipse with its second moments: 1 of a disc, 0.955 of a square at any slant.
// Letters, stars and most of what is cluttered have less.
constexpr double leastCompactness = 0.9;

// An ellipse and the map to it from the unit circle.
struct Shape
{
  Eigen::Vector2d center;
  Eigen::Vector2d semiAxes; // the longer one first
  Eigen::Matrix2d axes;     // columns
};

// Area, centre and covariance of what a closed polygon encloses.
struct Moments
{
  double area; // with its sign
  Eigen::Vector2d center;
  Eigen::Matrix2d covariance;
};

// positionOf(k): its corners. By Green's theorem, triangle by triangle from the first one.
template <class PositionOf> Moments momentsOf(std::size_t count, const PositionOf &positionOf)
{
  const Eigen::Vector2d origin = positionOf(0);
  double area = 0.; // twice, the first moments six times, the second ones 24 times
  double mx = 0., my = 0.;
  double mxx = 0., mxy = 0., myy = 0.;
  double px = 0., py = 0.;
  for (std::size_t i = 1; i < count; ++i) {
    const Eigen::Vector2d q = positionOf(i) - origin;
    const double triangle = px * q.y() - py * q.x();
    const double sx = px + q.x();
    const double sy = py + q.y();
    area += triangle;
    mx += triangle * sx;
    my += triangle * sy;
    mxx += triangle * (px * px + q.x() * q.x() + sx * sx);
    mxy += triangle * (px * py + q.x() * q.y() + sx * sy);
    myy += triangle * (py * py + q.y() * q.y() + sy * sy);
    px = q.x();
    py = q.y();
  }
  Moments moments = {0.5 * area, origin, Eigen::Matrix2d::Zero()};
  if (area != 0.) {
    const Eigen::Vector2d center = Eigen::Vector2d(mx, my) / (3. * area);
    moments.center += center;
    moments.covariance << mxx, mxy, mxy, myy;
    moments.covariance = moments.covariance / (12. * area) - center * center.transpose();
  }
  return moments;
}

// The ellipse with given second moments.
std::optional<Shape> shapeOf(const Moments &moments)
{
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
  solver.computeDirect(moments.covariance);
  const Eigen::Vector2d variances = solver.eigenvalues();
  if (!(variances[0] > 0.)) {
    return std::nullopt;
  }
  Shape shape;
  shape.center = moments.center;
  shape.semiAxes = {2. * std::sqrt(variances[1]), 2. * std::sqrt(variances[0])};
  shape.axes << solver.eigenvectors().col(1), solver.eigenvectors().col(0);
  return shape;
}

using Profile = std::array<double, steps>;

double sizeAt(double step)
{
  return nearest + (farthest - nearest) * step / (steps - 1.);
}

// Mean grey levels along the ellipse at each step of its size, in so many directions; nothing if it reaches out of the
// image.
std::optional<Profile> profileOf(const vpImage<unsigned char> &I, const Shape &shape, std::size_t directions)
{
  Profile greys = {};
  for (std::size_t i = 0; i < directions; ++i) {
    // Half of the circle: 45 degrees to either side of both ends of the longer axis.
    const std::size_t k = i % (directions / 2);
    const double angle =
        M_PI * ((static_cast<double>(k) + 0.5) / static_cast<double>(directions) - 0.25) + (k == i ? 0. : M_PI);
    const Eigen::Vector2d way =
        shape.axes * Eigen::Vector2d(shape.semiAxes[0] * std::cos(angle), shape.semiAxes[1] * std::sin(angle));
    if (!isBetweenPixels(I, shape.center + farthest * way)) {
      return std::nullopt;
    }
    for (std::size_t step = 0; step < steps; ++step) {
      greys[step] += bilinearBetween(I, shape.center + sizeAt(static_cast<double>(step)) * way);
    }
  }
  for (double &grey : greys) {
    grey /= static_cast<double>(directions);
  }
  return greys;
}

// The deepest valley: black sectors inside of a ring are less than half of their circle. 0: none.
std::size_t deepestValley(const Profile &greys, double rise)
{
  Profile outside; // the brightest from a step on
  outside[steps - 1] = greys[steps - 1];
  for (std::size_t i = steps - 1; i-- > 0;) {
    outside[i] = std::max(greys[i], outside[i + 1]);
  }
  const double range = outside[0] - *std::min_element(greys.begin(), greys.end());
  double deepest = std::max(rise, leastDepth * range);
  double inside = greys[0];
  std::size_t darkest = 0;
  for (std::size_t i = 1; i + 1 < steps; ++i) {
    const double depth = std::min(inside, outside[i + 1]) - greys[i];
    if (depth > deepest) {
      deepest = depth;
      darkest = i;
    }
    inside = std::max(inside, greys[i]);
  }
  return darkest;
}

// Whether what has these moments may be a sheet.
bool isLikeSheet(const vpImage<unsigned char> &I, const Moments &moments, double rise)
{
  const double determinant = moments.covariance.determinant();
  if (!(determinant > 0.) || std::abs(moments.area) < leastCompactness * 4. * M_PI * std::sqrt(determinant)) {
    return false;
  }
  const auto shape = shapeOf(moments);
  if (!shape || shape->semiAxes[1] > mostSemiMinor) {
    return false;
  }
  return std::all_of(fewDirections.begin(), fewDirections.end(), [&](std::size_t directions) {
    const auto greys = profileOf(I, *shape, directions);
    return greys && deepestValley(*greys, rise) > 0;
  });
}
} // namespace

bool mayBeSheet(const vpImage<unsigned char> &I, const EdgePixel *pixels, std::size_t count, double rise)
{
  return isLikeSheet(I, momentsOf(count, [pixels](std::size_t k) { return Eigen::Vector2d(pixels[k].x, pixels[k].y); }),
                     rise);
}

bool mayBeSheet(const vpImage<unsigned char> &I, const EdgePoint *points, std::size_t count, double rise)
{
  return isLikeSheet(I, momentsOf(count, [points](std::size_t k) { return points[k].position; }), rise);
}

std::optional<EllipseParameters> darkLineOfSheet(const vpImage<unsigned char> &I, const EdgePoint *points,
                                                 std::size_t count, double rise)
{
  const auto shape = shapeOf(momentsOf(count, [points](std::size_t k) { return points[k].position; }));
  const auto greys = shape ? profileOf(I, *shape, manyDirections) : std::nullopt;
  const std::size_t darkest = greys ? deepestValley(*greys, rise) : 0;
  if (darkest == 0) {
    return std::nullopt;
  }
  const double offset = vertexOfParabola((*greys)[darkest - 1], (*greys)[darkest], (*greys)[darkest + 1]);
  const double size = sizeAt(static_cast<double>(darkest) + offset);
  const Eigen::Vector2d major = shape->axes.col(0);
  EllipseParameters ellipse;
  ellipse.center = shape->center;
  ellipse.a = size * shape->semiAxes[0];
  ellipse.b = size * shape->semiAxes[1];
  ellipse.angle = major.x() == 0. ? M_PI_2 : std::atan(major.y() / major.x());
  return ellipse;
}
} // namespace circle_marker
END_VISP_NAMESPACE
