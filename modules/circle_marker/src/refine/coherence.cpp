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

#include <array>
#include <cmath>

#include <Eigen/Cholesky>

#include "refine/grey_model.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Clusters of neighbouring pixels whose pulls on the parameters are compared with what independent noise would give.
constexpr std::size_t clusters = 32;
// Fewer than this, and they tell nothing.
constexpr std::size_t leastClusters = 10;
// The ratio counts if it is above that of independent noise by this many of its standard deviations.
constexpr double clearOfChance = 3.;
// With normal noise, mean of (w r)^2 over that of w for the biweight's weights w.
constexpr double pullOfNoise = 0.6605;
} // namespace

double Likelihood::coherence(const MarkerPlane &plane, const Photometry &photometry, double noise) const
{
  const PixelBlocks &blocks = m_memory.blocks;
  const std::size_t count = blocks.bySight[0].size() + blocks.bySight[1].size() + blocks.bySight[2].size();
  const std::size_t blocksOfCluster = (count + clusters - 1) / clusters;
  if (count < leastClusters) {
    return 1.;
  }
  const ImageModel model(plane, m_pattern, photometry.blur, blocks);
  DarknessLanes darkness;
  RowLanes row;
  using PoseMatrix = Eigen::Matrix<double, poseSize, poseSize>;
  PoseMatrix all = PoseMatrix::Zero(), pulls = PoseMatrix::Zero();
  std::array<PoseMatrix, clusters> information;
  std::size_t cluster = 0, k = 0;
  PoseMatrix ofCluster = PoseMatrix::Zero();
  Eigen::Matrix<double, poseSize, 1> pull = Eigen::Matrix<double, poseSize, 1>::Zero();
  const auto close = [&]() {
    all += ofCluster;
    pulls += pull * pull.transpose();
    information[cluster++] = ofCluster;
    ofCluster.setZero();
    pull.setZero();
  };
  forEachBlock(blocks, [&](const PixelBlock &block, PixelSight sight) {
    model.evaluate(block, sight, darkness);
    const GreyLanes grey = greyOf(block, photometry, darkness.value);
    rowOf(block, photometry, darkness, grey, row);
    const LossLanes loss = biweight(grey.residual, block.variance, static_cast<float>(noise));
    for (int i = 0; i < poseSize; ++i) {
      const Lanes weighted = loss.weight * row[static_cast<std::size_t>(i)];
      pull[i] += static_cast<double>((weighted * grey.residual).sum());
      for (int j = 0; j <= i; ++j) {
        ofCluster(i, j) += static_cast<double>((weighted * row[static_cast<std::size_t>(j)]).sum());
        ofCluster(j, i) = ofCluster(i, j);
      }
    }
    if (++k % blocksOfCluster == 0) {
      close();
    }
  });
  if (k % blocksOfCluster != 0) {
    close();
  }
  // The pulls' sum is 0 after the fit, which takes a little away; the share of each cluster in what is known tells how
  // much that is, and how much the ratio varies by chance.
  const int fitted = m_settings.spinIsKnown ? poseSize : spinAt;
  const Eigen::LDLT<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, poseSize, poseSize>> known(
      all.topLeftCorner(fitted, fitted));
  double squaredShares = 0.;
  for (std::size_t i = 0; i < cluster; ++i) {
    const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, poseSize, poseSize> share =
        known.solve(information[i].topLeftCorner(fitted, fitted));
    squaredShares += (share * share).trace() / fitted;
  }
  const double expected = pullOfNoise * noise * noise * (1. - squaredShares);
  const double ratio = known.solve(pulls.topLeftCorner(fitted, fitted)).trace() / (fitted * expected);
  const double byChance = std::sqrt(2. * squaredShares / fitted);
  return ratio > 1. + clearOfChance * byChance ? ratio : 1.;
}
} // namespace circle_marker
END_VISP_NAMESPACE
