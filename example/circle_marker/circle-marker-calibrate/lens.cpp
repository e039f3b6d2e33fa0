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
 * ViSP's camera models as functions of their numbers.
 */

#include "lens.h"

#include <cmath>

namespace calibrate {
namespace {
constexpr int mostSteps = 50;
constexpr double precision = 1e-13; // of a number of the order of 1

/*! Solves rd (1 + k rd^2) = r for the branch that begins at 0; nothing beyond its end. */
std::optional<double> distorted(double r, double k)
{
  double rd = r;
  if (k < 0.) {
    const double end = std::sqrt(-1. / (3. * k)); // where the left side is greatest
    if (r >= end * (1. + k * end * end)) {
      return std::nullopt;
    }
    rd = std::min(r, end * (1. - 1e-9));
  }
  for (int i = 0; i < mostSteps; ++i) {
    const double step = (rd * (1. + k * rd * rd) - r) / (1. + 3. * k * rd * rd);
    rd -= step;
    if (std::abs(step) < precision) {
      return rd;
    }
  }
  return std::nullopt;
}

double kannalaBrandt(double theta, const Eigen::VectorXd &numbers)
{
  const double t2 = theta * theta;
  return theta * (1. + t2 * (numbers[4] + t2 * (numbers[5] + t2 * (numbers[6] + t2 * numbers[7]))));
}

double kannalaBrandtSlope(double theta, const Eigen::VectorXd &numbers)
{
  const double t2 = theta * theta;
  return 1. + t2 * (3. * numbers[4] + t2 * (5. * numbers[5] + t2 * (7. * numbers[6] + t2 * 9. * numbers[7])));
}

/*! The angle of a distorted radius. */
std::optional<double> angleOf(double rd, const Eigen::VectorXd &numbers)
{
  double theta = std::min(rd, 1.5);
  for (int i = 0; i < mostSteps; ++i) {
    const double slope = kannalaBrandtSlope(theta, numbers);
    if (!(slope > 0.)) {
      return std::nullopt;
    }
    const double step = (kannalaBrandt(theta, numbers) - rd) / slope;
    theta -= step;
    if (std::abs(step) < precision) {
      return theta >= 0. && theta < M_PI / 2. ? std::optional<double>(theta) : std::nullopt;
    }
  }
  return std::nullopt;
}

/*! kud of u = u0 + px x (1 + kud r^2) that is nearest to the exact inverse of kdu in the image. */
double fittedKud(const Lens &lens, unsigned int width, unsigned int height)
{
  constexpr int steps = 20; // of a grid over the image: the polynomials are smooth
  double above = 0., below = 0.;
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; j <= steps; ++j) {
      const Eigen::Vector2d pixel(i * (width - 1.) / steps, j * (height - 1.) / steps);
      const Eigen::Vector2d d = (pixel - Eigen::Vector2d(lens.numbers[2], lens.numbers[3]))
                                    .cwiseQuotient(Eigen::Vector2d(lens.numbers[0], lens.numbers[1]));
      const Eigen::Vector2d x = (1. + lens.numbers[4] * d.squaredNorm()) * d;
      above += (d - x).dot(x) * x.squaredNorm();
      below += x.squaredNorm() * x.squaredNorm() * x.squaredNorm();
    }
  }
  return below > 0. ? above / below : 0.;
}
} // namespace

std::string nameOf(LensModel model)
{
  return model == LensModel::Plain ? "plain" : (model == LensModel::Distortion ? "distortion" : "kannala-brandt");
}

Lens Lens::of(LensModel model, double px, double py, double u0, double v0)
{
  Lens lens;
  lens.model = model;
  lens.numbers = Eigen::VectorXd::Zero(model == LensModel::Plain ? 4 : (model == LensModel::Distortion ? 5 : 8));
  lens.numbers.head<4>() << px, py, u0, v0;
  return lens;
}

std::optional<Eigen::Vector2d> Lens::project(const Eigen::Vector3d &point) const
{
  if (!(point.z() > 0.)) {
    return std::nullopt;
  }
  const Eigen::Vector2d x = point.head<2>() / point.z();
  const double r = x.norm();
  double rd = r;
  if (model == LensModel::Distortion) {
    const auto solved = distorted(r, numbers[4]);
    if (!solved) {
      return std::nullopt;
    }
    rd = *solved;
  }
  else if (model == LensModel::KannalaBrandt) {
    rd = kannalaBrandt(std::atan(r), numbers);
  }
  const double scale = r > 0. ? rd / r : 1.;
  return Eigen::Vector2d(numbers[2] + numbers[0] * scale * x.x(), numbers[3] + numbers[1] * scale * x.y());
}

std::optional<Eigen::Vector2d> Lens::normalised(const Eigen::Vector2d &pixel) const
{
  const Eigen::Vector2d d((pixel.x() - numbers[2]) / numbers[0], (pixel.y() - numbers[3]) / numbers[1]);
  if (model == LensModel::Plain) {
    return d;
  }
  if (model == LensModel::Distortion) {
    const double scale = 1. + numbers[4] * d.squaredNorm();
    return scale > 0. ? std::optional<Eigen::Vector2d>(scale * d) : std::nullopt;
  }
  const double rd = d.norm();
  const auto theta = angleOf(rd, numbers);
  if (!theta) {
    return std::nullopt;
  }
  return rd > 0. ? Eigen::Vector2d(std::tan(*theta) / rd * d) : d;
}

vpCameraParameters Lens::parameters(unsigned int width, unsigned int height) const
{
  vpCameraParameters cam;
  switch (model) {
  case LensModel::Plain:
    cam.initPersProjWithoutDistortion(numbers[0], numbers[1], numbers[2], numbers[3]);
    break;
  case LensModel::Distortion:
    cam.initPersProjWithDistortion(numbers[0], numbers[1], numbers[2], numbers[3], fittedKud(*this, width, height),
                                   numbers[4]);
    break;
  default: // ViSP's files have a fifth coefficient, of which its formula makes no use
    cam.initProjWithKannalaBrandtDistortion(numbers[0], numbers[1], numbers[2], numbers[3],
                                            {numbers[4], numbers[5], numbers[6], numbers[7], 0.});
    break;
  }
  return cam;
}

std::vector<std::string> Lens::names() const
{
  std::vector<std::string> all{"px", "py", "u0", "v0"};
  if (model == LensModel::Distortion) {
    all.push_back("kdu");
  }
  else if (model == LensModel::KannalaBrandt) {
    all.insert(all.end(), {"k1", "k2", "k3", "k4"});
  }
  return all;
}
} // namespace calibrate
