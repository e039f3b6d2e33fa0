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
 * Results for programs.
 */

#include <cmath>

#include <nlohmann/json.hpp>

#include "report.h"

namespace accuracy {
namespace {
using nlohmann::ordered_json;

ordered_json number(double value)
{
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

/*! A cell that is a number as a whole becomes one. */
ordered_json cellOf(const std::string &text)
{
  std::size_t used = 0;
  try {
    const double value = std::stod(text, &used);
    return used == text.size() ? number(value) : ordered_json(text);
  }
  catch (const std::exception &) {
    return text == "-" ? ordered_json(nullptr) : ordered_json(text);
  }
}
} // namespace

std::string jsonOf(const std::vector<std::string> &comments, const std::vector<Table> &tables,
                   const std::vector<Check> &checks)
{
  ordered_json result;
  result["about"] = comments;
  result["targets"] = ordered_json::array();
  for (const Check &check : checks) {
    result["targets"].push_back({{"target", check.target},
                                 {"where", check.where},
                                 {"value", number(check.value)},
                                 {"least", number(check.least)},
                                 {"most", number(check.most)},
                                 {"images", check.frames},
                                 {"standard_error", number(check.error)},
                                 {"met", check.isMet()}});
  }
  result["tables"] = ordered_json::array();
  for (const Table &table : tables) {
    ordered_json rows = ordered_json::array();
    for (const auto &row : table.rows) {
      ordered_json object = ordered_json::array();
      for (const std::string &cell : row) {
        object.push_back(cellOf(cell));
      }
      rows.push_back(object);
    }
    result["tables"].push_back({{"caption", table.caption}, {"titles", table.titles}, {"rows", rows}});
  }
  return result.dump(2) + "\n";
}
} // namespace accuracy
