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
 * The table of an experiment's samples: reading.
 */

#include <algorithm>
#include <map>
#include <sstream>

#include "common/csv.h"
#include "run_data.h"
#include "run_header.h"

namespace experiments {
namespace {
constexpr std::size_t columnCount = 22;
constexpr const char *remedy = "; name another folder with --output, or remove the file to begin anew";

std::optional<Deviation> deviationFrom(const std::vector<std::string> &fields, std::size_t first)
{
  if (fields[first].empty()) {
    return std::nullopt;
  }
  return Deviation{std::stod(fields[first]), std::stod(fields[first + 1]), std::stod(fields[first + 2]),
                   std::stod(fields[first + 3])};
}

/*! \exception std::logic_error : If a field is not a number or no method has the name. */
Sample sampleFrom(const std::vector<std::string> &fields)
{
  const auto method = methodNamed(fields[2]);
  if (!method) {
    throw std::invalid_argument("method");
  }
  Sample sample;
  sample.method = *method;
  sample.x = std::stod(fields[3]);
  sample.y = std::stod(fields[4]);
  sample.z = std::stod(fields[5]);
  sample.angle = std::stod(fields[6]);
  sample.outlines = static_cast<unsigned int>(std::stoul(fields[7]));
  sample.markers = static_cast<unsigned int>(std::stoul(fields[8]));
  sample.first = deviationFrom(fields, 9);
  sample.second = deviationFrom(fields, 13);
  sample.rotation = fields[17].empty() ? 0. : std::stod(fields[17]);
  sample.isMirrored = fields[18] == "1";
  sample.logOdds = fields[19].empty() ? 0. : std::stod(fields[19]);
  sample.reading = fields[20].empty() ? 0. : std::stod(fields[20]);
  sample.cpuTime = std::stod(fields[21]);
  return sample;
}

std::vector<HeaderLine> headerFrom(const std::string &csv, const std::string &file)
{
  std::vector<HeaderLine> header;
  std::istringstream stream(csv);
  std::string line;
  std::getline(stream, line);
  if (line.rfind("# circle-marker-experiments: ", 0) != 0) {
    throw DataError("\"" + file + "\" is not written by this program" + remedy);
  }
  while (std::getline(stream, line) && line.rfind("# ", 0) == 0) {
    const std::size_t colon = line.find(": ");
    if (colon != std::string::npos) {
      header.push_back({line.substr(2, colon - 2), line.substr(colon + 2)});
    }
  }
  return header;
}

void checkHeader(const std::vector<HeaderLine> &found, const std::string &file, const Settings &settings)
{
  for (const HeaderLine &wanted : headerOf(settings)) {
    const auto line =
        std::find_if(found.begin(), found.end(), [&](const HeaderLine &l) { return l.key == wanted.key; });
    const std::string value = line == found.end() ? "not told" : line->value;
    if (value != wanted.value) {
      throw DataError("\"" + file + "\" has frames of " + wanted.key + " " + value + ", not " + wanted.value + remedy);
    }
  }
}

/*! A frame of which a method is missing is as good as not done. */
void dropPartFrames(const Experiment &experiment, RunData &data)
{
  for (std::size_t i = 0; i < data.size(); ++i) {
    for (std::size_t number = 0; number < data[i].size(); ++number) {
      auto &frame = data[i][number];
      if (frame && frame->size() != methodsOf(experiment.series[i], number).size()) {
        frame.reset();
      }
    }
  }
}
} // namespace

RunData dataFrom(const std::string &csv, const std::string &file, const Experiment &experiment,
                 const Settings &settings)
{
  checkHeader(headerFrom(csv, file), file, settings);
  std::map<std::string, std::size_t> places;
  for (std::size_t i = 0; i < experiment.series.size(); ++i) {
    places[experiment.series[i].name] = i;
  }
  RunData data = emptyData(experiment);
  std::istringstream stream(csv);
  std::size_t number = 0;
  bool isPastTitles = false;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (line.rfind("#", 0) == 0) {
      continue;
    }
    if (!isPastTitles) {
      isPastTitles = true;
      continue;
    }
    const std::vector<std::string> fields = common::fieldsOf(line);
    const auto place = fields.size() == columnCount ? places.find(fields[0]) : places.end();
    if (place == places.end()) {
      throw DataError("line " + std::to_string(number) + " of \"" + file + "\" is not of this experiment" + remedy);
    }
    try {
      auto &frames = data[place->second];
      const std::size_t frame = std::stoul(fields[1]);
      constexpr std::size_t mostFrames = 1000000; // As the command line has it.
      if (frame >= mostFrames) {
        throw std::out_of_range("frame");
      }
      frames.resize(std::max(frames.size(), frame + 1));
      if (!frames[frame]) {
        frames[frame].emplace();
      }
      frames[frame]->push_back(sampleFrom(fields));
    }
    catch (const std::logic_error &) { // What std::stod and its kind throw.
      throw DataError("line " + std::to_string(number) + " of \"" + file + "\" cannot be read" + remedy);
    }
  }
  dropPartFrames(experiment, data);
  return data;
}

Settings settingsFrom(const std::string &csv, const std::string &file, const Settings &given)
{
  try {
    return settingsOf(headerFrom(csv, file), given);
  }
  catch (const std::logic_error &) {
    throw DataError("the settings in \"" + file + "\" cannot be read" + remedy);
  }
}
} // namespace experiments
