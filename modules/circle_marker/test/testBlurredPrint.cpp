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
 * Test of a print that is seen through a blur.
 */

#include "testRoomTools.h"

#include <Eigen/Geometry>

#include "decode/blurred_print.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr unsigned int side = 200; // pixels

// A print, the blur that it is seen through, and how dark its parts are.
struct Look
{
  vpCircleMarkerFamily family;
  MarkerPlane plane;
  ImageBlur blur;
  Eigen::Matrix2d meterPerPixel;
  PrintParts darkness;
};

Look drawLook(Random &random, vpCircleMarkerFamily::vpType type, bool isDisc)
{
  const vpCircleMarkerFamily family(type);
  const MarkerScene scene =
      markerScene(random, family, family.isCoded() ? 3 : -1, uniform(random, 40., 90.), uniform(random, 0.1, 1.), side);
  Look look = {family, scene.plane(), ImageBlur(), Eigen::Matrix2d::Identity() / scene.focal, PrintParts()};
  if (isDisc) {
    look.blur.disc = uniform(random, 2., 8.);
  }
  else {
    look.blur.motion = Eigen::Vector2d(uniform(random, 4., 15.), uniform(random, -8., 8.));
  }
  look.darkness.ring = 150.;
  for (double &sector : look.darkness.sector) {
    sector = uniform(random, 0., 150.);
  }
  return look;
}

double darknessOf(const Look &look, const MarkerPlane &plane, const ImageBlur &blur, const Eigen::Vector2d &meter)
{
  const auto sectors = static_cast<int>(look.family.getNbSectors());
  BlurredPrint print(look.family.getLayout(), sectors);
  print.set(plane, blur, look.meterPerPixel, 1.);
  PrintParts shares;
  print.see(meter, shares);
  double sum = look.darkness.ring * shares.ring;
  for (std::size_t k = 0; k < static_cast<std::size_t>(sectors); ++k) {
    sum += look.darkness.sector[k] * shares.sector[k];
  }
  return sum;
}

MarkerPlane movedBy(const Eigen::Matrix<double, 6, 1> &twist, MarkerPlane plane)
{
  plane.center += plane.radius * (plane.rotation * twist.head<3>());
  const double angle = twist.tail<3>().norm();
  if (angle > 0.) {
    plane.rotation = plane.rotation * Eigen::AngleAxisd(angle, twist.tail<3>() / angle).toRotationMatrix();
  }
  return plane;
}

// By differences: six by the pose's twist, two by the motion, one by the disc.
Eigen::Matrix<double, 9, 1> differencesAt(const Look &look, const Eigen::Vector2d &meter)
{
  constexpr double h = 1e-6;
  Eigen::Matrix<double, 9, 1> slopes;
  for (int k = 0; k < 9; ++k) {
    std::array<double, 2> ends;
    for (std::size_t end = 0; end < ends.size(); ++end) {
      const double step = end == 0 ? -h : h;
      MarkerPlane plane = look.plane;
      ImageBlur blur = look.blur;
      if (k < 6) {
        plane = movedBy(step * Eigen::Matrix<double, 6, 1>::Unit(k), plane);
      }
      else if (k < 8) {
        blur.motion[k - 6] += step;
      }
      else {
        blur.disc += step;
      }
      ends[end] = darknessOf(look, plane, blur, meter);
    }
    slopes[k] = (ends[1] - ends[0]) / (2. * h);
  }
  return slopes;
}

// Share of random looks and places at which the slopes are the differences; where a ramp begins they need not be.
double agreement(vpCircleMarkerFamily::vpType type, bool isDisc, Random &random)
{
  constexpr int count = 300;
  int agreeing = 0;
  for (int i = 0; i < count; ++i) {
    const Look look = drawLook(random, type, isDisc);
    BlurredPrint print(look.family.getLayout(), static_cast<int>(look.family.getNbSectors()));
    print.set(look.plane, look.blur, look.meterPerPixel, 1.);
    const double angle = uniform(random, 0., 2. * M_PI);
    const Eigen::Vector2d meter =
        look.plane.project(uniform(random, 0.1, 1.3) * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    const DarknessSlopes slopes = print.slopesAt(meter, look.darkness);
    Eigen::Matrix<double, 9, 1> analytic;
    analytic << slopes.byTwist, slopes.byMotion, slopes.byDisc;
    Eigen::Matrix<double, 9, 1> numeric = differencesAt(look, meter);
    numeric.segment<3>(6) = isDisc ? Eigen::Vector3d(0., 0., numeric[8]) : Eigen::Vector3d(numeric[6], numeric[7], 0.);
    agreeing += (analytic - numeric).norm() < 1e-4 * numeric.norm() + 1e-3 ? 1 : 0;
  }
  return static_cast<double>(agreeing) / count;
}
} // namespace

TEST(BlurredPrint, SlopesAreTheDifferences)
{
  Random random = randomOfTest();
  for (const bool isDisc : {false, true}) {
    EXPECT_GT(agreement(vpCircleMarkerFamily::GOLAY23, isDisc, random), 0.98) << isDisc;
    EXPECT_GT(agreement(vpCircleMarkerFamily::RING, isDisc, random), 0.98) << isDisc;
  }
}

TEST(BlurredPrint, InTheMiddleOfTheRingNothingElseIsSeen)
{
  Random random = randomOfTest();
  for (int i = 0; i < 20; ++i) {
    Look look = drawLook(random, vpCircleMarkerFamily::GOLAY23, true);
    look.blur = ImageBlur();
    BlurredPrint print(look.family.getLayout(), 23);
    print.set(look.plane, look.blur, look.meterPerPixel, 1.);
    const double angle = uniform(random, 0., 2. * M_PI);
    const Eigen::Vector2d out(std::cos(angle), std::sin(angle));
    const double middle = 0.5 * (1. + look.family.getLayout().ringInner);
    PrintParts shares;
    print.see(look.plane.project(3. * out), shares);
    EXPECT_EQ(shares.ring, 0.);
    print.see(look.plane.project(middle * out), shares);
    EXPECT_GT(shares.ring, 0.5);
    EXPECT_LE(shares.ring, 1.);
    EXPECT_TRUE(print.isWithin(look.plane.project(middle * out), 1.));
    EXPECT_FALSE(print.isWithin(look.plane.project(1.1 * out), 1.));
  }
}
