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
 * The contract of tutorial-circle-marker-detector, from outside: what it refuses, and how it says so.
 */

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "detector_program.h"

namespace fs = std::filesystem;
using namespace detector_program_test;

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

TEST(DetectorProgram, InputsThatCannotBeUsedEndWithOne)
{
  const fs::path folder = test::emptyFolder();
  const std::vector<std::vector<std::string>> cases = {
      reference("nothing.png"),
      reference("nothing%d.png"),
      reference("@nothing.txt"),
      reference(referencePicture, {"--json", "no/such/folder/out.jsonl"}),
      {"--input", referencePicture, "--intrinsic", data + "/camera.xml", "--camera-name", "Other", "--size", "1"},
  };
  for (const std::vector<std::string> &arguments : cases) {
    const test::Outcome outcome = test::run(DETECTOR_PROGRAM, arguments, folder);
    EXPECT_EQ(outcome.status, 1) << ::testing::PrintToString(arguments);
    EXPECT_EQ(outcome.err.rfind("tutorial-circle-marker-detector: ", 0), 0U) << outcome.err;
  }
  EXPECT_TRUE(test::filesIn(folder).empty()) << "nothing is left of what could not be written";
}

TEST(DetectorProgram, ACameraWithoutFocalLengthIsRefusedByName)
{
  const fs::path folder = test::emptyFolder();
  std::string xml = test::contentOf(data + "/camera.xml");
  const std::size_t begin = xml.find("<px>");
  ASSERT_NE(begin, std::string::npos);
  xml.replace(begin, xml.find("</px>", begin) - begin, "<px>0");
  std::ofstream(folder / "flat.xml") << xml;
  const test::Outcome outcome = test::run(
      DETECTOR_PROGRAM,
      {"--input", referencePicture, "--intrinsic", "flat.xml", "--camera-name", "Camera", "--size", "0.18"}, folder);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("flat.xml\" px and py must be positive"), std::string::npos) << outcome.err;
}

TEST(DetectorProgram, OfAFolderItIsSaidWhatToGive)
{
  const fs::path folder = test::emptyFolder();
  const test::Outcome outcome = test::run(DETECTOR_PROGRAM, reference(folder.string()), folder);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("is left out: it is a folder; give the images in it"), std::string::npos) << outcome.err;
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
      reference(referencePicture, {"--sizes", "5:0.1,5:0.2"}),
      reference(referencePicture, {"--sizes", "5:0.1,178:0.2"}),
      reference(referencePicture, {"--ratio", "0.7", "--family", "golay23"}),
      reference(""),
      reference("img%d.png", {"--first", "5", "--last", "4"}),
      reference("@list.txt", {"--first", "5"}),
      reference(referencePicture, {"--last", "5"}),
      reference("img%d.png", {"--overlay", "one-name.png"}),
      {"--input", referencePicture, "--intrinsic", data + "/camera.xml", "--camera-name", "Camera", "--size", "0"},
      {"--input", referencePicture, "--intrinsic", data + "/camera.xml", "--camera-name", "Camera", "--size", "1e300"},
  };
  for (const std::vector<std::string> &arguments : cases) {
    const test::Outcome outcome = test::run(DETECTOR_PROGRAM, arguments, folder);
    EXPECT_EQ(outcome.status, 2) << ::testing::PrintToString(arguments);
    EXPECT_EQ(outcome.err.rfind("tutorial-circle-marker-detector: ", 0), 0U) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
  EXPECT_EQ(test::run(DETECTOR_PROGRAM, {"--help"}, folder).status, 0);
}
