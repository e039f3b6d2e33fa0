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
 * Lists of ids on the command line, and the file names they lead to.
 */

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <set>
#include <sstream>

#include "command_line.h"

namespace create {
namespace {
// No family has as many; keeps a slip such as 0-9999999999 from filling the memory.
constexpr int largestId = 99999;

[[noreturn]] void refuse(const std::string &list)
{
  throw UsageError("\"" + list + "\" is no list of ids; write for instance 5 or 0-9 or 1,4,7");
}

int parseId(const std::string &digits, const std::string &list)
{
  int id = 0;
  const char *end = digits.data() + digits.size();
  const std::from_chars_result result = std::from_chars(digits.data(), end, id);
  if (digits.empty() || result.ec != std::errc() || result.ptr != end || id < 0 || id > largestId) {
    refuse(list);
  }
  return id;
}
} // namespace

std::vector<int> parseIds(const std::string &list)
{
  std::vector<int> ids;
  std::set<int> seen;
  std::istringstream items(list + ","); // So that a comma at the end leaves an empty item, which is refused.
  for (std::string item; std::getline(items, item, ',');) {
    const std::size_t dash = item.find('-');
    const int first = parseId(item.substr(0, dash), list);
    const int last = dash == std::string::npos ? first : parseId(item.substr(dash + 1), list);
    if (last < first) {
      refuse(list);
    }
    for (int id = first; id <= last; ++id) {
      if (!seen.insert(id).second) {
        throw UsageError("id " + std::to_string(id) + " is named twice in \"" + list + "\"; name each id once");
      }
      ids.push_back(id);
    }
  }
  return ids;
}

std::string pageFile(const std::string &output, int firstId, int lastId)
{
  const std::filesystem::path path(output);
  std::string name = path.stem().string() + "-" + std::to_string(firstId);
  if (lastId != firstId) {
    name += "-" + std::to_string(lastId);
  }
  return (path.parent_path() / (name + path.extension().string())).string();
}
} // namespace create
