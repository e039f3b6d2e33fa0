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
 * Covariance of the pose of a marker that nearly faces the camera.
 */

#include "refine/nearly_frontal.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

// Standard deviations of the lean within which the likelihood is looked at: beyond, what there is between its two
// maxima adds a quarter to the second moments and less.
constexpr double mostDeviations = 9.;
// Lean beyond which it is not told by its square alone, rad: the sine of 30 degrees.
constexpr double mostLean = 0.5;
// The likelihood is summed up to where its logarithm is less than the maximum's by this.
constexpr double mostLogarithm = 10.;
// Points in each direction: two to three in a standard deviation at mostDeviations.
constexpr int points = 40;

// The turn about the marker's x and y axes by which its lean changes, and back: the normal moves along x by the turn
// about y.
Eigen::Vector2d turnFor(const Eigen::Vector2d &lean)
{
  return {-lean.y(), lean.x()};
}

// Covariance of the lean.
Eigen::Matrix2d leanCovariance(const Matrix6 &inMarkerFrame)
{
  const Eigen::Matrix2d turns = inMarkerFrame.block<2, 2>(3, 3);
  Eigen::Matrix2d toLean;
  toLean << 0., 1., -1., 0.;
  return toLean * turns * toLean.transpose();
}

// What there is to know of the lean besides its square: positive or nothing.
Eigen::Matrix2d positivePart(const Eigen::Matrix2d &information)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(information);
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0.).asDiagonal() * solver.eigenvectors().transpose();
}

// Where to sum the likelihood up: along the lean, and across.
struct Window
{
  double from = 0.;
  double to = 0.;
  double across = 0.;
};

Window windowAround(double lean, double byLean, const Eigen::Matrix2d &constant, bool hasTwin)
{
  const double farthest = std::sqrt(lean * lean + std::sqrt(8. * mostLogarithm) / byLean);
  const double least = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(constant).eigenvalues()[0];
  const double reach = least > 0. ? std::sqrt(2. * mostLogarithm / least) : HUGE_VAL;
  return {std::max(hasTwin ? 0. : -farthest, lean - reach), std::min(farthest, lean + reach),
          std::min(farthest, reach)};
}
} // namespace

Eigen::Vector2d leanOf(const MarkerPlane &plane)
{
  return -(plane.rotation.transpose() * plane.center.normalized()).head<2>();
}

MarkerPlane leaningBy(const MarkerPlane &plane, const Eigen::Vector2d &lean)
{
  MarkerPlane leaning = plane;
  const Eigen::Vector2d before = leanOf(plane);
  const Eigen::Vector2d turn = turnFor(lean - before);
  const double angle = turn.norm();
  if (angle > 0.) {
    const Eigen::Vector3d axis(turn.x() / angle, turn.y() / angle, 0.);
    leaning.rotation = plane.rotation * Eigen::AngleAxisd(angle, axis).toRotationMatrix();
  }
  // Narrower by half of the square in one direction, it looks smaller by a quarter.
  leaning.center *= 1. - 0.25 * (lean.squaredNorm() - before.squaredNorm());
  return leaning;
}

bool isNearlyFrontal(const FittedPose &fit)
{
  const Eigen::Vector2d lean = leanOf(fit.plane);
  const Eigen::Matrix2d covariance = leanCovariance(turnedCovariance(fit.covariance, fit.plane.rotation.transpose()));
  return lean.norm() < mostLean && lean.dot(covariance.inverse() * lean) < mostDeviations * mostDeviations;
}

Matrix6 nearlyFrontalCovariance(const FittedPose &fit, bool hasTwin)
{
  const Matrix6 covariance = turnedCovariance(fit.covariance, fit.plane.rotation.transpose());
  const Eigen::Matrix2d information = leanCovariance(covariance).inverse();
  const Eigen::Vector2d lean = leanOf(fit.plane);
  const double size = lean.norm();
  const Eigen::Vector2d along = size > 0. ? Eigen::Vector2d(lean / size) : Eigen::Vector2d::UnitX();
  const Eigen::Vector2d across(-along.y(), along.x());
  const double byLean = std::sqrt(*fit.leanInformation);
  const Eigen::Matrix2d constant =
      positivePart(information - *fit.leanInformation * size * size * Eigen::Matrix2d::Identity());

  // All else follows the turn (t_x, t_y) as the equations have it, and the distance its square: see leaningBy().
  const Eigen::Matrix<double, 6, 2> follows = covariance.middleCols<2>(3) * covariance.block<2, 2>(3, 3).inverse();
  const Eigen::Vector3d nearer = -0.25 * (fit.plane.rotation.transpose() * fit.plane.center);
  const Window window = windowAround(size, byLean, constant, hasTwin && size > 0.);
  Matrix6 moments = Matrix6::Zero();
  double sum = 0.;
  for (int i = 0; i < points; ++i) {
    const double x = window.from + (window.to - window.from) * (i + 0.5) / points;
    for (int j = 0; j < points; ++j) {
      const double y = window.across * (2. * (j + 0.5) / points - 1.);
      const Eigen::Vector2d off = (x - size) * along + y * across;
      const double square = x * x - y * y - size * size; // the real part of z^2 - m^2; 2 x y is the imaginary one
      const double squares = 0.25 * *fit.leanInformation * (square * square + 4. * x * x * y * y);
      const double weight = std::exp(-0.5 * (squares + off.dot(constant * off))) / std::hypot(x, y);
      Vector6 error = follows * turnFor(off);
      error.head<3>() += off.squaredNorm() * nearer;
      moments += weight * error * error.transpose();
      sum += weight;
    }
  }
  if (!(sum > 0.)) { // the maximum is narrower than the grid: then it is as the equations have it
    return fit.covariance;
  }
  const Matrix6 others = covariance - follows * covariance.block<2, 2>(3, 3) * follows.transpose();
  return turnedCovariance(others + moments / sum, fit.plane.rotation);
}
} // namespace circle_marker
END_VISP_NAMESPACE
