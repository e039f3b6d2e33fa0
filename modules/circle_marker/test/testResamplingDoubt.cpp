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

#include <Eigen/LU>

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

//! What an edge that is alone does, as its best fit has it: a twelfth of the third moment over the blur's variance.
double shiftOf(double blur)
{
  return thirdMoment / (12. * blur * blur);
}

//! A line between two places whose sides have a blur.
double lineAt(double x, double from, double to, double blur)
{
  const auto edge = [&](double at) { return 0.5 * std::erfc((at - x) / (std::sqrt(2.) * blur)); };
  return edge(from) - edge(to);
}

//! Where the sides of a line with a blur fit best what is seen as a function of x, beginning with those at -w / 2, w
//! / 2.
template <typename Seen> Eigen::Vector2d fittedSides(double width, double blur, Seen seen)
{
  Eigen::Vector2d sides(-0.5 * width, 0.5 * width);
  for (int step = 0; step < 10; ++step) {
    Eigen::Matrix2d matrix = Eigen::Matrix2d::Zero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    for (double x = -0.5 * width - 8.; x < 0.5 * width + 8.; x += 0.05) {
      constexpr double h = 1e-4;
      const Eigen::Vector2d slope(
          (lineAt(x, sides[0] + h, sides[1], blur) - lineAt(x, sides[0] - h, sides[1], blur)) / (2. * h),
          (lineAt(x, sides[0], sides[1] + h, blur) - lineAt(x, sides[0], sides[1] - h, blur)) / (2. * h));
      matrix += slope * slope.transpose();
      right += slope * (seen(x) - lineAt(x, sides[0], sides[1], blur));
    }
    sides += matrix.inverse() * right;
  }
  return sides;
}
} // namespace

// Of wide, narrow and unresolved lines, by fits of lines that are interpolated between two pixels. The model's blur has
// the right variance, so that only the third moment p (1 - p) (1 - 2p) is left, against the way that it points: at this
// phase there is next to no fifth one, which moves edges by 15 % more in the middle between pixel and half a pixel.
TEST(ResamplingDoubt, ThirdMomentMovesALineAsItsFitDoes)
{
  constexpr double phase = 0.1;
  constexpr double moment = phase * (1. - phase) * (1. - 2. * phase);
  for (const double width : {0.8, 1.5, 2.5, 10.}) {
    const double blur = 0.8;
    const double wider = std::sqrt(blur * blur + phase * (1. - phase));
    const Eigen::Vector2d sides = fittedSides(width, wider, [&](double x) {
      return (1. - phase) * lineAt(x + phase, -0.5 * width, 0.5 * width, blur) +
             phase * lineAt(x + phase - 1., -0.5 * width, 0.5 * width, blur);
    });
    const double expected = -moment * motionByThirdMoment(width, wider * wider);
    EXPECT_NEAR(sides.mean(), expected, 0.05 * std::abs(expected)) << width;
  }
  EXPECT_NEAR(motionByThirdMoment(20., 0.64) * thirdMoment, shiftOf(0.8), 1e-5);
  EXPECT_GT(motionByThirdMoment(1.2, 0.64), 2. * motionByThirdMoment(20., 0.64));
}

// A ring that nearly faces the camera, by hand: of its points only the way across is seen, and x is the mean of n_x
// (n_x^3 d_u + n_y^3 d_v) over that of n_x^2. With the shifts d of six parts independent and of variance 1 the variance
// of x is the sum over the parts of (integral of cos^4)^2 + (integral of cos sin^3)^2 over that of cos^2 all around,
// squared.
TEST(ResamplingDoubt, OfAFrontalRingsPlaceByHand)
{
  const MarkerPattern pattern = patternOf(vpCircleMarkerFamily(vpCircleMarkerFamily::RING), -1);
  double variance = 0.;
  for (int part = 0; part < 6; ++part) {
    const double middle = (part + 0.4) * M_PI / 3. - M_PI; // parts begin by a tenth before the angle of -180 degrees
    const double half = M_PI / 6.;
    const double second = std::sin(2. * half); // integral of cos(2 a) over the part, over cos(2 middle)
    const double fourth = 0.5 * std::sin(4. * half);
    const double alongU =
        3. / 8. * 2. * half + 0.5 * second * std::cos(2. * middle) + fourth * std::cos(4. * middle) / 8.;
    const double alongV = 0.25 * second * std::sin(2. * middle) - fourth * std::sin(4. * middle) / 8.;
    variance += (alongU * alongU + alongV * alongV) / (M_PI * M_PI);
  }
  for (const double blur : {0.6, 0.8, 1.2}) {
    FittedPose fit = fitOf(60., 0.3, blur);
    addResamplingDoubt(pattern, unit, fit);
    const double expected = std::sqrt(variance) * shiftOf(blur) * unit * fit.plane.center.z();
    EXPECT_NEAR(std::sqrt(fit.covariance(0, 0)), expected, 0.05 * expected) << blur;
  }
}

// A small marker moves with the phase of the pixels that it lies on: by nearly as much as its ring's sides do, where a
// large one has the mean of many phases.
TEST(ResamplingDoubt, SmallMarkersMoveAsOne)
{
  const MarkerPattern pattern = patternOf(vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23), 8);
  const double thickness = 1. - pattern.ring[1].radius; // outer radii
  const auto doubtOf = [&](double radius) {             // pixels
    FittedPose fit = fitOf(radius, 0.6, 0.8);
    addResamplingDoubt(pattern, unit, fit);
    return std::sqrt(fit.covariance(0, 0)) / (unit * fit.plane.center.z());
  };
  EXPECT_GT(doubtOf(8.), 0.55 * shiftOf(0.8));
  EXPECT_LT(doubtOf(8.), motionByThirdMoment(8. * thickness, 0.64) * thirdMoment);
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
