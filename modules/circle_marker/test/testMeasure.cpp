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
 * Both poses of a marker, refined and compared.
 */

#include "testMeasureTools.h"

#include <Eigen/Geometry>

#include "refine/measure.h"
#include "refine/report.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr unsigned int side = 150;

double angleBetween(const Eigen::Vector3d &a, const Eigen::Vector3d &b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}
} // namespace

TEST(Measure, TheTruthComesFirst)
{
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31, vpCircleMarkerFamily::RING}) {
    const vpCircleMarkerFamily family(type);
    for (int i = 0; i < 25; ++i) {
      const int id = family.isCoded() ? static_cast<int>(random() % family.getNbIds()) : -1;
      const MarkerScene scene =
          markerScene(random, family, id, uniform(random, 60., 100.), uniform(random, 0.35, 0.9), side);
      const vpImage<unsigned char> I = digitise(expose(side, side, 0.7, scene), 2., random);
      MeasureMemory memory;
      const auto result = measure(I, CameraModel(scene.camera()), recognised(scene, id, i % 2), true, memory);
      ASSERT_TRUE(result) << family.getName();
      EXPECT_LT(angleBetween(result->first.plane.rotation.col(2), scene.rotation.col(2)), 0.02) << family.getName();
      EXPECT_LT((result->first.plane.center - scene.center).norm(), 0.005 * scene.center.z());
      ASSERT_TRUE(result->second) << "tilt " << tiltOf(scene.plane());
      // The other solution leans to the other side by about as much.
      EXPECT_NEAR(angleBetween(result->second->plane.rotation.col(2), scene.rotation.col(2)),
                  2. * tiltOf(scene.plane()), 0.15);
      EXPECT_GT(result->cost2, result->cost + 3.) << family.getName();
    }
  }
}

// The few pixels of the coarse fits tell little of a small marker, and may be explained by the wrong pose far better
// than by a right one whose fit is stuck.
TEST(Measure, NoSmallMarkerIsSureOfTheWrongPose)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  constexpr unsigned int window = 40;
  constexpr int count = 1000;
  std::normal_distribution<double> normal(0., 1.);
  int sure = 0;
  int right = 0;
  for (int i = 0; i < count; ++i) {
    const int id = static_cast<int>(random() % family.getNbIds());
    const MarkerScene scene = markerScene(random, family, id, 17., uniform(random, 0.5, 1.1), window);
    const vpImage<unsigned char> I = digitise(expose(window, window, 0.7, scene), 2., random);
    Recognition marker = recognised(scene, id, i % 2);
    for (MarkerPlane &plane : marker.poses) { // as an outline of few pixels tells them
      plane.center *= 1. + 0.02 * normal(random);
      plane.rotation = turn(0.15, Eigen::Vector3d(normal(random), normal(random), 0.1)) * plane.rotation;
    }
    MeasureMemory memory;
    const auto result = measure(I, CameraModel(scene.camera()), marker, true, memory);
    if (result) {
      const bool isRight = angleBetween(result->first.plane.rotation.col(2), scene.rotation.col(2)) < 0.3;
      right += isRight ? 1 : 0;
      sure += !isRight && result->cost2 - result->cost > 15. ? 1 : 0;
    }
  }
  EXPECT_EQ(sure, 0);
  EXPECT_GT(right, count * 8 / 10);
}

// Two and a half times too much light: all paper is 255, and the outline that starts are taken from has shrunk.
TEST(Measure, TheTruthComesFirstInOverExposedPictures)
{
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::RING}) {
    const vpCircleMarkerFamily family(type);
    const int id = family.isCoded() ? 5 : -1;
    for (int i = 0; i < 25; ++i) {
      MarkerScene scene = markerScene(random, family, id, uniform(random, 40., 80.), uniform(random, 0.5, 0.95), side);
      for (double *grey : {&scene.white, &scene.black, &scene.surround}) {
        *grey *= 2.5;
      }
      const vpImage<unsigned char> I = digitise(expose(side, side, 0.7, scene), 2., random);
      Recognition marker = recognised(scene, id, i % 2);
      for (MarkerPlane &plane : marker.poses) {
        plane.center *= 1.04;
      }
      MeasureMemory memory;
      const auto result = measure(I, CameraModel(scene.camera()), marker, true, memory);
      ASSERT_TRUE(result) << family.getName();
      EXPECT_LT(angleBetween(result->first.plane.rotation.col(2), scene.rotation.col(2)), 0.03)
          << family.getName() << " " << i << " odds " << result->cost2 - result->cost;
      EXPECT_LT((result->first.plane.center - scene.center).norm(), 0.005 * scene.center.z());
    }
  }
}

TEST(Measure, ADiscCannotTellItsPosesApart)
{
  // One frame of a disc gives both poses the same likelihood, so neither may be called much the better.
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::DISC);
  int trusted = 0;
  for (int i = 0; i < 20; ++i) {
    const MarkerScene scene = markerScene(random, family, -1, 60., uniform(random, 0.35, 0.8), side);
    const vpImage<unsigned char> I = digitise(expose(side, side, 0.7, scene), 2., random);
    MeasureMemory memory;
    const auto result = measure(I, CameraModel(scene.camera()), recognised(scene, -1, i % 2), true, memory);
    ASSERT_TRUE(result);
    ASSERT_TRUE(result->second);
    EXPECT_LE(result->cost, result->cost2);
    trusted += result->cost2 - result->cost > 3.;
    const double best = std::min(angleBetween(result->first.plane.rotation.col(2), scene.rotation.col(2)),
                                 angleBetween(result->second->plane.rotation.col(2), scene.rotation.col(2)));
    EXPECT_LT(best, 0.02);
  }
  EXPECT_LE(trusted, 3);
}

TEST(Measure, FrontalPosesAreOne)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  MarkerScene scene = markerScene(random, family, 8, 80., 0., side);
  // Exactly toward the camera: both starts are the truth.
  const Eigen::Vector3d sight = scene.center.normalized();
  scene.rotation.col(2) = sight;
  scene.rotation.col(0) = (scene.rotation.col(0) - scene.rotation.col(0).dot(sight) * sight).normalized();
  scene.rotation.col(1) = sight.cross(scene.rotation.col(0));
  Recognition marker;
  marker.family = family;
  marker.code.id = 8;
  marker.poses = {scene.plane(), scene.plane()};
  MeasureMemory memory;
  const auto result = measure(photograph(side, side, 0.7, scene), CameraModel(scene.camera()), marker, true, memory);
  ASSERT_TRUE(result);
  EXPECT_FALSE(result->second);
  EXPECT_EQ(result->cost2, HUGE_VAL);
}

TEST(Measure, WithoutRefinementThePosesStay)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  for (int i = 0; i < 10; ++i) {
    const MarkerScene scene = markerScene(random, family, 8, 80., uniform(random, 0.4, 0.8), side);
    const Recognition marker = recognised(scene, 8, i % 2);
    MeasureMemory memory;
    const auto result = measure(photograph(side, side, 0.7, scene), CameraModel(scene.camera()), marker, false, memory);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->first.plane.center, scene.center);
    EXPECT_EQ(result->first.plane.rotation, scene.rotation);
  }
}

// Gamma, the spread of ink and the depth of a small marker nearly make up for each other. Along that valley damped
// steps are short, wherever they are: they are no sign of its end.
TEST(Measure, WhatIsSettledIsAtTheMinimum)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::BCH31);
  constexpr int count = 200;
  MeasureMemory memory;
  int settled = 0;
  int above = 0;
  double worst = 0.;
  for (int i = 0; i < count; ++i) {
    const int id = static_cast<int>(random() % family.getNbIds());
    const double tilt = uniform(random, 0.3, 0.9);
    const MarkerScene scene = markerScene(random, family, id, uniform(random, 17., 24.), tilt, side);
    const vpImage<unsigned char> I = digitise(expose(side, side, uniform(random, 0.8, 1.2), scene), 1., random);
    const auto result = measure(I, CameraModel(scene.camera()), recognised(scene, id, false), true, memory);
    if (result && result->first.isSettled) {
      const FittedPose &fit = result->first;
      const double left = std::sqrt(fit.decrement) / fit.noise; // standard deviations
      ++settled;
      above += left > 1.5 ? 1 : 0;
      worst = std::max(worst, left);
    }
  }
  RecordProperty("settled", settled);
  RecordProperty("above", above);
  RecordProperty("worst", std::to_string(worst));
  EXPECT_GT(settled, 0.9 * count);
  EXPECT_EQ(above, 0);
}

// A fit that is cut short may be that of the right pose, and the other one be all that is left.
TEST(Measure, NothingAfterTheDeadline)
{
  Random random = randomOfTest();
  const MarkerScene scene =
      markerScene(random, vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23), 8, 80., uniform(random, 0.4, 0.8), side);
  const vpImage<unsigned char> I = photograph(side, side, 0.7, scene);
  const CameraModel camera(scene.camera());
  MeasureMemory memory;
  const Deadline longPast(1e-6);
  for (const bool refine : {true, false}) {
    EXPECT_FALSE(measure(I, camera, recognised(scene, 8, false), refine, memory, longPast));
    EXPECT_TRUE(measure(I, camera, recognised(scene, 8, false), refine, memory, Deadline(1e6)));
  }
}

TEST(Measure, WhatIsNotTheMarkerIsRefused)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  MeasureMemory memory;
  for (int i = 0; i < 20; ++i) {
    const MarkerScene scene = markerScene(random, family, 8, 80., uniform(random, 0., 0.8), side);
    const CameraModel camera(scene.camera());
    // Noise, a flat image, a picture of another kind.
    vpImage<double> noise(side, side, 127.);
    EXPECT_FALSE(measure(digitise(noise, 40., random), camera, recognised(scene, 8, false), true, memory));
    EXPECT_FALSE(measure(vpImage<unsigned char>(side, side, 200), camera, recognised(scene, 8, false), true, memory));
    const vpImage<unsigned char> stripes =
        photograph(side, side, 0.7, [](double u, double v) { return std::sin(0.3 * u + 0.2 * v) > 0. ? ink : paper; });
    EXPECT_FALSE(measure(stripes, camera, recognised(scene, 8, false), true, memory));
  }
}

TEST(Report, CovarianceInTheCameraFrame)
{
  // By its definition: a disturbance (t, w) about the marker's centre is delta = (t - w x C, w) at the camera, so that
  // samples of the first, turned into exp(delta), must have the covariance reported.
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  const MarkerScene scene = markerScene(random, family, 8, 80., 0.5, side);
  MeasureMemory memory;
  const CameraModel camera(scene.camera());
  const Recognition marker = recognised(scene, 8, false);
  auto result = measure(digitise(expose(side, side, 0.7, scene), 2., random), camera, marker, true, memory);
  ASSERT_TRUE(result);
  vpCircleMarkerDetection detection;
  putReport(marker, *result, camera, 0.9, true, detection);
  EXPECT_EQ(detection.dof, 6u);
  EXPECT_EQ(detection.visible, 0.9);
  EXPECT_EQ(detection.id, 8);
  EXPECT_DOUBLE_EQ(detection.size, 0.2);
  Eigen::Matrix<double, 6, 6> reported;
  for (unsigned int row = 0; row < 6; ++row) {
    for (unsigned int column = 0; column < 6; ++column) {
      reported(row, column) = detection.covariance[row][column];
      EXPECT_EQ(detection.covariance[row][column], detection.covariance[column][row]);
    }
  }
  const Eigen::Vector3d C = result->first.plane.center;
  Eigen::Matrix3d cross;
  cross << 0., -C.z(), C.y(), C.z(), 0., -C.x(), -C.y(), C.x(), 0.;
  // t = v + w x C, so that (t, w) = A delta with A = [1, -[C]x; 0, 1]: A reported A^T is the covariance of (t, w).
  Eigen::Matrix<double, 6, 6> A = Eigen::Matrix<double, 6, 6>::Identity();
  A.topRightCorner<3, 3>() = -cross;
  const Eigen::Matrix<double, 6, 6> back = A * reported * A.transpose();
  for (int row = 0; row < 6; ++row) {
    for (int column = 0; column < 6; ++column) {
      const double scale = std::sqrt(result->first.covariance(row, row) * result->first.covariance(column, column));
      EXPECT_NEAR(back(row, column), result->first.covariance(row, column), 1e-4 * scale);
    }
  }
}

TEST(Report, FramesSpinAndEllipse)
{
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::RING}) {
    const vpCircleMarkerFamily family(type);
    const int id = family.isCoded() ? 8 : -1;
    const MarkerScene scene = markerScene(random, family, id, 80., 0.6, side);
    MeasureMemory memory;
    const CameraModel camera(scene.camera());
    const Recognition marker = recognised(scene, id, false);
    const auto result = measure(photograph(side, side, 0.7, scene), camera, marker, true, memory);
    ASSERT_TRUE(result);
    vpCircleMarkerDetection aligned;
    putReport(marker, *result, camera, 1., true, aligned);
    vpCircleMarkerDetection turned;
    putReport(marker, *result, camera, 1., false, turned);
    for (unsigned int row = 0; row < 3; ++row) {
      EXPECT_EQ(aligned.cMo[row][0], turned.cMo[row][0]);
      EXPECT_EQ(aligned.cMo[row][1], -turned.cMo[row][1]);
      EXPECT_EQ(aligned.cMo[row][2], -turned.cMo[row][2]);
      EXPECT_EQ(aligned.cMo[row][3], turned.cMo[row][3]);
      EXPECT_NEAR(aligned.cMo[row][2], result->first.plane.rotation(row, 2), 1e-12);
    }
    EXPECT_EQ(aligned.dof, family.isCoded() ? 6u : 5u);
    // Points of the outline lie on the ellipse.
    const double c = std::cos(aligned.ellipse.angle), s = std::sin(aligned.ellipse.angle);
    std::vector<vpImagePoint> outline;
    putOutline(marker, result->first.plane, camera, 20, outline);
    for (const vpImagePoint &point : outline) {
      const double x = point.get_u() - aligned.ellipse.center.get_u();
      const double y = point.get_v() - aligned.ellipse.center.get_v();
      EXPECT_NEAR(std::hypot((c * x + s * y) / aligned.ellipse.a, (c * y - s * x) / aligned.ellipse.b), 1., 1e-6);
    }
    EXPECT_GE(aligned.ellipse.a, aligned.ellipse.b);
    const Eigen::Vector3d C = result->first.plane.center;
    EXPECT_NEAR(aligned.center.get_u(), scene.principal.x() + scene.focal * C.x() / C.z(), 1e-9);
    EXPECT_NEAR(aligned.center.get_v(), scene.principal.y() + scene.focal * C.y() / C.z(), 1e-9);
    if (!family.isCoded()) {
      // Nothing is known of the spin: the variance of a uniform angle about the normal.
      double variance = 0.;
      for (unsigned int row = 0; row < 3; ++row) {
        for (unsigned int column = 0; column < 3; ++column) {
          variance += aligned.cMo[row][2] * aligned.covariance[row + 3][column + 3] * aligned.cMo[column][2];
        }
      }
      EXPECT_NEAR(variance, M_PI * M_PI / 3., 1e-6);
    }
  }
}

// What covers a marker, or bends it, draws its outline aside: one start is near the mirrored pose, the other one leads
// nowhere.
TEST(Measure, MarkersAreSoughtAtTheMirroredPoseToo)
{
  Random random = randomOfTest();
  for (int i = 0; i < 10; ++i) {
    const MarkerScene scene = markerScene(random, vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23), i, 60.,
                                          uniform(random, 0.6, 0.8), side);
    const vpImage<unsigned char> I = digitise(expose(side, side, 0.7, scene), 2., random);
    Recognition marker = recognised(scene, i, true);
    marker.poses[1] = marker.poses[0]; // as if the right one had ended there, too
    const CameraModel camera(scene.camera());
    const auto normalOf = [&]() {
      MeasureMemory memory;
      const auto result = measure(I, camera, marker, true, memory);
      return result ? Eigen::Vector3d(result->first.plane.rotation.col(2)) : Eigen::Vector3d(-Eigen::Vector3d::UnitZ());
    };
    EXPECT_LT(angleBetween(normalOf(), scene.rotation.col(2)), 0.05) << i << ": the parts disagree about the other one";
    SeenParts seen;
    seen.plane = scene.plane();
    seen.directions = 92;
    seen.ring.set();
    seen.track.set();
    seen.center.set();
    marker.seen = seen;
    EXPECT_LT(angleBetween(normalOf(), scene.rotation.col(2)), 0.05) << i;
  }
}
