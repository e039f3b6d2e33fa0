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
 * Means, covariance matrices and lines of a recorded marker's places.
 */

#include <algorithm>
#include <cmath>

#include "station_figures.h"

namespace experiments {
namespace {
constexpr double degrees = 180. / M_PI; // In a radian.

std::vector<Sight> sightsOf(const Station &station)
{
  std::vector<Sight> sights;
  for (const Picture &picture : station.pictures) {
    if (picture.sight) {
      sights.push_back(*picture.sight);
    }
  }
  return sights;
}

Triple difference(const Triple &a, const Triple &b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double dot(const Triple &a, const Triple &b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Triple cross(const Triple &a, const Triple &b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double angleBetween(const Triple &a, const Triple &b)
{
  const Triple product = cross(a, b);
  return degrees * std::atan2(std::sqrt(dot(product, product)), dot(a, b));
}

/*! d^T C^-1 d by Cramer's rule; nothing if C cannot be inverted. */
std::optional<double> mahalanobisSquare(const Triple &d, const Square &C)
{
  const Square minors = {cross(C[1], C[2]), cross(C[2], C[0]), cross(C[0], C[1])}; // Columns of the inverse times det.
  const double determinant = dot(C[0], minors[0]);
  if (!(determinant > 0.)) {
    return std::nullopt;
  }
  double sum = 0.;
  for (std::size_t i = 0; i < 3; ++i) {
    sum += d[i] * dot(minors[i], d);
  }
  return sum / determinant;
}

/*! Adds the products of a vector with itself, times a weight. */
void addSquare(const Triple &d, double weight, Square &sum)
{
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      sum[i][j] += weight * d[i] * d[j];
    }
  }
}

// Means, of one sight and more, and the spread, of two and more.
void addSights(const std::vector<Sight> &sights, StationFigures &figures)
{
  const double count = static_cast<double>(sights.size());
  Triple normal = {};
  for (const Sight &sight : sights) {
    for (std::size_t i = 0; i < 3; ++i) {
      figures.mean[i] += sight.centre[i] / count;
      normal[i] += sight.normal[i] / count;
      for (std::size_t j = 0; j < 3; ++j) {
        figures.stated[i][j] += sight.covariance[i][j] / count;
      }
    }
  }
  figures.tilt = angleBetween(normal, {0., 0., -1.});
  if (sights.size() < 2) {
    return;
  }
  const double freedoms = count - 1.; // The mean takes one.
  double squares = 0.;
  for (const Sight &sight : sights) {
    const Triple d = difference(sight.centre, figures.mean);
    addSquare(d, 1. / freedoms, figures.covariance);
    figures.consistency += mahalanobisSquare(d, sight.covariance).value_or(NAN) / (3. * freedoms);
    squares += std::pow(angleBetween(sight.normal, normal), 2);
  }
  figures.normalSpread = std::sqrt(squares / freedoms);
}
} // namespace

StationFigures figuresOf(const Station &station)
{
  StationFigures figures;
  const std::vector<Sight> sights = sightsOf(station);
  figures.frames = station.pictures.size();
  figures.found = sights.size();
  std::vector<double> times;
  for (const Picture &picture : station.pictures) {
    figures.markers += static_cast<double>(picture.markers) / static_cast<double>(figures.frames);
    times.push_back(picture.cpuTime);
  }
  figures.cpuTime = common::statisticsOf(times);
  if (!sights.empty()) {
    addSights(sights, figures);
  }
  return figures;
}

double SlideLine::distanceOf(const Triple &centre) const
{
  return std::hypot(centre[0] - origin[0] - direction[0] * centre[2], centre[1] - origin[1] - direction[1] * centre[2]);
}

SlideLine lineOf(const Station &station)
{
  const std::vector<Sight> sights = sightsOf(station);
  const StationFigures figures = figuresOf(station);
  SlideLine line;
  line.direction = {figures.covariance[0][2] / figures.covariance[2][2],
                    figures.covariance[1][2] / figures.covariance[2][2], 1.};
  for (std::size_t i = 0; i < 3; ++i) {
    line.origin[i] = figures.mean[i] - line.direction[i] * figures.mean[2];
  }
  line.angle = degrees * std::atan(std::hypot(line.direction[0], line.direction[1]));
  std::vector<double> depths, distances;
  for (const Sight &sight : sights) {
    depths.push_back(sight.centre[2]);
    distances.push_back(line.distanceOf(sight.centre));
  }
  const common::Statistics range = common::statisticsOf(depths);
  line.nearest = range.least;
  line.farthest = range.most;
  line.distances = common::statisticsOf(distances);
  return line;
}

std::vector<std::array<double, 2>> ellipseOf(const Square &covariance, std::size_t first, std::size_t second,
                                             double deviations)
{
  // The columns of the lower triangle L with L L^T = covariance map the unit circle to the ellipse.
  const double l11 = std::sqrt(covariance[first][first]);
  const double l21 = covariance[second][first] / l11;
  const double l22 = std::sqrt(std::fmax(covariance[second][second] - l21 * l21, 0.));
  constexpr int pieces = 60;
  std::vector<std::array<double, 2>> points;
  for (int i = 0; i <= pieces; ++i) {
    const double angle = 2. * M_PI * i / pieces;
    points.push_back(
        {deviations * l11 * std::cos(angle), deviations * (l21 * std::cos(angle) + l22 * std::sin(angle))});
  }
  return points;
}
} // namespace experiments
