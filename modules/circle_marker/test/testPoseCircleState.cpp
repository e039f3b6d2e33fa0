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
 * Frames of vpPoseCircle, and what it keeps from call to call.
 */

#include "testPoseCircleInputs.h"

#include <visp3/core/vpException.h>

using namespace pose_circle_test;

TEST(PoseCircleState, FrameConventions)
{
  const View view = knownView();
  vpPoseCircle pose(0.1);
  pose.setConic(toVisp(view.exactConic()));
  vpHomogeneousMatrix toward, away;
  pose.computePose(toward);
  pose.setZAlignedWithCameraAxis(true);
  pose.computePose(away);
  // Half a turn about x apart.
  vpHomogeneousMatrix half(0., 0., 0., M_PI, 0., 0.);
  const vpHomogeneousMatrix expected = away * half;
  for (unsigned int i = 0; i < 4; i++) {
    for (unsigned int j = 0; j < 4; j++) {
      EXPECT_NEAR(toward[i][j], expected[i][j], 1e-14);
    }
  }
  EXPECT_LT(toward[2][2], 0.) << "by default z points toward the camera";
  EXPECT_GT(away[2][2], 0.);

  // Seen from the front, upright: no rotation when aligned.
  vpMatrix frontal(3, 3);
  frontal[0][0] = frontal[1][1] = 1.;
  frontal[2][2] = -0.01;
  pose.setConic(frontal);
  pose.computePose(away);
  for (unsigned int i = 0; i < 3; i++) {
    for (unsigned int j = 0; j < 3; j++) {
      EXPECT_NEAR(away[i][j], (i == j) ? 1. : 0., 1e-15);
    }
  }
  EXPECT_NEAR(away[2][3], 1., 1e-14);
}

TEST(PoseCircleState, ResidualIsTheSumOfSquaredDistances)
{
  // Seen along the axis at 1 m, a circle of 0.1 m; the pose at 2 m has an image of half the size.
  vpPoseCircle pose(0.1);
  vpMatrix Q(3, 3);
  Q[0][0] = Q[1][1] = 1.;
  Q[2][2] = -0.01;
  pose.setConic(Q);
  EXPECT_NEAR(pose.computeResidual(vpHomogeneousMatrix(0., 0., 1., 0., 0., 0.)), 0., 1e-28);
  // Distance to first order, (rho^2 - R^2) / (2 rho) with rho = 0.1 and R = 0.05, at 72 points.
  const double distance = (0.01 - 0.0025) / 0.2;
  EXPECT_NEAR(pose.computeResidual(vpHomogeneousMatrix(0., 0., 2., 0., 0., 0.)), 72. * distance * distance, 1e-12);
}

TEST(PoseCircleState, TheLastKindOfInputCounts)
{
  const View view = knownView();
  View other = knownView();
  other.center *= 2.L;
  vpPoseCircle pose;
  pose.addPoints(exactPixels(other.contour(20), pinhole()), pinhole());
  pose.setConic(toVisp(view.exactConic()));
  EXPECT_EQ(pose.getNbPoints(), 0u);
  EXPECT_LT(errorsOfPose(pose, view).center, 1e-10);
  pose.addPoints(exactPixels(other.contour(20), pinhole()), pinhole());
  EXPECT_LT(errorsOfPose(pose, other).center, 1e-10);
  pose.clearPoint();
  vpHomogeneousMatrix cMo;
  EXPECT_THROW(pose.computePose(cMo), vpException);
}

TEST(PoseCircleState, CopiesAreIndependent)
{
  const View view = knownView();
  vpPoseCircle pose(0.1);
  pose.setConic(toVisp(view.exactConic()));
  vpPoseCircle copy(pose);
  pose.clearPoint();
  EXPECT_LT(errorsOfPose(copy, view).center, 1e-10);
  pose = copy;
  EXPECT_LT(errorsOfPose(pose, view).center, 1e-10);
}

TEST(PoseCircleState, ConicIsThatOfTheInput)
{
  const View view = knownView();
  vpPoseCircle pose(0.1);
  pose.addPoints(exactPixels(view.contour(20), pinhole()), pinhole());
  const vpMatrix Q = pose.getConic();
  const Matrix3 expected = view.exactConic().normalized();
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      EXPECT_NEAR(Q[i][j], static_cast<double>(expected(i, j)), 1e-12);
    }
  }
}

TEST(PoseCircleState, AnEarlierCovarianceDoesNotStay)
{
  const View view = knownView();
  vpPoseCircle pose(0.1);
  pose.setConic(toVisp(view.exactConic()));
  pose.setCovarianceComputation(true);
  vpHomogeneousMatrix cMo;
  pose.computePose(cMo);
  EXPECT_NO_THROW(pose.getCovarianceMatrix());
  pose.setCovarianceComputation(false);
  pose.computePose(cMo);
  EXPECT_THROW(pose.getCovarianceMatrix(), vpException);
  // Nor does that of a pose before one that could not be computed.
  pose.setCovarianceComputation(true);
  pose.setPriorPose(cMo);
  pose.computePose(cMo);
  EXPECT_GT(pose.getLogOdds(), 0.);
  pose.clearPoint();
  EXPECT_THROW(pose.computePose(cMo), vpException);
  EXPECT_THROW(pose.getCovarianceMatrix(), vpException);
  EXPECT_EQ(pose.getLogOdds(), 0.);
}
