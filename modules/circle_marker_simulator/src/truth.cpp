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
 * Ground truth of a marker from its exact projection.
 */

#include <algorithm>
#include <array>
#include <cmath>

#include "layers.h"
#include "print.h"
#include "truth.h"

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

namespace {

// Points on a marker's outer edge at which it is looked up whether the edge is visible.
constexpr int EDGE_SAMPLES = 2880;
// Points for the moments of a circle's image. The trapezoidal rule on a smooth closed curve converges faster than any
// power; 256 points are exact to rounding up to a tilt of 85 degrees at any distance from two diameters on.
constexpr int MOMENT_SAMPLES = 1024;

// Outer edge of the marker as printed without ink spread: circle, or rectangle.
PrintedRegion outerEdge(const vpSimulatedMarker &marker)
{
  PrintedRegion edge = {{}, 0.};
  const double x = 0.5 * marker.getSize();
  const double y = 0.5 * marker.getHeight();
  if (marker.isCircle()) {
    edge.boundary.push_back(PlaneCurve::arc(x, 0., 2. * M_PI));
    return edge;
  }
  for (const Segment &side : outlineOf({-x, -y, x, y})) {
    edge.boundary.push_back(PlaneCurve::line(side.from, side.to));
  }
  return edge;
}

double curveLength(const PlaneCurve &curve, const vpSimulatedMarker &marker)
{
  const PlanePoint from = curve.at(0.);
  const PlanePoint to = curve.at(1.);
  return curve.isLine() ? std::hypot(to.x - from.x, to.y - from.y) : M_PI * marker.getSize();
}

double visibleEdge(const vpSimulatedMarker &marker, const PrintedRegion &edge, const Lens &lens,
                   const std::vector<Outline> &covers, const Box &frame)
{
  const Paper paper(marker, marker.getPose());
  double all = 0.;
  double visible = 0.;
  const int samples = EDGE_SAMPLES / static_cast<int>(edge.boundary.size());
  for (const PlaneCurve &curve : edge.boundary) {
    const double piece = curveLength(curve, marker) / samples;
    for (int i = 0; i < samples; ++i) {
      const PlanePoint q = curve.at((i + 0.5) / samples);
      const PlanePoint p = paper.project(q, lens);
      const bool within = p.x >= frame.left && p.x <= frame.right && p.y >= frame.top && p.y <= frame.bottom;
      const bool covered =
          std::any_of(covers.begin(), covers.end(), [&p](const Outline &cover) { return isInside(cover, p); });
      all += piece;
      visible += within && !covered ? piece : 0.;
    }
  }
  return visible / all;
}

double coveredArea(const Outline &whole, const std::vector<Outline> &covers, const Box &frame)
{
  const double full = area(whole);
  const Box box = boundingBox(whole);
  const bool cut = box.left < frame.left || box.top < frame.top || box.right > frame.right || box.bottom > frame.bottom;
  Outline visible = cut ? intersect(whole, outlineOf(frame)) : whole;
  for (const Outline &cover : covers) {
    visible = subtract(visible, cover);
  }
  return full > 0. ? std::clamp(1. - area(visible) / full, 0., 1.) : 1.;
}

double tiltOf(const vpHomogeneousMatrix &cMo)
{
  const double distance = std::hypot(cMo[0][3], cMo[1][3], cMo[2][3]);
  const double cosine = (cMo[0][2] * cMo[0][3] + cMo[1][2] * cMo[1][3] + cMo[2][2] * cMo[2][3]) / distance;
  return std::acos(std::clamp(cosine, -1., 1.));
}

} // namespace

vpEllipseTruth ellipseOf(double radius, const Paper &paper, const Lens &lens)
{
  std::array<PlanePoint, MOMENT_SAMPLES> p;
  const PlanePoint origin = paper.project({0., 0.}, lens);
  for (int i = 0; i < MOMENT_SAMPLES; ++i) {
    const double angle = 2. * M_PI * i / MOMENT_SAMPLES;
    const PlanePoint q = paper.project({radius * std::cos(angle), radius * std::sin(angle)}, lens);
    p[i] = {q.x - origin.x, q.y - origin.y};
  }
  // Integrals over the disc's image of 1, x, y, x^2, x y, y^2 as integrals along its edge, with derivatives along the
  // edge by the central difference of order 8.
  constexpr std::array<double, 4> weights = {{4. / 5., -1. / 5., 4. / 105., -1. / 280.}};
  double m00 = 0., m10 = 0., m01 = 0., m20 = 0., m11 = 0., m02 = 0.;
  for (int i = 0; i < MOMENT_SAMPLES; ++i) {
    double dx = 0.;
    double dy = 0.;
    for (int k = 1; k <= 4; ++k) {
      const PlanePoint &ahead = p[(i + k) % MOMENT_SAMPLES];
      const PlanePoint &behind = p[(i - k + MOMENT_SAMPLES) % MOMENT_SAMPLES];
      dx += weights[k - 1] * (ahead.x - behind.x);
      dy += weights[k - 1] * (ahead.y - behind.y);
    }
    const double x = p[i].x;
    const double y = p[i].y;
    const double turn = x * dy - y * dx; // twice the area swept; moments of order n come out with a factor n + 2
    m00 += turn / 2.;
    m10 += turn * x / 3.;
    m01 += turn * y / 3.;
    m20 += turn * x * x / 4.;
    m11 += turn * x * y / 4.;
    m02 += turn * y * y / 4.;
  }
  const double cx = m10 / m00;
  const double cy = m01 / m00;
  const double n20 = m20 / m00 - cx * cx;
  const double n11 = m11 / m00 - cx * cy;
  const double n02 = m02 / m00 - cy * cy;
  const double mean = 0.5 * (n20 + n02);
  const double spread = std::hypot(0.5 * (n20 - n02), n11);
  // A filled ellipse has the second moments a^2 / 4 and b^2 / 4 about its axes.
  return {vpImagePoint(origin.y + cy, origin.x + cx), 2. * std::sqrt(mean + spread),
          2. * std::sqrt(std::max(mean - spread, 0.)), 0.5 * std::atan2(2. * n11, n20 - n02)};
}

vpMarkerTruth truthOf(const vpSimulatedMarker &marker, const Lens &lens, const std::vector<Outline> &covers,
                      const Box &frame)
{
  const vpHomogeneousMatrix &cMo = marker.getPose();
  const PlanePoint center = lens.project(cMo[0][3], cMo[1][3], cMo[2][3]);
  const Paper paper(marker, cMo);
  vpMarkerTruth truth;
  truth.family = marker.getFamily();
  truth.id = marker.getId();
  truth.size = marker.getSize();
  truth.cMo = cMo;
  truth.center = vpImagePoint(center.y, center.x);
  truth.tilt = tiltOf(cMo);
  if (!paper.showsItsFace()) {
    truth.visibleEdge = 0.;
    truth.coveredArea = 1.;
    return truth;
  }
  if (marker.isCircle()) {
    truth.ellipse = ellipseOf(0.5 * marker.getSize(), paper, lens);
  }
  const PrintedRegion edge = outerEdge(marker);
  truth.visibleEdge = visibleEdge(marker, edge, lens, covers, frame);
  truth.coveredArea = coveredArea(project(edge, paper, lens), covers, frame);
  return truth;
}

} // namespace marker_simulator
END_VISP_NAMESPACE
