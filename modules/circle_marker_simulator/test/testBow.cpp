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
 * Tests of bent sheets: by rays through the pixels, and the truth that goes with them.
 */

#include "test_support.h"

using namespace simulator_test;

namespace {

constexpr double PAPER = 220.;
constexpr double INK = 30.;
constexpr double BACKGROUND = 110.;

// A cylinder stated by its radius: the sheet's half side is the arc of the angle `half`, whose height is the bow.
struct Cylinder
{
  double radius; // metres, > 0
  double sign;   // 1: edges away from the viewer
  double lift;   // metres, toward the viewer
  double axis;   // radians
};

double bowOf(const Cylinder &cylinder, double side)
{
  return cylinder.sign * cylinder.radius * (1. - std::cos(0.5 * side / cylinder.radius));
}

// Lift by brute force: the mean depth of the outer edge becomes 0.
double liftOf(double radius, double sign, double ring)
{
  double sum = 0.;
  for (int i = 0; i < 10000; ++i) {
    sum += sign * radius * (1. - std::cos(ring * std::cos(2. * M_PI * i / 10000.) / radius));
  }
  return sum / 10000.;
}

// Point of the flat sheet that the ray through a pixel meets, by the quadratic equation of the cylinder
// s^2 + (z - z_c)^2 = radius^2 in the marker frame; nothing if the ray misses it.
std::optional<std::pair<double, double>> onCylinder(const vpCameraParameters &cam, const vpHomogeneousMatrix &cMo,
                                                    const Cylinder &cylinder, double u, double v)
{
  double x = 0.;
  double y = 0.;
  vpPixelMeterConversion::convertPoint(cam, u, v, x, y);
  const vpHomogeneousMatrix oMc = cMo.inverse();
  const double origin[3] = {oMc[0][3], oMc[1][3], oMc[2][3]};
  double ray[3];
  for (unsigned int i = 0; i < 3; ++i) {
    ray[i] = oMc[i][0] * x + oMc[i][1] * y + oMc[i][2];
  }
  const double ax = std::cos(cylinder.axis), ay = std::sin(cylinder.axis); // along the axis
  const double os = -ay * origin[0] + ax * origin[1], rs = -ay * ray[0] + ax * ray[1];
  const double zc = cylinder.sign * cylinder.radius - cylinder.lift;
  const double oz = origin[2] - zc;
  const double a = rs * rs + ray[2] * ray[2], b = os * rs + oz * ray[2];
  const double c = os * os + oz * oz - cylinder.radius * cylinder.radius;
  const double discriminant = b * b - a * c;
  if (discriminant < 0.) {
    return std::nullopt;
  }
  // A sheet whose edges turn away is the near side of its cylinder, one whose edges come near is the far side.
  const double t = (-b - cylinder.sign * std::sqrt(discriminant)) / a;
  const double bent = os + t * rs;
  const double flat = cylinder.radius * std::asin(bent / cylinder.radius);
  const double along = ax * (origin[0] + t * ray[0]) + ay * (origin[1] + t * ray[1]);
  return std::pair(along * ax - flat * ay, along * ay + flat * ax);
}

void expectAsSampled(const vpCameraParameters &cam, unsigned int width, unsigned int height,
                     const vpSimulatedMarker &flat, const Cylinder &cylinder)
{
  vpSimulatedMarker marker = flat;
  marker.setBow(bowOf(cylinder, flat.getSheetWidth()), cylinder.axis);
  vpMarkerSceneSimulator simulator(cam, width, height);
  simulator.setPhotometry(idealSensor());
  simulator.setBackground(vpSceneBackground::plain(BACKGROUND));
  simulator.addMarker(marker);
  vpImage<float> I;
  simulator.renderNoiseFree(I);
  const auto shade = [&](double u, double v) {
    const auto point = onCylinder(cam, flat.getPose(), cylinder, u, v);
    return point ? shadeAt(flat, point->first, point->second, PAPER, INK).value_or(BACKGROUND) : BACKGROUND;
  };
  unsigned int mixed = 0;
  for (unsigned int i = 0; i < height; ++i) {
    for (unsigned int j = 0; j < width; ++j) {
      const double expected = sampledPixel(shade, j, i);
      mixed += expected != PAPER && expected != INK && expected != BACKGROUND;
      ASSERT_NEAR(I[i][j], expected, 0.1) << "pixel (" << j << ", " << i << ")";
    }
  }
  ASSERT_GT(mixed, 100u);
}

} // namespace

TEST(Bow, IsTheCylinderThatRaysMeet)
{
  std::mt19937_64 random = seededFromTestName();
  for (const double sign : {1., -1.}) {
    for (const bool isDistorted : {false, true}) {
      vpCameraParameters cam = pinhole(44, 44, 200.);
      if (isDistorted) {
        cam.initPersProjWithDistortion(200., 200., 21.5, 21.5, -0.2, 0.2);
      }
      vpSimulatedMarker marker = vpSimulatedMarker::circle("golay23", 5, 0.18);
      marker.setPose(tiltedPose(uniform(random, -0.01, 0.01), uniform(random, -0.01, 0.01), 1.3,
                                uniform(random, 0.2, 0.8), uniform(random, 0., 6.), uniform(random, 0., 6.)));
      const double radius = uniform(random, 0.2, 0.6); // strongly bent, so that it shows
      const Cylinder cylinder = {radius, sign, liftOf(radius, sign, 0.09), uniform(random, 0., 6.)};
      expectAsSampled(cam, 44, 44, marker, cylinder);
    }
  }
}

TEST(Bow, OfATagIsTheCylinderThatRaysMeet)
{
  vpSimulatedMarker marker = vpSimulatedMarker::aprilTag36h11(3, 0.16);
  marker.setPose(tiltedPose(0.01, 0., 1.3, 0.5, 1., 0.3));
  const Cylinder cylinder = {0.4, 1., liftOf(0.4, 1., 0.08), 0.7};
  expectAsSampled(pinhole(44, 44, 200.), 44, 44, marker, cylinder);
}

TEST(Bow, OfNothingIsFlat)
{
  vpSimulatedMarker marker = vpSimulatedMarker::circle("bch31", 7, 0.18);
  marker.setPose(tiltedPose(0.1, 0.05, 3., 0.7, 1., 2.));
  vpMarkerSceneSimulator simulator(pinhole(200, 200), 200, 200);
  simulator.addMarker(marker);
  vpImage<float> flat, bent, unbent;
  simulator.renderNoiseFree(flat);
  simulator.clearMarkers();
  simulator.addMarker(vpSimulatedMarker(marker).setBow(0.002, 1.).setBow(0., 1.));
  simulator.renderNoiseFree(unbent);
  simulator.clearMarkers();
  simulator.addMarker(vpSimulatedMarker(marker).setBow(0.002, 1.));
  simulator.renderNoiseFree(bent);
  double greatest = 0.;
  for (unsigned int i = 0; i < flat.getSize(); ++i) {
    ASSERT_EQ(unbent.bitmap[i], flat.bitmap[i]);
    greatest = std::max(greatest, static_cast<double>(std::fabs(bent.bitmap[i] - flat.bitmap[i])));
  }
  EXPECT_GT(greatest, 2.); // 2 mm of bow, seen at 40 degrees, move edges by some 0.1 pixels
}

TEST(Bow, KeepsTheMeanDepthOfTheOuterEdge)
{
  // Facing the camera the edge's image widens where it is nearer and shrinks where it is farther: the mean stays.
  const vpCameraParameters cam = pinhole(1280, 960);
  const auto axes = [&cam](double bow) {
    vpMarkerSceneSimulator simulator(cam, 1280, 960);
    vpSimulatedMarker marker = vpSimulatedMarker::circle("golay23", 5, 0.18);
    simulator.addMarker(marker.setPose(tiltedPose(0., 0., 1., 0., 0., 0.)).setBow(bow, 0.3));
    return simulator.getTruth()[0].ellipse.value();
  };
  const vpEllipseTruth flat = axes(0.), bent = axes(0.002);
  EXPECT_GT(bent.semiAxisA - bent.semiAxisB, 0.05);
  EXPECT_NEAR(0.5 * (bent.semiAxisA + bent.semiAxisB), flat.semiAxisA, 0.02);
}

TEST(Bow, RefusesWhatIsTooMuch)
{
  vpSimulatedMarker marker = vpSimulatedMarker::circle("golay23", 5, 0.18);
  EXPECT_THROW(marker.setBow(0.03), vpException);
  EXPECT_THROW(marker.setBow(std::nan("")), vpException);
  // At 89 degrees a part of the sheet is hidden behind its own bend.
  marker.setPose(tiltedPose(0., 0., 3., 1.553, 0., 0.)).setBow(0.005, 0.);
  vpMarkerSceneSimulator simulator(pinhole(200, 200), 200, 200);
  simulator.addMarker(marker);
  vpImage<float> I;
  EXPECT_THROW(simulator.renderNoiseFree(I), vpException);
}
