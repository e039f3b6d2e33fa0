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
 * Tests of what makes a small marker's code certain.
 */

#include "code_proof.h"

#include <cmath>

#include <gtest/gtest.h>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif
using namespace circle_marker;

namespace {
const vpCircleMarkerFamily golay(vpCircleMarkerFamily::GOLAY23); // 11 check bits
const vpCircleMarkerFamily bch(vpCircleMarkerFamily::BCH31);     // 15

//! A fit of a print with a contrast of 150 grey levels that leaves so many grey levels.
FittedPose fitThatLeaves(double left, double correlation = 0.99)
{
  FittedPose fit;
  fit.photometry.white = 200.;
  fit.photometry.absorption = 0.75;
  fit.noise = left;
  fit.correlation = correlation;
  fit.inliers = 0.93;
  return fit;
}

bool proves(double odds, const FittedPose &fit, double noise, bool isCertain, double unexplained = 0.8,
            const vpCircleMarkerFamily &family = bch, std::size_t pixels = 200, double sector = 1.)
{
  LikelyCode code;
  code.odds = odds;
  code.unexplained = unexplained;
  return isProven(code, {family, fit, noise, isCertain, pixels, sector});
}
} // namespace

TEST(CodeProof, MoreOddsAreAskedOfWhatWasNotReadForCertain)
{
  const FittedPose fit = fitThatLeaves(2.);
  EXPECT_FALSE(proves(19.9, fit, 2., true));
  EXPECT_TRUE(proves(20.1, fit, 2., true));
  EXPECT_FALSE(proves(24.9, fit, 2., false));
  EXPECT_TRUE(proves(25.1, fit, 2., false));
}

TEST(CodeProof, AndOfADenseCodeInNoise)
{
  // 2 % of the contrast.
  EXPECT_FALSE(proves(32., fitThatLeaves(3.), 3., false, 0.8, golay));
  EXPECT_TRUE(proves(34., fitThatLeaves(3.), 3., false, 0.8, golay));
  EXPECT_TRUE(proves(32., fitThatLeaves(3.), 3., false, 0.8, bch));
  EXPECT_TRUE(proves(32., fitThatLeaves(3.), 3., true, 0.8, golay));
  // 1 %.
  EXPECT_TRUE(proves(32., fitThatLeaves(1.5), 1.5, false, 0.8, golay));
}

TEST(CodeProof, TheCodeMustExplainTheTrack)
{
  const FittedPose fit = fitThatLeaves(2.);
  EXPECT_FALSE(proves(39., fit, 2., true, 1.3));
  EXPECT_TRUE(proves(41., fit, 2., false, 1.55)) << "noise alone is left of the whole";
  EXPECT_FALSE(proves(41., fit, 2., false, 1.65));
  EXPECT_TRUE(proves(41., fitThatLeaves(2.3), 2., false, 1.25));
  EXPECT_FALSE(proves(41., fitThatLeaves(2.3), 2., false, 1.35));
  EXPECT_TRUE(proves(41., fit, 2., true, 1.9));
  EXPECT_FALSE(proves(500., fit, 2., true, 2.1));
}

TEST(CodeProof, OverwhelmingOddsNeedNotIfNoiseAloneIsLeft)
{
  // Noise alone is 1.2 times that of the image and 0.5 % of the contrast.
  EXPECT_TRUE(proves(1001., fitThatLeaves(3.1), 2., false, 3.9));
  EXPECT_FALSE(proves(999., fitThatLeaves(3.1), 2., false, 3.9));
  EXPECT_FALSE(proves(1001., fitThatLeaves(3.2), 2., false, 3.9));
  EXPECT_TRUE(proves(1001., fitThatLeaves(3.2), 2., true, 1.5)) << "as any other";
  EXPECT_FALSE(proves(1001., fitThatLeaves(3.1), 2., false, 3.9, bch, 200, 1.2)) << "sectors are long enough to tell";
  FittedPose covered = fitThatLeaves(3.1); // noise is told from most of the pixels, whatever the others are
  covered.inliers = 0.84;
  EXPECT_FALSE(proves(1001., covered, 2., false, 3.9));
}

TEST(CodeProof, NoOtherCodeIsMeasuredWhereNoneExplainsTheTrack)
{
  LikelyCode code;
  code.odds = 0.5; // at a pose that is off, the next codeword is nearly as likely
  code.unexplained = 1.5;
  EXPECT_TRUE(isWorthMeasuring(code));
  code.unexplained = 1.7;
  EXPECT_FALSE(isWorthMeasuring(code));
}

// Of 200 pixels the noise is known to 5 %: without clear odds no more than 3.5 times that may be left, and 0.3 % of the
// contrast as more noise; of 20 pixels the factor is 1.2. With clear odds the contrast's share is simply added.
TEST(CodeProof, NoMoreThanTheNoiseMayBeLeft)
{
  const auto leaves = [](double factor) { return fitThatLeaves(std::hypot(4. * factor, 0.45)); };
  EXPECT_TRUE(proves(35., leaves(1.17), 4., false));
  EXPECT_FALSE(proves(35., leaves(1.18), 4., false));
  EXPECT_FALSE(proves(35., fitThatLeaves(4. * 1.17 + 0.45), 4., false)) << "by squares";
  EXPECT_TRUE(proves(35., leaves(1.19), 4., false, 0.8, bch, 20));
  EXPECT_FALSE(proves(35., leaves(1.21), 4., false, 0.8, bch, 20));
  EXPECT_TRUE(proves(35., fitThatLeaves(4. * 1.19 + 0.45), 4., true)) << "it was read for certain";
  EXPECT_TRUE(proves(45., fitThatLeaves(4. * 1.19 + 0.45), 4., false)) << "the odds are clear";
  EXPECT_FALSE(proves(45., fitThatLeaves(4. * 1.21 + 0.45), 4., false));
}

// What covers a part of a code makes it look like another one, with any odds; but not like that one alone.
TEST(CodeProof, OfWhatWasNotReadForCertainLittleIsLeftWhateverTheOdds)
{
  EXPECT_TRUE(proves(500., fitThatLeaves(3.1), 2., false)); // 1.2 times the noise and 0.5 % of 150
  EXPECT_FALSE(proves(500., fitThatLeaves(3.2), 2., false));
  EXPECT_TRUE(proves(500., fitThatLeaves(3.2), 2., true));
}

TEST(CodeProof, WhatIsProvenLooksLikeAPrint)
{
  EXPECT_FALSE(proves(200., fitThatLeaves(2., 0.96), 1., false)) << "unlike the print";
  EXPECT_TRUE(proves(200., fitThatLeaves(2.1, 0.96), 2., false)) << "faint: no more than the noise is left";
  EXPECT_FALSE(proves(200., fitThatLeaves(8.), 2., false)) << "5 % of the contrast are left";
  EXPECT_TRUE(proves(200., fitThatLeaves(8.), 2., true));
  FittedPose blackerThanBlack = fitThatLeaves(2.);
  blackerThanBlack.photometry.absorption = 1.2;
  EXPECT_FALSE(proves(200., blackerThanBlack, 2., true));
}

// A letter was read as a golay23, with odds of e^34.
TEST(CodeProof, WhatNoSensorTellsIsNoContrastToLackAShareOf)
{
  FittedPose fit = fitThatLeaves(6.2); // 1.2 times the noise and 0.3 % of 255 are 6.4
  fit.photometry.white = 515.;
  fit.photometry.absorption = 1.;
  EXPECT_TRUE(proves(40.1, fit, 4.7, false));
  fit.noise = 6.8; // and of 515, 7.2
  EXPECT_FALSE(proves(40.1, fit, 4.7, false));
}

TEST(CodeProof, WhatPrintsLeaveIsNoiseAndSomeOfTheContrast)
{
  EXPECT_TRUE(leavesWhatPrintsLeave(fitThatLeaves(7.), 2.)); // 1.3 times 2 and 3 % of 150
  EXPECT_FALSE(leavesWhatPrintsLeave(fitThatLeaves(7.2), 2.));
}
