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
 * What all programs have in common: help, errors, no need of a display.
 */

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "run_program.h"

namespace fs = std::filesystem;

namespace {
std::vector<std::string> allPrograms()
{
  std::vector<std::string> programs;
  std::ifstream list(PROGRAM_LIST);
  for (std::string line; std::getline(list, line);) {
    if (!line.empty()) {
      programs.push_back(line);
    }
  }
  return programs;
}

/*! The long options that a help text lists: words that begin a line. */
std::set<std::string> optionsIn(const std::string &help)
{
  std::set<std::string> options;
  const std::regex option("\n +(?:-[a-zA-Z],)?(--[a-z0-9-]+)");
  for (auto i = std::sregex_iterator(help.begin(), help.end(), option); i != std::sregex_iterator(); ++i) {
    options.insert((*i)[1]);
  }
  return options;
}

class AnyProgram : public ::testing::TestWithParam<std::string>
{
protected:
  /*! Nobody is logged in at a screen. */
  void SetUp() override
  {
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
  }
  std::string name() const { return fs::path(GetParam()).filename().string(); }
  fs::path folder() const
  {
    const fs::path path = fs::path(CIRCLE_MARKER_TEST_DIR) / name();
    fs::remove_all(path);
    fs::create_directories(path);
    return path;
  }
};

std::string testName(const ::testing::TestParamInfo<std::string> &info)
{
  return std::regex_replace(fs::path(info.param).filename().string(), std::regex("[^A-Za-z0-9]"), "_");
}
} // namespace

TEST_P(AnyProgram, HelpNamesItsOptionsAndWritesNothing)
{
  const fs::path empty = folder();
  const test::Outcome outcome = test::run(GetParam(), {"--help"}, empty);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find(name()), std::string::npos) << outcome.out;
  EXPECT_GE(optionsIn(outcome.out).size(), 4U) << outcome.out;
  EXPECT_EQ(optionsIn(outcome.out).count("--help"), 1U) << outcome.out;
  EXPECT_TRUE(test::filesIn(empty).empty());
}

TEST_P(AnyProgram, OptionsThatHelpNamesAreKnown)
{
  const fs::path empty = folder();
  for (const std::string &option : optionsIn(test::run(GetParam(), {"--help"}, empty).out)) {
    if (option == "--help" || option == "--help-all" || option.rfind("--list-", 0) == 0) {
      continue;
    }
    // A value that no option takes for a good one, and an option that is none: nothing is done.
    const test::Outcome outcome = test::run(GetParam(), {option + "=\x01", "--no-such-option"}, empty);
    EXPECT_EQ(outcome.status, 2) << option << ": " << outcome.err;
    const bool isCalledUnknown = std::regex_search(outcome.err, std::regex("not expected:.*" + option + "(=|\\b)")) &&
                                 outcome.err.find(option + "=") != std::string::npos;
    EXPECT_FALSE(isCalledUnknown) << outcome.err;
  }
  EXPECT_TRUE(test::filesIn(empty).empty());
}

TEST_P(AnyProgram, AWrongOptionIsNamedAndWhatToDo)
{
  const fs::path empty = folder();
  for (const std::string wrong : {"--no-such-option", "stray-word"}) {
    const test::Outcome outcome = test::run(GetParam(), {wrong}, empty);
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err.rfind(name() + ": ", 0), 0U) << outcome.err;
    EXPECT_NE(outcome.err.find("see --help"), std::string::npos) << outcome.err;
  }
  EXPECT_TRUE(test::filesIn(empty).empty());
}

INSTANTIATE_TEST_SUITE_P(ProgramContract, AnyProgram, ::testing::ValuesIn(allPrograms()), testName);

TEST(ProgramContract, AllProgramsAreLookedAt)
{
  EXPECT_GE(allPrograms().size(), 10U);
}
