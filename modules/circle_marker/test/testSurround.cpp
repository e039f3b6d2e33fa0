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
 * What lies beyond a marker's quiet zone.
 */

#include "testRoomTools.h"

#include "refine/surround.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr unsigned int side = 120;
} // namespace

TEST(Surround, DirectionsGoAroundOnce)
{
  for (unsigned int k = 0; k < Surround::directions; ++k) {
    const double angle = 2. * M_PI * k / Surround::directions;
    for (const double off : {-0.4, 0., 0.4}) {
      const double a = angle + off * 2. * M_PI / Surround::directions;
      EXPECT_EQ(Surround::directionOf(3. * Eigen::Vector2d(std::cos(a), std::sin(a))), k);
    }
  }
}

TEST(Surround, SeesWhereThePaperEnds)
{
  Random random = randomOfTest();
  for (int i = 0; i < 10; ++i) {
    MarkerScene scene =
        markerScene(random, vpCircleMarkerFamily(vpCircleMarkerFamily::RING), -1, 60., uniform(random, 0., 0.8), side);
    const vpImage<unsigned char> I = photograph(side, side, 0.7, scene);
    const CameraModel camera(scene.camera());
    Surround surround(I, camera, scene.plane(), {PaperShape::ROUND, 1. + 1. / 6., 0.}, 0.8);
    for (unsigned int k = 0; k < Surround::directions; ++k) {
      const double angle = 2. * M_PI * k / Surround::directions;
      const double alongSide = std::max(std::fabs(std::cos(angle)), std::fabs(std::sin(angle)));
      if (alongSide > 0.995) { // toward a side of the square sheet, which ends at the quiet zone's end
        EXPECT_NEAR(surround.toward(k).grey, scene.surround, 12.) << k;
      }
      else if (alongSide < 0.75) { // toward a corner, where it goes on
        EXPECT_NEAR(surround.toward(k).grey, scene.white, 2.) << k;
        EXPECT_LT(surround.toward(k).spread, 2.) << k;
      }
    }
  }
}

TEST(Surround, BeyondTheImageNothingIsKnown)
{
  Random random = randomOfTest();
  MarkerScene scene = markerScene(random, vpCircleMarkerFamily(vpCircleMarkerFamily::RING), -1, 60., 0., side);
  scene.center.x() -= (side / 2. - 32.) * scene.center.z() / scene.focal; // its left quiet zone is at the image's edge
  const vpImage<unsigned char> I = photograph(side, side, 0.7, scene);
  const CameraModel camera(scene.camera());
  Surround surround(I, camera, scene.plane(), {PaperShape::ROUND, 1. + 1. / 6., 0.}, 0.8);
  unsigned int unknown = 0;
  for (unsigned int k = 0; k < Surround::directions; ++k) {
    unknown += std::isinf(surround.toward(k).spread);
  }
  EXPECT_GT(unknown, 3u);
  EXPECT_LT(unknown, Surround::directions / 2);
}

TEST(Surround, AroundASquareSheetIsOneGrey)
{
  Random random = randomOfTest();
  for (int i = 0; i < 10; ++i) {
    MarkerScene scene = markerScene(random, vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23), 3, 60.,
                                    uniform(random, 0., 0.6), side);
    const vpImage<unsigned char> I = photograph(side, side, 0.7, scene);
    const CameraModel camera(scene.camera());
    Surround surround(I, camera, scene.plane(), {PaperShape::SQUARE, 1. + 1. / 6., 0.}, 0.8);
    unsigned int known = 0;
    for (unsigned int k = 0; k < Surround::directions; ++k) {
      if (std::isfinite(surround.toward(k).spread)) {
        ++known;
        EXPECT_NEAR(surround.toward(k).grey, scene.surround, 15.) << k;
      }
    }
    EXPECT_GT(known, Surround::directions / 2);
  }
}

TEST(Surround, SquareSheetsAngleIsFound)
{
  Random random = randomOfTest();
  for (int i = 0; i < 40; ++i) {
    const double diameter = uniform(random, 20., 60.);
    MarkerScene scene = markerScene(random, vpCircleMarkerFamily(vpCircleMarkerFamily::RING), -1, diameter,
                                    uniform(random, 0., 1.), side);
    if (i % 2 == 1) { // on ground brighter than paper
      scene.white = 130.;
      scene.surround = 220.;
    }
    const vpImage<unsigned char> I = photograph(side, side, 0.7, scene);
    MarkerPlane plane = scene.plane();
    const double spin = uniform(random, 0., 0.5 * M_PI);
    plane.spin(-spin); // a ring does not tell it
    const double found = squareAngleOf(I, CameraModel(scene.camera()), plane, 1. + 1. / 6., 0.8);
    const double difference = std::remainder(found - spin, 0.5 * M_PI);
    EXPECT_LT(std::fabs(difference), 0.02) << "diameter " << diameter; // one degree
  }
}

// Of a sheet that is seen aslant the looks go off at a right angle to its end in the image: toward its corners, too,
// they see ground alone. Straight away from the centre they saw up to a tenth of the contrast of paper.
TEST(Surround, AroundAnObliqueSheetIsGroundAlone)
{
  Random random = randomOfTest();
  for (int i = 0; i < 20; ++i) {
    const MarkerScene scene = markerScene(random, vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23), 3,
                                          uniform(random, 18., 40.), uniform(random, 1., 1.25), side);
    const double blur = uniform(random, 0.7, 1.2);
    const vpImage<unsigned char> I = photograph(side, side, blur, scene);
    const CameraModel camera(scene.camera());
    Surround surround(I, camera, scene.plane(), {PaperShape::SQUARE, 1. + 1. / 6., 0.}, std::hypot(blur, 0.29));
    for (unsigned int k = 0; k < Surround::directions; ++k) {
      if (std::isfinite(surround.toward(k).spread)) {
        EXPECT_NEAR(surround.toward(k).grey, scene.surround, 0.01 * std::abs(scene.white - scene.surround) + 1.5) << k;
      }
    }
  }
}

// The share of a Gaussian beyond the corner of a sheet seen aslant, summed up point by point.
TEST(Surround, ShareBeyondACornerIsThatOfAllPoints)
{
  Random random = randomOfTest();
  PaperEnd paper;
  paper.shape = PaperShape::SQUARE;
  paper.extent = 1. + 1. / 6.;
  for (int i = 0; i < 60; ++i) {
    paper.angle = uniform(random, 0., 0.5 * M_PI);
    const double turned = uniform(random, 0., 2. * M_PI);
    Eigen::Matrix2d turn;
    turn << std::cos(turned), -std::sin(turned), std::sin(turned), std::cos(turned);
    PlanePoint point;
    const double across = uniform(random, 0.35, 1.); // the cosine of the tilt
    point.byPixel = turn * Eigen::Vector2d(0.1, 0.1 / across).asDiagonal() * turn.transpose();
    const double quadrant = std::round(uniform(random, -0.5, 3.5)) * 0.5 * M_PI;
    const double angle = paper.angle + 0.25 * M_PI + quadrant + uniform(random, -0.3, 0.3);
    point.q = uniform(random, 1.4, 1.9) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    constexpr double blur = 1.1, step = 0.05, most = 5.;
    double beyond = 0., all = 0.;
    for (double u = -most; u <= most; u += step) {
      for (double v = -most; v <= most; v += step) {
        const double weight = std::exp(-0.5 * (u * u + v * v));
        const Eigen::Vector2d q = paper.alongAxes(point.q + blur * point.byPixel * Eigen::Vector2d(u, v));
        all += weight;
        beyond += q.cwiseAbs().maxCoeff() > paper.extent ? weight : 0.;
      }
    }
    EXPECT_NEAR(shareBeyond(point, paper, blur).share, beyond / all, 0.005);
  }
}
