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
 * Random poses of a marker, as drawn for the experiments.
 */

#include <cmath>

#include <visp3/core/vpException.h>
#include <visp3/core/vpPixelMeterConversion.h>
#include <visp3/core/vpRotationMatrix.h>
#include <visp3/core/vpThetaUVector.h>
#include <visp3/core/vpTranslationVector.h>

#include <visp3/circle_marker_simulator/vpRandomMarkerPose.h>

#include "lens.h"
#include "print.h"
#include "random_numbers.h"

BEGIN_VISP_NAMESPACE

using namespace marker_simulator;

namespace {

// Draws after which a range is taken to be impossible; the marker fits in one of two draws even at the least depth.
constexpr int MOST_DRAWS = 100000;

vpRotationMatrix turn(double angle, double x, double y, double z)
{
  return vpRotationMatrix(vpThetaUVector(angle * x, angle * y, angle * z));
}

// Rotation that takes the axis z to the line of sight toward (X, Y, Z), about an axis across both.
vpRotationMatrix towardSight(double X, double Y, double Z)
{
  const double across = std::hypot(X, Y);
  return across == 0. ? vpRotationMatrix() : turn(std::atan2(across, Z), -Y / across, X / across, 0.);
}

bool fits(const vpSimulatedMarker &marker, const vpHomogeneousMatrix &cMo, const Lens &lens, const Box &frame)
{
  try {
    const Box box = boundingBox(project(sheetOf(marker), Paper(marker, cMo), lens));
    return box.left >= frame.left && box.top >= frame.top && box.right <= frame.right && box.bottom <= frame.bottom;
  }
  catch (const vpException &) {
    return false; // behind the camera or beyond the lens model
  }
}

} // namespace

/*!
  Draws a pose in the way of the thesis's third experiment, as far as the thesis says how (chapter 5.5): its tables give
  ranges of depth from 0.36 m, and of the angle between the marker's normal and the line of sight.

  - The depth z of the marker's centre is uniform in the range.
  - The centre's image is uniform over the image (without distortion: the centre is uniform over the field of view at
    that depth).
  - The angle between the normal, which faces the camera, and the line of sight is uniform from 0 to the greatest tilt,
    the direction of the tilt and the spin about the normal are uniform over the full circle.
  - The whole sheet lies in the image, \e margin pixels from its border; a draw where it does not is repeated with the
    same depth and the same tilt, so that their distributions stay uniform.

  \param marker : marker, for its sheet's size; its pose is not used.
  \param cam : camera parameters.
  \param width, height : size of the image, in pixels.
  \param range : ranges to draw from.
  \param seed : the same seed gives the same pose.
  \return Pose of the marker in the camera frame (z into the marker, metres).
  \exception vpException::badValue : the range is empty, or the marker does not fit into the image at any depth in it.
*/
vpHomogeneousMatrix vpRandomMarkerPose(const vpSimulatedMarker &marker, const vpCameraParameters &cam,
                                       unsigned int width, unsigned int height, const vpRandomPoseRange &range,
                                       std::uint64_t seed)
{
  constexpr double mostTilt = 0.5 * M_PI * (1. + 1e-12); // 90 degrees, however these are rounded
  if (!(range.minDepth > 0. && range.minDepth <= range.maxDepth) ||
      !(range.maxTilt >= 0. && range.maxTilt <= mostTilt)) {
    throw vpException(vpException::badValue, "depths from %g m to %g m with tilts to %g rad are no range to draw from",
                      range.minDepth, range.maxDepth, range.maxTilt);
  }
  const Lens lens(cam);
  const Box frame = {-0.5 + range.margin, -0.5 + range.margin, width - 0.5 - range.margin, height - 0.5 - range.margin};
  RandomNumbers random(seed);
  // Draws with the same depth and tilt before both are drawn anew: the marker may not fit at all.
  constexpr int drawsPerDepth = 1000;
  double Z = 0.;
  double tilt = 0.;
  for (int draw = 0; draw < MOST_DRAWS; ++draw) {
    if (draw % drawsPerDepth == 0) {
      Z = random.uniform(range.minDepth, range.maxDepth);
      tilt = random.uniform(0., range.maxTilt);
    }
    const double u = random.uniform(frame.left, frame.right);
    const double v = random.uniform(frame.top, frame.bottom);
    const double azimuth = random.uniform(0., 2. * M_PI);
    const double spin = random.uniform(0., 2. * M_PI);
    double x = 0.;
    double y = 0.;
    vpPixelMeterConversion::convertPoint(cam, u, v, x, y);
    const vpRotationMatrix R =
        towardSight(x, y, 1.) * turn(tilt, std::cos(azimuth), std::sin(azimuth), 0.) * turn(spin, 0., 0., 1.);
    const vpHomogeneousMatrix cMo(vpTranslationVector(x * Z, y * Z, Z), R);
    if (fits(marker, cMo, lens, frame)) {
      return cMo;
    }
  }
  throw vpException(vpException::badValue,
                    "a sheet of %g m does not fit into the image at depths from %g m to %g m: "
                    "ask for a greater depth",
                    marker.getSheetWidth(), range.minDepth, range.maxDepth);
}

END_VISP_NAMESPACE
