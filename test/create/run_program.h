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

#ifndef VP_TEST_RUN_PROGRAM_H
#define VP_TEST_RUN_PROGRAM_H

#include <filesystem>
#include <string>
#include <vector>

namespace test {
/*! What a program did: its exit status and all it wrote. */
struct Outcome
{
  int status;
  std::string out, err;
};

/*! Runs a program with arguments in a folder. */
Outcome run(const std::string &program, const std::vector<std::string> &arguments, const std::filesystem::path &folder);

/*! An empty folder for the running test, in a folder of the program of tests. */
std::filesystem::path emptyFolderIn(const std::filesystem::path &folder);

#ifdef CIRCLE_MARKER_TEST_DIR // each program of tests has its own; this file's are shared
inline std::filesystem::path emptyFolder()
{
  return emptyFolderIn(CIRCLE_MARKER_TEST_DIR);
}
#endif

/*! The names of the files and folders in a folder, ascending. */
std::vector<std::string> filesIn(const std::filesystem::path &folder);

std::string contentOf(const std::filesystem::path &file);
} // namespace test

#endif
