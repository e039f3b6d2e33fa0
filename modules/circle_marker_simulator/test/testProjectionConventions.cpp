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
 * Pixel centres, frames and lens models of the simulated camera, against OpenCV and ViSP.
 */

#include <opencv2/calib3d.hpp>

#include <visp3/core/vpMeterPixelConversion.h>

#include "test_support.h"

using namespace simulator_test;

namespace {

// Conic of a circle of radius r in the plane z = 0 of the marker, projected without distortion: H^-T diag(1, 1, -r^2)
// H^-1 with H = K (r1 r2 t). Area and centre follow from it in closed form.
struct ConicImage
{
  double area;
  double u;
  double v;
};

ConicImage conicOf(const vpCameraParameters &cam, const vpHomogeneousMatrix &cMo, double radius)
{
  vpMatrix H(3, 3);
  for (unsigned int i = 0; i < 3; ++i) {
    H[i][0] = cMo[i][0];
    H[i][1] = cMo[i][1];
    H[i][2] = cMo[i][3];
  }
  // The adjugate of the conic is H diag(1, 1, -1/r^2) H^T up to scale: no inverse is needed.
  vpMatrix D(3, 3, 0.);
  D[0][0] = D[1][1] = radius * radius;
  D[2][2] = -1.;
  const vpMatrix A = cam.get_K() * H * D * H.t() * cam.get_K().t();
  const double u = A[0][2] / A[2][2];
  const double v = A[1][2] / A[2][2];
  // The adjugate of an ellipse with covariance-like matrix S around c is proportional to c c^T - S.
  const double s20 = u * u - A[0][0] / A[2][2];
  const double s11 = u * v - A[0][1] / A[2][2];
  const double s02 = v * v - A[1][1] / A[2][2];
  return {M_PI * std::sqrt(s20 * s02 - s11 * s11), u, v};
}

// Ink within `reach` pixels of a point, in pixels of pure ink, and its centroid. (In the whole image the few millionths
// of a grey level by which 220 is missed far from the marker would count: the farther, the more.)
ConicImage inkOf(const vpImage<float> &I, double paper, double ink, const vpImagePoint &center, double reach)
{
  double area = 0., u = 0., v = 0.;
  for (unsigned int i = 0; i < I.getHeight(); ++i) {
    for (unsigned int j = 0; j < I.getWidth(); ++j) {
      if (std::fabs(i - center.get_v()) > reach || std::fabs(j - center.get_u()) > reach) {
        continue;
      }
      const double share = (paper - I[i][j]) / (paper - ink);
      area += share;
      u += share * j;
      v += share * i;
    }
  }
  return {area, u / area, v / area};
}

} // namespace

TEST(ProjectionConventions, PointsProjectAsInOpenCvAndViSP)
{
  std::mt19937_64 random = seededFromTestName();
  vpCameraParameters cam;
  cam.initPersProjWithoutDistortion(1600., 1580., 639.5, 470.25);
  const vpMarkerSceneSimulator simulator(cam, 1280, 960);
  const cv::Matx33d K(1600., 0., 639.5, 0., 1580., 470.25, 0., 0., 1.);
  for (int i = 0; i < 1000; ++i) {
    const cv::Point3d X(uniform(random, -1., 1.), uniform(random, -1., 1.), uniform(random, 0.5, 10.));
    std::vector<cv::Point2d> expected;
    cv::projectPoints(std::vector<cv::Point3d>{X}, cv::Vec3d(0., 0., 0.), cv::Vec3d(0., 0., 0.), K, cv::noArray(),
                      expected);
    const vpImagePoint p = simulator.project(X.x, X.y, X.z);
    EXPECT_NEAR(p.get_u(), expected[0].x, 1e-9);
    EXPECT_NEAR(p.get_v(), expected[0].y, 1e-9);
    double u = 0., v = 0.;
    vpMeterPixelConversion::convertPoint(cam, X.x / X.z, X.y / X.z, u, v);
    EXPECT_NEAR(p.get_u(), u, 1e-9);
    EXPECT_NEAR(p.get_v(), v, 1e-9);
  }
}

TEST(ProjectionConventions, PixelToMeterUndoesTheProjectionOfEveryModel)
{
  std::mt19937_64 random = seededFromTestName();
  vpCameraParameters barrel, pincushion, fisheye;
  barrel.initPersProjWithDistortion(1600., 1610., 639.5, 479.5, -0.25, 0.3);
  pincushion.initPersProjWithDistortion(1600., 1590., 639.5, 479.5, 0.25, -0.3);
  fisheye.initProjWithKannalaBrandtDistortion(400., 405., 639.5, 479.5, {-0.03, 0.01, -0.004, 0.0005});
  for (const vpCameraParameters &cam : {barrel, pincushion, fisheye}) {
    const vpMarkerSceneSimulator simulator(cam, 1280, 960);
    for (int i = 0; i < 1000; ++i) {
      const double X = uniform(random, -0.5, 0.5), Y = uniform(random, -0.4, 0.4), Z = uniform(random, 0.9, 3.);
      double x = 0., y = 0.;
      vpPixelMeterConversion::convertPoint(cam, simulator.project(X, Y, Z), x, y);
      EXPECT_NEAR(x, X / Z, 1e-12);
      EXPECT_NEAR(y, Y / Z, 1e-12);
    }
  }
}

TEST(ProjectionConventions, AreaAndCentroidOfARenderedDiscAreThoseOfTheConic)
{
  std::mt19937_64 random = seededFromTestName();
  const vpCameraParameters cam = pinhole(320, 240, 800.);
  for (int i = 0; i < 24; ++i) {
    vpMarkerSceneSimulator simulator(cam, 320, 240);
    vpScenePhotometry photometry = idealSensor();
    photometry.blurSigma = i % 4 == 0 ? 0. : uniform(random, 0.3, 2.);
    photometry.defocusRadius = i % 8 == 1 ? 2. : 0.;
    simulator.setPhotometry(photometry);
    simulator.setBackground(vpSceneBackground::plain(photometry.paper)); // nothing but the disc shows
    const double azimuth = uniform(random, 0., 2. * M_PI);
    const double z = uniform(random, 1.3, 8.);
    const vpHomogeneousMatrix cMo = tiltedPose(uniform(random, -0.03, 0.03) * z, uniform(random, -0.03, 0.03) * z, z,
                                               uniform(random, 0., 1.3), azimuth, 0.);
    simulator.addMarker(vpSimulatedMarker::disc(0.18).setPose(cMo));
    vpImage<float> I;
    simulator.renderNoiseFree(I);
    const ConicImage expected = conicOf(cam, cMo, 0.09);
    const vpEllipseTruth ellipse = *simulator.getTruth()[0].ellipse;
    const ConicImage measured =
        inkOf(I, photometry.paper, photometry.ink, ellipse.center, ellipse.semiAxisA + 6. * photometry.blurSigma + 3.);
    // An edge 1e-5 pixels off would change the area by this times the perimeter, which is below pi (a + b).
    EXPECT_NEAR(measured.area, expected.area, 1e-5 * M_PI * (ellipse.semiAxisA + ellipse.semiAxisB));
    if (photometry.blurSigma >= 0.5) {
      // Sampling an image that is blurred as little as this keeps its centroid. Pixels alone do not: their centres
      // stand for whatever lies inside of them, which shifts the centroid of an unblurred disc by some 1e-4 pixels.
      EXPECT_NEAR(measured.u, expected.u, 1e-5);
      EXPECT_NEAR(measured.v, expected.v, 1e-5);
    }
    EXPECT_NEAR(M_PI * ellipse.semiAxisA * ellipse.semiAxisB, expected.area, 1e-8 * expected.area);
    EXPECT_NEAR(ellipse.center.get_u(), expected.u, 1e-8);
    EXPECT_NEAR(ellipse.center.get_v(), expected.v, 1e-8);
  }
}

TEST(ProjectionConventions, EllipseAxesOfATiltedCircle)
{
  // On the axis and far away the image is the scaled orthographic one: b / a = cos(tilt), b along the tilt's direction.
  const vpCameraParameters cam = pinhole(1280, 960);
  vpMarkerSceneSimulator simulator(cam, 1280, 960);
  const double tilt = 0.6, azimuth = 0.4, z = 1000.;
  simulator.addMarker(vpSimulatedMarker::disc(20.).setPose(tiltedPose(0., 0., z, tilt, azimuth, 0.)));
  const vpMarkerTruth truth = simulator.getTruth()[0];
  EXPECT_NEAR(truth.ellipse->semiAxisA, 1600. * 10. / z, 1e-2);
  EXPECT_NEAR(truth.ellipse->semiAxisB, 1600. * 10. * std::cos(tilt) / z, 1e-2);
  EXPECT_NEAR(truth.ellipse->angle, azimuth, 1e-3); // the rotation's axis is the greater axis
  EXPECT_NEAR(truth.tilt, tilt, 1e-12);
  EXPECT_NEAR(truth.center.get_u(), 639.5, 1e-9);
}

TEST(ProjectionConventions, SectorZeroLiesFromXTowardYAsSeenByTheCamera)
{
  // Frontal and upright: x to the right, y down in the image. Sector 0 of id 0 (2787, 12 bits of 23) is white, and the
  // last sector, the least significant bit, is black.
  const vpCameraParameters cam = pinhole(400, 400, 1000.);
  vpMarkerSceneSimulator simulator(cam, 400, 400);
  simulator.setPhotometry(idealSensor());
  vpHomogeneousMatrix cMo(0., 0., 0.5, 0., 0., 0.);
  simulator.addMarker(vpSimulatedMarker::circle("golay23", 0, 0.18).setPose(cMo));
  vpImage<float> I;
  simulator.renderNoiseFree(I);
  for (unsigned int sector = 0; sector < 23; ++sector) {
    const double angle = 2. * M_PI * (sector + 0.5) / 23.;
    const double radius = 0.54 * 0.09 / 0.5 * 1000.;
    const unsigned int u = static_cast<unsigned int>(std::lround(199.5 + radius * std::cos(angle)));
    const unsigned int v = static_cast<unsigned int>(std::lround(199.5 + radius * std::sin(angle)));
    EXPECT_EQ(I[v][u], (2787u >> (22 - sector)) & 1 ? 30.f : 220.f) << "sector " << sector;
  }
}

TEST(ProjectionConventions, WhatCannotBeSeenThrows)
{
  const vpCameraParameters cam = pinhole(1280, 960);
  vpMarkerSceneSimulator simulator(cam, 1280, 960);
  vpImage<unsigned char> I;
  simulator.addMarker(vpSimulatedMarker::disc(0.18).setPose(tiltedPose(0., 0., -1., 0., 0., 0.)));
  EXPECT_THROW(simulator.render(I, 0), vpException);
  simulator.setMarkerPose(0, tiltedPose(0., 0., 0.05, 1.5, 0., 0.)); // half of the sheet is behind the camera
  EXPECT_THROW(simulator.render(I, 0), vpException);
  simulator.setMarkerPose(0, tiltedPose(0., 0., 0.5, 1.5, 0., 0.));
  EXPECT_NO_THROW(simulator.render(I, 0));
  vpCameraParameters folding;
  folding.initPersProjWithDistortion(400., 400., 639.5, 479.5, 0.2, -0.5);
  vpMarkerSceneSimulator beyond(folding, 1280, 960);
  beyond.addMarker(vpSimulatedMarker::disc(0.18).setPose(tiltedPose(1., 0., 1., 0., 0., 0.)));
  EXPECT_THROW(beyond.render(I, 0), vpException);
}

TEST(ProjectionConventions, FromBehindASheetIsBlank)
{
  const vpCameraParameters cam = pinhole(320, 240, 800.);
  vpMarkerSceneSimulator simulator(cam, 320, 240);
  simulator.setPhotometry(idealSensor());
  simulator.setBackground(vpSceneBackground::plain(100.));
  simulator.addMarker(vpSimulatedMarker::circle("golay23", 1, 0.18).setPose(tiltedPose(0., 0., 1., M_PI, 0., 0.)));
  vpImage<float> I;
  simulator.renderNoiseFree(I);
  EXPECT_EQ(I[120][160], 220.f);
  EXPECT_EQ(I[120][160 + 60], 220.f); // the ring would be here
  EXPECT_EQ(I[10][10], 100.f);
  EXPECT_EQ(simulator.getTruth()[0].visibleEdge, 0.);
}
