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
 * The contract of tutorial-circle-marker-pbvs, from outside.
 */

#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "run_program.h"

namespace fs = std::filesystem;

namespace {
/*! A row of a table, by the names of its columns. */
using Row = std::map<std::string, std::string>;

std::vector<std::string> cells(const std::string &line)
{
  std::vector<std::string> result;
  std::istringstream in(line);
  std::string cell;
  while (std::getline(in, cell, ',')) {
    result.push_back(cell);
  }
  return result;
}

std::vector<Row> rowsOf(const fs::path &file)
{
  std::istringstream in(test::contentOf(file));
  std::string line;
  std::getline(in, line);
  const std::vector<std::string> names = cells(line);
  std::vector<Row> rows;
  while (std::getline(in, line)) {
    const std::vector<std::string> values = cells(line);
    EXPECT_EQ(values.size(), names.size()) << line;
    Row row;
    for (std::size_t i = 0; i < std::min(names.size(), values.size()); ++i) {
      row[names[i]] = values[i];
    }
    rows.push_back(row);
  }
  return rows;
}

double number(const Row &row, const std::string &name)
{
  return std::stod(row.at(name));
}

/*! Three random starts with a detector all end at the desired pose, and what is written says so. */
void expectConvergence(const std::string &detector, const fs::path &folder)
{
  const test::Outcome outcome = test::run(
      PBVS_PROGRAM, {"--detector", detector, "--display-off", "--output", ".", "--runs", "3", "--seed", "40"}, folder);
  ASSERT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("3 of 3 converged"), std::string::npos) << outcome.out;
  const std::vector<Row> runs = rowsOf(folder / "runs.csv");
  ASSERT_EQ(runs.size(), 3U);
  for (const Row &run : runs) {
    EXPECT_LE(number(run, "distance_mm"), 1.);
    EXPECT_LE(number(run, "object_mm"), 1.);
    EXPECT_LE(number(run, "angle_deg"), 0.1);
  }
  const std::vector<Row> steps = rowsOf(folder / "servo.csv");
  ASSERT_GT(steps.size(), 10U);
  EXPECT_LE(number(steps.back(), "true_distance_m"), 1e-3);
  EXPECT_LE(number(steps.back(), "true_angle_deg"), 0.1);
  EXPECT_NEAR(number(steps.back(), "object_distance_m"), 0.5, 1e-3);
  EXPECT_NE(test::contentOf(folder / "servo.svg").find("</svg>"), std::string::npos);
  for (const std::string name : {"start", "halfway", "final"}) {
    EXPECT_EQ(cv::imread((folder / ("overlay-" + name + ".png")).string()).size(), cv::Size(1280, 960)) << name;
  }
}
} // namespace

TEST(PbvsProgram, CircleConverges)
{
  expectConvergence("circle", test::emptyFolder());
}

TEST(PbvsProgram, BothConvergesWithEachCoveredForAPartOfTheWay)
{
  const fs::path folder = test::emptyFolder();
  expectConvergence("both", folder);
  unsigned int circleCovered = 0, tagCovered = 0;
  for (const Row &step : rowsOf(folder / "servo.csv")) {
    if (step.at("circle_covered") == "1") {
      ++circleCovered;
      EXPECT_EQ(step.at("detector"), "apriltag") << "image " << step.at("iteration");
    }
    else {
      EXPECT_EQ(step.at("detector"), "circle") << "image " << step.at("iteration");
    }
    tagCovered += step.at("apriltag_covered") == "1" ? 1 : 0;
  }
  EXPECT_GT(circleCovered, 0U);
  EXPECT_GT(tagCovered, 0U);
}

TEST(PbvsProgram, MarkerTooFarAwayIsAClearFailure)
{
  // 0.12 m at 60 m are 3 pixels: no code can be read.
  const fs::path folder = test::emptyFolder();
  const test::Outcome outcome =
      test::run(PBVS_PROGRAM, {"--detector", "circle", "--display-off", "--output", ".", "--distance", "60"}, folder);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.out.find("no marker was seen"), std::string::npos) << outcome.out;
  for (const Row &step : rowsOf(folder / "servo.csv")) {
    EXPECT_EQ(step.at("vz_m_s"), "0") << "without a marker the camera stands still";
  }
}

TEST(PbvsProgram, WrongArgumentsEndWithTwo)
{
  const fs::path folder = test::emptyFolder();
  const std::vector<std::vector<std::string>> cases = {{"--detector", "square"}, {"--distance", "-1"},
                                                       {"--distance", "nan"},    {"--seed", "-1"},
                                                       {"--runs", "0"},          {"--nosuchoption"}};
  for (const std::vector<std::string> &arguments : cases) {
    const test::Outcome outcome = test::run(PBVS_PROGRAM, arguments, folder);
    EXPECT_EQ(outcome.status, 2) << ::testing::PrintToString(arguments);
    EXPECT_EQ(outcome.err.rfind("tutorial-circle-marker-pbvs: ", 0), 0U) << outcome.err;
  }
  EXPECT_EQ(test::run(PBVS_PROGRAM, {"--help"}, folder).status, 0);
  EXPECT_TRUE(test::filesIn(folder).empty());
}

// As of every program: what cannot be written is no wrong argument.
TEST(PbvsProgram, AFolderThatCannotBeMadeEndsWithOne)
{
  const fs::path folder = test::emptyFolder();
  const test::Outcome outcome = test::run(PBVS_PROGRAM, {"--output", "/dev/null/x"}, folder);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("/dev/null/x"), std::string::npos) << outcome.err;
}
