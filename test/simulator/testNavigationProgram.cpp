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
 * circle-marker-navigation: the robot finds its way, and knows how well.
 */

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "run_program.h"

namespace fs = std::filesystem;
using Json = nlohmann::json;

TEST(NavigationProgram, FollowsTasksAndKnowsWhereItIs)
{
  unsetenv("DISPLAY");
  const fs::path folder = test::emptyFolder();
  const test::Outcome outcome = test::run(NAVIGATION_PROGRAM, {"--output", "out", "--most-tasks", "3"}, folder);
  ASSERT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  const Json result = Json::parse(test::contentOf(folder / "out/navigation.json"));
  EXPECT_TRUE(result["complete"].get<bool>());
  ASSERT_EQ(result["stations"].size(), 4U);
  EXPECT_EQ(result["stations"][0]["marker"], "window");
  EXPECT_EQ(result["stations"][1]["marker"], "lift") << "where the window's marker has sent it";
  EXPECT_EQ(result["stations"][2]["marker"], "copier");
  EXPECT_EQ(result["stations"][3]["marker"], "sink");
  for (const Json &station : result["stations"]) {
    // 10 mm are asked for of the place that is believed.
    EXPECT_LT(station["off_mm"].get<double>(), 30.) << station.dump();
  }
  EXPECT_LT(result["place_mm"]["rms"].get<double>(), 20.);
  EXPECT_GT(result["wheels_mm"]["greatest"].get<double>(), 5. * result["place_mm"]["greatest"].get<double>())
      << "the wheels alone lose the way";
  // Honest: the error is about as large as its standard deviation says.
  EXPECT_LT(result["camera_sigmas"]["rms"].get<double>(), 2.);
  EXPECT_GT(result["camera_sigmas"]["rms"].get<double>(), 0.5);
  EXPECT_LT(result["belief_sigmas"]["rms"].get<double>(), 2.5);
  const std::string map = test::contentOf(folder / "out/map.svg");
  EXPECT_NE(map.find("copier"), std::string::npos);
  EXPECT_NE(map.find("</svg>"), std::string::npos);
  EXPECT_TRUE(fs::exists(folder / "out/station-3.png"));
  EXPECT_TRUE(fs::exists(folder / "out/track.csv"));
}

// What is in the room is looked for, whatever its family.
TEST(NavigationProgram, MarkersOfAllFamiliesAreSeen)
{
  unsetenv("DISPLAY");
  const fs::path folder = test::emptyFolder();
  std::ofstream(folder / "room.json")
      << R"({"markers": [{"family": "bch31r", "id": 3, "size": 0.18, "name": "window", "payload": {"task": "stop"},
             "pose": [0, 0, 5, 0, 0, 0]}]})";
  const test::Outcome outcome = test::run(NAVIGATION_PROGRAM, {"--output", "out", "--database", "room.json"}, folder);
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
}

TEST(NavigationProgram, PayloadsThatAreNoTasksAreNamed)
{
  const fs::path folder = test::emptyFolder();
  const std::string marker = R"({"markers": [{"family": "golay23", "id": 1, "size": 0.18, "name": "window",
    "payload": PAYLOAD, "pose": [0, 0, 5, 0, 0, 0]}]})";
  const auto outcomeOf = [&](const std::string &payload) {
    std::string text = marker;
    text.replace(text.find("PAYLOAD"), 7, payload);
    std::ofstream(folder / "room.json") << text;
    return test::run(NAVIGATION_PROGRAM, {"--output", "out", "--database", "room.json"}, folder);
  };
  const test::Outcome stop = outcomeOf(R"({"task": "stop"})");
  EXPECT_EQ(stop.status, 0) << stop.err;
  const test::Outcome fly = outcomeOf(R"({"task": "fly"})");
  EXPECT_EQ(fly.status, 1);
  EXPECT_NE(fly.err.find("the task \"fly\" is not known"), std::string::npos) << fly.err;
  const test::Outcome words = outcomeOf("\"somewhere\"");
  EXPECT_EQ(words.status, 1);
  EXPECT_NE(words.err.find("is no task"), std::string::npos) << words.err;
  const test::Outcome none = outcomeOf("\"\"");
  EXPECT_EQ(none.status, 1);
  EXPECT_NE(none.err.find("no marker with a task"), std::string::npos) << none.err;
}
