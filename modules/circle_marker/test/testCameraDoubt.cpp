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
 * Tests of what a doubtful calibration adds to the covariance.
 */

#include "testFitTools.h"

#include <complex>

#include "refine/camera_doubt.h"
#include "refine/measure.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr unsigned int side = 150;
using Twist = Eigen::Matrix<double, 6, 1>;

//! A camera whose parameter k of (px, py, u0, v0) is changed by some pixels.
vpCameraParameters changed(const vpCameraParameters &camera, int k, double by)
{
  double parameters[] = {camera.get_px(), camera.get_py(), camera.get_u0(), camera.get_v0()};
  parameters[k] += by;
  vpCameraParameters other;
  other.initPersProjWithoutDistortion(parameters[0], parameters[1], parameters[2], parameters[3]);
  return other;
}

std::optional<FittedPose> fitted(const vpImage<unsigned char> &I, const vpCameraParameters &camera,
                                 const MarkerScene &scene, int id)
{
  Recognition marker;
  marker.family = scene.family;
  marker.code.id = id;
  marker.poses = {scene.plane(), twinOf(scene.plane())};
  MeasureMemory memory;
  const auto measurement = measure(I, CameraModel(camera), marker, true, memory);
  return measurement ? std::optional<FittedPose>(measurement->first) : std::nullopt;
}
} // namespace

// Against the refinement itself, which weighs the pixels by their noise and knows nothing of these derivatives.
TEST(CameraDoubt, ThePoseMovesAsTheRefinementsDoes)
{
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::RING}) {
    const vpCircleMarkerFamily family(type);
    for (int i = 0; i < 6; ++i) {
      const int id = family.isCoded() ? 8 : -1;
      const MarkerScene scene = markerScene(random, family, id, 90., uniform(random, 0.5, 0.9), side);
      const vpImage<unsigned char> I = photograph(side, side, 0.7, scene);
      const auto at = fitted(I, scene.camera(), scene, id);
      ASSERT_TRUE(at);
      const Eigen::Matrix<double, 6, 4> derivative = poseByCamera(at->plane, family, CameraModel(scene.camera()));
      for (int k = 0; k < 4; ++k) {
        const double step = k < 2 ? 0.002 * scene.camera().get_px() : 1.; // pixels
        const auto there = fitted(I, changed(scene.camera(), k, step), scene, id);
        ASSERT_TRUE(there);
        const Twist actual = fit_test::errorOf(at->plane, there->plane);
        const Twist expected = step * derivative.col(k);
        // Relative, and where hardly anything moves, to what a principal point that is moved as far would do.
        const double angle = step / scene.camera().get_px();
        EXPECT_LT((actual - expected).head<3>().norm(),
                  0.05 * expected.head<3>().norm() + 1e-3 * angle * at->plane.center.z())
            << family.getName() << " parameter " << k;
        EXPECT_LT((actual - expected).tail<3>().norm(), 0.1 * expected.tail<3>().norm() + 1e-2 * angle)
            << family.getName() << " parameter " << k;
      }
    }
  }
}

// Of a small marker straight ahead by hand: its distance is known no better than the focal length, and its direction no
// better than the principal point.
TEST(CameraDoubt, AheadItIsTheFocalLengthAndThePrincipalPoint)
{
  constexpr double focal = 1600.;
  constexpr double depth = 5.; // metres
  vpCameraParameters parameters;
  parameters.initPersProjWithoutDistortion(focal, focal, 319.5, 239.5);
  MarkerPlane plane;
  plane.center = Eigen::Vector3d(0., 0., depth);
  plane.rotation = turn(0.5, Eigen::Vector3d(0., 1., 0.));
  plane.radius = 0.09;
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  const CameraModel camera(parameters);
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();
  covariance.topLeftCorner<2, 2>().setConstant(64.); // 8 pixels, px and py together
  covariance(2, 2) = 4.;
  covariance(3, 3) = 9.;
  FittedPose fit;
  fit.plane = plane;
  fit.covariance.setZero();
  addCameraDoubt(covariance, family, camera, fit);
  EXPECT_NEAR(std::sqrt(fit.covariance(0, 0)), depth * 2. / focal, 1e-5);
  EXPECT_NEAR(std::sqrt(fit.covariance(1, 1)), depth * 3. / focal, 1e-5);
  EXPECT_NEAR(std::sqrt(fit.covariance(2, 2)), depth * 8. / focal, 0.01 * depth * 8. / focal);
  // An image that is moved is that of a camera, and what it sees, turned.
  EXPECT_NEAR(std::sqrt(fit.covariance(3, 3)), 3. / focal, 0.1 * 3. / focal);
  EXPECT_NEAR(std::sqrt(fit.covariance(4, 4)), 2. / focal, 0.1 * 2. / focal);
}

// What px and py that are off do to a small lean: its square, as a complex number, is what the image tells. Against
// draws of the roots.
TEST(CameraDoubt, OfAMarkerThatFacesTheCameraTheSquareOfTheLeanIsMoved)
{
  Random random = randomOfTest();
  std::normal_distribution<double> normal(0., 1.);
  constexpr double focal = 1600.;
  constexpr double off = 1.; // pixel, of px and of py
  vpCameraParameters parameters;
  parameters.initPersProjWithoutDistortion(focal, focal, 319.5, 239.5);
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();
  covariance(0, 0) = covariance(1, 1) = off * off;
  for (const double lean : {0., 0.002, 0.02, 0.05, 0.15}) {
    const double azimuth = uniform(random, 0., 2. * M_PI);
    MarkerPlane plane;
    plane.center = Eigen::Vector3d(0., 0., 20.); // far away, where perspective tells nothing of it
    plane.rotation = turn(lean, Eigen::Vector3d(-std::sin(azimuth), std::cos(azimuth), 0.));
    plane.radius = 0.09;
    FittedPose fit;
    fit.plane = plane;
    fit.covariance.setZero();
    addCameraDoubt(covariance, family, CameraModel(parameters), fit);
    double squares = 0.;
    constexpr int draws = 20000;
    const std::complex<double> before = std::polar(lean, azimuth);
    for (int i = 0; i < draws; ++i) {
      const double ratio = off / focal * (normal(random) - normal(random));
      std::complex<double> after = std::sqrt(before * before + 2. * ratio);
      after = std::abs(after - before) < std::abs(after + before) ? after : -after;
      squares += std::norm(after - before);
    }
    const double expected = std::sqrt(squares / draws);
    EXPECT_NEAR(std::sqrt(fit.covariance.bottomRightCorner<3, 3>().trace()), expected, 0.3 * expected) << lean;
    if (lean == 0.) { // it may lean in any direction
      EXPECT_NEAR(fit.covariance(3, 3), fit.covariance(4, 4), 0.1 * fit.covariance(4, 4));
    }
  }
}

TEST(CameraDoubt, TheSpinOfARingStays)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::RING);
  for (int i = 0; i < 20; ++i) {
    const MarkerScene scene = markerScene(random, family, -1, 60., uniform(random, 0.1, 1.2), side);
    const MarkerPlane plane = scene.plane();
    const auto derivative = poseByCamera(plane, family, CameraModel(scene.camera()));
    EXPECT_TRUE(derivative.allFinite());
    EXPECT_LT((plane.rotation.col(2).transpose() * derivative.bottomRows<3>()).norm(), 1e-6);
  }
}

TEST(CameraDoubt, AKnownCameraAddsNothing)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  const MarkerScene scene = markerScene(random, family, 3, 60., 0.5, side);
  FittedPose fit;
  fit.plane = scene.plane();
  fit.covariance.setIdentity();
  addCameraDoubt(Eigen::Matrix4d::Zero(), family, CameraModel(scene.camera()), fit);
  EXPECT_EQ(fit.covariance, (Eigen::Matrix<double, 6, 6>::Identity()));
}

// With a lens that distorts: the derivative by the parameters, against differences of ViSP's own conversion.
TEST(CameraDoubt, MeterByParametersIsADerivative)
{
  vpCameraParameters radial;
  radial.initPersProjWithDistortion(800., 810., 310., 250., -0.2, 0.2);
  vpCameraParameters fisheye;
  fisheye.initProjWithKannalaBrandtDistortion(500., 510., 310., 250., {0.03, -0.01, 0.004, -0.001});
  constexpr double step = 0.01; // pixels
  for (const vpCameraParameters &camera : {radial, fisheye}) {
    const auto shifted = [&](int k, double by) {
      double p[] = {camera.get_px(), camera.get_py(), camera.get_u0(), camera.get_v0()};
      p[k] += by;
      vpCameraParameters other;
      if (camera.get_projModel() == vpCameraParameters::ProjWithKannalaBrandtDistortion) {
        other.initProjWithKannalaBrandtDistortion(p[0], p[1], p[2], p[3],
                                                  camera.getKannalaBrandtDistortionCoefficients());
      }
      else {
        other.initPersProjWithDistortion(p[0], p[1], p[2], p[3], camera.get_kud(), camera.get_kdu());
      }
      return CameraModel(other);
    };
    for (const Eigen::Vector2d &pixel : {Eigen::Vector2d(20., 30.), Eigen::Vector2d(600., 100.)}) {
      const Eigen::Matrix<double, 2, 4> derivative = CameraModel(camera).meterByParameters(pixel);
      for (int k = 0; k < 4; ++k) {
        const Eigen::Vector2d difference =
            (shifted(k, step).toMeter(pixel) - shifted(k, -step).toMeter(pixel)) / (2. * step);
        EXPECT_LT((derivative.col(k) - difference).norm(), 1e-3 * difference.norm() + 1e-9) << k;
      }
    }
  }
}
