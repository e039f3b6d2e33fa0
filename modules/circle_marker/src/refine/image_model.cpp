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
 * What a blurring camera makes of a marker: the darkness of a pixel.
 */

#include "refine/image_model.h"

#include <array>
#include <cmath>

#include "support/normal_distribution.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Edges farther than this many standard deviations of the blur do not touch a pixel (1e-6 of the contrast).
constexpr double reach = 4.8;
// A circular edge farther than this many standard deviations, to first order, is not looked at any closer.
constexpr double farAway = 6.;
// Sectors' edges considered to either side of a pixel: with sectors of a pixel, the third is beyond three sigma.
constexpr int neighbours = 2;

// A pixel on the marker's plane and how the plane's coordinates change with pixel and pose.
struct PlanePoint
{
  Eigen::Vector2d q;                  // in units of the outer radius
  Eigen::Matrix2d byPixel;            // dq / d(pixel)
  Eigen::Matrix<double, 2, 6> byPose; // dq / d(t, w)
};

PlanePoint planePoint(const ModelPixel &pixel, const MarkerPlane &plane)
{
  const Eigen::Vector3d ray(pixel.meter.x(), pixel.meter.y(), 1.);
  const Eigen::Vector3d normal = plane.rotation.col(2);
  const double slope = normal.dot(ray);
  const double depth = normal.dot(plane.center) / slope;
  const Eigen::Vector3d m = depth * ray - plane.center;
  PlanePoint point;
  for (int axis = 0; axis < 2; ++axis) {
    const Eigen::Vector3d e = plane.rotation.col(axis);
    const double ratio = e.dot(ray) / slope;
    point.q[axis] = e.dot(m) / plane.radius;
    const Eigen::Vector3d byRay = depth * (e - ratio * normal) / plane.radius;
    point.byPixel.row(axis) = byRay.head<2>().transpose() * pixel.meterPerPixel;
    point.byPose.block<1, 3>(axis, 0) = (ratio * normal - e).transpose() / plane.radius;
    point.byPose.block<1, 3>(axis, 3) = (e.cross(m) - ratio * normal.cross(m)).transpose() / plane.radius;
  }
  return point;
}

// An edge that a pixel may see both sides of: share of what lies on its black side, and derivatives.
struct SeenEdge
{
  double standardised = 0.;                            // distance in standard deviations
  double cumulative = 0.;                              // share of the black side
  double density = 0.;                                 // of the standard normal distribution there
  Eigen::Vector2d direction = Eigen::Vector2d::Zero(); // unit vector in the image, to the black side
  Eigen::Vector2d byQ = Eigen::Vector2d::Zero();       // derivative of the share by the plane's coordinates
  double bySigma = 0.;
  double byGrowth = 0.;
};

// Polar quantities of a plane point that all circular edges share.
struct Polar
{
  double radius;
  Eigen::Vector2d outward;   // unit vector in the plane
  Eigen::Vector2d direction; // unit vector of the radius' gradient in the image
  double gradient;           // its length, 1 / pixel
  double alongNormal;        // second derivative of the radius along the gradient, 1 / pixel^2
  double alongTangent;       // and along the edge
};

Polar polarOf(const PlanePoint &point)
{
  Polar polar;
  // At the very centre the direction does not matter: no edge is near.
  polar.radius = std::max(point.q.norm(), 1e-6);
  polar.outward = point.q / polar.radius;
  const Eigen::Vector2d around(-polar.outward.y(), polar.outward.x());
  const Eigen::Vector2d g = point.byPixel.transpose() * polar.outward;
  const Eigen::Vector2d h = point.byPixel.transpose() * around;
  polar.gradient = g.norm();
  polar.direction = g / polar.gradient;
  const Eigen::Vector2d tangent(-polar.direction.y(), polar.direction.x());
  polar.alongNormal = h.dot(polar.direction) * h.dot(polar.direction) / polar.radius;
  polar.alongTangent = h.dot(tangent) * h.dot(tangent) / polar.radius;
  return polar;
}

SeenEdge seeCircle(const Polar &polar, const RadialEdge &edge, const BlurParameters &blur)
{
  const double difference = edge.radius - polar.radius;
  SeenEdge seen;
  // Far from the edge its side is all there is to say: near the centre the curvature below grows beyond all bounds.
  if (std::abs(difference) > farAway * blur.sigma * polar.gradient) {
    seen.cumulative = difference * edge.blackSide > 0. ? 1. : 0.;
    return seen;
  }
  // Second-order distance along the gradient to the level set of the radius.
  const double distance =
      difference / polar.gradient * (1. - 0.5 * polar.alongNormal * difference / (polar.gradient * polar.gradient));
  const double curvature = polar.alongTangent / polar.gradient;
  const double inside = distance / blur.sigma - 0.5 * curvature * blur.sigma;
  seen.standardised = edge.blackSide * inside + blur.growth / blur.sigma;
  const auto normal = NormalDistribution::instance().at(seen.standardised);
  seen.cumulative = normal.cumulative;
  seen.density = normal.density;
  seen.direction = -edge.blackSide * polar.direction;
  seen.byQ = -edge.blackSide * normal.density / (polar.gradient * blur.sigma) * polar.outward;
  seen.bySigma = normal.density * (edge.blackSide * (-distance / (blur.sigma * blur.sigma) - 0.5 * curvature) -
                                   blur.growth / (blur.sigma * blur.sigma));
  seen.byGrowth = normal.density / blur.sigma;
  return seen;
}

// The edge between sector k - 1 and sector k; blackSide is 1 if sector k is the black one.
SeenEdge seeSectorEdge(const PlanePoint &point, const Eigen::Vector2d &across, double blackSide,
                       const BlurParameters &blur)
{
  const Eigen::Vector2d g = point.byPixel.transpose() * across;
  const double gradient = g.norm();
  SeenEdge seen;
  seen.standardised = (blackSide * across.dot(point.q) / gradient + blur.growth) / blur.sigma;
  const auto normal = NormalDistribution::instance().at(seen.standardised);
  seen.cumulative = normal.cumulative;
  seen.density = normal.density;
  seen.direction = blackSide * g / gradient;
  seen.byQ = blackSide * normal.density / (gradient * blur.sigma) * across;
  seen.bySigma = -normal.density * seen.standardised / blur.sigma;
  seen.byGrowth = normal.density / blur.sigma;
  return seen;
}

// Sum of what a pixel sees, with the derivative by the plane's coordinates.
struct Sum
{
  double value = 0.;
  Eigen::Vector2d byQ = Eigen::Vector2d::Zero();
  double bySigma = 0.;
  double byGrowth = 0.;

  void add(const SeenEdge &edge, double weight)
  {
    value += weight * edge.cumulative;
    byQ += weight * edge.byQ;
    bySigma += weight * edge.bySigma;
    byGrowth += weight * edge.byGrowth;
  }
};

// Band between two circles: black inside the outer and outside the inner.
Sum seeBand(const SeenEdge &outer, const SeenEdge &inner)
{
  Sum band;
  band.value = -1.;
  band.add(outer, 1.);
  band.add(inner, 1.);
  return band;
}

struct SectorEdges
{
  std::array<SeenEdge, 2 * neighbours> edges;
  int count = 0;
};

// Share of black along the angle, as if the track had no rims; and the edges, for their corners with the rims.
Sum seeSectors(const PlanePoint &point, const MarkerPattern &pattern, const BlurParameters &blur, SectorEdges &seen)
{
  const double sectorAngle = 2. * M_PI / pattern.sectors;
  const int sector = static_cast<int>(std::floor(std::atan2(point.q.y(), point.q.x()) / sectorAngle));
  Sum sum;
  // Black is counted from the first sector on: an edge to black adds the share beyond it, an edge to white takes away
  // the share beyond it, which is 1 minus that of its black side.
  sum.value = pattern.isBlack(sector - neighbours) ? 1. : 0.;
  for (int k = sector - neighbours + 1; k <= sector + neighbours; ++k) {
    const bool before = pattern.isBlack(k - 1);
    const bool after = pattern.isBlack(k);
    if (before == after) {
      continue;
    }
    const SeenEdge edge = seeSectorEdge(point, pattern.acrossBorder(k), after ? 1. : -1., blur);
    sum.add(edge, 1.);
    if (before) {
      sum.value -= 1.;
    }
    seen.edges[static_cast<std::size_t>(seen.count++)] = edge;
  }
  return sum;
}

// Probability of both sides of two edges less the product of the probabilities: the tetrachoric series, whose n-th term
// is rho^(n+1) / (n+1)! He_n(a) He_n(b) with the Hermite polynomials He_n.
double cornerExcess(const SeenEdge &p, const SeenEdge &q)
{
  // At a tilt of 70 degrees rho reaches 0.8; eight terms leave 0.1 % of the contrast there.
  constexpr int terms = 8;
  const double density = p.density * q.density;
  if (density == 0.) {
    return 0.;
  }
  const double rho = p.direction.dot(q.direction);
  double power = rho;
  double sum = 0.;
  double hermiteA[2] = {1., 0.}; // He_n and He_(n-1) at a
  double hermiteB[2] = {1., 0.};
  for (int n = 0; n < terms; ++n) {
    sum += power * hermiteA[0] * hermiteB[0];
    power *= rho / (n + 2);
    const double nextA = p.standardised * hermiteA[0] - n * hermiteA[1];
    const double nextB = q.standardised * hermiteB[0] - n * hermiteB[1];
    hermiteA[1] = hermiteA[0];
    hermiteB[1] = hermiteB[0];
    hermiteA[0] = nextA;
    hermiteB[0] = nextB;
  }
  return density * sum;
}
} // namespace

Darkness darknessAt(const ModelPixel &pixel, const MarkerPlane &plane, const MarkerPattern &pattern,
                    const BlurParameters &blur)
{
  const PlanePoint point = planePoint(pixel, plane);
  const Polar polar = polarOf(point);
  Sum total;
  const SeenEdge outer = seeCircle(polar, pattern.ring[0], blur);
  if (pattern.ringEdges == 1) {
    total.add(outer, 1.);
  }
  else {
    total = seeBand(outer, seeCircle(polar, pattern.ring[1], blur));
  }
  const double blurOfRadius = reach * blur.sigma * polar.gradient;
  if (pattern.sectors > 0 && polar.radius < pattern.track[0].radius + blurOfRadius &&
      polar.radius > pattern.track[1].radius - blurOfRadius) {
    const SeenEdge rimOutside = seeCircle(polar, pattern.track[0], blur);
    const SeenEdge rimInside = seeCircle(polar, pattern.track[1], blur);
    const Sum band = seeBand(rimOutside, rimInside);
    SectorEdges edges;
    const Sum code = seeSectors(point, pattern, blur, edges);
    total.value += band.value * code.value;
    total.byQ += band.value * code.byQ + code.value * band.byQ;
    total.bySigma += band.value * code.bySigma + code.value * band.bySigma;
    total.byGrowth += band.value * code.byGrowth + code.value * band.byGrowth;
    for (int i = 0; i < edges.count; ++i) {
      const SeenEdge &edge = edges.edges[static_cast<std::size_t>(i)];
      total.value += cornerExcess(edge, rimOutside) + cornerExcess(edge, rimInside);
    }
  }
  Darkness darkness;
  darkness.value = total.value;
  darkness.byPose = point.byPose.transpose() * total.byQ;
  darkness.bySigma = total.bySigma;
  darkness.byGrowth = total.byGrowth;
  return darkness;
}

PatternDistance distanceToPattern(const ModelPixel &pixel, const MarkerPlane &plane, const MarkerPattern &pattern)
{
  const PlanePoint point = planePoint(pixel, plane);
  const Polar polar = polarOf(point);
  PatternDistance distance;
  distance.radius = polar.radius;
  distance.radiusPerPixel = polar.gradient;
  distance.toEdges = HUGE_VAL;
  for (unsigned int i = 0; i < pattern.ringEdges; ++i) {
    distance.toEdges = std::min(distance.toEdges, std::abs(pattern.ring[i].radius - polar.radius) / polar.gradient);
  }
  if (pattern.sectors == 0) {
    return distance;
  }
  for (const RadialEdge &edge : pattern.track) {
    distance.toEdges = std::min(distance.toEdges, std::abs(edge.radius - polar.radius) / polar.gradient);
  }
  if (polar.radius < pattern.track[0].radius && polar.radius > pattern.track[1].radius) {
    const double sectorAngle = 2. * M_PI / pattern.sectors;
    const int nearest = static_cast<int>(std::lround(std::atan2(point.q.y(), point.q.x()) / sectorAngle));
    for (int border = nearest - 1; border <= nearest + 1; ++border) {
      if (pattern.isBlack(border) != pattern.isBlack(border - 1)) {
        const Eigen::Vector2d &across = pattern.acrossBorder(border);
        distance.toEdges =
            std::min(distance.toEdges, std::abs(across.dot(point.q)) / (point.byPixel.transpose() * across).norm());
      }
    }
  }
  return distance;
}
} // namespace circle_marker
END_VISP_NAMESPACE
