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
 * Area sampling of the simulated camera, against sampling by brute force.
 */

#include <algorithm>

#include "test_support.h"

using namespace simulator_test;

namespace {

// 0.1 grey levels, the accuracy the simulated camera promises, in each pixel.
constexpr double GREY_TOLERANCE = 0.1;
constexpr double PAPER = 220.;
constexpr double INK = 30.;
constexpr double BACKGROUND = 110.;

// Compares the whole image with the referee, whose scene is one marker in front of another and an ellipse in front.
void expectAsSampled(const vpCameraParameters &cam, unsigned int width, unsigned int height,
                     const std::vector<vpSimulatedMarker> &markers,
                     const std::function<std::optional<double>(double, double)> &occluder,
                     const std::vector<vpSceneOccluder> &occluders)
{
  vpMarkerSceneSimulator simulator(cam, width, height);
  simulator.setPhotometry(idealSensor());
  simulator.setBackground(vpSceneBackground::plain(BACKGROUND));
  for (const vpSimulatedMarker &marker : markers) {
    simulator.addMarker(marker);
  }
  for (const vpSceneOccluder &o : occluders) {
    simulator.addOccluder(o);
  }
  vpImage<float> I;
  simulator.renderNoiseFree(I);
  const auto shade = [&](double u, double v) {
    if (const auto grey = occluder(u, v)) {
      return *grey;
    }
    for (auto marker = markers.rbegin(); marker != markers.rend(); ++marker) {
      const auto [x, y] = onMarker(cam, marker->getPose(), u, v);
      if (const auto grey = shadeAt(*marker, x, y, PAPER, INK)) {
        return *grey;
      }
    }
    return BACKGROUND;
  };
  double worst = 0.;
  double sum = 0.;
  unsigned int mixed = 0;
  for (unsigned int i = 0; i < height; ++i) {
    for (unsigned int j = 0; j < width; ++j) {
      const double expected = sampledPixel(shade, j, i);
      const double difference = I[i][j] - expected;
      ASSERT_NEAR(I[i][j], expected, GREY_TOLERANCE) << "pixel (" << j << ", " << i << ")";
      worst = std::max(worst, std::fabs(difference));
      const bool crossed = expected != PAPER && expected != INK && expected != BACKGROUND;
      mixed += crossed;
      sum += crossed ? difference : 0.;
    }
  }
  ASSERT_GT(mixed, 100u);                  // pixels on edges: there was something to get wrong
  EXPECT_LT(std::fabs(sum / mixed), 0.01); // no bias: 0.01 grey levels are 5e-5 pixels of an edge
  ::testing::Test::RecordProperty("worst", std::to_string(worst));
}

std::optional<double> nothing(double, double)
{
  return std::nullopt;
}

constexpr unsigned int WIDTH = 64;
constexpr unsigned int HEIGHT = 56;

} // namespace

TEST(AreaSampling, CodedMarkersAtRandomPoses)
{
  std::mt19937_64 random = seededFromTestName();
  const vpCameraParameters cam = pinhole(WIDTH, HEIGHT, 200.);
  for (const auto &[family, id] : {std::pair("golay23", 5), std::pair("bch31", 1234), std::pair("bch31r", 65)}) {
    const double azimuth = uniform(random, 0., 2. * M_PI);
    const vpHomogeneousMatrix cMo =
        tiltedPose(uniform(random, -0.05, 0.05), uniform(random, -0.05, 0.05), uniform(random, 0.9, 1.1),
                   uniform(random, 0., 1.2), azimuth, uniform(random, 0., 2. * M_PI));
    expectAsSampled(cam, WIDTH, HEIGHT, {vpSimulatedMarker::circle(family, id, 0.18).setPose(cMo)}, nothing, {});
  }
}

TEST(AreaSampling, MarkerBeyondTheImageBorder)
{
  const vpCameraParameters cam = pinhole(WIDTH, HEIGHT, 200.);
  for (const auto &[x, y] : {std::pair(-0.17, 0.02), std::pair(0.17, -0.14), std::pair(0.01, 0.15)}) {
    const vpHomogeneousMatrix cMo = tiltedPose(x, y, 1., 0.4, 1., 0.3);
    expectAsSampled(cam, WIDTH, HEIGHT, {vpSimulatedMarker::circle("golay23", 177, 0.18).setPose(cMo)}, nothing, {});
  }
}

TEST(AreaSampling, RingDiscTagAndPicture)
{
  const vpCameraParameters cam = pinhole(WIDTH, HEIGHT, 200.);
  const vpHomogeneousMatrix cMo = tiltedPose(0.013, -0.007, 0.9, 0.7, 2., 1.);
  vpImage<unsigned char> picture(5, 7);
  for (unsigned int i = 0; i < picture.getSize(); ++i) {
    picture.bitmap[i] = static_cast<unsigned char>((i * 73) % 256);
  }
  expectAsSampled(cam, WIDTH, HEIGHT, {vpSimulatedMarker::ring(0.18, 0.7).setPose(cMo)}, nothing, {});
  expectAsSampled(cam, WIDTH, HEIGHT, {vpSimulatedMarker::disc(0.18).setPose(cMo)}, nothing, {});
  expectAsSampled(cam, WIDTH, HEIGHT, {vpSimulatedMarker::aprilTag36h11(7, 0.168).setPose(cMo)}, nothing, {});
  expectAsSampled(cam, WIDTH, HEIGHT, {vpSimulatedMarker::bitmap(picture, 0.21, 0.15).setPose(cMo)}, nothing, {});
}

TEST(AreaSampling, UprightTagWhoseEdgesFollowThePixels)
{
  const vpCameraParameters cam = pinhole(WIDTH, HEIGHT, 200.);
  const vpHomogeneousMatrix cMo = tiltedPose(0.0123, -0.0071, 1.03, 0., 0., 0.);
  expectAsSampled(cam, WIDTH, HEIGHT, {vpSimulatedMarker::aprilTag36h11(0, 0.168).setPose(cMo)}, nothing, {});
}

TEST(AreaSampling, EveryLensModelIsWhatPixelToMeterUndoes)
{
  // Away from the axis, where the distortion is: the principal point lies outside of the small image.
  vpCameraParameters barrel, pincushion, fisheye;
  barrel.initPersProjWithDistortion(200., 210., -40., -30., -0.3, 0.35); // kud is not the inverse of kdu
  pincushion.initPersProjWithDistortion(200., 190., -40., -30., 0.2, -0.15);
  fisheye.initProjWithKannalaBrandtDistortion(200., 205., -40., -30., {-0.03, 0.01, -0.004, 0.0005});
  for (const vpCameraParameters &cam : {barrel, pincushion, fisheye}) {
    double x = 0.;
    double y = 0.;
    vpPixelMeterConversion::convertPoint(cam, 31., 27., x, y);
    const vpHomogeneousMatrix cMo = tiltedPose(x, y, 1., 0.5, 4., 2.);
    expectAsSampled(cam, WIDTH, HEIGHT, {vpSimulatedMarker::circle("golay23", 9, 0.18).setPose(cMo)}, nothing, {});
    expectAsSampled(cam, WIDTH, HEIGHT, {vpSimulatedMarker::aprilTag36h11(9, 0.16).setPose(cMo)}, nothing, {});
  }
}

TEST(AreaSampling, MarkersAndOccludersThatCoverOneAnother)
{
  const vpCameraParameters cam = pinhole(WIDTH, HEIGHT, 200.);
  const vpSimulatedMarker behind =
      vpSimulatedMarker::circle("golay23", 3, 0.18).setPose(tiltedPose(-0.02, 0.01, 1., 0.3, 1., 0.5));
  const vpSimulatedMarker inFront =
      vpSimulatedMarker::aprilTag36h11(2, 0.08).setPose(tiltedPose(0.07, 0.03, 0.95, 0.4, 3., 0.2));
  const double a = 9.3, b = 4.7, angle = 0.6, u0 = 22.4, v0 = 25.7;
  const auto ellipse = [=](double u, double v) -> std::optional<double> {
    const double x = (u - u0) * std::cos(angle) + (v - v0) * std::sin(angle);
    const double y = (v - v0) * std::cos(angle) - (u - u0) * std::sin(angle);
    return x * x / (a * a) + y * y / (b * b) <= 1. ? std::optional<double>(75.) : std::nullopt;
  };
  expectAsSampled(cam, WIDTH, HEIGHT, {behind, inFront}, ellipse,
                  {vpSceneOccluder::ellipse(vpImagePoint(v0, u0), a, b, angle, 75.)});
  const auto bar = [](double u, double v) -> std::optional<double> {
    return u >= 20.25 && u <= 24.75 && v >= 3.5 && v <= 50.5 ? std::optional<double>(150.) : std::nullopt;
  };
  expectAsSampled(cam, WIDTH, HEIGHT, {behind, inFront}, bar,
                  {vpSceneOccluder::bar(vpImagePoint(3.5, 22.5), vpImagePoint(50.5, 22.5), 4.5, 150.)});
}

TEST(AreaSampling, CoincidingEdgesOfTwoSheets)
{
  // The second sheet lies exactly on the first; and a third shares an edge with both.
  const vpCameraParameters cam = pinhole(WIDTH, HEIGHT, 200.);
  const vpHomogeneousMatrix cMo = tiltedPose(-0.02, 0.01, 1.1, 0.3, 1., 0.5);
  const vpHomogeneousMatrix beside = cMo * vpHomogeneousMatrix(0.15, 0., 0., 0., 0., 0.);
  expectAsSampled(cam, WIDTH, HEIGHT,
                  {vpSimulatedMarker::disc(0.10).setSheetSide(0.15).setPose(cMo),
                   vpSimulatedMarker::ring(0.12, 0.5).setSheetSide(0.15).setPose(cMo),
                   vpSimulatedMarker::disc(0.05).setSheetSide(0.15).setPose(beside)},
                  nothing, {});
}

TEST(AreaSampling, CornersOfAnOccluderMayGoEitherWayRound)
{
  std::vector<vpImagePoint> corners = {{10.25, 12.75}, {10.25, 40.25}, {38.75, 40.25}, {38.75, 12.75}};
  const auto rectangle = [](double u, double v) -> std::optional<double> {
    return u >= 12.75 && u <= 40.25 && v >= 10.25 && v <= 38.75 ? std::optional<double>(75.) : std::nullopt;
  };
  for (int way = 0; way < 2; ++way) {
    expectAsSampled(pinhole(WIDTH, HEIGHT, 200.), WIDTH, HEIGHT, {}, rectangle,
                    {vpSceneOccluder::polygon(corners, 75.)});
    std::reverse(corners.begin(), corners.end());
  }
}
