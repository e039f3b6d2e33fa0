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
 * What neighbouring pixels pull together.
 */

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "refine/grey_model.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
namespace {
// Neighbouring directions are taken together, two and two, down to this number of parts: what is the same over a wide
// part of the marker shows when wide parts are compared, what is not when there are many of them.
constexpr std::size_t leastCount = 8;
// With fewer parts of it that have pixels than this share, their pulls tell nothing.
constexpr double leastParts = 0.75;
// The ratio counts if it is above what independent noise exceeds with the probability of this many standard deviations
// of a normal distribution: once in 740.
constexpr double clearOfChance = 3.;
// With normal noise, mean of (w r)^2 over that of w for the biweight's weights w.
constexpr double pullOfNoise = 0.6605;

using PoseColumn = Eigen::Matrix<double, poseSize, 1>;

// What a part of the pixels does to the pose; without its spin if that is not fitted.
template <int fitted> struct Part
{
  Eigen::Matrix<double, fitted, 1> motion = Eigen::Matrix<double, fitted, 1>::Zero(); // by its pull
  // Covariance of that motion with independent noise of variance 1.
  Eigen::Matrix<double, fitted, fitted> information = Eigen::Matrix<double, fitted, fitted>::Zero();
  bool isSeen = false;
};

template <int fitted> using Parts = std::array<Part<fitted>, directions>;

// The influence times a part's matrix, of which the triangle is given, row by row. used: number of parameters.
PoseInfluence movedBy(const ProductSums &products, const PoseInfluence &influence, int used)
{
  PoseInfluence moved;
  std::size_t k = 0;
  for (int i = 0; i < used; ++i) {
    PoseColumn sum = PoseColumn::Zero();
    for (int j = 0; j < i; ++j) {
      sum += products[k] * influence.col(j);
      moved.col(j) += products[k++] * influence.col(i);
    }
    moved.col(i) = sum + products[k++] * influence.col(i);
  }
  return moved;
}

// step: the last one from where the sums were made.
template <int fitted>
Part<fitted> partOf(const ProductSums &products, const PullSums &pulls, const PoseInfluence &influence,
                    const ParameterVector &step, int used)
{
  Part<fitted> part;
  part.isSeen = products[0] > 0.;
  if (!part.isSeen) {
    return part;
  }
  const PoseInfluence moved = movedBy(products, influence, used);
  PoseColumn motion = PoseColumn::Zero();
  Eigen::Matrix<double, poseSize, poseSize> information = Eigen::Matrix<double, poseSize, poseSize>::Zero();
  for (int i = 0; i < used; ++i) {
    motion += pulls[static_cast<std::size_t>(i)] * influence.col(i) - step[i] * moved.col(i);
    information += moved.col(i).lazyProduct(influence.col(i).transpose());
  }
  part.motion = motion.head<fitted>();
  part.information = information.topLeftCorner<fitted, fitted>();
  return part;
}

// By how much the parts together move the pose more than independent noise would.
template <int fitted> struct Excess
{
  double ratio = 1.; // mean over the pose's parameters; 1 if that is within chance
  // The parts' covariance of the pose, with noise of variance 1 if it were independent.
  Eigen::Matrix<double, fitted, fitted> covariance = Eigen::Matrix<double, fitted, fitted>::Zero();
};

// known: inverse of the covariance of the pose with independent noise of variance 1.
template <int fitted>
Excess<fitted> excessOf(const Parts<fitted> &parts, std::size_t count,
                        const Eigen::Matrix<double, fitted, fitted> &known, double noise)
{
  using PoseMatrix = Eigen::Matrix<double, fitted, fitted>;
  PoseMatrix moved = PoseMatrix::Zero();
  double squaredShares = 0.;
  std::size_t seen = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const Part<fitted> &part = parts[k];
    moved += part.motion * part.motion.transpose();
    const PoseMatrix share = known.lazyProduct(part.information);
    squaredShares += share.cwiseProduct(share.transpose()).sum() / fitted; // trace of its square
    seen += part.isSeen ? 1 : 0;
  }
  if (static_cast<double>(seen) < leastParts * static_cast<double>(count)) {
    return {};
  }
  // The motions' sum is 0 after the fit, which takes a little away; the share of each part in what is known tells how
  // much that is, and how much the ratio varies by chance.
  const PoseMatrix covariance = moved / (pullOfNoise * noise * noise * (1. - squaredShares));
  const double ratio = known.cwiseProduct(covariance).sum() / fitted; // trace of the product
  // By chance it is distributed as chi^2 / n, whose variance is 2 / n; its quantile by Wilson and Hilferty (Proceedings
  // of the National Academy of Sciences 17, 1931).
  const double perFreedom = 2. / 9. * squaredShares / fitted;
  const double mostByChance = std::pow(1. - perFreedom + clearOfChance * std::sqrt(perFreedom), 3.);
  return ratio > mostByChance ? Excess<fitted>{ratio, covariance} : Excess<fitted>();
}

// The first of the parts become each one with the one that follows it.
template <int fitted> void takeTogether(Parts<fitted> &parts, std::size_t count)
{
  for (std::size_t k = 0; k + 1 < count; k += 2) {
    parts[k / 2] = {parts[k].motion + parts[k + 1].motion, parts[k].information + parts[k + 1].information,
                    parts[k].isSeen || parts[k + 1].isSeen};
  }
}

// The covariance widened: by the mean ratio, and in the directions in which the parts move the pose more than that, by
// as much as they do there. Where they move it less they are too few to tell.
template <int fitted>
Eigen::Matrix<double, fitted, fitted> widened(const Eigen::Matrix<double, fitted, fitted> &covariance,
                                              const Excess<fitted> &excess)
{
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix<double, fitted, fitted>> solver(excess.covariance,
                                                                                               covariance);
  const Eigen::Matrix<double, fitted, fitted> axes = covariance * solver.eigenvectors();
  return axes * solver.eigenvalues().cwiseMax(excess.ratio).asDiagonal() * axes.transpose();
}

template <int fitted>
CoherentCovariance coherentCovarianceOf(const PassSums &sums, const PoseInfluence &influence,
                                        const ParameterVector &step, double noise, int used)
{
  const Eigen::Matrix<double, fitted, fitted> known = influence.topLeftCorner<fitted, fitted>().inverse();
  Parts<fitted> parts;
  const std::size_t seen = std::min(sums.products.size(), directions);
  for (std::size_t k = 0; k < seen; ++k) {
    parts[k] = partOf<fitted>(sums.products[k], sums.pulls[k], influence, step, used);
  }
  std::size_t count = directions;
  Excess<fitted> largest = excessOf<fitted>(parts, count, known, noise);
  while (count > leastCount) {
    takeTogether<fitted>(parts, count);
    count /= 2;
    const Excess<fitted> excess = excessOf<fitted>(parts, count, known, noise);
    largest = excess.ratio > largest.ratio ? excess : largest;
  }
  CoherentCovariance coherent = {influence.leftCols<poseSize>(), largest.ratio};
  if (coherent.ratio > 1.) {
    coherent.covariance.topLeftCorner(fitted, fitted) =
        widened<fitted>(coherent.covariance.template topLeftCorner<fitted, fitted>(), largest);
  }
  return coherent;
}
} // namespace

CoherentCovariance Likelihood::coherentCovariance(const PoseInfluence &influence, const ParameterVector &step,
                                                  double noise, int used) const
{
  return m_settings.spinIsKnown ? coherentCovarianceOf<poseSize>(m_memory.sums, influence, step, noise, used)
                                : coherentCovarianceOf<spinAt>(m_memory.sums, influence, step, noise, used);
}
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE
