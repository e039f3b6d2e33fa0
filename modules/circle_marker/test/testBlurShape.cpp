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
 * Tests what the shape of a wide blur adds to a covariance.
 */

#include "testRoomTools.h"

#include <optional>

#include "refine/blur_shape.h"

using namespace circle_marker;
using namespace room_test;

namespace {
//! By how much the covariance of a fit grows in an image of a noise of 2 grey levels.
double growth(double sigma, double noiseOfFit, double elongation = 0., bool isCoded = false,
              const std::optional<double> &leftAlike = std::nullopt)
{
  FittedPose fit;
  fit.photometry.blur.sigma = sigma;
  fit.photometry.blur.elongation = Eigen::Vector2d(elongation, 0.);
  fit.noise = noiseOfFit;
  fit.covariance.setIdentity();
  widenByShapeOfBlur(2., isCoded, leftAlike, fit);
  EXPECT_TRUE(fit.covariance.isApprox(fit.covariance(0, 0) * Eigen::Matrix<double, 6, 6>::Identity()));
  return fit.covariance(0, 0);
}
} // namespace

TEST(BlurShape, WidensWhatIsOutOfFocusAndLeavesMoreThanNoise)
{
  EXPECT_EQ(growth(0.8, 4.), 1.);  // sharp
  EXPECT_EQ(growth(2., 2.05), 1.); // nothing left but noise
  // Three quarters of the squares are more than noise (and 3 % of it), alike over 20 blur variances.
  EXPECT_NEAR(growth(2., 4.), 1. + (1. - 0.25 * 1.03 * 1.03) * 20. * 4., 1e-9);
  EXPECT_GT(growth(3., 4.), growth(2., 4.));
  EXPECT_GT(growth(2., 6.), growth(2., 4.));
  EXPECT_EQ(growth(2., 4., 0.6, true), 1.); // moved, not out of focus
  EXPECT_NEAR(growth(2., 4., 0., true), 1. + (1. - 0.25 * 1.03 * 1.03) * 5. * 4., 1e-9);
}

// Their outer edges see both ends of the way alike; a code's edges see each of them from all sides.
TEST(BlurShape, WidensWhatHasMovedIfItIsARing)
{
  const double elongation = 0.6;
  FittedPose fit;
  fit.photometry.blur.sigma = 2.;
  fit.photometry.blur.elongation = Eigen::Vector2d(elongation, 0.);
  const double widest = fit.photometry.blur.widest();
  const double narrowest = 4. / widest;
  ASSERT_LT(narrowest, 1.2);
  EXPECT_NEAR(growth(2., 4., elongation), 1. + (1. - 0.25 * 1.03 * 1.03) * 1.5 * narrowest * (widest - narrowest),
              1e-9);
  EXPECT_EQ(growth(2., 2.05, elongation), 1.); // nothing left but noise
}

// What all directions leave alike beside the edge, a share of the contrast, is all that a shape
// leaves.
TEST(BlurShape, WidensByNoMoreThanAllDirectionsLeaveAlike)
{
  EXPECT_EQ(growth(2., 4., 0., false, 0.), 1.); // every other pixel leaves the opposite: an enlarged picture
  const double contrast = Photometry().tellableContrast();
  EXPECT_NEAR(growth(2., 4., 0., false, 1. / contrast), 1. + 1. / 16. * 20. * 4., 1e-9);
  EXPECT_EQ(growth(2., 4., 0., false, 1.), growth(2., 4.));
}
