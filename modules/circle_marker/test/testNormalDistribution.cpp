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
 * The table of the normal distribution against the C library.
 */

#include "testRoomTools.h"

#include "support/normal_distribution.h"

using circle_marker::NormalDistribution;
using namespace room_test;

namespace {
double cumulative(double x)
{
  return 0.5 * std::erfc(-x * M_SQRT1_2);
}
double density(double x)
{
  return std::exp(-0.5 * x * x) / std::sqrt(2. * M_PI);
}
} // namespace

TEST(NormalDistribution, AgreesWithTheLibrary)
{
  Random random = randomOfTest();
  const NormalDistribution &table = NormalDistribution::instance();
  for (int i = 0; i < 200000; ++i) {
    const double x = uniform(random, -6., 6.);
    const NormalDistribution::Value value = table.at(x);
    EXPECT_NEAR(value.cumulative, cumulative(x), 1e-10) << x;
    EXPECT_NEAR(value.density, density(x), 2e-5) << x;
  }
}

TEST(NormalDistribution, TailsAndSymmetry)
{
  const NormalDistribution &table = NormalDistribution::instance();
  for (const double x : {6., 6.000001, 7., 40., 1e300, HUGE_VAL}) {
    EXPECT_EQ(table.at(x).cumulative, 1.);
    EXPECT_EQ(table.at(-x).cumulative, 0.);
    EXPECT_EQ(table.at(x).density, 0.);
    EXPECT_EQ(table.at(-x).density, 0.);
  }
  EXPECT_NEAR(table.at(0.).cumulative, 0.5, 1e-15);
  EXPECT_NEAR(table.at(std::nextafter(6., 0.)).cumulative, 1., 1e-8);
  EXPECT_NEAR(table.at(std::nextafter(-6., 0.)).cumulative, 0., 1e-8);
  for (double x = -5.99; x < 6.; x += 0.0137) {
    EXPECT_NEAR(table.at(x).cumulative + table.at(-x).cumulative, 1., 1e-12);
    EXPECT_GE(table.at(x + 0.001).cumulative, table.at(x).cumulative);
  }
}
