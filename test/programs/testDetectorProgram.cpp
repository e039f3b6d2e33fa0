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
 * The contract of tutorial-circle-marker-detector, from outside.
 */

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "run_program.h"

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {
const std::string data = CIRCLE_MARKER_DATA_DIR;
const std::string referencePicture = data + "/pictures/golay23-id5.png";
const std::string widePicture = data + "/pictures/wide-families.png";

Json readJson(const std::string &path)
{
  std::ifstream file(path);
  return Json::parse(file);
}

std::vector<Json> linesOf(const std::string &text)
{
  std::vector<Json> lines;
  std::istringstream in(text);
  std::string line;
  while (std::getline(in, line)) {
    lines.push_back(Json::parse(line));
  }
  return lines;
}

/*! Arguments for pictures of the reference camera. */
std::vector<std::string> reference(const std::string &input, const std::vector<std::string> &more = {})
{
  std::vector<std::string> arguments = {"--input", input,    "--intrinsic", data + "/camera.xml", "--camera-name",
                                        "Camera",  "--size", "0.18",        "--display-off"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

/*! Arguments for pictures of the camera with distortion. */
std::vector<std::string> wide(const std::string &input, const std::vector<std::string> &more = {})
{
  std::vector<std::string> arguments = {"--input",       input,  "--intrinsic", data + "/pictures/camera-wide.xml",
                                        "--camera-name", "Wide", "--size",      "0.18",
                                        "--display-off"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
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

TEST(DetectorProgram, UnreadableImageOfASequenceIsSkipped)
{
  const fs::path folder = test::emptyFolder();
  for (const std::string number : {"0007", "0008", "0010"}) {
    fs::copy_file(widePicture, folder / ("img" + number + ".png"));
  }
  const std::string damaged = test::contentOf(widePicture).substr(0, 20000);
  std::ofstream(folder / "img0009.png", std::ios::binary) << damaged;
  const test::Outcome outcome = test::run(
      DETECTOR_PROGRAM, wide("img%04d.png", {"--json", "out.jsonl", "--overlay", "overlay-%02d.png"}), folder);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("tutorial-circle-marker-detector: \"img0009.png\""), std::string::npos) << outcome.err;
  const std::vector<Json> lines = linesOf(test::contentOf(folder / "out.jsonl"));
  ASSERT_EQ(lines.size(), 3U);
  const std::string names[] = {"img0007.png", "img0008.png", "img0010.png"};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(lines[i]["image"], names[i]);
    EXPECT_EQ(lines[i]["markers"].size(), 2U) << "two golay23 markers are in the picture";
  }
  const std::vector<std::string> files = {"img0007.png", "img0008.png",    "img0009.png",    "img0010.png",
                                          "out.jsonl",   "overlay-07.png", "overlay-08.png", "overlay-10.png"};
  EXPECT_EQ(test::filesIn(folder), files);
  const cv::Mat overlay = cv::imread((folder / "overlay-07.png").string());
  EXPECT_EQ(overlay.size(), cv::Size(640, 480));
}

TEST(DetectorProgram, DebugWritesAPictureForEachRoom)
{
  const fs::path folder = test::emptyFolder();
  fs::create_directory(folder / "rooms");
  const test::Outcome outcome =
      test::run(DETECTOR_PROGRAM, wide(widePicture, {"--json", "out.jsonl", "--debug", "rooms"}), folder);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<std::string> files = {"0000-1-segment-half.png", "0000-1-segment-quarter.png", "0000-1-segment.png",
                                          "0000-2-edges-half.png",   "0000-2-edges-quarter.png",   "0000-2-edges.png",
                                          "0000-3-ellipses.png",     "0000-4-decode.png",          "0000-5-poses.png",
                                          "0000-candidates.csv"};
  EXPECT_EQ(test::filesIn(folder / "rooms"), files);
  const cv::Mat original = cv::imread(widePicture, cv::IMREAD_GRAYSCALE);
  for (const std::string &file : files) {
    if (file.find(".png") != std::string::npos) {
      const cv::Mat picture = cv::imread((folder / "rooms" / file).string());
      ASSERT_EQ(picture.size(), original.size()) << file;
      cv::Mat channels[3];
      cv::split(picture, channels);
      EXPECT_GT(cv::countNonZero(channels[0] != channels[2]), 100) << file << " has nothing drawn";
    }
  }
  // Every line but those of the markers has a reason.
  std::istringstream table(test::contentOf(folder / "rooms" / "0000-candidates.csv"));
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
  EXPECT_EQ(test::run(DETECTOR_PROGRAM, wide(widePicture, {"--debug", "no-such-folder"}), folder).status, 2);
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

TEST(DetectorProgram, FirstAndLastAskForEveryNumberBetween)
{
  const fs::path folder = test::emptyFolder();
  fs::copy_file(widePicture, folder / "img3.png");
  fs::copy_file(widePicture, folder / "img5.png");
  const test::Outcome inside = test::run(DETECTOR_PROGRAM, wide("img%d.png", {"--first", "5", "--last", "5"}), folder);
  EXPECT_EQ(inside.status, 0) << inside.err;
  ASSERT_EQ(linesOf(inside.out).size(), 1U);
  EXPECT_EQ(linesOf(inside.out)[0]["image"], "img5.png");
  const test::Outcome gap = test::run(DETECTOR_PROGRAM, wide("img%d.png", {"--first", "3", "--last", "5"}), folder);
  EXPECT_EQ(gap.status, 1);
  EXPECT_NE(gap.err.find("img4.png"), std::string::npos) << gap.err;
  EXPECT_EQ(linesOf(gap.out).size(), 2U);
}

TEST(DetectorProgram, ListOfPathsKeepsItsOrder)
{
  const fs::path folder = test::emptyFolder();
  std::ofstream(folder / "list.txt") << "b.png\r\n\n" << widePicture << "\na.png\n";
  cv::Mat color = cv::imread(widePicture, cv::IMREAD_COLOR);
  cv::imwrite((folder / "a.png").string(), color);
  cv::imwrite((folder / "b.png").string(), cv::Mat(480, 640, CV_8UC1, cv::Scalar(128)));
  const test::Outcome outcome = test::run(DETECTOR_PROGRAM, wide("@list.txt"), folder);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<Json> lines = linesOf(outcome.out);
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0]["image"], "b.png");
  EXPECT_EQ(lines[1]["image"], widePicture);
  EXPECT_EQ(lines[2]["image"], "a.png");
  EXPECT_EQ(lines[0]["markers"].size(), 0U);
  // The colour picture has three equal channels.
  EXPECT_EQ(lines[1]["markers"], lines[2]["markers"]);
}

TEST(DetectorProgram, ImagesOfAnotherSizeThanTheCameraAreSaidSo)
{
  const test::Outcome outcome = test::run(DETECTOR_PROGRAM, reference(widePicture), test::emptyFolder());
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.err.find("1280 x 960"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("640 x 480"), std::string::npos) << outcome.err;
}

TEST(DetectorProgram, AnImageThatNoCameraIsForIsLeftOut)
{
  const fs::path folder = test::emptyFolder();
  // One name for two sizes: of a third size nobody knows the camera.
  std::string xml = test::contentOf(data + "/camera.xml");
  const std::size_t begin = xml.find("<camera>");
  const std::size_t end = xml.rfind("</camera>") + 9;
  ASSERT_NE(begin, std::string::npos);
  std::string other = xml.substr(begin, end - begin);
  other.replace(other.find("1280"), 4, "640");
  other.replace(other.find("960"), 3, "480");
  xml.insert(end, "\n" + other);
  std::ofstream(folder / "cameras.xml") << xml;
  cv::imwrite((folder / "small.png").string(), cv::Mat(240, 320, CV_8U, cv::Scalar(100)));
  std::ofstream(folder / "list.txt") << referencePicture << "\nsmall.png\n" << referencePicture << "\n";
  const test::Outcome outcome = test::run(DETECTOR_PROGRAM,
                                          {"--input", "@list.txt", "--intrinsic", "cameras.xml", "--camera-name",
                                           "Camera", "--size", "0.18", "--display-off", "--json", "out.jsonl"},
                                          folder);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("small.png\" is left out"), std::string::npos) << outcome.err;
  EXPECT_EQ(linesOf(test::contentOf(folder / "out.jsonl")).size(), 2U);
}

TEST(DetectorProgram, APictureThatIsCutOffIsLeftOut)
{
  const fs::path folder = test::emptyFolder();
  cv::imwrite((folder / "whole.jpg").string(), cv::imread(referencePicture));
  const std::string jpeg = test::contentOf(folder / "whole.jpg");
  std::ofstream(folder / "cut.jpg", std::ios::binary) << jpeg.substr(0, jpeg.size() / 3);
  std::ofstream(folder / "list.txt") << "cut.jpg\nwhole.jpg\n";
  const test::Outcome outcome = test::run(DETECTOR_PROGRAM, reference("@list.txt"), folder);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("cut.jpg\" is left out"), std::string::npos) << outcome.err;
  ASSERT_EQ(linesOf(outcome.out).size(), 1U);
  EXPECT_EQ(linesOf(outcome.out)[0]["markers"].size(), 1U);
}

TEST(DetectorProgram, AFrameThatCannotBeDecodedIsLeftOut)
{
  const fs::path folder = test::emptyFolder();
  const std::string path = (folder / "video.avi").string();
  cv::VideoWriter writer(path, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 10., cv::Size(640, 480));
  for (int i = 0; i < 8; ++i) {
    cv::Mat picture;
    cv::resize(cv::imread(referencePicture), picture, cv::Size(640, 480));
    writer << picture;
  }
  writer.release();
  // The fourth JPEG picture is overwritten.
  std::string video = test::contentOf(path);
  std::size_t begin = 0;
  for (int i = 0; i < 4; ++i) {
    begin = video.find("\xff\xd8\xff", begin + 1);
    ASSERT_NE(begin, std::string::npos);
  }
  const std::size_t end = video.find("\xff\xd9", begin);
  std::fill(video.begin() + static_cast<std::ptrdiff_t>(begin), video.begin() + static_cast<std::ptrdiff_t>(end), '\0');
  std::ofstream(path, std::ios::binary) << video;
  const test::Outcome outcome = test::run(DETECTOR_PROGRAM, reference("video.avi"), folder);
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_NE(outcome.err.find("video.avi#3\" is left out"), std::string::npos) << outcome.err;
  EXPECT_EQ(linesOf(outcome.out).size(), 7U) << "and nothing but lines of JSON";
}

TEST(DetectorProgram, WhatIsReadIsNotReplaced)
{
  const fs::path folder = test::emptyFolder();
  fs::copy_file(referencePicture, folder / "a.png");
  const std::string before = test::contentOf(folder / "a.png");
  for (const std::string option : {"--overlay", "--json"}) {
    EXPECT_EQ(test::run(DETECTOR_PROGRAM, reference("a.png", {option, "./a.png"}), folder).status, 2) << option;
  }
  EXPECT_EQ(test::contentOf(folder / "a.png"), before);
  const test::Outcome piped = test::run(DETECTOR_PROGRAM, reference("a.png", {"--json", "/dev/stdout"}), folder);
  EXPECT_EQ(piped.status, 0) << piped.err;
  EXPECT_EQ(linesOf(piped.out).size(), 1U);
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

TEST(DetectorProgram, InputsThatCannotBeUsedEndWithOne)
{
  const fs::path folder = test::emptyFolder();
  const std::vector<std::vector<std::string>> cases = {
      reference("nothing.png"),
      reference("nothing%d.png"),
      reference("@nothing.txt"),
      reference(referencePicture, {"--json", "no/such/folder/out.jsonl"}),
      reference(referencePicture, {"--overlay", "overlay.nokind"}),
      {"--input", referencePicture, "--intrinsic", data + "/camera.xml", "--camera-name", "Other", "--size", "1"},
  };
  for (const std::vector<std::string> &arguments : cases) {
    const test::Outcome outcome = test::run(DETECTOR_PROGRAM, arguments, folder);
    EXPECT_EQ(outcome.status, 1) << ::testing::PrintToString(arguments);
    EXPECT_EQ(outcome.err.rfind("tutorial-circle-marker-detector: ", 0), 0U) << outcome.err;
  }
  EXPECT_TRUE(test::filesIn(folder).empty()) << "nothing is left of what could not be written";
}

TEST(DetectorProgram, WrongArgumentsEndWithTwo)
{
  const fs::path folder = test::emptyFolder();
  const std::vector<std::vector<std::string>> cases = {
      {},
      {"--input", referencePicture},
      reference(referencePicture, {"--nosuchoption"}),
      reference(referencePicture, {"--family", "nosuchfamily"}),
      reference(referencePicture, {"--sizes", "5=0.1"}),
      reference(referencePicture, {"--ratio", "0.7", "--family", "golay23"}),
      reference(""),
      reference("img%d.png", {"--first", "5", "--last", "4"}),
      reference("@list.txt", {"--first", "5"}),
      reference(referencePicture, {"--last", "5"}),
      reference("img%d.png", {"--overlay", "one-name.png"}),
      {"--input", referencePicture, "--intrinsic", data + "/camera.xml", "--camera-name", "Camera", "--size", "0"},
  };
  for (const std::vector<std::string> &arguments : cases) {
    const test::Outcome outcome = test::run(DETECTOR_PROGRAM, arguments, folder);
    EXPECT_EQ(outcome.status, 2) << ::testing::PrintToString(arguments);
    EXPECT_EQ(outcome.err.rfind("tutorial-circle-marker-detector: ", 0), 0U) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
  EXPECT_EQ(test::run(DETECTOR_PROGRAM, {"--help"}, folder).status, 0);
}
