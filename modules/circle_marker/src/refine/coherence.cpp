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
inline namespace CIRCLE_MARKER_LANES {
namespace {
// With fewer clusters of pixels than this, their pulls tell nothing.
constexpr std::size_t leastClusters = 10;
// The ratio counts if it is above that of independent noise by this many of its standard deviations.
constexpr double clearOfChance = 3.;
// With normal noise, mean of (w r)^2 over that of w for the biweight's weights w.
constexpr double pullOfNoise = 0.6605;
} // namespace

double Likelihood::coherence(const ParameterVector &step, double noise) const
{
  const std::vector<ClusterSums> &clusters = m_memory.clusters;
  if (clusters.size() < leastClusters) {
    return 1.;
  }
  using PoseMatrix = Eigen::Matrix<double, poseSize, poseSize>;
  using PoseVector = Eigen::Matrix<double, poseSize, 1>;
  PoseMatrix all = PoseMatrix::Zero(), pulls = PoseMatrix::Zero();
  std::array<PoseMatrix, mostClusters> information;
  for (std::size_t c = 0; c < clusters.size(); ++c) {
    ParameterMatrix matrix;
    std::size_t k = 0;
    for (int i = 0; i < parameters; ++i) {
      for (int j = 0; j <= i; ++j) {
        matrix(i, j) = clusters[c][k++];
        matrix(j, i) = matrix(i, j);
      }
    }
    information[c] = matrix.topLeftCorner<poseSize, poseSize>();
    const PoseVector before = Eigen::Map<const PoseVector>(clusters[c].data() + products);
    const PoseVector pull = before - matrix.topRows<poseSize>() * step;
    all += information[c];
    pulls += pull * pull.transpose();
  }
  // The pulls' sum is 0 after the fit, which takes a little away; the share of each cluster in what is known tells how
  // much that is, and how much the ratio varies by chance.
  const int fitted = m_settings.spinIsKnown ? poseSize : spinAt;
  const Eigen::LDLT<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, poseSize, poseSize>> known(
      all.topLeftCorner(fitted, fitted));
  double squaredShares = 0.;
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, poseSize, poseSize> share =
        known.solve(information[i].topLeftCorner(fitted, fitted));
    squaredShares += (share * share).trace() / fitted;
  }
  const double expected = pullOfNoise * noise * noise * (1. - squaredShares);
  const double ratio = known.solve(pulls.topLeftCorner(fitted, fitted)).trace() / (fitted * expected);
  const double byChance = std::sqrt(2. * squaredShares / fitted);
  return ratio > 1. + clearOfChance * byChance ? ratio : 1.;
}
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE
