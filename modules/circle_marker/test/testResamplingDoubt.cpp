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
 * What the resampling of a picture adds to the covariance of a pose.
 */

#include "testFitTools.h"

#include "refine/resampling_doubt.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr double unit = 1. / 80000.;     // of a pixel, normalised coordinates: so far away tilt moves no centre
constexpr double thirdMoment = 0.069007; // 1 / sqrt(210), pixels^3

//! A marker of a radius in pixels, straight ahead, leaning by an angle.
FittedPose fitOf(double radius, double lean, double blur)
{
  FittedPose fit;
  fit.plane.center = Eigen::Vector3d(0., 0., 2.);
  fit.plane.rotation = turn(lean, Eigen::Vector3d(0., 1., 0.));
  fit.plane.radius = radius * unit * fit.plane.center.z();
  fit.photometry.blur.sigma = blur;
  return fit;
}

//! The third moment of an edge's blur moves it, as its best fit has it, by a twelfth of it over the blur's variance:
//! the same sum as in the code, which the poses of undistorted pictures test (testDetectorProcessed).
double shiftOf(double blur)
{
  return thirdMoment / (12. * blur * blur);
}
} // namespace

// A ring that nearly faces the camera, by hand: of its points only the way across is seen, and x is the mean of n_x (n
// . d) over that of n_x^2. With the shifts d of eight parts independent and of variance 1 both ways its variance is the
// sum over the octants of (integral of cos^2)^2 + (integral of cos sin)^2 over that of cos^2 all around, squared: 4
// ((pi/8 + 1/4)^2 + (pi/8 - 1/4)^2 + 2/16) / pi^2 = 1/8 + 1/pi^2.
TEST(ResamplingDoubt, OfAFrontalRingsPlaceByHand)
{
  const MarkerPattern pattern = patternOf(vpCircleMarkerFamily(vpCircleMarkerFamily::RING), -1);
  for (const double blur : {0.6, 0.8, 1.2}) {
    FittedPose fit = fitOf(60., 0.3, blur);
    addResamplingDoubt(pattern, unit, fit);
    const double expected = std::sqrt(1. / 8. + 1. / (M_PI * M_PI)) * shiftOf(blur) * unit * fit.plane.center.z();
    EXPECT_NEAR(std::sqrt(fit.covariance(0, 0)), expected, 0.06 * expected) << blur;
    EXPECT_NEAR(std::sqrt(fit.covariance(1, 1)), expected, 0.06 * expected) << blur;
  }
}

// A small marker moves with the phase of the pixels that it lies on: by nearly as much as an edge does, where a large
// one has the mean of many phases.
TEST(ResamplingDoubt, SmallMarkersMoveAsOne)
{
  const MarkerPattern pattern = patternOf(vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23), 8);
  const auto doubtOf = [&](double radius) { // pixels
    FittedPose fit = fitOf(radius, 0.6, 0.8);
    addResamplingDoubt(pattern, unit, fit);
    return std::sqrt(fit.covariance(0, 0)) / (unit * fit.plane.center.z());
  };
  EXPECT_GT(doubtOf(8.), 0.55 * shiftOf(0.8));
  EXPECT_LT(doubtOf(8.), shiftOf(0.8));
  EXPECT_LT(doubtOf(80.), 0.55 * shiftOf(0.8));
}

// The covariance of what is known already stays in it, and a tilt that is known better has lost more.
TEST(ResamplingDoubt, AddsToWhatIsThere)
{
  const MarkerPattern pattern = patternOf(vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23), 8);
  FittedPose alone = fitOf(50., 0.6, 0.8);
  addResamplingDoubt(pattern, unit, alone);
  double before = HUGE_VAL;
  for (const double known : {1e-6, 1e-4, 1e-2}) { // rad or metres
    FittedPose fit = fitOf(50., 0.6, 0.8);
    fit.covariance = known * known * Eigen::Matrix<double, 6, 6>::Identity();
    const Eigen::Matrix<double, 6, 6> sum = fit.covariance + alone.covariance;
    addResamplingDoubt(pattern, unit, fit);
    EXPECT_LT((fit.covariance - sum).norm(), 1e-12 * sum.norm());
    EXPECT_GT(fit.resampled, 1.);
    EXPECT_LT(fit.resampled, before);
    before = fit.resampled;
  }
  EXPECT_LT(before, 1.01);
}

// A spin that nothing tells is neither known nor in doubt.
TEST(ResamplingDoubt, TheSpinOfARingStays)
{
  const MarkerPattern pattern = patternOf(vpCircleMarkerFamily(vpCircleMarkerFamily::RING), -1);
  FittedPose fit = fitOf(40., 0.7, 0.8);
  addResamplingDoubt(pattern, unit, fit);
  const Eigen::Vector3d normal = fit.plane.rotation.col(2);
  EXPECT_TRUE(fit.covariance.allFinite());
  EXPECT_LT(normal.dot(fit.covariance.bottomRightCorner<3, 3>() * normal), 1e-12);
}
