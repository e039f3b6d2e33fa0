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
 * Markers in bad pictures: found and rightly read, and nothing else.
 */

#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "detector_scenes.h"

using namespace detector_test;

namespace {
/*! What spoils a picture of a marker that has this diameter, pixels, about a place in the image. */
using Spoiling =
    std::function<void(Random &, double diameter, const vpImagePoint &place, vpScenePhotometry &, vpSceneMotion &)>;

/*!
  Markers of 44 pixels and more, tilts to 50 degrees, on clutter.
  A marker that is found and rightly read 97 times in 100 is lost more than twice of 16 in 1.1 % of all runs, three
  times in 0.1 %: less than 13 of 16 are a defect. The seeds are the test's. All of their edge is visible.
*/
void expectFound(const vpCircleMarkerFamily &family, const Spoiling &spoil, double least = 44., double greatest = 120.)
{
  constexpr unsigned int frames = 16;
  constexpr unsigned int leastFound = 13;
  constexpr double visibleSlack = 0.1; // nothing covers them
  constexpr unsigned int mostMisjudged = 2;
  Random random = randomOfTest();
  vpDetectorCircleMarker detector(family);
  unsigned int found = 0;
  unsigned int misjudged = 0;
  for (unsigned int frame = 0; frame < frames; ++frame) {
    const double diameter = least * std::pow(greatest / least, uniform(random, 0., 1.));
    const vpHomogeneousMatrix cMo = randomPose(random, diameter, uniform(random, 0., 0.87));
    const int id = randomId(random, family);
    vpMarkerSceneSimulator simulator(straightCamera(), width, height);
    simulator.setBackground(vpSceneBackground::clutter(random(), 20));
    vpScenePhotometry photometry;
    vpSceneMotion motion;
    spoil(random, diameter, simulator.project(cMo[0][3], cMo[1][3], cMo[2][3]), photometry, motion);
    simulator.setPhotometry(photometry);
    simulator.setMotion(motion);
    vpSimulatedMarker marker = printed(family, id);
    simulator.addMarker(marker.setPose(cMo));
    vpImage<unsigned char> I;
    const auto truth = simulator.render(I, random());
    detector.detect(I);
    for (const vpCircleMarkerDetection &detection : detector.getDetections()) {
      const bool isHere = vpImagePoint::distance(detection.center, truth[0].center) < 0.1 * diameter;
      found += isHere && detection.id == id ? 1 : 0;
      misjudged += isHere && truth[0].visibleEdge - detection.visible > visibleSlack ? 1 : 0;
      if (family.isCoded()) { // clutter has plain rings
        EXPECT_TRUE(isHere && detection.id == id) << "frame " << frame << ": id " << detection.id << " for " << id;
      }
    }
  }
  EXPECT_GE(found, leastFound) << "of " << frames;
  EXPECT_LE(misjudged, mostMisjudged) << "of " << found;
}

// Without clutter. Of 16 frames the mean of the squared Mahalanobis distances, by degrees of freedom, is 1 +- 0.14 if
// the covariance is right. leastOdds: logarithm; where a pose is less likely to be the right one, it is not asked.
void expectCovariance(const vpCircleMarkerFamily &family, const Spoiling &spoil, double leastOdds = 0.)
{
  constexpr int frames = 16;
  constexpr double most = 2.;
  Random random = randomOfTest();
  vpDetectorCircleMarker detector(family);
  detector.setZAlignedWithCameraAxis(true);
  double sum = 0.;
  int found = 0;
  int judged = 0;
  for (int frame = 0; frame < frames; ++frame) {
    const double diameter = 44. * std::pow(120. / 44., uniform(random, 0., 1.));
    const vpHomogeneousMatrix cMo = randomPose(random, diameter, uniform(random, 0.2, 0.87));
    vpMarkerSceneSimulator simulator(straightCamera(), width, height);
    vpScenePhotometry photometry;
    vpSceneMotion motion;
    spoil(random, diameter, simulator.project(cMo[0][3], cMo[1][3], cMo[2][3]), photometry, motion);
    simulator.setPhotometry(photometry);
    simulator.setMotion(motion);
    vpSimulatedMarker marker = printed(family, family.isCoded() ? randomId(random, family) : -1);
    simulator.addMarker(marker.setPose(cMo));
    vpImage<unsigned char> I;
    simulator.render(I, random());
    std::vector<vpHomogeneousMatrix> poses;
    detector.detect(I, size, straightCamera(), poses);
    if (poses.size() != 1) {
      continue;
    }
    ++found;
    const vpCircleMarkerDetection &detection = detector.getDetections()[0];
    if (detection.logOdds >= leastOdds) {
      double squared = mahalanobis(cMo, detection.cMo, detection.covariance, detection.dof);
      if (family.getType() == vpCircleMarkerFamily::DISC && detection.cost2 < HUGE_VAL) { // any of both may be first
        squared = std::min(squared, mahalanobis(cMo, detection.cMo2, detection.covariance2, detection.dof));
      }
      sum += squared / detection.dof;
      ++judged;
    }
  }
  ASSERT_GE(found, frames - 2);
  ASSERT_GE(judged, frames / 2);
  EXPECT_LE(sum / judged, most);
}

const vpCircleMarkerFamily golay23(vpCircleMarkerFamily::GOLAY23);
const vpCircleMarkerFamily bch31r(vpCircleMarkerFamily::BCH31R);
const vpCircleMarkerFamily ring(vpCircleMarkerFamily::RING);
const vpCircleMarkerFamily disc(vpCircleMarkerFamily::DISC);

// The edge of a shadow across the marker, in which a quarter of the light is left.
void castShadow(Random &random, double diameter, const vpImagePoint &place, vpScenePhotometry &photometry,
                vpSceneMotion &)
{
  const double offset = uniform(random, -0.4, 0.4) * diameter;
  vpSceneShadow shadow;
  shadow.direction = uniform(random, 0., 2. * M_PI);
  shadow.edge = vpImagePoint(place.get_v() + offset * std::sin(shadow.direction),
                             place.get_u() + offset * std::cos(shadow.direction));
  shadow.factor = 0.25;
  shadow.penumbra = uniform(random, 0.5, 3.);
  photometry.shadow = shadow;
}

// And light that falls off by 80 % of its mean over the marker, seen by a camera that darkens what is dark.
void castShadowOnAGradient(Random &random, double diameter, const vpImagePoint &place, vpScenePhotometry &photometry,
                           vpSceneMotion &motion)
{
  castShadow(random, diameter, place, photometry, motion);
  photometry.shadow->factor = 0.5;
  const double direction = uniform(random, 0., 2. * M_PI);
  photometry.gradientU = 0.8 * width / diameter * std::cos(direction);
  photometry.gradientV = 0.8 * height / diameter * std::sin(direction);
  photometry.lightCenter = place;
  photometry.paper = 180.; // so that the brighter side is not cut off
  photometry.gamma = 2.2;
}

// A lamp's soft reflection on glossy paper, which adds 70 % of the contrast to paper and ink.
void reflectLamp(Random &random, double diameter, const vpImagePoint &place, vpScenePhotometry &photometry,
                 vpSceneMotion &)
{
  photometry.paper = 150.; // so that the brighter side is not cut off
  const auto aside = [&] { return uniform(random, -0.4, 0.4) * diameter; };
  vpSceneReflection reflection;
  reflection.center = vpImagePoint(place.get_v() + aside(), place.get_u() + aside());
  reflection.radius = uniform(random, 0.2, 0.3) * diameter;
  reflection.grey = 0.7 * (photometry.paper - photometry.ink);
  photometry.reflection = reflection;
}

// The marker's image goes a quarter of its diameter during the exposure.
void moveCamera(Random &random, double, const vpImagePoint &, vpScenePhotometry &, vpSceneMotion &motion)
{
  const double direction = uniform(random, 0., 2. * M_PI);
  motion.twist[0] = 0.25 * size * std::cos(direction);
  motion.twist[1] = 0.25 * size * std::sin(direction);
}

// The disc that a point makes is 15 % of the diameter wide.
void defocus(Random &, double diameter, const vpImagePoint &, vpScenePhotometry &photometry, vpSceneMotion &)
{
  photometry.defocusRadius = 0.5 * 0.15 * diameter;
}
} // namespace

TEST(DetectorBadPictures, ShadowOnTheCode)
{
  expectFound(golay23, castShadow);
}

TEST(DetectorBadPictures, ShadowOnTheRing)
{
  expectFound(ring, castShadow);
}

TEST(DetectorBadPictures, ShadowOnAGradient)
{
  expectFound(golay23, castShadowOnAGradient);
}

TEST(DetectorBadPictures, ReflectionOnTheCode)
{
  expectFound(golay23, reflectLamp);
}

TEST(DetectorBadPictures, ReflectionOnMoreSectors)
{
  expectFound(bch31r, reflectLamp);
}

TEST(DetectorBadPictures, ReflectionOnSmallCodes)
{
  expectFound(golay23, reflectLamp, 18., 23.);
}

TEST(DetectorBadPictures, ReflectionOnTheRing)
{
  expectFound(ring, reflectLamp);
}

TEST(DetectorBadPictures, CovarianceUnderAReflection)
{
  expectCovariance(golay23, reflectLamp);
}

TEST(DetectorBadPictures, CovarianceUncodedUnderAReflection)
{
  expectCovariance(ring, reflectLamp);
  expectCovariance(disc, reflectLamp);
}

TEST(DetectorBadPictures, LittleContrast)
{
  expectFound(golay23, [](Random &, double, const vpImagePoint &, vpScenePhotometry &photometry, vpSceneMotion &) {
    photometry.paper = 132.5;
    photometry.ink = 107.5;
  });
}

TEST(DetectorBadPictures, Noise)
{
  expectFound(golay23, [](Random &, double, const vpImagePoint &, vpScenePhotometry &photometry, vpSceneMotion &) {
    photometry.noiseSigma = 20.;
  });
}

// What is no noise in usual images is noise in this one, whose noise the detector knows.
TEST(DetectorBadPictures, MuchNoise)
{
  expectFound(golay23, [](Random &, double, const vpImagePoint &, vpScenePhotometry &photometry, vpSceneMotion &) {
    photometry.noiseSigma = 40.;
  });
}

TEST(DetectorBadPictures, OverExposure)
{
  expectFound(golay23, [](Random &, double, const vpImagePoint &, vpScenePhotometry &photometry, vpSceneMotion &) {
    photometry.paper *= 2.5;
    photometry.ink *= 2.5;
  });
}

TEST(DetectorBadPictures, Jpeg)
{
  expectFound(golay23, [](Random &, double, const vpImagePoint &, vpScenePhotometry &photometry, vpSceneMotion &) {
    photometry.jpegQuality = 50;
  });
}

TEST(DetectorBadPictures, LongMotion)
{
  expectFound(golay23, moveCamera);
}

TEST(DetectorBadPictures, LongMotionOfRings)
{
  expectFound(ring, moveCamera);
}

// Their edges are 25 to 40 pixels wide.
TEST(DetectorBadPictures, LongMotionOfLargeMarkers)
{
  expectFound(golay23, moveCamera, 100., 160.);
}

TEST(DetectorBadPictures, StrongDefocus)
{
  expectFound(golay23, defocus);
}

TEST(DetectorBadPictures, StrongDefocusOfMoreSectors)
{
  expectFound(bch31r, defocus);
}

// A disc of 8 % of the diameter, which no Gaussian is; the covariance bears a guess of the shape's error.
void defocusALittle(Random &, double diameter, const vpImagePoint &, vpScenePhotometry &photometry, vpSceneMotion &)
{
  photometry.defocusRadius = 0.04 * diameter;
}

TEST(DetectorBadPictures, CovarianceOfDefocusedRings)
{
  expectCovariance(ring, defocusALittle);
}

TEST(DetectorBadPictures, CovarianceOfDefocusedCodes)
{
  expectCovariance(golay23, defocusALittle);
  expectCovariance(bch31r, defocusALittle);
}

TEST(DetectorBadPictures, CovarianceInStrongDefocus)
{
  expectCovariance(golay23, defocus);
}

TEST(DetectorBadPictures, CovarianceInLongMotion)
{
  expectCovariance(golay23, moveCamera);
}

// So little is left of a small ring that either of its two poses may be right: it is said so by its log-odds.
TEST(DetectorBadPictures, CovarianceOfRingsInLongMotion)
{
  constexpr double leastOdds = 2.; // one in eight is the other one
  expectCovariance(ring, moveCamera, leastOdds);
}
