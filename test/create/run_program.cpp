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
 * Running programs as a user does.
 */

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include <sys/wait.h>

#include <gtest/gtest.h>

#include "run_program.h"

namespace test {
namespace {
/*! A word that the shell takes as it is. */
std::string quoted(const std::string &word)
{
  std::string result = "'";
  for (const char letter : word) {
    result += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  }
  return result + "'";
}
} // namespace

std::string contentOf(const std::filesystem::path &file)
{
  std::ifstream stream(file, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
}

Outcome run(const std::string &program, const std::vector<std::string> &arguments, const std::filesystem::path &folder)
{
  // Beside the folder, not in it: what is in it is the program's.
  const std::string out = folder.string() + ".out";
  const std::string err = folder.string() + ".err";
  std::string command = "cd " + quoted(folder.string()) + " && " + quoted(program);
  for (const std::string &argument : arguments) {
    command += " " + quoted(argument);
  }
  const int status = std::system((command + " > " + quoted(out) + " 2> " + quoted(err)).c_str());
  return Outcome{WIFEXITED(status) ? WEXITSTATUS(status) : -1, contentOf(out), contentOf(err)};
}

std::filesystem::path emptyFolderIn(const std::filesystem::path &folder)
{
  const std::filesystem::path empty = folder / ::testing::UnitTest::GetInstance()->current_test_info()->name();
  std::filesystem::remove_all(empty);
  std::filesystem::create_directories(empty);
  return empty;
}

std::vector<std::string> filesIn(const std::filesystem::path &folder)
{
  std::vector<std::string> names;
  for (const auto &entry : std::filesystem::directory_iterator(folder)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}
} // namespace test
