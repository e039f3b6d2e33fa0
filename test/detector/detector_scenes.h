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
 * What the tests of the detector share: simulated scenes, and the distance of a pose from the truth.
 */

#ifndef VP_TEST_DETECTOR_SCENES_H
#define VP_TEST_DETECTOR_SCENES_H

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <Eigen/Core>

#include <visp3/circle_marker/vpDetectorCircleMarker.h>
#include <visp3/circle_marker_simulator/vpMarkerSceneSimulator.h>

#include "../../modules/circle_marker/test/testRandom.h"

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace detector_test {
using random_test::Random;
using random_test::randomOfTest;
using random_test::uniform;

constexpr unsigned int width = 640;
constexpr unsigned int height = 480;
constexpr double focal = 800.; // pixels
constexpr double size = 0.18;  // m

vpCameraParameters straightCamera();

Eigen::Matrix3d rotationOf(const vpHomogeneousMatrix &cMo);

Eigen::Vector3d translationOf(const vpHomogeneousMatrix &cMo);

vpHomogeneousMatrix poseOf(const Eigen::Matrix3d &R, const Eigen::Vector3d &t);

Eigen::Matrix3d turn(double angle, const Eigen::Vector3d &axis);

/*!
  A z-aligned pose of any spin.
  \e diameter: Of the ring in the image, pixels.
  \e tilt: Angle between normal and line of sight, rad.
  \e u and \e v: Image of the centre by a camera without distortion, pixels.
*/
vpHomogeneousMatrix randomPose(Random &random, double diameter, double tilt, double u, double v);

//! The same anywhere in the image, off its rim.
vpHomogeneousMatrix randomPose(Random &random, double diameter, double tilt);

//! A marker of any family as it is printed.
vpSimulatedMarker printed(const vpCircleMarkerFamily &family, int id, double diameter = size);

int randomId(Random &random, const vpCircleMarkerFamily &family);

vpImage<unsigned char> imageOf(const vpCameraParameters &cam, const std::vector<vpSimulatedMarker> &markers,
                               Random &random);

vpImage<unsigned char> imageOf(const vpSimulatedMarker &marker, Random &random);

/*!
  Squared Mahalanobis distance of the truth from a z-aligned pose, by the definition of the covariance:
  truth = exp(delta) estimate. Both are moved to the marker's centre, t = v + w x C, where the numbers are well
  conditioned; a marker without a code is compared up to its spin, in 5 dimensions.
*/
double mahalanobis(const vpHomogeneousMatrix &truth, const vpHomogeneousMatrix &estimate, const vpMatrix &covariance,
                   unsigned int freedom);

//! How true the covariance of single markers is, each in a picture of its own.
struct Honesty
{
  //! As it is recorded.
  std::string text() const;

  double squared = 0.;       // mean Mahalanobis distance^2 by degrees of freedom
  double bias = 0.;          // mean error of the depth, standard deviations
  unsigned int found = 0;    // where they are
  unsigned int mirrored = 0; // their other pose, which is not counted in what is above
  unsigned int others = 0;   // as another marker
  double wrongOdds = 0.;     // greatest log-odds of a mirrored pose
};

//! The markers, and their pictures.
struct HonestyScenes
{
  explicit HonestyScenes(const vpCircleMarkerFamily &ofFamily) : family(ofFamily) {}

  vpCircleMarkerFamily family;
  std::pair<double, double> diameters = {40., 110.}; // on the sensor, least and greatest, pixels
  double noise = 1.5;                                // grey levels
  unsigned int images = 40;
  //! What becomes of a picture between the sensor and the detector, and the camera that it is of then.
  std::function<void(vpImage<unsigned char> &I, Random &random)> process = [](vpImage<unsigned char> &, Random &) {};
  vpCameraParameters camera = straightCamera();
};

Honesty honestyOf(const HonestyScenes &scenes, Random &random);

//! What a squared Mahalanobis distance exceeds as seldom as a normal variable 5 standard deviations: 5.7e-7.
inline double fiveSigma(unsigned int freedom)
{
  return freedom == 6 ? 40.9 : 37.4;
}

//! Largest difference of two poses: of translation relative to the depth, and of rotation, rad.
double differenceOf(const vpHomogeneousMatrix &a, const vpHomogeneousMatrix &b);

//! Two markers, 5 and 9, of any spin.
struct TwoMarkers
{
  Random random = randomOfTest();
  vpHomogeneousMatrix poses[2] = {randomPose(random, 110., 0.5, 180., 220.), randomPose(random, 80., 0.7, 460., 250.)};
  vpImage<unsigned char> I = imageOf(straightCamera(),
                                     {printed(vpCircleMarkerFamily::GOLAY23, 5).setPose(poses[0]),
                                      printed(vpCircleMarkerFamily::GOLAY23, 9).setPose(poses[1])},
                                     random);
};
} // namespace detector_test

#endif
