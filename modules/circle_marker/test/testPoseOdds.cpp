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
 * How far a likelihood is believed that prefers one pose to the other.
 */

#include "refine/pose_odds.h"

#include <cmath>

#include <gtest/gtest.h>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif
using namespace circle_marker;

namespace {
FittedPose fit(double coherence, double decrement, bool isSettled)
{
  FittedPose pose;
  pose.coherence = coherence;
  pose.decrement = decrement;
  pose.isSettled = isSettled;
  return pose;
}
} // namespace

TEST(PoseOdds, WhereTheModelExplainsTheImageTheLikelihoodIsBelieved)
{
  // The other pose is wrong, so the parts of the print pull at it; and it was given up on its way.
  EXPECT_EQ(coherentOdds(40., fit(1., 1., true), fit(12., 900., false), 2.), 40.);
}

TEST(PoseOdds, WhatPullsThePoseApartPrefersOneAsMuch)
{
  EXPECT_NEAR(coherentOdds(40., fit(5., 1., true), fit(1., 1., true), 2.), 8., 1e-12);
}

TEST(PoseOdds, EdgesThatAreNoisierThanThePaperSayLess)
{
  FittedPose noisy = fit(1., 1., true);
  noisy.edgeNoise = 2.;
  EXPECT_NEAR(coherentOdds(40., noisy, fit(1., 1., true), 2.), 20., 1e-12);
  noisy.coherence = 4.;
  EXPECT_NEAR(coherentOdds(40., noisy, fit(1., 1., true), 2.), 5., 1e-12);
}

TEST(PoseOdds, AFitThatIsOnItsWaySaysLess)
{
  // The second would leave 240 grey levels^2 less: 30 in the cost at a noise of 2, 6 by a coherence of 5.
  EXPECT_NEAR(coherentOdds(40., fit(5., 1., true), fit(1., 240., false), 2.), 2. * 64. / (16. + 36.), 1e-12);
  EXPECT_NEAR(coherentOdds(40., fit(5., 80., false), fit(1., 160., false), 2.), 2. * 64. / (16. + 36.), 1e-12);
  EXPECT_EQ(coherentOdds(HUGE_VAL, fit(5., 80., false), fit(5., 80., false), 2.), HUGE_VAL);
  EXPECT_EQ(coherentOdds(0., fit(5., 0., false), fit(5., 0., false), 2.), 0.);
}

TEST(PoseOdds, UnrefinedPosesLeaveMoreByChance)
{
  EXPECT_NEAR(costOf(48., 2., 1.), 6., 1e-12);
  EXPECT_NEAR(costOf(48., 2., 3.), 2., 1e-12); // three pixels that share their noise are one
  EXPECT_NEAR(unrefinedOdds(8., fit(1., 48., false), 2.), 2. * 64. / (16. + 36.), 1e-12);
  EXPECT_EQ(unrefinedOdds(0., fit(1., 0., true), 2.), 0.);
}
