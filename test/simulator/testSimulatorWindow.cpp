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
 * circle-marker-simulator with keys and mouse, in an X server without a screen.
 */

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "json_lines.h"
#include "run_program.h"
#include "screen.h"

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {
std::vector<Json> act(const fs::path &folder, const std::vector<std::string> &actions)
{
  std::vector<std::string> arguments = {folder.string(), "bash", WINDOW_SCRIPT, folder.string(),
                                        "Circular markers, simulator"};
  arguments.insert(arguments.end(), actions.begin(), actions.end());
  for (const char *word : {"--", SIMULATOR_PROGRAM, "--json", "out.jsonl", "--distance", "0.6"}) {
    arguments.push_back(word);
  }
  const test::Outcome outcome = test::run(IN_X_SERVER, arguments, folder);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return test::linesOf(test::contentOf(folder / "out.jsonl"));
}

double number(const Json &line, int element)
{
  return line["wMc"][static_cast<std::size_t>(element)].get<double>();
}
} // namespace

TEST(SimulatorWindow, KeysMoveTheCameraAndShowMore)
{
  const fs::path folder = test::emptyFolder();
  const std::vector<Json> lines =
      act(folder, {"wait:1", "shot:before", "key:w", "key:w", "key:d", "key:N", "key:V", "key:h", "wait:1",
                   "shot:after", "key:p", "need:simulator-0000.png", "key:q"});
  ASSERT_GT(lines.size(), 3U);
  EXPECT_NEAR(number(lines.back(), 11) - number(lines.front(), 11), 0.2, 1e-9) << "two steps forward";
  EXPECT_NEAR(number(lines.back(), 3) - number(lines.front(), 3), 0.1, 1e-9) << "one to the right";
  EXPECT_EQ(lines.back()["noise"], 3.) << "a capital letter is another key";
  EXPECT_NEAR(lines.back()["covered"].get<double>(), 0.1, 1e-9);
  const test::Screen before = test::readScreen(folder / "before.xwd");
  const test::Screen after = test::readScreen(folder / "after.xwd");
  EXPECT_GT(before.grey, 800U * 600U / 2) << "the image is shown";
  EXPECT_GT(before.green, 100U) << "markers are outlined, errors written";
  EXPECT_GT(after.white, before.white + 500) << "the keys are explained";
  EXPECT_FALSE(cv::imread((folder / "simulator-0000.png").string()).empty());
}

TEST(SimulatorWindow, TheMouseTurnsAndShiftsTheCamera)
{
  const fs::path folder = test::emptyFolder();
  const std::vector<Json> lines = act(folder, {"wait:1", "drag:1,160,0", "wait:1", "drag:2,0,80", "wait:1", "click:3"});
  ASSERT_GT(lines.size(), 3U);
  // Each of the pieces of 160 pixels turns by its own angle: between that of the whole and the sum of small ones.
  const double turn = std::atan2(number(lines.back(), 2), number(lines.back(), 10));
  EXPECT_LT(turn, -std::atan(160. / 600.) + 0.02) << "the scene goes with the pointer to the right";
  EXPECT_GT(turn, -160. / 600. - 0.02);
  EXPECT_NEAR(number(lines.back(), 7), -1.5 * 80. / 600., 0.02) << "and down: the camera goes up";
}

TEST(SimulatorWindow, ServoStartsAndStopsAtAKey)
{
  const fs::path folder = test::emptyFolder();
  const std::vector<Json> lines = act(folder, {"wait:1", "key:t", "wait:2", "key:t", "wait:1", "key:Escape"});
  ASSERT_GT(lines.size(), 5U);
  bool wasServoing = false;
  for (const Json &line : lines) {
    wasServoing = wasServoing || line["servo"].get<bool>();
  }
  EXPECT_TRUE(wasServoing);
  EXPECT_GT(number(lines.back(), 11), number(lines.front(), 11) + 0.05) << "it has gone toward the marker";
}
