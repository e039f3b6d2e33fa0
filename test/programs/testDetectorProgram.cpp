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
 * The contract of tutorial-circle-marker-detector, from outside: what it says of markers.
 */

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "detector_program.h"

namespace fs = std::filesystem;
using namespace detector_program_test;

namespace {
Json readJson(const std::string &path)
{
  std::ifstream file(path);
  return Json::parse(file);
}

void expectFiniteNumbers(const Json &list, std::size_t size, const std::string &what)
{
  ASSERT_EQ(list.size(), size) << what;
  for (const Json &number : list) {
    ASSERT_TRUE(number.is_number() && std::isfinite(number.get<double>())) << what << " has " << number;
  }
}

/*! Angle of the rotation between two poses, degrees. */
double angleBetween(const Json &a, const Json &b)
{
  double trace = 0.;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      trace += a[4 * row + column].get<double>() * b[4 * row + column].get<double>();
    }
  }
  return std::acos(std::min(1., 0.5 * (trace - 1.))) * 180. / M_PI;
}

const Json *markerOf(const Json &line, const std::string &family, int id)
{
  for (const Json &marker : line["markers"]) {
    if (marker["family"] == family && marker["id"] == id) {
      return &marker;
    }
  }
  return nullptr;
}

/*! Bounds in metres, degrees and pixels. */
struct Bounds
{
  double lateral, depth, angle, center;
};

/*! Every marker of the truth, and no other, is in the line, within the bounds. */
void expectTruth(const Json &line, const Json &truth, const Bounds &bounds)
{
  EXPECT_EQ(line["width"], truth["width"]);
  EXPECT_EQ(line["height"], truth["height"]);
  EXPECT_EQ(line["markers"].size(), truth["markers"].size());
  for (const Json &expected : truth["markers"]) {
    const Json *marker = markerOf(line, expected["family"], expected["id"]);
    ASSERT_NE(marker, nullptr) << expected["family"] << " " << expected["id"] << " was not found";
    const Json &cMo = (*marker)["cMo"], &trueCMo = expected["cMo"];
    for (const int element : {3, 7, 11}) {
      EXPECT_NEAR(cMo[element].get<double>(), trueCMo[element].get<double>(),
                  element == 11 ? bounds.depth : bounds.lateral)
          << expected["id"] << " element " << element;
    }
    EXPECT_LT(angleBetween(cMo, trueCMo), bounds.angle) << expected["id"];
    for (const int axis : {0, 1}) {
      EXPECT_NEAR((*marker)["center"][axis].get<double>(), expected["center"][axis].get<double>(), bounds.center);
    }
  }
}
} // namespace

TEST(DetectorProgram, EveryFieldOfTheContractIsThere)
{
  const fs::path folder = test::emptyFolder();
  const test::Outcome outcome =
      test::run(DETECTOR_PROGRAM, reference(referencePicture, {"--json", "out.jsonl"}), folder);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(test::filesIn(folder), std::vector<std::string>{"out.jsonl"});
  const std::vector<Json> lines = linesOf(test::contentOf(folder / "out.jsonl"));
  ASSERT_EQ(lines.size(), 1U);
  const Json &line = lines[0];
  EXPECT_EQ(line["image"], referencePicture);
  EXPECT_GT(line["cpu_ms"].get<double>(), 0.);
  ASSERT_EQ(line["markers"].size(), 1U);
  const Json &marker = line["markers"][0];
  EXPECT_EQ(marker["family"], "golay23");
  EXPECT_EQ(marker["id"], 5);
  EXPECT_EQ(marker["hamming"], 0);
  EXPECT_EQ(marker["dof"], 6);
  EXPECT_EQ(marker["size_m"], 0.18);
  EXPECT_GT(marker["margin"].get<double>(), 0.5);
  EXPECT_GT(marker["visible"].get<double>(), 0.9);
  EXPECT_LE(marker["visible"].get<double>(), 1.);
  EXPECT_GT(marker["log_odds"].get<double>(), 0.);
  expectFiniteNumbers(marker["center"], 2, "center");
  expectFiniteNumbers(marker["ellipse"]["center"], 2, "ellipse.center");
  expectFiniteNumbers(marker["ellipse"]["semi_axes"], 2, "ellipse.semi_axes");
  EXPECT_TRUE(marker["ellipse"]["angle"].is_number());
  expectFiniteNumbers(marker["cMo"], 16, "cMo");
  expectFiniteNumbers(marker["cMo2"], 16, "cMo2");
  expectFiniteNumbers(marker["covariance"], 36, "covariance");
}

TEST(DetectorProgram, PoseOfTheReferencePicture)
{
  const test::Outcome outcome = test::run(DETECTOR_PROGRAM, reference(referencePicture), test::emptyFolder());
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<Json> lines = linesOf(outcome.out);
  ASSERT_EQ(lines.size(), 1U);
  // About five times the standard deviations at 1.6 m with a ring of 180 pixels: 0.01 mm, 0.03 mm, 0.003 degrees.
  expectTruth(lines[0], readJson(data + "/pictures/golay23-id5.json"), Bounds{5e-5, 1.5e-4, 0.02, 0.02});
  const Json ellipse = readJson(data + "/pictures/golay23-id5.json")["markers"][0]["ellipse"];
  for (const int axis : {0, 1}) {
    EXPECT_NEAR(lines[0]["markers"][0]["ellipse"]["semi_axes"][axis].get<double>(),
                ellipse["semi_axes"][axis].get<double>(), 0.02);
  }
}

TEST(DetectorProgram, SeveralFamiliesThroughALensWithDistortion)
{
  // The words of bch31r are words of bch31 as well: the stricter family is asked first.
  const test::Outcome outcome =
      test::run(DETECTOR_PROGRAM, wide(widePicture, {"--family", "golay23,bch31r,bch31"}), test::emptyFolder());
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<Json> lines = linesOf(outcome.out);
  ASSERT_EQ(lines.size(), 1U);
  // Rings of 65 to 95 pixels, f = 560 pixels, 1.1 m away.
  expectTruth(lines[0], readJson(data + "/pictures/wide-families.json"), Bounds{1e-4, 5e-4, 0.2, 0.05});
}

TEST(DetectorProgram, SizesOfSingleMarkers)
{
  const test::Outcome outcome =
      test::run(DETECTOR_PROGRAM, reference(referencePicture, {"--sizes", "4:1,5:0.36"}), test::emptyFolder());
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json marker = linesOf(outcome.out).at(0)["markers"][0];
  EXPECT_EQ(marker["size_m"], 0.36);
  EXPECT_NEAR(marker["cMo"][11].get<double>(), 3.2, 1e-3);
}

TEST(DetectorProgram, TrackingFindsTheSame)
{
  const fs::path folder = test::emptyFolder();
  for (int i = 0; i < 6; ++i) {
    fs::copy_file(widePicture, folder / ("img" + std::to_string(i) + ".png"));
  }
  const test::Outcome outcome = test::run(DETECTOR_PROGRAM, wide("img%d.png", {"--tracking", "4"}), folder);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<Json> lines = linesOf(outcome.out);
  ASSERT_EQ(lines.size(), 6U);
  for (const Json &line : lines) {
    ASSERT_EQ(line["markers"].size(), 2U);
    for (const std::size_t i : {0U, 1U}) {
      EXPECT_EQ(line["markers"][i]["id"], lines[0]["markers"][i]["id"]);
      for (const int axis : {0, 1}) {
        EXPECT_NEAR(line["markers"][i]["center"][axis].get<double>(),
                    lines[0]["markers"][i]["center"][axis].get<double>(), 1e-3);
      }
    }
  }
  EXPECT_EQ(test::run(DETECTOR_PROGRAM, wide("img%d.png", {"--tracking", "0"}), folder).status, 2);
}

TEST(DetectorProgram, DebugWritesAPictureForEachRoom)
{
  const fs::path folder = test::emptyFolder();
  const test::Outcome outcome =
      test::run(DETECTOR_PROGRAM, wide(widePicture, {"--json", "out.jsonl", "--debug", "debug/rooms"}), folder);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<std::string> files = {"0000-1-segment-half.png", "0000-1-segment-quarter.png", "0000-1-segment.png",
                                          "0000-2-edges-half.png",   "0000-2-edges-quarter.png",   "0000-2-edges.png",
                                          "0000-3-ellipses.png",     "0000-4-decode.png",          "0000-5-poses.png",
                                          "0000-candidates.csv"};
  EXPECT_EQ(test::filesIn(folder / "debug" / "rooms"), files);
  const cv::Mat original = cv::imread(widePicture, cv::IMREAD_GRAYSCALE);
  for (const std::string &file : files) {
    if (file.find(".png") != std::string::npos) {
      const cv::Mat picture = cv::imread((folder / "debug" / "rooms" / file).string());
      ASSERT_EQ(picture.size(), original.size()) << file;
      cv::Mat channels[3];
      cv::split(picture, channels);
      EXPECT_GT(cv::countNonZero(channels[0] != channels[2]), 100) << file << " has nothing drawn";
    }
  }
  // Every line but those of the markers has a reason.
  std::istringstream table(test::contentOf(folder / "debug" / "rooms" / "0000-candidates.csv"));
  std::string line;
  std::getline(table, line);
  EXPECT_EQ(line, "reason,family,u,v,semi_axis_a,semi_axis_b,angle,points,id,hamming,margin");
  std::size_t markers = 0, others = 0;
  while (std::getline(table, line)) {
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), 10) << line;
    (line.rfind("none,golay23,", 0) == 0 ? markers : others) += 1;
  }
  EXPECT_EQ(markers, 2U);
  EXPECT_GT(others, 2U);
  EXPECT_EQ(test::run(DETECTOR_PROGRAM, wide(widePicture, {"--debug", "out.jsonl"}), folder).status, 1);
}
