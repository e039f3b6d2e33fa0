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
 * circle-marker-simulator without a window: scripts, true errors, the servo.
 */

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "json_lines.h"
#include "run_program.h"

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {
bool isSaid(const std::string &text, const std::string &part)
{
  return text.find(part) != std::string::npos;
}

/*! Runs a script; a line of JSON for each image. */
std::vector<Json> runScript(const std::string &script, const fs::path &folder,
                            const std::vector<std::string> &more = {})
{
  unsetenv("DISPLAY");
  std::ofstream(folder / "script.txt") << script;
  std::vector<std::string> arguments{"--display-off", "--script", "script.txt", "--json", "out.jsonl"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const test::Outcome outcome = test::run(SIMULATOR_PROGRAM, arguments, folder);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return test::linesOf(test::contentOf(folder / "out.jsonl"));
}

const Json *find(const Json &line, int id)
{
  for (const Json &marker : line["markers"]) {
    if (marker["id"] == id) {
      return &marker;
    }
  }
  return nullptr;
}
} // namespace

TEST(SimulatorProgram, MarkersAreFoundWithTheirTrueErrors)
{
  const fs::path folder = test::emptyFolder();
  const std::vector<Json> lines = runScript("wait 4\n", folder);
  ASSERT_EQ(lines.size(), 5U) << "one image at the start, four that are waited for";
  double squares = 0.;
  int count = 0;
  for (const Json &line : lines) {
    EXPECT_EQ(line["phantoms"], 0);
    const Json *window = find(line, 1); // straight ahead, at 4 m
    ASSERT_NE(window, nullptr);
    EXPECT_EQ((*window)["name"], "window");
    EXPECT_NEAR((*window)["distance_m"].get<double>(), 4., 0.02);
    ASSERT_TRUE((*window)["error_m"].is_number()) << line.dump();
    EXPECT_LT((*window)["error_m"].get<double>(), 0.02);
    EXPECT_GT((*window)["error_m"].get<double>(), 0.) << "noise differs from image to image";
    squares += std::pow((*window)["error_in_sigmas"].get<double>(), 2);
    ++count;
  }
  EXPECT_LT(std::sqrt(squares / count), 3.);
}

TEST(SimulatorProgram, KeysAndMouseMoveTheCamera)
{
  const fs::path folder = test::emptyFolder();
  const std::vector<Json> lines =
      runScript("key w 2 # twice 0.1 m\nkey d\nkey +\nkey e\nkey l\ndrag 1 100 0\nkey 0\n", folder);
  ASSERT_EQ(lines.size(), 8U);
  const auto pose = [&](std::size_t i) { return lines[i]["wMc"].get<std::vector<double>>(); };
  EXPECT_NEAR(pose(1)[11] - pose(0)[11], 0.2, 1e-9);           // z
  EXPECT_NEAR(pose(2)[3] - pose(1)[3], 0.1, 1e-9);             // x
  EXPECT_NEAR(pose(4)[7] - pose(3)[7], -0.2, 1e-9);            // up is -y, steps are twice as long
  EXPECT_NEAR(std::atan2(pose(5)[2], pose(5)[10]), 0.2, 1e-9); // the camera looks to the right
  // To drag the scene to the right is to look to the left; 100 of 600 pixels.
  EXPECT_NEAR(std::atan2(pose(6)[2], pose(6)[10]), 0.2 - std::atan(100. / 600.), 1e-9);
  EXPECT_EQ(pose(7), pose(0));
}

TEST(SimulatorProgram, NoiseBlurLightAndCoverAct)
{
  const fs::path folder = test::emptyFolder();
  const std::vector<Json> all =
      runScript("shot plain.png\nkey g 5\nshot dark.png\nkey G 5\nkey N 20\nshot noisy.png\nkey n 20\nkey V 5\nwait 1\n"
                "key v 9\nkey B 20\nwait 1\n",
                folder);
  ASSERT_FALSE(all.empty());
  const auto brightest = [&](const std::string &name) {
    const cv::Mat picture = cv::imread((folder / name).string(), 0);
    cv::Mat marker = picture(cv::Rect(300, 200, 200, 180)); // where the nearest one is, and no text
    cv::erode(marker, marker, cv::Mat());
    double most = 0.;
    cv::minMaxLoc(marker, nullptr, &most);
    return most;
  };
  EXPECT_NEAR(brightest("plain.png"), 220., 10.) << "paper";
  EXPECT_NEAR(brightest("dark.png"), 110., 10.) << "half of the light";
  const Json &covered = all[6];
  EXPECT_NEAR(covered["covered"].get<double>(), 0.5, 1e-9) << covered.dump();
  EXPECT_NEAR(all.back()["blur_pixels"].get<double>(), 4.7, 1e-9);
  EXPECT_TRUE((*find(covered, 1))["error_m"].is_null()) << "half of a marker is not read: " << covered.dump();
}

TEST(SimulatorProgram, ServoGoesInFrontOfTheNearestMarker)
{
  const fs::path folder = test::emptyFolder();
  const std::vector<Json> lines =
      runScript("key w 20\nkey d 2\nkey t\nwait 120\nshot end.png\n", folder, {"--distance", "0.6"});
  ASSERT_GT(lines.size(), 20U);
  EXPECT_TRUE(lines[3]["servo"].get<bool>());
  EXPECT_FALSE(lines.back()["servo"].get<bool>()) << "it has stopped";
  const Json *window = find(lines.back(), 1);
  ASSERT_NE(window, nullptr);
  EXPECT_NEAR((*window)["distance_m"].get<double>(), 0.6, 2e-3);
  EXPECT_LT((*window)["tilt_rad"].get<double>(), 0.01);
  EXPECT_FALSE(cv::imread((folder / "end.png").string()).empty());
}

TEST(SimulatorProgram, RoomsAreFilesToo)
{
  const fs::path folder = test::emptyFolder();
  const test::Outcome room = test::run(SIMULATOR_PROGRAM, {"--save-room", "room.json"}, folder);
  ASSERT_EQ(room.status, 0) << room.err;
  EXPECT_EQ(Json::parse(test::contentOf(folder / "room.json"))["markers"].size(), 10U);
  const std::vector<Json> own = runScript("wait 1\n", folder);
  const std::vector<Json> read = runScript("wait 1\n", folder, {"--database", "room.json"});
  EXPECT_EQ(own.back()["markers"].size(), read.back()["markers"].size());
  std::ofstream(folder / "bad.json") << "{\"markers\": [\n{\"family\": \"golay23\", \"id\": 500, \"size\": 0.1}]}";
  const test::Outcome bad = test::run(SIMULATOR_PROGRAM, {"--database", "bad.json"}, folder);
  EXPECT_EQ(bad.status, 1);
  EXPECT_TRUE(isSaid(bad.err, "line 2")) << bad.err;
}

// A lens with kdu = -0.2 folds over at 0.86 focal lengths from the axis: the charger is beyond that at the start, and
// others come there while the camera turns.
TEST(SimulatorProgram, MarkersBeyondWhatALensShowsAreNotDrawn)
{
  const fs::path folder = test::emptyFolder();
  std::ofstream(folder / "wide.xml")
      << "<?xml version=\"1.0\"?><root><camera><name>Camera</name><image_width>640</image_width>"
         "<image_height>480</image_height><model><type>perspectiveProjWithDistortion</type><px>500</px><py>500</py>"
         "<u0>319.5</u0><v0>239.5</v0><kud>0.2</kud><kdu>-0.2</kdu></model></camera></root>";
  const std::vector<Json> lines = runScript("wait 2\n", folder, {"--intrinsic", "wide.xml", "--camera-name", "Camera"});
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_NE(find(lines.back(), 1), nullptr);
}

TEST(SimulatorProgram, WrongArgumentsAndScriptsSayWhatToDo)
{
  const fs::path folder = test::emptyFolder();
  const test::Outcome blind = test::run(SIMULATOR_PROGRAM, {"--display-off"}, folder);
  EXPECT_EQ(blind.status, 2);
  EXPECT_TRUE(isSaid(blind.err, "add --script")) << blind.err;
  for (const auto &[line, words] : std::vector<std::pair<std::string, std::string>>{
           {"key w\njump\n", "line 2"}, {"key ?", "means nothing"}, {"key w -3", "line 1"}, {"drag 7 1 1", "line 1"}}) {
    std::ofstream(folder / "script.txt") << line;
    const test::Outcome outcome =
        test::run(SIMULATOR_PROGRAM, {"--display-off", "--script", "script.txt", "--json", "o.jsonl"}, folder);
    EXPECT_EQ(outcome.status, 1) << line;
    EXPECT_TRUE(isSaid(outcome.err, words)) << outcome.err;
    EXPECT_FALSE(fs::exists(folder / "o.jsonl"));
  }
}
