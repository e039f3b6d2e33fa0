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
 * Black-box tests of circle-marker-bound: its figures, its answers, its files, its errors.
 */

#include <cmath>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "../create/run_program.h"

using namespace test;
using nlohmann::json;

namespace {
const std::string camera = std::string(CIRCLE_MARKER_DATA_DIR) + "/camera.xml";

std::vector<std::string> plus(std::vector<std::string> arguments, const std::vector<std::string> &more)
{
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

/*! Runs a plan without a table worth the name and gives its JSON. */
json planOf(const std::vector<std::string> &arguments, const std::filesystem::path &folder)
{
  const Outcome outcome = run(CIRCLE_MARKER_BOUND, plus(arguments, {"--output", "plan"}), folder);
  const bool hasGnuplot = std::string(GNUPLOT) != "";
  EXPECT_EQ(outcome.status, hasGnuplot ? 0 : 1) << outcome.err;
  return json::parse(contentOf(folder / "plan" / "bound.json"), nullptr, false);
}
} // namespace

TEST(BoundProgram, GivesTheBoundsOfAPublishedPose)
{
  const auto folder = emptyFolder();
  const json plan =
      planOf({"--size", "0.2", "--id", "5", "--angle", "30", "--min-distance", "10", "--max-distance", "10", "--rows",
              "1", "--surround", "white", "--intrinsic", camera, "--camera-name", "Camera"},
             folder);
  ASSERT_FALSE(plan.is_discarded());
  ASSERT_EQ(plan["rows"].size(), 1u);
  const json &row = plan["rows"][0];
  // A ring of 0.75-1 with 24 sectors has 0.010 mm, 1.66 mm, 0.038 degrees and 33 (DESIGN.md, section 3).
  EXPECT_NEAR(row["x_mm"].get<double>() / 0.010, 1., 0.15);
  EXPECT_NEAR(row["z_mm"].get<double>() / 1.66, 1., 0.08);
  EXPECT_NEAR(row["normal_deg"].get<double>() / 0.038, 1., 0.08);
  EXPECT_NEAR(row["separation"].get<double>() / 33., 1., 0.08);
  EXPECT_NEAR(row["diameter_px"].get<double>(), 32., 0.3);
  EXPECT_NEAR(row["minor_axis_px"].get<double>(), 32. * std::cos(M_PI / 6.), 0.3);
  EXPECT_TRUE(row["in_image"].get<bool>());
  EXPECT_NEAR(plan["settings"]["noise_with_rounding"].get<double>(), std::sqrt(4. + 1. / 12.), 1e-12);
}

TEST(BoundProgram, WritesTableCsvJsonAndPlot)
{
  const auto folder = emptyFolder();
  const Outcome outcome = run(CIRCLE_MARKER_BOUND,
                              {"--angle", "0,45", "--min-distance", "6", "--max-distance", "18", "--rows", "3",
                               "--output", "plan", "--family", "bch31", "--id", "2113"},
                              folder);
  const bool hasGnuplot = std::string(GNUPLOT) != "";
  EXPECT_EQ(outcome.status, hasGnuplot ? 0 : 1) << outcome.err;
  std::vector<std::string> expected = {"bound.csv", "bound.gp", "bound.json"};
  if (hasGnuplot) {
    expected.push_back("bound.svg");
    EXPECT_NE(contentOf(folder / "plan" / "bound.svg").find("</svg>"), std::string::npos);
  }
  EXPECT_EQ(filesIn(folder / "plan"), expected);
  EXPECT_NE(outcome.out.find("angle 45 deg"), std::string::npos);

  const json plan = json::parse(contentOf(folder / "plan" / "bound.json"), nullptr, false);
  ASSERT_FALSE(plan.is_discarded());
  ASSERT_EQ(plan["rows"].size(), 6u);
  std::istringstream csv(contentOf(folder / "plan" / "bound.csv"));
  std::size_t lines = 0;
  for (std::string line; std::getline(csv, line);) {
    lines += line.rfind('#', 0) == 0 ? 0 : 1;
  }
  EXPECT_EQ(lines, 7u);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(plan["rows"][i]["separation"].is_null(), i < 3) << "facing the camera there is one pose";
    if (i % 3 > 0) {
      for (const char *name : {"x_mm", "y_mm", "z_mm", "normal_deg", "spin_deg"}) {
        EXPECT_GT(plan["rows"][i][name].get<double>(), plan["rows"][i - 1][name].get<double>()) << name;
      }
    }
  }
}

TEST(BoundProgram, AnswersAreConsistentWithTheTable)
{
  const auto folder = emptyFolder();
  const std::vector<std::string> wanted = {"--angle",       "40", "--accuracy-z", "3", "--accuracy-normal", "0.1",
                                           "--accuracy-xy", "1",  "--rows",       "1"};
  const json plan = planOf(plus(wanted, {"--min-distance", "5", "--max-distance", "5"}), folder);
  ASSERT_FALSE(plan.is_discarded());
  const double farthest = plan["reaches"][0]["farthest_m"].get<double>();
  const double leastSize = plan["reaches"][0]["least_size_m"].get<double>();

  // At the farthest distance one of the wanted figures is just met.
  const std::string there = std::to_string(farthest);
  const json atEnd = planOf(plus(wanted, {"--min-distance", there, "--max-distance", there}), folder);
  const double share =
      std::max(atEnd["rows"][0]["z_mm"].get<double>() / 3., atEnd["rows"][0]["normal_deg"].get<double>() / 0.1);
  EXPECT_NEAR(share, 1., 0.02);
  // And so it is for the least size, at its distance.
  const json least =
      planOf(plus(wanted, {"--min-distance", "5", "--max-distance", "5", "--size", std::to_string(leastSize)}), folder);
  const double leastShare =
      std::max(least["rows"][0]["z_mm"].get<double>() / 3., least["rows"][0]["normal_deg"].get<double>() / 0.1);
  EXPECT_NEAR(leastShare, 1., 0.02);
  // A reserve shortens the reach.
  const json reserved = planOf(plus(wanted, {"--min-distance", "5", "--max-distance", "5", "--reserve", "2"}), folder);
  EXPECT_LT(reserved["reaches"][0]["farthest_m"].get<double>(), 0.95 * farthest);
}

// Half the width of such an image would be a sheet whose near side is behind the camera.
TEST(BoundProgram, HasALeastSizeBeforeAWideLensToo)
{
  const json plan = planOf({"--focal", "300", "--angle", "70", "--accuracy-z", "5", "--min-distance", "3",
                            "--max-distance", "3", "--rows", "1"},
                           emptyFolder());
  ASSERT_FALSE(plan.is_discarded());
  const double leastSize = plan["reaches"][0]["least_size_m"].get<double>();
  EXPECT_GT(leastSize, 0.05);
  EXPECT_LT(leastSize, 1.);
}

TEST(BoundProgram, SaysWhenNothingDoes)
{
  const Outcome outcome =
      run(CIRCLE_MARKER_BOUND,
          {"--angle", "40", "--accuracy-z", "1e-6", "--min-distance", "3", "--max-distance", "3", "--rows", "1"},
          emptyFolder());
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("does not keep"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("no marker"), std::string::npos) << outcome.out;
}

TEST(BoundProgram, ShowsItsHelp)
{
  const Outcome outcome = run(CIRCLE_MARKER_BOUND, {"--help"}, emptyFolder());
  EXPECT_EQ(outcome.status, 0);
  for (const char *option :
       {"--intrinsic", "--focal", "--family", "--size", "--blur", "--contrast", "--noise", "--angle", "--min-distance",
        "--max-distance", "--accuracy-z", "--accuracy-normal", "--accuracy-odds", "--size-for", "--output"}) {
    EXPECT_NE(outcome.out.find(option), std::string::npos) << option;
  }
}

TEST(BoundProgram, RefusesWrongArguments)
{
  const auto folder = emptyFolder();
  const std::vector<std::vector<std::string>> wrong = {{"--family", "golay24"},
                                                       {"--id", "178"},
                                                       {"--size", "nan"},
                                                       {"--min-distance", "9", "--max-distance", "8"},
                                                       {"--intrinsic", "no-such.xml"},
                                                       {"--output", ""},
                                                       {"--angle", "95"},
                                                       {"--family", "disc", "--accuracy-odds", "1"},
                                                       {"--camera-name", "Camera"},
                                                       {"--frames", "3"},
                                                       {"more"}};
  for (const auto &arguments : wrong) {
    const Outcome outcome = run(CIRCLE_MARKER_BOUND, arguments, folder);
    EXPECT_EQ(outcome.status, 2) << arguments[0];
    EXPECT_EQ(outcome.err.rfind("circle-marker-bound: ", 0), 0u) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
  const Outcome noCamera = run(CIRCLE_MARKER_BOUND, {"--intrinsic", camera, "--camera-name", "Nobody"}, folder);
  EXPECT_EQ(noCamera.status, 1);
  EXPECT_NE(noCamera.err.find("Nobody"), std::string::npos);
  EXPECT_EQ(filesIn(folder), std::vector<std::string>());
}
