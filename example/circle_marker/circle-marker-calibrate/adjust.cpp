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
 * Least squares over the camera and all poses of the target.
 */

#include "adjust.h"

#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace calibrate {
namespace {
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

enum class Poses
{
  Sought,
  Known
};

/*! The normal equations of one view: [U W; W' V] for lens and pose. */
struct ViewEquations
{
  Matrix6 V = Matrix6::Zero();
  Eigen::MatrixXd W;
  Vector6 right = Vector6::Zero();
};

struct Equations
{
  Eigen::MatrixXd U;
  Eigen::VectorXd right;
  std::vector<ViewEquations> views;
};

constexpr double impossible = 1e30; // the cost of a camera that cannot see a point

double costOf(const Target &target, const std::vector<View> &views, const Lens &lens,
              const std::vector<TargetPose> &poses)
{
  double cost = 0.;
  for (std::size_t v = 0; v < views.size(); ++v) {
    for (const Observation &o : views[v].observations) {
      const auto image = lens.project(poses[v] * target.points[o.point].place);
      if (!image) {
        return impossible;
      }
      cost += (o.pixel - *image).squaredNorm();
    }
  }
  return std::isfinite(cost) ? cost : impossible;
}

/*! Central differences of a point's image with respect to a number; the models are smooth. */
template <class Image> Eigen::Vector2d derivative(const Image &image, double step)
{
  const auto ahead = image(step), behind = image(-step);
  return ahead && behind ? Eigen::Vector2d((*ahead - *behind) / (2. * step)) : Eigen::Vector2d::Zero();
}

/*! A step of a lens's number for differences: its effect is a small part of a pixel, and far above rounding. */
double stepOf(const Lens &lens, int number)
{
  return number < 4 ? 1e-4 * std::max(1., std::abs(lens.numbers[0]) * 1e-3) : 1e-6;
}

void accumulate(const Target &target, const View &view, const Lens &lens, const TargetPose &pose, Equations &all,
                ViewEquations &equations)
{
  const auto n = lens.numbers.size();
  equations.W = Eigen::MatrixXd::Zero(n, 6);
  Eigen::MatrixXd JLens(2, n);
  Eigen::Matrix<double, 2, 6> JPose;
  for (const Observation &o : view.observations) {
    const Eigen::Vector2d place = target.points[o.point].place;
    const Eigen::Vector3d X = pose * place;
    const auto image = lens.project(X);
    if (!image) {
      continue;
    }
    for (int i = 0; i < n; ++i) {
      JLens.col(i) = derivative(
          [&](double step) {
            Lens other = lens;
            other.numbers[i] += step;
            return other.project(X);
          },
          stepOf(lens, i));
    }
    Eigen::Matrix<double, 2, 3> JPoint;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d axis = Eigen::Vector3d::Unit(i);
      JPoint.col(i) = derivative([&](double step) { return lens.project(X + step * axis); }, 1e-6 * X.z());
    }
    JPose.leftCols<3>() = JPoint;
    const Eigen::Vector3d Y = X - pose.translation;
    Eigen::Matrix3d cross;
    cross << 0., -Y.z(), Y.y(), Y.z(), 0., -Y.x(), -Y.y(), Y.x(), 0.;
    JPose.rightCols<3>() = -JPoint * cross;
    const Eigen::Vector2d residual = o.pixel - *image;
    all.U += JLens.transpose() * JLens;
    all.right += JLens.transpose() * residual;
    equations.W += JLens.transpose() * JPose;
    equations.V += JPose.transpose() * JPose;
    equations.right += JPose.transpose() * residual;
  }
}

Equations equationsOf(const Target &target, const std::vector<View> &views, const Adjustment &a)
{
  const auto n = a.lens.numbers.size();
  Equations all{Eigen::MatrixXd::Zero(n, n), Eigen::VectorXd::Zero(n), std::vector<ViewEquations>(views.size())};
  for (std::size_t v = 0; v < views.size(); ++v) {
    accumulate(target, views[v], a.lens, a.poses[v], all, all.views[v]);
  }
  return all;
}

/*! The lens's normal matrix without the poses, damped; and its right side. */
void reduce(const Equations &all, Poses kind, double damping, Eigen::MatrixXd &S, Eigen::VectorXd &right)
{
  S = all.U;
  S.diagonal() *= 1. + damping;
  right = all.right;
  if (kind == Poses::Known) {
    return;
  }
  for (const ViewEquations &view : all.views) {
    Matrix6 V = view.V;
    V.diagonal() *= 1. + damping;
    const Eigen::Matrix<double, 6, Eigen::Dynamic> solved = V.ldlt().solve(view.W.transpose());
    S -= view.W * solved;
    right -= solved.transpose() * view.right;
  }
}

void moveBy(const Equations &all, Poses kind, double damping, const Adjustment &from, Adjustment &to)
{
  Eigen::MatrixXd S;
  Eigen::VectorXd right;
  reduce(all, kind, damping, S, right);
  const Eigen::VectorXd step = S.ldlt().solve(right);
  to.lens.numbers = from.lens.numbers + step;
  for (std::size_t v = 0; v < from.poses.size() && kind == Poses::Sought; ++v) {
    Matrix6 V = all.views[v].V;
    V.diagonal() *= 1. + damping;
    const Vector6 own = V.ldlt().solve(all.views[v].right - all.views[v].W.transpose() * step);
    to.poses[v] = from.poses[v].moved(own);
  }
}

/*! Covariance and condition at the minimum. */
void judge(const Target &target, const std::vector<View> &views, Poses kind, Adjustment &a)
{
  Eigen::MatrixXd S;
  Eigen::VectorXd right;
  reduce(equationsOf(target, views, a), kind, 0., S, right);
  const Eigen::VectorXd scale = S.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * S * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scaled);
  const double least = eigen.eigenvalues().minCoeff();
  a.condition = least > 0. ? eigen.eigenvalues().maxCoeff() / least : HUGE_VAL;
  const double sigma2 = a.sigma() * a.sigma();
  a.covariance = sigma2 * Eigen::MatrixXd(scale.asDiagonal() * scaled.inverse() * scale.asDiagonal());
}

Adjustment minimise(const Target &target, const std::vector<View> &views, const Adjustment &start, Poses kind)
{
  constexpr int mostSteps = 200;
  constexpr double enough = 1e-10; // relative decrease of the cost below which nothing more is to be had
  Adjustment best = start;
  best.points = 0;
  for (const View &view : views) {
    best.points += view.observations.size();
  }
  best.cost = costOf(target, views, best.lens, best.poses);
  best.converged = false;
  double damping = 1e-3;
  for (int i = 0; i < mostSteps && !best.converged && best.cost < impossible; ++i) {
    const Equations all = equationsOf(target, views, best);
    bool isBetter = false;
    while (!isBetter && damping < 1e12) {
      Adjustment next = best;
      moveBy(all, kind, damping, best, next);
      next.cost = costOf(target, views, next.lens, next.poses);
      isBetter = next.cost < best.cost;
      if (isBetter) {
        best.converged = best.cost - next.cost <= enough * best.cost;
        next.converged = best.converged;
        best = next;
        damping = std::max(1e-12, 0.1 * damping);
      }
      else {
        damping *= 10.;
      }
    }
    best.converged = best.converged || !isBetter; // no step is better: the minimum, to rounding
  }
  if (best.cost < impossible) {
    judge(target, views, kind, best);
  }
  return best;
}
} // namespace

double Adjustment::rms() const
{
  return std::sqrt(cost / static_cast<double>(points));
}

double Adjustment::sigma() const
{
  const double unknowns = static_cast<double>(lens.numbers.size()) + 6. * static_cast<double>(poses.size());
  return std::sqrt(cost / std::max(1., 2. * static_cast<double>(points) - unknowns));
}

Adjustment adjust(const Target &target, const std::vector<View> &views, const Adjustment &start)
{
  return minimise(target, views, start, Poses::Sought);
}

Adjustment adjustLens(const Target &target, const std::vector<View> &views, const Adjustment &start)
{
  return minimise(target, views, start, Poses::Known);
}

std::vector<std::vector<Eigen::Vector2d>> residualsOf(const Target &target, const std::vector<View> &views,
                                                      const Adjustment &adjustment)
{
  std::vector<std::vector<Eigen::Vector2d>> residuals(views.size());
  for (std::size_t v = 0; v < views.size(); ++v) {
    for (const Observation &o : views[v].observations) {
      const auto image = adjustment.lens.project(adjustment.poses[v] * target.points[o.point].place);
      residuals[v].push_back(image ? Eigen::Vector2d(o.pixel - *image) : Eigen::Vector2d::Zero());
    }
  }
  return residuals;
}
} // namespace calibrate
