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
 * Tests of the choice between two measurements of what looks blurred.
 */

#include "refine/blurred_measurement.h"

#include <cmath>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif
using namespace circle_marker;

namespace {
Measurement measured(double correlation, double blur)
{
  Measurement measurement;
  measurement.first.correlation = correlation;
  measurement.first.photometry.blur.sigma = blur;
  return measurement;
}

Recognition readThroughABlur(double unexplained)
{
  Recognition marker;
  marker.blurred = BlurredPoses();
  marker.blurred->unexplained = unexplained;
  marker.blurred->cost = {{1., HUGE_VAL}};
  return marker;
}

// Whether it is the one that measure() made.
bool takesMeasured(const Recognition &marker, double correlation, double blur)
{
  const auto best = bestMeasurement(marker, measured(correlation, blur));
  EXPECT_TRUE(best);
  return best && best->first.photometry.blur.sigma == blur && best->first.correlation == correlation;
}
} // namespace

TEST(BlurredMeasurement, WithoutAReadingThroughABlurThereIsOneMeasurement)
{
  EXPECT_TRUE(takesMeasured(Recognition(), 0.9, 4.));
  EXPECT_FALSE(bestMeasurement(Recognition(), std::nullopt));
}

TEST(BlurredMeasurement, TheBetterExplanationIsTaken)
{
  EXPECT_TRUE(takesMeasured(readThroughABlur(0.01), 0.99, 4.));
  EXPECT_FALSE(takesMeasured(readThroughABlur(0.01), 0.94, 4.));
  EXPECT_TRUE(bestMeasurement(readThroughABlur(0.01), std::nullopt));
}

TEST(BlurredMeasurement, OfAWideDiscTheReadingIsTaken)
{
  Recognition marker = readThroughABlur(0.01);
  marker.blurred->disc = 0.1;
  EXPECT_TRUE(takesMeasured(marker, 0.99, 4.));
  marker.blurred->disc = 0.15;
  EXPECT_FALSE(takesMeasured(marker, 0.99, 4.));
}

// Noise of a twelfth of the contrast leaves three hundredths of the variance, and sharp edges.
TEST(BlurredMeasurement, NoiseIsNoBlur)
{
  EXPECT_TRUE(takesMeasured(readThroughABlur(0.002), 0.985, 0.9));
  EXPECT_FALSE(takesMeasured(readThroughABlur(0.002), 0.96, 0.9));
}

TEST(BlurredMeasurement, OfTheTwoPosesOfAReadingTheBetterComesFirst)
{
  Recognition marker = readThroughABlur(0.01);
  marker.poses[0].center = Eigen::Vector3d(0., 0., 1.);
  marker.poses[1].center = Eigen::Vector3d(0., 0., 2.);
  for (std::size_t i = 0; i < 2; ++i) {
    marker.poses[i].rotation.setIdentity();
    marker.blurred->covariance[i].setIdentity();
  }
  for (const std::size_t better : {std::size_t(0), std::size_t(1)}) {
    marker.blurred->cost[better] = 2.;
    marker.blurred->cost[1 - better] = 5.;
    const auto best = bestMeasurement(marker, std::nullopt);
    ASSERT_TRUE(best && best->second);
    EXPECT_EQ(best->cost, 2.);
    EXPECT_EQ(best->cost2, 5.);
    EXPECT_EQ(best->first.plane.center, marker.poses[better].center);
    EXPECT_EQ(best->second->plane.center, marker.poses[1 - better].center);
  }
}

// The reading knows its centre in units of the marker's radius, along the marker's own axes.
TEST(BlurredMeasurement, CovarianceIsInMetresOfTheCamera)
{
  constexpr double radius = 0.09; // m
  Recognition marker = readThroughABlur(0.01);
  marker.poses[0].radius = radius;
  marker.poses[0].rotation = Eigen::AngleAxisd(M_PI_2, Eigen::Vector3d::UnitZ()).toRotationMatrix(); // x to y, y to -x
  marker.blurred->covariance[0].setZero();
  marker.blurred->covariance[0].diagonal() << 1., 4., 9., 16., 25., 36.;
  const auto best = bestMeasurement(marker, std::nullopt);
  ASSERT_TRUE(best);
  const Eigen::Matrix<double, 6, 6> &covariance = best->first.covariance;
  EXPECT_NEAR(covariance(0, 0), 4. * radius * radius, 1e-12);
  EXPECT_NEAR(covariance(1, 1), 1. * radius * radius, 1e-12);
  EXPECT_NEAR(covariance(2, 2), 9. * radius * radius, 1e-12);
  EXPECT_NEAR(covariance(3, 3), 25., 1e-12);
  EXPECT_NEAR(covariance(4, 4), 16., 1e-12);
  EXPECT_NEAR(covariance(5, 5), 36., 1e-12);
}
