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
 * Reading what programs write as lines of JSON.
 */

#ifndef VP_TEST_JSON_LINES_H
#define VP_TEST_JSON_LINES_H

#include <sstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace test {
/*! A value for each line of JSON. */
inline std::vector<nlohmann::json> linesOf(const std::string &text)
{
  std::vector<nlohmann::json> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    lines.push_back(nlohmann::json::parse(line));
  }
  return lines;
}
} // namespace test

#endif
