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
 * The camera models, read from pixel to metre, and their inverse.
 */

#include "testRoomTools.h"

#include <visp3/core/vpPixelMeterConversion.h>

#include "support/bilinear.h"
#include "support/camera_model.h"

using namespace circle_marker;
using namespace room_test;

namespace {
vpCameraParameters straight()
{
  return vpCameraParameters(1600., 1580., 639.5, 479.5);
}

vpCameraParameters radial()
{
  vpCameraParameters camera;
  camera.initPersProjWithDistortion(1600., 1580., 639.5, 479.5, -0.1, 0.11);
  return camera;
}

vpCameraParameters fisheye()
{
  vpCameraParameters camera;
  camera.initProjWithKannalaBrandtDistortion(700., 690., 639.5, 479.5, {-0.02, 0.004, -0.001, 0.0002});
  return camera;
}

Eigen::Vector2d randomPixel(Random &random)
{
  return Eigen::Vector2d(uniform(random, -0.5, 1279.5), uniform(random, -0.5, 959.5));
}
} // namespace

TEST(CameraModel, ToPixelIsTheInverseOfToMeter)
{
  Random random = randomOfTest();
  for (const vpCameraParameters &cam : {straight(), radial(), fisheye()}) {
    const CameraModel camera(cam);
    for (int i = 0; i < 2000; ++i) {
      const Eigen::Vector2d pixel = randomPixel(random);
      EXPECT_LT((camera.toPixel(camera.toMeter(pixel)) - pixel).norm(), 1e-8) << pixel.transpose();
    }
  }
}

// Wherever kud leads: ViSP's inverse is not asked.
TEST(CameraModel, SoItIsFarFromTheAxisOfALensThatDistortsALot)
{
  Random random = randomOfTest();
  for (const double kdu : {-0.3, -0.05, 0.3, 1.}) {
    vpCameraParameters cam;
    cam.initPersProjWithDistortion(300., 310., 639.5, 479.5, -kdu, kdu);
    const CameraModel camera(cam);
    for (int i = 0; i < 2000; ++i) {
      const Eigen::Vector2d pixel = randomPixel(random);
      const double squaredRadius =
          Eigen::Vector2d((pixel.x() - 639.5) / 300., (pixel.y() - 479.5) / 310.).squaredNorm();
      if (1. + 3. * kdu * squaredRadius > 0.02) { // short of where the lens folds over
        EXPECT_LT((camera.toPixel(camera.toMeter(pixel)) - pixel).norm(), 1e-8) << pixel.transpose() << ", " << kdu;
      }
    }
  }
}

TEST(CameraModel, BeyondTheFoldOfALensThereIsNoPixel)
{
  vpCameraParameters cam;
  cam.initPersProjWithDistortion(300., 300., 639.5, 479.5, 0.1, -0.1);
  const double fold = 2. / (3. * std::sqrt(0.3)); // the largest normalised radius
  EXPECT_NEAR(CameraModel(cam).toPixel(Eigen::Vector2d((1. - 1e-6) * fold, 0.)).x(), 639.5 + 300. / std::sqrt(0.3), 1.);
  EXPECT_FALSE(CameraModel(cam).toPixel(Eigen::Vector2d(1.01 * fold, 0.)).allFinite());
  EXPECT_FALSE(CameraModel(cam).toPixel(Eigen::Vector2d(0., -100.)).allFinite());
}

TEST(CameraModel, ToMeterIsViSPs)
{
  Random random = randomOfTest();
  for (const vpCameraParameters &cam : {straight(), radial(), fisheye()}) {
    for (int i = 0; i < 200; ++i) {
      const Eigen::Vector2d pixel = randomPixel(random);
      double x = 0., y = 0.;
      vpPixelMeterConversion::convertPoint(cam, pixel.x(), pixel.y(), x, y);
      EXPECT_EQ(CameraModel(cam).toMeter(pixel), Eigen::Vector2d(x, y));
    }
  }
}

TEST(CameraModel, DerivativeOfToMeter)
{
  Random random = randomOfTest();
  for (const vpCameraParameters &cam : {straight(), radial(), fisheye()}) {
    const CameraModel camera(cam);
    for (int i = 0; i < 500; ++i) {
      const Eigen::Vector2d pixel = randomPixel(random);
      const Eigen::Matrix2d jacobian = camera.meterPerPixel(pixel);
      for (int axis = 0; axis < 2; ++axis) {
        // Richardson's extrapolation of two central differences: error of fourth order.
        const auto central = [&](double h) -> Eigen::Vector2d {
          const Eigen::Vector2d step = h * Eigen::Vector2d::Unit(axis);
          return (camera.toMeter(pixel + step) - camera.toMeter(pixel - step)) / (2. * h);
        };
        const Eigen::Vector2d truth = (4. * central(0.05) - central(0.1)) / 3.;
        // The half pixel's own error, h^2 / 6 of the third derivative: 3e-6 where the fisheye sees 65 degrees off axis.
        EXPECT_LT((jacobian.col(axis) - truth).norm(), 5e-6 * truth.norm()) << pixel.transpose();
      }
    }
  }
}

TEST(CameraModel, PrincipalPointOfEveryModel)
{
  // Where the radius is 0, Kannala-Brandt's formula is 0 / 0.
  for (const vpCameraParameters &cam : {straight(), radial(), fisheye()}) {
    const CameraModel camera(cam);
    EXPECT_LT(camera.toMeter(Eigen::Vector2d(639.5, 479.5)).norm(), 1e-12);
    EXPECT_LT((camera.toPixel(Eigen::Vector2d::Zero()) - Eigen::Vector2d(639.5, 479.5)).norm(), 1e-8);
    EXPECT_NEAR(camera.meterPerPixel(Eigen::Vector2d(639.5, 479.5))(0, 0), 1. / cam.get_px(), 1e-6 / cam.get_px());
  }
}

TEST(CameraModel, OnlyTheFirstIsLinear)
{
  EXPECT_TRUE(CameraModel(straight()).isLinear());
  EXPECT_FALSE(CameraModel(radial()).isLinear());
  EXPECT_FALSE(CameraModel(fisheye()).isLinear());
}

TEST(Bilinear, IsExactOnProductsOfLines)
{
  vpImage<unsigned char> I(20, 30);
  for (unsigned int v = 0; v < 20; ++v) {
    for (unsigned int u = 0; u < 30; ++u) {
      I[v][u] = static_cast<unsigned char>(3 * u + 5 * v + (u % 2) * (v % 2));
    }
  }
  Random random = randomOfTest();
  for (int i = 0; i < 1000; ++i) {
    const double u = uniform(random, 0., 28.999);
    const double v = uniform(random, 0., 18.999);
    // The odd-odd pixels carry one grey level more: bilinear in each cell.
    const auto towardOdd = [](double x) { return 1. - std::fabs(std::remainder(x - 1., 2.)); };
    const auto grey = bilinear(I, Eigen::Vector2d(u, v));
    ASSERT_TRUE(grey);
    EXPECT_NEAR(*grey, 3. * u + 5. * v + towardOdd(u) * towardOdd(v), 1e-9);
  }
}

TEST(Bilinear, NothingOutside)
{
  const vpImage<unsigned char> I(20, 30, 7);
  EXPECT_TRUE(bilinear(I, Eigen::Vector2d(0., 0.)));
  EXPECT_TRUE(bilinear(I, Eigen::Vector2d(28.999, 18.999)));
  const double nan = std::nan("");
  for (const Eigen::Vector2d &pixel :
       {Eigen::Vector2d(-0.001, 5.), Eigen::Vector2d(5., -0.001), Eigen::Vector2d(29.001, 5.),
        Eigen::Vector2d(5., 19.001), Eigen::Vector2d(nan, 5.), Eigen::Vector2d(5., nan), Eigen::Vector2d(1e300, 5.),
        Eigen::Vector2d(5., -1e300), Eigen::Vector2d(HUGE_VAL, HUGE_VAL)}) {
    EXPECT_FALSE(bilinear(I, pixel)) << pixel.transpose();
  }
}
