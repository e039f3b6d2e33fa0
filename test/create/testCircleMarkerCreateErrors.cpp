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
 * circle-marker-create with arguments and outputs that cannot be used.
 */

#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "create_program.h"
#include "run_program.h"

using test::create;
using test::emptyFolder;
using test::filesIn;
using test::Outcome;

TEST(CircleMarkerCreateErrors, TooLargeMarkersAreRefusedWithTheLargestSizeThatFits)
{
  const std::filesystem::path folder = emptyFolder();
  for (const std::string sheet : {"a4", "a3", "letter"}) {
    const std::vector<std::string> arguments = {"--id", "1", "--sheet", sheet, "--output", "marker.svg", "--size"};
    const auto sized = [&arguments](const std::string &size) {
      std::vector<std::string> all = arguments;
      all.push_back(size);
      return all;
    };
    const Outcome refused = create(sized("0.3"), folder);
    EXPECT_EQ(2, refused.status);
    EXPECT_TRUE(filesIn(folder).empty());
    std::smatch found;
    ASSERT_TRUE(std::regex_search(refused.err, found, std::regex("largest size that fits is ([0-9.]+) m\n")))
        << refused.err;
    EXPECT_EQ(0, create(sized(found[1]), folder).status) << sheet;
    EXPECT_EQ(2, create(sized(std::to_string(std::stod(found[1]) + 0.0002)), folder).status) << sheet;
    std::filesystem::remove(folder / "marker.svg");
  }
}

TEST(CircleMarkerCreateErrors, WrongArgumentsExitWith2AndLeaveNothing)
{
  const std::vector<std::string> wrong[] = {
      {},
      {"--id", "3"},
      {"--output", "x.pdf"},
      {"--id", "178", "--output", "x.pdf"},
      {"--id", "-1", "--output", "x.pdf"},
      {"--id", "1-2", "--output", "x.pdf"},
      {"--id", "1", "--ids", "1-2", "--output", "x.pdf"},
      {"--ids", "4-2", "--output", "x.pdf"},
      {"--ids", "170-180", "--output", "x.pdf"},
      {"--id", "3", "--output", "x.jpg"},
      {"--id", "3", "--output", "x"},
      {"--family", "golay", "--id", "3", "--output", "x.pdf"},
      {"--family", "ring", "--id", "4", "--output", "x.pdf"},
      {"--family", "ring", "--ratio", "1", "--output", "x.pdf"},
      {"--family", "ring", "--ratio", "0", "--output", "x.pdf"},
      {"--ratio", "0.7", "--id", "3", "--output", "x.pdf"},
      {"--id", "3", "--size", "0", "--output", "x.pdf"},
      {"--id", "3", "--size", "-0.1", "--output", "x.pdf"},
      {"--id", "3", "--size", "nan", "--output", "x.pdf"},
      {"--id", "3", "--size", "180", "--output", "x.pdf"},
      {"--id", "3", "--size", "big", "--output", "x.pdf"},
      {"--id", "3", "--sheet", "a5", "--output", "x.pdf"},
      {"--id", "3", "--dpi", "0", "--output", "x.png"},
      {"--id", "3", "--dpi", "5000", "--output", "x.png"},
      {"--id", "3", "--per-sheet", "0", "--output", "x.pdf"},
      {"--id", "3", "--per-sheet", "2", "--output", "x.pdf"},
      {"--ids", "1-2", "--per-sheet", "2", "--sheet", "none", "--output", "x.pdf"},
      {"--id", "3", "--output", "x.pdf", "--unknown"},
      {"--id", "3", "--output", "x.pdf", "more"},
  };
  const std::filesystem::path folder = emptyFolder();
  for (const std::vector<std::string> &arguments : wrong) {
    std::string line;
    for (const std::string &argument : arguments) {
      line += " " + argument;
    }
    const Outcome outcome = create(arguments, folder);
    EXPECT_EQ(2, outcome.status) << line;
    EXPECT_EQ("", outcome.out) << line;
    EXPECT_EQ(0u, outcome.err.find("circle-marker-create: ")) << line << "\n" << outcome.err;
    EXPECT_EQ(outcome.err.size() - 1, outcome.err.find('\n')) << line << "\n" << outcome.err;
    EXPECT_TRUE(filesIn(folder).empty()) << line;
  }
}

TEST(CircleMarkerCreateErrors, UnwritableOutputExitsWith1AndLeavesNothing)
{
  const std::filesystem::path folder = emptyFolder();
  const Outcome noFolder = create({"--id", "3", "--output", "nowhere/x.pdf"}, folder);
  EXPECT_EQ(1, noFolder.status);
  EXPECT_EQ("", noFolder.out);
  EXPECT_EQ(0u, noFolder.err.find("circle-marker-create: cannot write \"nowhere/x.pdf\"")) << noFolder.err;
  EXPECT_TRUE(filesIn(folder).empty());

  // The second of three files cannot be written: the first is not left behind either.
  std::filesystem::create_directory(folder / "m-1.svg");
  const Outcome isFolder = create({"--ids", "0-2", "--output", "m.svg"}, folder);
  EXPECT_EQ(1, isFolder.status);
  EXPECT_EQ("", isFolder.out);
  EXPECT_EQ(std::vector<std::string>({"m-1.svg"}), filesIn(folder));
}

TEST(CircleMarkerCreateErrors, FullDiskLeavesNothing)
{
  // A file that may not grow beyond one block stands for a full disk.
  const std::filesystem::path folder = emptyFolder();
  const Outcome outcome = test::run(
      "/bin/sh", {"-c", "trap '' XFSZ; ulimit -f 1; exec \"$0\" --id 3 --output x.png", CIRCLE_MARKER_CREATE}, folder);
  EXPECT_EQ(1, outcome.status) << outcome.err;
  EXPECT_TRUE(filesIn(folder).empty());
}
