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
 * Projection of points that vpPixelMeterConversion undoes exactly.
 */

#include <algorithm>
#include <cmath>
#include <vector>

#include <visp3/core/vpException.h>

#include "lens.h"

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

namespace {

// Nearer to the camera's plane than a micrometre nothing can be projected in a meaningful way.
constexpr double NEAREST = 1e-6;

// Radius r_d with r_d (1 + kdu r_d^2) = radius, by Newton's method from below, where it cannot overshoot the fold.
double invertRadialDistortion(double kdu, double radius)
{
  if (kdu < 0.) {
    const double fold = 1. / std::sqrt(-3. * kdu);
    if (radius >= 2. / 3. * fold) {
      throw vpException(vpException::badValue,
                        "a point lies outside of what this camera's distortion model can image "
                        "(kdu = %g reaches a radius of %g m): move the marker toward the axis",
                        kdu, 2. / 3. * fold);
    }
  }
  double r = radius;
  for (int i = 0; i < 100; ++i) { // 4 to 6 steps are usual; many only next to the fold
    const double step = (r * (1. + kdu * r * r) - radius) / (1. + 3. * kdu * r * r);
    r -= step;
    if (std::fabs(step) <= 1e-15 * r) {
      break;
    }
  }
  return r;
}

} // namespace

Lens::Lens(const vpCameraParameters &cam)
    : m_model(cam.get_projModel()), m_px(cam.get_px()), m_py(cam.get_py()), m_u0(cam.get_u0()), m_v0(cam.get_v0()),
      m_kdu(cam.get_kdu())
{
  if (m_model == vpCameraParameters::ProjWithKannalaBrandtDistortion) {
    const std::vector<double> k = cam.getKannalaBrandtDistortionCoefficients();
    // ViSP's files have a fifth coefficient, of which its formula makes no use.
    if (k.size() < m_fisheye.size()) {
      throw vpException(vpException::dimensionError, "a Kannala-Brandt camera needs 4 coefficients, this one has %d",
                        static_cast<int>(k.size()));
    }
    std::copy_n(k.begin(), m_fisheye.size(), m_fisheye.begin());
  }
}

double Lens::imageRadius(double radius) const
{
  if (m_model == vpCameraParameters::perspectiveProjWithDistortion) {
    return invertRadialDistortion(m_kdu, radius);
  }
  const double t = std::atan(radius);
  const double t2 = t * t;
  const double slope =
      1. + t2 * (3. * m_fisheye[0] + t2 * (5. * m_fisheye[1] + t2 * (7. * m_fisheye[2] + t2 * 9. * m_fisheye[3])));
  if (slope <= 0.) {
    throw vpException(vpException::badValue,
                      "a point lies %g rad off the axis, beyond the range in which this camera's "
                      "Kannala-Brandt model grows: move the marker toward the axis",
                      t);
  }
  return t * (1. + t2 * (m_fisheye[0] + t2 * (m_fisheye[1] + t2 * (m_fisheye[2] + t2 * m_fisheye[3]))));
}

PlanePoint Lens::project(double X, double Y, double Z) const
{
  if (!(Z > NEAREST)) {
    throw vpException(vpException::badValue,
                      "a point of the scene at depth %g m is not in front of the camera: move "
                      "the marker so that its whole sheet is",
                      Z);
  }
  double x = X / Z;
  double y = Y / Z;
  if (m_model != vpCameraParameters::perspectiveProjWithoutDistortion) {
    const double radius = std::hypot(x, y);
    const double scale = radius > 0. ? imageRadius(radius) / radius : 1.;
    x *= scale;
    y *= scale;
  }
  return {m_u0 + m_px * x, m_v0 + m_py * y};
}

} // namespace marker_simulator
END_VISP_NAMESPACE
