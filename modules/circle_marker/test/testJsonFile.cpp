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
 * Tests of files that are written as a whole or not at all.
 */

#include "support/json_file.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <system_error>

#ifdef __linux__
#include <csignal>
#include <sys/resource.h>
#include <unistd.h>
#endif

#include <gtest/gtest.h>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif
using namespace circle_marker;
namespace fs = std::filesystem;

#ifdef __linux__
TEST(JsonFile, WhatCannotBeWrittenLeavesNothingBehind)
{
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  // In a process of its own, since its files may not be longer than that any more.
  const auto writeTooMuch = [] {
    const fs::path folder = fs::temp_directory_path() / ("testJsonFile-" + std::to_string(getpid()));
    fs::create_directory(folder);
    const std::string filename = (folder / "settings.json").string();
    const bool isBegun = writeWhole(filename, "old");
    std::signal(SIGXFSZ, SIG_IGN); // or the process ends there
    const rlimit limit = {16, 16}; // bytes
    setrlimit(RLIMIT_FSIZE, &limit);
    const bool isWritten = writeWhole(filename, std::string(100000, 'x'));
    std::stringstream text;
    text << std::ifstream(filename).rdbuf();
    const auto files = std::distance(fs::directory_iterator(folder), fs::directory_iterator());
    std::error_code error;
    fs::remove_all(folder, error);
    std::_Exit(isWritten ? 1 : (isBegun && text.str() == "old" && files == 1 ? 0 : 2));
  };
  EXPECT_EXIT(writeTooMuch(), ::testing::ExitedWithCode(0), "");
}

TEST(JsonFile, WhatItsOwnerAloneMayReadStaysSo)
{
  const fs::path filename = fs::temp_directory_path() / ("testJsonFile-private-" + std::to_string(getpid()));
  ASSERT_TRUE(writeWhole(filename.string(), "old"));
  const fs::perms isPrivate = fs::perms::owner_read | fs::perms::owner_write;
  fs::permissions(filename, isPrivate);
  ASSERT_TRUE(writeWhole(filename.string(), "new"));
  EXPECT_EQ(fs::status(filename).permissions(), isPrivate);
  EXPECT_EQ(readWhole(filename.string()), "new");
  fs::remove(filename);
}
#endif
