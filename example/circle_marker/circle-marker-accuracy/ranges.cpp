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
 * Ranges and groups of records.
 */

#include <algorithm>
#include <cstdio>
#include <limits>
#include <map>
#include <utility>

#include "parts.h"
#include "ranges.h"

namespace accuracy {
namespace {
constexpr double infinity = std::numeric_limits<double>::infinity();

Filter between(double Record::*value, double from, double to)
{
  return [=](const Record &record) { return record.*value >= from && record.*value < to; };
}
} // namespace

std::vector<Range> octaveRanges()
{
  std::vector<Range> ranges;
  for (std::size_t i = 0; i + 1 < octaves.size(); ++i) {
    char name[64];
    std::snprintf(name, sizeof(name), "%g-%g px", octaves[i], octaves[i + 1]);
    // Drawn for a marker in the middle; perspective moves a few across the borders.
    ranges.push_back({name, between(&Record::diameter, i == 0 ? 0. : octaves[i],
                                    i + 2 == octaves.size() ? infinity : octaves[i + 1])});
  }
  return ranges;
}

std::vector<Range> minorRanges()
{
  return {{"minor >= 8 px", between(&Record::minor, 8., infinity)},
          {"minor 4-8 px", between(&Record::minor, 4., 8.)},
          {"minor < 4 px", between(&Record::minor, 0., 4.)}};
}

std::vector<Range> tiltRanges()
{
  return {{"tilt < 15°", between(&Record::tilt, 0., 15.)},
          {"tilt 15-30°", between(&Record::tilt, 15., 30.)},
          {"tilt 30-45°", between(&Record::tilt, 30., 45.)},
          {"tilt 45-60°", between(&Record::tilt, 45., 60.)},
          {"tilt >= 60°", between(&Record::tilt, 60., 90.)}};
}

Filter inPart(const std::string &part)
{
  return [part](const Record &record) { return record.part == part; };
}

Filter inGroup(const std::string &group)
{
  return [group](const Record &record) { return record.group == group; };
}

Filter byMethod(const std::string &method)
{
  return [method](const Record &record) { return record.method == method; };
}

std::vector<std::string> methodsOf(const Records &records)
{
  std::vector<std::string> names;
  for (const Record &record : records) {
    if (std::find(names.begin(), names.end(), record.method) == names.end()) {
      names.push_back(record.method);
    }
  }
  return names;
}

Records commonImages(const Records &records)
{
  std::map<std::pair<std::string, double>, bool> isGood;
  for (const Record &record : records) {
    const bool good = record.isFound() && !record.isWrong();
    const auto place = isGood.emplace(std::make_pair(record.group, record.frame), true).first;
    place->second = place->second && good;
  }
  return chosen(records, [&](const Record &record) { return isGood.at({record.group, record.frame}); });
}

Records withoutMirror(Records records)
{
  for (Record &record : records) {
    record.wrong = 0.;
  }
  return records;
}
} // namespace accuracy
