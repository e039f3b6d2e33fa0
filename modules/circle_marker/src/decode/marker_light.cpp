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
 * Light on a marker, by the white around it.
 */

#include "decode/marker_light.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Cholesky>

#include "decode/code_track.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Less than this share of the white, root mean square, about the plane is noise or a narrow quiet zone: noise of 20
// grey levels on white of 190.
constexpr double leastUneven = 0.11;
// Of a shadow at most this share of the light is left; the plane does for less.
constexpr double mostShadow = 0.85;
// A shadow must leave at most this share of what the plane leaves.
constexpr double mostLeft = 0.5;
// And this share, of squares, of what is left by a plane with equal dips on opposite sides, two of them or four: where
// the narrow quiet zone of a tilted marker ends in the blur, the white around has such dips.
constexpr double mostLeftOfDips = 0.5;
// Half widths of a shadow's edge that are tried, outer radii: a hard one to one of six pixels on a marker of 40.
constexpr std::array<double, 3> halfWidths = {0.02, 0.1, 0.3};
// Light that falls off so much over the marker that less than this share of it is left at its rim is no plane: what
// lies beside is in it.
constexpr double leastAtRim = 0.15;
// The fit of light and factor is linear but for their product: a few steps.
constexpr int steps = 3;

/*! Light with a shadow: of grey levels, or of their roots. */
struct Fit
{
  double center = 0.;
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();
  double factor = 0.5;
  Eigen::Vector2d toLight = Eigen::Vector2d::Zero();
  double edge = 0.;
  double left = HUGE_VAL; // mean square of grey levels

  double litAt(const Eigen::Vector2d &q) const { return center + slope.dot(q); }
};

/*! Grey levels around a circle, or their roots, and the places where they are. */
struct Around
{
  std::array<double, mostSamples> whites;
  std::size_t count = 0;
  double radius = 0.;
  std::array<Eigen::Vector2d, mostSamples> places;
  bool isRoot = false;
};

// The arc that is darker than a plane of logarithms makes it, as far as one step explains it best: its first direction
// and its length. A shadow multiplies, and so does the logarithm add.
std::array<std::size_t, 2> darkArc(const Around &around)
{
  const std::size_t n = around.count;
  const double share = 1. / static_cast<double>(n);
  std::array<double, mostSamples> residual;
  double mean = 0.;
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < n; ++i) {
    residual[i] = std::log(std::max(around.whites[i], 1.));
    mean += share * residual[i];
    slope += 2. * share * residual[i] / around.radius * around.places[i];
  }
  for (std::size_t i = 0; i < n; ++i) {
    residual[i] -= mean + slope.dot(around.places[i]) / around.radius;
  }
  std::array<std::size_t, 2> best = {0, 0};
  double most = 0.;
  for (std::size_t length = 1; length < n; ++length) {
    // What is left of a step of this length about its own plane: it is the same for all directions.
    const double angle = M_PI * share;
    const double turned = std::sin(angle * static_cast<double>(length)) / std::sin(angle);
    const double own = static_cast<double>(length) * (1. - share * static_cast<double>(length));
    const double squares = own - 2. * share * turned * turned;
    if (squares < 0.05) { // one direction among few is nearly a plane's
      continue;
    }
    double sum = 0.;
    for (std::size_t i = 0; i < length; ++i) {
      sum += residual[i];
    }
    for (std::size_t i = 0; i < n; ++i) {
      if (sum < 0. && sum * sum > most * squares) {
        most = sum * sum / squares;
        best = {i, length};
      }
      sum += residual[(i + length) % n] - residual[i];
    }
  }
  return best;
}

// Light and factor for given shares of light, by least squares; with a slope or without.
void fitLight(const Around &around, const std::array<double, mostSamples> &lit, bool hasSlope, Fit &fit)
{
  for (int step = 0; step < steps; ++step) {
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    for (std::size_t i = 0; i < around.count; ++i) {
      const Eigen::Vector2d &q = around.places[i];
      const double white = fit.litAt(q);
      const double here = fit.factor + (1. - fit.factor) * lit[i];
      const Eigen::Vector4d row(here, hasSlope ? here * q.x() : 0., hasSlope ? here * q.y() : 0.,
                                white * (1. - lit[i]));
      matrix += row * row.transpose();
      right += (around.whites[i] - white * here) * row;
    }
    matrix.diagonal().array() += 1e-9 * matrix.trace();
    const Eigen::Vector4d change = matrix.ldlt().solve(right);
    fit.center += change[0];
    fit.slope += change.segment<2>(1);
    fit.factor = std::clamp(fit.factor + change[3], 0., 1.);
  }
}

// Sets light and factor; where light would fall off to nothing, that of an even light.
void fitAnyLight(const Around &around, const std::array<double, mostSamples> &lit, double mean, Fit &fit)
{
  fitLight(around, lit, true, fit);
  if (!(fit.slope.norm() * around.radius < (1. - leastAtRim) * fit.center)) {
    fit.center = mean;
    fit.slope.setZero();
    fitLight(around, lit, false, fit);
  }
}

// Mean square of what is left of the grey levels.
double leftBy(const Fit &fit, const Around &around, const std::array<double, mostSamples> &lit)
{
  double left = 0.;
  for (std::size_t i = 0; i < around.count; ++i) {
    const double white = fit.litAt(around.places[i]) * (fit.factor + (1. - fit.factor) * lit[i]);
    const double residual =
        around.isRoot ? around.whites[i] * around.whites[i] - white * std::abs(white) : around.whites[i] - white;
    left += residual * residual / static_cast<double>(around.count);
  }
  return left;
}

// The light with the shadow that is dark on an arc; none if there is no line.
Fit fitShadow(const Around &around, const std::array<std::size_t, 2> &dark)
{
  const double n = static_cast<double>(around.count);
  std::array<double, mostSamples> lit;
  double mean = 0.;
  for (std::size_t i = 0; i < around.count; ++i) {
    lit[i] = (i + around.count - dark[0]) % around.count < dark[1] ? 0. : 1.;
    mean += around.whites[i] / n;
  }
  Fit fit;
  fit.center = mean;
  fitAnyLight(around, lit, mean, fit);
  // The lit arc: its middle is the direction of the light, its length the distance of the chord. Levels between light
  // and shadow lie on the edge.
  double all = 0.;
  for (std::size_t i = 0; i < around.count; ++i) {
    const double level = around.whites[i] / fit.litAt(around.places[i]);
    const double share = std::clamp((level - fit.factor) / std::max(1. - fit.factor, 1e-3), 0., 1.);
    all += share / n;
    fit.toLight += share * around.places[i];
  }
  Fit best;
  if (fit.toLight.norm() == 0.) {
    return best;
  }
  fit.toLight.normalize();
  fit.edge = around.radius * std::cos(M_PI * all);
  for (const double halfWidth : halfWidths) {
    for (std::size_t i = 0; i < around.count; ++i) {
      lit[i] = std::clamp(0.5 + 0.5 * (fit.toLight.dot(around.places[i]) - fit.edge) / halfWidth, 0., 1.);
    }
    fitAnyLight(around, lit, mean, fit);
    fit.left = leftBy(fit, around, lit);
    if (fit.left < best.left) {
      best = fit;
    }
  }
  return best;
}
} // namespace

MarkerLight::MarkerLight(const double *whites, std::size_t count, double radius, double first)
{
  const double n = static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2. * M_PI * (static_cast<double>(i) + first) / n;
    m_mean += whites[i] / n;
    m_slope += 2. * whites[i] / (n * radius) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  }
  m_center = m_mean;
  seekShadow(whites, count, radius, first);
}

void MarkerLight::seekShadow(const double *whites, std::size_t count, double radius, double first)
{
  const double n = static_cast<double>(count);
  double squares = 0.;
  for (std::size_t i = 0; i < count; ++i) {
    squares += whites[i] * whites[i] / n;
  }
  // The mean and the two slopes are orthogonal over the circle.
  const double leftByPlane = squares - m_mean * m_mean - 0.5 * radius * radius * m_slope.squaredNorm();
  if (!(leftByPlane > std::pow(leastUneven * m_mean, 2.))) {
    return;
  }
  Around around;
  around.count = count;
  around.radius = radius;
  Eigen::Vector4d dips = Eigen::Vector4d::Zero(); // orthogonal to the plane, too
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2. * M_PI * (static_cast<double>(i) + first) / n;
    const Eigen::Vector4d waves(std::cos(2. * angle), std::sin(2. * angle), std::cos(4. * angle), std::sin(4. * angle));
    dips += 2. * whites[i] / n * waves;
    around.places[i] = radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    around.whites[i] = whites[i];
  }
  const std::array<std::size_t, 2> dark = darkArc(around);
  double least = std::min(mostLeft * mostLeft * leftByPlane, mostLeftOfDips * (leftByPlane - 0.5 * dips.squaredNorm()));
  for (const bool isRoot : {false, true}) {
    if (isRoot) {
      around.isRoot = true;
      std::transform(whites, whites + count, around.whites.begin(), [](double white) { return std::sqrt(white); });
    }
    const Fit fit = fitShadow(around, dark);
    const double factor = isRoot ? fit.factor * fit.factor : fit.factor;
    if (fit.left < least && factor <= mostShadow) {
      least = fit.left;
      m_center = fit.center;
      m_slope = fit.slope;
      m_isSquare = isRoot;
      m_factor = factor;
      m_toLight = fit.toLight;
      m_edge = fit.edge;
    }
  }
}
} // namespace circle_marker
END_VISP_NAMESPACE
