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
 * The live detector with a V4L2 camera of a simulated libv4l, from outside.
 */

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "live_run.h"

namespace fs = std::filesystem;
using test::Json;

namespace {
/*! The device is any that is there: the simulated library opens it, and nothing touches the real one. */
test::Outcome detect(const Json &bus, const std::vector<std::string> &more, const fs::path &folder)
{
  std::vector<std::string> arguments =
      test::liveArguments({"--source", "v4l2:/dev/zero", "--display-off", "--all-images"});
  arguments.insert(arguments.end(), more.begin(), more.end());
  return test::runOnBus(LIVE_PROGRAM, arguments, folder, bus);
}
} // namespace

TEST(V4l2Live, PosesThroughTheGrabberOfViSP)
{
  const Json bus = test::chameleonBus();
  const test::Outcome outcome = detect(bus, {"--image-size", "1280x960", "--count", "6"}, test::emptyFolder());
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<Json> lines = test::linesOf(outcome.out);
  ASSERT_EQ(lines.size(), 6U);
  EXPECT_EQ(lines[5]["image"], "v4l2:/dev/zero#5");
  test::expectPoses(lines, bus);
  for (const Json &line : lines) {
    // The driver's clock counts from the computer's start; an hour's error would be one of the clocks.
    ASSERT_TRUE(line["latency_ms"].is_number());
    EXPECT_LT(line["latency_ms"].get<double>(), 60e3);
    EXPECT_GT(line["latency_ms"].get<double>(), 0.);
  }
}

TEST(V4l2Live, OtherSizeThanAskedForIsSaid)
{
  const test::Outcome outcome = detect(test::chameleonBus(), {"--count", "1"}, test::emptyFolder());
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("use --image-size 1280x960"), std::string::npos) << outcome.err;
}

TEST(V4l2Live, UnpluggedInTheMiddle)
{
  const fs::path folder = test::emptyFolder();
  Json bus = test::chameleonBus();
  bus["unplug_at"] = 3;
  const test::Outcome outcome = detect(bus, {"--image-size", "1280x960", "--json", "out.jsonl"}, folder);
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_NE(outcome.err.find("delivers no more images"), std::string::npos) << outcome.err;
  EXPECT_EQ(test::linesOf(test::contentOf(folder / "out.jsonl")).size(), 3U);
}
