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
 * Random poses to start a servo from.
 */

#include <cmath>
#include <random>

#include <visp3/core/vpException.h>
#include <visp3/core/vpMeterPixelConversion.h>
#include <visp3/core/vpPixelMeterConversion.h>
#include <visp3/core/vpThetaUVector.h>

#include "servo_scene.h"

namespace tutorial {
namespace {
/*! Numbers that are the same with every compiler, which std::uniform_real_distribution's are not. */
class Uniform
{
public:
  explicit Uniform(std::uint64_t seed) : m_engine(seed) {}

  double operator()(double low, double high)
  {
    constexpr double step = 1. / 9007199254740992.; // 2^-53
    return low + (high - low) * static_cast<double>(m_engine() >> 11) * step;
  }

private:
  std::mt19937_64 m_engine; //!< Where the numbers come from.
};

/*! The rotation that takes the z axis to a unit vector by the shortest way. */
vpRotationMatrix zAxisTo(const vpColVector &direction)
{
  const double angle = std::acos(std::min(1., direction[2]));
  const double norm = std::hypot(direction[0], direction[1]);
  if (norm < 1e-12) {
    return vpRotationMatrix();
  }
  return vpRotationMatrix(vpThetaUVector(-angle * direction[1] / norm, angle * direction[0] / norm, 0.));
}

vpHomogeneousMatrix drawPose(const ServoCamera &camera, const StartRange &range, Uniform &uniform)
{
  double x = 0., y = 0.;
  vpPixelMeterConversion::convertPoint(camera.parameters, uniform(0., camera.width - 1.),
                                       uniform(0., camera.height - 1.), x, y);
  vpColVector sight(std::vector<double>{x, y, 1.});
  sight.normalize();
  const double distance = uniform(range.nearest, range.farthest);
  const double tilt = uniform(0., range.steepest);
  const double direction = uniform(-M_PI, M_PI);
  const double spin = uniform(-M_PI, M_PI);
  const vpRotationMatrix tilted(vpThetaUVector(tilt * std::cos(direction), tilt * std::sin(direction), 0.));
  const vpRotationMatrix spun(vpThetaUVector(0., 0., spin));
  return vpHomogeneousMatrix(vpTranslationVector(distance * sight[0], distance * sight[1], distance * sight[2]),
                             zAxisTo(sight) * tilted * spun);
}

bool isInside(const ServoCamera &camera, const ServoObject &object, const vpHomogeneousMatrix &cMo, double margin)
{
  for (const MountedMarker &marker : object.markers()) {
    for (const vpColVector &corner : sheetCorners(marker)) {
      const vpColVector P = cMo * corner;
      double u = -1., v = -1.;
      if (P[2] > 0.) {
        vpMeterPixelConversion::convertPoint(camera.parameters, P[0] / P[2], P[1] / P[2], u, v);
      }
      if (!(u >= margin && v >= margin && u <= camera.width - 1. - margin && v <= camera.height - 1. - margin)) {
        return false;
      }
    }
  }
  return true;
}
} // namespace

vpHomogeneousMatrix randomStart(const ServoCamera &camera, const ServoObject &object, const StartRange &range,
                                std::uint64_t seed)
{
  Uniform uniform(seed);
  constexpr int attempts = 100000; // at 0.5 m one pose in a hundred or so is inside
  for (int i = 0; i < attempts; ++i) {
    const vpHomogeneousMatrix cMo = drawPose(camera, range, uniform);
    if (isInside(camera, object, cMo, range.margin)) {
      return cMo;
    }
  }
  throw vpException(vpException::badValue,
                    "no start at %g m to %g m has the whole object in the image; use a greater "
                    "--distance",
                    range.nearest, range.farthest);
}
} // namespace tutorial
