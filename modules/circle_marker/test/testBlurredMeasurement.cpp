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
