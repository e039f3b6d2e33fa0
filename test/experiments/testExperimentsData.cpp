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
 * Tests of the table that keeps an experiment's samples.
 */

#include <functional>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "run_data.h"

using namespace experiments;

namespace {
std::mt19937_64 generator()
{
  return std::mt19937_64(std::hash<std::string>()(::testing::UnitTest::GetInstance()->current_test_info()->name()));
}

/*! Two series, of which only the names and methods count here. */
Experiment twoSeries()
{
  Series one;
  one.name = "one";
  one.frames = 3;
  one.methods = {Method::Ring, Method::Circle};
  Series two = one;
  two.name = "two";
  two.methods = {Method::Circle, Method::Bound}; // The bound is computed for every fifth frame only.
  two.frames = 7;
  return {"test", "Test", {one, two}};
}

Deviation randomDeviation(std::mt19937_64 &random)
{
  std::normal_distribution<double> normal(0., 3.);
  return {normal(random), normal(random), normal(random), std::fabs(normal(random))};
}

Sample randomSample(Method method, std::mt19937_64 &random)
{
  std::uniform_real_distribution<double> uniform(-5., 5.);
  Sample sample;
  sample.method = method;
  sample.x = uniform(random);
  sample.y = uniform(random);
  sample.z = 6. + uniform(random);
  sample.angle = 45. + uniform(random);
  sample.outlines = random() % 5;
  sample.markers = random() % 3;
  sample.cpuTime = 10. + uniform(random);
  if (random() % 4 > 0) {
    sample.first = randomDeviation(random);
    sample.isMirrored = random() % 2 == 0;
    sample.rotation = 6. + uniform(random);
    if (random() % 2 == 0) {
      sample.second = randomDeviation(random);
      sample.logOdds = uniform(random);
    }
  }
  return sample;
}

RunData randomData(const Experiment &experiment, std::mt19937_64 &random)
{
  RunData data = emptyData(experiment);
  for (std::size_t i = 0; i < data.size(); ++i) {
    for (std::size_t frame = 0; frame < data[i].size(); ++frame) {
      if (random() % 5 > 0) {
        data[i][frame].emplace();
        for (const Method method : methodsOf(experiment.series[i], frame)) {
          data[i][frame]->push_back(randomSample(method, random));
        }
      }
    }
  }
  return data;
}

void expectSame(const std::optional<Deviation> &a, const std::optional<Deviation> &b)
{
  ASSERT_EQ(a.has_value(), b.has_value());
  if (a) {
    EXPECT_NEAR(a->dx, b->dx, 1e-4);
    EXPECT_NEAR(a->dy, b->dy, 1e-4);
    EXPECT_NEAR(a->dz, b->dz, 1e-4);
    EXPECT_NEAR(a->normal, b->normal, 1e-4);
  }
}

/*! What the table says of why it cannot be read. */
std::string problemOf(const std::string &csv, const Settings &settings = Settings())
{
  try {
    dataFrom(csv, "file", twoSeries(), settings);
  }
  catch (const DataError &e) {
    return e.what();
  }
  return "";
}
} // namespace

TEST(ExperimentsData, ComesBackFromTheTable)
{
  std::mt19937_64 random = generator();
  const Experiment experiment = twoSeries();
  for (int i = 0; i < 100; ++i) {
    const RunData data = randomData(experiment, random);
    const RunData again = dataFrom(csvOf(experiment, Settings(), data), "file", experiment, Settings());
    ASSERT_EQ(framesDone(again), framesDone(data));
    for (std::size_t series = 0; series < data.size(); ++series) {
      ASSERT_EQ(again[series].size(), data[series].size());
      for (std::size_t frame = 0; frame < data[series].size(); ++frame) {
        ASSERT_EQ(again[series][frame].has_value(), data[series][frame].has_value());
        for (std::size_t method = 0; data[series][frame] && method < data[series][frame]->size(); ++method) {
          const Sample &a = (*data[series][frame])[method];
          const Sample &b = (*again[series][frame])[method];
          EXPECT_EQ(a.method, b.method);
          EXPECT_NEAR(a.z, b.z, 1e-7);
          EXPECT_NEAR(a.angle, b.angle, 1e-6);
          EXPECT_EQ(a.outlines, b.outlines);
          EXPECT_EQ(a.markers, b.markers);
          EXPECT_EQ(a.isMirrored, b.isMirrored);
          EXPECT_NEAR(a.cpuTime, b.cpuTime, 1e-3);
          EXPECT_NEAR(a.logOdds, b.logOdds, 1e-4);
          expectSame(a.first, b.first);
          expectSame(a.second, b.second);
        }
      }
    }
  }
}

TEST(ExperimentsData, TableOfTheTableIsTheSame)
{
  std::mt19937_64 random = generator();
  const Experiment experiment = twoSeries();
  const std::string csv = csvOf(experiment, Settings(), randomData(experiment, random));
  EXPECT_EQ(csvOf(experiment, Settings(), dataFrom(csv, "file", experiment, Settings())), csv);
}

TEST(ExperimentsData, FramesBeyondThoseAskedForAreKept)
{
  std::mt19937_64 random = generator();
  Experiment experiment = twoSeries();
  RunData data = emptyData(experiment);
  for (std::size_t frame = 0; frame < 3; ++frame) {
    data[0][frame] = FrameSamples{randomSample(Method::Ring, random), randomSample(Method::Circle, random)};
  }
  const std::string csv = csvOf(experiment, Settings(), data);
  experiment.series[0].frames = 1;
  EXPECT_EQ(framesDone(dataFrom(csv, "file", experiment, Settings())), 3u);
}

TEST(ExperimentsData, FrameWithoutOneOfItsMethodsIsNotDone)
{
  std::mt19937_64 random = generator();
  const Experiment experiment = twoSeries();
  RunData data = emptyData(experiment);
  data[0][1] = FrameSamples{randomSample(Method::Ring, random)};                                        // No circle.
  data[1][0] = FrameSamples{randomSample(Method::Circle, random)};                                      // No bound.
  data[1][1] = FrameSamples{randomSample(Method::Circle, random)};                                      // All.
  data[1][5] = FrameSamples{randomSample(Method::Circle, random), randomSample(Method::Bound, random)}; // All.
  EXPECT_EQ(framesDone(dataFrom(csvOf(experiment, Settings(), data), "file", experiment, Settings())), 2u);
}

TEST(ExperimentsData, OfOtherSettingsIsRefused)
{
  const std::string csv = csvOf(twoSeries(), Settings(), emptyData(twoSeries()));
  EXPECT_EQ(problemOf(csv), "");
  Settings settings;
  settings.seed = 2;
  EXPECT_NE(problemOf(csv, settings).find("seed 1, not 2"), std::string::npos);
  settings = Settings();
  settings.noise = 2.5;
  EXPECT_NE(problemOf(csv, settings).find("noise_grey_levels 2, not 2.5"), std::string::npos);
  settings = Settings();
  settings.maximumDistance = 5.;
  EXPECT_NE(problemOf(csv, settings).find("max_distance_m -, not 5"), std::string::npos);
  settings = Settings();
  settings.frames = 17; // Frames and threads change no frame.
  settings.threads = 3;
  EXPECT_EQ(problemOf(csv, settings), "");
}

TEST(ExperimentsData, SettingsComeBackFromTheTable)
{
  Settings settings;
  settings.seed = 18446744073709551615u;
  settings.noise = 0.1;
  settings.size = 1. / 3.;
  settings.maximumAngle = 12.5;
  const Settings again = settingsFrom(csvOf(twoSeries(), settings, emptyData(twoSeries())), "file", Settings());
  EXPECT_EQ(again.seed, settings.seed);
  EXPECT_EQ(again.noise, settings.noise);
  EXPECT_EQ(again.size, settings.size);
  EXPECT_EQ(again.maximumAngle, settings.maximumAngle);
  EXPECT_FALSE(again.maximumDistance.has_value());
}

TEST(ExperimentsData, WhatIsNoSuchTableIsRefused)
{
  std::mt19937_64 random = generator();
  const std::string head = csvOf(twoSeries(), Settings(), emptyData(twoSeries()));
  const std::string row = "one,0,ring,1,2,3,4,5,6,,,,,,,,,,,,,7\n";
  EXPECT_EQ(problemOf(head + row), "");
  for (const std::string &bad :
       {std::string("one,0,ring\n"), std::string("three,0,ring,1,2,3,4,5,6,,,,,,,,,,,,,7\n"),
        std::string("one,0,square,1,2,3,4,5,6,,,,,,,,,,,,,7\n"), std::string("one,0,ring,x,2,3,4,5,6,,,,,,,,,,,,,7\n"),
        std::string("one,99999999,ring,1,2,3,4,5,6,,,,,,,,,,,,,7\n"),
        std::string("one,0,ring,1,2,3,4,5,6,1,,,,,,,,,,,,7\n"), std::string("\n")}) {
    EXPECT_NE(problemOf(head + bad).find("line "), std::string::npos) << bad;
  }
  EXPECT_NE(problemOf(""), "");
  EXPECT_NE(problemOf("a,b,c\n1,2,3\n"), "");
  // Any cut leaves a table or a stated problem, never anything else.
  const std::string csv = csvOf(twoSeries(), Settings(), randomData(twoSeries(), random));
  for (std::size_t length = 0; length < csv.size(); ++length) {
    problemOf(csv.substr(0, length));
  }
}
