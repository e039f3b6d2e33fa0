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
 * Error of a pose in the terms of its covariance.
 */

#include <cmath>

#include <visp3/core/vpColVector.h>
#include <visp3/core/vpExponentialMap.h>
#include <visp3/core/vpRotationMatrix.h>

#include "pose_check.h"

namespace accuracy {
namespace {
/*! The measured pose with the spin that brings it nearest to the truth: what is left is no turn about the normal. */
vpHomogeneousMatrix withSpinOf(const vpHomogeneousMatrix &measured, const vpHomogeneousMatrix &truth)
{
  // Trace of (R Rz(a))^T R_true is greatest for tan(a) = (m10 - m01) / (m00 + m11), with M = R^T R_true.
  const vpRotationMatrix M = measured.getRotationMatrix().t() * truth.getRotationMatrix();
  const double angle = std::atan2(M[1][0] - M[0][1], M[0][0] + M[1][1]);
  return measured * vpHomogeneousMatrix(0., 0., 0., 0., 0., angle);
}

/*!
  Rows: the centre's motion upsilon + omega x c along the camera's axes, the turn along the marker's x, y and z axes.
*/
vpMatrix toCentre(const vpHomogeneousMatrix &cMo)
{
  vpMatrix A(6, 6, 0.);
  const vpMatrix cross = -1. * cMo.getTranslationVector().skew();
  for (unsigned int i = 0; i < 3; ++i) {
    A[i][i] = 1.;
    for (unsigned int j = 0; j < 3; ++j) {
      A[i][3 + j] = cross[i][j];
      A[3 + i][3 + j] = cMo[j][i];
    }
  }
  return A;
}
} // namespace

PoseCheck check(const vpHomogeneousMatrix &measured, const vpHomogeneousMatrix &truth, const vpMatrix &covariance,
                unsigned int dof)
{
  const vpHomogeneousMatrix aligned = dof == 5 ? withSpinOf(measured, truth) : measured;
  const vpMatrix A = toCentre(aligned);
  const vpMatrix whole = A * covariance * A.t();
  const vpColVector error = A * vpExponentialMap::inverse(truth * aligned.inverse());
  vpMatrix C(dof, dof);
  vpColVector e(dof);
  for (unsigned int i = 0; i < dof; ++i) {
    e[i] = error[i] / std::sqrt(whole[i][i]); // Metres and radians to the same size, for the inverse.
    for (unsigned int j = 0; j < dof; ++j) {
      C[i][j] = whole[i][j] / std::sqrt(whole[i][i] * whole[j][j]);
    }
  }
  PoseCheck result;
  result.x = std::sqrt(whole[0][0]);
  result.y = std::sqrt(whole[1][1]);
  result.z = std::sqrt(whole[2][2]);
  result.normal = std::sqrt(whole[3][3] + whole[4][4]);
  result.mahalanobis = e.t() * (C.inverseByLU() * e);
  return result;
}
} // namespace accuracy
