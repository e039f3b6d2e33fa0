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
 * Order of the two poses of a circle, its log-odds, and the covariance.
 */

#include "testPoseCircleInputs.h"
#include "testPoseCircleTools.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <visp3/circle_marker/vpPoseCircle.h>

using namespace pose_circle_test;

namespace {
vpCameraParameters camera()
{
  vpCameraParameters cam;
  cam.initPersProjWithoutDistortion(1600., 1600., 639.5, 479.5);
  return cam;
}

std::vector<vpImagePoint> noisyPixels(const View &view, int size, double factor, double sigma, std::mt19937_64 &random)
{
  const vpCameraParameters cam = camera();
  std::normal_distribution<double> noise(0., 1.);
  std::vector<vpImagePoint> pixels;
  for (const Eigen::Vector2d &x : view.contour(size, factor)) {
    pixels.emplace_back(cam.get_v0() + cam.get_py() * x.y() + sigma * noise(random),
                        cam.get_u0() + cam.get_px() * x.x() + sigma * noise(random));
  }
  return pixels;
}

//! Image of the concentric circle whose radius is a factor of the view's.
Matrix3 innerConic(View view, double factor)
{
  view.radius *= factor;
  return view.exactConic();
}
} // namespace

TEST(PoseCircleEvidence, WithoutEvidenceTheMoreFrontalComesFirst)
{
  std::mt19937_64 random = randomOfTest();
  for (int i = 0; i < 200; i++) {
    const View view = randomView(random, 0.1, 1., 5., uniform(random, 10., 80.) * M_PI / 180.);
    vpPoseCircle pose(0.1);
    pose.setZAlignedWithCameraAxis(true);
    pose.setConic(toVisp(view.exactConic()));
    vpHomogeneousMatrix cMo, cMo2;
    pose.computePose(cMo, &cMo2);
    EXPECT_GE(cMo[2][2], cMo2[2][2]);
    EXPECT_EQ(pose.getLogOdds(), 0.);
  }
}

TEST(PoseCircleEvidence, ConcentricCircleFindsTheRightOne)
{
  std::mt19937_64 random = randomOfTest();
  for (int i = 0; i < 1000; i++) {
    const View view = randomView(random, 0.1, 0.5, 4., uniform(random, 10., 80.) * M_PI / 180.);
    vpPoseCircle pose(0.1);
    pose.setConic(toVisp(view.exactConic()));
    pose.setConcentricCircle(0.08, toVisp(innerConic(view, 0.8)));
    vpHomogeneousMatrix cMo, cMo2;
    pose.computePose(cMo, &cMo2);
    EXPECT_LT(errorsOf(view, cMo).normal, 1e-9);
    EXPECT_GT(errorsOf(view, cMo2).normal, 0.1);
    EXPECT_GT(pose.getLogOdds(), 0.);
  }
}

TEST(PoseCircleEvidence, LogOddsAreCalibrated)
{
  // Among views whose log-odds say p the share p has the right one first.
  std::mt19937_64 random = randomOfTest();
  const double sigma = 0.3; // pixels
  double expected = 0., variance = 0.;
  int right = 0, doubtful = 0;
  for (int i = 0; i < 4000; i++) {
    View view = randomView(random, 0.09, 3., 8., uniform(random, 15., 60.) * M_PI / 180.);
    vpPoseCircle pose(0.09);
    pose.setPointSigma(sigma / camera().get_px());
    pose.addPoints(noisyPixels(view, 100, 1., sigma, random), camera());
    pose.setConcentricCircle(0.072, noisyPixels(view, 80, 0.8, sigma, random), camera());
    vpHomogeneousMatrix cMo, cMo2;
    pose.computePose(cMo, &cMo2);
    const double p = 1. / (1. + std::exp(-pose.getLogOdds()));
    if (p < 0.99) {
      doubtful++;
      expected += p;
      variance += p * (1. - p);
      right += (errorsOf(view, cMo).normal < errorsOf(view, cMo2).normal) ? 1 : 0;
    }
  }
  ASSERT_GT(doubtful, 500);
  EXPECT_NEAR(right, expected, 4. * std::sqrt(variance)) << "of " << doubtful;
}

TEST(PoseCircleEvidence, PriorPoseAndNormal)
{
  std::mt19937_64 random = randomOfTest();
  for (int i = 0; i < 500; i++) {
    const View view = randomView(random, 0.1, 0.5, 4., uniform(random, 10., 80.) * M_PI / 180.);
    vpPoseCircle pose(0.1);
    pose.setConic(toVisp(view.exactConic()));
    vpHomogeneousMatrix cMo, cMo2, prior;
    pose.computePose(cMo, &cMo2);
    // The prior is now one, now the other; in either frame convention.
    prior = (i % 2) ? cMo : cMo2;
    vpPoseCircle again(pose);
    again.setZAlignedWithCameraAxis(i % 3 == 0);
    again.setPriorPose(prior);
    vpHomogeneousMatrix first, second;
    again.computePose(first, &second);
    const double sign = (i % 3 == 0) ? -1. : 1.;
    EXPECT_NEAR(first[0][2], sign * prior[0][2], 1e-12);
    EXPECT_NEAR(first[1][2], sign * prior[1][2], 1e-12);
    // Half the squared angle between both normals over the variance, at 5 degrees.
    const Eigen::Vector3d n1(cMo[0][2], cMo[1][2], cMo[2][2]), n2(cMo2[0][2], cMo2[1][2], cMo2[2][2]);
    const double angle = std::atan2(n1.cross(n2).norm(), n1.dot(n2)), sigma = 0.0873;
    EXPECT_NEAR(again.getLogOdds(), angle * angle / (2. * sigma * sigma), 1e-6 * angle * angle / (sigma * sigma));

    again.clearEvidence();
    vpColVector normal(3);
    for (unsigned int k = 0; k < 3; k++) {
      normal[k] = -7. * prior[k][2];
    }
    again.setPriorNormal(normal, 0.2);
    vpHomogeneousMatrix byNormal;
    again.computePose(byNormal);
    EXPECT_NEAR(byNormal[0][2], first[0][2], 1e-12);
    again.clearEvidence();
    again.computePose(byNormal);
    EXPECT_EQ(again.getLogOdds(), 0.);
  }
}

TEST(PoseCircleEvidence, APriorNormalMayHaveAnyLength)
{
  vpPoseCircle pose(0.1);
  pose.setConic(toVisp(knownView().exactConic()));
  vpHomogeneousMatrix cMo, cMo2, again;
  pose.computePose(cMo, &cMo2);
  for (const double length : {1e-200, 1e200}) {
    vpColVector normal(3);
    for (unsigned int k = 0; k < 3; k++) {
      normal[k] = length * cMo2[k][2];
    }
    pose.setPriorNormal(normal, 0.1);
    pose.computePose(again);
    EXPECT_NEAR(again[0][2], cMo2[0][2], 1e-9);
  }
}

// The distance to first order is not defined at the centre of an ellipse.
TEST(PoseCircleEvidence, APointAtTheCentreSaysNothing)
{
  const View view = knownView();
  vpPoseCircle pose(0.1);
  pose.setConic(toVisp(view.exactConic()));
  const vpImagePoint center(camera().get_v0() + camera().get_py() * view.c().y() / view.c().z(),
                            camera().get_u0() + camera().get_px() * view.c().x() / view.c().z());
  pose.setConcentricCircle(0.05, {center}, camera());
  vpHomogeneousMatrix cMo;
  pose.computePose(cMo);
  EXPECT_TRUE(std::isfinite(pose.getLogOdds()));
  EXPECT_GE(pose.getLogOdds(), 0.);
}

TEST(PoseCircleEvidence, AConcentricCircleIsForgottenWithTheRest)
{
  std::mt19937_64 random = randomOfTest();
  const View view = randomView(random, 0.1, 0.5, 4., M_PI / 4.);
  vpPoseCircle pose(0.1);
  pose.setConic(toVisp(view.exactConic()));
  pose.setConcentricCircle(0.08, toVisp(innerConic(view, 0.8)));
  vpHomogeneousMatrix cMo;
  pose.computePose(cMo);
  EXPECT_GT(pose.getLogOdds(), 0.);
  pose.clearEvidence();
  pose.computePose(cMo);
  EXPECT_EQ(pose.getLogOdds(), 0.);
}

TEST(PoseCircleEvidence, CovarianceIsThatOfTheErrors)
{
  // The squared error in units of the covariance has the mean 5: the degrees of freedom of a circle.
  std::mt19937_64 random = randomOfTest();
  const double sigma = 0.05; // pixels
  const int trials = 3000;
  double mean = 0.;
  for (int i = 0; i < trials; i++) {
    const View view = randomView(random, 0.1, 1., 5., uniform(random, 30., 70.) * M_PI / 180.);
    vpPoseCircle pose(0.1);
    pose.setPointSigma(sigma / camera().get_px());
    pose.setCovarianceComputation(true);
    pose.setZAlignedWithCameraAxis(true);
    pose.addPoints(noisyPixels(view, 100, 1., sigma, random), camera());
    vpColVector truth(3);
    for (unsigned int k = 0; k < 3; k++) {
      truth[k] = view.n()(k);
    }
    pose.setPriorNormal(truth);
    vpHomogeneousMatrix cMo;
    pose.computePose(cMo);
    const vpMatrix C = pose.getCovarianceMatrix();
    Eigen::Matrix<double, 6, 6> covariance;
    for (int k = 0; k < 6; k++) {
      for (int l = 0; l < 6; l++) {
        covariance(k, l) = C[k][l];
      }
    }
    // delta moves the centre by v + w x C and the normal by w x n.
    const Eigen::Vector3d center(cMo[0][3], cMo[1][3], cMo[2][3]), normal(cMo[0][2], cMo[1][2], cMo[2][2]);
    const Eigen::Vector3d e1 = normal.unitOrthogonal(), e2 = normal.cross(e1);
    Eigen::Matrix<double, 5, 6> A = Eigen::Matrix<double, 5, 6>::Zero();
    A.topLeftCorner<3, 3>().setIdentity();
    for (int k = 0; k < 3; k++) {
      A.block<3, 1>(0, 3 + k) = Eigen::Vector3d::Unit(k).cross(center);
    }
    A.block<1, 3>(3, 3) = e1.transpose();
    A.block<1, 3>(4, 3) = e2.transpose();
    const Eigen::Vector3d rotation = normal.cross(view.n());
    Eigen::Matrix<double, 5, 1> error;
    error << view.c() - center, rotation.dot(e1), rotation.dot(e2);
    const Eigen::Matrix<double, 5, 5> projected = A * covariance * A.transpose();
    mean += error.dot(projected.inverse() * error) / trials;
    // The spin has the variance of a uniform angle.
    EXPECT_NEAR(normal.dot(covariance.bottomRightCorner<3, 3>() * normal), M_PI * M_PI / 3., 1e-9);
    EXPECT_LT((covariance - covariance.transpose()).norm(), 1e-15);
  }
  // The mean of 3000 chi-square values of 5 degrees of freedom has the standard deviation 0.058.
  EXPECT_NEAR(mean, 5., 0.3);
}

TEST(PoseCircleEvidence, CovarianceStaysFiniteAlongTheAxis)
{
  vpMatrix Q(3, 3);
  Q[0][0] = Q[1][1] = 1.;
  Q[2][2] = -0.01;
  vpPoseCircle pose(0.1);
  pose.setCovarianceComputation(true);
  pose.setConic(Q);
  vpHomogeneousMatrix cMo;
  pose.computePose(cMo);
  const vpMatrix C = pose.getCovarianceMatrix();
  // The tilt is not seen to first order: the variance of a uniform angle within a right angle either way, at most.
  EXPECT_NEAR(C[3][3], M_PI * M_PI / 12., 0.05);
  EXPECT_NEAR(C[4][4], M_PI * M_PI / 12., 0.05);
  EXPECT_GT(C[5][5], 3.);
  EXPECT_LT(C[2][2], 1.);
}
