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
 * Derivatives of the image model against differences.
 */

#include "testDarkness.h"
#include "testPatternDistance.h"
#include "testRoomTools.h"

#include "support/camera_model.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr unsigned int side = 130;

ModelPixel pixelAt(const CameraModel &camera, const Eigen::Vector2d &where)
{
  return {camera.toMeter(where), camera.meterPerPixel(where)};
}

const vpCircleMarkerFamily::vpType families[] = {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31,
                                                 vpCircleMarkerFamily::BCH31R, vpCircleMarkerFamily::RING,
                                                 vpCircleMarkerFamily::DISC};

int randomId(Random &random, const vpCircleMarkerFamily &family)
{
  return family.isCoded() ? static_cast<int>(random() % family.getNbIds()) : -1;
}
void expectDerivatives(double leastDiameter, double mostDiameter, double precision, Random &random)
{
  for (const vpCircleMarkerFamily::vpType type : families) {
    const vpCircleMarkerFamily family(type);
    for (int i = 0; i < 8; ++i) {
      const int id = randomId(random, family);
      const MarkerScene scene =
          markerScene(random, family, id, uniform(random, leastDiameter, mostDiameter), uniform(random, 0., 0.9), side);
      const MarkerPattern pattern = patternOf(family, id);
      const CameraModel camera(scene.camera());
      const double pixelSize = scene.center.z() / scene.focal;
      BlurParameters blur;
      blur.sigma = uniform(random, 0.6, 1.2);
      blur.spread = uniform(random, -0.2, 0.2) * pixelSize / scene.radius;
      blur.elongation = Eigen::Vector2d(uniform(random, -0.15, 0.15), uniform(random, -0.15, 0.15));
      blur.sigma /= std::pow(blur.widest() / blur.sigma, 2.); // edges bend as much at most within it as without
      // Central differences with steps of about a hundredth of a pixel.
      const auto difference = [&](const ModelPixel &pixel, int parameter) {
        double values[2];
        double step = 0.01;
        for (int sign = 0; sign < 2; ++sign) {
          MarkerPlane plane = scene.plane();
          BlurParameters changed = blur;
          const double h = (sign ? 1. : -1.) * 0.01;
          if (parameter < 3) {
            step = 0.01 * pixelSize;
            plane.center[parameter] += h * pixelSize;
          }
          else if (parameter < 6) {
            step = 0.01 * pixelSize / scene.radius;
            plane.rotation = turn(h * pixelSize / scene.radius, Eigen::Vector3d::Unit(parameter - 3)) * plane.rotation;
          }
          else if (parameter == 6) {
            changed.sigma += h;
          }
          else if (parameter == 7) {
            step = 0.01 * pixelSize / scene.radius;
            changed.spread += h * pixelSize / scene.radius;
          }
          else if (parameter < 10) {
            changed.elongate(h * Eigen::Vector2d::Unit(parameter - 8));
          }
          else {
            step = 0.01 * pixelSize / scene.radius;
            const Eigen::Vector3d bend = h * pixelSize / scene.radius * Eigen::Vector3d::Unit(parameter - 10);
            plane.bend = {bend.x(), bend.tail<2>()};
          }
          values[sign] = darknessAt(pixel, plane, pattern, changed).value;
        }
        return (values[1] - values[0]) / (2. * step);
      };
      constexpr int count = 13; // of parameters
      std::array<double, count> largest{};
      std::array<double, count> worst{};
      std::array<double, count> worstAtCorners{};
      for (int k = 0; k < 800; ++k) {
        const Eigen::Vector2d where(std::floor(uniform(random, 5., 125.)), std::floor(uniform(random, 5., 125.)));
        const ModelPixel pixel = pixelAt(camera, where);
        const Darkness darkness = darknessAt(pixel, scene.plane(), pattern, blur);
        // Where a border of sectors may meet a rim.
        const double radius = scene.onMarker(where.x(), where.y()).norm();
        const vpCircleMarkerLayout &layout = family.getLayout();
        const double reach = 5.5 * blur.widest() * 2. * pixelSize / (scene.radius * std::cos(0.9));
        const bool seesCorners =
            family.isCoded() && radius > layout.codeInner - reach && radius < layout.codeOuter + reach;
        for (int parameter = 0; parameter < count; ++parameter) {
          const auto p = static_cast<std::size_t>(parameter);
          const double analytic = parameter < 6    ? darkness.byPose[parameter]
                                  : parameter == 6 ? darkness.bySigma
                                  : parameter == 7 ? darkness.bySpread
                                  : parameter < 10 ? darkness.byElongation[parameter - 8]
                                                   : darkness.byBend[parameter - 10];
          ASSERT_TRUE(std::isfinite(analytic)) << parameter;
          const double numeric = difference(pixel, parameter);
          largest[p] = std::max(largest[p], std::fabs(numeric));
          double &most = seesCorners ? worstAtCorners[p] : worst[p];
          most = std::max(most, std::fabs(analytic - numeric));
        }
      }
      // What a sharp edge's derivative is like: the sample may have met no edge.
      const double common = 0.4 / blur.sigma;
      for (std::size_t p = 0; p < count; ++p) {
        const bool isLength = (p >= 3 && p < 6) || p == 7 || p >= 10;
        const double scale = p < 3 ? common / pixelSize : isLength ? common * scene.radius / pixelSize : common;
        const double size = std::max(largest[p], scale);
        EXPECT_LT(worst[p], precision * size) << family.getName() << " parameter " << p << " sigma " << blur.sigma;
        // How the blur's elongation changes what rims bend away at corners is not in the derivative.
        const double atCorners = p < 8 || p >= 10 ? precision : std::max(precision, 0.1);
        EXPECT_LT(worstAtCorners[p], atCorners * size)
            << family.getName() << " parameter " << p << " sigma " << blur.sigma << " at corners";
      }
    }
  }
}
} // namespace

TEST(ImageModelDerivatives, AgreeWithDifferences)
{
  Random random = randomOfTest();
  expectDerivatives(50., 100., 0.03, random);
}

TEST(ImageModelDerivatives, OfSmallMarkersAgreeWithDifferences)
{
  Random random = randomOfTest();
  expectDerivatives(25., 50., 0.05, random);
}
