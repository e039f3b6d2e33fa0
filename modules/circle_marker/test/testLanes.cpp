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
 * Arithmetic on eight pixels at a time.
 */

#include "testRoomTools.h"

#include "refine/lane_lists.h"
#include "refine/lane_tables.h"

using namespace circle_marker;
using namespace room_test;

TEST(Lanes, NormalDistribution)
{
  for (double start = -7.; start < 7.; start += 0.08) {
    Lanes z;
    for (int lane = 0; lane < laneCount; ++lane) {
      z[lane] = static_cast<float>(start + 0.01 * lane);
    }
    const NormalLanes normal = normalOf(z);
    const Lanes alone = cumulativeOf(z);
    for (int lane = 0; lane < laneCount; ++lane) {
      const double x = static_cast<double>(z[lane]);
      EXPECT_NEAR(normal.cumulative[lane], 0.5 * std::erfc(-x * M_SQRT1_2), 3e-7) << x;
      EXPECT_NEAR(alone[lane], 0.5 * std::erfc(-x * M_SQRT1_2), 1e-6) << x;
      EXPECT_NEAR(normal.density[lane], std::exp(-0.5 * x * x) / std::sqrt(2. * M_PI), 1e-7) << x;
    }
  }
}

TEST(Lanes, FarAwayIsNeitherInfiniteNorUnknown)
{
  Lanes z;
  z << -1e30f, -1e6f, -50.f, -0.f, 0.f, 50.f, 1e6f, 1e30f;
  const NormalLanes normal = normalOf(z);
  const float expected[laneCount] = {0.f, 0.f, 0.f, 0.5f, 0.5f, 1.f, 1.f, 1.f};
  for (int lane = 0; lane < laneCount; ++lane) {
    EXPECT_NEAR(normal.cumulative[lane], expected[lane], 1e-6) << z[lane];
    EXPECT_NEAR(cumulativeOf(z)[lane], expected[lane], 1e-6) << z[lane];
    EXPECT_TRUE(std::isfinite(normal.density[lane]));
  }
}

TEST(Lanes, ExponentialAndLogarithm)
{
  Random random = randomOfTest();
  for (int i = 0; i < 1000; ++i) {
    Lanes x;
    for (int lane = 0; lane < laneCount; ++lane) {
      x[lane] = static_cast<float>(uniform(random, -12., 6.));
    }
    const Lanes power = x.exp();
    const Lanes back = power.log();
    for (int lane = 0; lane < laneCount; ++lane) {
      const double expected = std::exp(static_cast<double>(x[lane]));
      EXPECT_NEAR(power[lane], expected, 3e-7 * expected) << x[lane];
      EXPECT_NEAR(back[lane], std::log(static_cast<double>(power[lane])), 1e-6) << x[lane];
    }
  }
}

TEST(Lanes, BelowABound)
{
  Random random = randomOfTest();
  for (int i = 0; i < 1000; ++i) {
    Lanes values;
    std::vector<int> expected;
    for (int lane = 0; lane < laneCount; ++lane) {
      values[lane] = i == 0 ? HUGE_VALF : static_cast<float>(uniform(random, 0., 2.));
      if (values[lane] < 1.f) {
        expected.push_back(lane);
      }
    }
    const LaneList list = lanesBelow(values, 1.f);
    EXPECT_EQ(std::vector<int>(list.lanes.begin(), list.lanes.begin() + list.count), expected);
  }
}

TEST(Lanes, EntriesOfATable)
{
  LaneTable table;
  for (std::size_t k = 0; k < table.entries.size(); ++k) {
    table.entries[k] = static_cast<float>(k * k);
  }
  Random random = randomOfTest();
  for (int i = 0; i < 100; ++i) {
    const Lanes number = lanesOf([&](int) { return static_cast<float>(uniform(random, 0., 31.999)); });
    const Lanes entries = entriesOf(table, number);
    for (int lane = 0; lane < laneCount; ++lane) {
      EXPECT_EQ(entries[lane], std::pow(std::floor(number[lane]), 2.f));
    }
  }
}

TEST(Lanes, WhatIsNoNumberOfAnEntryReadsNothingBesideTheTable)
{
  LaneTable table;
  table.entries.fill(3.f);
  Lanes number;
  number << -1e30f, -1.f, 32.f, 1e30f, HUGE_VALF, -HUGE_VALF, std::nanf(""), 31.9f;
  const Lanes entries = entriesOf(table, number);
  for (int lane = 0; lane < laneCount; ++lane) {
    EXPECT_EQ(entries[lane], 3.f) << number[lane];
  }
}

TEST(Lanes, AsBytes)
{
  Lanes number;
  number << 0.f, 1.f, 2.f, 127.f, 128.f, 200.f, 254.f, 255.f;
  std::array<unsigned char, laneCount> bytes;
  writeBytes(number, bytes.data());
  for (int lane = 0; lane < laneCount; ++lane) {
    EXPECT_EQ(static_cast<float>(bytes[static_cast<std::size_t>(lane)]), number[lane]);
  }
}
