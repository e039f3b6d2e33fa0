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
 * Distance of a pose from the true one, by its covariance.
 */

#include <cmath>

#include <visp3/core/vpColVector.h>
#include <visp3/core/vpRotationMatrix.h>
#include <visp3/core/vpThetaUVector.h>

#include "pose_distance.h"

namespace common {
namespace {
/*! The estimate turned about its normal so that its spin is the true one. */
vpHomogeneousMatrix withSpinOf(const vpHomogeneousMatrix &truth, const vpHomogeneousMatrix &estimate)
{
  double c = 0.;
  double s = 0.;
  for (unsigned int row = 0; row < 3; ++row) {
    c += estimate[row][0] * truth[row][0];
    s += estimate[row][1] * truth[row][0];
  }
  const vpRotationMatrix spin(vpThetaUVector(0., 0., std::atan2(s, c)));
  return estimate * vpHomogeneousMatrix(vpTranslationVector(0., 0., 0.), spin);
}
} // namespace

double squaredMahalanobis(const vpHomogeneousMatrix &truth, const vpCircleMarkerDetection &detection)
{
  const vpHomogeneousMatrix cMo = detection.dof == 6 ? detection.cMo : withSpinOf(truth, detection.cMo);
  vpColVector error(6);
  const vpThetaUVector turn(vpRotationMatrix(truth) * vpRotationMatrix(cMo).t());
  for (unsigned int i = 0; i < 3; ++i) {
    error[i] = truth[i][3] - cMo[i][3];
    error[3 + i] = turn[i];
  }
  // In standard deviations, in which the numbers are well conditioned: lateral ones are a ten-thousandth of the turns.
  vpMatrix covariance = detection.covarianceAtMarker;
  for (unsigned int i = 0; i < 6; ++i) {
    const double sigma = std::sqrt(covariance[i][i]);
    error[i] /= sigma;
    for (unsigned int j = 0; j < 6; ++j) {
      covariance[i][j] /= sigma;
      covariance[j][i] /= sigma;
    }
  }
  return vpColVector::dotProd(error, covariance.inverseByLU() * error);
}
} // namespace common
