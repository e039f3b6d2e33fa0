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
 * Calibration of a live camera: views taken by keys, clicks and by themselves, in an X server without a screen.
 */

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <visp3/core/vpHomogeneousMatrix.h>

#include "circle_marker/common/camera_file.h"
#include "live_run.h"
#include "screen.h"

namespace fs = std::filesystem;
using test::Json;

namespace {
/*! Twelve markers in rows of four, around the middle of a sheet: the lines that circle-marker-create prints. */
Json sheetOfTwelve()
{
  constexpr double size = 0.05, spacing = 0.065; // metres
  Json sheet = Json::array();
  for (int id = 0; id < 12; ++id) {
    sheet.push_back({{"family", "golay23"},
                     {"id", id},
                     {"size_m", size},
                     {"center_m", {spacing * (id % 4 - 1.5), spacing * (id / 4 - 1.)}}});
  }
  return sheet;
}

/*!
  Poses of the sheet as a hand holds it, each of them for so many images: 0.55 m away, where it takes half of the
  image's width, tilted by 20 to 40 degrees. Steps by irrational shares of a turn: no pose comes again, neighbours are
  far apart.
*/
std::vector<std::vector<double>> posesOfASheet(int count, int imagesOfEach)
{
  constexpr double golden = 0.61803398875, root = 0.41421356237;
  std::vector<std::vector<double>> poses;
  for (int i = 0; i < count; ++i) {
    const double direction = 2. * M_PI * golden * i, place = 2. * M_PI * root * i;
    const double tilt = (30. + 10. * std::sin(1. + i)) * M_PI / 180.;
    const vpHomogeneousMatrix cMo(
        vpTranslationVector(0.07 * std::cos(place), 0.04 * std::sin(place), 0.55),
        vpRotationMatrix(vpThetaUVector(tilt * std::cos(direction), tilt * std::sin(direction), 0.)));
    poses.insert(poses.end(), static_cast<std::size_t>(imagesOfEach), std::vector<double>(cMo.data, cMo.data + 16));
  }
  return poses;
}

/*!
  Calibrates with the sheet before a FireWire camera of 640 x 480 pixels, with these actions. Images come as fast as
  they are drawn: a machine with much else to do sees the same sequence, slower.
*/
test::Outcome calibrate(const fs::path &folder, const Json &poses, const std::vector<std::string> &actions,
                        const std::vector<std::string> &more)
{
  Json bus = test::chameleonBus();
  bus["sheet"] = sheetOfTwelve();
  bus["poses"] = poses;
  const fs::path sheet = folder.string() + ".sheet.jsonl";
  test::writeLines(sheet, bus["sheet"]);
  std::vector<std::string> before = {IN_X_SERVER,   folder.string(), "bash",
                                     WINDOW_SCRIPT, folder.string(), "Camera calibration"};
  before.insert(before.end(), actions.begin(), actions.end());
  before.push_back("--");
  std::vector<std::string> arguments = {"--target",   "markers",      "--sheet",       sheet.string(), "--source",
                                        "firewire:0", "--video-mode", "640x480_mono8", "--framerate",  "15",
                                        "--model",    "plain",        "--output",      "camera.xml",   "--json",
                                        "out.json",   "--save-views", "views/%02d.png"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  fs::create_directory(folder / "views");
  return test::runOnBus(CALIBRATE_PROGRAM, arguments, folder, bus, before);
}

/*! camera.xml must have the camera of the bus, with a focal length of 800 pixels. */
void expectCameraOfTheBus(const fs::path &folder)
{
  const tutorial::NamedCamera camera = tutorial::readCamera((folder / "camera.xml").string(), "Camera", 640, 480);
  const Json model = Json::parse(test::contentOf(folder / "out.json"))["models"][0];
  // Four numbers within 4.5 standard deviations: once in 30000 runs not.
  EXPECT_NEAR(camera.parameters.get_px(), 800., 4.5 * model["sigma"]["px"].get<double>()) << model.dump();
  EXPECT_NEAR(camera.parameters.get_py(), 800., 4.5 * model["sigma"]["py"].get<double>()) << model.dump();
  EXPECT_NEAR(camera.parameters.get_u0(), 319.5, 4.5 * model["sigma"]["u0"].get<double>()) << model.dump();
  EXPECT_NEAR(camera.parameters.get_v0(), 239.5, 4.5 * model["sigma"]["v0"].get<double>()) << model.dump();
  EXPECT_LT(model["sigma"]["px"].get<double>(), 2.) << "such views constrain a camera";
}
} // namespace

TEST(LiveCalibration, SpaceAndLeftClickTakeViewsOfAMovingSheetAndARightClickEnds)
{
  const fs::path folder = test::emptyFolder();
  const test::Outcome outcome =
      calibrate(folder, posesOfASheet(400, 1),
                {"wait:1", "shot:before", "key:space", "wait:1", "key:space", "wait:1", "key:space", "wait:1",
                 "click:1", "wait:1", "click:1", "wait:1", "click:1", "wait:1", "shot:after", "click:3"},
                {"--views", "10"});
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.err.find("6 of 10 views"), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find("7 of 10 views"), std::string::npos) << outcome.err;
  EXPECT_EQ(test::filesIn(folder / "views").size(), 6U);
  const test::Screen before = test::readScreen(folder / "before.xwd"), after = test::readScreen(folder / "after.xwd");
  EXPECT_GT(before.grey, 640U * 480U / 4) << "the image is shown";
  EXPECT_GT(before.green, 100U) << "the markers that were found are marked";
  EXPECT_GT(after.green, 100U);
  expectCameraOfTheBus(folder);
}

TEST(LiveCalibration, ViewsAreTakenByThemselvesWhereTheSheetIsHeldStill)
{
  const fs::path folder = test::emptyFolder();
  const test::Outcome outcome = calibrate(folder, posesOfASheet(12, 15), {}, {"--views", "5"});
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.err.find("5 of 5 views"), std::string::npos) << outcome.err;
  EXPECT_EQ(test::filesIn(folder / "views").size(), 5U) << "one of each pose, and no more";
  expectCameraOfTheBus(folder);
}

TEST(LiveCalibration, EndedBeforeThereAreEnoughViewsNothingIsWritten)
{
  const fs::path folder = test::emptyFolder();
  const test::Outcome outcome =
      calibrate(folder, posesOfASheet(400, 1), {"wait:1", "key:space", "wait:1", "key:q"}, {"--views", "10"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("1 views show the target; at least 3 are needed"), std::string::npos) << outcome.err;
  EXPECT_FALSE(fs::exists(folder / "camera.xml"));
}
