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
 * Calls circle-marker-create and reads what it answers.
 */

#ifndef VP_TEST_CREATE_PROGRAM_H
#define VP_TEST_CREATE_PROGRAM_H

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "json_lines.h"
#include "run_program.h"

namespace test {
/*! Runs the program in a folder. */
inline Outcome create(const std::vector<std::string> &arguments, const std::filesystem::path &folder)
{
  return run(CIRCLE_MARKER_CREATE, arguments, folder);
}

/*! The lines of JSON that a successful run wrote. */
inline std::vector<nlohmann::json> linesOf(const Outcome &outcome)
{
  EXPECT_EQ(0, outcome.status) << outcome.err;
  EXPECT_EQ("", outcome.err);
  return linesOf(outcome.out);
}
} // namespace test

#endif
