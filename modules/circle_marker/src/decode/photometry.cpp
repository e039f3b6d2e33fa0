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
 * Light, contrast and blur of a marker's image.
 */

#include "decode/photometry.h"

#include <algorithm>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// exp((a, b; b, -a)): its square is a^2 + b^2 times the unit matrix.
Eigen::Matrix2d exponential(const Eigen::Vector2d &elongation)
{
  const double size = elongation.norm();
  const double share = size > 1e-9 ? std::sinh(size) / size : 1.;
  Eigen::Matrix2d matrix;
  matrix << elongation.x(), elongation.y(), elongation.y(), -elongation.x();
  return std::cosh(size) * Eigen::Matrix2d::Identity() + share * matrix;
}

// The inverse of that, of a symmetric matrix of determinant 1.
Eigen::Vector2d logarithm(const Eigen::Matrix2d &matrix)
{
  const Eigen::Vector2d part(0.5 * (matrix(0, 0) - matrix(1, 1)), matrix(0, 1)); // sinh(size) times the direction
  const double sine = part.norm();
  return sine > 1e-9 ? Eigen::Vector2d(std::asinh(sine) / sine * part) : part;
}
} // namespace

Eigen::Matrix2d BlurParameters::shape() const
{
  return exponential(elongation);
}

void BlurParameters::elongate(const Eigen::Vector2d &step)
{
  const Eigen::Matrix2d before = shape();
  elongation = 0.5 * logarithm(before * exponential(2. * step) * before);
}

double Photometry::contrast() const
{
  return absorption < 1. ? 1. - std::pow(1. - absorption, gamma) : absorption;
}

double Photometry::tellableContrast() const
{
  constexpr double brightest = 255.;
  return std::max(std::min(white, brightest) - std::max(white * (1. - contrast()), 0.), 0.);
}

double Shadow::leavesAt(const Eigen::Vector2d &offset) const
{
  const double beyond = Eigen::Vector2d(std::cos(direction), std::sin(direction)).dot(offset) - edge;
  return 1. - 0.5 * (1. - factor) * std::erfc(-beyond / (std::sqrt(2.) * softness));
}

double Photometry::relativeLightAt(const Eigen::Vector2d &offset) const
{
  double light = 1. + lightGradient.dot(offset);
  if (lightCurvature) {
    light +=
        lightCurvature->dot(Eigen::Vector3d(offset.x() * offset.x(), offset.x() * offset.y(), offset.y() * offset.y()));
  }
  return std::max(light, leastLight);
}

double Photometry::whiteAt(const Eigen::Vector2d &offset) const
{
  const double left = shadow ? shadow->leavesAt(offset) : 1.;
  return white * std::pow(relativeLightAt(offset) * left, gamma);
}

double Photometry::blackOf(double grey) const
{
  const double print = toneCurve ? beforeTone(grey) : grey;
  return (1. - std::pow(std::max(print, 0.), 1. / gamma)) / absorption;
}

double Photometry::beforeTone(double grey) const
{
  const double ink = std::pow(std::max(1. - absorption, leastLight), gamma);
  const double sought = (grey - ink) / (1. - ink);
  if (sought <= 0. || sought >= 1.) { // beyond ink and paper the light is no print's
    return grey;
  }
  // Newton's method: between both the curve rises everywhere, and from its middle, where it bends, never leaves them.
  constexpr int steps = 12;
  constexpr double exact = 1e-9;
  double w = 0.5;
  for (int step = 0; step < steps; ++step) {
    const double off = w + *toneCurve * w * (1. - w) * (1. - 2. * w) - sought;
    w = std::clamp(w - off / (1. + *toneCurve * (1. - 6. * w * (1. - w))), 0., 1.);
    if (std::abs(off) < exact) {
      break;
    }
  }
  return ink + (1. - ink) * w;
}
} // namespace circle_marker
END_VISP_NAMESPACE
