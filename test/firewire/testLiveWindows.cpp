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
 * The windows of the live programs, with keys and buttons, in an X server without a screen.
 */

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "live_run.h"
#include "screen.h"

namespace fs = std::filesystem;
using test::Json;

namespace {
/*! Runs a program under an X server of its own, with a FireWire camera in real time, and with these actions. */
test::Outcome act(const fs::path &folder, const std::string &title, const std::vector<std::string> &actions,
                  const std::string &program, const std::vector<std::string> &arguments)
{
  Json bus = test::chameleonBus();
  bus["real_time"] = true;
  // One pose: what differs between two screens is what the keys have changed.
  bus["poses"] = {test::pathOfPoses(12)[1]};
  std::vector<std::string> before = {IN_X_SERVER, folder.string(), "bash", WINDOW_SCRIPT, folder.string(), title};
  before.insert(before.end(), actions.begin(), actions.end());
  before.push_back("--");
  return test::runOnBus(program, arguments, folder, bus, before);
}

std::vector<std::string> live(const std::vector<std::string> &more)
{
  std::vector<std::string> arguments =
      test::liveArguments({"--video-mode", "1280x960_mono8", "--framerate", "15", "--json", "out.jsonl"});
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

const std::string liveTitle = "Circular markers, live";
} // namespace

TEST(LiveWindows, KeysShowMoreAndQuit)
{
  const fs::path folder = test::emptyFolder();
  const test::Outcome outcome = act(folder, liveTitle,
                                    {"wait:1", "shot:plain", "key:2", "key:u", "wait:1", "shot:details", "key:h",
                                     "wait:1", "shot:keys", "key:x", "key:Shift", "wait:0.5", "key:q"},
                                    LIVE_PROGRAM, live({}));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const test::Screen plain = test::readScreen(folder / "plain.xwd");
  const test::Screen details = test::readScreen(folder / "details.xwd");
  const test::Screen keys = test::readScreen(folder / "keys.xwd");
  ASSERT_EQ(plain.pixels, 1400U * 1050U);
  EXPECT_GT(plain.grey, 640U * 480U / 2) << "the image is shown";
  EXPECT_GT(plain.green, 100U) << "the outline is drawn";
  EXPECT_EQ(plain.orange, 0U);
  EXPECT_GT(details.orange, 20U) << "the second pose is drawn";
  EXPECT_GT(details.yellow, plain.yellow + 300) << "two more lines of text";
  EXPECT_GT(keys.white, details.white + 500) << "the keys are explained";
  const std::vector<Json> lines = test::linesOf(test::contentOf(folder / "out.jsonl"));
  EXPECT_GT(lines.size(), 10U);
}

TEST(LiveWindows, SpaceHoldsTheImageAndAClickQuits)
{
  const fs::path folder = test::emptyFolder();
  const test::Outcome outcome =
      act(folder, liveTitle, {"wait:1", "key:space", "wait:1", "shot:held", "wait:1", "shot:still", "click:1"},
          LIVE_PROGRAM, live({}));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(test::contentOf(folder / "held.xwd"), test::contentOf(folder / "still.xwd"));
  const std::vector<Json> lines = test::linesOf(test::contentOf(folder / "out.jsonl"));
  ASSERT_GT(lines.size(), 0U);
  // Two seconds of 30 images are not in the results.
  EXPECT_LT(lines.size(), 40U);
}

TEST(LiveWindows, LeftClickRecordsAndEscapeQuits)
{
  const fs::path folder = test::emptyFolder();
  const test::Outcome outcome =
      act(folder, liveTitle, {"wait:1", "click:1", "wait:1", "shot:recording", "key:r", "wait:0.5", "key:Escape"},
          LIVE_PROGRAM, live({"--record", "sequence/img%03d.png"}));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const std::size_t recorded = test::linesOf(test::contentOf(folder / "sequence/poses.jsonl")).size();
  EXPECT_GT(recorded, 2U);
  EXPECT_EQ(test::filesIn(folder / "sequence").size(), recorded + 1);
  EXPECT_GT(test::linesOf(test::contentOf(folder / "out.jsonl")).size(), recorded)
      << "images before and after were seen, but not recorded";
}

TEST(LiveWindows, ServoStandsUntilALeftClickAndQuitsAtARightClick)
{
  const fs::path folder = test::emptyFolder();
  const test::Outcome outcome =
      act(folder, "Servo on circular markers",
          {"wait:2", "shot:before", "click:1", "wait:2", "shot:moving", "click:1", "wait:1", "shot:stopped", "click:3"},
          SERVO_PROGRAM, {"--output", folder.string()});
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_NE(outcome.out.find("stopped by a right click"), std::string::npos) << outcome.out << outcome.err;
  const test::Screen before = test::readScreen(folder / "before.xwd"), moving = test::readScreen(folder / "moving.xwd");
  EXPECT_GT(before.grey, 640U * 480U / 2) << "the camera's image is shown";
  EXPECT_GT(moving.green, before.green) << "the marker has grown";
  EXPECT_NE(test::contentOf(folder / "servo.csv").find("\n3,"), std::string::npos) << "several images count";
}
