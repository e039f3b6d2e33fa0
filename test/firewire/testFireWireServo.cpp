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
 * The servo with a FireWire camera and a robot that the user supplies.
 */

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "live_run.h"

namespace fs = std::filesystem;
using test::Json;

namespace {
/*! The scenario whose camera the robot moves. */
Json busOfRobot(const fs::path &folder)
{
  Json bus = test::chameleonBus();
  bus["pose_file"] = (folder / "robot").string();
  bus["size"] = 0.12;
  return bus;
}

test::Outcome servo(const Json &bus, const fs::path &folder, const std::vector<std::string> &more = {})
{
  std::vector<std::string> arguments = {
      "--source",        "firewire:0", "--video-mode", "1280x960_mono8",
      "--framerate",     "15",         "--intrinsic",  std::string(CIRCLE_MARKER_DATA_DIR) + "/camera.xml",
      "--size",          "0.12",       "--id",         "5",
      "--robot-address", "robot",      "--output",     "out",
      "--display-off"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return test::runOnBus(SERVO_WITH_ROBOT, arguments, folder, bus);
}

std::vector<double> numbersOf(const std::string &text)
{
  std::istringstream in(text);
  std::vector<double> numbers;
  double number = 0.;
  while (in >> number) {
    numbers.push_back(number);
  }
  return numbers;
}

/*! The velocities that the robot was sent, one after the other. */
std::vector<std::vector<double>> velocities(const fs::path &folder)
{
  std::istringstream in(test::contentOf(folder / "robot.log"));
  std::vector<std::vector<double>> all;
  std::string line;
  while (std::getline(in, line)) {
    const std::vector<double> numbers = numbersOf(line);
    if (numbers.size() == 6) {
      all.push_back(numbers);
    }
  }
  return all;
}
} // namespace

TEST(FireWireServo, BringsTheCameraWhereItShouldBe)
{
  const fs::path folder = test::emptyFolder();
  const test::Outcome outcome = servo(busOfRobot(folder), folder);
  ASSERT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("measured pose at the end"), std::string::npos) << outcome.out;
  // Where the robot really is, which the program does not know.
  const std::vector<double> cMo = numbersOf(test::contentOf(folder / "robot"));
  ASSERT_EQ(cMo.size(), 16U);
  const std::vector<double> desired = {1., 0., 0., 0., 0., 1., 0., 0., 0., 0., 1., 0.5, 0., 0., 0., 1.};
  const test::PoseDistance distance = test::poseDistance(cMo, desired);
  EXPECT_LT(distance.metres, 1e-3);
  EXPECT_LT(distance.degrees, 0.1);
  const auto all = velocities(folder);
  ASSERT_GT(all.size(), 20U);
  for (const std::vector<double> &velocity : all) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_LE(std::abs(velocity[axis]), 0.2 * 1.0001) << "--max-speed";
    }
  }
  EXPECT_EQ(all.back(), std::vector<double>(6, 0.)) << "the robot is left standing";
  EXPECT_NE(test::contentOf(folder / "out/servo.svg").find("</svg>"), std::string::npos);
}

TEST(FireWireServo, StandsStillWhenImagesStopComing)
{
  const fs::path folder = test::emptyFolder();
  Json bus = busOfRobot(folder);
  bus["silent_at"] = 25;
  const test::Outcome outcome = servo(bus, folder, {"--timeout", "1"});
  EXPECT_EQ(outcome.status, 1) << outcome.out;
  EXPECT_NE(outcome.err.find("no image came from firewire:0 for 1 s"), std::string::npos) << outcome.err;
  const auto all = velocities(folder);
  ASSERT_GT(all.size(), 3U);
  // Once when the image was late, long before the program gave up, and once at the end.
  EXPECT_EQ(all[all.size() - 2], std::vector<double>(6, 0.));
  EXPECT_EQ(all[all.size() - 1], std::vector<double>(6, 0.));
  EXPECT_NE(all[all.size() - 3], std::vector<double>(6, 0.));
}

TEST(FireWireServo, StandsStillWhenTheCameraIsUnplugged)
{
  const fs::path folder = test::emptyFolder();
  Json bus = busOfRobot(folder);
  bus["unplug_at"] = 25;
  const test::Outcome outcome = servo(bus, folder);
  EXPECT_EQ(outcome.status, 1) << outcome.out;
  EXPECT_NE(outcome.err.find("was it unplugged"), std::string::npos) << outcome.err;
  const auto all = velocities(folder);
  ASSERT_GT(all.size(), 3U);
  EXPECT_EQ(all.back(), std::vector<double>(6, 0.));
}

TEST(FireWireServo, RobotThatCannotBeUsedIsSaid)
{
  const fs::path folder = test::emptyFolder();
  const test::Outcome without = test::runOnBus(SERVO_WITH_ROBOT, {"--display-off"}, folder, nullptr);
  EXPECT_EQ(without.status, 1);
  EXPECT_NE(without.err.find("the robot needs --robot-address"), std::string::npos) << without.err;
  // The simulated camera belongs to the robot that stands in.
  const test::Outcome simulated =
      test::runOnBus(SERVO_WITH_ROBOT, {"--display-off", "--robot-address", "robot"}, folder, nullptr);
  EXPECT_EQ(simulated.status, 2);
  EXPECT_NE(simulated.err.find("add --source"), std::string::npos) << simulated.err;
}
