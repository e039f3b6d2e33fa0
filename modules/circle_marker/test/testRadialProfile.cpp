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
 * The grey level of rings and discs as a function of the radius.
 */

#include "testRoomTools.h"

#include "decode/radial_profile.h"

using namespace circle_marker;
using namespace room_test;

namespace {
std::optional<RadialProfile> profileOf(const MarkerScene &scene, double noise, Random &random)
{
  return radialProfile(digitise(expose(150, 150, 0.7, scene), noise, random), CameraModel(scene.camera()),
                       scene.plane());
}
constexpr double leastContrast = 0.3 * (paper - ink);
const double quietZone = vpCircleMarkerLayout().quietZone;
} // namespace

TEST(RadialProfile, RatioOfRings)
{
  Random random = randomOfTest();
  for (int i = 0; i < 60; ++i) {
    const double ratio = uniform(random, 0.4, 0.88);
    const double diameter = uniform(random, 50., 110.);
    const MarkerScene scene =
        markerScene(random, vpCircleMarkerFamily::ring(ratio), -1, diameter, uniform(random, 0., 0.9), 150);
    const auto profile = profileOf(scene, 2., random);
    ASSERT_TRUE(profile);
    const auto inner = innerRadius(*profile, quietZone, leastContrast);
    ASSERT_TRUE(inner) << "ratio " << ratio << " diameter " << diameter;
    // A pixel is 2 / diameter of the radius; a fifth of a pixel, and more where a thin rim is blurred.
    EXPECT_NEAR(*inner, ratio, 0.02 + 0.4 / diameter) << "diameter " << diameter;
  }
}

TEST(RadialProfile, GreyLevelsOfThickRings)
{
  Random random = randomOfTest();
  for (int i = 0; i < 20; ++i) {
    const MarkerScene scene =
        markerScene(random, vpCircleMarkerFamily::ring(0.6), -1, 100., uniform(random, 0., 0.7), 150);
    const auto profile = profileOf(scene, 0., random);
    ASSERT_TRUE(profile);
    for (unsigned int k = 0; k < RadialProfile::size; ++k) {
      const double radius = RadialProfile::radiusAt(k);
      // Two pixels and more from the edges; 0.1 of the radius is 5 pixels, 3.8 across a tilt of 40 degrees.
      if (radius < 0.5 || (radius > 1.1 && radius < 1.12)) {
        EXPECT_NEAR(profile->grey[k], paper, 3.) << radius;
      }
      else if (radius > 0.7 && radius < 0.9) {
        EXPECT_NEAR(profile->grey[k], ink, 3.) << radius;
      }
    }
  }
}

// The ground beyond a narrow quiet zone is no white.
TEST(RadialProfile, WhiteIsThatOfTheQuietZone)
{
  Random random = randomOfTest();
  vpCircleMarkerLayout narrow = vpCircleMarkerFamily::ring(0.7).getLayout();
  narrow.quietZone = 0.08;
  for (int i = 0; i < 20; ++i) {
    const MarkerScene scene = markerScene(random, vpCircleMarkerFamily(vpCircleMarkerFamily::RING).withLayout(narrow),
                                          -1, 110., uniform(random, 0., 0.3), 150);
    const auto round = [&](double u, double v) {
      return scene.onMarker(u, v).norm() < 1. + narrow.quietZone ? scene(u, v) : ink;
    };
    const auto profile = radialProfile(photograph(150, 150, 0.7, round), CameraModel(scene.camera()), scene.plane());
    ASSERT_TRUE(profile);
    const auto inner = innerRadius(*profile, narrow.quietZone, leastContrast);
    ASSERT_TRUE(inner);
    EXPECT_NEAR(*inner, narrow.ringInner, 0.03);
    EXPECT_FALSE(innerRadius(*profile, quietZone, leastContrast)) << "the zone is wider than it was said to be";
  }
}

TEST(RadialProfile, DiscsAreDarkToTheCentre)
{
  Random random = randomOfTest();
  for (int i = 0; i < 40; ++i) {
    const MarkerScene scene = markerScene(random, vpCircleMarkerFamily(vpCircleMarkerFamily::DISC), -1,
                                          uniform(random, 20., 110.), uniform(random, 0., 0.9), 150);
    const auto profile = profileOf(scene, 2., random);
    ASSERT_TRUE(profile);
    const auto inner = innerRadius(*profile, quietZone, leastContrast);
    ASSERT_TRUE(inner);
    EXPECT_EQ(*inner, 0.);
  }
}

TEST(RadialProfile, CoveredQuarterDoesNotDecide)
{
  Random random = randomOfTest();
  for (int i = 0; i < 30; ++i) {
    const MarkerScene scene =
        markerScene(random, vpCircleMarkerFamily::ring(0.7), -1, 100., uniform(random, 0., 0.6), 150);
    const double from = uniform(random, 0., 2. * M_PI);
    const double cover = uniform(random, 0., 255.);
    const auto covered = [&](double u, double v) {
      const double angle = std::atan2(v - 75., u - 75.) - from;
      return angle - 2. * M_PI * std::floor(angle / (2. * M_PI)) < M_PI_2 ? cover : scene(u, v);
    };
    const auto profile = radialProfile(photograph(150, 150, 0.7, covered), CameraModel(scene.camera()), scene.plane());
    ASSERT_TRUE(profile);
    const auto inner = innerRadius(*profile, quietZone, leastContrast);
    ASSERT_TRUE(inner) << "cover " << cover;
    EXPECT_NEAR(*inner, 0.7, 0.03) << "cover " << cover;
  }
}

TEST(RadialProfile, NothingWithoutADarkBand)
{
  RadialProfile flat;
  flat.grey.fill(120.);
  EXPECT_FALSE(innerRadius(flat, quietZone, 10.));
  RadialProfile bright; // a bright disc
  for (unsigned int i = 0; i < RadialProfile::size; ++i) {
    bright.grey[i] = RadialProfile::radiusAt(i) < 1. ? paper : ink;
  }
  EXPECT_FALSE(innerRadius(bright, quietZone, 10.));
}

TEST(RadialProfile, NothingOutsideOfTheImage)
{
  Random random = randomOfTest();
  MarkerScene scene = markerScene(random, vpCircleMarkerFamily::ring(0.7), -1, 100., 0.2, 150);
  const vpImage<unsigned char> I = photograph(150, 150, 0.7, scene);
  ASSERT_TRUE(radialProfile(I, CameraModel(scene.camera()), scene.plane()));
  // Its centre 10 pixels outside: more than half of every circle.
  scene.center += Eigen::Vector3d(1.7 * scene.radius, 0., 0.);
  EXPECT_FALSE(radialProfile(I, CameraModel(scene.camera()), scene.plane()));
  scene.center += Eigen::Vector3d(5., 0., 0.);
  EXPECT_FALSE(radialProfile(I, CameraModel(scene.camera()), scene.plane()));
}
