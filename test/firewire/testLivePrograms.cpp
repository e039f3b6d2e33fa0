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
 * The live programs without any camera: recordings, wrong arguments, the robot that stands in.
 */

#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#ifdef HAVE_VIDEOIO
#include <opencv2/videoio.hpp>
#endif

#include "live_run.h"

namespace fs = std::filesystem;
using test::Json;

namespace {
const std::string data = CIRCLE_MARKER_DATA_DIR;
const std::string referencePicture = data + "/pictures/golay23-id5.png";

bool isSaid(const std::string &text, const std::string &part)
{
  return text.find(part) != std::string::npos;
}

test::Outcome runLive(const std::vector<std::string> &more, const fs::path &folder)
{
  std::vector<std::string> arguments = test::liveArguments({"--display-off"});
  arguments.insert(arguments.end(), more.begin(), more.end());
  return test::runOnBus(LIVE_PROGRAM, arguments, folder, nullptr);
}
} // namespace

TEST(LivePrograms, RecordedImagesGiveTheDetectorsLines)
{
  const fs::path folder = test::emptyFolder();
  for (const std::string name : {"img3.png", "img5.png"}) {
    fs::copy_file(referencePicture, folder / name);
  }
  const test::Outcome live = runLive({"--source", "img%d.png"}, folder);
  ASSERT_EQ(live.status, 0) << live.err;
  const std::vector<Json> lines = test::linesOf(live.out);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[1]["image"], "img5.png");
  const test::Outcome still =
      test::run(DETECTOR_PROGRAM, test::liveArguments({"--display-off", "--input", "img%d.png"}), folder);
  const std::vector<Json> expected = test::linesOf(still.out);
  ASSERT_EQ(expected.size(), 2U);
  EXPECT_EQ(lines[0]["markers"], expected[0]["markers"]);
  EXPECT_TRUE(lines[0]["latency_ms"].is_null());
}

TEST(LivePrograms, UnreadableImageOfARecordingIsLeftOut)
{
  const fs::path folder = test::emptyFolder();
  fs::copy_file(referencePicture, folder / "img1.png");
  std::ofstream(folder / "img2.png") << "no picture";
  const test::Outcome outcome = runLive({"--source", "img%d.png", "--json", "o.jsonl"}, folder);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_TRUE(isSaid(outcome.err, "tutorial-circle-marker-detector-live: \"img2.png\" is left out")) << outcome.err;
  EXPECT_EQ(test::linesOf(test::contentOf(folder / "o.jsonl")).size(), 1U);
}

TEST(LivePrograms, OpenCvReadsWhatItIsGiven)
{
  const fs::path folder = test::emptyFolder();
  for (const std::string name : {"img0000.png", "img0001.png"}) {
    fs::copy_file(referencePicture, folder / name);
  }
  const test::Outcome outcome = runLive({"--source", "opencv:img%04d.png"}, folder);
  if (isSaid(outcome.err, "built without OpenCV's cameras")) {
    GTEST_SKIP() << outcome.err;
  }
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<Json> lines = test::linesOf(outcome.out);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[1]["image"], "opencv:img%04d.png#1");
  ASSERT_EQ(lines[1]["markers"].size(), 1U);
  EXPECT_EQ(lines[1]["markers"][0]["id"], 5);
}

#ifdef HAVE_VIDEOIO
namespace {
/*! The reference picture three times as a video; false: this OpenCV writes none. */
bool writeVideo(const fs::path &file)
{
  const cv::Mat picture = cv::imread(referencePicture);
  cv::VideoWriter writer(file.string(), cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 15., picture.size());
  for (int i = 0; i < 3 && writer.isOpened(); ++i) {
    writer.write(picture);
  }
  return writer.isOpened();
}
} // namespace

TEST(LivePrograms, OpenCvReadsVideosToTheirEnd)
{
  const fs::path folder = test::emptyFolder();
  if (!writeVideo(folder / "video.avi")) {
    GTEST_SKIP() << "OpenCV writes no video here";
  }
  const test::Outcome outcome = runLive({"--source", "opencv:video.avi"}, folder);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<Json> lines = test::linesOf(outcome.out);
  ASSERT_EQ(lines.size(), 3U);
  ASSERT_EQ(lines[2]["markers"].size(), 1U);
  EXPECT_EQ(lines[2]["markers"][0]["id"], 5);
  EXPECT_TRUE(lines[2]["latency_ms"].is_null()) << "nobody knows when it was taken";
}

TEST(LivePrograms, OpenCvStreamsAreLiveAndTheirEndIsAFailure)
{
  const fs::path folder = test::emptyFolder();
  if (!writeVideo(folder / "video.avi")) {
    GTEST_SKIP() << "OpenCV writes no video here";
  }
  const std::string address = "opencv:file://" + (folder / "video.avi").string();
  const test::Outcome outcome = runLive({"--source", address, "--all-images"}, folder);
  if (isSaid(outcome.err, "OpenCV cannot open the camera")) {
    GTEST_SKIP() << "this OpenCV opens no addresses";
  }
  // A camera's images do not end.
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_TRUE(isSaid(outcome.err, "delivers no images")) << outcome.err;
  const std::vector<Json> lines = test::linesOf(outcome.out);
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_TRUE(lines[0]["latency_ms"].is_number());
}
#endif

TEST(LivePrograms, CamerasThatAreNotThere)
{
  const fs::path folder = test::emptyFolder();
  const std::pair<std::string, std::string> cases[] = {{"v4l2:/dev/video99", "there is no such device"},
                                                       {"v4l2:/dev/null", "it is no V4L2 device"},
                                                       {"v4l2:" + referencePicture, "it is no V4L2 device"},
                                                       {"opencv:99", "OpenCV cannot open the camera"},
                                                       {"nosuch%d.png", "no file is named like"},
                                                       {"/nosuch/file.avi", "there is no file"}};
  for (const auto &[source, part] : cases) {
    const test::Outcome outcome = runLive({"--source", source}, folder);
    EXPECT_EQ(outcome.status, 1) << source << outcome.err;
    EXPECT_TRUE(isSaid(outcome.err, part) || isSaid(outcome.err, "built without")) << outcome.err;
    EXPECT_TRUE(isSaid(outcome.err, "tutorial-circle-marker-detector-live: ")) << outcome.err;
  }
}

TEST(LivePrograms, WrongArgumentsEndWithTwo)
{
  const fs::path folder = test::emptyFolder();
  const std::vector<std::vector<std::string>> live = {
      {"--nosuchoption"},
      {"--source", "img%d.png", "--video-mode", "1280x960_mono8"},
      {"--source", "v4l2", "--framerate", "15"},
      {"--source", "v4l2", "--image-size", "1280"},
      {"--source", "img%d.png", "--image-size", "12x13"},
      {"--image-size", "640x480"},
      {"--format7-roi", "0,0,640,480"},
      {"--video-mode", "format7_0", "--format7-roi", "0,0,640"},
      {"--video-mode", "format7_0", "--format7-roi", "0,0,0,0"},
      {"--video-mode", "format7_0", "--framerate", "15"},
      {"--shutter", "much"},
      {"--framerate", "-1"},
      {"--record", "one-name.png"},
      {"--timeout", "0"},
      {"--count", "0"},
      {"--family", "nosuch"},
  };
  for (const std::vector<std::string> &arguments : live) {
    const test::Outcome outcome = runLive(arguments, folder);
    EXPECT_EQ(outcome.status, 2) << ::testing::PrintToString(arguments) << outcome.err;
    EXPECT_EQ(outcome.err.rfind("tutorial-circle-marker-detector-live: ", 0), 0U) << outcome.err;
  }
  const std::vector<std::vector<std::string>> servo = {
      {"--nosuchoption"},        {"--source", "firewire"}, {"--distance", "-1"},  {"--size", "0"},
      {"--max-speed", "100"},    {"--max-speed", "nan"},   {"--max-turn", "nan"}, {"--timeout", "nan"},
      {"--accept-angle", "nan"}, {"--id", "-3"},           {"--family", "bch31"}};
  for (std::vector<std::string> arguments : servo) {
    arguments.push_back("--display-off");
    const test::Outcome outcome = test::runOnBus(SERVO_PROGRAM, arguments, folder, nullptr);
    EXPECT_EQ(outcome.status, 2) << ::testing::PrintToString(arguments) << outcome.err;
    EXPECT_EQ(outcome.err.rfind("tutorial-circle-marker-pbvs-live: ", 0), 0U) << outcome.err;
  }
  EXPECT_TRUE(test::filesIn(folder).empty());
}

TEST(LivePrograms, HelpNamesEveryOption)
{
  const fs::path folder = test::emptyFolder();
  const test::Outcome live = test::runOnBus(LIVE_PROGRAM, {"--help"}, folder, nullptr);
  EXPECT_EQ(live.status, 0);
  for (const std::string option : {"--source", "--video-mode", "--framerate", "--format7-roi", "--shutter", "--gain",
                                   "--record", "--list-cameras", "--display-off", "--timeout"}) {
    EXPECT_TRUE(isSaid(live.out, option)) << option;
  }
  EXPECT_EQ(test::runOnBus(SERVO_PROGRAM, {"--help"}, folder, nullptr).status, 0);
  EXPECT_EQ(test::runOnBus(LIVE_PROGRAM, {"--list-cameras"}, folder, nullptr).status, 0);
}

TEST(LivePrograms, WithoutADisplayTheDetectorGoesOn)
{
  const fs::path folder = test::emptyFolder();
  const test::Outcome outcome = test::runOnBus(
      "env",
      [] {
        std::vector<std::string> arguments = {"-u", "DISPLAY", LIVE_PROGRAM};
        const std::vector<std::string> more = test::liveArguments({"--source", referencePicture, "--json", "o.jsonl"});
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
      }(),
      folder, nullptr);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(isSaid(outcome.err, "no window can be opened")) << outcome.err;
  EXPECT_EQ(test::linesOf(test::contentOf(folder / "o.jsonl")).size(), 1U);
}

TEST(LivePrograms, ServoWithTheRobotThatStandsIn)
{
  const fs::path folder = test::emptyFolder();
  const test::Outcome outcome = test::runOnBus(
      SERVO_PROGRAM, {"--display-off", "--output", ".", "--max-speed", "2", "--max-turn", "90"}, folder, nullptr);
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_TRUE(isSaid(outcome.out, "true pose at the end")) << outcome.out;
  EXPECT_TRUE(isSaid(outcome.out, ": converged")) << outcome.out;
  EXPECT_TRUE(isSaid(test::contentOf(folder / "servo.svg"), "</svg>"));
  EXPECT_EQ(cv::imread((folder / "overlay-final.png").string()).size(), cv::Size(1280, 960));
}

TEST(LivePrograms, ServoOnARecordingIsADryRun)
{
  const fs::path folder = test::emptyFolder();
  const test::Outcome outcome = test::runOnBus(
      SERVO_PROGRAM, test::liveArguments({"--display-off", "--source", referencePicture, "--output", "."}), folder,
      nullptr);
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_TRUE(isSaid(outcome.err, "no robot was supplied")) << outcome.err;
  EXPECT_TRUE(isSaid(outcome.err, "there are no more images")) << outcome.err;
}

// As where ViSP was built without libdc1394, libv4l, X11 and OpenCV: the programs are there and say what is missing.
TEST(LivePrograms, BuiltWithoutCamerasAndDisplay)
{
  const fs::path folder = test::emptyFolder();
  const std::pair<std::string, std::string> cases[] = {{"firewire", "apt-get install libdc1394-dev"},
                                                       {"v4l2", "apt-get install libv4l-dev"},
                                                       {"opencv", "apt-get install libopencv-videoio-dev"}};
  for (const auto &[source, part] : cases) {
    const test::Outcome outcome =
        test::runOnBus(LIVE_WITHOUT, test::liveArguments({"--source", source, "--display-off"}), folder, nullptr);
    EXPECT_EQ(outcome.status, 1) << outcome.err;
    EXPECT_TRUE(isSaid(outcome.err, part)) << outcome.err;
  }
  const test::Outcome list = test::runOnBus(LIVE_WITHOUT, {"--list-cameras"}, folder, nullptr);
  EXPECT_TRUE(isSaid(list.out, "no FireWire camera: this program was built without FireWire")) << list.out;
  const test::Outcome noWindow = test::runOnBus(
      LIVE_WITHOUT, test::liveArguments({"--source", referencePicture, "--json", "o.jsonl"}), folder, nullptr);
  EXPECT_EQ(noWindow.status, 0) << noWindow.err;
  EXPECT_TRUE(isSaid(noWindow.err, "this ViSP was built without a display")) << noWindow.err;
  EXPECT_EQ(test::linesOf(test::contentOf(folder / "o.jsonl")).size(), 1U);
  const test::Outcome servo = test::runOnBus(SERVO_WITHOUT, {"--output", "out"}, folder, nullptr);
  EXPECT_EQ(servo.status, 2);
  EXPECT_TRUE(isSaid(servo.err, "--display-off starts at once")) << servo.err;
}

// udev ignores a line that it cannot read, and says so only in its log.
TEST(LivePrograms, UdevRulesAreWellFormed)
{
  std::ifstream file(data + "/udev/60-circle-marker-cameras.rules");
  const std::string term = "[A-Z]+(\\{[A-Za-z]+\\})?(==|=|\\+=)\"[^\"]*\"";
  const std::regex rule(term + "(, " + term + ")*");
  int rules = 0;
  std::string line;
  while (std::getline(file, line)) {
    if (line.empty() || line[0] == '#') {
      continue;
    }
    ++rules;
    EXPECT_TRUE(std::regex_match(line, rule)) << line;
    EXPECT_TRUE(isSaid(line, "GROUP=\"video\"") && isSaid(line, "TAG+=\"uaccess\"")) << line;
  }
  EXPECT_EQ(rules, 3) << "IEEE 1394 of two kinds, and USB";
}
