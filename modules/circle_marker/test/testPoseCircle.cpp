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
 * Pose of a circle by every route of exact input, against known truth.
 */

#include "testPoseCircleInputs.h"

#include <functional>

#include <visp3/core/vpCircle.h>
#include <visp3/core/vpMeterPixelConversion.h>
#include <visp3/core/vpPixelMeterConversion.h>
#include <visp3/visual_features/vpFeatureBuilder.h>
#include <visp3/visual_features/vpFeatureEllipse.h>

using namespace pose_circle_test;

namespace {
vpCircle projectedCircle(const View &view)
{
  vpCircle circle;
  // The normal of either sign and any length.
  circle.setWorldCoordinates(-2. * view.n().x(), -2. * view.n().y(), -2. * view.n().z(), view.c().x(), view.c().y(),
                             view.c().z(), static_cast<double>(view.radius));
  circle.changeFrame(vpHomogeneousMatrix());
  circle.projection();
  return circle;
}

//! Runs a route on random views and checks the errors.
void checkRoute(const std::function<void(vpPoseCircle &, const View &)> &route, double bound, double farthest = 10.)
{
  std::mt19937_64 random = randomOfTest();
  for (int i = 0; i < 1000; i++) {
    const View view = randomView(random, 0.1, 0.5, farthest, uniform(random, 5., 80.) * M_PI / 180.);
    vpPoseCircle pose;
    route(pose, view);
    const Errors errors = errorsOfPose(pose, view);
    ASSERT_LT(errors.center, bound) << "depth " << view.depth() << " tilt " << view.tilt();
    ASSERT_LT(errors.normal, bound) << "depth " << view.depth() << " tilt " << view.tilt();
  }
}
} // namespace

TEST(PoseCircle, FromConic)
{
  checkRoute([](vpPoseCircle &pose, const View &view) { pose.setConic(toVisp(-3. * view.exactConic())); }, 1e-10);
}

TEST(PoseCircle, FromSixCoefficients)
{
  checkRoute(
      [](vpPoseCircle &pose, const View &view) {
        const vpMatrix Q = toVisp(view.exactConic());
        vpColVector K(6);
        K[0] = Q[0][0];
        K[1] = Q[1][1];
        K[2] = Q[0][1];
        K[3] = Q[0][2];
        K[4] = Q[1][2];
        K[5] = Q[2][2];
        pose.setConic(K);
      },
      1e-10);
}

TEST(PoseCircle, FromFiveCoefficients)
{
  checkRoute(
      [](vpPoseCircle &pose, const View &view) {
        const vpMatrix Q = toVisp(view.exactConic() / view.exactConic()(0, 0));
        vpColVector K(5);
        K[0] = Q[1][1];
        K[1] = Q[0][1];
        K[2] = Q[0][2];
        K[3] = Q[1][2];
        K[4] = Q[2][2];
        pose.setConic(K);
      },
      1e-9);
}

TEST(PoseCircle, FromConicInPixels)
{
  checkRoute(
      [](vpPoseCircle &pose, const View &view) {
        const vpCameraParameters cam = pinhole();
        Matrix3 inverse;
        inverse << 1.L / cam.get_px(), 0.L, -cam.get_u0() / static_cast<long double>(cam.get_px()), 0.L,
            1.L / cam.get_py(), -cam.get_v0() / static_cast<long double>(cam.get_py()), 0.L, 0.L, 1.L;
        pose.setConic(toVisp(inverse.transpose() * view.exactConic() * inverse), cam);
      },
      1e-9);
}

TEST(PoseCircle, FromPoints)
{
  checkRoute(
      [](vpPoseCircle &pose, const View &view) {
        std::vector<vpPoint> points;
        for (const Eigen::Vector2d &x : view.contour(30)) {
          vpPoint P;
          P.set_x(x.x());
          P.set_y(x.y());
          points.push_back(P);
        }
        pose.addPoints(points);
        EXPECT_EQ(pose.getNbPoints(), 30u);
      },
      1e-9);
}

TEST(PoseCircle, FromPixelsWithoutDistortion)
{
  checkRoute(
      [](vpPoseCircle &pose, const View &view) { pose.addPoints(exactPixels(view.contour(40), pinhole()), pinhole()); },
      1e-9);
}

TEST(PoseCircle, FromPixelsWithRadialDistortion)
{
  checkRoute(
      [](vpPoseCircle &pose, const View &view) { pose.addPoints(exactPixels(view.contour(40), radial()), radial()); },
      1e-9);
}

TEST(PoseCircle, FromPixelsOfAFisheye)
{
  checkRoute(
      [](vpPoseCircle &pose, const View &view) { pose.addPoints(exactPixels(view.contour(40), fisheye()), fisheye()); },
      1e-9);
}

TEST(PoseCircle, FromCircle)
{
  // vpCircle computes its moments with a loss of its own, which grows with the square of the distance.
  checkRoute([](vpPoseCircle &pose, const View &view) { pose.setEllipse(projectedCircle(view)); }, 1e-7, 3.);
}

TEST(PoseCircle, FromFeatureEllipse)
{
  checkRoute(
      [](vpPoseCircle &pose, const View &view) {
        vpCircle circle = projectedCircle(view);
        vpFeatureEllipse ellipse;
        vpFeatureBuilder::create(ellipse, circle);
        pose.setEllipse(ellipse);
      },
      1e-7, 3.);
}

TEST(PoseCircle, FromMomentsInPixels)
{
  checkRoute(
      [](vpPoseCircle &pose, const View &view) {
        const vpCameraParameters cam = pinhole();
        const vpCircle circle = projectedCircle(view);
        vpImagePoint center;
        double n20 = 0., n11 = 0., n02 = 0.;
        vpMeterPixelConversion::convertEllipse(cam, circle, center, n20, n11, n02);
        pose.setMoments(center, n20, n11, n02, cam);
      },
      1e-7, 3.);
}

TEST(PoseCircle, MomentsAreThoseOfTheArea)
{
  // Second moments of the filled image over its area, summed over a fine grid.
  const View view = knownView();
  const Eigen::Matrix3d Q = view.exactConic().cast<double>();
  const double step = 2e-4;
  double m00 = 0., m10 = 0., m01 = 0., m20 = 0., m11 = 0., m02 = 0.;
  for (double x = -0.1; x < 0.25; x += step) {
    for (double y = -0.2; y < 0.15; y += step) {
      const Eigen::Vector3d p(x, y, 1.);
      if (p.dot(Q * p) < 0.) {
        m00 += 1.;
        m10 += x;
        m01 += y;
        m20 += x * x;
        m11 += x * y;
        m02 += y * y;
      }
    }
  }
  const double x = m10 / m00, y = m01 / m00;
  vpPoseCircle pose;
  pose.setMoments(x, y, m20 / m00 - x * x, m11 / m00 - x * y, m02 / m00 - y * y);
  const Errors errors = errorsOfPose(pose, view);
  // A boundary of 1500 cells, each right or wrong by chance, of 2e5 inside.
  EXPECT_LT(errors.center, 2e-4);
  EXPECT_LT(errors.normal, 2e-3);
}

TEST(PoseCircle, EllipseInPixelsWithDistortionIsUndistortedOutline)
{
  // A small circle off the axis: its image in pixels is nearly an ellipse. Undistorting the centre alone, as
  // vpPixelMeterConversion::convertEllipse does, is off by per cents.
  View view = knownView();
  view.center = Vector3(0.35L, 0.2L, 1.L);
  view.radius = 0.02L;
  const vpCameraParameters cam = radial();
  double u = 0., v = 0., uu = 0., uv = 0., vv = 0.;
  const int size = 360;
  // For a nearly affine image the moments of the outline at equal steps are twice those of the area.
  const std::vector<vpImagePoint> outline = exactPixels(view.contour(size), cam);
  for (const vpImagePoint &p : outline) {
    u += p.get_u() / size;
    v += p.get_v() / size;
  }
  for (const vpImagePoint &p : outline) {
    uu += (p.get_u() - u) * (p.get_u() - u) / (2. * size);
    uv += (p.get_u() - u) * (p.get_v() - v) / (2. * size);
    vv += (p.get_v() - v) * (p.get_v() - v) / (2. * size);
  }
  vpPoseCircle pose;
  pose.setMoments(vpImagePoint(v, u), uu, uv, vv, cam);
  EXPECT_LT(errorsOfPose(pose, view).center, 1e-3);

  double x = 0., y = 0., n20 = 0., n11 = 0., n02 = 0.;
  vpPixelMeterConversion::convertEllipse(cam, vpImagePoint(v, u), uu, uv, vv, x, y, n20, n11, n02);
  vpPoseCircle naive;
  naive.setMoments(x, y, n20, n11, n02);
  EXPECT_GT(errorsOfPose(naive, view).center, 1e-2);
}
