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
 * A plain shape in front of the markers of a simulated scene.
 */

#include <algorithm>
#include <cmath>

#include <visp3/core/vpException.h>

#include <visp3/circle_marker_simulator/vpSceneOccluder.h>

BEGIN_VISP_NAMESPACE

vpSceneOccluder::vpSceneOccluder(const std::vector<vpImagePoint> &corners, double grey)
    : m_corners(corners), m_grey(grey)
{
  if (corners.size() < 3) {
    throw vpException(vpException::badValue, "an occluder needs at least 3 corners, not %d",
                      static_cast<int>(corners.size()));
  }
  double twiceArea = 0.;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const vpImagePoint &a = corners[i];
    const vpImagePoint &b = corners[(i + 1) % corners.size()];
    twiceArea += a.get_u() * b.get_v() - b.get_u() * a.get_v();
  }
  if (!std::isfinite(twiceArea) || twiceArea == 0.) {
    throw vpException(vpException::badValue, "an occluder's corners must be finite and span an area");
  }
  if (twiceArea < 0.) {
    std::reverse(m_corners.begin(), m_corners.end());
  }
}

/*!
  A polygon that does not cross itself.
  \param corners : Its corners, pixels.
  \param grey : Grey level.
  \exception vpException::badValue : If the corners span no area or are not finite.
*/
vpSceneOccluder vpSceneOccluder::polygon(const std::vector<vpImagePoint> &corners, double grey)
{
  return vpSceneOccluder(corners, grey);
}

/*!
  A straight bar with square ends between two points.
  \param from, to : The points, pixels.
  \param width : Of the bar, pixels.
  \param grey : Grey level.
  \exception vpException::badValue : If the points are one, or the width is not positive.
*/
vpSceneOccluder vpSceneOccluder::bar(const vpImagePoint &from, const vpImagePoint &to, double width, double grey)
{
  const double du = to.get_u() - from.get_u();
  const double dv = to.get_v() - from.get_v();
  const double length = std::hypot(du, dv);
  if (!(length > 0.) || !(width > 0.)) {
    throw vpException(vpException::badValue, "a bar of %g px by %g px covers nothing", length, width);
  }
  const double u = -0.5 * width * dv / length;
  const double v = 0.5 * width * du / length;
  return vpSceneOccluder({vpImagePoint(from.get_v() - v, from.get_u() - u),
                          vpImagePoint(to.get_v() - v, to.get_u() - u), vpImagePoint(to.get_v() + v, to.get_u() + u),
                          vpImagePoint(from.get_v() + v, from.get_u() + u)},
                         grey);
}

/*!
  An ellipse.
  \param center : in pixels.
  \param semiAxisA, semiAxisB : semi-axes, in pixels.
  \param angle : direction of the axis A, in radians from +u toward +v.
  \param grey : grey level.
  \exception vpException::badValue : a semi-axis is not positive.
*/
vpSceneOccluder vpSceneOccluder::ellipse(const vpImagePoint &center, double semiAxisA, double semiAxisB, double angle,
                                         double grey)
{
  if (!(semiAxisA > 0.) || !(semiAxisB > 0.)) {
    throw vpException(vpException::badValue, "an ellipse with semi-axes of %g px and %g px covers nothing", semiAxisA,
                      semiAxisB);
  }
  // Chord error: r (step / 2)^2 / 2 with the greater semi-axis as r, 2e-4 pixels at most.
  const double chordError = 2e-4;
  const double r = std::max(semiAxisA, semiAxisB);
  const int number = std::max(32, static_cast<int>(std::ceil(M_PI / std::sqrt(2. * chordError / r))));
  std::vector<vpImagePoint> corners;
  for (int i = 0; i < number; ++i) {
    const double x = semiAxisA * std::cos(2. * M_PI * i / number);
    const double y = semiAxisB * std::sin(2. * M_PI * i / number);
    corners.emplace_back(center.get_v() + x * std::sin(angle) + y * std::cos(angle),
                         center.get_u() + x * std::cos(angle) - y * std::sin(angle));
  }
  return vpSceneOccluder(corners, grey);
}

END_VISP_NAMESPACE
