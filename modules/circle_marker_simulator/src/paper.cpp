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
 * Where the points of a printed sheet are in space, flat or bent.
 */

#include <cmath>

#include <visp3/core/vpException.h>

#include "paper.h"

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

namespace {

// Curvature of an arc of the half-length a and the height b: b c = 1 - cos(a c), by Newton's method from the parabola.
double curvatureOf(double bow, double a)
{
  if (bow == 0.) {
    return 0.;
  }
  const double height = std::fabs(bow);
  double c = 2. * height / (a * a);
  for (int i = 0; i < 20; ++i) {
    const double step = (1. - std::cos(a * c) - height * c) / (a * std::sin(a * c) - height);
    c -= step;
    if (std::fabs(step) < 1e-15 * c) {
      break;
    }
  }
  return std::copysign(c, bow);
}

// Mean of (1 - cos(c s)) / c over a circle of the radius r about the origin, s = r cos(phi): (1 - J_0(c r)) / c.
double meanHeight(double c, double r)
{
  if (c == 0.) {
    return 0.;
  }
  constexpr int samples = 64; // exact to rounding for an even, periodic and smooth function
  double sum = 0.;
  for (int i = 0; i < samples; ++i) {
    sum += 2. * std::pow(std::sin(0.5 * c * r * std::cos(2. * M_PI * i / samples)), 2) / c;
  }
  return sum / samples;
}

} // namespace

Paper::Paper(const vpSimulatedMarker &marker, const vpHomogeneousMatrix &cMo) : m_cMo(cMo)
{
  const double half = 0.5 * std::fmax(marker.getSheetWidth(), marker.getSheetHeight());
  m_curvature = curvatureOf(marker.getBow(), half);
  m_lift = meanHeight(m_curvature, 0.5 * marker.getSize());
  m_acrossX = -std::sin(marker.getBowAxis());
  m_acrossY = std::cos(marker.getBowAxis());
  m_reach = 0.5 * (std::fabs(m_acrossX) * marker.getSheetWidth() + std::fabs(m_acrossY) * marker.getSheetHeight());
}

PlanePoint Paper::project(const PlanePoint &p, const Lens &lens) const
{
  double x = p.x;
  double y = p.y;
  double z = 0.;
  if (!isFlat()) {
    const double s = m_acrossX * x + m_acrossY * y;
    const double change = std::sin(m_curvature * s) / m_curvature - s;
    x += change * m_acrossX;
    y += change * m_acrossY;
    z = 2. * std::pow(std::sin(0.5 * m_curvature * s), 2) / m_curvature - m_lift;
  }
  const vpHomogeneousMatrix &M = m_cMo;
  return lens.project(M[0][0] * x + M[0][1] * y + M[0][2] * z + M[0][3],
                      M[1][0] * x + M[1][1] * y + M[1][2] * z + M[1][3],
                      M[2][0] * x + M[2][1] * y + M[2][2] * z + M[2][3]);
}

// The tangent plane at s contains the direction of the axis, so that one point of each generator of the cylinder tells.
bool Paper::facesCamera(double s) const
{
  const double angle = m_curvature * s;
  const double across = isFlat() ? s : std::sin(angle) / m_curvature;
  const double height = isFlat() ? 0. : (1. - std::cos(angle)) / m_curvature - m_lift;
  // Normal, into the paper, and point, in the marker frame.
  const double normal[3] = {-std::sin(angle) * m_acrossX, -std::sin(angle) * m_acrossY, std::cos(angle)};
  const double point[3] = {across * m_acrossX, across * m_acrossY, height};
  double side = 0.;
  for (int i = 0; i < 3; ++i) {
    double n = 0.;
    double p = m_cMo[i][3];
    for (int j = 0; j < 3; ++j) {
      n += m_cMo[i][j] * normal[j];
      p += m_cMo[i][j] * point[j];
    }
    side += n * p;
  }
  return side > 0.;
}

bool Paper::showsItsFace() const
{
  const bool middle = facesCamera(0.);
  if (!isFlat() && (facesCamera(m_reach) != middle || facesCamera(-m_reach) != middle)) {
    throw vpException(vpException::badValue,
                      "the bent sheet hides a part of itself from the camera: bend it less or tilt it less");
  }
  return middle;
}

} // namespace marker_simulator
END_VISP_NAMESPACE
