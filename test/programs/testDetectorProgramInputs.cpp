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
 * The contract of tutorial-circle-marker-detector, from outside: sequences, lists, videos and damaged pictures.
 */

#include <algorithm>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "detector_program.h"

namespace fs = std::filesystem;
using namespace detector_program_test;

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

TEST(DetectorProgram, WhatWasFoundBeforeAnInterruptionIsKept)
{
  const fs::path folder = test::emptyFolder();
  std::ofstream list(folder / "list.txt");
  for (int i = 0; i < 100000; ++i) { // many minutes
    list << referencePicture << "\n";
  }
  list.close();
  const std::string script =
      "\"$@\" & program=$!; until [ -e overlay-3.png ] || ! kill -0 $program; do sleep 0.05; done; "
      "kill -TERM $program; wait $program";
  std::vector<std::string> arguments = {"-c", script, "sh", DETECTOR_PROGRAM};
  for (const std::string &argument : reference("@list.txt", {"--json", "out.jsonl", "--overlay", "overlay-%d.png"})) {
    arguments.push_back(argument);
  }
  const test::Outcome outcome = test::run("/bin/sh", arguments, folder);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("interrupted after "), std::string::npos) << outcome.err;
  const std::size_t done = linesOf(test::contentOf(folder / "out.jsonl")).size();
  EXPECT_GE(done, 3U);
  EXPECT_LT(done, 100000U);
  EXPECT_EQ(test::filesIn(folder).size(), done + 2) << "a picture for each line, the list and the lines";
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

TEST(DetectorProgram, AFolderMayHaveAPercentSignInItsName)
{
  const fs::path folder = test::emptyFolder();
  fs::create_directory(folder / "50%");
  fs::copy_file(widePicture, folder / "50%" / "img3.png");
  for (const std::string input : {"50%/img%d.png", "50%%/img%d.png"}) {
    const test::Outcome outcome = test::run(DETECTOR_PROGRAM, wide(input), folder);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    ASSERT_EQ(linesOf(outcome.out).size(), 1U) << input;
    EXPECT_EQ(linesOf(outcome.out)[0]["image"], "50%/img3.png");
  }
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

// Whatever OpenCV plays: with an index or without, with --first and --last; what is asked for beyond the end is said.
TEST(DetectorProgram, VideosOfEveryKindAreRead)
{
  struct Kind
  {
    const char *name;
    int codec;
  };
  const Kind kinds[] = {{"video.avi", cv::VideoWriter::fourcc('M', 'J', 'P', 'G')},
                        {"video.mkv", cv::VideoWriter::fourcc('M', 'J', 'P', 'G')},
                        {"video.m4v", cv::VideoWriter::fourcc('m', 'p', '4', 'v')},
                        {"video.mpg", cv::VideoWriter::fourcc('P', 'I', 'M', '1')},
                        {"video.webm", cv::VideoWriter::fourcc('V', 'P', '8', '0')}};
  int played = 0;
  for (const Kind &kind : kinds) {
    const fs::path folder = test::emptyFolder();
    cv::VideoWriter writer((folder / kind.name).string(), kind.codec, 25., cv::Size(640, 480));
    if (!writer.isOpened()) {
      continue; // no such encoder here
    }
    cv::Mat picture;
    cv::resize(cv::imread(referencePicture), picture, cv::Size(640, 480));
    for (int i = 0; i < 5; ++i) {
      writer << picture;
    }
    writer.release();
    ++played;
    const test::Outcome all = test::run(DETECTOR_PROGRAM, reference(kind.name), folder);
    EXPECT_EQ(all.status, 0) << kind.name << ": " << all.err;
    EXPECT_EQ(linesOf(all.out).size(), 5U) << kind.name;
    std::vector<std::string> some = reference(kind.name);
    some.insert(some.end(), {"--first", "3", "--last", "9"});
    const test::Outcome end = test::run(DETECTOR_PROGRAM, some, folder);
    EXPECT_EQ(end.status, 1) << kind.name;
    EXPECT_NE(end.err.find("has 5 frames"), std::string::npos) << kind.name << ": " << end.err;
    EXPECT_EQ(linesOf(end.out).size(), 2U) << kind.name;
  }
  EXPECT_GE(played, 2);
}

// The content counts, and not the name; and images of 16 bits or of text, which ViSP does not read.
TEST(DetectorProgram, ImagesAreWhatTheyHold)
{
  const fs::path folder = test::emptyFolder();
  const cv::Mat picture = cv::imread(referencePicture, cv::IMREAD_GRAYSCALE);
  cv::Mat deep;
  picture.convertTo(deep, CV_16U, 257.);
  cv::imwrite((folder / "deep.pgm").string(), deep);
  cv::imwrite((folder / "text.pgm").string(), picture, {cv::IMWRITE_PXM_BINARY, 0});
  cv::imwrite((folder / "whole.png").string(), picture);
  cv::imwrite((folder / "whole.jpg").string(), picture);
  fs::copy(folder / "whole.png", folder / "png.jpg");
  fs::copy(folder / "whole.jpg", folder / "jpeg.png");
  fs::copy(folder / "whole.png", folder / "nameless");
  for (const char *name : {"deep.pgm", "text.pgm", "png.jpg", "jpeg.png", "nameless"}) {
    const test::Outcome outcome = test::run(DETECTOR_PROGRAM, reference(name), folder);
    EXPECT_EQ(outcome.status, 0) << name << ": " << outcome.err;
    ASSERT_EQ(linesOf(outcome.out).size(), 1U) << name;
    EXPECT_EQ(linesOf(outcome.out)[0]["markers"].size(), 1U) << name;
  }
  std::ofstream(folder / "text") << "no image";
  EXPECT_EQ(test::run(DETECTOR_PROGRAM, reference("text"), folder).status, 1);
}

TEST(DetectorProgram, APictureWithoutAKindIsRefusedBeforeTheWork)
{
  const fs::path folder = test::emptyFolder();
  for (const char *name : {"overlay.xyz", "overlay"}) {
    std::vector<std::string> arguments = reference(referencePicture);
    arguments.insert(arguments.end(), {"--overlay", name});
    const test::Outcome outcome = test::run(DETECTOR_PROGRAM, arguments, folder);
    EXPECT_EQ(outcome.status, 2) << name;
    EXPECT_EQ(outcome.out, "") << name;
  }
}
