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
 * Fit of an ellipse to points.
 */

#include "ellipse/fit_conic.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

//! Points that are treated together: compilers make vector instructions of it.
constexpr int laneCount = 4;
using Lanes = Eigen::Array<double, laneCount, 1>;

//! Some points, each with its share of the sums; where there are no more, the last one again, without any.
struct PointLanes
{
  Lanes x;
  Lanes y;
  Lanes weight;
};

/*! The points as given, and the affine map u = W (x - mean) that makes their scatter the unit matrix. */
struct WhitenedPoints
{
  const Eigen::Vector2d *points;
  std::size_t size;
  double weight; // of each: their sum is one
  Eigen::Vector2d mean;
  Eigen::Matrix2d W;

  //! Calls use(lanes) for all points, whitened.
  template <class Use> void forEach(const Use &use) const
  {
    PointLanes lanes;
    for (std::size_t first = 0; first < size; first += laneCount) {
      for (int k = 0; k < laneCount; ++k) {
        const std::size_t i = std::min(first + static_cast<std::size_t>(k), size - 1);
        lanes.x[k] = points[i].x() - mean.x();
        lanes.y[k] = points[i].y() - mean.y();
        lanes.weight[k] = first + static_cast<std::size_t>(k) < size ? weight : 0.;
      }
      const Lanes x = lanes.x;
      lanes.x = W(0, 0) * x + W(0, 1) * lanes.y;
      lanes.y = W(1, 0) * x + W(1, 1) * lanes.y;
      use(lanes);
    }
  }
};

std::optional<WhitenedPoints> whiten(const Eigen::Vector2d *points, std::size_t size)
{
  constexpr std::size_t parameters = 5; // of an ellipse
  if (size < parameters) {
    return std::nullopt;
  }
  WhitenedPoints whitened{points, size, 1. / static_cast<double>(size), Eigen::Vector2d::Zero(),
                          Eigen::Matrix2d::Identity()};
  for (std::size_t i = 0; i < size; i++) {
    if (!points[i].allFinite()) {
      return std::nullopt;
    }
    whitened.mean += points[i];
  }
  whitened.mean /= static_cast<double>(size);

  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (std::size_t i = 0; i < size; i++) {
    const Eigen::Vector2d d = points[i] - whitened.mean;
    scatter += whitened.weight * d * d.transpose();
  }
  // Points on a line: a spread across it below this share of the spread along it is rounding, not shape. The scatter
  // has the squares of both, so that this is well above the square root of its own rounding, 1.5e-8.
  const double leastRatio = 1e-7;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen;
  eigen.computeDirect(scatter);
  const double minor = eigen.eigenvalues()(0), major = eigen.eigenvalues()(1);
  if (!(major > 0.) || !(minor > leastRatio * leastRatio * major) || !std::isfinite(major)) {
    return std::nullopt;
  }
  whitened.W = eigen.eigenvectors().transpose();
  whitened.W.row(0) /= std::sqrt(minor);
  whitened.W.row(1) /= std::sqrt(major);
  return whitened;
}

//! Sums of products of the monomials of a conic's coefficients, u^2, u v, v^2, u, v and 1: they are moments.
Matrix6d scatterOf(const WhitenedPoints &points)
{
  // By the powers of u and v: the exponents of each monomial add up.
  constexpr int order = 4;
  std::array<std::array<Lanes, order + 1>, order + 1> moments;
  for (auto &byU : moments) {
    for (Lanes &moment : byU) {
      moment.setZero();
    }
  }
  points.forEach([&](const PointLanes &p) {
    Lanes powerOfU = p.weight;
    for (std::size_t i = 0; i <= order; ++i) {
      Lanes power = powerOfU;
      for (std::size_t j = 0; j <= order - i; ++j) {
        moments[i][j] += power;
        power *= p.y;
      }
      powerOfU *= p.x;
    }
  });
  constexpr std::size_t ofU[6] = {2, 1, 0, 1, 0, 0};
  constexpr std::size_t ofV[6] = {0, 1, 2, 0, 1, 0};
  Matrix6d scatter;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      scatter(i, j) = moments[ofU[i] + ofU[j]][ofV[i] + ofV[j]].sum();
    }
  }
  return scatter;
}

//! Positive for an ellipse.
double discriminant(const Vector6d &conic)
{
  return 4. * conic(0) * conic(2) - conic(1) * conic(1);
}

/*!
  Least algebraic distance under the constraint discriminant = 1. The linear part is eliminated as by Halir and Flusser
  (equations 23 to 26). In p = (a + c, a - c, b) the discriminant is p0^2 - p1^2 - p2^2, and the condition for the
  minimum, (R - l diag(1, -1, -1)) p = 0 with R = [alpha, beta^T; beta, Gamma], leaves one unknown:
  f(l) = alpha - l - beta^T (Gamma + l I)^-1 beta = 0. f is concave, f(0) >= 0 >= f(alpha), and its only root l >= 0 is
  the ellipse: Newton from alpha converges monotonically, and no eigenvector of an unsymmetric matrix is needed.
*/
std::optional<Vector6d> fitDirectly(const WhitenedPoints &points)
{
  const Matrix6d S = scatterOf(points);
  const Eigen::Matrix3d S2 = S.topRightCorner<3, 3>();
  // Of whitened points the scatter of (u, v, 1) is the unit matrix, up to rounding.
  const Eigen::Matrix3d T = -Eigen::Matrix3d(S.bottomRightCorner<3, 3>()).inverse() * S2.transpose();
  Eigen::Matrix3d toCoefficients; // (a, b, c) from p
  toCoefficients << 0.5, 0.5, 0., 0., 0., 1., 0.5, -0.5, 0.;
  const Eigen::Matrix3d R = toCoefficients.transpose() * (S.topLeftCorner<3, 3>() + S2 * T) * toCoefficients;

  double l = R(0, 0);
  Eigen::Vector2d z = Eigen::Vector2d::Zero();
  const int maximumIterations = 50; // Quadratic convergence at the end: about ten are used for a short arc.
  for (int i = 0; i < maximumIterations; i++) {
    const Eigen::Matrix2d shifted = R.bottomRightCorner<2, 2>() + l * Eigen::Matrix2d::Identity();
    z = -shifted.inverse() * R.bottomLeftCorner<2, 1>();
    const double value = R(0, 0) - l + R.bottomLeftCorner<2, 1>().dot(z);
    const double slope = z.squaredNorm() - 1.;
    if (!(slope < 0.) || !(value < 0.)) {
      break;
    }
    l -= value / slope;
  }
  Vector6d conic;
  conic.head<3>() = toCoefficients * Eigen::Vector3d(1., z(0), z(1));
  conic.tail<3>() = T * conic.head<3>();
  conic.normalize();
  return (conic.allFinite() && discriminant(conic) > 0.) ? std::optional<Vector6d>(conic) : std::nullopt;
}

/*! Sum of squared Sampson distances, in the original coordinates, and its normal equations. */
struct NormalEquations
{
  double cost = 0.;
  Vector6d gradient = Vector6d::Zero();
  Matrix6d hessian = Matrix6d::Zero();
};

// Of the last candidate of a fit only the cost is asked for, which takes a third of the time.
NormalEquations sampsonEquations(const WhitenedPoints &points, const Vector6d &conic, bool onlyCost = false)
{
  const Eigen::Matrix2d metric = points.W * points.W.transpose();
  Lanes cost = Lanes::Zero();
  std::array<Lanes, 6> gradient;
  std::array<std::array<Lanes, 6>, 6> hessian; // its lower triangle
  for (std::size_t j = 0; j < 6; ++j) {
    gradient[j].setZero();
    for (Lanes &product : hessian[j]) {
      product.setZero();
    }
  }
  points.forEach([&](const PointLanes &p) {
    const Lanes slopeX = 2. * conic(0) * p.x + conic(1) * p.y + conic(3);
    const Lanes slopeY = conic(1) * p.x + 2. * conic(2) * p.y + conic(4);
    // By Euler's theorem on homogeneous functions.
    const Lanes value = 0.5 * (p.x * (slopeX + conic(3)) + p.y * (slopeY + conic(4))) + conic(5);
    const Lanes steepestX = metric(0, 0) * slopeX + metric(0, 1) * slopeY;
    const Lanes steepestY = metric(1, 0) * slopeX + metric(1, 1) * slopeY;
    const Lanes squaredLength = slopeX * steepestX + slopeY * steepestY;
    // At the centre, where there is no distance, a point counts nothing.
    const Lanes perSquare = (squaredLength > 0.).select(squaredLength.inverse(), 0.);
    const Lanes perLength = perSquare.sqrt();
    const Lanes distance = value * perLength;
    cost += p.weight * distance * distance;
    if (onlyCost) {
      return;
    }
    // Derivative of value / length: that of the length is h . d(slope), with h the metric's unit covector.
    const Lanes hx = distance * perLength * steepestX; // times the distance
    const Lanes hy = distance * perLength * steepestY;
    const std::array<Lanes, 6> J = {perLength * p.x * (p.x - 2. * hx),
                                    perLength * (p.x * p.y - p.y * hx - p.x * hy),
                                    perLength * p.y * (p.y - 2. * hy),
                                    perLength * (p.x - hx),
                                    perLength * (p.y - hy),
                                    perLength};
    for (std::size_t j = 0; j < 6; ++j) {
      const Lanes weighted = p.weight * J[j];
      gradient[j] += weighted * distance;
      for (std::size_t k = 0; k <= j; ++k) {
        hessian[j][k] += weighted * J[k];
      }
    }
  });
  NormalEquations equations;
  equations.cost = cost.sum();
  for (std::size_t j = 0; j < 6; ++j) {
    const auto row = static_cast<Eigen::Index>(j);
    equations.gradient[row] = gradient[j].sum();
    for (std::size_t k = 0; k <= j; ++k) {
      const auto column = static_cast<Eigen::Index>(k);
      equations.hessian(row, column) = hessian[j][k].sum();
      equations.hessian(column, row) = equations.hessian(row, column);
    }
  }
  return equations;
}

//! Gauss-Newton on the unit sphere of the coefficients; steps that leave the ellipses or raise the cost are halved.
Vector6d refine(const WhitenedPoints &points, Vector6d conic, const FitLimits &limits)
{
  if (limits.iterations == 0) {
    return conic;
  }
  const int maximumHalvings = 4; // A sixteenth of a Gauss-Newton step that does not help: at the minimum.
  NormalEquations equations = sampsonEquations(points, conic);
  for (int iteration = 0; iteration < limits.iterations; iteration++) {
    Matrix6d H = equations.hessian;
    // The distance does not depend on the scale of the coefficients: fix that direction.
    H += H.trace() * conic * conic.transpose();
    Vector6d step = -H.ldlt().solve(equations.gradient);
    if (!step.allFinite()) {
      break;
    }
    if (-equations.gradient.dot(step) < limits.leastGain * equations.cost) {
      break;
    }
    const bool isLast = iteration + 1 == limits.iterations;
    bool better = false;
    for (int halving = 0; halving <= maximumHalvings && !better; halving++) {
      const Vector6d candidate = (conic + step).normalized();
      if (discriminant(candidate) > 0.) {
        const NormalEquations next = sampsonEquations(points, candidate, isLast);
        if (next.cost < equations.cost) {
          conic = candidate;
          equations = next;
          better = true;
          break;
        }
      }
      step *= 0.5;
    }
    if (!better || step.norm() < limits.leastStep) {
      break;
    }
  }
  return conic;
}
} // namespace

std::optional<Eigen::Matrix3d> fitEllipse(const Eigen::Vector2d *points, std::size_t size, const FitLimits &limits)
{
  const std::optional<WhitenedPoints> whitened = whiten(points, size);
  if (!whitened) {
    return std::nullopt;
  }
  const std::optional<Vector6d> start = fitDirectly(*whitened);
  if (!start) {
    return std::nullopt;
  }
  const Vector6d c = refine(*whitened, *start, limits);

  Eigen::Matrix3d Q;
  Q << c(0), 0.5 * c(1), 0.5 * c(3), 0.5 * c(1), c(2), 0.5 * c(4), 0.5 * c(3), 0.5 * c(4), c(5);
  Eigen::Matrix3d T = Eigen::Matrix3d::Identity();
  T.topLeftCorner<2, 2>() = whitened->W;
  T.topRightCorner<2, 1>() = -whitened->W * whitened->mean;
  Q = T.transpose() * Q * T;
  Q = (0.5 / Q.norm()) * (Q + Q.transpose().eval());
  // What the rounding of the way back may have made of a hardly visible ellipse is for the caller to refuse too.
  return centerConic(Q) ? std::optional<Eigen::Matrix3d>(Q) : std::nullopt;
}
} // namespace circle_marker
END_VISP_NAMESPACE
