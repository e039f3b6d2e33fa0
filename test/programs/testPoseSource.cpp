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
 * Tests of what a servo takes for the pose of its object.
 */

#include <gtest/gtest.h>

#include <visp3/circle_marker_simulator/vpMarkerSceneSimulator.h>

#include "circle_marker/common/servo/pose_source.h"

using namespace tutorial;

namespace {
constexpr double size = 0.12; // metres
const vpCameraParameters cam(800., 800., 319.5, 239.5);

ServoObject objectWith(int id)
{
  ServoObject object;
  object.circle = MountedMarker{id, size, size * 7. / 6., vpHomogeneousMatrix()};
  return object;
}

DetectorSettings settingsOf(vpCircleMarkerFamily::vpType family)
{
  DetectorSettings settings;
  settings.size = size;
  settings.families = {vpCircleMarkerFamily(family)};
  return settings;
}

vpHomogeneousMatrix poseAt(double x, double z, double turnAboutY = 0.)
{
  return vpHomogeneousMatrix(x, 0., z, 0., turnAboutY, 0.);
}

vpImage<unsigned char> pictureOf(const std::vector<vpSimulatedMarker> &markers, std::uint64_t seed)
{
  vpMarkerSceneSimulator scene(cam, 640, 480);
  for (const vpSimulatedMarker &marker : markers) {
    scene.addMarker(marker);
  }
  vpImage<unsigned char> I;
  scene.render(I, seed);
  return I;
}

//! Marker 3 at the left and marker 9 at the right, at two distances.
vpImage<unsigned char> twoMarkers(double left, double right)
{
  return pictureOf({vpSimulatedMarker::circle("golay23", 3, size).setPose(poseAt(-0.1, left)),
                    vpSimulatedMarker::circle("golay23", 9, size).setPose(poseAt(0.1, right))},
                   1);
}
} // namespace

TEST(PoseSource, KeepsToTheMarkerThatItHasBegunWith)
{
  PoseSource source(objectWith(anyId), cam, settingsOf(vpCircleMarkerFamily::GOLAY23));
  const auto first = source.look(twoMarkers(0.6, 0.8)).best();
  ASSERT_TRUE(first);
  EXPECT_NEAR((*first)[0][3], -0.1, 0.001);
  const auto second = source.look(twoMarkers(0.6, 0.5)).best(); // the other one is larger now
  ASSERT_TRUE(second);
  EXPECT_NEAR((*second)[0][3], -0.1, 0.001);
  const auto hidden =
      source.look(pictureOf({vpSimulatedMarker::circle("golay23", 9, size).setPose(poseAt(0.1, 0.5))}, 2));
  EXPECT_FALSE(hidden.best());
}

TEST(PoseSource, BeginsWithTheLargest)
{
  for (const double right : {0.4, 1.2}) {
    PoseSource source(objectWith(anyId), cam, settingsOf(vpCircleMarkerFamily::GOLAY23));
    const auto first = source.look(twoMarkers(0.7, right)).best();
    ASSERT_TRUE(first);
    EXPECT_NEAR((*first)[0][3], right < 0.7 ? 0.1 : -0.1, 0.001) << right;
  }
}

TEST(PoseSource, TakesTheMarkerThatIsAskedFor)
{
  PoseSource source(objectWith(9), cam, settingsOf(vpCircleMarkerFamily::GOLAY23));
  const auto seen = source.look(twoMarkers(0.6, 0.8)).best();
  ASSERT_TRUE(seen);
  EXPECT_NEAR((*seen)[0][3], 0.1, 0.001);
}

// A ring of 12 pixels, whose two poses one image hardly tells apart, after one that is near and clear.
TEST(PoseSource, OfTwoPosesThatLookAlikeItTakesThatWhichWasClearBefore)
{
  constexpr double tilt = 0.3; // radians
  const double ratio = vpCircleMarkerFamily(vpCircleMarkerFamily::RING).getLayout().ringInner;
  const auto ringAt = [&](double z, std::uint64_t seed) {
    return pictureOf({vpSimulatedMarker::ring(size, ratio).setPose(poseAt(0., z, tilt))}, seed);
  };
  const DetectorSettings settings = settingsOf(vpCircleMarkerFamily::RING);
  const auto leansAsItShould = [](const vpHomogeneousMatrix &cMo) { return cMo[0][2] > 0.; };
  int seen = 0;
  int mirrored = 0; // by one image alone
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    PoseSource source(objectWith(anyId), cam, settings);
    const auto near = source.look(ringAt(0.4, seed)).best();
    ASSERT_TRUE(near && leansAsItShould(*near));
    const vpImage<unsigned char> far = ringAt(8., seed);
    const auto after = source.look(far).best();
    const auto alone = PoseSource(objectWith(anyId), cam, settings).look(far).best();
    if (after && alone) {
      ++seen;
      mirrored += leansAsItShould(*alone) ? 0 : 1;
      EXPECT_TRUE(leansAsItShould(*after)) << "image " << seed;
    }
  }
  EXPECT_GE(seen, 36);
  EXPECT_GE(mirrored, 3);
}

// A first image that was wrong is outvoted by those after it, though none of them is certain.
TEST(PoseSource, AWrongBeginningDoesNotLast)
{
  constexpr double tilt = 0.3; // radians
  const double ratio = vpCircleMarkerFamily(vpCircleMarkerFamily::RING).getLayout().ringInner;
  const DetectorSettings settings = settingsOf(vpCircleMarkerFamily::RING);
  const auto look = [&](PoseSource &source, std::uint64_t seed) {
    return source.look(pictureOf({vpSimulatedMarker::ring(size, ratio).setPose(poseAt(0., 8., tilt))}, seed)).best();
  };
  int begun = 0; // wrongly
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    PoseSource source(objectWith(anyId), cam, settings);
    const auto first = look(source, seed);
    if (!first || (*first)[0][2] > 0.) {
      continue;
    }
    ++begun;
    std::optional<vpHomogeneousMatrix> last;
    for (std::uint64_t more = 1; more <= 20; ++more) {
      last = look(source, 100 * seed + more);
    }
    EXPECT_TRUE(last && (*last)[0][2] > 0.) << "image " << seed;
  }
  EXPECT_GE(begun, 3);
}

TEST(PoseSource, MayBePointedAtAnother)
{
  PoseSource source(objectWith(anyId), cam, settingsOf(vpCircleMarkerFamily::GOLAY23));
  ASSERT_TRUE(source.look(twoMarkers(0.6, 0.8)).best());
  source.forget();
  const auto other = source.look(twoMarkers(0.8, 0.5)).best();
  ASSERT_TRUE(other);
  EXPECT_NEAR((*other)[0][3], 0.1, 0.001);
}

#if defined(VISP_HAVE_APRILTAG)
TEST(PoseSource, TakesTheTagWhereTheCircleIsNotSeen)
{
  ServoObject object = objectWith(5);
  object.aprilTag = MountedMarker{2, size, size * 1.5, vpHomogeneousMatrix(0.2, 0., 0., 0., 0., 0.)};
  PoseSource source(object, cam, settingsOf(vpCircleMarkerFamily::GOLAY23));
  const vpHomogeneousMatrix cMo = poseAt(-0.1, 0.7);
  const ObjectSighting sighting =
      source.look(pictureOf({vpSimulatedMarker::aprilTag36h11(2, size).setPose(cMo * object.aprilTag->oMm)}, 1));
  EXPECT_FALSE(sighting.byCircle);
  ASSERT_TRUE(sighting.byAprilTag);
  EXPECT_NEAR((*sighting.byAprilTag)[0][3], -0.1, 0.005);
  EXPECT_STREQ(sighting.usedDetector(), "apriltag");
}
#endif
