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
 * Pose of a circle by every input route, against known truth.
 */

#include "testPoseCircleTools.h"

#include <functional>

#include <visp3/blob/vpDot2.h>
#include <visp3/circle_marker/vpPoseCircle.h>
#include <visp3/core/vpCircle.h>
#include <visp3/core/vpMeterPixelConversion.h>
#include <visp3/core/vpPixelMeterConversion.h>
#include <visp3/me/vpMe.h>
#include <visp3/me/vpMeEllipse.h>
#include <visp3/visual_features/vpFeatureBuilder.h>
#include <visp3/visual_features/vpFeatureEllipse.h>

using namespace pose_circle_test;

namespace {
vpMatrix toVisp(const Matrix3 &Q)
{
  vpMatrix matrix(3, 3);
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      matrix[i][j] = static_cast<double>(Q(i, j));
    }
  }
  return matrix;
}

vpCameraParameters pinhole()
{
  vpCameraParameters cam;
  cam.initPersProjWithoutDistortion(1600., 1580., 639.5, 479.5);
  return cam;
}

vpCameraParameters radial()
{
  vpCameraParameters cam;
  cam.initPersProjWithDistortion(800., 805., 320.3, 239.1, -0.21, 0.25);
  return cam;
}

vpCameraParameters fisheye()
{
  vpCameraParameters cam;
  cam.initProjWithKannalaBrandtDistortion(400., 402., 319.5, 239.5, {0.05, -0.01, 0.003, -0.0005});
  return cam;
}

//! Pixel that vpPixelMeterConversion takes to a point: the inverse of ViSP's model pixel to metre, by Newton.
vpImagePoint exactPixel(const Eigen::Vector2d &point, const vpCameraParameters &cam)
{
  const double r = point.norm();
  double distorted = r;
  if (cam.get_projModel() == vpCameraParameters::perspectiveProjWithDistortion) {
    // The vector from the centre grows by 1 + kdu rd^2 from pixel to metre.
    for (int i = 0; i < 30; i++) {
      const double f = distorted * (1. + cam.get_kdu() * distorted * distorted) - r;
      distorted -= f / (1. + 3. * cam.get_kdu() * distorted * distorted);
    }
  }
  else if (cam.get_projModel() == vpCameraParameters::ProjWithKannalaBrandtDistortion) {
    const std::vector<double> k = cam.getKannalaBrandtDistortionCoefficients();
    const double t = std::atan(r), t2 = t * t;
    distorted = t * (1. + t2 * (k[0] + t2 * (k[1] + t2 * (k[2] + t2 * k[3]))));
  }
  const double factor = (r > 0.) ? distorted / r : 1.;
  return vpImagePoint(cam.get_v0() + cam.get_py() * factor * point.y(),
                      cam.get_u0() + cam.get_px() * factor * point.x());
}

std::vector<vpImagePoint> exactPixels(const std::vector<Eigen::Vector2d> &points, const vpCameraParameters &cam)
{
  std::vector<vpImagePoint> pixels;
  for (const Eigen::Vector2d &point : points) {
    pixels.push_back(exactPixel(point, cam));
  }
  return pixels;
}

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

//! Errors of the better one of both poses.
Errors errorsOfPose(vpPoseCircle &pose, const View &view, bool zAligned = false)
{
  pose.setRadius(static_cast<double>(view.radius));
  vpHomogeneousMatrix cMo, cMo2;
  EXPECT_TRUE(pose.computePose(cMo, &cMo2));
  return better(errorsOf(view, cMo, zAligned), errorsOf(view, cMo2, zAligned));
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

//! A dark image with a bright filled circle, each pixel the mean of 8 x 8 samples.
vpImage<unsigned char> render(const View &view, const vpCameraParameters &cam)
{
  vpImage<unsigned char> I(480, 640, 0);
  const Eigen::Matrix3d Q = view.exactConic().cast<double>();
  const int samples = 8;
  for (unsigned int v = 0; v < I.getHeight(); v++) {
    for (unsigned int u = 0; u < I.getWidth(); u++) {
      int inside = 0;
      for (int k = 0; k < samples * samples; k++) {
        double x = 0., y = 0.;
        vpPixelMeterConversion::convertPoint(cam, u - 0.5 + (k % samples + 0.5) / samples,
                                             v - 0.5 + (k / samples + 0.5) / samples, x, y);
        const Eigen::Vector3d p(x, y, 1.);
        inside += (p.dot(Q * p) < 0.) ? 1 : 0;
      }
      I[v][u] = static_cast<unsigned char>(20 + 200 * inside / (samples * samples));
    }
  }
  return I;
}

View knownView()
{
  View view;
  view.center = Vector3(0.06L, -0.04L, 1.L);
  view.normal = Vector3(0.5L, 0.3L, 0.8L).normalized();
  view.radius = 0.1L;
  return view;
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

TEST(PoseCircle, FromDot)
{
  const View view = knownView();
  for (const vpCameraParameters &cam : {radial(), fisheye()}) {
    const vpImage<unsigned char> I = render(view, cam);
    vpDot2 dot;
    const vpImagePoint start = exactPixel({0.06, -0.04}, cam);
    dot.initTracking(I, start, 121, 255);
    vpPoseCircle pose;
    pose.setEllipse(dot, cam);
    const Errors errors = errorsOfPose(pose, view);
    // The border is known to whole pixels: 0.3 pixel of rounding in each of 200 to 400 points. Half a pixel all round
    // would be a hundredth of the depth.
    EXPECT_LT(errors.center, 3e-4);
    EXPECT_LT(errors.normal, 5e-3);
  }
}

TEST(PoseCircle, FromMovingEdges)
{
  const View view = knownView();
  vpCameraParameters cam;
  cam.initPersProjWithoutDistortion(800., 810., 319.5, 239.5);
  const vpImage<unsigned char> I = render(view, cam);
  vpMe me;
  me.setRange(8);
  me.setThreshold(1000.);
  me.setSampleStep(3);
  vpMeEllipse tracker;
  tracker.setMe(&me);
  tracker.initTracking(I, exactPixels(view.contour(8), cam));
  tracker.track(I);
  vpPoseCircle pose;
  pose.setEllipse(tracker, cam);
  const Errors errors = errorsOfPose(pose, view);
  // Moving edges are found to whole pixels along the normal, that is with 0.3 pixel of noise.
  EXPECT_LT(errors.center, 3e-3);
  EXPECT_LT(errors.normal, 1e-2);
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

TEST(PoseCircle, FrameConventions)
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

TEST(PoseCircle, ResidualIsTheSumOfSquaredDistances)
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

TEST(PoseCircle, TheLastKindOfInputCounts)
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

TEST(PoseCircle, CopiesAreIndependent)
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

TEST(PoseCircle, ConicIsThatOfTheInput)
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
