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
 * A picture as if its lens had no distortion.
 */

#include "common/undistorted_picture.h"

#include <cmath>

#include <visp3/core/vpImageTools.h>
#include <visp3/core/vpPixelMeterConversion.h>

namespace common {
namespace {
// The place in a camera's picture that is seen in the undistorted one at another: by fixed-point iteration, whose error
// falls by the share of the distortion's slope, less than a half, each time.
vpImagePoint distortedPlace(const vpCameraParameters &camera, const vpImagePoint &undistorted)
{
  constexpr int mostIterations = 60;
  constexpr double negligible = 1e-6; // pixels
  vpImagePoint place = undistorted;
  for (int i = 0; i < mostIterations; ++i) {
    const vpImagePoint error = undistorted - undistortedPlace(camera, place);
    place += error;
    if (std::hypot(error.get_u(), error.get_v()) < negligible) {
      break;
    }
  }
  return place;
}
} // namespace

vpCameraParameters straightened(const vpCameraParameters &camera)
{
  return vpCameraParameters(camera.get_px(), camera.get_py(), camera.get_u0(), camera.get_v0());
}

vpImagePoint undistortedPlace(const vpCameraParameters &camera, const vpImagePoint &place)
{
  double x = 0.;
  double y = 0.;
  vpPixelMeterConversion::convertPoint(camera, place, x, y);
  return vpImagePoint(camera.get_v0() + camera.get_py() * y, camera.get_u0() + camera.get_px() * x);
}

void undistort(const vpCameraParameters &camera, vpImage<unsigned char> &I)
{
  const unsigned int height = I.getHeight();
  const unsigned int width = I.getWidth();
  vpArray2D<int> u(height, width);
  vpArray2D<int> v(height, width);
  vpArray2D<float> du(height, width);
  vpArray2D<float> dv(height, width);
  for (unsigned int row = 0; row < height; ++row) {
    for (unsigned int column = 0; column < width; ++column) {
      const vpImagePoint place = distortedPlace(camera, vpImagePoint(row, column));
      u[row][column] = static_cast<int>(std::floor(place.get_u()));
      v[row][column] = static_cast<int>(std::floor(place.get_v()));
      du[row][column] = static_cast<float>(place.get_u() - std::floor(place.get_u()));
      dv[row][column] = static_cast<float>(place.get_v() - std::floor(place.get_v()));
    }
  }
  vpImage<unsigned char> undistorted(height, width, 0);
  vpImageTools::remap(I, u, v, du, dv, undistorted);
  I = undistorted;
}
} // namespace common
