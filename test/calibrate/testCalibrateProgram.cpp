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
 * circle-marker-calibrate: true cameras are recovered, views that do not constrain them refused.
 */

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "circle_marker/common/camera_file.h"
#include "run_program.h"

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Words = std::vector<std::string>;

namespace {
const std::string data = CIRCLE_MARKER_DATA_DIR;
const Words circles{"--target", "circles", "--columns", "6", "--rows", "6", "--spacing", "0.03", "--diameter", "0.02"};

Words operator+(Words a, const Words &b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

bool isSaid(const std::string &text, const std::string &part)
{
  return text.find(part) != std::string::npos;
}

test::Outcome calibrate(const Words &arguments, const fs::path &folder)
{
  return test::run(CALIBRATE_PROGRAM, arguments, folder);
}

/*! Runs the program, which must be content, and reads its numbers. */
Json resultOf(const Words &arguments, const fs::path &folder)
{
  const test::Outcome outcome = calibrate(arguments + Words{"--json", "out.json"}, folder);
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  return outcome.status == 0 ? Json::parse(test::contentOf(folder / "out.json")) : Json();
}

void writeCamera(const vpCameraParameters &cam, unsigned int width, unsigned int height, const fs::path &file)
{
  const tutorial::SilentStream silentOutput(std::cout), silentErrors(std::cerr);
  vpXmlParserCamera().save(cam, file.string(), "Camera", width, height);
}

/*!
  A file as ROS writes it of a camera of 640 x 480 pixels, or OpenCV.
  \param matrix : Nine numbers.
  \param distortion : Its coefficients.
  \param model : Name of the distortion model in ROS; empty: the file is OpenCV's.
*/
void writeYaml(const fs::path &file, const std::string &matrix, const std::vector<std::string> &distortion,
               const std::string &model = "")
{
  const bool isOpenCv = model.empty();
  const auto list = [&](const char *name, int rows, std::size_t columns, const std::string &numbers) {
    return std::string(name) + (isOpenCv ? ": !!opencv-matrix\n" : ":\n") + "  rows: " + std::to_string(rows) +
           "\n  cols: " + std::to_string(columns) + (isOpenCv ? "\n  dt: d" : "") + "\n  data: [" + numbers + "]\n";
  };
  std::string numbers;
  for (const std::string &number : distortion) {
    numbers += (numbers.empty() ? "" : ", ") + number;
  }
  std::ofstream(file) << (isOpenCv ? "%YAML:1.0\n---\n" : "camera_name: left\n")
                      << "image_width: 640\nimage_height: 480\n"
                      << list("camera_matrix", 3, 3, matrix) << (isOpenCv ? "" : "distortion_model: " + model + "\n")
                      << list("distortion_coefficients", 1, distortion.size(), numbers);
}

/*!
  The true camera must lie within its standard deviations. Of n numbers the squared distance is one of chi square
  with n degrees of freedom, here divided by n: of four numbers its root is beyond 2.1 once in 700 times.
*/
void expectTruth(const Json &model)
{
  ASSERT_TRUE(model.contains("errors_in_sigmas")) << model.dump();
  const auto errors = model["errors_in_sigmas"].get<std::vector<double>>();
  EXPECT_LT(errors.back(), 2.1) << model.dump();
}

//! What vpDetectorCircleMarker::setCameraCovariance() takes: of px, py, u0 and v0, with the deviations that are told.
void expectCameraCovariance(const Json &model)
{
  const char *numbers[] = {"px", "py", "u0", "v0"};
  ASSERT_EQ(model["cameraCovariance"].size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    ASSERT_EQ(model["cameraCovariance"][i].size(), 4u);
    const double sigma = model["sigma"][numbers[i]];
    EXPECT_NEAR(model["cameraCovariance"][i][i].get<double>(), sigma * sigma, 1e-9 * sigma * sigma) << numbers[i];
  }
}
} // namespace

TEST(CalibrateProgram, CirclesByTheirTrueCentersGiveTheTrueCamera)
{
  const fs::path folder = test::emptyFolder();
  const Json result = resultOf(circles + Words{"--simulate", "6", "--seed", "5", "--model", "plain"}, folder);
  ASSERT_FALSE(result.is_null());
  const Json &model = result["models"][0];
  expectTruth(model);
  expectCameraCovariance(model);
  EXPECT_NEAR(model["camera"]["px"].get<double>(), 1600., 0.3);
  EXPECT_LT(model["rms_pixels"].get<double>(), 0.01);
  // The ellipses' centres are no such points.
  EXPECT_GT(model["greatest_center_offset_pixels"].get<double>(), 0.2);
  EXPECT_GT(model["by_ellipse_centers"]["errors_in_sigmas"].get<std::vector<double>>().back(), 5.);
  EXPECT_GT(model["by_ellipse_centers"]["rms_pixels"].get<double>(), model["rms_pixels"].get<double>());
}

TEST(CalibrateProgram, DistortionAndItsInverseAreRecovered)
{
  const fs::path folder = test::emptyFolder();
  const Words truth{"--truth", data + "/pictures/camera-wide.xml", "--truth-name", "Wide"};
  const Json result = resultOf(circles + truth +
                                   Words{"--simulate", "8", "--model", "distortion", "--output", "cam.xml",
                                         "--residuals", "r.svg", "--save-views", "img%02d.png"},
                               folder);
  ASSERT_FALSE(result.is_null());
  expectTruth(result["models"][0]);
  const tutorial::NamedCamera camera = tutorial::readCamera((folder / "cam.xml").string(), "Camera", 640, 480);
  EXPECT_EQ(camera.width, 640u);
  EXPECT_EQ(camera.parameters.get_projModel(), vpCameraParameters::perspectiveProjWithDistortion);
  EXPECT_NEAR(camera.parameters.get_px(), 560., 0.5);
  EXPECT_NEAR(camera.parameters.get_py(), 555., 0.5);
  EXPECT_NEAR(camera.parameters.get_kdu(), 0.24, 2e-3);
  // kud is the nearest to the inverse of kdu, which it cannot be exactly.
  EXPECT_NEAR(camera.parameters.get_kud(), -0.2, 0.04);
  EXPECT_TRUE(isSaid(test::contentOf(folder / "r.svg"), "</svg>"));

  // The same pictures as files give the same camera.
  const Json again = resultOf(circles + Words{"--input", "img%02d.png", "--model", "distortion"}, folder);
  ASSERT_FALSE(again.is_null());
  EXPECT_EQ(again["models"][0]["camera"], result["models"][0]["camera"]);

  // And as a live camera's, each twice: the target then stands still.
  std::ofstream list(folder / "list.txt");
  for (int i = 0; i < 8; ++i) {
    list << "img0" << i << ".png\nimg0" << i << ".png\n";
  }
  list.close();
  const test::Outcome live = calibrate(circles + Words{"--source", "@list.txt", "--views", "5", "--model", "distortion",
                                                       "--display-off", "--json", "live.json"},
                                       folder);
  EXPECT_EQ(live.status, 0) << live.out << live.err;
  EXPECT_TRUE(isSaid(live.err, "5 of 5 views")) << live.err;
}

TEST(CalibrateProgram, KannalaBrandtFromPartsOfASheetOfMarkers)
{
  const fs::path folder = test::emptyFolder();
  const test::Outcome sheet = test::run(
      CREATE_PROGRAM, {"--ids", "0-19", "--size", "0.03", "--per-sheet", "auto", "--output", "sheet.pdf"}, folder);
  ASSERT_EQ(sheet.status, 0) << sheet.err;
  std::ofstream(folder / "sheet.jsonl") << sheet.out;
  vpCameraParameters cam;
  cam.initProjWithKannalaBrandtDistortion(420., 421., 330., 236., {-0.03, 0.004, -0.002, 0.0003});
  writeCamera(cam, 640, 480, folder / "fisheye.xml");
  const Json result = resultOf({"--target", "markers", "--sheet", "sheet.jsonl", "--simulate", "8", "--truth",
                                "fisheye.xml", "--model", "kannala-brandt", "--output", "cam.xml"},
                               folder);
  ASSERT_FALSE(result.is_null());
  expectTruth(result["models"][0]);
  bool isPartial = false;
  for (const Json &view : result["models"][0]["views"]) {
    isPartial = isPartial || view["points"].get<int>() < 20;
  }
  EXPECT_TRUE(isPartial) << "some views show a part of the sheet only";
  const tutorial::NamedCamera camera = tutorial::readCamera((folder / "cam.xml").string(), "Camera", 640, 480);
  EXPECT_EQ(camera.parameters.get_projModel(), vpCameraParameters::ProjWithKannalaBrandtDistortion);
  EXPECT_NEAR(camera.parameters.get_px(), 420., 1.);
}

TEST(CalibrateProgram, AsymmetricGridAndChessboard)
{
  const fs::path folder = test::emptyFolder();
  const Json grid = resultOf({"--target", "asymmetric", "--columns", "4", "--rows", "9", "--spacing", "0.02",
                              "--diameter", "0.018", "--simulate", "6", "--seed", "2", "--model", "plain"},
                             folder);
  ASSERT_FALSE(grid.is_null());
  expectTruth(grid["models"][0]);
  const Json board = resultOf({"--target", "chessboard", "--columns", "8", "--rows", "6", "--spacing", "0.03",
                               "--simulate", "6", "--seed", "2", "--model", "plain"},
                              folder);
  ASSERT_FALSE(board.is_null());
  // OpenCV's corners have errors of their own that are no noise: see the residuals.
  EXPECT_NEAR(board["models"][0]["camera"]["px"].get<double>(), 1600., 1.5);
  EXPECT_LT(board["models"][0]["rms_pixels"].get<double>(), 0.06);
  EXPECT_FALSE(board["models"][0].contains("by_ellipse_centers"));
  // Higher than wide: the sheet has to hold it, too.
  const Json upright = resultOf({"--target", "chessboard", "--columns", "6", "--rows", "9", "--spacing", "0.03",
                                 "--simulate", "4", "--seed", "2", "--model", "plain"},
                                folder);
  EXPECT_FALSE(upright.is_null());
}

TEST(CalibrateProgram, ViewsThatSayTooLittleAreRefusedWithTheReason)
{
  const fs::path folder = test::emptyFolder();
  const test::Outcome frontal = calibrate(
      circles + Words{"--simulate", "4", "--tilts", "0", "0", "--model", "plain", "--output", "cam.xml"}, folder);
  EXPECT_EQ(frontal.status, 1);
  EXPECT_TRUE(isSaid(frontal.err, "nearly the same tilt in all views")) << frontal.err;
  EXPECT_TRUE(isSaid(frontal.err, "condition of the normal matrix")) << frontal.err;
  EXPECT_FALSE(fs::exists(folder / "cam.xml"));
  const test::Outcome few = calibrate(circles + Words{"--simulate", "2", "--output", "cam.xml"}, folder);
  EXPECT_EQ(few.status, 1);
  EXPECT_TRUE(isSaid(few.err, "2 views show the target; at least 3 are needed")) << few.err;
  const test::Outcome none =
      calibrate(circles + Words{"--input", data + "/pictures/golay23-id5.png", "--output", "cam.xml"}, folder);
  EXPECT_EQ(none.status, 1);
  EXPECT_TRUE(isSaid(none.err, "check --columns and --rows")) << none.err;
  EXPECT_FALSE(fs::exists(folder / "cam.xml"));
}

TEST(CalibrateProgram, RealPhotographsAsWellAsVisp)
{
  const char *given = std::getenv("VISP_INPUT_IMAGE_PATH");
  const fs::path images =
      fs::path(given != nullptr ? given : "/usr/share/visp-images-data") / "ViSP-images/calibration";
  if (!fs::exists(images / "grid36-01.pgm")) {
    GTEST_SKIP() << "visp-images-data is not installed";
  }
  const fs::path folder = test::emptyFolder();
  const Json result =
      resultOf(circles + Words{"--input", (images / "grid36-%02d.pgm").string(), "--compare-visp"}, folder);
  ASSERT_FALSE(result.is_null());
  for (const Json &model : result["models"]) {
    // Both take the least rms there is on the same points; ours has the circles' centres besides.
    const double ours = model["rms_pixels"], visp = model["visp_same_points"]["rms_pixels"];
    EXPECT_LT(ours, 1.01 * visp) << model.dump();
    EXPECT_LT(ours, 0.35);
    EXPECT_TRUE(model["visp_own_points"].contains("rms_pixels")) << model.dump();
    EXPECT_NEAR(model["camera"]["px"].get<double>(), model["visp_same_points"]["px"].get<double>(), 5.);
  }
}

TEST(CalibrateProgram, ReadsTheCamerasOfOpenCvAndRos)
{
  const fs::path folder = test::emptyFolder();
  writeYaml(folder / "opencv.yml", "600., 0., 320., 0., 601., 240., 0., 0., 1.", {"-0.1", "0.", "0.", "0.", "0."});
  const test::Outcome opencv =
      calibrate({"--convert", "opencv.yml", "--model", "distortion", "--output", "cam.xml"}, folder);
  ASSERT_EQ(opencv.status, 0) << opencv.err;
  const tutorial::NamedCamera camera = tutorial::readCamera((folder / "cam.xml").string(), "Camera", 640, 480);
  // OpenCV's first coefficient is ViSP's kud; kdu, which is fitted, is nearly its negative.
  EXPECT_NEAR(camera.parameters.get_kud(), -0.1, 0.01);
  EXPECT_NEAR(camera.parameters.get_kdu(), 0.11, 0.02);
  EXPECT_NEAR(camera.parameters.get_px(), 600., 1.);
  writeYaml(folder / "ros.yaml", "300.5, 0, 320, 0, 301, 240, 0, 0, 1", {"-0.02", "0.003", "0.0001", "0"},
            "equidistant");
  const test::Outcome ros =
      calibrate({"--convert", "ros.yaml", "--model", "kannala-brandt", "--output", "ros.xml"}, folder);
  ASSERT_EQ(ros.status, 0) << ros.err;
  const tutorial::NamedCamera fisheye = tutorial::readCamera((folder / "ros.xml").string(), "Camera", 640, 480);
  ASSERT_EQ(fisheye.parameters.get_projModel(), vpCameraParameters::ProjWithKannalaBrandtDistortion);
  EXPECT_NEAR(fisheye.parameters.get_px(), 300.5, 1e-3);
  EXPECT_NEAR(fisheye.parameters.getKannalaBrandtDistortionCoefficients()[0], -0.02, 1e-4);
  std::ofstream(folder / "bad.yaml") << "image_width: 640\n";
  const test::Outcome bad = calibrate({"--convert", "bad.yaml", "--output", "bad.xml"}, folder);
  EXPECT_EQ(bad.status, 1);
  EXPECT_TRUE(isSaid(bad.err, "camera_matrix")) << bad.err;
}

// r (1 - 0.9 r^2) is 0.4 at most: 120 pixels from the centre, and no ray is seen in the corners.
TEST(CalibrateProgram, DistortionThatFoldsTheImageIsRefused)
{
  const fs::path folder = test::emptyFolder();
  writeYaml(folder / "folded.yaml", "300, 0, 320, 0, 300, 240, 0, 0, 1", {"-0.9", "0", "0", "0"}, "plumb_bob");
  const test::Outcome folded =
      calibrate({"--convert", "folded.yaml", "--model", "distortion", "--output", "folded.xml"}, folder);
  EXPECT_EQ(folded.status, 1);
  EXPECT_TRUE(isSaid(folded.err, "cannot be undone")) << folded.err;
  EXPECT_FALSE(fs::exists(folder / "folded.xml"));
}

TEST(CalibrateProgram, WrongArgumentsSayWhatToDo)
{
  const fs::path folder = test::emptyFolder();
  const std::vector<std::pair<Words, std::string>> cases = {
      {{}, "add --input, --source or --simulate"},
      {{"--simulate", "5"}, "add --target"},
      {{"--simulate", "5", "--target", "circles"}, "--columns and --rows"},
      {{"--simulate", "5", "--target", "circles", "--columns", "5", "--rows", "5", "--spacing", "1"}, "--diameter"},
      {{"--simulate", "5", "--target", "circles", "--columns", "5", "--rows", "5", "--spacing", "0.02", "--diameter",
        "0.03"},
       "overlap"},
      {{"--simulate", "5", "--target", "markers"}, "--sheet"},
      {circles + Words{"--simulate", "5", "--model", "pinhole"}, "--model takes"},
      {circles + Words{"--simulate", "5", "--model", ""}, "--model is empty"},
      {circles + Words{"--simulate", "5", "--model", "plain,plain"}, "each once"},
      {circles + Words{"--simulate", "5", "--output", "other.xml"}, "would be lost"},
      {circles + Words{"--simulate", "5", "--input", "a.png"}, "exclude each other"},
      {{"--convert", "a.yaml"}, "--convert needs --output"},
  };
  std::ofstream(folder / "other.xml") << "<root><camera><name>Left</name></camera></root>\n";
  for (const auto &[arguments, words] : cases) {
    const test::Outcome outcome = calibrate(arguments, folder);
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_EQ(outcome.err.rfind("circle-marker-calibrate: ", 0), 0u) << outcome.err;
    EXPECT_TRUE(isSaid(outcome.err, words)) << outcome.err;
  }
}
