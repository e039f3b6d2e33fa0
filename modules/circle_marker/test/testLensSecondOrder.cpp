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
 * Tests the second derivative of a lens, as pixels have it, against differences of the camera.
 */

#include "testRoomTools.h"

#include <Eigen/LU>

#include "refine/lens_second_order.h"
#include "support/camera_model.h"

using namespace circle_marker;
using namespace room_test;

namespace {
std::vector<FitPixel> pixelsAround(const CameraModel &camera, const Eigen::Vector2d &center, int reach)
{
  std::vector<FitPixel> pixels;
  for (int v = -reach; v <= reach; ++v) {
    for (int u = -reach; u <= reach; ++u) {
      const Eigen::Vector2d where = center + Eigen::Vector2d(u, v);
      FitPixel pixel;
      pixel.meter = camera.toMeter(where).cast<float>();
      pixel.meterPerPixel = camera.meterPerPixel(where).cast<float>();
      pixels.push_back(pixel);
    }
  }
  return pixels;
}
} // namespace

TEST(LensSecondOrder, IsThatOfTheCamera)
{
  vpCameraParameters radial;
  radial.initPersProjWithDistortion(500., 500., 319.5, 239.5, -0.2, 0.2);
  vpCameraParameters fisheye;
  fisheye.initProjWithKannalaBrandtDistortion(220., 220., 319.5, 239.5, {-0.01, 0.002, -0.0005, 0.0001});
  for (const vpCameraParameters &cam : {radial, fisheye}) {
    const CameraModel camera(cam);
    for (const Eigen::Vector2d &center : {Eigen::Vector2d(420., 300.), Eigen::Vector2d(200., 100.)}) {
      const Eigen::Matrix<double, 2, 3> lens = secondOrderOfLens(pixelsAround(camera, center, 20));
      constexpr double h = 0.5; // pixels
      const auto at = [&](double u, double v) { return camera.toMeter(center + h * Eigen::Vector2d(u, v)); };
      Eigen::Matrix<double, 2, 3> expected;
      expected << at(1., 0.) - 2. * at(0., 0.) + at(-1., 0.),
          0.25 * (at(1., 1.) - at(1., -1.) - at(-1., 1.) + at(-1., -1.)), at(0., 1.) - 2. * at(0., 0.) + at(0., -1.);
      expected = camera.meterPerPixel(center).inverse() * expected / (h * h);
      EXPECT_GT(expected.norm(), 2e-4); // 1 / pixel
      EXPECT_LT((lens - expected).norm(), 0.05 * expected.norm()) << lens << "\n\n" << expected;
    }
  }
}

TEST(LensSecondOrder, IsNothingWithoutDistortionOrTooFewPixels)
{
  vpCameraParameters straight(500., 500., 319.5, 239.5);
  EXPECT_EQ(secondOrderOfLens(pixelsAround(CameraModel(straight), Eigen::Vector2d(100., 100.), 5)).norm(), 0.);
  vpCameraParameters radial;
  radial.initPersProjWithDistortion(500., 500., 319.5, 239.5, -0.2, 0.2);
  const std::vector<FitPixel> pixels = pixelsAround(CameraModel(radial), Eigen::Vector2d(100., 100.), 1);
  EXPECT_EQ(secondOrderOfLens({pixels[0]}).norm(), 0.);
  EXPECT_EQ(secondOrderOfLens({pixels[0], pixels[1]}).norm(), 0.);
}
