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
 * Reading the tables that programs write.
 */

#ifndef VP_TEST_CSV_ROWS_H
#define VP_TEST_CSV_ROWS_H

#include <algorithm>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace test {
/*! Fields by the names of their columns. */
using Row = std::map<std::string, std::string>;

inline std::vector<std::string> fieldsOf(const std::string &line)
{
  std::vector<std::string> fields(1);
  for (const char letter : line) {
    if (letter == ',') {
      fields.emplace_back();
    }
    else {
      fields.back() += letter;
    }
  }
  return fields;
}

/*! The rows of a CSV file without its comments; the first line names the columns. */
inline std::vector<Row> rowsOf(const std::string &csv)
{
  std::vector<Row> rows;
  std::vector<std::string> names;
  std::istringstream stream(csv);
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind('#', 0) == 0) {
      continue;
    }
    const std::vector<std::string> fields = fieldsOf(line);
    if (names.empty()) {
      names = fields;
      continue;
    }
    EXPECT_EQ(fields.size(), names.size()) << line;
    Row row;
    for (std::size_t i = 0; i < std::min(fields.size(), names.size()); ++i) {
      row[names[i]] = fields[i];
    }
    rows.push_back(row);
  }
  return rows;
}

/*! A CSV file without its last column, the CPU time. */
inline std::string withoutTimes(const std::string &csv)
{
  std::string text;
  std::istringstream stream(csv);
  for (std::string line; std::getline(stream, line);) {
    text += (line.rfind('#', 0) == 0 ? line : line.substr(0, line.rfind(','))) + "\n";
  }
  return text;
}
} // namespace test

#endif
