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
 * The windows of the tutorials, in an X server without a screen.
 */

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "run_program.h"
#include "screen.h"

namespace fs = std::filesystem;

namespace {
const std::string data = CIRCLE_MARKER_DATA_DIR;

/*! Runs a program under an X server of its own, with clicks of these buttons, two seconds between them. */
test::Outcome runWithClicks(const fs::path &folder, const std::string &title, const std::vector<std::string> &buttons,
                            const std::vector<std::string> &command)
{
  std::vector<std::string> arguments = {folder.string(), "bash", WINDOW_SCRIPT, folder.string(), title, "2"};
  arguments.insert(arguments.end(), buttons.begin(), buttons.end());
  arguments.push_back("--");
  arguments.insert(arguments.end(), command.begin(), command.end());
  return test::run(IN_X_SERVER, arguments, folder);
}
} // namespace

TEST(ProgramWindows, DetectorShowsWhatItFindsAndGoesOnAtAClick)
{
  const fs::path folder = test::emptyFolder();
  const test::Outcome outcome = runWithClicks(folder, "Circular markers", {"1"},
                                              {DETECTOR_PROGRAM, "--input", data + "/pictures/wide-families.png",
                                               "--intrinsic", data + "/pictures/camera-wide.xml", "--camera-name",
                                               "Wide", "--size", "0.18", "--json", "o.jsonl"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(fs::exists(folder / "o.jsonl"));
  const test::Screen screen = test::readScreen(folder / "screen-0.xwd");
  ASSERT_EQ(screen.pixels, 1400U * 1050U);
  EXPECT_GT(screen.grey, 640U * 480U / 2) << "the image is shown";
  EXPECT_GT(screen.green, 200U) << "two outlines of some 250 pixels are drawn";
}

TEST(ProgramWindows, ServoStartsAtALeftClickAndQuitsAtARightClick)
{
  const fs::path folder = test::emptyFolder();
  const test::Outcome outcome = runWithClicks(
      folder, "Servo on circular markers", {"1", "3"},
      {PBVS_PROGRAM, "--detector", "circle", "--seed", "3", "--distance", "4", "--output", folder.string()});
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_NE(outcome.out.find("stopped by a right click"), std::string::npos) << outcome.out << outcome.err;
  const test::Screen before = test::readScreen(folder / "screen-0.xwd"),
                     after = test::readScreen(folder / "screen-1.xwd");
  ASSERT_EQ(before.pixels, 1400U * 1050U);
  EXPECT_GT(before.grey, 640U * 480U / 2) << "the camera's image is shown";
  EXPECT_GT(before.white, 100000U) << "the curves' window is shown";
  EXPECT_GT(after.green, before.green) << "the marker has grown, or a curve with it";
  const std::string table = test::contentOf(folder / "servo.csv");
  EXPECT_GT(std::count(table.begin(), table.end(), '\n'), 5) << "the camera has moved between the clicks";
}
