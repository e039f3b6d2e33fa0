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
 * What was found, drawn into a picture; needs no display.
 */

#ifndef VP_TUTORIAL_DRAW_H
#define VP_TUTORIAL_DRAW_H

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpColor.h>
#include <visp3/core/vpFont.h>
#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/core/vpImage.h>
#include <visp3/core/vpImageDraw.h>
#include <visp3/core/vpImagePoint.h>
#include <visp3/core/vpMeterPixelConversion.h>
#include <visp3/core/vpPoint.h>
#include <visp3/core/vpRGBa.h>

#include "visp_names.h"

namespace tutorial {
/*!
  Pixel of a direction, normalised coordinates: the exact inverse of vpPixelMeterConversion, by which poses are made.
  vpMeterPixelConversion goes by kud, which was calibrated apart from kdu: at the rim of a wide lens that is some pixels
  beside it. Not a number where the lens shows nothing.
*/
inline vpImagePoint pixelOf(double x, double y, const vpCameraParameters &cam)
{
  vpImagePoint image;
  if (cam.get_projModel() != vpCameraParameters::perspectiveProjWithDistortion) {
    vpMeterPixelConversion::convertPoint(cam, x, y, image);
    return image;
  }
  // With rho the distance from the principal point, pixels by px and py: r = rho (1 + kdu rho^2), by Newton's method.
  constexpr int steps = 20;
  const double kdu = cam.get_kdu();
  const double r = std::hypot(x, y);
  double rho = r;
  for (int i = 0; i < steps; ++i) {
    rho -= (rho * (1. + kdu * rho * rho) - r) / (1. + 3. * kdu * rho * rho);
  }
  const bool isSeen = std::abs(rho * (1. + kdu * rho * rho) - r) < 1e-9 * (1. + r) && 1. + 3. * kdu * rho * rho > 0.;
  const double scale = !isSeen ? std::numeric_limits<double>::quiet_NaN() : r > 0. ? rho / r : 1.;
  image.set_uv(cam.get_u0() + cam.get_px() * scale * x, cam.get_v0() + cam.get_py() * scale * y);
  return image;
}

/*! Image of a point of the marker's frame, pixels. The point must be in front of the camera. */
inline vpImagePoint imageOf(double x, double y, double z, const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam)
{
  vpPoint point(x, y, z);
  point.track(cMo);
  return pixelOf(point.get_x(), point.get_y(), cam);
}

/*! Whether every point is near enough to the image to be drawn: vpImageDraw counts in int and goes along every line. */
inline bool isDrawable(const vpImage<vpRGBa> &I, const std::vector<vpImagePoint> &points)
{
  const double reach = 4. * std::max(I.getWidth(), I.getHeight());
  return std::all_of(points.begin(), points.end(), [reach](const vpImagePoint &p) {
    return std::abs(p.get_u()) < reach && std::abs(p.get_v()) < reach;
  });
}

/*! Draws the line through some points of an image, pixels. */
inline void drawPath(vpImage<vpRGBa> &I, const std::vector<vpImagePoint> &points, const vpColor &color,
                     unsigned int thickness, bool closed)
{
  if (isDrawable(I, points)) {
    vpImageDraw::drawPolygon(I, points, color, thickness, closed);
  }
}

/*! Draws a circle of the marker's plane around its origin; the radius is in metres. */
inline void drawRing(vpImage<vpRGBa> &I, const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam, double radius,
                     const vpColor &color, unsigned int thickness)
{
  constexpr int corners = 90; // the polygon is then within 0.06 % of the radius
  std::vector<vpImagePoint> outline;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2. * M_PI * i / corners;
    outline.push_back(imageOf(radius * std::cos(angle), radius * std::sin(angle), 0., cMo, cam));
  }
  drawPath(I, outline, color, thickness, true);
}

/*! Draws a square of the marker's plane around its origin; the side is in metres. */
inline void drawSquare(vpImage<vpRGBa> &I, const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam, double side,
                       const vpColor &color, unsigned int thickness)
{
  const double h = 0.5 * side;
  drawPath(I,
           {imageOf(-h, -h, 0., cMo, cam), imageOf(h, -h, 0., cMo, cam), imageOf(h, h, 0., cMo, cam),
            imageOf(-h, h, 0., cMo, cam)},
           color, thickness, true);
}

/*! Draws the axes of a frame: x in red, y in green, z in blue, or all in one colour; the length is in metres. */
inline void drawAxes(vpImage<vpRGBa> &I, const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam, double length,
                     const vpColor &color = vpColor::none, unsigned int thickness = 2)
{
  const vpImagePoint origin = imageOf(0., 0., 0., cMo, cam);
  const vpColor colors[3] = {vpColor::red, vpColor::green, vpColor::blue};
  for (unsigned int axis = 0; axis < 3; ++axis) {
    // An axis that would pass the camera is not drawn.
    if (cMo[2][3] + length * cMo[2][axis] > 0.05 * cMo[2][3]) {
      const vpImagePoint tip =
          imageOf(axis == 0 ? length : 0., axis == 1 ? length : 0., axis == 2 ? length : 0., cMo, cam);
      drawPath(I, {origin, tip}, color == vpColor::none ? colors[axis] : color, thickness, false);
    }
  }
}

/*! Draws a cross, arms of 6 pixels, with its middle to a pixel. */
inline void drawMark(vpImage<vpRGBa> &I, const vpImagePoint &p, const vpColor &color)
{
  if (isDrawable(I, {p})) {
    vpImageDraw::drawCross(I, p, 12, color, 1);
  }
}

/*! Writes a line of text on a dark ground; moved so that its start is in the image. */
inline void drawText(vpImage<vpRGBa> &I, const std::string &text, const vpImagePoint &topLeft,
                     const vpColor &color = vpColor::yellow)
{
  // Pixels; pictures wider than 1000 pixels are looked at scaled down.
  static const vpFont smallFont(16, vpFont::GENERIC_MONOSPACE), largeFont(24, vpFont::GENERIC_MONOSPACE);
  const vpFont &font = I.getWidth() > 1000 ? largeFont : smallFont;
  const vpImagePoint extent = font.getMeasure(text);
  const double u = std::max(0., std::min(topLeft.get_u(), I.getWidth() - extent.get_u() - 1.));
  const double v = std::max(0., std::min(topLeft.get_v(), I.getHeight() - extent.get_v() - 1.));
  font.drawText(I, text, vpImagePoint(v, u), color, vpColor::black);
}
} // namespace tutorial

#endif
