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
 * What the tests of the detector's rooms share: images drawn from a formula, without the detector's own code.
 */

#ifndef VP_TEST_ROOM_TOOLS_H
#define VP_TEST_ROOM_TOOLS_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <visp3/circle_marker/vpCircleMarkerFamily.h>
#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpImage.h>

#include "pose/marker_plane.h"
#include "refine/fit_pixel.h"
#include "testRandom.h"

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace room_test {
using random_test::Random;
using random_test::randomOfTest;
using random_test::uniform;

/*!
  An image as numbers before the sensor: what a scene of the plane gives through a Gaussian blur and square pixels.

  The scene is averaged over cells, \e fine x \e fine a pixel; those that hold an edge are sampled 8 x 8 times. The
  blur's kernel is integrated over the pixel and taken at the cells' centres. Error at a blur of 0.7: under 0.006 of a
  step for fine = 4, under 0.001 for fine = 8.
  \param width, height : Pixels.
  \param blur : Standard deviation of the Gaussian, pixels; may be 0.
  \param scene : scene(u, v) gives the value at a point of the image.
  \param fine : Cells a pixel.
*/
template <class Scene>
vpImage<double> expose(unsigned int width, unsigned int height, double blur, const Scene &scene, int fine = 4)
{
  // What each cell counts for the pixel with index 0. The cells' own size blurs by 1 / 12 of its square.
  const int reach = static_cast<int>(std::ceil(5. * blur)) + 1; // pixels
  const double sigma = std::sqrt(std::max(blur * blur - 1. / (12. * fine * fine), 0.));
  std::vector<double> kernel;
  double sum = 0.;
  for (int i = 0; i < (2 * reach + 1) * fine; ++i) {
    const double x = (i + 0.5) / fine - 0.5 - reach;
    kernel.push_back(sigma > 0. ? std::erf((x + 0.5) / (sigma * M_SQRT2)) - std::erf((x - 0.5) / (sigma * M_SQRT2))
                                : (std::fabs(x) < 0.5 ? 1. : 0.));
    sum += kernel.back();
  }
  for (double &weight : kernel) {
    weight /= sum;
  }
  const auto columns = static_cast<std::size_t>((static_cast<int>(width) + 2 * reach) * fine);
  const auto rows = static_cast<std::size_t>((static_cast<int>(height) + 2 * reach) * fine);
  const auto place = [fine, reach](double cell) { return cell / fine - 0.5 - reach; };
  constexpr int samples = 8; // of a cell with an edge, in each direction
  std::vector<double> above(columns + 1);
  std::vector<double> below(columns + 1);
  for (std::size_t column = 0; column <= columns; ++column) {
    below[column] = scene(place(static_cast<double>(column)), place(0.));
  }
  std::vector<double> line(columns);
  std::vector<double> reduced(rows * width); // each row of cells, reduced to pixels along u
  for (std::size_t row = 0; row < rows; ++row) {
    above.swap(below);
    for (std::size_t column = 0; column <= columns; ++column) {
      below[column] = scene(place(static_cast<double>(column)), place(static_cast<double>(row) + 1.));
    }
    for (std::size_t column = 0; column < columns; ++column) {
      const auto corners = {above[column], above[column + 1], below[column], below[column + 1]};
      const double least = std::min(corners);
      const double most = std::max(corners);
      line[column] = 0.25 * (above[column] + above[column + 1] + below[column] + below[column + 1]);
      if (most - least > 0.02 * (std::fabs(most) + std::fabs(least))) {
        double inside = 0.;
        for (int i = 0; i < samples; ++i) {
          for (int j = 0; j < samples; ++j) {
            inside += scene(place(static_cast<double>(column) + (j + 0.5) / samples),
                            place(static_cast<double>(row) + (i + 0.5) / samples));
          }
        }
        line[column] = inside / (samples * samples);
      }
    }
    for (unsigned int u = 0; u < width; ++u) {
      const double *cells = line.data() + static_cast<std::size_t>(u) * static_cast<std::size_t>(fine);
      double value = 0.;
      for (std::size_t i = 0; i < kernel.size(); ++i) {
        value += kernel[i] * cells[i];
      }
      reduced[row * width + u] = value;
    }
  }
  vpImage<double> exposed(height, width);
  for (unsigned int v = 0; v < height; ++v) {
    for (unsigned int u = 0; u < width; ++u) {
      double value = 0.;
      for (std::size_t i = 0; i < kernel.size(); ++i) {
        value += kernel[i] * reduced[(static_cast<std::size_t>(v) * static_cast<std::size_t>(fine) + i) * width + u];
      }
      exposed[v][u] = value;
    }
  }
  return exposed;
}

//! Grey plane, tilted by some grey levels a pixel.
vpImage<double> greyPlane(unsigned int width, unsigned int height, double grey, double byU, double byV);

//! The sensor: adds noise, rounds and clamps.
vpImage<unsigned char> digitise(const vpImage<double> &exposed, double noise, Random &random);

// Grey levels of paper and ink.
constexpr double paper = 220.;
constexpr double ink = 30.;

//! A scene without noise as the sensor gives it; the scene's values are grey levels.
template <class Scene>
vpImage<unsigned char> photograph(unsigned int width, unsigned int height, double blur, const Scene &scene)
{
  Random unused;
  return digitise(expose(width, height, blur, scene), 0., unused);
}

//! A circle or ring in the image seen as an ellipse: dark between two radii, in units of the outline.
struct EllipseScene
{
  Eigen::Vector2d center;
  double a;
  double b;
  double angle;
  double inner = 0.;      // 0 for a disc
  double inside = ink;    // grey level of the disc or ring
  double outside = paper; // and of the rest

  double operator()(double u, double v) const
  {
    const double x = u - center.x();
    const double y = v - center.y();
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const double radius = std::hypot((c * x + s * y) / a, (c * y - s * x) / b);
    return radius < 1. && radius >= inner ? inside : outside;
  }
};

//! A printed marker in front of a camera without distortion; written from the design, not from the detector.
struct MarkerScene
{
  vpCircleMarkerFamily family;
  std::uint32_t word = 0;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity(); // z into the marker
  Eigen::Vector3d center = Eigen::Vector3d(0., 0., 1.);   // m
  double radius = 0.1;                                    // m
  double focal = 600.;                                    // pixels
  Eigen::Vector2d principal = Eigen::Vector2d(80., 80.);  // pixels
  double white = paper;
  double black = ink;
  double sheet = 1.1667;  // half the side of the white sheet, in units of the radius
  double surround = 110.; // grey level beyond it

  // The point of the marker's plane that is seen at a pixel, in units of the radius.
  Eigen::Vector2d onMarker(double u, double v) const;

  bool isBlack(const Eigen::Vector2d &q) const;

  double operator()(double u, double v) const;

  vpCameraParameters camera() const { return vpCameraParameters(focal, focal, principal.x(), principal.y()); }

  //! Coordinates of the image about it.
  circle_marker::ImageFrame frame() const;

  //! The true pose as the detector's rooms have it.
  circle_marker::MarkerPlane plane() const;
};

Eigen::Matrix3d turn(double angle, const Eigen::Vector3d &axis);

//! The angle between the normal and the line of sight.
double tiltOf(const circle_marker::MarkerPlane &plane);

//! The pose with the same outline, nearly: the normal on the other side of the line of sight.
circle_marker::MarkerPlane twinOf(const circle_marker::MarkerPlane &plane);

/*!
  A marker near the middle of a square image.
  \e diameter: Of its ring in the image if it were seen frontally, pixels.
  \e tilt: Angle between normal and optical axis, rad.
*/
MarkerScene markerScene(Random &random, const vpCircleMarkerFamily &family, int id, double diameter, double tilt,
                        unsigned int side);

//! The angle brought into [-pi, pi].
inline double wrapped(double angle)
{
  return std::remainder(angle, 2. * M_PI);
}

//! What moves by an odd number of pixels along u during the exposure.
vpImage<double> moved(const vpImage<double> &sharp, int way);
} // namespace room_test

#endif
