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
 * The live detector with a FireWire camera of the simulated bus, from outside.
 */

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "live_run.h"

namespace fs = std::filesystem;
using test::Json;

namespace {
/*! Runs the live detector without a window; every image is used. */
test::Outcome detect(const Json &bus, const std::vector<std::string> &more, const fs::path &folder)
{
  std::vector<std::string> arguments = test::liveArguments({"--display-off", "--all-images"});
  arguments.insert(arguments.end(), more.begin(), more.end());
  return test::runOnBus(LIVE_PROGRAM, arguments, folder, bus);
}

const std::vector<std::string> chameleon = {"--video-mode", "1280x960_mono8", "--framerate", "15"};

std::vector<std::string> with(std::vector<std::string> arguments, const std::vector<std::string> &more)
{
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

bool isSaid(const std::string &text, const std::string &part)
{
  return text.find(part) != std::string::npos;
}

std::vector<std::string> textLines(const fs::path &file)
{
  std::istringstream in(test::contentOf(file));
  std::vector<std::string> lines;
  std::string line;
  while (std::getline(in, line)) {
    lines.push_back(line);
  }
  return lines;
}

/*! Every line of what went wrong starts with the program's name, but for the last one with the numbers of images. */
void expectClearMessage(const test::Outcome &outcome, const std::string &part)
{
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_TRUE(isSaid(outcome.err, part)) << outcome.err;
  EXPECT_EQ(outcome.err.rfind("tutorial-circle-marker-detector-live: ", 0), 0U) << outcome.err;
}
} // namespace

TEST(FireWireLive, PosesOfTheThesisCamera)
{
  const fs::path folder = test::emptyFolder();
  Json bus = test::chameleonBus();
  bus["log"] = folder.string() + ".log";
  fs::remove(folder.string() + ".log");
  const test::Outcome outcome = detect(bus, with(chameleon, {"--count", "12"}), folder);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<Json> lines = test::linesOf(outcome.out);
  ASSERT_EQ(lines.size(), 12U);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_EQ(lines[i]["image"], "firewire:0#" + std::to_string(i));
    EXPECT_EQ(lines[i]["width"], 1280);
    EXPECT_EQ(lines[i]["height"], 960);
    EXPECT_EQ(lines[i]["missed"], 0);
    // The camera's own clock: 15 images a second.
    EXPECT_NEAR(lines[i]["time_s"].get<double>() - lines[0]["time_s"].get<double>(), static_cast<double>(i) / 15.,
                1e-4);
  }
  test::expectPoses(lines, bus);
  EXPECT_TRUE(isSaid(outcome.err, "dropped: 0 by the camera or bus, 0 passed over here; damaged: 0")) << outcome.err;
  // The camera is left as it should be.
  const std::vector<std::string> told = textLines(folder.string() + ".log");
  ASSERT_GT(told.size(), 3U);
  EXPECT_EQ(told[told.size() - 3], "transmission off");
  EXPECT_EQ(told[told.size() - 2], "capture stopped");
  EXPECT_EQ(told[told.size() - 1], "power off");
}

TEST(FireWireLive, ByGuidInColorModes)
{
  for (const std::string mode : {"1280x960_yuv422", "1280x960_rgb8", "1280x960_mono16"}) {
    const Json bus = test::chameleonBus();
    const test::Outcome outcome = detect(
        bus, {"--source", "firewire:0x00b09d01007e0ee7", "--video-mode", mode, "--framerate", "7.5", "--count", "3"},
        test::emptyFolder());
    ASSERT_EQ(outcome.status, 0) << mode << outcome.err;
    const std::vector<Json> lines = test::linesOf(outcome.out);
    ASSERT_EQ(lines.size(), 3U);
    EXPECT_EQ(lines[2]["image"], "firewire:0x00b09d01007e0ee7#2");
    test::expectPoses(lines, bus);
  }
}

TEST(FireWireLive, RegionOfFormat7KeepsThePoses)
{
  const Json bus = test::chameleonBus();
  const test::Outcome outcome = detect(
      bus,
      {"--video-mode", "format7_0", "--format7-roi", "240,160,800,640", "--color-coding", "mono8", "--count", "12"},
      test::emptyFolder());
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<Json> lines = test::linesOf(outcome.out);
  ASSERT_EQ(lines.size(), 12U);
  EXPECT_EQ(lines[0]["width"], 800);
  EXPECT_EQ(lines[0]["height"], 640);
  test::expectPoses(lines, bus);
}

TEST(FireWireLive, ShutterAndGainReachTheCamera)
{
  const fs::path folder = test::emptyFolder();
  Json bus = test::chameleonBus();
  bus["log"] = folder.string() + ".log";
  fs::remove(folder.string() + ".log");
  const test::Outcome outcome =
      detect(bus, with(chameleon, {"--shutter", "480", "--gain", "auto", "--count", "1"}), folder);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<std::string> told = textLines(folder.string() + ".log");
  // In libdc1394's order of features, shutter is 7 and gain 8.
  const auto shutter = std::find(told.begin(), told.end(), "feature 7 = 480");
  ASSERT_NE(shutter, told.end());
  EXPECT_EQ(*(shutter - 1), "feature 7 by hand");
  EXPECT_NE(std::find(told.begin(), told.end(), "feature 8 automatic"), told.end());
}

TEST(FireWireLive, WhatTheCameraDoesNotHaveIsSaid)
{
  const fs::path folder = test::emptyFolder();
  const std::pair<std::vector<std::string>, std::string> cases[] = {
      {{"--video-mode", "1600x1200_mono8"}, "it has 640x480_yuv411, 640x480_mono8, 1280x960_yuv422"},
      {{"--video-mode", "1280x960_rgb8", "--framerate", "15"},
       "--framerate in the mode 1280x960_rgb8; it has 3.75, 7.5"},
      {{"--video-mode", "format7_0", "--format7-roi", "800,0,640,480"}, "beyond the camera's image of 1280 x 960"},
      {{"--video-mode", "format7_0", "--color-coding", "rgb16s"}, "--color-coding; it has mono8, mono16"},
      {with(chameleon, {"--shutter", "5000"}), "it takes 0 to 1023"},
      {{"--source", "firewire:first"}, "index from 0 or its GUID"},
  };
  for (const auto &[arguments, part] : cases) {
    const test::Outcome outcome = detect(test::chameleonBus(), with(arguments, {"--count", "1"}), folder);
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_TRUE(isSaid(outcome.err, part)) << outcome.err;
  }
  expectClearMessage(detect(test::chameleonBus(), {"--source", "firewire:1"}, folder), "0 = 0x00b09d01007e0ee7");
  // The region is not in the camera's steps: ViSP closes the camera, and the message of its own would mislead.
  expectClearMessage(
      detect(test::chameleonBus(), {"--video-mode", "format7_0", "--format7-roi", "3,0,640,480"}, folder),
      "cannot be started");
}

TEST(FireWireLive, ColorsThatCannotBeConvertedAreSaid)
{
  expectClearMessage(
      detect(test::chameleonBus(), {"--video-mode", "format7_0", "--color-coding", "rgb16"}, test::emptyFolder()),
      "cannot convert the camera's color coding");
}

TEST(FireWireLive, UnpluggedInTheMiddle)
{
  for (const bool isUsb : {false, true}) {
    const fs::path folder = test::emptyFolder();
    Json bus = test::chameleonBus();
    bus["unplug_at"] = 5;
    bus["usb"] = isUsb;
    const test::Outcome outcome = detect(bus, with(chameleon, {"--json", "out.jsonl"}), folder);
    expectClearMessage(outcome, "no longer answers: was it unplugged");
    // What was seen before is kept.
    const std::vector<Json> lines = test::linesOf(test::contentOf(folder / "out.jsonl"));
    ASSERT_EQ(lines.size(), 5U);
    test::expectPoses(lines, bus);
  }
}

TEST(FireWireLive, BusThatFallsSilent)
{
  const fs::path folder = test::emptyFolder();
  Json bus = test::chameleonBus();
  bus["silent_at"] = 4;
  const test::Outcome outcome = detect(bus, with(chameleon, {"--json", "out.jsonl", "--timeout", "0.5"}), folder);
  expectClearMessage(outcome, "no image came from firewire:0 for 0.5 s");
  EXPECT_EQ(test::linesOf(test::contentOf(folder / "out.jsonl")).size(), 4U);
}

TEST(FireWireLive, DamagedImagesAreLeftOutAndSaid)
{
  const fs::path folder = test::emptyFolder();
  Json bus = test::chameleonBus();
  bus["corrupt"] = {1};
  bus["truncated"] = {3};
  bus["undeliverable"] = {5};
  const test::Outcome outcome = detect(bus, with(chameleon, {"--json", "out.jsonl", "--count", "6"}), folder);
  expectClearMessage(outcome, "image firewire:0#1 is damaged: packets were lost on the way");
  EXPECT_TRUE(isSaid(outcome.err, "image firewire:0#3 is damaged: 409600 bytes came of 1228800")) << outcome.err;
  EXPECT_TRUE(isSaid(outcome.err, "could not deliver an image")) << outcome.err;
  EXPECT_TRUE(isSaid(outcome.err, "dropped: 0 by the camera or bus, 0 passed over here; damaged: 3")) << outcome.err;
  const std::vector<Json> lines = test::linesOf(test::contentOf(folder / "out.jsonl"));
  ASSERT_EQ(lines.size(), 6U);
  EXPECT_EQ(lines[0]["image"], "firewire:0#0");
  EXPECT_EQ(lines[1]["image"], "firewire:0#2");
  EXPECT_EQ(lines[2]["image"], "firewire:0#4");
}

TEST(FireWireLive, OnlyDamagedImagesEnd)
{
  Json bus = test::chameleonBus();
  std::vector<long> all(1000);
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i] = static_cast<long>(i);
  }
  bus["corrupt"] = all;
  expectClearMessage(detect(bus, chameleon, test::emptyFolder()), "delivers only damaged images");
}

TEST(FireWireLive, LostImagesAreCounted)
{
  Json bus = test::chameleonBus();
  bus["after_gap"] = {2, 4};
  const test::Outcome outcome = detect(bus, with(chameleon, {"--count", "6"}), test::emptyFolder());
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<Json> lines = test::linesOf(outcome.out);
  ASSERT_EQ(lines.size(), 6U);
  const int missed[] = {0, 0, 2, 0, 2, 0};
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(lines[i]["missed"], missed[i]) << i;
  }
  // The camera is read one image ahead.
  EXPECT_TRUE(isSaid(outcome.err, "dropped: 4 by the camera or bus")) << outcome.err;
}

TEST(FireWireLive, InRealTimeTheNewestImageIsUsedAndTheLatencyIsKnown)
{
  Json bus = test::chameleonBus();
  bus["real_time"] = true;
  const test::Outcome outcome = test::runOnBus(
      LIVE_PROGRAM, test::liveArguments(with(chameleon, {"--display-off", "--count", "10"})), test::emptyFolder(), bus);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<Json> lines = test::linesOf(outcome.out);
  ASSERT_EQ(lines.size(), 10U);
  test::expectPoses(lines, bus);
  for (const Json &line : lines) {
    ASSERT_TRUE(line["latency_ms"].is_number()) << line["image"];
    EXPECT_GE(line["latency_ms"].get<double>(), line["cpu_ms"].get<double>() * 0.5);
  }
}

TEST(FireWireLive, UsbCamerasHaveNoTimeStamps)
{
  Json bus = test::chameleonBus();
  bus["usb"] = true;
  const test::Outcome outcome = detect(bus, with(chameleon, {"--count", "2"}), test::emptyFolder());
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<Json> lines = test::linesOf(outcome.out);
  EXPECT_TRUE(lines.at(1)["time_s"].is_null());
  EXPECT_TRUE(lines.at(1)["latency_ms"].is_null());
  test::expectPoses(lines, bus);
}

TEST(FireWireLive, BrokenBuses)
{
  const fs::path folder = test::emptyFolder();
  const std::pair<std::string, std::string> cases[] = {{"library_fails", "libdc1394 cannot be started"},
                                                       {"list_fails", "cannot be listed"},
                                                       {"open_fails", "0x00b09d01007e0ee7 cannot be opened"},
                                                       {"setup_fails", "needs less of the bus"}};
  for (const auto &[failure, part] : cases) {
    Json bus = test::chameleonBus();
    bus[failure] = true;
    expectClearMessage(detect(bus, {}, folder), part);
  }
  Json empty = test::chameleonBus();
  empty["cameras"] = Json::array();
  const test::Outcome outcome = detect(empty, {}, folder);
  expectClearMessage(outcome, "no FireWire camera was found");
  EXPECT_TRUE(isSaid(outcome.err, "60-circle-marker-cameras.rules")) << outcome.err;
}

TEST(FireWireLive, CamerasAreListed)
{
  Json bus = test::chameleonBus();
  bus["cameras"].push_back({{"guid", 0xb09d01009b329cULL}, {"vendor", "Point Grey Research"}, {"model", "Flea2"}});
  const test::Outcome outcome = test::runOnBus(LIVE_PROGRAM, {"--list-cameras"}, test::emptyFolder(), bus);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(isSaid(outcome.out, "firewire:0 = firewire:0x00b09d01007e0ee7  Point Grey Research Chameleon"))
      << outcome.out;
  EXPECT_TRUE(isSaid(outcome.out, "firewire:1 = firewire:0x00b09d01009b329c  Point Grey Research Flea2"));
  EXPECT_TRUE(isSaid(outcome.out, "1280x960_mono8")) << outcome.out;
}

TEST(FireWireLive, RecordingGivesTheSamePosesAgain)
{
  const fs::path folder = test::emptyFolder();
  const Json bus = test::chameleonBus();
  const test::Outcome outcome =
      detect(bus, with(chameleon, {"--count", "5", "--record", "sequence/img%04d.png"}), folder);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "") << "the lines are in poses.jsonl";
  const std::vector<Json> live = test::linesOf(test::contentOf(folder / "sequence/poses.jsonl"));
  ASSERT_EQ(live.size(), 5U);
  EXPECT_EQ(test::filesIn(folder / "sequence").size(), 6U);
  const test::Outcome replay =
      test::run(DETECTOR_PROGRAM, test::liveArguments({"--display-off", "--input", "sequence/img%04d.png"}), folder);
  ASSERT_EQ(replay.status, 0) << replay.err;
  const std::vector<Json> again = test::linesOf(replay.out);
  ASSERT_EQ(again.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(live[i]["image"], again[i]["image"]);
    EXPECT_EQ(live[i]["markers"], again[i]["markers"]) << i;
  }
  // A recording is never overwritten.
  const test::Outcome second =
      detect(bus, with(chameleon, {"--count", "1", "--record", "sequence/img%04d.png"}), folder);
  expectClearMessage(second, "is there already");
}

// Ctrl-C is how a program without a window ends: nothing is lost.
TEST(FireWireLive, InterruptKeepsTheResults)
{
  const fs::path folder = test::emptyFolder();
  Json bus = test::chameleonBus();
  bus["real_time"] = true;
  const test::Outcome outcome =
      test::runOnBus(LIVE_PROGRAM, test::liveArguments(with(chameleon, {"--display-off", "--json", "out.jsonl"})),
                     folder, bus, {"timeout", "--preserve-status", "--signal=INT", "3"});
  const std::vector<Json> lines = test::linesOf(test::contentOf(folder / "out.jsonl"));
  EXPECT_GT(lines.size(), 0U) << outcome.err;
  test::expectPoses(lines, bus);
}
