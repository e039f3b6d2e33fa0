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

#include <Eigen/Cholesky>

#include "refine/grey_model.h"
#include "support/symmetric_eigen.h"

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
// Below that it may be chance, and counts as if so many degrees of freedom had told that it is 1. Its own are 40 of a
// golay23 and 25 of a plain ring: 1.2 is within chance, and is what a picture has that was drawn with 8 x 8 samples a
// pixel.
constexpr double expectedFreedom = 50.;

using PoseColumn = Eigen::Matrix<double, poseSize, 1>;
using PoseMatrix = Eigen::Matrix<double, poseSize, poseSize>;

// What a part of the pixels does to the pose, in coordinates in which that is known as well in all directions: there
// independent noise of variance 1 gives it the covariance 1. A spin that is not fitted does not move.
struct Part
{
  PoseColumn motion = PoseColumn::Zero();      // by its pull
  PoseMatrix information = PoseMatrix::Zero(); // covariance of that motion with independent noise of variance 1
  bool isSeen = false;
};

using Parts = std::array<Part, directions>;

// The influence times a part's matrix, of which the triangle is given, row by row.
PoseInfluence movedBy(const ProductSums &products, const PoseInfluence &influence)
{
  PoseInfluence moved(poseSize, influence.cols());
  std::size_t k = 0;
  for (Eigen::Index i = 0; i < influence.cols(); ++i) {
    PoseColumn sum = PoseColumn::Zero();
    for (Eigen::Index j = 0; j < i; ++j) {
      sum += products[k] * influence.col(j);
      moved.col(j) += products[k++] * influence.col(i);
    }
    moved.col(i) = sum + products[k++] * influence.col(i);
  }
  return moved;
}

// influence: in these coordinates; step: the last one from where the sums were made.
Part partOf(const ProductSums &products, const PullSums &pulls, const PoseInfluence &influence, const UsedVector &step)
{
  Part part;
  part.isSeen = products[0] > 0.;
  if (!part.isSeen) {
    return part;
  }
  const PoseInfluence moved = movedBy(products, influence);
  for (Eigen::Index i = 0; i < step.size(); ++i) {
    part.motion += pulls[static_cast<std::size_t>(i)] * influence.col(i) - step[i] * moved.col(i);
    part.information += moved.col(i).lazyProduct(influence.col(i).transpose());
  }
  return part;
}

// By how much the parts together move the pose more than independent noise would.
struct Excess
{
  // As far as a ratio within chance is to be believed. Less than independent noise does is always chance.
  double shrunk() const { return std::max((expectedFreedom + ratio * freedom) / (expectedFreedom + freedom), 1.); }

  double ratio = 1.;                          // mean over the pose's parameters
  double freedom = 0.;                        // its degrees of freedom; 0 if too few parts are seen to tell
  bool isClear = false;                       // whether it is above what chance may do
  PoseMatrix covariance = PoseMatrix::Zero(); // the parts' covariance of the pose, with noise of variance 1
};

// The first parts, so many; fitted: number of the pose's parameters that are fitted.
Excess excessOf(const Parts &parts, std::size_t count, int fitted, double noise)
{
  PoseMatrix moved = PoseMatrix::Zero();
  double squaredShares = 0.;
  std::size_t seen = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const Part &part = parts[k];
    moved += part.motion.lazyProduct(part.motion.transpose());
    squaredShares += part.information.squaredNorm() / fitted;
    seen += part.isSeen ? 1 : 0;
  }
  if (static_cast<double>(seen) < leastParts * static_cast<double>(count)) {
    return {};
  }
  // The motions' sum is 0 after the fit, which takes a little away; the share of each part in what is known tells how
  // much that is, and how much the ratio varies by chance.
  const PoseMatrix covariance = moved / (pullOfNoise * noise * noise * (1. - squaredShares));
  const double ratio = covariance.trace() / fitted;
  // By chance it is distributed as chi^2 / n, whose variance is 2 / n; its quantile by Wilson and Hilferty (Proceedings
  // of the National Academy of Sciences 17, 1931).
  const double perFreedom = 2. / 9. * squaredShares / fitted;
  const double mostByChance = std::pow(1. - perFreedom + clearOfChance * std::sqrt(perFreedom), 3.);
  return {ratio, fitted / squaredShares, ratio > mostByChance, covariance};
}

// The first of the parts become each one with the one that follows it.
void takeTogether(Parts &parts, std::size_t count)
{
  for (std::size_t k = 0; k + 1 < count; k += 2) {
    parts[k / 2] = {parts[k].motion + parts[k + 1].motion, parts[k].information + parts[k + 1].information,
                    parts[k].isSeen || parts[k + 1].isSeen};
  }
}

// The covariance widened: by the mean ratio, and in the directions in which the parts move the pose more than that, by
// as much as they do there. Where they move it less they are too few to tell. root: of the covariance, L of L L'.
PoseMatrix widened(const PoseMatrix &root, const Excess &excess)
{
  const SymmetricEigen eigen = symmetricEigen(excess.covariance);
  const PoseMatrix axes = root * eigen.vectors;
  return axes * eigen.values.cwiseMax(excess.ratio).asDiagonal() * axes.transpose();
}
} // namespace

CoherentCovariance Likelihood::coherentCovariance(const PoseInfluence &influence, const UsedVector &step,
                                                  double noise) const
{
  CoherentCovariance coherent = {influence.leftCols<poseSize>(), 1.};
  const int fitted = m_settings.spinIsKnown ? poseSize : spinAt;
  const Eigen::LLT<PoseMatrix> decomposed(coherent.covariance);
  // Of a spin that is not fitted the equations have a 1 on the diagonal and nothing else, and so has the root.
  const PoseMatrix root = decomposed.matrixL();
  if (decomposed.info() != Eigen::Success) {
    return coherent;
  }
  PoseInfluence even = root.triangularView<Eigen::Lower>().solve(influence);
  even.bottomRows(poseSize - fitted).setZero();
  Parts parts;
  const std::size_t seen = std::min(m_memory.sums.products.size(), directions);
  for (std::size_t k = 0; k < seen; ++k) {
    parts[k] = partOf(m_memory.sums.products[k], m_memory.sums.pulls[k], even, step);
  }
  std::size_t count = directions;
  const Excess finest = excessOf(parts, count, fitted, noise);
  Excess largest = finest;
  while (count > leastCount) {
    takeTogether(parts, count);
    count /= 2;
    const Excess excess = excessOf(parts, count, fitted, noise);
    const bool isLarger = !largest.isClear || excess.ratio > largest.ratio;
    largest = excess.isClear && isLarger ? excess : largest;
  }
  if (largest.isClear) {
    coherent.ratio = largest.ratio;
    coherent.covariance = widened(root, largest);
  }
  else {
    coherent.covariance *= finest.shrunk();
  }
  return coherent;
}
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE
