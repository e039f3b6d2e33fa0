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
 * What vpPoseCircle refuses, and the reasons it gives.
 */

#include "testPoseCircleTools.h"

#include <functional>
#include <limits>

#include <visp3/blob/vpDot2.h>
#include <visp3/circle_marker/vpPoseCircle.h>
#include <visp3/core/vpCircle.h>
#include <visp3/visual_features/vpFeatureEllipse.h>

using namespace pose_circle_test;

namespace {
const double nan_ = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

vpMatrix diagonal(double a, double b, double c)
{
  vpMatrix Q(3, 3);
  Q[0][0] = a;
  Q[1][1] = b;
  Q[2][2] = c;
  return Q;
}

vpCameraParameters camera()
{
  vpCameraParameters cam;
  cam.initPersProjWithoutDistortion(600., 600., 320., 240.);
  return cam;
}

//! The action throws a vpException whose message has the reason.
void expectReason(const std::function<void()> &action, const std::string &reason)
{
  try {
    action();
    FAIL() << "no exception for: " << reason;
  }
  catch (const vpException &e) {
    EXPECT_NE(std::string(e.what()).find(reason), std::string::npos) << e.what() << "\nexpected: " << reason;
  }
}
} // namespace

TEST(PoseCircleErrors, Radius)
{
  for (double radius : {0., -0.1, nan_, infinity}) {
    expectReason([=] { vpPoseCircle pose(radius); }, "radius");
    vpPoseCircle pose;
    expectReason([&] { pose.setRadius(radius); }, "radius");
    expectReason([&] { pose.setConcentricCircle(radius, diagonal(1., 1., -1.)); }, "radius");
  }
  vpPoseCircle pose;
  pose.setConic(diagonal(1., 1., -1.));
  vpHomogeneousMatrix cMo;
  expectReason([&] { pose.computePose(cMo); }, "radius");
  expectReason([&] { pose.computeResidual(cMo); }, "radius");
}

TEST(PoseCircleErrors, Conics)
{
  vpPoseCircle pose(0.1);
  expectReason([&] { pose.setConic(diagonal(1., -1., -1.)); }, "hyperbola");
  expectReason([&] { pose.setConic(diagonal(1., 1., 0.)); }, "point");
  expectReason([&] { pose.setConic(diagonal(1., 1., 1.)); }, "imaginary");
  expectReason([&] { pose.setConic(diagonal(1., 0., -1.)); }, "parabola");
  expectReason([&] { pose.setConic(diagonal(0., 0., 0.)); }, "zero");
  expectReason([&] { pose.setConic(diagonal(nan_, 1., -1.)); }, "finite");
  expectReason([&] { pose.setConic(diagonal(1., 1., -infinity)); }, "finite");
  expectReason([&] { pose.setConic(vpMatrix(2, 3)); }, "3 x 3");
  expectReason([&] { pose.setConic(vpColVector(4)); }, "5 or 6");
  expectReason([&] { pose.setConcentricCircle(0.05, diagonal(1., -1., -1.)); }, "hyperbola");
}

TEST(PoseCircleErrors, Points)
{
  vpPoseCircle pose(0.1);
  vpHomogeneousMatrix cMo;
  expectReason([&] { pose.computePose(cMo); }, "at least 5");
  for (int i = 0; i < 4; i++) {
    pose.addPoint(vpImagePoint(240. + 50. * std::cos(i), 320. + 50. * std::sin(i)), camera());
  }
  expectReason([&] { pose.computePose(cMo); }, "at least 5");
  pose.addPoint(vpImagePoint(240. + 50. * std::cos(4.), 320. + 50. * std::sin(4.)), camera());
  EXPECT_TRUE(pose.computePose(cMo));

  pose.clearPoint();
  for (int i = 0; i < 20; i++) {
    pose.addPoint(vpImagePoint(100. + 3. * i, 50. + 7. * i), camera());
  }
  expectReason([&] { pose.computePose(cMo); }, "line");
  expectReason([&] { pose.addPoint(vpImagePoint(nan_, 1.), camera()); }, "finite");
  vpPoint P;
  P.set_x(infinity);
  P.set_y(0.);
  expectReason([&] { pose.addPoint(P); }, "finite");
  const unsigned int before = pose.getNbPoints();
  expectReason([&] { pose.addPoints({vpImagePoint(1., 2.), vpImagePoint(nan_, 1.)}, camera()); }, "finite");
  expectReason([&] { pose.addPoints({vpPoint(), P}); }, "finite");
  EXPECT_EQ(pose.getNbPoints(), before) << "all or none";

  // A fisheye's pixel at more than a right angle from the axis is not in front of the camera.
  vpCameraParameters fisheye;
  fisheye.initProjWithKannalaBrandtDistortion(200., 200., 320., 240., {0., 0., 0., 0.});
  expectReason([&] { pose.addPoint(vpImagePoint(240., 320. + 200. * 1.7), fisheye); }, "field of view");
}

TEST(PoseCircleErrors, Moments)
{
  vpPoseCircle pose(0.1);
  expectReason([&] { pose.setMoments(0., 0., 1., 1., 1.); }, "moments");
  expectReason([&] { pose.setMoments(0., 0., -1., 0., -1.); }, "moments");
  expectReason([&] { pose.setMoments(nan_, 0., 1., 0., 1.); }, "moments");
  expectReason([&] { pose.setMoments(vpImagePoint(1., 1.), 0., 0., 1., camera()); }, "moments");
  expectReason([&] { pose.setEllipse(vpFeatureEllipse()); }, "moments");
  expectReason([&] { pose.setEllipse(vpDot2(), camera()); }, "dot");
}

TEST(PoseCircleErrors, CircleBehindTheCamera)
{
  vpPoseCircle pose(0.1);
  // Wholly behind; and with one edge behind the plane of the camera's centre.
  vpCircle behind(0., 0., 1., 0.1, 0., -1., 0.1);
  behind.changeFrame(vpHomogeneousMatrix());
  behind.projection();
  expectReason([&] { pose.setEllipse(behind); }, "behind");
  vpCircle across(1., 0., 0.2, 0.1, 0., 0.05, 0.1);
  across.changeFrame(vpHomogeneousMatrix());
  across.projection();
  expectReason([&] { pose.setEllipse(across); }, "behind");
  expectReason([&] { pose.setEllipse(vpCircle()); }, "moments");
}

TEST(PoseCircleErrors, ACircleThatFacesTheCameraMayBeNearerThanItsRadius)
{
  // All of it is 0.3 m in front of the camera; only tilted by more than 37 degrees would an edge be behind.
  constexpr double depth = 0.3, radius = 0.5;
  vpCircle facing(0., 0., 1., 0., 0., depth, radius);
  facing.changeFrame(vpHomogeneousMatrix());
  facing.projection();
  vpPoseCircle pose(radius);
  pose.setEllipse(facing);
  vpHomogeneousMatrix cMo;
  pose.computePose(cMo);
  EXPECT_NEAR(cMo[2][3], depth, 1e-9);
}

TEST(PoseCircleErrors, ResidualOfAPoseBehindTheCamera)
{
  vpPoseCircle pose(0.1);
  pose.setMoments(0., 0., 0.0025, 0., 0.0025); // seen from the front at 1 m
  vpHomogeneousMatrix cMo;
  pose.computePose(cMo);
  EXPECT_LT(pose.computeResidual(cMo), 1e-20);
  cMo[2][3] = -cMo[2][3]; // the same cone, on the other side
  EXPECT_EQ(pose.computeResidual(cMo), HUGE_VAL);
  cMo[2][3] = nan_;
  EXPECT_EQ(pose.computeResidual(cMo), HUGE_VAL);
}

TEST(PoseCircleErrors, Settings)
{
  vpPoseCircle pose(0.1);
  expectReason([&] { pose.setPointSigma(0.); }, "standard deviation");
  expectReason([&] { pose.setPointSigma(1e-300); }, "standard deviation");
  expectReason([&] { pose.setPriorPose(vpHomogeneousMatrix(), 1e-300); }, "standard deviation");
  expectReason([&] { pose.setPriorNormal(vpColVector(3, 0.)); }, "normal");
  expectReason([&] { pose.setPriorNormal(vpColVector(2, 1.)); }, "normal");
  expectReason([&] { pose.setPriorPose(vpHomogeneousMatrix(), -1.); }, "standard deviation");
  expectReason([&] { pose.getCovarianceMatrix(); }, "setCovarianceComputation");
  expectReason([&] { pose.setConcentricCircle(0.05, {vpImagePoint(nan_, 0.)}, camera()); }, "finite");
}
