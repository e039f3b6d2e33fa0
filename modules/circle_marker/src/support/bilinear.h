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
 * Grey level between pixels.
 */

#ifndef VP_CIRCLE_MARKER_BILINEAR_H
#define VP_CIRCLE_MARKER_BILINEAR_H

#include <cmath>
#include <optional>

#include <Eigen/Core>

#include <visp3/circle_marker/vpConfigCircleMarker.h>
#include <visp3/core/vpImage.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Whether bilinear() has a grey level for a position: whether four pixel centres lie around it.
*/
inline bool isBetweenPixels(const vpImage<unsigned char> &I, const Eigen::Vector2d &pixel)
{
  // Both bounds are asked of the numbers themselves, so that nothing that is not one is rounded.
  return pixel.x() >= 0. && pixel.y() >= 0. && pixel.x() < I.getWidth() - 1. && pixel.y() < I.getHeight() - 1.;
}

/*!
  Grey level of an image between its pixel centres, by bilinear interpolation, where isBetweenPixels().
*/
inline double bilinearBetween(const vpImage<unsigned char> &I, const Eigen::Vector2d &pixel)
{
  // The whole part of a positive number is its floor: a processor without an instruction for std::floor() is spared its
  // call.
  const auto u = static_cast<unsigned int>(pixel.x());
  const auto v = static_cast<unsigned int>(pixel.y());
  const double s = pixel.x() - u;
  const double t = pixel.y() - v;
  const unsigned char *above = I[v] + u;
  const unsigned char *below = above + I.getWidth();
  return (1. - t) * ((1. - s) * above[0] + s * above[1]) + t * ((1. - s) * below[0] + s * below[1]);
}

/*!
  The same anywhere; nothing outside of the image (vpImage::getValue() takes the nearest pixel at the image's rim and is
  half as fast).
*/
inline std::optional<double> bilinear(const vpImage<unsigned char> &I, const Eigen::Vector2d &pixel)
{
  return isBetweenPixels(I, pixel) ? std::optional<double>(bilinearBetween(I, pixel)) : std::nullopt;
}
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
